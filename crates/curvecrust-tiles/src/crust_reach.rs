//! How far away samples may be that a sample is joined to by the crust.
//!
//! Let an edge of the crust lead from p to q, and let a disc about c with both on its boundary be
//! free of samples and Voronoi vertices. Its centre lies on the Voronoi edge of p and q, whose ends
//! are no nearer to c than p is. So the diameter ab of the disc along that edge lies in the cell of
//! p. By Thales the angle apb is a right one, the midpoint of pq is the foot of its altitude, and
//!
//! (2 / |pq|)^2 = 1 / |pa|^2 + 1 / |pb|^2.
//!
//! The cell that p has among some of the samples is at least as large as the one among all. Of that
//! cell, let s(u) be the inverse of the distance from p to its border in the direction u; each
//! neighbour v contributes 2 (u v) / |v|^2, as seen from p, and s is the largest of these or 0.
//! Then no q is farther away than 2 / sqrt(min s(u)^2 + s(u')^2) over all u, where u' is u turned
//! by a right angle. Along a curve cells are thin, and this is little more than the spacing, though
//! they may reach far.
//!
//! Besides, the midpoint of pq lies in the cell: the angle at a neighbour v is at most a right one.
//! Beyond the end of a curve, where the cell has no border, this leaves what lies before the end.

use std::array;

use curvecrust_geometry::DVec2;

use crate::area::Area;
use crate::region::{Region, most};

/// Directions in a quarter turn.
const QUARTER: usize = 8;

/// Directions.
const ALL: usize = 4 * QUARTER;

/// More than all rounding errors.
const SLACK: f64 = 1.0 + 1e-9;

/// Directions around a circle.
#[derive(Clone, Debug)]
pub(crate) struct Directions([DVec2; ALL]);

impl Directions {
    pub(crate) fn new() -> Self {
        Self(array::from_fn(|k| {
            let up = (k % QUARTER) as f64;
            let first = DVec2::new(QUARTER as f64 - up, up).normalize();
            (0..k / QUARTER).fold(first, |u, _| u.perp())
        }))
    }
}

/// Where samples may be that the crust joins a sample to.
#[derive(Clone, Debug)]
pub(crate) struct CrustReach {
    at: DVec2,
    /// The most that the distance may be; infinite if it is not bounded.
    distance: f64,
    /// The neighbours as seen from the sample.
    neighbours: Vec<DVec2>,
}

impl CrustReach {
    /// Of a sample and its Delaunay neighbours, or some of them.
    pub(crate) fn new(
        directions: &Directions,
        at: DVec2,
        neighbours: impl Iterator<Item = DVec2>,
    ) -> Self {
        let neighbours: Vec<DVec2> = neighbours.map(|v| v - at).collect();
        // Half of s, at least, on the arc from each direction to the next one.
        let mut least = [0.0f64; ALL];
        for v in &neighbours {
            let scaled = *v / v.length_squared();
            let along = directions.0.map(|u| u.dot(scaled));
            // The cosine of an angle is least at one end of an arc on which it is positive.
            for (k, least) in least.iter_mut().enumerate() {
                *least = least.max(along[k].min(along[(k + 1) % ALL]));
            }
        }
        let sum = |k: usize| least[k].powi(2) + least[(k + QUARTER) % ALL].powi(2);
        let least = (0..ALL).map(sum).fold(f64::INFINITY, f64::min);
        Self {
            at,
            distance: SLACK / least.sqrt(),
            neighbours,
        }
    }
}

impl Region for CrustReach {
    fn meets(&self, area: Area) -> bool {
        let distance = area.distance_squared(self.at);
        if distance > self.distance * self.distance {
            return false;
        }
        // Whether all of it lies beyond the line through a neighbour, as seen from the sample.
        let is_beyond = |&v: &DVec2| -most(area, self.at, -v) > v.length_squared() * SLACK;
        !self.neighbours.iter().any(is_beyond)
    }

    fn is_inside(&self, area: Area) -> bool {
        self.distance * self.distance < area.inside_squared(self.at)
    }

    fn bounds(&self) -> Area {
        if self.distance == f64::INFINITY {
            return Area::EVERYTHING;
        }
        let rounding = f64::EPSILON * self.at.abs().max_element();
        Area::of([self.at]).grown(self.distance * SLACK + rounding)
    }
}
