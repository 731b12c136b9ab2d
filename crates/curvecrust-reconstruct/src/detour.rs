//! What a polyline gains in length by a point on its way.

use curvecrust_geometry::DVec2;

/// How much longer the path from p to q is if it passes v: |vp| + |vq| - |pq|.
///
/// In a form whose error is relative to the shorter of |vp| and |vq|.
pub(crate) fn detour(v: DVec2, p: DVec2, q: DVec2) -> f64 {
    let (a, b) = (p - v, q - v);
    let (a_length, b_length) = (a.length(), b.length());
    let around = a_length + b_length + p.distance(q);
    (2.0 * (a_length * b_length + a.dot(b)) / around).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_detour_is_what_the_triangle_inequality_leaves() {
        let v = DVec2::new(1.0, 2.0);
        let at = |degrees: f64, length: f64| v + DVec2::from_angle(degrees.to_radians()) * length;
        for (p, q) in [
            (at(0.0, 3.0), at(90.0, 4.0)),
            (at(10.0, 1.0), at(160.0, 7.0)),
        ] {
            let expected = v.distance(p) + v.distance(q) - p.distance(q);
            assert!((detour(v, p, q) - expected).abs() < 1e-14);
        }
        // Straight on, and back: twice the shorter edge.
        assert!(detour(v, at(0.0, 5.0), at(180.0, 0.1)) < 1e-16);
        assert!((detour(v, at(0.0, 5.0), at(0.0, 0.1)) - 0.2).abs() < 1e-15);
    }
}
