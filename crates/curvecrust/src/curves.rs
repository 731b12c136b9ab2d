//! Points in, ordered curves out.

use crate::error::Error;
use crate::geometry::{PointId, PointSet};
use crate::points::IntoPoint;
use crate::reconstruct::{Known, LeastDetour, NestedChain, Reconstruction, Reconstructor, Shape};
use glam::DVec2;
use std::num::NonZeroU32;

/// The curves that some points come from: each an open or a closed polyline through points in
/// order.
///
/// Indices are positions in the input, so that other data of a point can be found again. The order
/// of the points changes nothing but these indices.
///
/// ```
/// use curvecrust::{DVec2, reconstruct};
/// use std::f64::consts::TAU;
///
/// // Two rings, one inside the other, and a stroke that is not in order.
/// let ring = |n: u32, radius: f64| {
///     (0..n).map(move |i| radius * DVec2::from_angle(f64::from(i) * TAU / f64::from(n)))
/// };
/// let stroke = [9.0, 11.0, 10.0].map(|x| DVec2::new(x, 0.0));
/// let points: Vec<DVec2> = ring(8, 2.0).chain(ring(20, 6.0)).chain(stroke).collect();
/// let curves = reconstruct(&points)?;
/// let [inner, outer, open] = curves.polylines() else { panic!("three curves") };
/// assert_eq!((inner.nesting(), outer.nesting(), open.nesting()), (Some(1), Some(0), None));
/// assert_eq!(inner.indices(), [0, 1, 2, 3, 4, 5, 6, 7]);
/// assert_eq!(open.indices(), [28, 30, 29]);
/// assert_eq!(open.points()[1], points[30]);
/// assert_eq!(curves.leaves(), [28, 29]);
/// # Ok::<(), curvecrust::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Curves {
    polylines: Vec<Polyline>,
    edges: Vec<[usize; 2]>,
    leaves: Vec<usize>,
    isolated: Vec<usize>,
    junctions: Vec<usize>,
    duplicates: Vec<[usize; 2]>,
}

/// Points in order along one curve.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Polyline {
    points: Vec<DVec2>,
    indices: Vec<usize>,
    closed: bool,
    nesting: Option<u32>,
    parent: Option<usize>,
}

/// Options of [`reconstruct_with`]; the defaults are those of [`reconstruct`].
///
/// ```
/// use curvecrust::reconstruct::HnnCrust;
/// use curvecrust::{ReconstructOptions, reconstruct_with};
///
/// let twice = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0]];
/// assert!(curvecrust::reconstruct(twice).is_err());
/// let options = ReconstructOptions {
///     algorithm: &HnnCrust::MUTUAL,
///     merge_duplicates: true,
///     ..Default::default()
/// };
/// let curves = reconstruct_with(twice, &options)?;
/// assert_eq!(curves.polylines()[0].indices(), [0, 1, 2]);
/// assert_eq!(curves.duplicates(), [[3, 1]]);
/// # Ok::<(), curvecrust::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ReconstructOptions<'a> {
    /// The algorithm: least detour unless another is named.
    pub algorithm: &'a dyn Reconstructor,
    /// Whether all curves are known to be closed, or all to be open.
    pub shape: Option<Shape>,
    /// How many curves there are known to be. They then go through all points.
    pub curves: Option<NonZeroU32>,
    /// Indices of points that are known to be ends of open curves.
    pub termini: &'a [usize],
    /// Whether equal points count as one, which the first of them stands for. Otherwise they are an
    /// error.
    pub merge_duplicates: bool,
    /// A distance within which points count as one, if any; 0 is for equal points. The points that
    /// stay are farther apart ([`PointSet::merging_within`]).
    pub merge_within: Option<f64>,
}

impl Default for ReconstructOptions<'_> {
    fn default() -> Self {
        Self {
            algorithm: &LeastDetour,
            shape: None,
            curves: None,
            termini: &[],
            merge_duplicates: false,
            merge_within: None,
        }
    }
}

/// Orders points into the curves that they come from, open and closed, by the default algorithm,
/// [least detour](mod@crate::reconstruct::least_detour).
///
/// It takes anything that iterates over points, see [`IntoPoint`]. It needs no parameter: it finds
/// how many curves there are and which of them are closed. No points give no curves.
///
/// ```
/// let points = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
/// for curve in curvecrust::reconstruct(points)? {
///     let kind = if curve.is_closed() { "closed" } else { "open" };
///     println!("{kind}: {:?}", curve.points());
/// }
/// # assert!(curvecrust::reconstruct(points)?.polylines()[0].is_closed());
/// # Ok::<(), curvecrust::Error>(())
/// ```
///
/// # Errors
/// [`Error::Points`] for coordinates that are not finite or out of range, and for equal points; it
/// names the index. [`ReconstructOptions::merge_duplicates`] takes equal points as one.
pub fn reconstruct<P: IntoPoint>(points: impl IntoIterator<Item = P>) -> Result<Curves, Error> {
    reconstruct_with(points, &ReconstructOptions::default())
}

/// [`reconstruct`] with options: the algorithm, what is known about the curves, equal points.
///
/// # Errors
/// Those of [`reconstruct`]; [`Error::NoSuchPoint`] for a terminus that is no point;
/// [`Error::Reconstruct`] for knowledge that the algorithm cannot use or the points contradict.
pub fn reconstruct_with<P: IntoPoint>(
    points: impl IntoIterator<Item = P>,
    options: &ReconstructOptions<'_>,
) -> Result<Curves, Error> {
    let points = points.into_iter().map(IntoPoint::into_point).collect();
    let input = Input::new(points, options)?;
    let known = Known {
        shape: options.shape,
        curves: options.curves,
        termini: input.ids_of(options.termini)?,
    };
    let found = Reconstruction::by_known(options.algorithm, &input.points, &known)?;
    Ok(Curves::new(&input, &found))
}

/// The points that are reconstructed, and their positions in the input.
struct Input {
    points: PointSet,
    /// The index of every point; empty where nothing was merged.
    indices: Vec<usize>,
    /// The point of every index; empty where nothing was merged.
    ids: Vec<PointId>,
}

impl Input {
    fn new(points: Vec<DVec2>, options: &ReconstructOptions<'_>) -> Result<Self, Error> {
        let merged = match (options.merge_within, options.merge_duplicates) {
            (Some(distance), _) => PointSet::merging_within(points, distance)?,
            (None, true) => PointSet::merging_duplicates(points)?,
            (None, false) => {
                return Ok(Self {
                    points: PointSet::new(points)?,
                    indices: Vec::new(),
                    ids: Vec::new(),
                });
            }
        };
        Ok(Self {
            points: merged.points,
            indices: merged.origin,
            ids: merged.representative,
        })
    }

    fn index(&self, id: PointId) -> usize {
        self.indices.get(id.index()).copied().unwrap_or(id.index())
    }

    fn indices(&self, ids: &[PointId]) -> Vec<usize> {
        ids.iter().map(|&id| self.index(id)).collect()
    }

    fn ids_of(&self, indices: &[usize]) -> Result<Vec<PointId>, Error> {
        let count = self.points.len().max(self.ids.len());
        let id = |&index: &usize| {
            if index >= count {
                return Err(Error::NoSuchPoint { index, count });
            }
            let id = self.ids.get(index).copied().or(PointId::new(index));
            id.ok_or(Error::NoSuchPoint { index, count })
        };
        indices.iter().map(id).collect()
    }

    /// Pairs of an index and the index of the point that stands for it.
    fn duplicates(&self) -> Vec<[usize; 2]> {
        let places = self.ids.iter().enumerate();
        let pairs = places.map(|(index, &id)| [index, self.index(id)]);
        pairs.filter(|[index, first]| index != first).collect()
    }
}

impl Curves {
    fn new(input: &Input, found: &Reconstruction) -> Self {
        let polyline = |nested: &NestedChain| Polyline::new(input, nested);
        let edges = found.edges().edges().iter();
        Self {
            polylines: found.chains().iter().map(polyline).collect(),
            edges: edges
                .map(|edge| edge.ends().map(|v| input.index(v)))
                .collect(),
            leaves: input.indices(&found.leaves()),
            isolated: input.indices(&found.isolated()),
            junctions: input.indices(&found.junctions()),
            duplicates: input.duplicates(),
        }
    }

    /// The curves, by the smallest index of a closed one and of the ends of an open one.
    #[must_use]
    pub fn polylines(&self) -> &[Polyline] {
        &self.polylines
    }

    /// The number of curves.
    #[must_use]
    pub fn len(&self) -> usize {
        self.polylines.len()
    }

    /// Whether there is no curve: all points are isolated, or there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.polylines.is_empty()
    }

    /// The curves, in order.
    pub fn iter(&self) -> std::slice::Iter<'_, Polyline> {
        self.polylines.iter()
    }

    /// Every edge once, as the indices of its ends, ascending.
    #[must_use]
    pub fn edges(&self) -> &[[usize; 2]] {
        &self.edges
    }

    /// The ends of open curves, ascending.
    #[must_use]
    pub fn leaves(&self) -> &[usize] {
        &self.leaves
    }

    /// The points that are on no curve, ascending.
    #[must_use]
    pub fn isolated(&self) -> &[usize] {
        &self.isolated
    }

    /// The points where three edges or more meet, ascending: none by the default algorithm.
    #[must_use]
    pub fn junctions(&self) -> &[usize] {
        &self.junctions
    }

    /// The points that equal an earlier one and were merged into it, with that one, ascending.
    #[must_use]
    pub fn duplicates(&self) -> &[[usize; 2]] {
        &self.duplicates
    }
}

impl IntoIterator for Curves {
    type Item = Polyline;
    type IntoIter = std::vec::IntoIter<Polyline>;

    fn into_iter(self) -> Self::IntoIter {
        self.polylines.into_iter()
    }
}

impl<'a> IntoIterator for &'a Curves {
    type Item = &'a Polyline;
    type IntoIter = std::slice::Iter<'a, Polyline>;

    fn into_iter(self) -> Self::IntoIter {
        self.polylines.iter()
    }
}

impl Polyline {
    fn new(input: &Input, nested: &NestedChain) -> Self {
        let vertices = nested.chain.vertices();
        Self {
            points: vertices.iter().map(|&v| input.points[v]).collect(),
            indices: input.indices(vertices),
            closed: nested.chain.is_closed(),
            nesting: nested.nesting,
            parent: nested.parent,
        }
    }

    /// The points in order. A closed curve runs counter-clockwise and does not repeat its first
    /// point.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The indices of these points in the input.
    #[must_use]
    pub fn indices(&self) -> &[usize] {
        &self.indices
    }

    /// Whether an edge leads from the last point back to the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// How many other closed curves surround a closed one: 0 on the outside, 1 for a hole, 2 for an
    /// island in a hole. `None` for an open curve.
    #[must_use]
    pub fn nesting(&self) -> Option<u32> {
        self.nesting
    }

    /// The closed curve right around a closed one, as a position in [`Curves::polylines`]. `None`
    /// on the outside and for an open curve.
    #[must_use]
    pub fn parent(&self) -> Option<usize> {
        self.parent
    }
}

impl AsRef<[DVec2]> for Polyline {
    fn as_ref(&self) -> &[DVec2] {
        &self.points
    }
}
