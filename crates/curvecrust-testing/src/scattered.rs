//! Points that follow no curve or too many: the search of least detour has work at all of them.

use curvecrust_geometry::{DVec2, Random};
use std::f64::consts::TAU;

use crate::hard_points::HardPoints;

/// Scattered points, of any number.
pub const SCATTERED: &[HardPoints] = &[
    HardPoints {
        name: "uniform points",
        points: uniform,
    },
    HardPoints {
        name: "lattice with holes",
        points: lattice_with_holes,
    },
    HardPoints {
        name: "band of noise",
        points: band_of_noise,
    },
    HardPoints {
        name: "pixel borders",
        points: pixel_borders,
    },
];

/// Independent points of a square.
fn uniform(n: usize) -> Vec<DVec2> {
    let mut random = Random::new(1);
    let mut unit = || random.unit();
    (0..n).map(|_| DVec2::new(unit(), unit())).collect()
}

/// A square of whole coordinates, of which every fifth point is not there.
fn lattice_with_holes(n: usize) -> Vec<DVec2> {
    let mut random = Random::new(2);
    let side = (n + n / 4).isqrt();
    let at = |i: usize| DVec2::new((i / side) as f64, (i % side) as f64);
    let kept = (0..side * side).filter(|_| random.unit() > 0.2);
    kept.map(at).collect()
}

/// Points that scatter about a segment by a hundredth of its length.
fn band_of_noise(n: usize) -> Vec<DVec2> {
    let mut random = Random::new(3);
    let mut at = || {
        // Box and Muller.
        let distance = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        DVec2::new(random.unit(), 0.01 * distance * (TAU * random.unit()).cos())
    };
    (0..n).map(|_| at()).collect()
}

/// The border pixels of discs with radii of 10 to 50 pixels.
fn pixel_borders(n: usize) -> Vec<DVec2> {
    let mut random = Random::new(4);
    let mut points = Vec::new();
    let places = (0..).map(|i| DVec2::new(f64::from(i % 64), f64::from(i / 64)) * 120.0);
    for corner in places {
        if points.len() >= n {
            break;
        }
        let centre = DVec2::new(random.unit(), random.unit());
        let radius = random.between(10.0, 50.0);
        let is_inside = |p: DVec2| p.distance(centre) < radius;
        let pixels = (-51..=51).flat_map(|x| (-51..=51).map(move |y| (x, y)));
        let pixels = pixels.map(|(x, y)| DVec2::new(x.into(), y.into()));
        let steps = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
        let border = pixels.filter(|&p| is_inside(p) && !steps.iter().all(|&s| is_inside(p + s)));
        points.extend(border.map(|p| corner + p));
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strategies::point_set;

    #[test]
    fn as_many_points_as_asked_for_and_hardly_one_twice() {
        for scattered in SCATTERED {
            for n in [1_000, 5_000] {
                let points = (scattered.points)(n);
                let share = point_set(points).len() as f64 / n as f64;
                assert!((0.9..1.4).contains(&share), "{}: {share}", scattered.name);
            }
        }
    }
}
