//! Points that are hard on an algorithm, by name; the benches measure the same ones at a million.

use std::f64::consts::TAU;

use glam::DVec2;

/// A set of points of about the size that is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    /// What it is.
    pub(crate) name: &'static str,
    /// About so many points.
    pub(crate) points: fn(usize) -> Vec<DVec2>,
}

/// What the others are compared with: evenly spread, in general position, in no order.
pub(crate) const WELL_SPREAD: Cell = Cell {
    name: "well spread",
    points: well_spread,
};

/// Every hard set that is a point set.
pub(crate) const CELLS: &[Cell] = &[
    cell("integer grid", grid),
    cell("grid, sorted by y", |n| sorted(grid(n), |p| p.y)),
    cell("grid at 1e15", |n| {
        grid(n).iter().map(|p| p + 1e15).collect()
    }),
    cell("grid of 0.1", |n| grid(n).iter().map(|p| 0.1 * p).collect()),
    cell("line", line),
    cell("line, reversed", |n| line(n).into_iter().rev().collect()),
    cell("line, shuffled", |n| shuffled(line(n))),
    cell("slanted line", |n| {
        line(n).iter().map(|p| DVec2::new(p.x, 3.0 * p.x)).collect()
    }),
    cell("slanted line, rounded", |n| {
        line(n)
            .iter()
            .map(|p| DVec2::new(p.x / 3.0, p.x / 7.0))
            .collect()
    }),
    cell("line and a point beside it", |n| {
        let mut points = line(n);
        points.push(DVec2::new(n as f64 / 2.0, n as f64));
        points
    }),
    cell("polygon", polygon),
    cell("polygon, shuffled", |n| shuffled(polygon(n))),
    cell("polygon at 1e15", |n| {
        let radius = n as f64;
        let on_grid = |p: &DVec2| (p * radius).round() + 1e15;
        polygon(n).iter().map(on_grid).collect()
    }),
    cell("polygon and its centre", |n| {
        let mut points = polygon(n);
        points.push(DVec2::ZERO);
        points
    }),
    cell("two circles 1e-12 apart", |n| {
        let inner = polygon(n / 2);
        let outer: Vec<DVec2> = inner.iter().map(|p| p * (1.0 + 1e-12)).collect();
        [inner, outer].concat()
    }),
    cell("two circles 1e-12 apart, interleaved", |n| {
        let circle = |(i, p): (usize, DVec2)| if i % 2 == 0 { p } else { p * (1.0 + 1e-12) };
        polygon(n).into_iter().enumerate().map(circle).collect()
    }),
    cell("two parallel lines", |n| {
        let lower = line(n / 2);
        let upper: Vec<DVec2> = lower.iter().map(|p| p + DVec2::new(0.5, 1e-6)).collect();
        [lower, upper].concat()
    }),
    cell("parabola", |n| {
        let on_parabola = |p: &DVec2| DVec2::new(p.x, p.x * p.x);
        line(n).iter().map(on_parabola).collect()
    }),
    cell("cluster of 1e-9 beside a far point", |n| {
        let cluster = |p: DVec2| 1.0 + 1e-9 * p;
        let far = [DVec2::new(1e6, -1e6)];
        well_spread(n).into_iter().map(cluster).chain(far).collect()
    }),
    cell("clusters in clusters", |n| {
        let per_level = n.div_ceil(20);
        let level = |k: usize| {
            let size = 1e-2f64.powi(i32::try_from(k).unwrap_or(0));
            well_spread(per_level).into_iter().map(move |p| size * p)
        };
        (0..20).flat_map(level).collect()
    }),
    cell("spiral", spiral),
    cell("spiral, shuffled", |n| shuffled(spiral(n))),
    cell("geometric progression", |n| {
        // Distances over 40 powers of ten.
        let at = |i: usize| 10f64.powf(-40.0 * i as f64 / n as f64);
        (0..n).map(|i| DVec2::new(at(i), at(i) / 2.0)).collect()
    }),
    cell("ties on the Hilbert curve", |n| {
        // Two far corners leave the others to one cell of the first grid, and of the second.
        let corners = [DVec2::ZERO, DVec2::splat(1e6), DVec2::splat(1e-5)];
        let tied = well_spread(n).into_iter().map(|p| 1e-12 * p + 1e-6);
        corners.into_iter().chain(tied).collect()
    }),
    cell("columns", |n| {
        // Few different x, many y.
        let at = |i: usize| DVec2::new((i % 3) as f64, (i / 3) as f64 * 1e-3);
        (0..n).map(at).collect()
    }),
    cell("two clusters", |n| {
        let far = |(i, p): (usize, DVec2)| 1e-9 * p + 1e3 * (i % 2) as f64;
        well_spread(n).into_iter().enumerate().map(far).collect()
    }),
    cell("star", |n| {
        // Rays of points into a centre: near it, all are close to all others.
        let rays = 1.0 + (n as f64).sqrt().floor();
        let at = |i: f64| DVec2::from_angle((i % rays) / rays * TAU) * (1.0 + (i / rays).floor());
        (0..n).map(|i| at(i as f64)).collect()
    }),
    cell("smallest coordinates", |n| {
        grid(n).iter().map(|p| p * 2f64.powi(-142)).collect()
    }),
    cell("largest coordinates", |n| {
        grid(n).iter().map(|p| p * 2f64.powi(185)).collect()
    }),
];

const fn cell(name: &'static str, points: fn(usize) -> Vec<DVec2>) -> Cell {
    Cell { name, points }
}

/// The additive recurrence of the plastic number, slightly perturbed.
pub(crate) fn well_spread(n: usize) -> Vec<DVec2> {
    let at = |i: f64| {
        let p = DVec2::new(i * 0.754_877_666_246_692_8, i * 0.569_840_290_998_053_3);
        p.fract() + DVec2::new((i * 0.618_034).fract(), (i * 0.414_214).fract()) / (4.0 * n as f64)
    };
    (1..=n).map(|i| at(i as f64)).collect()
}

pub(crate) fn grid(n: usize) -> Vec<DVec2> {
    let side = n.isqrt();
    let at = |i: usize| DVec2::new((i / side) as f64, (i % side) as f64);
    (0..side * side).map(at).collect()
}

pub(crate) fn line(n: usize) -> Vec<DVec2> {
    (0..n).map(|i| DVec2::new(i as f64, 0.0)).collect()
}

pub(crate) fn polygon(n: usize) -> Vec<DVec2> {
    let angle = |i: usize| i as f64 / n as f64 * TAU;
    (0..n).map(|i| DVec2::from_angle(angle(i))).collect()
}

/// An Archimedean spiral, its points about 1 apart, its arms 10.
pub(crate) fn spiral(n: usize) -> Vec<DVec2> {
    let at = |i: usize| {
        let turn = (TAU * (i as f64 + 40.0) / 5.0).sqrt();
        DVec2::from_angle(turn) * (turn * 10.0 / TAU)
    };
    (0..n).map(at).collect()
}

pub(crate) fn sorted(mut points: Vec<DVec2>, key: impl Fn(&DVec2) -> f64) -> Vec<DVec2> {
    points.sort_by(|p, q| key(p).total_cmp(&key(q)));
    points
}

/// In an order that looks random.
pub(crate) fn shuffled(points: Vec<DVec2>) -> Vec<DVec2> {
    let key = |i: usize| (i as f64 * 0.618_033_988_749_894_9).fract();
    let mut keyed: Vec<(f64, DVec2)> = points
        .into_iter()
        .enumerate()
        .map(|(i, p)| (key(i), p))
        .collect();
    keyed.sort_by(|p, q| p.0.total_cmp(&q.0));
    keyed.into_iter().map(|(_, p)| p).collect()
}
