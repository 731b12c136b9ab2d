//! A spatial index of Voronoi vertices whose places keep their digits at every scale.
//!
//! A place is a coordinate as seen from an origin, so it has no digits below 2^-53 of its distance
//! to the origin. Vertices of triangles that are much smaller than that distance are therefore
//! grouped by place, and each group has a frame of its own, with an origin in the group. Groups are
//! nested as deep as the range of the coordinates demands. Usually there are none.

use std::ops::ControlFlow;

use curvecrust_geometry::DVec2;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::voronoi_vertex::VoronoiVertex;

/// A triangle is fine if its circumradius is less than this fraction of the distance to the origin.
const FINE: f64 = f64::from_bits((1023 - 30) << 52);

/// The size of the cells by which fine triangles are grouped, as an exponent of two relative to the
/// distance to the origin.
const CELL: i32 = -25;

/// Up to this many fine triangles of a cell need no group.
const FEW: usize = 8;

/// A vertex by its index, at its place in a frame.
type Place = GeomWithData<[f64; 2], usize>;

/// Vertices as seen from an origin.
pub(crate) struct Frame {
    origin: DVec2,
    places: RTree<Place>,
    groups: Vec<Self>,
    /// The rectangles hold the places of all vertices of a group, which is given by its index.
    boxes: RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>,
}

impl Frame {
    /// Of some of the vertices, by their indices.
    pub(crate) fn new(vertices: &[VoronoiVertex], members: Vec<usize>) -> Self {
        let origin = members.first().map(|&first| vertices[first].corner());
        let origin = origin.unwrap_or_default();
        let mut places = Vec::with_capacity(members.len());
        let mut fine = Vec::new();
        for index in members {
            let place = vertices[index].position(origin);
            let item = Place::new(place.into(), index);
            if vertices[index].size() < FINE * place.abs().max_element() {
                fine.push((cell(place), item));
            } else {
                places.push(item);
            }
        }
        fine.sort_unstable_by_key(|&(cell, item)| (cell, item.data));
        let (mut groups, mut boxes) = (Vec::new(), Vec::new());
        for group in fine.chunk_by(|(a, _), (b, _)| a == b) {
            let items = group.iter().map(|&(_, item)| item);
            if group.len() <= FEW {
                places.extend(items);
            } else {
                boxes.push(GeomWithData::new(bounds(items.clone()), groups.len()));
                // The origin has to be in the group, where some triangle is not fine, so that
                // nesting ends.
                groups.push(Self::new(vertices, items.map(|item| item.data).collect()));
            }
        }
        Self {
            origin,
            places: RTree::bulk_load(places),
            groups,
            boxes: RTree::bulk_load(boxes),
        }
    }

    /// Visits all vertices in a disc, and perhaps a few around it, until `visit` breaks.
    ///
    /// `disc` gives its centre as seen from an origin and its squared radius; `None` beyond the
    /// range of doubles.
    pub(crate) fn in_disc<'v>(
        &self,
        vertices: &'v [VoronoiVertex],
        disc: &impl Fn(DVec2) -> Option<(DVec2, f64)>,
        visit: &mut impl FnMut(&'v VoronoiVertex) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let Some((centre, radius_squared)) = disc(self.origin) else {
            // A disc too large for a tree holds them all.
            for place in &self.places {
                visit(&vertices[place.data])?;
            }
            for group in &self.groups {
                group.in_disc(vertices, disc, visit)?;
            }
            return ControlFlow::Continue(());
        };
        self.places
            .locate_within_distance(centre.into(), radius_squared)
            .try_for_each(|place| visit(&vertices[place.data]))?;
        if self.groups.is_empty() {
            return ControlFlow::Continue(());
        }
        let radius = DVec2::splat(radius_squared.sqrt());
        let around = AABB::from_corners((centre - radius).into(), (centre + radius).into());
        self.boxes
            .locate_in_envelope_intersecting(around)
            .try_for_each(|group| self.groups[group.data].in_disc(vertices, disc, visit))
    }
}

/// The rectangle that holds all of some places.
fn bounds(items: impl Iterator<Item = Place>) -> Rectangle<[f64; 2]> {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let places = items.map(|item| DVec2::from(*item.geom()));
    let (low, high) = places.fold(empty, |(low, high), p| (low.min(p), high.max(p)));
    Rectangle::from_corners(low.into(), high.into())
}

/// The cell of a place that is not the origin: its size is relative to the larger coordinate.
fn cell(place: DVec2) -> (i32, i64, i64) {
    let biased = place.abs().max_element().to_bits() >> 52;
    let exponent = i32::try_from(biased).unwrap_or(0) - 1022;
    let unit = 2f64.powi(exponent + CELL);
    #[expect(clippy::cast_possible_truncation, reason = "at most 2^25 units")]
    let at = |x: f64| (x / unit).floor() as i64;
    (exponent, at(place.x), at(place.y))
}
