//! Where the prover tries the centres of balls. Nothing here has to be right.

use crate::arcs;
use crate::certificate::Reason;
use crate::configuration::Configuration;
use crate::interval::Interval;
use crate::vector::Vector;
use std::f64::consts::{FRAC_PI_2, PI};

/// How far centres are inside of the discs that are free of the medial axis.
const INSIDE: f64 = 1e-6;

/// How often the range of the best centre on a circle is made smaller.
const STEPS: u32 = 24;

/// Points at the rim of the two discs that are free of the medial axis.
pub(crate) fn rim(configuration: &Configuration, reach: Interval) -> Vec<[f64; 2]> {
    let q = [configuration.q.x.middle(), configuration.q.y.middle()];
    let lfs = configuration.lfs(reach).low();
    let about_s1 = (0..24).map(|i| FRAC_PI_2 + 1.6 * (f64::from(i) + 0.5) / 24.0);
    let about_s1 = about_s1.map(|angle| [0.9999 * angle.cos(), 0.9999 * angle.sin()]);
    let about_q = (0..16).map(|i| PI * (f64::from(i) + 0.5) / 16.0);
    let radius = (lfs - 0.5 * configuration.distance.width()).max(0.1);
    let about_q = about_q.map(move |a| [q[0] + radius * a.cos(), q[1] + radius * a.sin()]);
    about_s1
        .chain(about_q)
        .map(|center| center.map(rounded))
        .collect()
}

/// The two points at this rim about which the largest ball free of an arc reaches farthest beyond
/// z, for the numbers in the middle of a box.
pub(crate) fn best(case: &Configuration) -> Vec<[f64; 2]> {
    let middle = |vector: Vector| [vector.x.middle(), vector.y.middle()];
    let [q, z] = [case.q, case.z].map(middle);
    let wide = 0.5 * case.q.x.width().hypot(case.q.y.width());
    let about_q = case.lfs(arcs::reach(case)).low() - wide - INSIDE;
    let curvature = Interval::point(case.curvature.low());
    let beyond = |center: [f64; 2]| {
        let height = arcs::height(curvature, Vector::point(center));
        height.low() - (center[0] - z[0]).hypot(center[1] - z[1])
    };
    [([0.0, 0.0], 1.0 - INSIDE), (q, about_q)]
        .map(|([x, y], radius)| {
            let at = |angle: f64| [x + radius * angle.cos(), y + radius * angle.sin()];
            at(highest(|angle| beyond(at(angle)), [0.5 * PI, 1.25 * PI])).map(finely)
        })
        .into()
}

/// Where a function with one maximum in a range is largest.
fn highest(function: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..STEPS {
        let third = (high - low) / 3.0;
        if function(low + third) < function(high - third) {
            low += third;
        } else {
            high -= third;
        }
    }
    0.5 * (low + high)
}

/// The smallest ball about a centre that holds z.
pub(crate) fn ball(configuration: &Configuration, center: [f64; 2]) -> Reason {
    let from_center = configuration.z - Vector::point(center);
    let radius = rounded(from_center.square().sqrt().high() + 1e-5);
    Reason::Ball { center, radius }
}

/// With few digits, which keeps the certificate short.
pub(crate) fn rounded(number: f64) -> f64 {
    (number * 1e5).round() / 1e5
}

/// With some more digits.
fn finely(number: f64) -> f64 {
    (number * 1e7).round() / 1e7
}
