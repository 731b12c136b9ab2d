//! HNN-Crust on the point sets of the paper's authors, which are read if they are there.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that fails panics, one that skips says so"
)]

use curvecrust_geometry::{DVec2, PointSet};
use curvecrust_reconstruct::{ALGORITHMS, HnnCrust, Reconstruction};

const FOLDER: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../../shared/paper-data/points"
);

/// The points of a file of `x y` lines; `None` and a word about it if the file is not there.
fn points(name: &str) -> Option<PointSet> {
    let path = format!("{FOLDER}/{name}.p2d");
    let Ok(text) = std::fs::read_to_string(&path) else {
        println!("skipped: the paper's data is not at {FOLDER}");
        return None;
    };
    let point = |line: &str| {
        let mut numbers = line.split_whitespace().map(|word| word.parse().unwrap());
        Some(DVec2::new(numbers.next()?, numbers.next()?))
    };
    let points = text.lines().filter_map(point).collect();
    Some(PointSet::merging_duplicates(points).unwrap().points)
}

fn reconstruction(name: &str) -> Option<Reconstruction> {
    Some(Reconstruction::by(&HnnCrust::MUTUAL, &points(name)?))
}

#[test]
fn crocodile_is_closed_with_129_edges() {
    let Some(found) = reconstruction("crocodile-conf") else {
        return;
    };
    assert_eq!(found.edges().len(), 129);
    assert!(found.degrees().iter().all(|&degree| degree == 2));
    // The outline, and an eye of four points in it.
    let mut rings: Vec<_> = found
        .chains()
        .iter()
        .map(|c| (c.chain.edge_count(), c.nesting))
        .collect();
    rings.sort_unstable();
    assert_eq!(rings, [(4, Some(1)), (125, Some(0))]);
}

#[test]
fn ventilator_has_184_edges_and_20_leaves() {
    let Some(found) = reconstruction("ventilator") else {
        return;
    };
    assert_eq!((found.edges().len(), found.leaves().len()), (184, 20));
}

#[test]
fn mushroom_has_53_edges_and_12_leaves() {
    let Some(found) = reconstruction("mushroom") else {
        return;
    };
    assert_eq!((found.edges().len(), found.leaves().len()), (53, 12));
}

#[test]
fn every_algorithm_takes_them() {
    for name in ["crocodile-conf", "ventilator", "mushroom"] {
        let Some(points) = points(name) else { return };
        for algorithm in ALGORITHMS {
            assert!(!algorithm.reconstruct(&points).is_empty());
        }
    }
}
