// The view that samples a curve under a condition.

import { Lane } from "./engine.js";
import { Drawing } from "./drawing.js";
import { Plot, fillPoints, strokeEdges, strokeSegments } from "./plot.js";
import { areStrokes, pathOf } from "./stroke.js";

const get = (id) => document.getElementById(id);
const lane = new Lane();
const counter = new Lane();

let plot = null;
let curve = null;
let samples = null;
let source = null;
let drawing = null;
/** Counts the curves that were left, so that a late answer does not bring one back. */
let left = 0;
let attempt = null;

export function state() {
  const checked = document.querySelector("[name=condition]:checked").value;
  const values = Object.fromEntries(["rho", "epsilon", "limit"].map((id) => [id, get(id).value]));
  return { source, strokes: drawing.strokes, closed: isClosed(), condition: checked, ...values };
}

const isClosed = () => get("draw-closed").checked;

export function enter() {
  plot?.redraw();
}

export async function start({ curves, attempt: doing, state: linked, toReconstruct }) {
  attempt = doing;
  plot = new Plot(get("canvas-sample"));
  plot.canvas.setAttribute("aria-label", "The curve, its samples and its medial axis");
  drawing = new Drawing(plot, { isClosed, changed: () => attempt(redraw), tell });
  plot.show(paint);
  fillSelect(curves);
  for (const id of ["rho", "epsilon", "limit"]) get(id).addEventListener("input", () => slide(id));
  for (const input of document.querySelectorAll("[name=condition]")) {
    input.addEventListener("input", update);
  }
  for (const id of ["show-axis", "show-lfs", "show-polygon"]) {
    get(id).addEventListener("input", () => plot.redraw());
  }
  listenToDrawing(curves);
  get("to-reconstruct").addEventListener("click", () => {
    if (samples) toReconstruct(Array.from(samples.samples));
  });
  await restore(curves, linked);
}

function fillSelect(curves) {
  const select = get("curve-fixture");
  select.add(new Option("my own", ""));
  for (const { name } of curves) select.add(new Option(name, name));
  select.addEventListener("input", () => {
    const chosen = curves.find(({ name }) => name === select.value);
    if (chosen) attempt(() => open(chosen.name, chosen.svg));
  });
}

async function restore(curves, linked) {
  for (const id of ["rho", "epsilon", "limit"]) {
    if (typeof linked?.[id] === "string") get(id).value = linked[id];
  }
  const checked = linked?.condition === "epsilon" ? "epsilon" : "rho";
  document.querySelector(`[name=condition][value=${checked}]`).checked = true;
  const first = curves.find(({ name }) => name === "bunny") ?? curves[0];
  if (areStrokes(linked?.strokes)) {
    get("draw-closed").checked = linked.closed !== false;
    draw(linked.strokes);
    await attempt(redraw);
  } else if (typeof linked?.source?.svg === "string") {
    await attempt(() => open(linked.source.name ?? "", linked.source.svg));
  } else {
    await attempt(() => open(first.name, first.svg));
  }
}

/** Takes a drawing; one that is none leaves the one before it. */
export async function open(name, svg) {
  await take({ curve: { svg } }, () => {
    source = { name, svg };
    showDrawing(null);
    get("curve-fixture").value = name;
    if (get("curve-fixture").selectedIndex < 0) get("curve-fixture").value = "";
  });
}

/** Loads a curve; what is to be done with it comes before its samples are counted. */
async function take(header, loadedIt = () => {}) {
  const before = left;
  const loaded = await lane.curve(header);
  if (!loaded || left !== before) return;
  curve = loaded;
  samples = null;
  if (header.curve.svg) plot.box = loaded.box;
  loadedIt();
  await update();
  const counting = await counter.curve(header);
  const counts = counting && (await counter.ask("counts"));
  if (counts && left === before) showCounts(counts.counts);
}

function showCounts(counts) {
  const cells = counts.map(({ bound, samples: count }) => {
    const cell = document.createElement("div");
    const [name, value] = [document.createElement("dt"), document.createElement("dd")];
    name.textContent = bound;
    value.textContent = count ?? "–";
    cell.append(name, value);
    return cell;
  });
  get("counts").replaceChildren(...cells);
}

function slide(id) {
  if (id !== "limit") document.querySelector(`[name=condition][value=${id}]`).checked = true;
  update();
}

/** The limit as a share of the extent: 0.01 % to 10 %, in equal steps of its logarithm. */
function limitOf(position) {
  return position > 0 ? 0.1 * 10 ** (-3 * (1 - (60 - position) / 59)) : null;
}

async function update() {
  const condition = document.querySelector("[name=condition]:checked").value;
  const bound = Number(get(condition).value);
  const limit = limitOf(Number(get("limit").value));
  for (const id of ["rho", "epsilon"]) {
    get(`${id}-value`).textContent = Number(get(id).value).toFixed(3);
  }
  get("limit-value").textContent = limit ? `${(100 * limit).toPrecision(2)} %` : "none";
  get("guarantee").textContent = guarantee(condition, bound);
  get("guarantee").classList.toggle("warn", bound > (condition === "rho" ? 0.888 : 0.47));
  if (!curve) return;
  await attempt(async () => {
    const before = left;
    const answer = await lane.ask({ sample: { condition, bound, limit } });
    if (!answer || left !== before) return;
    samples = answer;
    get("sample-caption").textContent = caption(answer);
    plot.redraw();
  });
}

const counted = (count, one) => `${count} ${count === 1 ? one : `${one}s`}`;

function caption(answer) {
  const share = (100 * answer.hausdorff) / curve.extent;
  return [
    `${answer.samples.length / 2} samples`,
    `their polygon is within ${share.toFixed(2)} % of the curve`,
    `${answer.decoder} ${answer.exact ? "returns it exactly" : "does not return it"}`,
    curve.corners ? `${counted(curve.corners, "corner")}, which no theorem covers` : "",
    curve.cuts ? `cut in ${counted(curve.cuts, "place")} where strokes touch` : "",
    `${answer.milliseconds.toFixed(1)} ms`,
  ].filter(Boolean).join(", ");
}

/** What is known of a bound; docs/theory.md has the proofs and the counterexample. */
function guarantee(condition, bound) {
  if (condition === "rho") {
    if (bound <= 0.888) return "Proven: HNN-Crust returns the polygon of every such sampling.";
    if (bound < 0.895) return "The paper claims that HNN-Crust is right here. It is proven up to 0.888; no counterexample is known below 0.895.";
    if (bound <= 0.9) return "The paper claims rho < 0.9, but from 0.895 on there are curves where HNN-Crust loses an edge. Nothing is guaranteed here.";
    return "Beyond every claim: nothing is guaranteed here.";
  }
  if (bound <= 1 / 3) return "Proven: NN-Crust and HNN-Crust return the polygon of every such sampling.";
  if (bound <= 0.47) return "Proven for HNN-Crust. NN-Crust is guaranteed up to 1/3 only.";
  return "Beyond every claim: nothing is guaranteed here.";
}

function listenToDrawing(curves) {
  get("draw").addEventListener("click", () => {
    if (drawing.strokes === null) {
      draw([[]]);
    } else {
      showDrawing(null);
      attempt(() => open(curves[0].name, curves[0].svg));
    }
  });
  get("draw-new").addEventListener("click", () => {
    if (drawing.strokes) drawing.addStroke();
    else draw([[]]);
  });
  get("draw-closed").addEventListener("input", () => drawing.strokes && drawing.reshape());
  get("node-corner").addEventListener("input", (event) => drawing.makeCorner(event.target.checked));
  get("node-add").addEventListener("click", () => drawing.addAfter());
  get("node-remove").addEventListener("click", () => drawing.remove());
}

/** Begins to draw, with strokes that are there. */
function draw(own) {
  source = null;
  get("curve-fixture").value = "";
  leave();
  showDrawing(own);
}

/** Shows the strokes of the reader's own drawing; null if another one is shown. */
function showDrawing(strokes) {
  get("draw").setAttribute("aria-pressed", String(strokes !== null));
  for (const id of ["node", "draw-hint"]) get(id).hidden = strokes === null;
  plot.canvas.setAttribute("aria-describedby", strokes ? "draw-hint" : "sample-caption");
  drawing.begin(strokes);
}

/** Leaves the curve, and waits for points enough of another. */
function leave() {
  left += 1;
  clear("Click to add points, drag to move them.");
}

function clear(words) {
  curve = samples = null;
  get("counts").replaceChildren();
  get("sample-caption").textContent = words;
  plot.redraw();
}

/** Says what is selected, and offers what can be done with it. */
function tell(words) {
  get("node-words").textContent = words || "No point is selected.";
  get("node-corner").checked = drawing.isCorner();
  for (const id of ["node-corner", "node-remove"]) get(id).disabled = drawing.selected === null;
  get("node-add").disabled = !drawing.hasNext();
}

async function redraw() {
  plot.redraw();
  const path = pathOf(drawing.strokes, isClosed());
  if (!path) {
    leave();
    return;
  }
  try {
    await take({ curve: { path } });
  } catch (error) {
    // The curve before it would hide what is drawn.
    clear("No samples of this drawing.");
    throw error;
  }
}

function paint(g, place, colour) {
  if (drawing.strokes) drawing.paintStrokes(g, place, colour);
  if (curve) paintCurve(g, place, colour);
  if (samples) paintSamples(g, place, colour);
  if (drawing.strokes) drawing.paint(g, place, colour);
}

function paintSamples(g, place, colour) {
  g.lineWidth = 2;
  g.strokeStyle = colour("differs");
  if (get("show-polygon").checked) strokeEdges(g, place, samples.samples, polygon(samples));
  g.fillStyle = colour("point");
  fillPoints(g, place, samples.samples, 4);
}

function paintCurve(g, place, colour) {
  g.strokeStyle = colour("axis");
  g.lineWidth = 1;
  if (get("show-axis").checked) strokeSegments(g, place, curve.axis);
  // Few places have a very large lfs: the colours end before.
  const finite = curve.lfs.filter(Number.isFinite).sort();
  const largest = finite[Math.floor(0.9 * (finite.length - 1))] || 1;
  g.lineWidth = 3.5;
  for (const band of bands(curve, largest)) {
    const hue = 20 + 220 * band.share;
    g.strokeStyle = get("show-lfs").checked ? `hsl(${hue} 70% 55%)` : colour("curve");
    strokeEdges(g, place, curve.dense, band.edges);
  }
}

const BANDS = 16;

/** The chords of the curve by their lfs, so that each colour is stroked once. */
function bands({ dense, lfs, components }, largest) {
  const found = Array.from({ length: BANDS }, (_, i) => ({ share: i / (BANDS - 1), edges: [] }));
  const count = dense.length / 2;
  for (let c = 0; c < components.length; c += 3) {
    const [start, end, closed] = components.subarray(c, c + 3);
    for (let i = start; i < Math.min(end, count); i++) {
      const next = i + 1 < end ? i + 1 : closed ? start : i;
      const share = Math.sqrt(Math.min(1, lfs[i] / largest));
      found[Math.round(share * (BANDS - 1))].edges.push(i, next);
    }
  }
  return found;
}

/** The edges between consecutive samples. */
export function polygon({ components }) {
  const edges = [];
  for (let c = 0; c < components.length; c += 3) {
    const [start, end, closed] = components.subarray(c, c + 3);
    for (let i = start; i + 1 < end; i++) edges.push(i, i + 1);
    if (closed && end - start > 2) edges.push(end - 1, start);
  }
  return edges;
}
