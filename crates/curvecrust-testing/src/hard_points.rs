//! Points that are hard on an algorithm, by name and of any number: tests take hundreds of them,
//! benches a million.

use std::f64::consts::TAU;

use curvecrust_geometry::DVec2;

/// A set of points of about the size that is asked for.
#[derive(Clone, Copy, Debug)]
pub struct HardPoints {
    /// What it is.
    pub name: &'static str,
    /// About this many points.
    pub points: fn(usize) -> Vec<DVec2>,
}

/// What the others are compared with: evenly spread, in general position, in no order.
pub const WELL_SPREAD: HardPoints = HardPoints {
    name: "well spread",
    points: well_spread,
};

/// Every hard set that is a point set.
pub const HARD_POINTS: &[HardPoints] = &[
    hard("integer grid", grid),
    hard("grid, sorted by y", |n| sorted(grid(n), |p| p.y)),
    hard("grid at 1e15", |n| {
        grid(n).iter().map(|p| p + 1e15).collect()
    }),
    hard("grid of 0.1", |n| grid(n).iter().map(|p| 0.1 * p).collect()),
    hard("line", line),
    hard("line, reversed", |n| line(n).into_iter().rev().collect()),
    hard("line, shuffled", |n| shuffled(line(n))),
    hard("slanted line", |n| {
        line(n).iter().map(|p| DVec2::new(p.x, 3.0 * p.x)).collect()
    }),
    hard("slanted line, rounded", |n| {
        line(n)
            .iter()
            .map(|p| DVec2::new(p.x / 3.0, p.x / 7.0))
            .collect()
    }),
    hard("line and a point beside it", |n| {
        let mut points = line(n);
        points.push(DVec2::new(n as f64 / 2.0, n as f64));
        points
    }),
    hard("polygon", polygon),
    hard("polygon, shuffled", |n| shuffled(polygon(n))),
    hard("polygon at 1e15", |n| {
        let radius = n as f64;
        let on_grid = |p: &DVec2| (p * radius).round() + 1e15;
        polygon(n).iter().map(on_grid).collect()
    }),
    hard("polygon and its centre", |n| {
        let mut points = polygon(n);
        points.push(DVec2::ZERO);
        points
    }),
    hard("two circles 1e-12 apart", |n| {
        let inner = polygon(n / 2);
        let outer: Vec<DVec2> = inner.iter().map(|p| p * (1.0 + 1e-12)).collect();
        [inner, outer].concat()
    }),
    hard("two circles 1e-12 apart, interleaved", |n| {
        let circle = |(i, p): (usize, DVec2)| if i % 2 == 0 { p } else { p * (1.0 + 1e-12) };
        polygon(n).into_iter().enumerate().map(circle).collect()
    }),
    hard("two parallel lines", |n| {
        let lower = line(n / 2);
        let upper: Vec<DVec2> = lower.iter().map(|p| p + DVec2::new(0.5, 1e-6)).collect();
        [lower, upper].concat()
    }),
    hard("parabola", |n| {
        let on_parabola = |p: &DVec2| DVec2::new(p.x, p.x * p.x);
        line(n).iter().map(on_parabola).collect()
    }),
    hard("cluster of 1e-9 beside a far point", |n| {
        let cluster = |p: DVec2| 1.0 + 1e-9 * p;
        let far = [DVec2::new(1e6, -1e6)];
        well_spread(n).into_iter().map(cluster).chain(far).collect()
    }),
    hard("clusters in clusters", |n| {
        let per_level = n.div_ceil(20);
        let level = |k: usize| {
            let size = 1e-2f64.powi(i32::try_from(k).unwrap_or(0));
            well_spread(per_level).into_iter().map(move |p| size * p)
        };
        (0..20).flat_map(level).collect()
    }),
    hard("spiral", spiral),
    hard("spiral, shuffled", |n| shuffled(spiral(n))),
    hard("exponential spiral", exponential_spiral),
    hard("grid at 1e17 and the origin", |n| {
        far_grid(n, DVec2::splat(1e17))
    }),
    hard("geometric progression", |n| {
        // Distances over 40 powers of ten.
        let at = |i: usize| 10f64.powf(-40.0 * i as f64 / n as f64);
        (0..n).map(|i| DVec2::new(at(i), at(i) / 2.0)).collect()
    }),
    hard("ties on the Hilbert curve", |n| {
        // Two far corners leave the others to one cell of the first grid, and of the second.
        let corners = [DVec2::ZERO, DVec2::splat(1e6), DVec2::splat(1e-5)];
        let tied = well_spread(n).into_iter().map(|p| 1e-12 * p + 1e-6);
        corners.into_iter().chain(tied).collect()
    }),
    hard("columns", |n| {
        // Few different x, many y.
        let at = |i: usize| DVec2::new((i % 3) as f64, (i / 3) as f64 * 1e-3);
        (0..n).map(at).collect()
    }),
    hard("two clusters", |n| {
        let far = |(i, p): (usize, DVec2)| 1e-9 * p + 1e3 * (i % 2) as f64;
        well_spread(n).into_iter().enumerate().map(far).collect()
    }),
    hard("star", |n| {
        // Rays of points into a centre: near it, all are close to all others.
        let rays = 1.0 + (n as f64).sqrt().floor();
        let at = |i: f64| DVec2::from_angle((i % rays) / rays * TAU) * (1.0 + (i / rays).floor());
        (0..n).map(|i| at(i as f64)).collect()
    }),
    hard("smallest coordinates", |n| {
        grid(n).iter().map(|p| p * 2f64.powi(-142)).collect()
    }),
    hard("largest coordinates", |n| {
        grid(n).iter().map(|p| p * 2f64.powi(185)).collect()
    }),
];

const fn hard(name: &'static str, points: fn(usize) -> Vec<DVec2>) -> HardPoints {
    HardPoints { name, points }
}

/// The additive recurrence of the plastic number, slightly perturbed.
#[must_use]
pub fn well_spread(n: usize) -> Vec<DVec2> {
    let at = |i: f64| {
        let p = DVec2::new(i * 0.754_877_666_246_692_8, i * 0.569_840_290_998_053_3);
        p.fract() + DVec2::new((i * 0.618_034).fract(), (i * 0.414_214).fract()) / (4.0 * n as f64)
    };
    (1..=n).map(|i| at(i as f64)).collect()
}

/// The points with whole coordinates of a square, column by column; at most `n`.
#[must_use]
pub fn grid(n: usize) -> Vec<DVec2> {
    let side = n.isqrt();
    let at = |i: usize| DVec2::new((i / side) as f64, (i % side) as f64);
    (0..side * side).map(at).collect()
}

/// The first `n` points with whole coordinates of the x axis.
#[must_use]
pub fn line(n: usize) -> Vec<DVec2> {
    (0..n).map(|i| DVec2::new(i as f64, 0.0)).collect()
}

/// The corners of a regular polygon in the unit circle, counter-clockwise.
#[must_use]
pub fn polygon(n: usize) -> Vec<DVec2> {
    let angle = |i: usize| i as f64 / n as f64 * TAU;
    (0..n).map(|i| DVec2::from_angle(angle(i))).collect()
}

/// An Archimedean spiral, its points about 1 apart, its arms 10.
#[must_use]
pub fn spiral(n: usize) -> Vec<DVec2> {
    let at = |i: usize| {
        let turn = (TAU * (i as f64 + 40.0) / 5.0).sqrt();
        DVec2::from_angle(turn) * (turn * 10.0 / TAU)
    };
    (0..n).map(at).collect()
}

/// A spiral over 90 powers of e: as seen from outside, doubles do not tell its inner points apart.
#[must_use]
pub fn exponential_spiral(n: usize) -> Vec<DVec2> {
    let at = |i: usize| {
        let turn = i as f64 / n as f64;
        DVec2::from_angle(400.0 * turn) * (90.0 * turn).exp()
    };
    (0..n).map(at).collect()
}

/// A grid with steps of 16 from a far corner on, and the origin, from which doubles hardly tell its
/// points apart.
#[must_use]
pub fn far_grid(n: usize, corner: DVec2) -> Vec<DVec2> {
    let far = grid(n).into_iter().map(|p| corner + 16.0 * p);
    far.chain([DVec2::ZERO]).collect()
}

/// In the order of a number that each point has.
#[must_use]
pub fn sorted(mut points: Vec<DVec2>, key: impl Fn(&DVec2) -> f64) -> Vec<DVec2> {
    points.sort_by(|p, q| key(p).total_cmp(&key(q)));
    points
}

/// In an order that looks random.
#[must_use]
pub fn shuffled(points: Vec<DVec2>) -> Vec<DVec2> {
    let key = |i: usize| (i as f64 * 0.618_033_988_749_894_9).fract();
    let mut keyed: Vec<(f64, DVec2)> = points
        .into_iter()
        .enumerate()
        .map(|(i, p)| (key(i), p))
        .collect();
    keyed.sort_by(|p, q| p.0.total_cmp(&q.0));
    keyed.into_iter().map(|(_, p)| p).collect()
}
