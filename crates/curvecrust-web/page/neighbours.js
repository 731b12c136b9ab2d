// The paper's two neighbours, for the figure that explains them.

const squared = (points, i, j) =>
  (points[2 * i] - points[2 * j]) ** 2 + (points[2 * i + 1] - points[2 * j + 1]) ** 2;

/** The index of the point nearest to point s. */
export function nearest(points, s) {
  return closest(points, s, () => true);
}

/** The closest point to s of those that are nearer to s than to n; -1 if there is none. */
export function half(points, s, n) {
  return closest(points, s, (q) => q !== n && squared(points, q, s) < squared(points, q, n));
}

function closest(points, s, allowed) {
  let found = -1;
  for (let q = 0; 2 * q < points.length; q++) {
    if (q === s || !allowed(q)) continue;
    if (found < 0 || squared(points, q, s) < squared(points, found, s)) found = q;
  }
  return found;
}
