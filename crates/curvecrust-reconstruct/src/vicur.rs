//! VICUR-like: after T. A. Nguyen, Y. Zeng, "VICUR: A Human-Vision-Based Algorithm for Curve
//! Reconstruction", Robotics and Computer-Integrated Manufacturing 24(6), 2008. Its text and its
//! constants were not available: this is a sketch of its idea.
//!
//! As in [DISCUR](mod@crate::discur), curves grow at their ends; but an end chooses its partner
//! by proximity and by how smoothly the curve goes on. Let the edges of a curve have mean h and
//! standard deviation s, and its corners the mean angle m, where 180 degrees is straight on. Its
//! end looks at the Delaunay neighbours that are ends, no farther than 1.849 h, and at an angle of
//! 45 degrees or more to its last edge. It chooses the one at distance d and angle t with the
//! largest
//!
//! ```text
//! 1 / (1 + c (t / m - 1)^2 + (1 - c) / 4 (d / (h + s))^2),   c = 0.7
//! ```
//!
//! A point alone is joined by whoever chooses it, and with another one if they are the nearest
//! to each other of those that are ends. Two ends of curves are joined if they choose each other.
//! The shortest such edge is taken first.
//!
//! No sampling condition is known to make it exact. Cost: that of the Delaunay triangulation,
//! O(n log n), as long as no point is near very many others.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_graph::DelaunayGraph;
use crate::paths::Paths;
use crate::spacing::Spacing;

/// The weight of smoothness; the rest is that of proximity.
const SMOOTHNESS: f64 = 0.7;

/// How far an end looks, in mean spacings of its curve.
const FARTHEST: f64 = 1.849;

/// The edges of the VICUR-like algorithm: rings and chains.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::vicur;
///
/// // A row that goes straight on past a point that is nearer, but to the side.
/// let mut row: Vec<DVec2> = (0..10).map(|i| DVec2::new(f64::from(i), 0.0)).collect();
/// row.extend([DVec2::new(10.3, 0.0), DVec2::new(9.0, 1.25)]);
/// assert_eq!(vicur(&PointSet::new(row)?).isolated(), [11.into()]);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn vicur(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let mut growth = Growth::new(&graph);
    while let Some(Reverse(number)) = growth.wanted.pop() {
        growth.consider(number);
    }
    graph.edge_set(growth.paths.pairs())
}

struct Growth<'a> {
    graph: &'a DelaunayGraph,
    paths: Paths,
    /// At the ends of a path: of its edges, and of its angles.
    spacing: Vec<Spacing>,
    angles: Vec<Spacing>,
    /// The edge that an end wants.
    choice: Vec<Option<u32>>,
    /// Edges that both ends agreed to when they were put here.
    wanted: BinaryHeap<Reverse<u32>>,
}

impl<'a> Growth<'a> {
    fn new(graph: &'a DelaunayGraph) -> Self {
        let mut growth = Self {
            graph,
            paths: Paths::new(graph.len()),
            spacing: vec![Spacing::default(); graph.len()],
            angles: vec![Spacing::default(); graph.len()],
            choice: vec![None; graph.len()],
            wanted: BinaryHeap::new(),
        };
        for v in graph.vertices() {
            growth.choose(v);
        }
        growth
    }

    /// Whether both ends of the edge want it; a free point does if the other end is none.
    fn is_agreed(&self, number: u32) -> bool {
        let ends = self.graph.ends(number);
        let wants = ends.map(|v| self.choice[v as usize] == Some(number));
        let free = ends.map(|v| self.paths.is_free(v));
        match wants {
            [true, true] => true,
            [true, false] => free == [false, true],
            [false, true] => free == [true, false],
            [false, false] => false,
        }
    }

    fn consider(&mut self, number: u32) {
        let [p, q] = self.graph.ends(number);
        let is_open = self.paths.is_end(p) && self.paths.is_end(q);
        if !is_open || self.paths.are_joined(p, q) || !self.is_agreed(number) {
            return;
        }
        let closes = self.paths.far_end(p) == q;
        let sum = |of: &[Spacing]| {
            let [p, q] = [p, q].map(|v| of[v as usize]);
            if closes { p } else { p.and(q) }
        };
        let spacing = sum(&self.spacing).with(self.graph.length(p, q));
        let mut angles = sum(&self.angles);
        for (at, to) in [(p, q), (q, p)] {
            if let Some(angle) = self.angle(at, to) {
                angles = angles.with(angle);
            }
        }
        let ends = self.paths.join(p, q);
        for end in ends {
            self.spacing[end as usize] = spacing;
            self.angles[end as usize] = angles;
        }
        // Ends whose choice is no end any more choose again.
        let graph = self.graph;
        for v in [p, q] {
            if self.paths.is_end(v) {
                continue;
            }
            self.choice[v as usize] = None;
            for (number, w) in graph.around(v) {
                if self.choice[w as usize] == Some(number) {
                    self.choose(w);
                }
            }
        }
        for end in ends {
            self.choose(end);
        }
    }

    /// Renews what an end wants.
    fn choose(&mut self, v: u32) {
        let ends = self.graph.around(v).filter(|&(_, w)| {
            self.paths.is_end(v) && self.paths.is_end(w) && !self.paths.are_joined(v, w)
        });
        let choice = if self.paths.is_free(v) {
            ends.map(|(number, _)| number).next()
        } else {
            let (mean, deviation) = {
                let spacing = self.spacing[v as usize];
                (spacing.mean(), spacing.deviation())
            };
            let near = ends.take_while(|&(_, w)| self.graph.length(v, w) <= FARTHEST * mean);
            let rated = near.filter_map(|(number, w)| {
                let distance = self.graph.length(v, w) / (mean + deviation);
                Some((self.connectivity(v, w, distance)?, number))
            });
            // Of equal ones the shortest.
            let best = rated.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            best.map(|(_, number)| number)
        };
        self.choice[v as usize] = choice;
        if let Some(number) = choice.filter(|&number| self.is_agreed(number)) {
            self.wanted.push(Reverse(number));
        }
    }

    /// How well a curve goes on from its end to another point; `None` if it turns back.
    fn connectivity(&self, end: u32, to: u32, distance: f64) -> Option<f64> {
        let angle = self.angle(end, to)?;
        let angles = self.angles[end as usize];
        let usual = if angles.is_empty() {
            std::f64::consts::PI
        } else {
            angles.mean()
        };
        let turn = angle / usual - 1.0;
        let proximity = (1.0 - SMOOTHNESS) / 4.0 * distance * distance;
        (angle >= std::f64::consts::FRAC_PI_4)
            .then(|| 1.0 / (1.0 + SMOOTHNESS * turn * turn + proximity))
    }

    /// The angle at the end of a curve between its last edge and a further one; `None` at a free
    /// point.
    fn angle(&self, end: u32, to: u32) -> Option<f64> {
        let before = self.paths.before(end)?;
        let at = self.graph.at(end);
        let [u, v] = [before, to].map(|w| self.graph.at(w) - at);
        Some(libm::atan2(u.perp_dot(v).abs(), u.dot(v)))
    }
}

/// The VICUR-like algorithm behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vicur;

impl Reconstructor for Vicur {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED_AND_OPEN,
            ..AlgorithmInfo::new(
                "vicur-like",
                "after Nguyen, Zeng: VICUR. Robotics and Computer-Integrated Manufacturing 2008",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        vicur(points)
    }
}
