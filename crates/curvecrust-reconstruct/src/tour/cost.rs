//! What a tour costs: the lengths of its edges, and perhaps the detours at its points, but for its
//! gaps.

use crate::detour::detour;
use curvecrust_geometry::DVec2;

use super::{Goal, Task};

/// A smaller gain, as a share of the lengths that it is the difference of, is rounding: that of
/// some dozen sums.
const ROUNDING: f64 = 1e-14;

/// A difference of costs, and the size of the terms that it was computed from.
#[derive(Clone, Copy, Default)]
pub(super) struct Change {
    pub(super) cost: f64,
    size: f64,
}

impl Change {
    /// With the cost of an edge that is put in.
    pub(super) fn add(&mut self, edge: f64) {
        self.cost += edge;
        self.size += edge.abs();
    }

    /// With the cost of an edge that is taken away.
    pub(super) fn remove(&mut self, edge: f64) {
        self.cost -= edge;
        self.size += edge.abs();
    }

    /// Whether the cost falls by more than rounding could feign.
    pub(super) fn is_gain(self) -> bool {
        self.cost < -ROUNDING * self.size
    }
}

impl std::ops::Add for Change {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            cost: self.cost + other.cost,
            size: self.size + other.size,
        }
    }
}

/// The cost of a tour through points and gaps: the lengths of its edges; and for
/// [`Goal::LengthAndDetours`] at each point v between p and q the detour |vp| + |vq| - |pq|, as for
/// [least detour](mod@crate::least_detour).
///
/// A gap is a vertex without a place. It lies between the end of an open curve and the start of the
/// next, so a step to it costs nothing. What must not be (gaps next to each other, a curve of one
/// point, a terminus inside a curve) costs more than any exchange of edges can gain.
#[derive(Clone, Copy)]
pub(super) struct Cost<'a> {
    points: &'a [DVec2],
    goal: Goal,
    gaps: usize,
    is_terminus: &'a [bool],
    /// Whether points that are no termini may be next to a gap.
    has_free_ends: bool,
    /// The cost of what must not be.
    forbidden: f64,
    /// What is added to the cost of an edge for each point at its ends: the same for every tour.
    prices: &'a [f64],
}

impl<'a> Cost<'a> {
    pub(super) fn new(points: &'a [DVec2], task: &'a Task) -> Self {
        let low = points
            .iter()
            .copied()
            .reduce(DVec2::min)
            .unwrap_or_default();
        let high = points
            .iter()
            .copied()
            .reduce(DVec2::max)
            .unwrap_or_default();
        let termini = task.is_terminus.iter().filter(|&&t| t).count();
        Self {
            points,
            goal: task.goal,
            gaps: task.gaps,
            is_terminus: &task.is_terminus,
            has_free_ends: termini < 2 * task.gaps,
            // An exchange changes a dozen edges at most.
            forbidden: 64.0 * (high - low).length(),
            prices: &[],
        }
    }

    /// The same, with a price for every point. All tours cost the same more.
    ///
    /// Of an exchange that gains in the end, some partial sum from a right start is a gain all
    /// along (Lin, Kernighan 1973); at prices for which the cheapest 1-tree is nearly a tour, the
    /// partial sums of right exchanges fall less (Helsgaun 2000, 4.1), above all where points are
    /// in clusters.
    pub(super) fn with_prices<'b>(&self, prices: &'b [f64]) -> Cost<'b>
    where
        'a: 'b,
    {
        Cost { prices, ..*self }
    }

    /// Whether vertices cost something, and not edges alone.
    pub(super) fn has_vertices(&self) -> bool {
        self.goal == Goal::LengthAndDetours
    }

    pub(super) fn points(&self) -> &'a [DVec2] {
        self.points
    }

    pub(super) fn is_gap(&self, v: u32) -> bool {
        v as usize >= self.points.len()
    }

    /// The gaps.
    pub(super) fn gaps(&self) -> impl Iterator<Item = u32> + use<> {
        let (points, gaps) = (self.points.len(), self.gaps);
        (0u32..).skip(points).take(gaps)
    }

    pub(super) fn is_terminus(&self, v: u32) -> bool {
        self.is_terminus.get(v as usize).is_some_and(|&t| t)
    }

    /// Whether a point may be the end of an open curve.
    pub(super) fn may_be_end(&self, v: u32) -> bool {
        self.has_free_ends || self.is_terminus(v)
    }

    /// The cost of an edge.
    pub(super) fn edge(&self, v: u32, w: u32) -> f64 {
        match [v, w].map(|v| self.points.get(v as usize)) {
            [Some(p), Some(q)] => p.distance(*q) + self.price(v) + self.price(w),
            [None, None] => self.forbidden,
            [Some(_), None] => self.end(v),
            [None, Some(_)] => self.end(w),
        }
    }

    fn price(&self, v: u32) -> f64 {
        self.prices.get(v as usize).copied().unwrap_or(0.0)
    }

    /// The cost of a point next to a gap: a terminus gains by it.
    fn end(&self, v: u32) -> f64 {
        if self.is_terminus(v) {
            -self.forbidden
        } else if self.has_free_ends {
            0.0
        } else {
            self.forbidden
        }
    }

    /// The cost of a vertex between two others: a detour, but beside gaps.
    pub(super) fn vertex(&self, v: u32, p: u32, q: u32) -> f64 {
        match [v, p, q].map(|v| self.points.get(v as usize)) {
            [Some(&v), Some(&p), Some(&q)] => match self.goal {
                Goal::Length => 0.0,
                Goal::LengthAndDetours => detour(v, p, q),
            },
            // A curve of one point.
            [Some(_), None, None] => 4.0 * self.forbidden,
            _ => 0.0,
        }
    }
}
