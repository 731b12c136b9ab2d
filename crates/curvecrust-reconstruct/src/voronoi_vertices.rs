//! Whether Voronoi vertices leave room for a disc that touches two samples.

use std::f64::consts::FRAC_1_SQRT_2;
use std::ops::ControlFlow;
use std::sync::OnceLock;

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{DVec2, PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use crate::frame::Frame;
use crate::pencil::{Cut, Effect, Pencil};
use crate::voronoi_vertex::VoronoiVertex;

/// Half a unit in the last place of 1: the relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// Voronoi vertices, indexed by their places.
struct Indexed {
    vertices: Vec<VoronoiVertex>,
    frame: Frame,
}

impl Indexed {
    fn new(vertices: Vec<VoronoiVertex>) -> Self {
        Self {
            frame: Frame::new(&vertices, (0..vertices.len()).collect()),
            vertices,
        }
    }

    /// Visits all vertices in a disc, as [`Frame::in_disc`] does.
    fn in_disc<'v>(
        &'v self,
        disc: &impl Fn(DVec2) -> Option<(DVec2, f64)>,
        visit: &mut impl FnMut(&'v VoronoiVertex) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if self.vertices.is_empty() {
            return ControlFlow::Continue(());
        }
        self.frame.in_disc(&self.vertices, disc, visit)
    }
}

/// The Voronoi vertices of a point set, ready for searches.
pub(crate) struct VoronoiVertices<'a> {
    points: &'a PointSet,
    delaunay: &'a Delaunay,
    /// Which of them count.
    counts: &'a (dyn Fn(&VoronoiVertex) -> bool + Sync),
    /// Those that may lie in the smallest disc of an edge to be asked about: where samples are
    /// dense these are few.
    near: Indexed,
    /// All others, indexed if the smallest disc of some edge is not free.
    far: OnceLock<Indexed>,
    /// The largest circumradius of those that are near.
    radius: f64,
}

impl<'a> VoronoiVertices<'a> {
    /// For questions about edges up to a length.
    pub(crate) fn new(points: &'a PointSet, delaunay: &'a Delaunay, longest: f64) -> Self {
        Self::among(points, delaunay, longest, &|_| true)
    }

    /// The same for those of the vertices that count.
    pub(crate) fn among(
        points: &'a PointSet,
        delaunay: &'a Delaunay,
        longest: f64,
        counts: &'a (dyn Fn(&VoronoiVertex) -> bool + Sync),
    ) -> Self {
        // What lies in the disc with diameter pq is no farther from p or q than |pq| / sqrt 2; and
        // a little more, for rounding.
        let radius = FRAC_1_SQRT_2 * longest * (1.0 + 2f64.powi(-10));
        let near = delaunay
            .triangles()
            .filter(|&triangle| is_small(points, triangle, radius))
            .map(|triangle| VoronoiVertex::new(points, triangle));
        Self {
            points,
            delaunay,
            counts,
            near: Indexed::new(near.collect()),
            far: OnceLock::new(),
            radius,
        }
    }

    fn far(&self) -> &Indexed {
        self.far.get_or_init(|| {
            let triangles = self.delaunay.triangles();
            let others = triangles.filter(|&t| !is_small(self.points, t, self.radius));
            let others: Vec<[PointId; 3]> = others.collect();
            let vertex = |&triangle| VoronoiVertex::new(self.points, triangle);
            Indexed::new(others.par_iter().map(vertex).collect())
        })
    }

    /// Whether some disc with both samples on its boundary has no Voronoi vertex inside, exactly.
    pub(crate) fn spare_a_disc_through(&self, ends: [PointId; 2]) -> bool {
        self.free_discs_through(ends).is_some()
    }

    /// A range of cotangents that holds a disc with both samples on its boundary and no vertex
    /// inside, exactly; most often it is a single disc. `None` if there is no such disc.
    ///
    /// Tries one disc after the other. Vertices inside narrow the range of discs that may still be
    /// free; the next disc is taken from the middle of what is left, so that the range at least
    /// halves, until a disc is free or the ends of the range are too close to tell apart.
    pub(crate) fn free_discs_through(&self, ends: [PointId; 2]) -> Option<[f64; 2]> {
        let pencil = Pencil::new(self.points, ends);
        let mut stop_at_first = self.if_counted(|_| ControlFlow::Break(()));
        let smallest = |origin| pencil.disc(0.0, origin);
        if self
            .near
            .in_disc(&smallest, &mut stop_at_first)
            .is_continue()
        {
            return Some([0.0; 2]);
        }
        let mut range = Range::default();
        while let Some(tried) = range.probe() {
            self.in_disc(&pencil, tried, |vertex| {
                range.apply(&pencil, vertex);
                if range.surely_excludes(tried) {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
            if range.surely_contains(tried) {
                return Some([tried; 2]);
            }
            if range.is_empty(&pencil) {
                return None;
            }
        }
        // What is outside of the discs at both ends of a range is outside of all discs between.
        let ends = range.outer_ends();
        for end in ends {
            self.in_disc(&pencil, end, |vertex| {
                range.apply(&pencil, vertex);
                ControlFlow::Continue(())
            });
        }
        (!range.is_empty(&pencil)).then_some(ends)
    }

    /// What visits the vertices that count alone.
    fn if_counted<'v>(
        &'v self,
        mut visit: impl FnMut(&'v VoronoiVertex) -> ControlFlow<()>,
    ) -> impl FnMut(&'v VoronoiVertex) -> ControlFlow<()> {
        move |vertex| {
            if (self.counts)(vertex) {
                visit(vertex)
            } else {
                ControlFlow::Continue(())
            }
        }
    }

    /// Visits all vertices that count in a disc, and perhaps a few around it, until `visit` breaks.
    fn in_disc<'v>(
        &'v self,
        pencil: &Pencil<'_>,
        cotangent: f64,
        visit: impl FnMut(&'v VoronoiVertex) -> ControlFlow<()>,
    ) {
        let disc = |origin| pencil.disc(cotangent, origin);
        let mut visit = self.if_counted(visit);
        if self.near.in_disc(&disc, &mut visit).is_continue() {
            let _ = self.far().in_disc(&disc, &mut visit);
        }
    }

    /// Whether one of the vertices near edges, in a disc or a little outside, is asked for.
    pub(crate) fn any_near(
        &self,
        disc: &impl Fn(DVec2) -> Option<(DVec2, f64)>,
        is_wanted: impl Fn(&VoronoiVertex) -> bool,
    ) -> bool {
        let mut stop_at_wanted = |vertex: &VoronoiVertex| {
            if is_wanted(vertex) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        self.near.in_disc(disc, &mut stop_at_wanted).is_break()
    }
}

/// Whether the circumradius of a triangle is, up to rounding, at most `radius`: never false if it
/// is.
fn is_small(points: &PointSet, triangle: [PointId; 3], radius: f64) -> bool {
    let [a, b, c] = triangle.map(|id| points[id]);
    let (ab, ac, bc) = (b - a, c - a, c - b);
    let [x, y, z] = [ab, ac, bc].map(DVec2::length);
    // A circle is no smaller than its chords.
    if x.max(y).max(z) > 2.0 * radius {
        return false;
    }
    // Each product errs by 3 U of itself, their difference by one more.
    let terms = (ab.x * ac.y).abs() + (ab.y * ac.x).abs();
    let twice_area = ab.perp_dot(ac) + 8.0 * U * terms;
    x * y * z <= 2.0 * radius * twice_area
}

/// The discs of a pencil that no vertex has ruled out, by their cotangents: from `low` to `high`,
/// both included.
#[derive(Default)]
struct Range<'a> {
    low: Option<Cut<'a>>,
    high: Option<Cut<'a>>,
    is_blocked: bool,
}

impl<'a> Range<'a> {
    /// Rules out the discs that hold the vertex.
    fn apply(&mut self, pencil: &Pencil<'_>, vertex: &'a VoronoiVertex) {
        match pencil.effect(vertex) {
            Effect::Above(cut) => {
                if self
                    .high
                    .is_none_or(|high| pencil.compare(&cut, &high).is_lt())
                {
                    self.high = Some(cut);
                }
            }
            Effect::Below(cut) => {
                if self
                    .low
                    .is_none_or(|low| pencil.compare(&cut, &low).is_gt())
                {
                    self.low = Some(cut);
                }
            }
            Effect::Everywhere => self.is_blocked = true,
            Effect::Nowhere => {}
        }
    }

    fn is_empty(&self, pencil: &Pencil<'_>) -> bool {
        let crossed = match (&self.low, &self.high) {
            (Some(low), Some(high)) => pencil.compare(low, high).is_gt(),
            _ => false,
        };
        self.is_blocked || crossed
    }

    fn surely_contains(&self, cotangent: f64) -> bool {
        let (low, high) = self.sure_ends();
        !self.is_blocked && low <= cotangent && cotangent <= high
    }

    fn surely_excludes(&self, cotangent: f64) -> bool {
        self.is_blocked
            || self.low.is_some_and(|low| cotangent < low.least)
            || self.high.is_some_and(|high| cotangent > high.most)
    }

    /// A cotangent surely in the range: of the smallest disc if it may be, else one in the middle,
    /// so that the range shrinks fast. `None` if the ends of the range are too close.
    fn probe(&self) -> Option<f64> {
        let (low, high) = self.sure_ends();
        let probe = if low <= 0.0 && 0.0 <= high {
            0.0
        } else if high.is_infinite() {
            2.0 * low + 1.0
        } else if low.is_infinite() {
            2.0 * high - 1.0
        } else {
            low / 2.0 + high / 2.0
        };
        (probe.is_finite() && low <= probe && probe <= high).then_some(probe)
    }

    /// The ends of the range without their rounding errors.
    fn sure_ends(&self) -> (f64, f64) {
        (
            self.low.map_or(f64::NEG_INFINITY, |low| low.most),
            self.high.map_or(f64::INFINITY, |high| high.least),
        )
    }

    /// The ends of the range with their rounding errors.
    fn outer_ends(&self) -> [f64; 2] {
        [
            self.low.map_or(f64::NEG_INFINITY, |low| low.least),
            self.high.map_or(f64::INFINITY, |high| high.most),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::delaunay_edges::is_crust_edge;
    use curvecrust_testing::hard_points::{exponential_spiral, far_grid};

    /// How many vertices are visited per edge and disc, for the smallest discs of all edges that
    /// the one-step crust keeps, and for those twice as wide on both sides.
    fn visits_per_edge(points: Vec<DVec2>) -> f64 {
        let points = PointSet::new(points).unwrap();
        let delaunay = Delaunay::new(&points);
        let edges = delaunay.edges().filter(|dual| is_crust_edge(&points, dual));
        let edges: Vec<_> = edges.map(|dual| dual.ends).collect();
        let length = |&[p, q]: &[PointId; 2]| points[p].distance(points[q]);
        let longest = edges.iter().map(length).fold(0.0, f64::max);
        let vertices = VoronoiVertices::new(&points, &delaunay, longest);
        let mut visits = 0_usize;
        for &ends in &edges {
            let pencil = Pencil::new(&points, ends);
            for cotangent in [-1.0, 0.0, 1.0] {
                vertices.in_disc(&pencil, cotangent, |_| {
                    visits += 1;
                    ControlFlow::Continue(())
                });
            }
        }
        visits as f64 / edges.len() as f64
    }

    /// As seen from the largest coordinates, doubles do not resolve the inner part of the spiral,
    /// nor points at 1e17 as seen from one at 0: every search visited all of them.
    #[test]
    fn searches_stay_local_beyond_the_digits_of_a_double() {
        for n in [1000, 4000] {
            let mut sets = vec![exponential_spiral(n)];
            for corner in [DVec2::ONE, DVec2::NEG_ONE, DVec2::new(1.0, -1.0)] {
                sets.push(far_grid(n, 1e17 * corner));
            }
            for (which, points) in sets.into_iter().enumerate() {
                let visits = visits_per_edge(points);
                assert!(visits < 30.0, "{n} {which}: {visits}");
            }
        }
    }
}
