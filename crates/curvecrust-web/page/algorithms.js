// The names of the algorithms.

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
