// Strokes that are drawn in a picture, and bent: by a pointer or by keys.

import { boxOf, ring, stepped, strokeSegments } from "./plot.js";
import * as curve from "./stroke.js";

const POINT = -1;

export class Drawing {
  #plot;
  #isClosed;
  #changed;
  #tell;
  /** Whether a pointer drags, or arrows move, what is selected. */
  #held = false;
  /** Null where no drawing of the reader's own is shown. */
  strokes = null;
  /** The node that is selected: its stroke, its index, and which part of it moves. */
  selected = null;

  /** `changed` is called when the curve has, `tell` with words on what is selected. */
  constructor(plot, { isClosed, changed, tell }) {
    this.#plot = plot;
    this.#isClosed = isClosed;
    this.#changed = changed;
    this.#tell = tell;
    plot.listen({
      down: (x, y, within) => this.strokes && this.#press(x, y, within),
      move: (x, y, pressed) => pressed && this.#held && this.#move(x, y),
      holds: () => (this.strokes && this.#held && this.selected ? this.#place() : null),
      leave: () => this.#leave(),
      key: (key) => this.strokes !== null && this.#key(key),
    });
  }

  /** Begins with strokes that are there, or ends with null. */
  begin(strokes) {
    // There is always a stroke that the next click goes on with.
    this.strokes = strokes?.length === 0 ? [[]] : strokes;
    this.#plot.cursor = null;
    if (strokes) this.#plot.box = this.#box();
    this.select(null);
  }

  #box() {
    const nodes = this.strokes.flatMap((stroke) => stroke.map((node) => node.slice(0, 2)));
    const controls = this.strokes.flatMap((stroke) => curve.cubicsOf(stroke, this.#isClosed()));
    return boxOf([nodes, controls].flat(3));
  }

  /** A stroke that the next click begins. */
  addStroke() {
    if (this.strokes.at(-1)?.length !== 0) this.strokes.push([]);
    this.select(null);
    this.#tell("A new stroke: add its first point.");
  }

  /** Selects a node or one of its handles, and says which. */
  select(selected, held = false) {
    this.selected = selected;
    this.#held = held && selected !== null;
    this.#tell(this.#words());
    this.#plot.redraw();
  }

  /** Takes up that strokes were opened or closed: a handle may be gone. */
  reshape() {
    if (this.selected) this.select({ ...this.selected, part: POINT }, this.#held);
    this.#changed();
  }

  #stroke() {
    return this.strokes[this.selected.index];
  }

  #place() {
    const { node, part } = this.selected;
    if (part === POINT) return this.#stroke()[node].slice(0, 2);
    return curve.control(this.#stroke(), node, this.#isClosed(), part);
  }

  #leave() {
    this.#held = false;
    this.#tell(`${this.#words()} Arrows move the cross.`);
  }

  #press(x, y, within) {
    const found = this.#handleAt(x, y, within) ?? this.#nodeAt(x, y, within);
    if (found) {
      this.select(found, true);
      return;
    }
    const near = curve.closest(this.strokes, this.#isClosed(), this.#plot, x, y, within / 2);
    if (near) this.#split(near.index, near.segment, near.t);
    else this.#append(this.#plot.at(x, y));
    // Keys leave the cross free for the next point.
    this.#held = this.#plot.cursor === null;
  }

  #append(place) {
    const index = this.strokes.length - 1;
    this.strokes[index].push(place);
    this.select({ index, node: this.strokes[index].length - 1, part: POINT });
    this.#changed();
  }

  #split(index, segment, t) {
    const node = curve.split(this.strokes[index], segment, this.#isClosed(), t);
    this.select({ index, node, part: POINT });
    this.#changed();
  }

  /** A handle of the node that is selected, where it is nearer than that node. */
  #handleAt(x, y, within) {
    if (!this.selected) return null;
    const { index, node } = this.selected;
    const stroke = this.#stroke();
    const parts = curve.sides(stroke, node, this.#isClosed());
    const ends = parts.map((part) => curve.control(stroke, node, this.#isClosed(), part));
    const found = this.#plot.nearest([stroke[node].slice(0, 2), ...ends].flat(), x, y, within);
    return found > 0 ? { index, node, part: parts[found - 1] } : null;
  }

  #nodeAt(x, y, within) {
    const all = this.#all();
    const places = all.flatMap(({ index, node }) => this.strokes[index][node].slice(0, 2));
    return all[this.#plot.nearest(places, x, y, within)] ?? null;
  }

  #all() {
    return this.strokes.flatMap((stroke, index) => stroke.map((_, node) => ({ index, node, part: POINT })));
  }

  #move(x, y) {
    const place = this.#plot.at(x, y);
    const { node, part } = this.selected;
    if (part === POINT) this.#stroke()[node].splice(0, 2, ...place);
    else curve.bend(this.#stroke(), node, this.#isClosed(), part, place);
    this.#tell(this.#words());
    this.#changed();
  }

  #key(key) {
    const act = {
      ".": () => this.#step(1),
      ",": () => this.#step(-1),
      h: () => this.#nextPart(),
      a: () => this.#addByKey(),
      c: () => this.selected && this.makeCorner(!this.isCorner()),
      delete: () => this.remove(),
      backspace: () => this.remove(),
      escape: () => this.select(null),
    }[key.toLowerCase()];
    act?.();
    return act !== undefined;
  }

  #step(by) {
    const all = this.#all();
    if (all.length === 0) return;
    const { index, node } = this.selected ?? {};
    const at = all.findIndex((other) => other.index === index && other.node === node);
    this.select(all[stepped(at, by, all.length)], true);
  }

  /** From the point to its handles, one after the other, and back. */
  #nextPart() {
    if (!this.selected) return;
    const { index, node, part } = this.selected;
    const parts = [POINT, ...curve.sides(this.#stroke(), node, this.#isClosed())];
    this.select({ index, node, part: parts[(parts.indexOf(part) + 1) % parts.length] }, true);
  }

  #addByKey() {
    if (this.#held) this.addAfter();
    else this.#append(this.#plot.at(...this.#plot.cross()));
    this.#plot.cursor ??= this.#plot.cross();
  }

  /** Whether there is a segment after the node that is selected. */
  hasNext() {
    if (!this.selected) return false;
    return this.selected.node < curve.cubicsOf(this.#stroke(), this.#isClosed()).length;
  }

  /** Adds a node in the middle of the segment after the one that is selected. */
  addAfter() {
    if (!this.hasNext()) return;
    this.#split(this.selected.index, this.selected.node, 0.5);
    this.#held = true;
  }

  /** Removes the node that is selected, and selects the one that follows. */
  remove() {
    if (!this.selected) return;
    const { index, node } = this.selected;
    const stroke = this.#stroke();
    stroke.splice(node, 1);
    if (stroke.length === 0 && this.strokes.length > 1) this.strokes.splice(index, 1);
    const left = this.strokes[index] === stroke ? stroke.length : 0;
    this.select(left ? { index, node: Math.min(node, left - 1), part: POINT } : null, true);
    this.#tell(`Point removed. ${this.#words()}`);
    this.#changed();
  }

  isCorner() {
    return this.selected !== null && curve.isCorner(this.#stroke()[this.selected.node]);
  }

  makeCorner(corner) {
    curve.makeCorner(this.#stroke(), this.selected.node, this.#isClosed(), corner);
    this.#tell(this.#words());
    this.#changed();
  }

  #words() {
    if (!this.selected) return "";
    const { index, node, part } = this.selected;
    const stroke = this.#stroke();
    const at = this.#place().map((v) => v.toFixed(1)).join(", ");
    const where = this.strokes.length > 1 ? ` of stroke ${index + 1}` : "";
    const count = `${node + 1} of ${stroke.length}${where}`;
    if (part === curve.BEFORE) return `Handle before point ${count}: ${at}.`;
    if (part === curve.AFTER) return `Handle after point ${count}: ${at}.`;
    const isEnd = curve.sides(stroke, node, this.#isClosed()).length < 2;
    return `Point ${count}, ${isEnd ? "an end" : this.isCorner() ? "a corner" : "smooth"}: ${at}.`;
  }

  /** The strokes alone, before anything is known of them. */
  paintStrokes(g, plot, colour) {
    const at = ([x, y]) => [plot.x(x), plot.y(y)];
    g.strokeStyle = colour("curve");
    g.lineWidth = 2;
    g.beginPath();
    for (const stroke of this.strokes) {
      for (const [from, ...controls] of curve.cubicsOf(stroke, this.#isClosed())) {
        g.moveTo(...at(from));
        g.bezierCurveTo(...controls.flatMap(at));
      }
    }
    g.stroke();
  }

  /** The points, and the handles of the one that is selected. */
  paint(g, plot, colour) {
    g.strokeStyle = colour("text");
    g.lineWidth = 1.5;
    g.fillStyle = colour("card");
    for (const stroke of this.strokes) {
      for (const [x, y] of stroke) paintNode(g, plot.x(x), plot.y(y));
    }
    if (this.selected) this.#paintHandles(g, plot, colour);
    if (this.selected) ring(g, plot, colour, ...this.#place());
  }

  #paintHandles(g, plot, colour) {
    const { node, part } = this.selected;
    const stroke = this.#stroke();
    const [x, y] = stroke[node];
    for (const side of curve.sides(stroke, node, this.#isClosed())) {
      const end = curve.control(stroke, node, this.#isClosed(), side);
      g.fillStyle = colour(side === part ? "accent" : "card");
      strokeSegments(g, plot, [x, y, ...end]);
      paintHandle(g, plot.x(end[0]), plot.y(end[1]));
    }
  }
}

function paintNode(g, x, y) {
  g.beginPath();
  g.arc(x, y, 4.5, 0, 2 * Math.PI);
  g.fill();
  g.stroke();
}

function paintHandle(g, x, y) {
  g.beginPath();
  g.rect(x - 5.5, y - 5.5, 11, 11);
  g.fill();
  g.stroke();
}
