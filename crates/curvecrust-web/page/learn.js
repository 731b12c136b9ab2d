// The guided page: six steps, each with a figure that can be moved.

import { Lane } from "./engine.js";
import { circle, draggable, section } from "./figure.js";
import { half, nearest } from "./neighbours.js";
import { boxOf, fillPoints, strokeEdges, strokeSegments } from "./plot.js";
import { rollingBalls } from "./rolling.js";
import { polygon } from "./sample.js";

export { redrawFigures as enter } from "./figure.js";

export function start({ curves }) {
  const svg = (name) => (curves.find((curve) => curve.name === name) ?? curves[0]).svg;
  featureSize(svg("teaser"));
  conditions(svg("bunny"));
  neighbours();
  angles();
  rollingBalls();
  unique();
}

function paintCurve(g, plot, colour, curve) {
  g.strokeStyle = colour("curve");
  g.lineWidth = 3;
  strokeEdges(g, plot, curve.dense, polygon(curve));
}

async function featureSize(svg) {
  const { plot, slider, note } = section(
    "1. How much detail is where",
    [
      "The medial axis (blue) holds the points with two or more nearest points on the curve.",
      "The local feature size, lfs, of a point of the curve is its distance to the medial axis. It is small where the curve bends or comes near itself. The reach of a piece is the smallest lfs on it.",
    ],
    { label: "Place on the curve", min: 0, max: 999, value: 430 },
  );
  const curve = await new Lane().curve({ curve: { svg } });
  plot.box = curve.box;
  const count = curve.dense.length / 2;
  const at = () => Math.min(count - 1, Math.floor((slider.value / 1000) * count));
  plot.show((g, place, colour) => {
    g.strokeStyle = colour("axis");
    strokeSegments(g, place, curve.axis);
    paintCurve(g, place, colour, curve);
    const point = curve.dense.subarray(2 * at(), 2 * at() + 2);
    circle(g, place, ...point, curve.lfs[at()], colour("differs"));
    g.fillStyle = colour("differs");
    fillPoints(g, place, point, 5);
  });
  const tell = () => {
    note.textContent = `lfs here: ${((100 * curve.lfs[at()]) / curve.extent).toFixed(1)} % of the drawing.`;
    plot.redraw();
  };
  slider.addEventListener("input", tell);
  tell();
}

async function conditions(svg) {
  const { plot, slider, note } = section(
    "2. Two conditions",
    [
      "Epsilon asks for a sample within epsilon times the lfs at every point. Rho asks for one within rho times the reach of the piece between two samples.",
      "Every epsilon-sample is a rho-sample with rho = epsilon / (1 - epsilon). The other way round, rho allows far fewer samples.",
    ],
    { label: "Bound", min: 0.15, max: 0.9, step: 0.01, value: 0.47 },
  );
  const lane = new Lane();
  const curve = await lane.curve({ curve: { svg } });
  plot.box = curve.box;
  let shown = null;
  plot.show((g, place, colour) => {
    paintCurve(g, place, colour, curve);
    if (!shown) return;
    g.fillStyle = colour("point");
    fillPoints(g, place, shown.samples, 4);
  });
  const update = async () => {
    const bound = Number(slider.value);
    const rho = bound / (1 - bound);
    const epsilonSamples = await lane.ask({ sample: { condition: "epsilon", bound } });
    if (!epsilonSamples) return;
    const parts = [`epsilon < ${bound.toFixed(2)}: ${epsilonSamples.samples.length / 2} samples (shown)`];
    shown = epsilonSamples;
    plot.redraw();
    if (rho <= 1) {
      const answer = await lane.ask({ sample: { condition: "rho", bound: rho } });
      if (!answer) return;
      parts.push(`rho < ${rho.toFixed(2)}, which it implies: ${answer.samples.length / 2}`);
    }
    note.textContent = `${parts.join("; ")}.`;
  };
  slider.addEventListener("input", update);
  update();
}

function neighbours() {
  const { plot, note } = section("3. Nearest and half neighbour", [
    "HNN-Crust joins each sample s to its nearest neighbour n. Then it looks at the half plane beyond the bisector of s and n, which holds all that is nearer to s.",
    "The closest sample in there is the half neighbour h. Drag the points.",
  ]);
  const points = [50, 50, 68, 40, 22, 55, 15, 30, 80, 70, 40, 85, 88, 25];
  plot.box = [0, 5, 100, 95];
  plot.show((g, place, colour) => {
    const n = nearest(points, 0);
    const h = half(points, 0, n);
    paintHalfPlane(g, place, colour, points, n);
    g.lineWidth = 3;
    g.strokeStyle = colour("edge");
    strokeEdges(g, place, points, [0, n]);
    g.strokeStyle = colour("differs");
    if (h >= 0) strokeEdges(g, place, points, [0, h]);
    g.fillStyle = colour("point");
    fillPoints(g, place, points, 5);
    g.fillStyle = colour("text");
    g.font = "16px system-ui";
    for (const [name, v] of [["s", 0], ["n", n], ["h", h]]) {
      if (v >= 0) g.fillText(name, place.x(points[2 * v]) + 9, place.y(points[2 * v + 1]) - 9);
    }
    drag.paint(g, place, colour);
  });
  const tell = () => {
    const n = nearest(points, 0);
    const h = half(points, 0, n);
    const names = (v) => ({ 0: "s, ", [n]: "n, ", [h]: "h, " })[v] ?? "";
    const other = h < 0 ? " No sample is nearer to s than to n: s has no half neighbour." : "";
    note.textContent = drag.words((v) => `Point ${names(v)}${v + 1} of ${points.length / 2}`) + other;
    plot.redraw();
  };
  const put = (v, place) => points.splice(2 * v, 2, ...place);
  const drag = draggable(plot, { places: () => points, put, tell });
  tell();
}

function paintHalfPlane(g, plot, colour, points, n) {
  const [sx, sy] = points;
  const [dx, dy] = [points[2 * n] - sx, points[2 * n + 1] - sy];
  const [mx, my] = [sx + dx / 2, sy + dy / 2];
  const far = 300 / (Math.hypot(dx, dy) || 1);
  const corner = (a, b) => [plot.x(mx + far * (a * dx - b * dy)), plot.y(my + far * (a * dy + b * dx))];
  g.fillStyle = colour("axis");
  g.globalAlpha = 0.18;
  g.beginPath();
  for (const place of [corner(0, -1), corner(0, 1), corner(-1, 1), corner(-1, -1)]) g.lineTo(...place);
  g.fill();
  g.globalAlpha = 1;
}

function angles() {
  const { plot, slider, note } = section(
    "4. Sharp angles",
    [
      "Crust can lose an edge where consecutive samples meet at less than 90 degrees. HNN-Crust, where edges are of equal length, gets down to 60.",
      "So much sharper are the bends that few samples may show. Red edges: HNN-Crust alone finds them.",
    ],
    { label: "Angle", min: 45, max: 130, value: 75 },
  );
  const lanes = [new Lane(), new Lane()];
  let shown = null;
  plot.show((g, place, colour) => {
    if (!shown) return;
    const { points, crust, hnn } = shown;
    g.lineWidth = 4;
    g.strokeStyle = colour("differs");
    strokeEdges(g, place, points, hnn.edges);
    g.strokeStyle = colour("edge");
    strokeEdges(g, place, points, crust.edges);
    g.fillStyle = colour("point");
    fillPoints(g, place, points, 5);
  });
  const update = async () => {
    const points = Float64Array.from(zigzag(Number(slider.value)));
    const ask = (lane, algorithm) => lane.ask({ reconstruct: { algorithm } }, points);
    const [crust, hnn] = await Promise.all([ask(lanes[0], "crust"), ask(lanes[1], "hnn-crust")]);
    if (!crust || !hnn) return;
    shown = { points, crust, hnn };
    plot.box = boxOf(points);
    note.textContent = `${slider.value} degrees: Crust finds ${crust.edges.length / 2} edges, HNN-Crust ${hnn.edges.length / 2}.`;
    plot.redraw();
  };
  slider.addEventListener("input", update);
  update();
}

/** A row of teeth of an angle, with an arm at each end that goes straight on and up. */
function zigzag(degrees) {
  const turn = (degrees * Math.PI) / 360;
  const [across, along] = [Math.sin(turn), Math.cos(turn)];
  const points = [];
  for (let i = -3; i <= 3; i++) points.push(i * across, i & 1 ? along : 0);
  for (const side of [-1, 1]) {
    for (let i = 1; i <= 3; i++) points.push(side * (3 * across + 0.9 * i), along - 0.5 * i);
  }
  return points;
}

function unique() {
  const { plot, slider, note } = section(
    "6. Where the answer stops being unique",
    [
      "Too few samples do not tell what they come from. Here two rows come nearer to each other, until across is as short as along.",
      "Least detour says by how much at most its answer is better than the next one: the smallest margin of its edges.",
    ],
    { label: "Distance of the rows", min: 0.5, max: 2.5, step: 0.05, value: 1 },
  );
  const lane = new Lane();
  let shown = null;
  plot.show((g, place, colour) => {
    if (!shown) return;
    g.lineWidth = 3;
    g.strokeStyle = colour("edge");
    strokeEdges(g, place, shown.points, shown.edges);
    g.fillStyle = colour("point");
    fillPoints(g, place, shown.points, 5);
  });
  const update = async () => {
    const gap = Number(slider.value);
    const points = Float64Array.from([0, 1, 2, 3, 4, 5].flatMap((x) => [x, 0, x, gap]));
    const answer = await lane.ask({ reconstruct: { algorithm: "least-detour", reasons: true } }, points);
    if (!answer) return;
    shown = { points, edges: answer.edges };
    plot.box = boxOf(points);
    const margins = Array.from(answer.margins).filter(Number.isFinite);
    const margin = margins.length ? Math.min(...margins).toFixed(2) : "none needed: all are certified";
    const count = answer.lengths.length;
    note.textContent = `${count} ${count === 1 ? "curve" : "curves"}; smallest margin, at most: ${margin}.`;
    plot.redraw();
  };
  slider.addEventListener("input", update);
  update();
}
