//! The area that points lie in.

use glam::DVec2;

/// The least area, as a share of the square of the extent: points on a line have some too.
const SLIVER: f64 = 1e-9;

/// The area of the convex hull of points that are sorted by coordinates; of points on a line a
/// sliver.
///
/// Source: A. Andrew, *Another Efficient Algorithm for Convex Hulls in Two Dimensions*, 1979.
pub(crate) fn hull_area(sorted: &[DVec2]) -> f64 {
    let lower = chain(sorted.iter().copied());
    let upper = chain(sorted.iter().rev().copied());
    let (Some(&first), Some(&last)) = (lower.first(), lower.last()) else {
        return f64::MIN_POSITIVE;
    };
    let twice: f64 = [&lower, &upper]
        .iter()
        .flat_map(|chain| chain.windows(2))
        .map(|pair| (pair[0] - first).perp_dot(pair[1] - first))
        .sum();
    let least = SLIVER * first.distance_squared(last);
    (0.5 * twice.abs()).max(least).max(f64::MIN_POSITIVE)
}

/// The part of the hull to the right of the way from the first point to the last.
fn chain(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for p in points {
        while let [.., a, b] = *chain
            && (b - a).perp_dot(p - b) <= 0.0
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_diamond_with_points_inside() {
        let points = [(-1.0, 0.0), (0.0, -1.0), (0.0, 0.2), (0.0, 1.0), (1.0, 0.0)];
        assert!((hull_area(&points.map(DVec2::from)) - 2.0).abs() < 1e-12);
        let line = [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)];
        assert!((hull_area(&line.map(DVec2::from)) - 8.0 * SLIVER).abs() < 1e-12);
        assert!(hull_area(&[]) > 0.0);
    }
}
