// The geometry of the paper's Figure 8: balls without a point of the curve in them, and whether
// they cover where a sample could be taken for the half neighbour of s1.
//
// s1 is the origin, and the curve's tangent there the x axis, y upwards. The unit is the lfs at s1.
// The curve has constant curvature on each side: x and s0 lie on the circle through s1 of radius
// `bend`, y and s2 on the one at the right. x and y are halfway, |s1 y| = rho and |x s1| =
// ratio * rho. alpha and beta are their angles below the tangent. The disk of radius 1 that touches
// the tangent in s1 is free of the curve, so that sin alpha <= |x s1| / 2, and likewise for beta.
//
// The medial axis stays out of the disk of lfs around s1 and of the one around x. A ball whose
// centre is in them and that reaches to the curve is free of the curve. The balls have to cover all
// that is nearer to s1 than s2, and nearer to s1 than to s0, left of s1 and above the curve.

/** The largest angle below the tangent at a distance from s1. */
export const steepest = (distance) => Math.asin(Math.min(1, distance / 2));

const polar = (radius, angle) => [radius * Math.cos(angle), radius * Math.sin(angle)];
const distance = ([ax, ay], [bx, by]) => Math.sqrt((ax - bx) ** 2 + (ay - by) ** 2);

/** The places of a configuration, and the disks that hold the centres of its balls. */
export function layout({ rho, ratio, alpha, beta }) {
  const near = ratio * rho;
  const x = polar(near, Math.PI + alpha);
  return {
    s0: polar(2 * near * Math.cos(alpha), Math.PI + 2 * alpha),
    x,
    y: polar(rho, -beta),
    s2: polar(2 * rho * Math.cos(beta), -2 * beta),
    /** |s1 s2|. */
    radius: 2 * rho * Math.cos(beta),
    /** The radii of the circles that the curve follows; infinite where it is straight. */
    bend: near / (2 * Math.sin(alpha)),
    bendRight: rho / (2 * Math.sin(beta)),
    free: [
      { centre: [0, 0], radius: 1 },
      { centre: x, radius: Math.max(ratio, 1 - near) },
    ],
  };
}

/** How far a place is above the curve left of s1. */
export function clearance({ bend }, [x, y]) {
  // The distance to the circle's centre less its radius, written so that a straight curve has one.
  const curvature = 1 / bend;
  const square = 2 * y + curvature * (x * x + y * y);
  return square / (1 + Math.sqrt(Math.max(0, 1 + curvature * square)));
}

/** The balls as their centre goes along the boundary of the free disks, `steps` for a turn. */
export function balls(figure, steps) {
  const [first, second] = figure.free;
  const around = (disk, other) =>
    Array.from({ length: steps }, (_, i) => {
      const [dx, dy] = polar(disk.radius, (2 * Math.PI * i) / steps);
      return [disk.centre[0] + dx, disk.centre[1] + dy];
    }).filter((c) => distance(c, other.centre) >= other.radius);
  return [...around(first, second), ...around(second, first)]
    .filter(([x]) => x <= 0)
    .map((centre) => ({ centre, radius: clearance(figure, centre) }))
    .filter(({ radius }) => radius > 0);
}

/** What has to be covered, along rays from s1: each with its direction and its two ends. */
export function rays(figure, count) {
  const { s0, radius, bend } = figure;
  const found = [];
  for (let i = 0; i <= count; i++) {
    const direction = polar(1, Math.PI / 2 + (Math.PI * i) / count);
    const along = direction[0] * s0[0] + direction[1] * s0[1];
    const bisector = along > 0 ? (s0[0] ** 2 + s0[1] ** 2) / (2 * along) : Infinity;
    const to = Math.min(radius, bisector);
    const from = direction[1] >= 0 ? 0 : -2 * bend * direction[1];
    if (from < to) found.push({ direction, from, to });
  }
  return found;
}

/** Where the bisector of s0 and s1 meets the circle through s2: above the curve, and below. */
export function bisectorEnds({ s0, radius }) {
  const length = Math.hypot(...s0);
  const [ux, uy] = [s0[0] / length, s0[1] / length];
  const across = Math.sqrt(radius * radius - (length * length) / 4);
  return [across, -across].map((far) => [(length / 2) * ux + far * uy, (length / 2) * uy - far * ux]);
}

/** How far the balls reach beyond a place, negative where it is in none. */
export function spare(rolling, place) {
  let best = -Infinity;
  for (const { centre, radius } of rolling) best = Math.max(best, radius - distance(centre, place));
  return best;
}

const STEPS = 1440;
const RAYS = 180;
const ALONG = 4;
/** Beside the curve some ball touches it at every place: only their number leaves gaps there. */
const BESIDE = 0.05;

/** The place that is covered least, and how far balls reach beyond it; the corner, if all is. */
export function weakest(figure) {
  const rolling = balls(figure, STEPS);
  const [corner] = bisectorEnds(figure);
  let found = { place: corner, spare: spare(rolling, corner) };
  for (const { direction, from, to } of rays(figure, RAYS)) {
    for (let i = 1; i <= ALONG; i++) {
      const length = from + ((to - from) * i) / ALONG;
      const place = direction.map((v) => length * v);
      if (clearance(figure, place) < BESIDE) continue;
      const reached = spare(rolling, place);
      if (reached < Math.min(found.spare, 0)) found = { place, spare: reached };
    }
  }
  return found;
}
