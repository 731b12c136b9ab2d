//! Points with known answers: the edges that a reconstruction has to find. Seeds decide the points.

use std::f64::consts::TAU;

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, PointSetError, Random};

/// Points sampled from closed curves, and the edges between consecutive ones.
#[derive(Clone, Debug)]
pub struct Planted {
    /// The samples.
    pub points: PointSet,
    /// The edges between consecutive samples: what a correct reconstruction returns.
    pub edges: EdgeSet,
}

/// The edges between consecutive ones of `count` points, and if `closed` the one from the last to
/// the first.
#[must_use]
pub fn consecutive_edges(count: usize, closed: bool) -> EdgeSet {
    let id = |i: usize| PointId::new(i % count).unwrap();
    let steps = if closed {
        count
    } else {
        count.saturating_sub(1)
    };
    let edges = (0..steps).filter_map(|i| Edge::new(id(i), id(i + 1)));
    EdgeSet::new(count, edges)
}

/// Points on one closed curve at least; more of them make more curves.
const PER_CURVE: usize = 250;

/// `count` points of wavy closed curves that do not touch, in random order.
///
/// The curves lie in the cells of a square grid, 250 points on each, 0.7 to 1.3 times the even
/// spacing apart in angle. The spacing is a tenth of the distance between curves at most:
/// HNN-Crust, NN-Crust and Crust return the planted edges.
///
/// # Errors
/// Too many points for a [`PointSet`].
pub fn many_curves(count: usize, seed: u64) -> Result<Planted, PointSetError> {
    in_cells(count, seed, |random| random.between(0.3, 0.35))
}

/// As [`many_curves`], with radii over three decades: uniform in their logarithm.
///
/// # Errors
/// Too many points for a [`PointSet`].
pub fn mixed_scale(count: usize, seed: u64) -> Result<Planted, PointSetError> {
    in_cells(count, seed, |random| {
        0.35 * 10f64.powf(-3.0 * random.unit())
    })
}

/// `count` points, independent and uniform in the unit square.
///
/// # Errors
/// Too many points for a [`PointSet`].
pub fn uniform(count: usize, seed: u64) -> Result<PointSet, PointSetError> {
    let mut random = Random::new(seed);
    let point = |_| DVec2::new(random.unit(), random.unit());
    let points = (0..count).map(point).collect();
    PointSet::merging_duplicates(points).map(|merged| merged.points)
}

/// `count` points, dense along one smooth closed curve, in its order: a wavy circle of mean
/// radius 1.
///
/// # Errors
/// Too many points for a [`PointSet`].
pub fn one_curve(count: usize) -> Result<Planted, PointSetError> {
    let wave = Wave {
        centre: DVec2::ZERO,
        radius: 1.0,
        depth: 0.2,
        waves: 5.0,
        phase: 0.3,
    };
    let points = (0..count)
        .map(|i| wave.at(i as f64 / count as f64))
        .collect();
    planted(points, &[count], None)
}

/// A circle whose radius oscillates.
struct Wave {
    centre: DVec2,
    radius: f64,
    depth: f64,
    waves: f64,
    phase: f64,
}

impl Wave {
    /// The point at a fraction of the full turn.
    fn at(&self, turn: f64) -> DVec2 {
        let angle = TAU * turn;
        let radius = self.radius * (1.0 + self.depth * (self.waves * angle + self.phase).cos());
        self.centre + radius * DVec2::from_angle(angle)
    }
}

fn in_cells(
    count: usize,
    seed: u64,
    mut radius: impl FnMut(&mut Random) -> f64,
) -> Result<Planted, PointSetError> {
    let mut random = Random::new(seed);
    let curves = (count / PER_CURVE).max(1);
    let side = (curves - 1).isqrt() + 1;
    let mut points = Vec::with_capacity(count);
    let mut sizes = Vec::with_capacity(curves);
    for curve in 0..curves {
        // The first curves take the points that are left over.
        let size = count / curves + usize::from(curve < count % curves);
        let cell = DVec2::new((curve % side) as f64, (curve / side) as f64);
        let wave = Wave {
            centre: cell + DVec2::new(random.between(0.49, 0.51), random.between(0.49, 0.51)),
            radius: radius(&mut random),
            depth: random.between(0.05, 0.15),
            waves: [3.0, 4.0, 5.0][random.below(3)],
            phase: TAU * random.unit(),
        };
        points.extend((0..size).map(|i| {
            let jitter = random.between(-0.15, 0.15);
            wave.at((i as f64 + jitter) / size as f64)
        }));
        sizes.push(size);
    }
    planted(points, &sizes, Some(random))
}

/// Closed curves of the given sizes, one after the other in `points`; shuffled at random if asked.
fn planted(
    points: Vec<DVec2>,
    sizes: &[usize],
    shuffle: Option<Random>,
) -> Result<Planted, PointSetError> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    if let Some(mut random) = shuffle {
        random.shuffle(&mut order);
    }
    let mut place = vec![0; order.len()];
    for (to, &from) in order.iter().enumerate() {
        place[from] = to;
    }
    let mut edges = Vec::with_capacity(points.len());
    let mut first = 0;
    for &size in sizes {
        let curve = &place[first..first + size];
        let pairs = curve.iter().zip(curve.iter().cycle().skip(1));
        edges.extend(pairs.filter_map(|(&p, &q)| Edge::new(PointId::new(p)?, PointId::new(q)?)));
        first += size;
    }
    Ok(Planted {
        edges: EdgeSet::new(points.len(), edges),
        points: PointSet::new(order.into_iter().map(|i| points[i]).collect())?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_reconstruct::hnn_crust;

    #[test]
    fn curves_do_not_touch_and_are_reconstructed() {
        for count in [100, 1_000, 30_000] {
            for planted in [
                many_curves(count, 1),
                mixed_scale(count, 1),
                one_curve(count),
            ] {
                let planted = planted.unwrap();
                assert_eq!(planted.points.len(), count);
                assert_eq!(planted.edges.len(), count);
                assert_eq!(hnn_crust(&planted.points), planted.edges);
            }
        }
    }

    #[test]
    fn seeds_decide() {
        let points = |seed| many_curves(1_000, seed).unwrap().points;
        assert_eq!(points(3), points(3));
        assert_ne!(points(3), points(4));
        assert_eq!(uniform(1_000, 3).unwrap(), uniform(1_000, 3).unwrap());
    }

    #[test]
    fn radii_span_three_decades() {
        let planted = mixed_scale(100_000, 1).unwrap();
        let length = |e: &Edge| planted.points[e.a()].distance(planted.points[e.b()]);
        let lengths = planted.edges.edges().iter().map(length);
        let (least, most) = lengths.fold((f64::MAX, 0f64), |(l, m), d| (l.min(d), m.max(d)));
        assert!(most > 1_000.0 * least);
    }
}
