//! Random smooth closed curves.

use std::f64::consts::TAU;

use curvecrust_curve::{BezierPath, CubicBezier, Curve};
use curvecrust_geometry::{DVec2, Random};

/// One to four smooth closed components: Fourier series and chains of Béziers, beside each other
/// and one inside another. They may cross.
#[must_use]
pub fn random_closed(random: &mut Random) -> Curve {
    let count = 1 + random.below(4);
    let components = (0..count).map(|i| {
        let (centre, size) = if i == 3 {
            (DVec2::ZERO, 0.3)
        } else {
            let at = DVec2::new(2.6 * i as f64, random.fine_between(-0.5, 0.5));
            (at, random.fine_between(0.5, 1.0))
        };
        let segments = if random.below(2) == 0 {
            fourier(random)
        } else {
            chain(random)
        };
        let placed = segments
            .into_iter()
            .map(|s| CubicBezier::new(s.control_points().map(|p| centre + size * p)));
        BezierPath::new(placed.collect(), true)
    });
    Curve::new(components.collect()).unwrap()
}

/// A circle with three harmonics of its radius and of its angle, by Hermite interpolation.
fn fourier(random: &mut Random) -> Vec<CubicBezier> {
    let waves: Vec<[f64; 3]> = (2..5)
        .map(|k| {
            let depth = random.fine_between(0.0, 0.35) / f64::from(k);
            [f64::from(k), depth, TAU * random.fine_between(0.0, 1.0)]
        })
        .collect();
    let radius = |a: f64| {
        1.0 + waves
            .iter()
            .map(|w| w[1] * (w[0] * a + w[2]).cos())
            .sum::<f64>()
    };
    let slope = |a: f64| {
        -waves
            .iter()
            .map(|w| w[0] * w[1] * (w[0] * a + w[2]).sin())
            .sum::<f64>()
    };
    let pieces = 24;
    let at = |i: u32| TAU * f64::from(i % pieces) / f64::from(pieces);
    let point = |i: u32| radius(at(i)) * DVec2::from_angle(at(i));
    let handle = |i: u32| {
        let direction = DVec2::from_angle(at(i));
        let derivative = slope(at(i)) * direction + radius(at(i)) * direction.perp();
        derivative * (TAU / f64::from(pieces) / 3.0)
    };
    let piece = |i: u32| {
        let (p, q) = (point(i), point(i + 1));
        CubicBezier::new([p, p + handle(i), q - handle(i + 1), q])
    };
    (0..pieces).map(piece).collect()
}

/// A smooth chain of Béziers through points at random distances from the origin.
fn chain(random: &mut Random) -> Vec<CubicBezier> {
    let n = 5 + random.below(6);
    let radii: Vec<f64> = (0..n).map(|_| random.fine_between(0.45, 1.2)).collect();
    let at = |i: usize| DVec2::from_angle(TAU * (i % n) as f64 / n as f64) * radii[i % n];
    let handle = |i: usize| (at(i + 1) - at(i + n - 1)) / 6.0;
    let piece = |i: usize| {
        CubicBezier::new([
            at(i),
            at(i) + handle(i),
            at(i + 1) - handle(i + 1),
            at(i + 1),
        ])
    };
    (0..n).map(piece).collect()
}
