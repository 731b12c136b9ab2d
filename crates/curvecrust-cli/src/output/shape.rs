//! What a result is made of, borrowed from where it is kept: of ten million points no copy is made.

use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet, Segment};
use serde::ser::{Serialize, Serializer};
use std::borrow::Cow;

/// Places in order.
#[derive(Clone, Debug)]
pub(crate) struct Places<'a> {
    points: &'a [DVec2],
    /// Which of them; all, if `None`.
    ids: Option<Cow<'a, [PointId]>>,
}

/// A shape and what is known about it.
#[derive(Debug)]
pub(crate) struct Feature<'a, P> {
    pub(crate) shape: Shape<'a>,
    pub(crate) properties: P,
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
        Self { points, ids: None }
    }

    pub(crate) fn named(points: &'a PointSet, ids: impl Into<Cow<'a, [PointId]>>) -> Self {
        Self {
            points: points.points(),
            ids: Some(ids.into()),
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.ids.as_ref().map_or(self.points.len(), |ids| ids.len())
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = DVec2> + Clone + '_ {
        (0..self.len()).map(|i| match &self.ids {
            Some(ids) => self.points[ids[i].index()],
            None => self.points[i],
        })
    }

    /// All, and the first again.
    pub(crate) fn closed(&self) -> impl Iterator<Item = DVec2> + Clone + '_ {
        self.iter().chain(self.iter().take(1))
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
