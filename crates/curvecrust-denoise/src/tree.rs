//! The points near a place.

use glam::DVec2;
use rstar::RTree;
use rstar::primitives::GeomWithData;

/// An index of points; what it gives back are their positions in the slice.
pub(crate) struct Tree(RTree<GeomWithData<[f64; 2], usize>>);

impl Tree {
    pub(crate) fn new(points: &[DVec2]) -> Self {
        let item = |(i, p): (usize, &DVec2)| GeomWithData::new(p.to_array(), i);
        Self(RTree::bulk_load(
            points.iter().enumerate().map(item).collect(),
        ))
    }

    /// The nearest point; `None` without points.
    pub(crate) fn nearest_one(&self, p: DVec2) -> Option<usize> {
        let found = self.0.nearest_neighbor(p.to_array());
        found.map(|item| item.data)
    }

    /// The points by ascending distance, each with the square of it.
    pub(crate) fn nearest(&self, p: DVec2) -> impl Iterator<Item = (usize, f64)> + '_ {
        let found = self.0.nearest_neighbor_iter_with_distance_2(p.to_array());
        found.map(|(item, squared)| (item.data, squared))
    }

    /// The points within a distance, ascending by position: sums over them do not depend on how
    /// the tree was built.
    pub(crate) fn within(&self, p: DVec2, distance: f64) -> Vec<usize> {
        let found = self
            .0
            .locate_within_distance(p.to_array(), distance * distance);
        let mut found: Vec<usize> = found.map(|item| item.data).collect();
        found.sort_unstable();
        found
    }
}
