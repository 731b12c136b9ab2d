//! The geometry of Figure 8: why no sample comes between s1 and s2 on the side of s0.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016, Section 7: Lemmas 4 to 8, and the proof of Theorem 2. It leaves to show that no sample z
//! above I = [s0, s1] lies in O(s1, |s1 s2|) and in the half-plane H, so that s2 is the half
//! neighbour of s1. That holds where balls without a point of the curve in them cover O(s1,
//! |s1 s2|) ∩ H.
//!
//! **Place.** s1 is the origin, the curve's tangent there the x axis; y points up, s0 is on the
//! left. The unit is the lfs that is certain at s1 and y: lfs ≥ reach([s1, s2]) > |s1 y| / ρ, so at
//! worst |s1 y| = ρ. Here x and y are the points of the two intervals as far from s1 as from s0 and
//! s2, and |x s1| = ratio · ρ.
//!
//! **Angles.** x and y lie at the angles α and β below the x axis: there the curve bends away from
//! z, and H is widest. The disk of lfs(s1) that touches the x axis from below is free of the curve
//! (Lemma 5), so |x s1| ≥ 2 sin α, or α ≤ arcsin(|x s1| / 2), and likewise β (Lemma 8): at most
//! 26.7° at the distance ρ, *less* for a nearer x. Fractions in the caption of the figure are taken
//! of these maxima.
//!
//! **s0 and s2** continue the circle through s1 and x, or y, that is tangent to the x axis
//! (constant curvature, the extreme of Lemma 7): s0 is at the angle 2α below the axis and |s0 s1| =
//! 2 |x s1| cos α; |s1 s2| = 2 ρ cos β. H is bounded by the bisector of s0 and s1, which passes
//! through the circle's centre.
//!
//! **Balls.** A disk around a curve point p of radius lfs(p) is free of the medial axis, so a ball
//! with its centre c in it and a radius of the distance from c to the curve is free of the curve
//! (Lemma 6). Two such disks are certain: around s1 with radius 1, and around x with radius
//! max(ratio, 1 - |x s1|), by the reach of [s0, s1] and because lfs is 1-Lipschitz. The distance
//! from c to the curve is bounded by what the curve does not rise above: the disk that x lies on,
//! if α is largest, or else, as in the paper, the x axis. Centres stay left of s1; the curve on the
//! right of it is farther from them than s1.
//!
//! The region is taken a little larger than in the figure of the paper: all of O(s1, |s1 s2|) ∩ H
//! on the left of s1 that lies above the disk, or the axis, not only what is above the axis. The
//! tests find it covered in all eight configurations, barely in the fourth, as the paper says. If
//! instead α could be 26.7° whatever |x s1| is, the fourth and the fifth would not be covered; see
//! the tests. These are eight examples, not a proof: the paper's runs through all combinations of
//! small intervals. A ninth one, which it must have missed, is not covered.

use crate::figure::Ball;
use curvecrust::DVec2;
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// The bound of the sampling condition.
pub(super) const RHO: f64 = 0.9;

/// What the balls roll on, left of s1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Surface {
    /// The disk that touches the x axis in s1 from below, and has x on its boundary.
    Disk,
    /// The x axis.
    Axis,
}

/// One of the cases of Figure 8.
#[derive(Clone, Copy, Debug)]
pub(super) struct Configuration {
    /// |x s1| / |s1 y|.
    pub(super) ratio: f64,
    /// The angle of x below the axis, as a fraction of its maximum.
    x_angle: f64,
    /// The angle of y below the axis, as a fraction of its maximum.
    y_angle: f64,
    pub(super) surface: Surface,
}

/// The eight, in the order of the paper.
pub(super) const CONFIGURATIONS: [Configuration; 8] = [
    configuration(1.0, [1.0, 1.0], Surface::Disk),
    configuration(1.0 / 3.0, [1.0, 1.0], Surface::Disk),
    configuration(FRAC_1_SQRT_2, [1.0, 1.0], Surface::Disk),
    configuration(FRAC_1_SQRT_2, [1.0, 0.0], Surface::Disk),
    configuration(FRAC_1_SQRT_2, [0.5, 0.0], Surface::Axis),
    configuration(FRAC_1_SQRT_2, [0.0, 0.0], Surface::Axis),
    configuration(0.001, [0.0, 0.0], Surface::Axis),
    configuration(1.0, [0.0, 1.0], Surface::Axis),
];

/// A ninth, which is not covered: the counterexample to Theorem 2 of `docs/theorem-2.md` at its
/// threshold.
pub(super) const UNCOVERED: Configuration = configuration(0.732_346, [1.0, 0.0], Surface::Disk);

const fn configuration(
    ratio: f64,
    [x_angle, y_angle]: [f64; 2],
    surface: Surface,
) -> Configuration {
    Configuration {
        ratio,
        x_angle,
        y_angle,
        surface,
    }
}

impl Configuration {
    pub(super) fn geometry(&self) -> Geometry {
        let largest = |distance: f64| (distance / 2.0).asin();
        let alpha = self.x_angle * largest(self.ratio * RHO);
        let beta = self.y_angle * largest(RHO);
        Geometry::new(self.ratio, [alpha, beta], self.surface)
    }
}

/// A configuration laid out, y upwards.
#[derive(Clone, Debug)]
pub(super) struct Geometry {
    pub(super) s0: DVec2,
    pub(super) x: DVec2,
    pub(super) y: DVec2,
    pub(super) s2: DVec2,
    /// The angles of x and of y below the axis, in radians.
    pub(super) angles: [f64; 2],
    /// The radius of the disk that x lies on; infinite for the axis.
    pub(super) bend: f64,
    /// Disks that are free of the medial axis.
    free: [Ball; 2],
    surface: Surface,
}

impl Geometry {
    pub(super) fn new(ratio: f64, [alpha, beta]: [f64; 2], surface: Surface) -> Self {
        let near = ratio * RHO;
        let left = |angle: f64| DVec2::new(-angle.cos(), -angle.sin());
        let right = |angle: f64| DVec2::new(angle.cos(), -angle.sin());
        let x = near * left(alpha);
        let disk = |centre, radius| Ball { centre, radius };
        Self {
            s0: 2.0 * near * alpha.cos() * left(2.0 * alpha),
            x,
            y: RHO * right(beta),
            s2: 2.0 * RHO * beta.cos() * right(2.0 * beta),
            angles: [alpha, beta],
            bend: near / (2.0 * alpha.sin()),
            free: [disk(DVec2::ZERO, 1.0), disk(x, ratio.max(1.0 - near))],
            surface,
        }
    }

    /// |s1 s2|.
    pub(super) fn radius(&self) -> f64 {
        self.s2.length()
    }

    /// Where the bisector of s0 and s1 meets O(s1, |s1 s2|), above the curve.
    pub(super) fn corner(&self) -> DVec2 {
        let towards = self.s0.normalize();
        let along = self.s0.length() / 2.0;
        let across = (self.radius().powi(2) - along * along).sqrt();
        along * towards - across * towards.perp()
    }

    /// How far `p` is above what the curve does not rise above; negative below it.
    pub(super) fn clearance(&self, p: DVec2) -> f64 {
        match self.surface {
            Surface::Disk => p.distance(DVec2::new(0.0, -self.bend)) - self.bend,
            Surface::Axis => p.y,
        }
    }

    /// Tangent balls as their centre moves along the boundary of the free disks, `steps` a turn.
    pub(super) fn rolling(&self, steps: u32) -> Vec<Ball> {
        let [s1, x] = self.free;
        let around = |disk: Ball, other: Ball| {
            let turn = (0..steps).map(move |i| TAU * f64::from(i) / f64::from(steps));
            turn.map(move |angle| disk.centre + disk.radius * DVec2::from_angle(angle))
                .filter(move |c| c.distance(other.centre) >= other.radius)
        };
        around(s1, x)
            .chain(around(x, s1))
            .filter(|c| c.x <= 0.0)
            .map(|centre| Ball {
                centre,
                radius: self.clearance(centre),
            })
            .filter(|ball| ball.radius > 0.0)
            .collect()
    }

    /// The boundary of the region to be covered, along `rays` rays from s1.
    ///
    /// Seen from s1 it has no hidden part: both the disk and the axis pass through s1.
    pub(super) fn region(&self, rays: u32) -> Vec<DVec2> {
        let (mut outer, mut inner) = (Vec::new(), Vec::new());
        for i in 0..=rays {
            // From straight up to the left, and on to straight down.
            let d = DVec2::from_angle(TAU / 4.0 + TAU / 2.0 * f64::from(i) / f64::from(rays));
            let along_s0 = d.dot(self.s0) / self.s0.length_squared();
            let to_bisector = if along_s0 > 0.0 {
                0.5 / along_s0
            } else {
                f64::INFINITY
            };
            let to = self.radius().min(to_bisector);
            let from = match self.surface {
                _ if d.y >= 0.0 => 0.0,
                Surface::Disk => -2.0 * self.bend * d.y,
                Surface::Axis => f64::INFINITY,
            };
            if from < to {
                outer.push(to * d);
                inner.push(from * d);
            }
        }
        outer.extend(inner.into_iter().rev());
        outer
    }

    /// Whether `p` is in O(s1, |s1 s2|) ∩ H, left of s1 and above the disk or the axis.
    #[cfg(test)]
    fn in_region(&self, p: DVec2) -> bool {
        let in_h = p.dot(self.s0) <= self.s0.length_squared() / 2.0;
        in_h && p.x <= 0.0 && p.length() <= self.radius() && self.clearance(p) >= 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::figures::covering::BALLS;

    /// Every point of the region on a grid of 1/100, and its boundary.
    fn points(geometry: &Geometry) -> Vec<DVec2> {
        let grid = (-260..=0).flat_map(|i| (-200..=200).map(move |j| (i, j)));
        let grid = grid.map(|(i, j)| DVec2::new(f64::from(i), f64::from(j)) / 100.0);
        let inside = grid.filter(|&p| geometry.in_region(p));
        inside.chain(geometry.region(2000)).collect()
    }

    /// The largest clearance of a point of the region that is in none of the balls.
    fn highest_gap(geometry: &Geometry, steps: u32) -> f64 {
        let balls = geometry.rolling(steps);
        let covered = |p: DVec2| {
            balls
                .iter()
                .any(|ball| p.distance(ball.centre) <= ball.radius + 1e-12)
        };
        let gaps = points(geometry).into_iter().filter(|&p| !covered(p));
        gaps.map(|p| geometry.clearance(p)).fold(0.0, f64::max)
    }

    #[test]
    fn s0_and_s2_are_as_far_from_x_and_y_as_s1() {
        for configuration in CONFIGURATIONS {
            let geometry = configuration.geometry();
            let near = configuration.ratio * RHO;
            assert!((geometry.x.length() - near).abs() < 1e-12);
            assert!((geometry.x.distance(geometry.s0) - near).abs() < 1e-12);
            assert!((geometry.y.length() - RHO).abs() < 1e-12);
            assert!((geometry.y.distance(geometry.s2) - RHO).abs() < 1e-12);
            // The disk of lfs(s1) below the axis is free of the curve.
            for p in [geometry.s0, geometry.x, geometry.y, geometry.s2] {
                assert!(p.distance(DVec2::NEG_Y) >= 1.0 - 1e-12, "{configuration:?}");
            }
            if configuration.surface == Surface::Disk {
                assert!((geometry.bend - 1.0).abs() < 1e-12, "x lies on that disk");
            }
        }
        let steepest = CONFIGURATIONS[0].geometry().angles[0].to_degrees();
        assert!((steepest - 26.74).abs() < 0.01, "{steepest}");
    }

    #[test]
    fn rolling_balls_cover_the_region_in_all_eight() {
        for configuration in CONFIGURATIONS {
            let gap = highest_gap(&configuration.geometry(), 20_000);
            // Between the points where two neighbours touch the surface, there is always a gap.
            assert!(gap < 1e-5, "{configuration:?}: {gap}");
        }
    }

    #[test]
    fn so_do_the_balls_that_are_drawn() {
        for configuration in CONFIGURATIONS {
            let gap = highest_gap(&configuration.geometry(), BALLS);
            assert!(gap < 0.02, "{configuration:?}: {gap}");
        }
    }

    #[test]
    fn the_fourth_is_close_to_tight() {
        let margin = |configuration: &Configuration| {
            let geometry = configuration.geometry();
            let balls = geometry.rolling(20_000).into_iter();
            let spare = balls.map(|ball| ball.radius - geometry.corner().distance(ball.centre));
            spare.fold(f64::NEG_INFINITY, f64::max)
        };
        let margins = CONFIGURATIONS.each_ref().map(margin);
        let least = margins.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(margins[3] > 0.0 && margins[3] < 0.01, "{margins:?}");
        assert!(
            (margins[3].min(margins[4]) - least).abs() < 1e-12,
            "{margins:?}"
        );
        let uncovered = margin(&UNCOVERED);
        assert!((-0.008..-0.006).contains(&uncovered), "{uncovered}");
    }

    #[test]
    fn an_angle_of_27_degrees_near_s1_would_not_do() {
        let covered = CONFIGURATIONS.map(|configuration| {
            let angles = [configuration.x_angle, configuration.y_angle];
            let largest = (RHO / 2.0).asin();
            let angles = angles.map(|fraction| fraction * largest);
            let geometry = Geometry::new(configuration.ratio, angles, configuration.surface);
            highest_gap(&geometry, 20_000) < 1e-5
        });
        assert_eq!(covered, [true, true, true, false, false, true, true, true]);
    }
}
