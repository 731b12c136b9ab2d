//! The same edges, whatever the scale, the place, the order of the points and the number of threads:
//! for the samples of every curve of the fixtures and for all of their points.

#![allow(clippy::unwrap_used, reason = "a test that fails panics")]

use std::fs;
use std::path::{Path, PathBuf};

use curvecrust::DVec2;
use curvecrust::curve::Curve;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust::medial_axis::{Discretisation, MeasureOptions, measure_with};
use curvecrust::reconstruct::{ALGORITHMS, Reconstructor};
use curvecrust::sampling::{Condition, sample};

/// Samples are rounded to multiples of this, so that they can be shifted without rounding.
const GRAIN: f64 = 1.0 / (1u64 << 30) as f64;

fn files(folder: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let entries = fs::read_dir(root.join(folder)).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

/// The fixtures as bare points, by name.
fn fixtures() -> Vec<(String, PointSet)> {
    let name = |path: &Path| path.file_stem().unwrap().to_string_lossy().into_owned();
    let mut found = Vec::new();
    for path in files("curves") {
        let curve = Curve::from_svg(&fs::read_to_string(&path).unwrap()).unwrap();
        let options = MeasureOptions {
            discretisation: Discretisation::Adaptive { gap_to_lfs: 0.05 },
            ..MeasureOptions::default()
        };
        let measured = measure_with(&curve, &options).unwrap();
        for condition in [Condition::rho(0.9), Condition::epsilon(1.0 / 3.0)] {
            let sampling = sample(&measured, condition.unwrap()).unwrap();
            found.push((name(&path), sampling.samples.points().to_vec()));
        }
    }
    for path in files("points") {
        let text = fs::read_to_string(&path).unwrap();
        let point = |line: &str| {
            let mut numbers = line.split_whitespace().map(|n| n.parse().unwrap());
            Some(DVec2::new(numbers.next()?, numbers.next()?))
        };
        let lines = text.lines().map(|line| line.split('#').next().unwrap());
        found.push((name(&path), lines.filter_map(point).collect()));
    }
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
    PointSet::new(points.points().iter().map(|&p| by(p)).collect()).unwrap()
}

fn distances_differ(points: &PointSet) -> bool {
    let points = points.points();
    let mut squares: Vec<f64> = (0..points.len())
        .flat_map(|i| (0..i).map(move |j| points[i].distance_squared(points[j])))
        .collect();
    squares.sort_unstable_by(f64::total_cmp);
    squares.windows(2).all(|pair| pair[0] < pair[1])
}

/// Compares the edges of all algorithms from both sets, the points of which correspond.
fn assert_same(name: &str, what: &str, points: &PointSet, other: &PointSet) {
    for algorithm in ALGORITHMS {
        let (expected, found) = (algorithm.reconstruct(points), algorithm.reconstruct(other));
        assert!(
            expected == found,
            "{} of {name}, {what}",
            algorithm.info().name
        );
    }
}

#[test]
fn scale_and_place_do_not_matter() {
    for (name, points) in fixtures() {
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
    for (name, points) in fixtures() {
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
        for (what, turn) in turns {
            assert_same(&name, what, &points, &moved(&points, turn));
        }
    }
    assert!(without_ties >= 10, "{without_ties}");
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    for (name, points) in fixtures() {
        // A multiplier that has no divisor in common with the count visits all.
        let count = points.len();
        let step = (count / 2..)
            .find(|&s| (2..=s).all(|d| s % d > 0 || count % d > 0))
            .unwrap();
        let order: Vec<PointId> = (0..count)
            .map(|i| PointId::new((i * step + 3) % count).unwrap())
            .collect();
        let permuted = PointSet::new(order.iter().map(|&id| points[id]).collect()).unwrap();
        for algorithm in ALGORITHMS {
            let edges = algorithm.reconstruct(&permuted);
            let old = |e: &Edge| Edge::new(order[e.a().index()], order[e.b().index()]);
            let renamed = EdgeSet::new(count, edges.edges().iter().filter_map(old));
            let name = format!("{} of {name}", algorithm.info().name);
            assert!(renamed == algorithm.reconstruct(&points), "{name}");
        }
    }
}

#[test]
fn threads_do_not_matter() {
    let all: Vec<DVec2> = (0u32..)
        .zip(fixtures())
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
