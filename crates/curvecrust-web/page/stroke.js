// A smooth curve through points that were clicked: Catmull and Rom's, as cubics of an SVG path.

/** The path of all strokes with points enough, or an empty text. */
export function pathOf(strokes, closed) {
  const paths = strokes.map((stroke) => pathOfOne(stroke, closed));
  return paths.filter(Boolean).join(" ");
}

function pathOfOne(stroke, closed) {
  const count = stroke.length;
  if (count < 3) return "";
  const at = (i) => (closed ? stroke[(i + count) % count] : stroke[Math.max(0, Math.min(count - 1, i))]);
  const parts = [`M ${at(0).join(" ")}`];
  for (let i = 0; i < (closed ? count : count - 1); i++) {
    const [before, from, to, after] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    const first = from.map((v, k) => v + (to[k] - before[k]) / 6);
    const second = to.map((v, k) => v - (after[k] - from[k]) / 6);
    parts.push(`C ${[...first, ...second, ...to].join(" ")}`);
  }
  return parts.join(" ") + (closed ? " Z" : "");
}
