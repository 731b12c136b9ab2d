//! The pairs of points that a search tries to join.

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, PointSet};
use curvecrust_voronoi::Delaunay;

use super::around::in_quadrants;
use crate::adjacency::Adjacency;
use crate::held_karp::Link;

/// So many Delaunay neighbours are tried, the nearest.
const ADJACENT: usize = 12;

/// So many points are tried altogether, the nearest of those at most two Delaunay edges away.
const NEAREST: usize = 10;

/// For every point others that it may be joined to, the nearest first: its Delaunay neighbours, and
/// the nearest of theirs, for where the right edge is none of the triangulation.
pub(crate) struct Near {
    targets: Adjacency,
}

impl Near {
    pub(crate) fn new(points: &PointSet, delaunay: &Delaunay) -> Self {
        let edges: Vec<[u32; 2]> = delaunay
            .edges()
            .map(|dual| dual.ends.map(u32::from))
            .collect();
        let adjacent = Adjacency::new(points.len(), &edges);
        let places = points.points();
        let sort = |v: u32, list: &mut Vec<u32>| sort(places, v, list);
        let adjacent = Self::of_lists(points, |v| {
            let mut list = adjacent.of(v).to_vec();
            sort(v, &mut list);
            list.truncate(ADJACENT);
            list
        });
        let targets = Self::of_lists(points, |v| {
            let mut list = adjacent.of(v).to_vec();
            let mut around: Vec<u32> = list.iter().flat_map(|&w| adjacent.of(w)).copied().collect();
            around.retain(|&w| w != v && !list.contains(&w));
            sort(v, &mut around);
            around.truncate(NEAREST.saturating_sub(list.len()).max(NEAREST / 2));
            list.append(&mut around);
            sort(v, &mut list);
            list
        });
        Self { targets }
    }

    fn of_lists(points: &PointSet, of: impl Fn(u32) -> Vec<u32> + Sync + Send) -> Adjacency {
        let ids: Vec<u32> = points.ids().map(u32::from).collect();
        let lists: Vec<Vec<u32>> = ids.into_par_iter().map(of).collect();
        Adjacency::of_lists(&lists)
    }

    /// The pairs, each once.
    pub(crate) fn links(&self, points: &[DVec2]) -> Vec<Link> {
        let from = |v: u32| {
            let is_mutual = move |w: u32| self.of(w).contains(&v);
            let to = self.of(v).iter().copied();
            let first = to.filter(move |&w| v < w || !is_mutual(w));
            first.map(move |w| Link::new(points, [v, w]))
        };
        (0u32..).take(points.len()).flat_map(from).collect()
    }

    /// The same, and points on all sides, which may be far.
    pub(super) fn and_around(&self, points: &PointSet) -> Self {
        let mut lists = in_quadrants(points.points());
        for (v, list) in (0u32..).zip(&mut lists) {
            let near = self.of(v);
            list.retain(|w| !near.contains(w));
            list.sort_unstable();
            list.dedup();
            list.splice(..0, near.iter().copied());
        }
        Self::of_own(&lists)
    }

    /// For each point those that are beside it in one of the tours, the nearest first.
    pub(super) fn in_tours(tours: &[Vec<u32>], points: &[DVec2]) -> Self {
        let mut lists = vec![Vec::new(); points.len()];
        for tour in tours {
            let next = tour.iter().cycle().skip(1);
            for (&v, &w) in tour.iter().zip(next) {
                lists[v as usize].push(w);
                lists[w as usize].push(v);
            }
        }
        for (v, list) in (0u32..).zip(&mut lists) {
            sort(points, v, list);
        }
        Self::of_own(&lists)
    }

    /// Of a list for each point.
    pub(super) fn of_own(lists: &[Vec<u32>]) -> Self {
        Self {
            targets: Adjacency::of_lists(lists),
        }
    }

    /// Nothing for gaps.
    pub(crate) fn of(&self, v: u32) -> &[u32] {
        self.targets.of(v)
    }
}

/// Sorts a list of points near one, the nearest first, and leaves each in it once.
fn sort(places: &[DVec2], v: u32, list: &mut Vec<u32>) {
    let at = places[v as usize];
    list.sort_unstable_by(|&p, &q| {
        let [p, q] = [p, q].map(|id| places[id as usize]);
        let distances = [p, q].map(|p| at.distance_squared(p));
        distances[0]
            .total_cmp(&distances[1])
            .then(by_coordinates(p, q))
    });
    list.dedup();
}
