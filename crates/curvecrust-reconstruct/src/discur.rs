//! DISCUR: Y. Zeng, T. A. Nguyen, B. Yan, S. Li, "A Distance-Based Parameter Free Algorithm for
//! Curve Reconstruction", Computer-Aided Design 40(2), 2008.
//!
//! Points are joined as people see them joined: by proximity and by how even the spacing is. Every
//! point starts as a curve of its own. The shortest Delaunay edge between the ends of two curves,
//! or of one, is taken that both of its ends accept, until there is none. A point alone accepts all
//! edges. The end of a curve whose edges have mean h and standard deviation s, the last of them d',
//! accepts an edge of length d if
//!
//! ```text
//! d < h (a / b) (1 + h / s)^(s / h),   a = (d + d') / 2,   b = |d - d'| / sqrt 2
//! ```
//!
//! where the last factor is 1 without deviation. So a chain of even spacing accepts a gap of up to
//! 2.05 spacings.
//!
//! No sampling condition by lfs is known to make it exact. Cost: that of the Delaunay
//! triangulation, O(n log n), as long as few curves end at one point in turn.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Reconstructor, Scope};
use crate::delaunay_graph::DelaunayGraph;
use crate::paths::Paths;
use crate::spacing::Spacing;

/// The edges of DISCUR: rings and chains.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::discur;
///
/// // Ten points of even spacing, a gap, and ten more.
/// let row = |gap: f64| {
///     let x = (0..20).map(|i| f64::from(i) + if i < 10 { 0.0 } else { gap - 1.0 });
///     PointSet::new(x.map(|x| DVec2::new(x, 0.0)).collect())
/// };
/// assert_eq!(discur(&row(2.0)?).len(), 19);
/// assert_eq!(discur(&row(2.1)?).len(), 18);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn discur(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let mut growth = Growth {
        graph: &graph,
        paths: Paths::new(graph.len()),
        spacing: vec![Spacing::default(); graph.len()],
        again: BinaryHeap::new(),
    };
    for number in (0u32..).take(graph.edges.len()) {
        growth.consider(number, number);
        while let Some(Reverse(rejected)) = growth.again.pop() {
            growth.consider(rejected, number);
        }
    }
    graph.edge_set(growth.paths.pairs())
}

struct Growth<'a> {
    graph: &'a DelaunayGraph,
    paths: Paths,
    /// At the ends of a path, that of its edges.
    spacing: Vec<Spacing>,
    /// Edges that were rejected, but whose ends have changed.
    again: BinaryHeap<Reverse<u32>>,
}

impl Growth<'_> {
    /// Takes an edge if both ends accept it; then those up to `latest` at the ends of the new path
    /// are to be considered again.
    fn consider(&mut self, number: u32, latest: u32) {
        let [p, q] = self.graph.ends(number);
        let length = self.graph.length(p, q);
        let is_open = self.paths.is_end(p) && self.paths.is_end(q);
        if !is_open || self.paths.are_joined(p, q) {
            return;
        }
        if !self.accepts(p, length) || !self.accepts(q, length) {
            return;
        }
        let spacing = if self.paths.far_end(p) == q {
            self.spacing[p as usize].with(length)
        } else {
            self.spacing[p as usize]
                .and(self.spacing[q as usize])
                .with(length)
        };
        let ends = self.paths.join(p, q);
        for end in ends {
            self.spacing[end as usize] = spacing;
            if self.paths.is_end(end) {
                let around = self.graph.around(end).map(|(number, _)| number);
                let rejected = around.take_while(|&number| number <= latest);
                self.again.extend(rejected.map(Reverse));
            }
        }
    }

    fn accepts(&self, end: u32, length: f64) -> bool {
        let Some(before) = self.paths.before(end) else {
            return true;
        };
        let last = self.graph.length(before, end);
        let spacing = self.spacing[end as usize];
        let (mean, deviation) = (spacing.mean(), spacing.deviation());
        let [even, uneven] = [
            f64::midpoint(length, last),
            (length - last).abs() / std::f64::consts::SQRT_2,
        ];
        let spread = if deviation > 0.0 {
            libm::pow(1.0 + mean / deviation, deviation / mean)
        } else {
            1.0
        };
        // Without a division, which would be by 0 for even edges.
        length * uneven < mean * even * spread
    }
}

/// DISCUR behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Discur;

impl Reconstructor for Discur {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            scope: Scope::CLOSED_AND_OPEN.with_corners(),
            ..AlgorithmInfo::new(
                "discur",
                "Zeng, Nguyen, Yan, Li: A Distance-Based Parameter Free Algorithm for Curve \
                 Reconstruction. CAD 2008",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        discur(points)
    }
}
