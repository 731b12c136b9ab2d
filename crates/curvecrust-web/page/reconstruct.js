// The view that joins points: two algorithms beside each other.

import { Lane } from "./engine.js";
import { Plot, boxOf, fillPoints, strokeEdges } from "./plot.js";
import { save } from "./save.js";

const get = (id) => document.getElementById(id);
const sides = ["a", "b"].map((side) => ({ side, lane: new Lane(), answer: null, plot: null }));
/** With more points than this, edges come without reasons, which take longer. */
const EXPLAINED = 20_000;
const UNDONE = 50;

let points = [];
let up = true;
let past = [];
let dragged = -1;
let marked = null;
let attempt = null;

export function state() {
  const settings = { a: get("algorithm-a").value, b: get("algorithm-b").value };
  return { points, up, shape: get("shape").value, curves: get("curves").value, ...settings };
}

/** Takes other points, and fits the pictures to them. */
export function setPoints(others, turned = up) {
  remember();
  points = others;
  up = turned;
  fit();
  return update();
}

export function enter() {
  for (const { plot } of sides) plot?.redraw();
}

export function start({ points: fixtures, attempt: doing, state: linked }) {
  attempt = doing;
  for (const side of sides) listenTo(side);
  fillSelects(fixtures);
  for (const id of ["algorithm-a", "algorithm-b", "shape", "curves"]) {
    get(id).addEventListener("input", update);
  }
  for (const button of document.querySelectorAll("[data-change]")) {
    button.addEventListener("click", () => change(button.dataset.change));
  }
  for (const button of document.querySelectorAll("[data-export]")) {
    const [{ plot }] = sides;
    button.addEventListener("click", () =>
      attempt(() => save(button.dataset.export, { points, answer: sides[0].answer, plot })),
    );
  }
  if (isState(linked)) restore(linked);
  else setPoints(fixtures[0].points.slice());
}

/** Whether a link holds points; it may come from anywhere. */
function isState(linked) {
  const list = linked?.points;
  return Array.isArray(list) && list.length % 2 === 0 && list.every((n) => Number.isFinite(n));
}

function restore(linked) {
  const names = { shape: "shape", curves: "curves", a: "algorithm-a", b: "algorithm-b" };
  for (const [name, id] of Object.entries(names)) {
    if (typeof linked[name] === "string") get(id).value = linked[name];
    if (get(id).tagName === "SELECT" && get(id).selectedIndex < 0) get(id).selectedIndex = 0;
  }
  get("points-fixture").selectedIndex = 0;
  setPoints(linked.points, linked.up === true);
}

async function fillSelects(fixtures) {
  const select = get("points-fixture");
  select.add(new Option("my own", ""));
  for (const { name } of fixtures) select.add(new Option(name, name));
  select.value = fixtures[0].name;
  select.addEventListener("input", () => {
    const chosen = fixtures.find(({ name }) => name === select.value);
    setPoints(chosen ? chosen.points.slice() : [], true);
  });
  for (const name of ALGORITHMS) {
    for (const { side } of sides) get(`algorithm-${side}`).add(new Option(name, name));
  }
  get("algorithm-b").value = "crust";
}

/** As the library lists them; a test of the page compares. */
export const ALGORITHMS = [
  "least-detour",
  "hnn-crust",
  "hnn-crust-union",
  "nn-crust",
  "crust",
  "one-step-crust",
  "beta-skeleton",
  "gabriel",
  "normalised-mesh",
  "alpha-shape",
  "sphere-of-influence",
  "spanning-tree",
  "conservative-crust",
  "gathan-like",
  "gathan-g-like",
  "lenz-like",
  "discur",
  "vicur-like",
  "crawl",
  "peel",
  "connect2d",
  "sig-connect2d",
  "shortest-tour",
];

function remember() {
  past.push({ points, up });
  past = past.slice(-UNDONE);
}

function fit() {
  for (const { plot } of sides) {
    plot.box = boxOf(points);
    plot.up = up;
  }
}

/** Asks for both sides anew. */
async function update() {
  marked = null;
  const sent = Float64Array.from(points);
  await Promise.all(sides.map((side) => attempt(() => ask(side, sent))));
}

async function ask(side, sent) {
  const request = { algorithm: get(`algorithm-${side.side}`).value };
  if (get("shape").value) request.shape = get("shape").value;
  if (Number(get("curves").value) >= 1) request.curves = Math.floor(Number(get("curves").value));
  request.reasons = sent.length / 2 <= EXPLAINED;
  const canKnow = request.algorithm === "least-detour";
  const unused = !canKnow && (request.shape || request.curves);
  if (!canKnow) {
    delete request.shape;
    delete request.curves;
  }
  const caption = get(`caption-${side.side}`);
  try {
    const answer = await side.lane.ask({ reconstruct: request }, sent);
    if (!answer) return;
    side.answer = answer;
    side.points = points;
    const left = unused ? "; it cannot use what you know" : "";
    caption.textContent = summary(request.algorithm, answer) + left;
  } catch (error) {
    side.answer = null;
    caption.textContent = `${request.algorithm}: no result`;
    throw error;
  } finally {
    compare();
    for (const { plot } of sides) plot.redraw();
  }
}

const counted = (count, one, more = `${one}s`) => `${count} ${count === 1 ? one : more}`;

function summary(name, answer) {
  const closed = answer.closed.reduce((sum, one) => sum + one, 0);
  const parts = [
    counted(answer.edges.length / 2, "edge"),
    `${closed} closed and ${answer.closed.length - closed} open`,
    answer.isolated.length ? `${answer.isolated.length} alone` : "",
    answer.junctions.length ? counted(answer.junctions.length, "junction") : "",
    answer.duplicates ? `${counted(answer.duplicates, "equal point")} merged` : "",
    `${answer.milliseconds.toFixed(answer.milliseconds < 10 ? 1 : 0)} ms`,
  ];
  return `${name}: ${parts.filter(Boolean).join(", ")}`;
}

/** Marks the edges of each side that the other one lacks. */
function compare() {
  const key = (edges, i) => edges[i] * 4294967296 + edges[i + 1];
  for (const [own, other] of [sides, [...sides].reverse()]) {
    if (!own.answer) continue;
    const theirs = new Set();
    const edges = other.answer?.edges ?? own.answer.edges;
    for (let i = 0; i < edges.length; i += 2) theirs.add(key(edges, i));
    own.common = [];
    own.differing = [];
    const mine = own.answer.edges;
    for (let i = 0; i < mine.length; i += 2) {
      const list = theirs.has(key(mine, i)) ? own.common : own.differing;
      list.push(mine[i], mine[i + 1]);
    }
  }
}

function listenTo(side) {
  const canvas = get(`canvas-${side.side}`);
  const place = side.side === "a" ? "Left" : "Right";
  canvas.setAttribute("aria-label", `${place} result: points and their edges`);
  side.plot = new Plot(canvas);
  side.plot.show((g, plot, colour) => paint(g, plot, colour, side));
  side.plot.listen({
    down: (x, y) => press(side.plot, x, y),
    move: (x, y, pressed) => (pressed && dragged >= 0 ? drag(side.plot, x, y) : hover(side, x, y)),
    up: () => (dragged = -1),
    holds: () => dragged >= 0,
    key: (key) => step(side, { n: 1, N: 1, p: -1, P: -1 }[key]),
  });
}

function paint(g, plot, colour, side) {
  const edges = side.answer && side.points.length <= points.length ? side.answer.edges : [];
  const many = points.length > 4000;
  g.lineWidth = many ? 1 : 2;
  g.strokeStyle = colour("edge");
  strokeEdges(g, plot, points, edges.length ? side.common : []);
  g.strokeStyle = colour("differs");
  g.setLineDash([6, 5]);
  strokeEdges(g, plot, points, edges.length ? side.differing : []);
  g.setLineDash([]);
  if (marked?.side === side && marked.edge >= 0) {
    g.lineWidth = 6;
    g.strokeStyle = colour("accent");
    strokeEdges(g, plot, points, edges.subarray(2 * marked.edge, 2 * marked.edge + 2));
  }
  g.fillStyle = colour("point");
  fillPoints(g, plot, points, many ? 1.2 : 3.4);
  if (edges.length) rings(g, plot, colour, side.answer.leaves);
}

function rings(g, plot, colour, ends) {
  g.lineWidth = 2;
  g.strokeStyle = colour("differs");
  for (const v of ends) {
    g.beginPath();
    g.arc(plot.x(points[2 * v]), plot.y(points[2 * v + 1]), 7, 0, 2 * Math.PI);
    g.stroke();
  }
}

function press(plot, x, y) {
  const tool = document.querySelector("[name=tool]:checked").value;
  const nearest = plot.nearest(points, x, y);
  if (tool !== "add" && nearest < 0) return;
  remember();
  points = points.slice();
  if (tool === "add") points.push(...plot.at(x, y));
  if (tool === "erase") points.splice(2 * nearest, 2);
  if (tool === "move") dragged = nearest;
  get("points-fixture").selectedIndex = 0;
  for (const side of sides) if (tool === "erase") side.answer = null;
  update();
}

function drag(plot, x, y) {
  points = points.slice();
  [points[2 * dragged], points[2 * dragged + 1]] = plot.at(x, y);
  update();
}

/** Says why the edge or the end under the pointer is there. */
function hover(side, x, y) {
  if (!side.answer || side.points !== points) return;
  const end = side.plot.nearest(points, x, y, 9);
  if (end >= 0 && side.answer.leaves.includes(end)) return mark(side, -1, end);
  let [best, found] = [10, -1];
  const { edges } = side.answer;
  if (edges.length > 40_000) return;
  for (let i = 0; i < edges.length; i += 2) {
    const distance = toSegment(side.plot, x, y, edges[i], edges[i + 1]);
    if (distance < best) [best, found] = [distance, i / 2];
  }
  mark(side, found, -1);
}

function toSegment(plot, x, y, a, b) {
  const [ax, ay] = [plot.x(points[2 * a]), plot.y(points[2 * a + 1])];
  const [bx, by] = [plot.x(points[2 * b]) - ax, plot.y(points[2 * b + 1]) - ay];
  const t = ((x - ax) * bx + (y - ay) * by) / (bx * bx + by * by || 1);
  const s = Math.min(1, Math.max(0, t));
  return Math.hypot(x - ax - s * bx, y - ay - s * by);
}

function step(side, by) {
  const count = (side.answer?.edges.length ?? 0) / 2;
  if (!by || count === 0) return false;
  const from = marked?.side === side ? marked.edge : by > 0 ? -1 : 0;
  mark(side, (from + by + count) % count, -1);
  return true;
}

function mark(side, edge, end) {
  if (marked?.side === side && marked.edge === edge && marked.end === end) return;
  marked = { side, edge, end };
  get("reason").textContent = edge >= 0 ? why(side, edge) : end >= 0 ? whyEnd(side, end) : "";
  for (const { plot } of sides) plot.redraw();
}

const REASONS = {
  certified: "certified: HNN-Crust finds it too, and nothing around it is open",
  completed: "completed: the shortest that was left, and no exchange removed it",
  exchanged: "exchanged: an exchange that lowered the cost added it",
  required: "required by what you know",
};

function why(side, edge) {
  const { edges, reasons, margins } = side.answer;
  const name = get(`algorithm-${side.side}`).value;
  const start = `Edge ${edges[2 * edge]} – ${edges[2 * edge + 1]} by ${name}: `;
  if (!reasons) return `${start}its definition is its reason.`;
  const margin = Number.isFinite(margins[edge])
    ? ` Without it the cost would rise by at most ${margins[edge].toFixed(2)}.`
    : "";
  return `${start}${REASONS[reasons[edge]] ?? reasons[edge]}.${margin}`;
}

function whyEnd(side, end) {
  const at = side.answer.ends?.indexOf(end) ?? -1;
  if (at < 0) return `Point ${end} is an open end.`;
  const [partner, cost] = side.answer.rejected.subarray(2 * at, 2 * at + 2);
  if (!Number.isFinite(partner)) return `Point ${end} is an open end: no other edge was possible.`;
  return `Point ${end} is an open end: an edge to ${partner} was rejected, the cost would rise by ${cost.toFixed(2)}.`;
}

function change(kind) {
  if (kind === "undo") {
    const before = past.pop();
    if (before) ({ points, up } = before);
    fit();
    update();
    return;
  }
  const pairs = [];
  for (let i = 0; i < points.length; i += 2) pairs.push([points[i], points[i + 1]]);
  const [x0, y0, x1, y1] = boxOf(points);
  const size = 0.01 * Math.max(x1 - x0, y1 - y0);
  const noisy = (v) => v + size * (Math.random() + Math.random() - 1);
  const changed = {
    noise: () => pairs.map((pair) => pair.map(noisy)),
    drop: () => pairs.filter(() => Math.random() >= 0.1),
    shuffle: () => shuffled(pairs),
    clear: () => [],
  };
  get("points-fixture").selectedIndex = 0;
  setPoints(changed[kind]().flat());
}

function shuffled(pairs) {
  for (let i = pairs.length - 1; i > 0; i--) {
    const j = Math.floor(Math.random() * (i + 1));
    [pairs[i], pairs[j]] = [pairs[j], pairs[i]];
  }
  return pairs;
}
