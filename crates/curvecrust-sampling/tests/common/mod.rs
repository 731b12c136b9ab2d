//! Curves to test with.
#![allow(
    unreachable_pub,
    clippy::unwrap_used,
    reason = "helpers of several tests"
)]

use curvecrust_curve::Curve;
use curvecrust_medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};

/// An open arch from (0, 0) to (6, 0).
pub fn arch() -> MeasuredCurve {
    let curve = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0").unwrap();
    let options = MeasureOptions {
        discretisation: Discretisation::Adaptive { gap_to_lfs: 0.01 },
        ..MeasureOptions::default()
    };
    measure_with(&curve, &options).unwrap()
}
