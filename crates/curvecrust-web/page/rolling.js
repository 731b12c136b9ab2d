// The step of the guided page with the paper's Figure 8, whose points can be dragged.

import { balls, bisectorEnds, layout, rays, steepest, weakest } from "./cover.js";
import { circle, draggable, section } from "./figure.js";
import { fillPoints, strokeSegments } from "./plot.js";

/** Bends are shares of the steepest angle; of x and s0 on the left, of y and s2 on the right. */
const FOURTH = { rho: 0.9, ratio: Math.SQRT1_2, left: 1, right: 0 };
const PRESETS = {
  "As in the paper": FOURTH,
  "Not covered": { ...FOURTH, ratio: 0.73 },
};
const SMALLEST = 0.05;
const NAMES = ["s0", "x", "y", "s2"];

const clamp = (v, low, high) => Math.min(high, Math.max(low, v));

export function rollingBalls() {
  const { plot, slider, note, text } = section(
    "5. Rolling balls",
    [
      "s0, s1 and s2 are samples in the order of the curve, x and y are halfway between them, and y is as far from s1 as rho allows. Balls (blue) roll along the curve. Their centres are nearer to s1 or to x than the lfs there, so no other part of the curve is inside, and no sample.",
      "The shaded region is nearer to s1 than to s0, and nearer to s1 than s2 is. If the balls cover it, s2 is the half neighbour of s1. Figure 8 of the paper shows this for rho = 0.9. From rho = 0.895 on, some ratios of x s1 to s1 y leave a place open (red): with a sample z there, HNN-Crust loses the edge to s2.",
      "Drag s0, x, y or s2, and the slider of rho.",
    ],
    { label: "rho", min: 0.5, max: 1, step: 0.005, value: 0.9 },
  );
  let state = { ...FOURTH };
  let figure = null;
  let least = null;
  plot.box = [-2.35, -2.05, 2.2, 2.05];
  plot.up = true;
  const tell = () => {
    figure = layout(angled(state));
    least = weakest(figure);
    note.textContent = `${drag.words((v) => NAMES[v])} ${words(state, least)}`.trim();
    plot.redraw();
  };
  const change = (changed) => {
    state = { ...state, ...changed };
    slider.value = state.rho;
  };
  const places = () => NAMES.flatMap((name) => figure[name]);
  const put = (v, place) => change(dragged(state, NAMES[v], place));
  const drag = draggable(plot, { places, put, tell });
  slider.addEventListener("input", () => {
    change({ rho: Number(slider.value) });
    tell();
  });
  text.insertBefore(presets((chosen) => (change(chosen), tell())), note);
  plot.show((g, picture, colour) => {
    paint(g, picture, colour, figure, least);
    drag.paint(g, picture, colour);
  });
  tell();
}

function presets(choose) {
  const row = Object.assign(document.createElement("div"), { className: "row buttons" });
  for (const [name, chosen] of Object.entries(PRESETS)) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
    button.addEventListener("click", () => choose(chosen));
    row.append(button);
  }
  return row;
}

function angled({ rho, ratio, left, right }) {
  return { rho, ratio, alpha: left * steepest(ratio * rho), beta: right * steepest(rho) };
}

/** What changes when a point is dragged to a place, within what the condition allows. */
function dragged({ rho }, name, [px, py]) {
  // s0 and s2 are at twice the angle of x and y.
  const share = name === "s0" || name === "s2" ? 0.5 : 1;
  if (name === "y" || name === "s2") {
    return { right: clamp((share * Math.atan2(-py, px)) / steepest(rho), 0, 1) };
  }
  const alpha = clamp(share * Math.atan2(-py, -px), 0, steepest(rho));
  const length = Math.hypot(px, py) / (name === "s0" ? 2 * Math.cos(alpha) : 1);
  const ratio = clamp(length / rho, SMALLEST, 1);
  return { ratio, left: clamp(alpha / steepest(ratio * rho), 0, 1) };
}

function words(state, least) {
  const { rho, ratio, alpha, beta } = angled(state);
  const degrees = (angle) => `${((180 * angle) / Math.PI).toFixed(1)}°`;
  const angles = `x at ${degrees(alpha)} and y at ${degrees(beta)} below the tangent`;
  const start = `rho ${rho.toFixed(3)}, ratio ${ratio.toFixed(3)}, ${angles}`;
  const reach = Math.abs(least.spare).toFixed(4);
  if (least.spare < 0) return `${start}: not covered. z is ${reach} of the lfs outside of all balls.`;
  return `${start}: covered. Balls reach ${reach} of the lfs beyond the corner.`;
}

/** How many balls are drawn for a turn of their centre, and how many for what they cover. */
const DRAWN = 72;
const COVERING = 1440;

function paint(g, plot, colour, figure, least) {
  const region = outline(figure);
  g.fillStyle = colour("axis");
  g.globalAlpha = 0.25;
  trace(g, plot, region);
  g.fill();
  g.globalAlpha = 0.45;
  for (const { centre, radius } of balls(figure, DRAWN)) circle(g, plot, ...centre, radius, colour("axis"));
  g.globalAlpha = 1;
  paintGap(g, plot, colour, figure, region);
  paintConstruction(g, plot, colour, figure);
  paintNames(g, plot, colour, figure, least);
}

function trace(g, plot, places) {
  g.beginPath();
  for (const [x, y] of places) g.lineTo(plot.x(x), plot.y(y));
  g.closePath();
}

/** The boundary of what has to be covered. */
function outline(figure) {
  const all = rays(figure, 360);
  const ends = (name) => all.map((ray) => ray.direction.map((v) => ray[name] * v));
  return [...ends("to"), ...ends("from").reverse()];
}

/** The region without all balls, from a sheet of its own. */
function paintGap(g, plot, colour, figure, region) {
  const sheet = document.createElement("canvas");
  [sheet.width, sheet.height] = [plot.canvas.width, plot.canvas.height];
  const h = sheet.getContext("2d");
  h.setTransform(g.getTransform());
  h.fillStyle = colour("differs");
  trace(h, plot, region);
  h.fill();
  h.globalCompositeOperation = "destination-out";
  h.beginPath();
  for (const { centre, radius } of balls(figure, COVERING)) {
    const [x, y, r] = [plot.x(centre[0]), plot.y(centre[1]), radius * plot.scale];
    h.moveTo(x + r, y);
    h.arc(x, y, r, 0, 2 * Math.PI);
  }
  h.fill();
  g.save();
  g.resetTransform();
  g.drawImage(sheet, 0, 0);
  g.restore();
}

/** The circle through s2, the bisector of s0 and s1, and the curve from s0 to s2. */
function paintConstruction(g, plot, colour, figure) {
  const { s0, s2, radius, bend, bendRight } = figure;
  g.setLineDash([5, 5]);
  circle(g, plot, 0, 0, radius, colour("soft"));
  strokeSegments(g, plot, bisectorEnds(figure).flat());
  g.setLineDash([]);
  g.strokeStyle = colour("curve");
  g.lineWidth = 3;
  g.beginPath();
  const curve = [...arc(s0, bend).reverse(), ...arc(s2, bendRight)];
  for (const [x, y] of curve) g.lineTo(plot.x(x), plot.y(y));
  g.stroke();
}

/** From s1 to a sample, along a circle that touches the tangent in s1. */
function arc([x, y], radius) {
  if (!Number.isFinite(radius)) return [[0, 0], [x, y]];
  const turn = 2 * Math.atan2(-y, Math.abs(x));
  return Array.from({ length: 61 }, (_, i) => {
    const angle = (turn * i) / 60;
    return [Math.sign(x) * radius * Math.sin(angle), radius * (Math.cos(angle) - 1)];
  });
}

function paintNames(g, plot, colour, figure, least) {
  const { s0, x, y, s2 } = figure;
  g.fillStyle = colour("point");
  fillPoints(g, plot, [s0, [0, 0], s2].flat(), 5);
  g.fillStyle = colour("soft");
  fillPoints(g, plot, [x, y].flat(), 4);
  g.font = "16px system-ui";
  g.fillStyle = colour("text");
  const below = [4, 22];
  for (const [name, place] of Object.entries({ s0, x, s1: [0, 0], y, s2 })) {
    paintName(g, plot, colour, name, place, below);
  }
  if (least.spare >= 0) return;
  g.fillStyle = colour("differs");
  fillPoints(g, plot, least.place, 5);
  paintName(g, plot, colour, "z", least.place, [-18, -6]);
}

/** A name beside its point, where there are no balls. */
function paintName(g, plot, colour, name, [x, y], [right, down]) {
  const place = [plot.x(x) + right, plot.y(y) + down];
  g.strokeStyle = colour("card");
  g.lineWidth = 4;
  g.strokeText(name, ...place);
  g.fillText(name, ...place);
}
