//! Smooth plane curves as chains of cubic Béziers, from SVG or analytic, and their discretisation
