//! The shortest tour by dynamic programming: M. Held, R. M. Karp, "A Dynamic Programming Approach
//! to Sequencing Problems", 1962.

use curvecrust_geometry::{DVec2, EdgeSet, PointSet, orient2d};
use curvecrust_reconstruct::{Known, Reconstructor, ShortestTour, is_shortest_tour, shortest_tour};

/// So many points at most are looked through.
const MOST: usize = 13;

pub(crate) fn length(points: &PointSet, edges: &EdgeSet) -> f64 {
    let ends = edges.edges().iter().map(|edge| edge.ends());
    ends.map(|[p, q]| points[p].distance(points[q])).sum()
}

/// The length of the shortest path through all points from the first to each.
fn shortest_paths(points: &[DVec2]) -> Vec<f64> {
    let count = points.len();
    let mut best = vec![vec![f64::INFINITY; count]; 1 << count];
    best[1][0] = 0.0;
    for set in 1..1_usize << count {
        for last in (0..count).filter(|v| set >> v & 1 == 1) {
            let so_far = best[set][last];
            for next in (0..count).filter(|v| set >> v & 1 == 0) {
                let with = &mut best[set | 1 << next][next];
                *with = with.min(so_far + points[last].distance(points[next]));
            }
        }
    }
    best.pop().unwrap()
}

/// Whether a tour visits all points and, of few of them, is the shortest.
pub(crate) fn fault(points: &PointSet, edges: &EdgeSet) -> Option<String> {
    let all = points.points();
    let on_a_line = all.len() < 3 || all.iter().all(|&p| orient2d(all[0], all[1], p) == 0.0);
    let chains = edges.chains();
    let is_one = chains.len() == usize::from(all.len() > 1)
        && edges.isolated().len() == usize::from(all.len() == 1);
    let is_closed = chains.iter().all(|chain| chain.is_closed() != on_a_line);
    if !is_one || !is_closed || edges.degrees().iter().any(|&degree| degree > 2) {
        return Some(format!("no tour: {edges:?}"));
    }
    if on_a_line || all.len() > MOST {
        return None;
    }
    let paths = shortest_paths(all);
    let back = (1..all.len()).map(|v| paths[v] + all[v].distance(all[0]));
    let (least, found) = (back.fold(f64::INFINITY, f64::min), length(points, edges));
    (found > least * (1.0 + 1e-12)).then(|| format!("{found} instead of {least}"))
}

/// The shortest open path through all points.
#[test]
fn open_tours_are_the_shortest() {
    let mut random = curvecrust_geometry::Random::new(7);
    for count in [2, 3, 5, 8, 11] {
        for _ in 0..20 {
            let places = (0..count).map(|_| DVec2::new(random.unit(), random.unit()));
            let points = PointSet::new(places.collect()).unwrap();
            let found = ShortestTour
                .reconstruct_known(&points, &Known::ONE_OPEN_CURVE)
                .unwrap();
            let least = points.ids().map(|first| {
                let mut all = points.points().to_vec();
                all.swap(0, first.index());
                shortest_paths(&all)
                    .into_iter()
                    .fold(f64::INFINITY, f64::min)
            });
            let least = least.fold(f64::INFINITY, f64::min);
            assert!(
                (length(&points, &found) - least).abs() < 1e-12,
                "{points:?}"
            );
        }
    }
}

/// A proof is never given for a longer tour.
#[test]
fn proofs_are_for_the_shortest() {
    let mut random = curvecrust_geometry::Random::new(3);
    let mut proven = 0;
    for _ in 0..100 {
        let places = (0..9).map(|_| DVec2::new(random.unit(), random.unit()));
        let points = PointSet::new(places.collect()).unwrap();
        let tour = shortest_tour(&points);
        proven += usize::from(is_shortest_tour(&points, &tour));
        // One that crosses, or goes elsewhere.
        let ids: Vec<_> = points.ids().collect();
        let around =
            (0..9).filter_map(|i| curvecrust_geometry::Edge::new(ids[i], ids[(i + 1) % 9]));
        let other = EdgeSet::new(9, around);
        assert!(other == tour || !is_shortest_tour(&points, &other));
    }
    assert!(proven >= 80, "{proven}");
}
