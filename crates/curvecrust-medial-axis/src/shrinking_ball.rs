//! The estimator of the paper's authors.
//!
//! J. Ma, S. W. Bae, S. Choi, *3D medial axis point approximation using nearest neighbors and the
//! normal field*, The Visual Computer 2012: at each point the largest empty ball tangent to the
//! curve there, found by shrinking. Here its limit is computed at once: the smallest of the balls
//! tangent at p that another dense point touches. The normal is perpendicular to the chord of the
//! two neighbours, so a medial point is as noisy as they are: lfs comes out too small in places.
//!
//! Cost: O(n^2), vectorised and parallel.

use curvecrust_curve::DenseCurve;
use curvecrust_geometry::DVec2;
use curvecrust_geometry::parallel::*;
use rstar::RTree;

use crate::lfs::LocalFeatureSize;

/// The medial point of every dense point that has one: the centre of the smallest ball that is
/// tangent to the curve there and has another dense point on its boundary.
///
/// Points on a straight line with all others have none.
#[must_use]
pub fn medial_points(dense: &DenseCurve) -> Vec<DVec2> {
    let (xs, ys): (Vec<f64>, Vec<f64>) = dense.points().iter().map(|p| (p.x, p.y)).unzip();
    (0..dense.len())
        .into_par_iter()
        .filter_map(|i| {
            let p = dense.points()[i];
            let normal = normal_at(dense, i)?;
            // 1 / radius, signed by the side of the normal on which the centre lies.
            let curvature = tightest(&xs, &ys, p, normal);
            (curvature != 0.0).then(|| p + normal / curvature)
        })
        .collect()
}

/// The distance of every dense point to the nearest medial point of any.
#[must_use]
pub fn lfs(dense: &DenseCurve) -> LocalFeatureSize {
    let medial = medial_points(dense).into_iter().map(|m| m.to_array());
    let tree = RTree::bulk_load(medial.collect());
    let distance = |p: &DVec2| {
        let nearest = tree.nearest_neighbor(p.to_array());
        nearest.map_or(f64::INFINITY, |&m| p.distance(DVec2::from_array(m)))
    };
    LocalFeatureSize::from_values(dense.points().par_iter().map(distance).collect())
}

/// The unit normal left of the chord between the neighbours; of the one gap, at the end of a curve.
fn normal_at(dense: &DenseCurve, i: usize) -> Option<DVec2> {
    let before = dense.points()[dense.previous(i).unwrap_or(i)];
    let after = dense.points()[dense.next(i).unwrap_or(i)];
    Some((after - before).try_normalize()?.perp())
}

/// The curvature of largest magnitude among the balls tangent at `p` through another point `q`:
/// 2 n.(q - p) / |q - p|^2.
fn tightest(xs: &[f64], ys: &[f64], p: DVec2, normal: DVec2) -> f64 {
    const LANES: usize = 4;
    // Greatest and least in independent lanes, so that the loop vectorises.
    let mut greatest = [0.0f64; LANES];
    let mut least = [0.0f64; LANES];
    let curvature = |x: f64, y: f64| {
        let (dx, dy) = (x - p.x, y - p.y);
        let squared = dx * dx + dy * dy;
        // p itself is 0 / 0: the smallest positive divisor makes it 0.
        2.0 * (normal.x * dx + normal.y * dy) / squared.max(f64::MIN_POSITIVE)
    };
    let (x_chunks, y_chunks) = (xs.chunks_exact(LANES), ys.chunks_exact(LANES));
    for (x, y) in x_chunks.remainder().iter().zip(y_chunks.remainder()) {
        greatest[0] = greatest[0].max(curvature(*x, *y));
        least[0] = least[0].min(curvature(*x, *y));
    }
    for (x, y) in x_chunks.zip(y_chunks) {
        for lane in 0..LANES {
            let c = curvature(x[lane], y[lane]);
            greatest[lane] = if c > greatest[lane] {
                c
            } else {
                greatest[lane]
            };
            least[lane] = if c < least[lane] { c } else { least[lane] };
        }
    }
    let greatest = greatest.into_iter().fold(0.0, f64::max);
    let least = least.into_iter().fold(0.0, f64::min);
    if greatest >= -least { greatest } else { least }
}
