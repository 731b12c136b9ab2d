//! Few points with coordinates of at most 24 bits: the local rules and the beta-skeletons by their
//! definitions, decided in integers.

#![no_main]

use curvecrust::DVec2;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust::reconstruct::{
    Beta, HnnCrust, Reconstructor, beta_skeleton, crust, hnn_crust, nn_crust, one_step_crust,
    spanning_tree,
};
use libfuzzer_sys::fuzz_target;

/// At most so many points.
const MOST: usize = 9;

type Point = [i64; 2];

// How many bits coordinates have, the power of two that scales them, and the points.
fuzz_target!(|input: (u8, i8, [[i32; 2]; MOST], u8)| {
    let (bits, scale, integers, count) = input;
    let shift = 31 - u32::from(bits) % 24;
    let count = 1 + usize::from(count) % MOST;
    let mut integers: Vec<Point> = integers[..count]
        .iter()
        .map(|p| p.map(|x| i64::from(x >> shift)))
        .collect();
    integers.sort_unstable();
    integers.dedup();
    let unit = f64::from(scale).exp2();
    let points = integers
        .iter()
        .map(|&[x, y]| DVec2::new(x as f64, y as f64) * unit);
    let Ok(points) = PointSet::new(points.collect()) else {
        return;
    };
    rules(&points, &integers);
    skeletons(&points, &integers);
});

/// HNN-Crust and NN-Crust: what each point chooses.
fn rules(points: &PointSet, at: &[Point]) {
    let half = choices(at, |s, n0, q| squared(at, q, s) < squared(at, q, n0));
    let mutual = joined(at.len(), |p, q| {
        half[p].contains(&q) && half[q].contains(&p)
    });
    assert_eq!(hnn_crust(points), mutual);
    let union = joined(at.len(), |p, q| {
        half[p].contains(&q) || half[q].contains(&p)
    });
    assert_eq!(HnnCrust::UNION.reconstruct(points), union);
    let right = choices(at, |s, n0, q| dot(at, s, n0, q) <= 0);
    let union = joined(at.len(), |p, q| {
        right[p].contains(&q) || right[q].contains(&p)
    });
    assert_eq!(nn_crust(points), union);
}

/// The nearest point, and the nearest of those on the other side of it; the first of equal ones by
/// coordinates, which is their order.
fn choices(at: &[Point], beyond: impl Fn(usize, usize, usize) -> bool) -> Vec<Vec<usize>> {
    let nearest = |s: usize, wanted: &dyn Fn(usize) -> bool| {
        let others = (0..at.len()).filter(|&q| q != s && wanted(q));
        others.min_by_key(|&q| squared(at, q, s))
    };
    let of = |s| {
        let n0 = nearest(s, &|_| true)?;
        let other = nearest(s, &|q| beyond(s, n0, q));
        Some([Some(n0), other].into_iter().flatten().collect())
    };
    (0..at.len()).map(|s| of(s).unwrap_or_default()).collect()
}

/// Gabriel's graph by its discs, and what is part of what.
fn skeletons(points: &PointSet, at: &[Point]) {
    let gabriel = joined(at.len(), |p, q| {
        (0..at.len()).all(|r| r == p || r == q || dot(at, r, p, q) > 0)
    });
    assert_eq!(beta_skeleton(points, Beta::GABRIEL), gabriel);
    let crust = crust(points);
    let narrower = beta_skeleton(points, Beta::CRUST);
    assert_eq!(narrower.difference(&gabriel).count(), 0);
    assert_eq!(crust.difference(&one_step_crust(points).crust).count(), 0);
    let tree = spanning_tree(points);
    assert_eq!(tree.len() + 1, at.len());
}

fn joined(count: usize, wanted: impl Fn(usize, usize) -> bool) -> EdgeSet {
    let id = |i| PointId::new(i).expect("few points");
    let wanted = &wanted;
    let pairs = (0..count).flat_map(|p| {
        (p + 1..count)
            .filter(move |&q| wanted(p, q))
            .map(move |q| (p, q))
    });
    EdgeSet::new(count, pairs.filter_map(|(p, q)| Edge::new(id(p), id(q))))
}

/// (p - from) . (q - from)
fn dot(at: &[Point], from: usize, p: usize, q: usize) -> i64 {
    (0..2)
        .map(|i| (at[p][i] - at[from][i]) * (at[q][i] - at[from][i]))
        .sum()
}

fn squared(at: &[Point], p: usize, q: usize) -> i64 {
    dot(at, p, q, q)
}
