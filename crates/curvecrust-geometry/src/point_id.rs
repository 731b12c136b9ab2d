//! Names of points: their indices, in a type of their own.

use std::fmt;

/// Index of a point in its [`PointSet`](crate::PointSet), and of the vertex of the same name in an
/// edge set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(transparent)
)]
pub struct PointId(u32);

impl PointId {
    /// The id of the point at `index`; `None` past the 2^32 - 1 points that a set can hold.
    #[must_use]
    pub fn new(index: usize) -> Option<Self> {
        u32::try_from(index)
            .ok()
            .filter(|&i| i < u32::MAX)
            .map(Self)
    }

    /// The position of the point in its set.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl From<u32> for PointId {
    fn from(index: u32) -> Self {
        Self(index)
    }
}

impl From<PointId> for u32 {
    fn from(id: PointId) -> Self {
        id.0
    }
}

impl From<PointId> for usize {
    fn from(id: PointId) -> Self {
        id.index()
    }
}

impl fmt::Display for PointId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
