// Strokes that are drawn: nodes that a smooth curve goes through, as cubics of an SVG path.
//
// A node is [x, y]: its tangent is then Catmull and Rom's, and follows its neighbours. Or it is
// [x, y, bx, by, ax, ay, corner] with handles of its own: the vectors from it to the control point
// before and to the one after. They are opposite unless `corner` is 1.

import { toSegment } from "./plot.js";

/** The two handles of a node, by the numbers that stand for them in a selection. */
export const [BEFORE, AFTER] = [0, 1];

/** Whether strokes from a link can be drawn; it may come from anywhere. */
export function areStrokes(list) {
  const isNode = (node) =>
    Array.isArray(node) && [2, 7].includes(node.length) && node.every((v) => Number.isFinite(v));
  return Array.isArray(list) && list.every((stroke) => Array.isArray(stroke) && stroke.every(isNode));
}

/** The path of all strokes with nodes enough, or an empty text. */
export function pathOf(strokes, closed) {
  const paths = strokes.map((stroke) => pathOfOne(stroke, closed));
  return paths.filter(Boolean).join(" ");
}

function pathOfOne(stroke, closed) {
  const cubics = cubicsOf(stroke, closed);
  if (cubics.length === 0) return "";
  const parts = cubics.map(([, ...controls]) => `C ${controls.flat().join(" ")}`);
  return `M ${cubics[0][0].join(" ")} ${parts.join(" ")}${closed ? " Z" : ""}`;
}

/** The segments of a stroke, each as four places; none of fewer than three nodes without handles. */
export function cubicsOf(stroke, closed) {
  const count = stroke.length;
  const enough = count > 2 || (count === 2 && stroke.some(isBent));
  return Array.from({ length: enough ? segments(stroke, closed) : 0 }, (_, i) => cubic(stroke, i, closed));
}

const segments = (stroke, closed) => (closed ? stroke.length : stroke.length - 1);

function cubic(stroke, i, closed) {
  const next = (i + 1) % stroke.length;
  const ends = [i, next].map((k) => stroke[k].slice(0, 2));
  return [ends[0], control(stroke, i, closed, AFTER), control(stroke, next, closed, BEFORE), ends[1]];
}

const isBent = (node) => node.length > 2;

/** The nodes before and after a node; at an open end, that node itself. */
function neighbours(stroke, i, closed) {
  const count = stroke.length;
  return [i - 1, i + 1].map((k) =>
    closed ? stroke[(k + count) % count] : stroke[Math.max(0, Math.min(count - 1, k))],
  );
}

function handles(stroke, i, closed) {
  const node = stroke[i];
  if (isBent(node)) return [node.slice(2, 4), node.slice(4, 6)];
  const [before, after] = neighbours(stroke, i, closed);
  const vector = [0, 1].map((k) => (after[k] - before[k]) / 6);
  return [vector.map((v) => -v), vector];
}

/** The control point at the end of a handle. */
export function control(stroke, i, closed, side) {
  return handles(stroke, i, closed)[side].map((v, k) => stroke[i][k] + v);
}

/** The handles that a node has: at an open end there is one. */
export function sides(stroke, i, closed) {
  if (stroke.length < 2) return [];
  return [BEFORE, AFTER].filter((side) => closed || (side === BEFORE ? i > 0 : i + 1 < stroke.length));
}

/** Gives a node the handles that it shows, as its own. */
function fix(stroke, i, closed) {
  const node = stroke[i];
  if (!isBent(node)) node.push(...handles(stroke, i, closed).flat(), 0);
}

/** Drags a handle to a place. At a smooth node the other one turns with it, and keeps its length. */
export function bend(stroke, i, closed, side, place) {
  fix(stroke, i, closed);
  const node = stroke[i];
  const vector = place.map((v, k) => v - node[k]);
  node.splice(2 + 2 * side, 2, ...vector);
  const length = Math.hypot(...vector);
  if (node[6] || length === 0) return;
  const other = 2 + 2 * (1 - side);
  const kept = Math.hypot(node[other], node[other + 1]) / length;
  node.splice(other, 2, ...vector.map((v) => -kept * v));
}

export const isCorner = (node) => node[6] === 1;

/** Makes a node a corner, whose handles point at its neighbours, or smooth. */
export function makeCorner(stroke, i, closed, corner) {
  const node = stroke[i];
  node.length = 2;
  if (!corner) return;
  const towards = neighbours(stroke, i, closed).map((end) => [0, 1].map((k) => (end[k] - node[k]) / 3));
  node.push(...towards.flat(), 1);
}

/** Adds a node on a segment, by de Casteljau's subdivision: the curve stays. Returns its index. */
export function split(stroke, segment, closed, t) {
  const next = (segment + 1) % stroke.length;
  const between = (a, b) => a.map((v, k) => v + t * (b[k] - v));
  const [a, b, c, d] = cubic(stroke, segment, closed);
  const [ab, bc, cd] = [between(a, b), between(b, c), between(c, d)];
  const [abc, bcd] = [between(ab, bc), between(bc, cd)];
  const place = between(abc, bcd);
  // Both ends first: the tangent of one may follow the other.
  for (const i of [segment, next]) fix(stroke, i, closed);
  setHandle(stroke[segment], AFTER, ab);
  setHandle(stroke[next], BEFORE, cd);
  const node = [...place, 0, 0, 0, 0, 0];
  setHandle(node, BEFORE, abc);
  setHandle(node, AFTER, bcd);
  stroke.splice(segment + 1, 0, node);
  return segment + 1;
}

function setHandle(node, side, place) {
  node.splice(2 + 2 * side, 2, place[0] - node[0], place[1] - node[1]);
}

const STEPS = 32;

/** Where strokes come nearest to a pixel: stroke, segment and t; null if that is not within reach. */
export function closest(strokes, closed, plot, px, py, within) {
  let [best, found] = [within, null];
  strokes.forEach((stroke, index) =>
    cubicsOf(stroke, closed).forEach((controls, segment) => {
      let from = pixel(plot, controls, 0);
      for (let i = 0; i < STEPS; i++) {
        const to = pixel(plot, controls, (i + 1) / STEPS);
        const [distance, share] = toSegment(px, py, from, to);
        if (distance < best) [best, found] = [distance, { index, segment, t: (i + share) / STEPS }];
        from = to;
      }
    }),
  );
  return found;
}

function pixel(plot, [a, b, c, d], t) {
  const s = 1 - t;
  const [x, y] = [0, 1].map(
    (k) => s * s * s * a[k] + 3 * s * s * t * b[k] + 3 * s * t * t * c[k] + t * t * t * d[k],
  );
  return [plot.x(x), plot.y(y)];
}
