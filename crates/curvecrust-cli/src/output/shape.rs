//! What a result is made of, borrowed from where it is kept: of ten million points no copy is made.

use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet, Segment};
use serde::ser::{Serialize, Serializer};
use std::borrow::Cow;

/// A place in the plane, and its height where heights are kept.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Position {
    pub(crate) place: DVec2,
    pub(crate) height: Option<f64>,
}

/// Places in order.
#[derive(Clone, Debug)]
pub(crate) struct Places<'a> {
    points: &'a [DVec2],
    /// The height of every point, where heights are kept.
    heights: Option<&'a [f64]>,
    /// Which of them; all, if `None`.
    ids: Option<Cow<'a, [PointId]>>,
}

/// A shape and what is known about it.
#[derive(Debug)]
pub(crate) struct Feature<'a, P> {
    pub(crate) shape: Shape<'a>,
    pub(crate) properties: P,
}

/// What is known about a shape, in the columns of a table.
pub(crate) trait Attributes {
    /// The names of the columns, and what they hold.
    const COLUMNS: &'static [(&'static str, Kind)];

    /// A value for each column.
    fn values(&self) -> Vec<Attribute>;
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Word,
    Whole,
    Real,
}

/// A value of the kind of its column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Attribute {
    Word(&'static str),
    /// `None` where there is no such number.
    Whole(Option<u32>),
    Real(f64),
}

/// What the formats know that know nothing but geometry.
#[derive(Debug)]
pub(crate) enum Shape<'a> {
    /// Rings, none of which repeats its first point: one outside, counter-clockwise, and holes.
    Polygon(Vec<Places<'a>>),
    /// One polyline.
    Line(Places<'a>),
    /// Points alone.
    Points(Places<'a>),
    /// Straight pieces, in no order.
    Segments(&'a [Segment]),
}

/// A sequence that is serialised item by item, without being collected.
pub(crate) struct Streamed<F>(pub(crate) F);

impl<'a> Places<'a> {
    pub(crate) fn all(points: &'a [DVec2]) -> Self {
        Self {
            points,
            heights: None,
            ids: None,
        }
    }

    pub(crate) fn named(points: &'a PointSet, ids: impl Into<Cow<'a, [PointId]>>) -> Self {
        Self {
            points: points.points(),
            heights: None,
            ids: Some(ids.into()),
        }
    }

    /// The same with the heights of all points, if those are kept.
    pub(crate) fn at_heights(self, heights: Option<&'a [f64]>) -> Self {
        Self { heights, ..self }
    }

    /// Whether the places have heights.
    pub(crate) fn has_heights(&self) -> bool {
        self.heights.is_some()
    }

    pub(crate) fn len(&self) -> usize {
        self.ids.as_ref().map_or(self.points.len(), |ids| ids.len())
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = DVec2> + Clone + '_ {
        self.positions().map(|position| position.place)
    }

    /// The places with their heights.
    pub(crate) fn positions(&self) -> impl Iterator<Item = Position> + Clone + '_ {
        (0..self.len()).map(|i| {
            let index = match &self.ids {
                Some(ids) => ids[i].index(),
                None => i,
            };
            Position {
                place: self.points[index],
                height: self.heights.map(|heights| heights[index]),
            }
        })
    }

    /// All, and the first again.
    pub(crate) fn closed(&self) -> impl Iterator<Item = Position> + Clone + '_ {
        self.positions().chain(self.positions().take(1))
    }
}

impl Shape<'_> {
    /// The number of its places.
    #[cfg(feature = "flatgeobuf")]
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Polygon(rings) => rings.iter().map(Places::len).sum(),
            Self::Line(places) | Self::Points(places) => places.len(),
            Self::Segments(segments) => 2 * segments.len(),
        }
    }

    /// Whether its places have heights.
    pub(crate) fn has_heights(&self) -> bool {
        match self {
            Self::Polygon(rings) => rings.iter().any(Places::has_heights),
            Self::Line(places) | Self::Points(places) => places.has_heights(),
            Self::Segments(_) => false,
        }
    }
}

impl Position {
    /// x, y and, where heights are kept, z.
    pub(crate) fn coordinates(self) -> impl Iterator<Item = f64> {
        self.place.to_array().into_iter().chain(self.height)
    }
}

impl From<DVec2> for Position {
    fn from(place: DVec2) -> Self {
        Self {
            place,
            height: None,
        }
    }
}

impl<F, I> Serialize for Streamed<F>
where
    F: Fn() -> I,
    I: Iterator<Item: Serialize>,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((self.0)())
    }
}
