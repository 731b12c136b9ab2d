//! The same edges, whatever the scale, the place, the order of the points and the number of
//! threads: for the samples of every curve of the fixtures and for all of their points.

#![allow(clippy::unwrap_used, reason = "a test that fails panics")]

use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet};
use curvecrust::medial_axis::{Discretisation, MeasureOptions, measure_with};
use curvecrust::reconstruct::{ALGORITHMS, Reconstructor};
use curvecrust::sampling::{Condition, sample};
use curvecrust_testing::fixtures;
use curvecrust_testing::moves::{distances_differ, mapped, permuted, relabelled};

/// Samples are rounded to multiples of this, so that they can be shifted without rounding.
const GRAIN: f64 = 1.0 / (1u64 << 30) as f64;

/// The fixtures as bare points, by name.
fn all_points() -> Vec<(String, PointSet)> {
    let mut found = Vec::new();
    for (name, curve) in fixtures::curves() {
        let options = MeasureOptions {
            discretisation: Discretisation::Adaptive { gap_to_lfs: 0.05 },
            ..MeasureOptions::default()
        };
        let measured = measure_with(&curve, &options).unwrap();
        for condition in [Condition::rho(0.9), Condition::epsilon(1.0 / 3.0)] {
            let sampling = sample(&measured, condition.unwrap()).unwrap();
            found.push((name.clone(), sampling.samples.points().to_vec()));
        }
    }
    found.extend(fixtures::points());
    assert!(found.len() > 40);
    let rounded = |points: Vec<DVec2>| {
        points
            .iter()
            .map(|&p| (p / GRAIN).round() * GRAIN)
            .collect()
    };
    found
        .into_iter()
        .map(|(name, points)| {
            (
                name,
                PointSet::merging_duplicates(rounded(points))
                    .unwrap()
                    .points,
            )
        })
        .collect()
}

fn moved(points: &PointSet, by: impl Fn(DVec2) -> DVec2) -> PointSet {
    mapped(points, by).unwrap()
}

/// Compares the edges of all algorithms from both sets, the points of which correspond.
fn assert_same(name: &str, what: &str, points: &PointSet, other: &PointSet) {
    for &algorithm in ALGORITHMS {
        assert_same_by(algorithm, name, what, points, other);
    }
}

fn assert_same_by(
    algorithm: &dyn Reconstructor,
    name: &str,
    what: &str,
    points: &PointSet,
    other: &PointSet,
) {
    let (expected, found) = (algorithm.reconstruct(points), algorithm.reconstruct(other));
    let algorithm = algorithm.info().name;
    assert!(expected == found, "{algorithm} of {name}, {what}");
}

#[test]
fn scale_and_place_do_not_matter() {
    for (name, points) in all_points() {
        for exponent in [-60, 60] {
            let scaled = moved(&points, |p| p * 2f64.powi(exponent));
            assert_same(&name, "scaled", &points, &scaled);
        }
        let by = DVec2::splat(2f64.powi(20));
        let shifted = moved(&points, |p| p + by);
        assert_eq!(
            moved(&shifted, |p| p - by),
            points,
            "{name} is shifted without rounding"
        );
        assert_same(&name, "shifted", &points, &shifted);
    }
}

type Turn = fn(DVec2) -> DVec2;

#[test]
fn quarter_turns_and_mirrors_do_not_matter_without_ties() {
    let mut without_ties = 0;
    for (name, points) in all_points() {
        if !distances_differ(&points) {
            continue;
        }
        without_ties += 1;
        let turns: [(&str, Turn); 5] = [
            ("turned by 90", DVec2::perp),
            ("turned by 180", |p| -p),
            ("turned by 270", |p| -p.perp()),
            ("mirrored at y", |p| DVec2::new(-p.x, p.y)),
            ("mirrored at the diagonal", |p| DVec2::new(p.y, p.x)),
        ];
        // The search for the shortest tour starts from the order of the points along a Hilbert
        // curve, which turns do change: of tours that are hardly longer it may find another.
        let others = ALGORITHMS.iter().copied();
        let others = others.filter(|algorithm| algorithm.info().name != "shortest-tour");
        for (what, turn) in turns {
            let turned = moved(&points, turn);
            for algorithm in others.clone() {
                assert_same_by(algorithm, &name, what, &points, &turned);
            }
        }
    }
    assert!(without_ties >= 10, "{without_ties}");
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    for (name, points) in all_points() {
        // A multiplier that has no divisor in common with the count visits all.
        let count = points.len();
        let step = (count / 2..)
            .find(|&s| (2..=s).all(|d| s % d > 0 || count % d > 0))
            .unwrap();
        let order: Vec<PointId> = (0..count)
            .map(|i| PointId::new((i * step + 3) % count).unwrap())
            .collect();
        let mixed = permuted(&points, &order);
        for algorithm in ALGORITHMS {
            let renamed = relabelled(&algorithm.reconstruct(&mixed), &order);
            let name = format!("{} of {name}", algorithm.info().name);
            assert!(renamed == algorithm.reconstruct(&points), "{name}");
        }
    }
}

#[test]
fn threads_do_not_matter() {
    let all: Vec<DVec2> = (0u32..)
        .zip(all_points())
        .flat_map(|(i, (_, points))| {
            let by = DVec2::new(f64::from(i % 8), f64::from(i / 8)) * 1024.0;
            points.points().iter().map(|&p| p + by).collect::<Vec<_>>()
        })
        .collect();
    // Enough of them that they are divided among threads.
    let copies = (0..5).flat_map(|i| all.iter().map(move |&p| p + f64::from(i) * 8192.0));
    let points = PointSet::merging_duplicates(copies.collect())
        .unwrap()
        .points;
    assert!(points.len() > 10_000);
    let on = |threads: usize, algorithm: &dyn Reconstructor| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build()
            .unwrap()
            .install(|| algorithm.reconstruct(&points))
    };
    for algorithm in ALGORITHMS {
        let one = on(1, *algorithm);
        for threads in [2, 16] {
            assert!(on(threads, *algorithm) == one, "{algorithm:?} on {threads}");
        }
    }
}
