// The view that joins points: two algorithms beside each other.

import { ALGORITHMS } from "./algorithms.js";
import { Lane } from "./engine.js";
import { Plot, boxOf, fillPoints, ring, stepped, strokeEdges, toSegment } from "./plot.js";
import { whyEdge, whyEnd } from "./reasons.js";
import { save } from "./save.js";

const get = (id) => document.getElementById(id);
const sides = ["a", "b"].map((side) => ({ side, lane: new Lane(), answer: null, plot: null }));
/** With more points than this, edges come without reasons, which take longer. */
const EXPLAINED = 20_000;
const UNDONE = 50;
/** How many pixels beside the point that is held a key adds one. */
const BESIDE = 24;

let points = [];
let up = true;
let past = [];
/** The point that is selected, -1 for none; whether a pointer drags it, or arrows move it. */
let selected = -1;
let held = false;
/** Whether what moves is remembered already. */
let moved = false;
let marked = null;
let attempt = null;

export function state() {
  const settings = { a: get("algorithm-a").value, b: get("algorithm-b").value };
  return { points, up, shape: get("shape").value, curves: get("curves").value, ...settings };
}

/** Takes other points, and fits the pictures to them. */
export function setPoints(others, turned = up) {
  remember();
  select(-1);
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

function remember() {
  past.push({ points, up });
  past = past.slice(-UNDONE);
}

function fit() {
  for (const { plot } of sides) {
    plot.box = boxOf(points);
    plot.up = up;
    plot.cursor = null;
  }
}

/** Asks for both sides anew. */
async function update() {
  marked = null;
  const asked = points;
  const sent = Float64Array.from(points);
  await Promise.all(sides.map((side) => attempt(() => ask(side, asked, sent))));
}

/** `sent` holds the points that are asked about; others may be shown when the answer comes. */
async function ask(side, asked, sent) {
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
    side.points = asked;
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
    down: (x, y, within) => press(side.plot, x, y, within),
    move: (x, y, pressed) => (pressed && held ? drag(side.plot, x, y) : hover(side, x, y)),
    holds: () => (held ? points.slice(2 * selected, 2 * selected + 2) : null),
    leave: () => select(selected),
    key: (key) => pressKey(side, key.toLowerCase()),
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
  if (marked?.side === side && marked.edge >= 0 && edges.length) {
    g.lineWidth = 6;
    g.strokeStyle = colour("accent");
    strokeEdges(g, plot, points, edges.subarray(2 * marked.edge, 2 * marked.edge + 2));
  }
  g.fillStyle = colour("point");
  fillPoints(g, plot, points, many ? 1.2 : 3.4);
  if (edges.length) rings(g, plot, colour, side.answer.leaves);
  if (selected >= 0) ring(g, plot, colour, points[2 * selected], points[2 * selected + 1]);
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

function press(plot, x, y, within) {
  const tool = document.querySelector("[name=tool]:checked").value;
  const nearest = plot.nearest(points, x, y, within);
  // Keys leave the cross free for the next point.
  if (tool === "add") add(plot.at(x, y), plot.cursor === null);
  else if (tool === "erase" && nearest >= 0) erase(nearest);
  else select(nearest, nearest >= 0);
}

/** Selects a point, and says which; -1 for none. */
function select(point, hold = false) {
  selected = point;
  held = hold;
  moved = false;
  tell(wordsOf(point));
  for (const { plot } of sides) plot?.redraw();
}

const rounded = (v) => Number(v.toPrecision(4));

function wordsOf(point) {
  if (point < 0) return "";
  const [x, y] = points.slice(2 * point, 2 * point + 2).map(rounded);
  return `Point ${point} at ${x}, ${y}, one of ${points.length / 2}.`;
}

function add(place, hold) {
  remember();
  points = [...points, ...place];
  select(points.length / 2 - 1, hold);
  moved = true;
  changed();
}

function erase(point) {
  remember();
  points = points.toSpliced(2 * point, 2);
  for (const side of sides) side.answer = null;
  select(-1);
  tell(`Point ${point} removed, ${points.length / 2} are left.`);
  changed();
}

function drag(plot, x, y) {
  if (!moved) remember();
  moved = true;
  points = points.toSpliced(2 * selected, 2, ...plot.at(x, y));
  tell(wordsOf(selected));
  changed();
}

function changed() {
  get("points-fixture").selectedIndex = 0;
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
    const [distance] = toSegment(x, y, pixel(side.plot, edges[i]), pixel(side.plot, edges[i + 1]));
    if (distance < best) [best, found] = [distance, i / 2];
  }
  mark(side, found, -1);
}

const pixel = (plot, v) => [plot.x(points[2 * v]), plot.y(points[2 * v + 1])];

function pressKey(side, key) {
  const act = {
    n: () => stepEdge(side, 1),
    p: () => stepEdge(side, -1),
    ".": () => stepPoint(1),
    ",": () => stepPoint(-1),
    a: () => addByKey(side.plot),
    delete: () => removeByKey(side.plot),
    backspace: () => removeByKey(side.plot),
    escape: () => select(-1),
  }[key];
  act?.();
  return act !== undefined;
}

function stepEdge(side, by) {
  const count = (side.answer?.edges.length ?? 0) / 2;
  if (count === 0) return;
  mark(side, stepped(marked?.side === side ? marked.edge : -1, by, count), -1);
}

function stepPoint(by) {
  const count = points.length / 2;
  if (count === 0) return;
  select(stepped(selected, by, count), true);
}

/** Adds a point at the cross; beside the point that is held, if one is. */
function addByKey(plot) {
  const [x, y] = plot.cross();
  plot.cursor = [x, y];
  add(plot.at(held ? x + BESIDE : x, y), held);
}

/** Removes the point that is selected, or the one at the cross; then the next one is selected. */
function removeByKey(plot) {
  const point = selected >= 0 ? selected : plot.nearest(points, ...plot.cross());
  if (point < 0) return;
  const [follows, hold] = [selected >= 0, held];
  erase(point);
  if (!follows || points.length === 0) return;
  const words = get("reason").textContent;
  select(Math.min(point, points.length / 2 - 1), hold);
  tell(`${words} ${get("reason").textContent}`);
}

const tell = (words) => (get("reason").textContent = words);

function mark(side, edge, end) {
  if (marked?.side === side && marked.edge === edge && marked.end === end) return;
  marked = { side, edge, end };
  const name = get(`algorithm-${side.side}`).value;
  if (edge >= 0) tell(whyEdge(side.answer, edge, name));
  else tell(end >= 0 ? whyEnd(side.answer, end) : "");
  for (const { plot } of sides) plot.redraw();
}

function change(kind) {
  if (kind === "undo") {
    const before = past.pop();
    if (before) ({ points, up } = before);
    select(-1);
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
