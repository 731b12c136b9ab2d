//! alpha-shape: H. Edelsbrunner, D. Kirkpatrick, R. Seidel, "On the Shape of a Set of Points in the
//! Plane", IEEE Transactions on Information Theory 29(4), 1983.
//!
//! Two points are joined if a disc of radius alpha touches both and holds no point. Among Delaunay
//! edges: if alpha is between the least and the largest radius of the discs about their Voronoi
//! edge, `min h^2 + t^2 <= alpha^2 <= max h^2 + t^2` for t in [t1, t2].
//!
//! Right for a closed curve whose samples are spaced evenly, less than 2 alpha, with alpha below
//! the least lfs: one alpha for all, so it fails where density varies. Cost: that of the Delaunay
//! triangulation, O(n log n).

use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::algorithm::{AlgorithmInfo, Reconstructor, Scope};
use crate::delaunay_edges::{has_length, is_gabriel_edge};
use crate::error::ReconstructError;
use crate::parameter::parameter;
use crate::voronoi_vertex::VoronoiVertex;

/// The radius of an alpha-shape: finite and above 0.
///
/// ```
/// use curvecrust_reconstruct::Alpha;
///
/// assert_eq!(Alpha::new(0.5)?.get(), 0.5);
/// assert!(Alpha::new(0.0).is_err());
/// # Ok::<(), curvecrust_reconstruct::ReconstructError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Alpha(f64);

impl Alpha {
    /// Checks a radius.
    ///
    /// # Errors
    /// [`Alpha`](ReconstructError::Alpha) if it is not above 0, infinite or not a number.
    pub fn new(alpha: f64) -> Result<Self, ReconstructError> {
        if alpha > 0.0 && alpha.is_finite() {
            Ok(Self(alpha))
        } else {
            Err(ReconstructError::Alpha { alpha })
        }
    }

    /// Of the radii at which an edge appears, the one at which the fewest points have other than
    /// two edges; the smallest of several. `None` without an edge.
    ///
    /// On evenly sampled closed curves no point is left without its two edges. Cost: O(n log n).
    #[must_use]
    pub fn of(points: &PointSet) -> Option<Self> {
        Shapes::new(points).own_alpha().map(Self)
    }
}

parameter!(Alpha);

/// The edges of the alpha-shape, by radii in floating point.
///
/// Alpha counts as a little more than it is: at the radius of the circle around a triangle some
/// edges appear and others vanish, and never are both there.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{Alpha, alpha_shape};
///
/// let ring = (0..40).map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 40.0));
/// let points = PointSet::new(ring.collect())?;
/// assert_eq!(alpha_shape(&points, Alpha::new(0.3)?).len(), 40);
/// assert_eq!(alpha_shape(&points, Alpha::new(0.01)?).len(), 0);
/// let own = Alpha::of(&points).ok_or("no edge")?;
/// assert_eq!(alpha_shape(&points, own).degrees(), [2; 40]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn alpha_shape(points: &PointSet, alpha: Alpha) -> EdgeSet {
    Shapes::new(points).at(alpha.0)
}

/// An edge, and the radii of the empty discs that touch both its ends.
struct Radii {
    ends: [PointId; 2],
    least: f64,
    largest: f64,
}

fn radii(points: &PointSet) -> Vec<Radii> {
    let delaunay = Delaunay::new(points);
    let radius: Vec<f64> = delaunay
        .triangles()
        .map(|triangle| VoronoiVertex::new(points, triangle).radius())
        .collect();
    let of = |dual: DualEdge| {
        let [p, q] = dual.ends;
        let [left, right] = dual.triangles.map(|t| t.map(|t| radius[t]));
        let bounded = || [left, right].into_iter().flatten();
        let half = points[p].distance(points[q]) / 2.0;
        Radii {
            ends: dual.ends,
            least: if is_gabriel_edge(points, &dual) {
                half
            } else {
                bounded().fold(f64::INFINITY, f64::min).max(half)
            },
            largest: match [left, right] {
                [Some(left), Some(right)] => left.max(right).max(half),
                _ => f64::INFINITY,
            },
        }
    };
    delaunay
        .edges()
        .filter(|dual| has_length(points, dual))
        .map(of)
        .collect()
}

/// The shapes of some points, one for each alpha.
struct Shapes {
    radii: Vec<Radii>,
    /// What the caller calls the points.
    ids: Vec<PointId>,
}

impl Shapes {
    fn new(points: &PointSet) -> Self {
        let (points, ids) = points.in_hilbert_order();
        let radii = radii(&points);
        Self { radii, ids }
    }

    fn at(&self, alpha: f64) -> EdgeSet {
        let radii = self.radii.iter();
        let kept = radii.filter(|edge| edge.least <= alpha && alpha < edge.largest);
        let named = kept.filter_map(|edge| {
            let [p, q] = edge.ends.map(|v| self.ids[v.index()]);
            Edge::new(p, q)
        });
        EdgeSet::new(self.ids.len(), named)
    }

    /// Alpha grows past the radii at which edges appear and, behind them, disappear.
    fn own_alpha(&self) -> Option<f64> {
        let sorted_by = |key: fn(&Radii) -> f64| {
            let radii = self.radii.iter();
            let mut order: Vec<_> = radii.map(|edge| (key(edge), edge.ends)).collect();
            order.sort_unstable_by(|a: &(f64, _), b| a.0.total_cmp(&b.0));
            order
        };
        let appear = sorted_by(|edge| edge.least);
        let mut vanish = sorted_by(|edge| edge.largest).into_iter().peekable();
        let mut degrees = Degrees::new(self.ids.len());
        let mut best: Option<(usize, f64)> = None;
        #[expect(clippy::float_cmp, reason = "edges that appear at the same radius")]
        for together in appear.chunk_by(|a, b| a.0 == b.0) {
            let alpha = together[0].0;
            for &(_, ends) in together {
                degrees.change(ends, 1);
            }
            while let Some((_, ends)) = vanish.next_if(|&(largest, _)| largest <= alpha) {
                degrees.change(ends, -1);
            }
            if best.is_none_or(|(wrong, _)| degrees.wrong < wrong) {
                best = Some((degrees.wrong, alpha));
            }
        }
        best.map(|(_, alpha)| alpha)
    }
}

/// The number of edges at each point.
struct Degrees {
    of: Vec<i32>,
    /// How many are not 2.
    wrong: usize,
}

impl Degrees {
    fn new(count: usize) -> Self {
        Self {
            of: vec![0; count],
            wrong: count,
        }
    }

    fn change(&mut self, ends: [PointId; 2], by: i32) {
        for end in ends {
            let degree = &mut self.of[end.index()];
            self.wrong += usize::from(*degree == 2);
            *degree += by;
            self.wrong -= usize::from(*degree == 2);
        }
    }
}

/// The alpha-shape behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlphaShape {
    /// Its radius; `None` for the one that the points suggest: [`Alpha::of`].
    pub alpha: Option<Alpha>,
}

impl AlphaShape {
    /// The one with the radius that the points suggest.
    pub const OWN: Self = Self { alpha: None };
}

impl Reconstructor for AlphaShape {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            scope: Scope::CLOSED,
            ..AlgorithmInfo::new(
                "alpha-shape",
                "Edelsbrunner, Kirkpatrick, Seidel: On the Shape of a Set of Points in the Plane. \
                 1983",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        let shapes = Shapes::new(points);
        let alpha = self.alpha.map(Alpha::get);
        // Without an edge there is no alpha, and any will do.
        shapes.at(alpha.or_else(|| shapes.own_alpha()).unwrap_or_default())
    }
}
