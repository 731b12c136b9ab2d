//! For each point others on all sides of it.

use curvecrust_geometry::DVec2;

/// Nothing was found.
const NONE: (f64, u32) = (f64::INFINITY, u32::MAX);

/// For each point the nearest one in each of eight quadrants, where there is one: four between the
/// axes, and four that are turned by 45 degrees. Distances are sums along the sides of a quadrant.
///
/// The nearest points of one at the border of a cluster are all of its cluster. D. S. Johnson,
/// L. A. McGeoch, "The Traveling Salesman Problem: A Case Study in Local Optimization", in: Local
/// Search in Combinatorial Optimization, 1997: with neighbours in each quadrant, a search can join
/// clusters.
pub(super) fn in_quadrants(points: &[DVec2]) -> Vec<Vec<u32>> {
    let mut found = vec![Vec::new(); points.len()];
    let sides = [DVec2::X, DVec2::ONE, DVec2::Y, DVec2::new(-1.0, 1.0)];
    for side in sides {
        for side in [side, -side] {
            let turned: Vec<DVec2> = points
                .iter()
                .map(|&p| DVec2::new(side.dot(p), side.perp().dot(p)))
                .collect();
            for (list, at) in found.iter_mut().zip(in_first(&turned)) {
                list.extend(at);
            }
        }
    }
    found
}

/// For each point the one of least x + y of the others whose x and y are not less.
///
/// Points are taken from right to left. Those so far are in a tree of partial minima over their
/// order by y: P. M. Fenwick, "A New Data Structure for Cumulative Frequency Tables", Software:
/// Practice and Experience 24(3), 1994.
fn in_first(points: &[DVec2]) -> Vec<Option<u32>> {
    let sorted = |key: fn(DVec2) -> (f64, f64)| {
        let mut ids: Vec<u32> = (0u32..).take(points.len()).collect();
        ids.sort_unstable_by(|&v, &w| {
            let [v_key, w_key] = [v, w].map(|v| key(points[v as usize]));
            let firsts = v_key.0.total_cmp(&w_key.0);
            firsts.then(v_key.1.total_cmp(&w_key.1)).then(v.cmp(&w))
        });
        ids
    };
    let mut rank = vec![0; points.len()];
    for (i, v) in sorted(|p| (-p.y, -p.x)).into_iter().enumerate() {
        rank[v as usize] = i + 1;
    }
    let mut least = vec![NONE; points.len() + 1];
    let mut found = vec![None; points.len()];
    for v in sorted(|p| (-p.x, -p.y)) {
        let p = points[v as usize];
        let mut best = NONE;
        let mut i = rank[v as usize];
        while i > 0 {
            best = nearer(best, least[i]);
            i &= i - 1;
        }
        found[v as usize] = (best.1 != NONE.1).then_some(best.1);
        let mut i = rank[v as usize];
        while let Some(entry) = least.get_mut(i) {
            *entry = nearer(*entry, (p.x + p.y, v));
            i += i & i.wrapping_neg();
        }
    }
    found
}

fn nearer(a: (f64, u32), b: (f64, u32)) -> (f64, u32) {
    if b.0.total_cmp(&a.0).then(b.1.cmp(&a.1)).is_lt() {
        b
    } else {
        a
    }
}

#[cfg(test)]
mod tests {
    use curvecrust_geometry::Random;

    use super::*;

    /// On a grid, with many ties.
    #[test]
    fn the_nearest_of_a_quadrant_is_that_of_all() {
        let mut random = Random::new(1);
        let cells = (0..81_u32).map(|i| DVec2::new(f64::from(i % 9), f64::from(i / 9)));
        let points: Vec<DVec2> = cells.filter(|_| random.below(3) > 0).collect();
        for (&p, found) in points.iter().zip(in_first(&points)) {
            let is_in = |q: DVec2| q.x >= p.x && q.y >= p.y && q != p;
            let all = points.iter().filter(|&&q| is_in(q));
            let least = all.map(|q| q.x + q.y).reduce(f64::min);
            let found = found.map(|v| points[v as usize]);
            assert!(found.is_none_or(is_in), "{p}");
            assert_eq!(found.map(|q| q.x + q.y), least, "{p}");
        }
    }
}
