// Why an edge or an open end is there, in words.

const REASONS = {
  certified: "certified: HNN-Crust finds it too, and nothing around it is open",
  completed: "completed: the shortest that was left, and no exchange removed it",
  exchanged: "exchanged: an exchange that lowered the cost added it",
  required: "required by what you know",
};

/** Why an edge of an answer is there; `name` is that of the algorithm. */
export function whyEdge({ edges, reasons, margins }, edge, name) {
  const start = `Edge ${edges[2 * edge]} – ${edges[2 * edge + 1]} by ${name}: `;
  if (!reasons) return `${start}its definition is its reason.`;
  const margin = Number.isFinite(margins[edge])
    ? ` Without it the cost would rise by at most ${margins[edge].toFixed(2)}.`
    : "";
  return `${start}${REASONS[reasons[edge]] ?? reasons[edge]}.${margin}`;
}

/** Why a point is an open end. */
export function whyEnd({ ends, rejected }, end) {
  const at = ends?.indexOf(end) ?? -1;
  if (at < 0) return `Point ${end} is an open end.`;
  const [partner, cost] = rejected.subarray(2 * at, 2 * at + 2);
  if (!Number.isFinite(partner)) return `Point ${end} is an open end: no other edge was possible.`;
  return `Point ${end} is an open end: an edge to ${partner} was rejected, the cost would rise by ${cost.toFixed(2)}.`;
}
