//! Points with small integer coordinates, and exact answers about them.

use curvecrust_geometry::{DVec2, EdgeSet, PointId, PointSet, Random};

pub(crate) type Place = (i64, i64);

/// Scattered points, parts of a lattice, and runs on few lines.
pub(crate) fn random_places(kind: usize, seed: u64, most: usize) -> Vec<Place> {
    let mut random = Random::new(seed << 2 | kind as u64);
    let count = 3 + random.below(most - 2);
    let side = [1000, 2 + count / 4, 3 * count][kind];
    let mut places = Vec::new();
    while places.len() < count {
        let [x, y] = [random.below(side + 4), random.below(side + 4)];
        let place = match (kind, random.below(4)) {
            (2, 0) => (x, 0),
            (2, 1) => (0, y),
            (2, 2) => (x, x),
            (2, _) => (x, 1 + y % 2),
            _ => (x, y),
        };
        let place = (place.0 as i64, place.1 as i64);
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places
}

pub(crate) fn set(places: &[Place]) -> PointSet {
    #[expect(clippy::cast_precision_loss, reason = "small integers")]
    let points = places.iter().map(|&(x, y)| DVec2::new(x as f64, y as f64));
    PointSet::new(points.collect()).unwrap()
}

pub(crate) fn orientation(a: Place, b: Place, c: Place) -> i64 {
    ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum()
}

pub(crate) fn are_on_a_line(places: &[Place]) -> bool {
    places
        .windows(3)
        .all(|w| orientation(w[0], w[1], w[2]) == 0)
}

/// Whether a point lies on a closed segment.
pub(crate) fn is_on(p: Place, (a, b): (Place, Place)) -> bool {
    let is_between = |p: i64, a: i64, b: i64| a.min(b) <= p && p <= a.max(b);
    orientation(a, b, p) == 0 && is_between(p.0, a.0, b.0) && is_between(p.1, a.1, b.1)
}

/// Whether edges meet at common ends alone.
pub(crate) fn is_simple(places: &[Place], edges: &EdgeSet) -> bool {
    let edges: Vec<[usize; 2]> = edges
        .edges()
        .iter()
        .map(|e| e.ends().map(PointId::index))
        .collect();
    edges.iter().enumerate().all(|(i, &[a, b])| {
        let e = (places[a], places[b]);
        let is_empty = (0..places.len()).all(|v| v == a || v == b || !is_on(places[v], e));
        is_empty
            && edges[..i].iter().all(|&[c, d]| {
                let f = (places[c], places[d]);
                let sides = |e: (Place, Place), f: (Place, Place)| {
                    orientation(e.0, e.1, f.0) * orientation(e.0, e.1, f.1)
                };
                [c, d].contains(&a) || [c, d].contains(&b) || sides(e, f) >= 0 || sides(f, e) >= 0
            })
    })
}
