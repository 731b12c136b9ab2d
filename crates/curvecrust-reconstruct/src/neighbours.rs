//! Nearest and half neighbours: the local step of HNN-Crust and NN-Crust.

mod bounds;
mod candidates;
mod edges;
mod half_plane;
mod kernel;
mod lanes;
mod search;
mod tree;

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{EdgeSet, Interrupt, PointId, PointSet};

use kernel::{Choice, TASK};
use search::NONE;
use tree::Tree;

pub use edges::Keep;
pub use half_plane::HalfPlane;

/// The two points to which a point of a curve may be joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Neighbours {
    /// The closest other point; `None` iff there is no other point.
    pub nearest: Option<PointId>,
    /// The closest point of the half-plane of a [`HalfRule`]; `None` iff no point lies there.
    pub half: Option<PointId>,
}

/// The half-plane, on the side away from the nearest neighbour n0, in which the second neighbour
/// of a point s is sought.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HalfRule {
    /// All q with |q s| < |q n0|: the open half-plane of the bisector of s and n0 that holds s.
    /// The half neighbour of HNN-Crust (Ohrhallinger, Mitchell, Wimmer 2016).
    Bisector,
    /// All q with an angle n0-s-q of 90 degrees or more: the rule of NN-Crust (Dey, Kumar 1999).
    RightAngle,
}

/// The nearest and the half neighbour of every point, in the order of ids.
///
/// The search has no cap: it ends at a neighbour or when no point is left. Which points lie in the
/// half-plane is decided exactly. Distances are compared as squares computed in f64 from
/// differences of coordinates; ties go to the smaller x, then the smaller y. The result therefore
/// depends neither on the order of the points nor on the number of threads, and stays the same
/// under scaling by a power of two and under translation, as long as no coordinate is rounded.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointId, PointSet};
/// use curvecrust_reconstruct::neighbours::{HalfRule, neighbours};
///
/// let points = PointSet::new([0.0, 1.0, 3.0].map(|x| DVec2::new(x, 0.0)).to_vec())?;
/// let found = neighbours(&points, HalfRule::Bisector);
/// let id = |i| Some(PointId::from(i));
/// assert_eq!((found[1].nearest, found[1].half), (id(0), id(2)));
/// assert_eq!((found[2].nearest, found[2].half), (id(1), None));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn neighbours(points: &PointSet, rule: HalfRule) -> Vec<Neighbours> {
    let Choices { order, chosen } = Choices::new(points, rule);
    let at = |place: u32| order.get(place as usize).copied();
    let mut neighbours = vec![Neighbours::default(); points.len()];
    for (id, &[nearest, half]) in order.iter().zip(&chosen) {
        neighbours[id.index()] = Neighbours {
            nearest: at(nearest),
            half: at(half),
        };
    }
    neighbours
}

/// The neighbours of all points, in spatial order.
#[derive(Debug)]
pub(crate) struct Choices<'a> {
    /// The points in spatial order.
    order: &'a [PointId],
    /// What each chose, as positions in that order.
    chosen: Vec<Choice>,
}

impl<'a> Choices<'a> {
    /// The nearest and the half neighbour of every point.
    pub(crate) fn new(points: &'a PointSet, rule: HalfRule) -> Self {
        let order = points.hilbert_order();
        let tree = Tree::new(points.points(), order);
        let mut chosen = vec![[NONE; 2]; tree.len()];
        let interrupt = Interrupt::current();
        let tasks = chosen.par_chunks_mut(TASK).enumerate();
        tasks.for_each(|(task, chosen)| {
            interrupt.check();
            kernel::choose(&tree, rule, task, chosen);
        });
        Self { order, chosen }
    }

    /// Takes back the choice of a half neighbour by some of the points.
    pub(crate) fn without_half(mut self, of: &[PointId]) -> Self {
        if of.is_empty() {
            return self;
        }
        let mut is_of = vec![false; self.order.len()];
        for id in of {
            is_of[id.index()] = true;
        }
        for (id, [_, half]) in self.order.iter().zip(&mut self.chosen) {
            if is_of[id.index()] {
                *half = NONE;
            }
        }
        self
    }

    /// The edges that points chose and `keep` keeps.
    pub(crate) fn edges(&self, keep: Keep) -> EdgeSet {
        edges::kept(self.order, &self.chosen, keep)
    }
}

#[cfg(test)]
mod tests {
    use super::half_plane::HalfPlane;
    use super::*;
    use curvecrust_geometry::DVec2;
    use curvecrust_geometry::point_set::by_coordinates;
    use proptest::prelude::*;

    const RULES: [HalfRule; 2] = [HalfRule::Bisector, HalfRule::RightAngle];

    fn brute_force(points: &PointSet, rule: HalfRule) -> Vec<Neighbours> {
        let closest = |s: DVec2, wanted: &dyn Fn(DVec2) -> bool| {
            points
                .ids()
                .filter(|&q| points[q] != s && wanted(points[q]))
                .min_by(|&p, &q| {
                    let (p, q) = (points[p], points[q]);
                    (p - s)
                        .length_squared()
                        .total_cmp(&(q - s).length_squared())
                        .then(by_coordinates(p, q))
                })
        };
        let of = |&s: &DVec2| {
            let nearest = closest(s, &|_| true);
            let half = nearest.and_then(|n0| {
                let plane = HalfPlane::new(rule, s, points[n0]);
                closest(s, &|q| plane.contains(q))
            });
            Neighbours { nearest, half }
        };
        points.points().iter().map(of).collect()
    }

    /// Points on small grids (many ties and collinear runs), anywhere, and far outliers.
    fn point_sets() -> impl Strategy<Value = PointSet> {
        let grid = (-6i32..6, -6i32..6).prop_map(|(x, y)| DVec2::new(x.into(), y.into()));
        let anywhere = (-6f64..6.0, -6f64..6.0).prop_map(|(x, y)| DVec2::new(x, y));
        let far = (-1e9f64..1e9, -1e9f64..1e9).prop_map(|(x, y)| DVec2::new(x, y));
        let point = prop_oneof![6 => grid, 3 => anywhere, 1 => far];
        prop::collection::vec(point, 0..120)
            .prop_map(|p| PointSet::merging_duplicates(p).unwrap().points)
    }

    /// Ties on a grid, a spiral down to 2^-60, a distant cluster and a far outlier: several levels
    /// of the tree, of keys and of everything that is not certain at first.
    fn uneven_points() -> PointSet {
        let grid = (0..900).map(|i| DVec2::new(f64::from(i % 30), f64::from(i / 30)));
        let spiral = (0..1500).map(|i| {
            let turn = f64::from(i) * 0.04;
            DVec2::from_angle(turn) * (-turn * 0.7).exp2() * 8.0 - 20.0
        });
        let cluster = (0..400).map(|i| {
            let i = f64::from(i);
            DVec2::new((i * 0.618).fract(), (i * 0.414).fract()) * 1e-6 + 1e3
        });
        let outlier = DVec2::new(-1e9, 1e8);
        let all = grid.chain(spiral).chain(cluster).chain([outlier]);
        PointSet::merging_duplicates(all.collect()).unwrap().points
    }

    #[test]
    fn density_and_threads_do_not_matter() {
        let points = uneven_points();
        for rule in RULES {
            let expected = brute_force(&points, rule);
            for threads in [1, 3] {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
                let found = pool.build().unwrap().install(|| neighbours(&points, rule));
                assert_eq!(found, expected);
            }
        }
    }

    proptest! {
        #[test]
        fn equals_brute_force(points in point_sets()) {
            for rule in RULES {
                prop_assert_eq!(neighbours(&points, rule), brute_force(&points, rule));
            }
        }

        #[test]
        fn scale_shift_and_order_do_not_matter(points in point_sets()) {
            let moved = |f: &dyn Fn(DVec2) -> DVec2| {
                PointSet::new(points.points().iter().map(|&p| f(p)).collect()).unwrap()
            };
            let scaled = moved(&|p| p * 2f64.powi(-90));
            let reversed = PointSet::new(points.points().iter().rev().copied().collect()).unwrap();
            let last = u32::try_from(points.len()).unwrap().wrapping_sub(1);
            let back = |id: PointId| PointId::from(last - u32::from(id));
            for rule in RULES {
                let found = neighbours(&points, rule);
                prop_assert_eq!(&neighbours(&scaled, rule), &found);
                let from_reversed: Vec<Neighbours> = neighbours(&reversed, rule)
                    .into_iter()
                    .rev()
                    .map(|n| Neighbours { nearest: n.nearest.map(back), half: n.half.map(back) })
                    .collect();
                prop_assert_eq!(from_reversed, found);
            }
        }
    }
}
