// A picture on a canvas: places of the plane to pixels and back, pointer and keys, colours.

/** The colours of the sheet, by name. */
export function colours() {
  const style = getComputedStyle(document.documentElement);
  return (name) => style.getPropertyValue(`--${name}`).trim();
}

/** The box of points, as [low x, low y, high x, high y]. */
export function boxOf(points) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < points.length; i += 2) {
    box[0] = Math.min(box[0], points[i]);
    box[1] = Math.min(box[1], points[i + 1]);
    box[2] = Math.max(box[2], points[i]);
    box[3] = Math.max(box[3], points[i + 1]);
  }
  return box[0] <= box[2] ? box : [0, 0, 100, 100];
}

export class Plot {
  #paint = () => {};
  #waits = false;
  #holds = () => null;
  /** The pixel of the cross that keys move; null while a pointer is used. */
  cursor = null;

  constructor(canvas) {
    this.canvas = canvas;
    this.box = [0, 0, 100, 100];
    this.up = false;
    new ResizeObserver(() => this.redraw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
  }

  /** What is painted from now on: a function of the context and this plot. */
  show(paint) {
    this.#paint = paint;
    this.redraw();
  }

  redraw() {
    if (this.#waits) return;
    this.#waits = true;
    requestAnimationFrame(() => {
      this.#waits = false;
      this.#draw();
    });
  }

  #draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const g = this.canvas.getContext("2d");
    g.scale(ratio, ratio);
    g.lineJoin = g.lineCap = "round";
    this.#place(width, height);
    this.#paint(g, this, colours());
    if (this.cursor && !this.#holds() && document.activeElement === this.canvas) this.#cross(g);
  }

  #place(width, height) {
    const [x0, y0, x1, y1] = this.box;
    const margin = 26;
    const size = Math.max(x1 - x0, y1 - y0, Number.MIN_VALUE) || 1;
    const across = Math.max(x1 - x0, size * 1e-6);
    const along = Math.max(y1 - y0, size * 1e-6);
    this.scale = Math.min((width - 2 * margin) / across, (height - 2 * margin) / along);
    this.left = width / 2 - (this.scale * (x0 + x1)) / 2;
    const middle = (this.scale * (y0 + y1)) / 2;
    this.top = height / 2 + (this.up ? middle : -middle);
  }

  x(x) {
    return this.left + this.scale * x;
  }

  y(y) {
    return this.top + (this.up ? -this.scale : this.scale) * y;
  }

  /** The place of the plane under a pixel. */
  at(px, py) {
    const y = (py - this.top) / this.scale;
    return [(px - this.left) / this.scale, this.up ? -y : y];
  }

  /** The index of the point nearest to a pixel, at most `within` pixels away; -1 if there is none. */
  nearest(points, px, py, within = NEAR) {
    let [best, found] = [within * within, -1];
    for (let i = 0; 2 * i < points.length; i++) {
      const [dx, dy] = [this.x(points[2 * i]) - px, this.y(points[2 * i + 1]) - py];
      if (dx * dx + dy * dy < best) [best, found] = [dx * dx + dy * dy, i];
    }
    return found;
  }

  #cross(g) {
    const [x, y] = this.cursor;
    g.strokeStyle = colours()("differs");
    g.lineWidth = 1.5;
    g.beginPath();
    g.moveTo(x - 9, y);
    g.lineTo(x + 9, y);
    g.moveTo(x, y - 9);
    g.lineTo(x, y + 9);
    g.stroke();
  }

  /**
   * Calls `down`, `move` and `up` with pixels, from a pointer or from keys, and `key` for other keys.
   * `down` also gets how many pixels away a point still counts as meant. `holds` gives the place of
   * the point that arrows move, or null: then they move the cross. `leave` lets go of that point.
   */
  listen({ down = ignore, move = ignore, up = ignore, key = ignore, holds = () => null, leave = ignore }) {
    this.#holds = holds;
    const at = (event) => {
      const box = this.canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const on = (name, act) => this.canvas.addEventListener(name, (event) => event.isPrimary && act(event));
    on("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.cursor = null;
      down(...at(event), event.pointerType === "touch" ? FINGER : NEAR);
    });
    on("pointermove", (event) => move(...at(event), event.buttons > 0));
    on("pointerup", () => up());
    on("pointercancel", () => up());
    for (const name of ["focus", "blur"]) this.canvas.addEventListener(name, () => this.redraw());
    this.canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (!this.#press(event, { down, move, up, key, leave })) return;
      event.preventDefault();
      this.redraw();
    });
  }

  /** What a key does; whether it does something. */
  #press(event, { down, move, up, key, leave }) {
    const place = this.#holds();
    if (place) this.cursor = [this.x(place[0]), this.y(place[1])];
    const arrow = ARROWS[event.key];
    if (arrow) {
      const step = event.shiftKey ? LONG_STEP : STEP;
      const to = this.cross().map((v, k) => v + step * arrow[k]);
      const { clientWidth, clientHeight } = this.canvas;
      // The cross stays in the picture; a point may leave it.
      this.cursor = place ? to : to.map((v, k) => Math.min(Math.max(v, 0), k ? clientHeight : clientWidth));
      move(...this.cursor, place !== null);
    } else if (place && ["Enter", " ", "Escape"].includes(event.key)) {
      leave();
    } else if (event.key === "Enter" || event.key === " ") {
      this.cursor = this.cross();
      down(...this.cursor, NEAR);
      up();
    } else {
      return key(event.key) === true;
    }
    return true;
  }

  /** The pixel of the cross, which is in the middle at first. */
  cross() {
    return this.cursor ?? [this.canvas.clientWidth / 2, this.canvas.clientHeight / 2];
  }
}

const ignore = () => {};
/** How many pixels away from a point a mouse and a finger still mean it. */
const NEAR = 14;
const FINGER = 24;
/** How many pixels an arrow goes, and with Shift. */
const STEP = 3;
const LONG_STEP = 24;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Strokes pairs of places, each a segment: x, y, x, y. */
export function strokeSegments(g, plot, segments) {
  g.beginPath();
  for (let i = 0; i + 3 < segments.length; i += 4) {
    g.moveTo(plot.x(segments[i]), plot.y(segments[i + 1]));
    g.lineTo(plot.x(segments[i + 2]), plot.y(segments[i + 3]));
  }
  g.stroke();
}

/** Strokes edges between points, given as pairs of indices. */
export function strokeEdges(g, plot, points, edges) {
  g.beginPath();
  for (let i = 0; i + 1 < edges.length; i += 2) {
    const [a, b] = [edges[i], edges[i + 1]];
    g.moveTo(plot.x(points[2 * a]), plot.y(points[2 * a + 1]));
    g.lineTo(plot.x(points[2 * b]), plot.y(points[2 * b + 1]));
  }
  g.stroke();
}

/** Fills points as dots. */
export function fillPoints(g, plot, points, radius) {
  g.beginPath();
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [plot.x(points[i]), plot.y(points[i + 1])];
    g.moveTo(x + radius, y);
    g.arc(x, y, radius, 0, 2 * Math.PI);
  }
  g.fill();
}

/** Rings a point that is selected. */
export function ring(g, plot, colour, x, y) {
  g.strokeStyle = colour("accent");
  g.lineWidth = 2.5;
  g.beginPath();
  g.arc(plot.x(x), plot.y(y), 9, 0, 2 * Math.PI);
  g.stroke();
}

/** The distance of a place to a segment, and the share of it at which it is nearest. */
export function toSegment(x, y, [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1);
  const share = Math.min(1, Math.max(0, t));
  return [Math.hypot(x - ax - share * dx, y - ay - share * dy), share];
}

/** The index `by` steps from another one, around; from none, -1, the first or the last one. */
export const stepped = (from, by, count) => ((from < 0 && by < 0 ? 0 : from) + by + count) % count;
