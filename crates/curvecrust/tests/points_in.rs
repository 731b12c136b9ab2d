//! Points in, ordered curves out: `reconstruct` as its user sees it.

use curvecrust::reconstruct::{HnnCrust, NnCrust, ReconstructError};
use curvecrust::{Curves, DVec2, Error, ReconstructOptions, reconstruct, reconstruct_with};
use std::f64::consts::TAU;

fn ring(n: u32, radius: f64) -> impl Iterator<Item = DVec2> {
    (0..n).map(move |i| DVec2::from_angle(TAU * f64::from(i) / f64::from(n)) * radius)
}

/// Two rings, one in the other, a stroke, and a point far from all.
fn drawing() -> Vec<DVec2> {
    let stroke = (0..9).map(|i| DVec2::new(12.0 + f64::from(i), 0.3 * f64::from(i)));
    let far = DVec2::new(200.0, 500.0);
    ring(40, 8.0)
        .chain(ring(16, 3.0))
        .chain(stroke)
        .chain([far])
        .collect()
}

/// Every index in a curve names the point at its place.
fn assert_names(points: &[DVec2], curves: &Curves) {
    for curve in curves {
        let named: Vec<DVec2> = curve.indices().iter().map(|&i| points[i]).collect();
        assert_eq!(named, curve.points());
    }
}

#[test]
fn curves_come_with_indices_nesting_and_ends() {
    let points = drawing();
    let curves = reconstruct(&points).unwrap();
    assert_names(&points, &curves);
    let [outer, inner, stroke] = curves.polylines() else {
        panic!("{curves:?}")
    };
    assert_eq!(outer.indices(), (0..40).collect::<Vec<_>>());
    assert_eq!(inner.indices(), (40..56).collect::<Vec<_>>());
    assert_eq!(stroke.indices(), (56..65).collect::<Vec<_>>());
    assert_eq!((outer.nesting(), outer.parent()), (Some(0), None));
    assert_eq!((inner.nesting(), inner.parent()), (Some(1), Some(0)));
    assert_eq!((stroke.nesting(), stroke.parent()), (None, None));
    assert_eq!(curves.leaves(), [56, 64]);
    assert_eq!(curves.isolated(), [65]);
    assert_eq!(curves.edges().len(), 40 + 16 + 8);
}

#[test]
fn the_order_of_the_points_only_renames_indices() {
    let points = drawing();
    let renamed: Vec<usize> = (0..points.len()).map(|i| i * 29 % points.len()).collect();
    let shuffled: Vec<DVec2> = renamed.iter().map(|&i| points[i]).collect();
    let curves = reconstruct(&shuffled).unwrap();
    assert_names(&shuffled, &curves);
    let edges = |curves: &Curves, name: &dyn Fn(usize) -> usize| {
        let ends = |&[a, b]: &[usize; 2]| [name(a).min(name(b)), name(a).max(name(b))];
        let mut edges: Vec<[usize; 2]> = curves.edges().iter().map(ends).collect();
        edges.sort_unstable();
        edges
    };
    let original = reconstruct(&points).unwrap();
    assert_eq!(edges(&curves, &|i| renamed[i]), edges(&original, &|i| i));
}

#[test]
fn every_kind_of_point_is_taken() {
    let single: [(f32, f32); 4] = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.5), (3.0, 0.5)];
    let pairs = single.map(|(x, y)| (f64::from(x), f64::from(y)));
    let expected = reconstruct(pairs).unwrap();
    assert_eq!(reconstruct(single).unwrap(), expected);
    assert_eq!(reconstruct(single.map(<[f32; 2]>::from)).unwrap(), expected);
    assert_eq!(reconstruct(pairs.map(<[f64; 2]>::from)).unwrap(), expected);
    let vectors = pairs.map(DVec2::from);
    assert_eq!(reconstruct(vectors).unwrap(), expected);
    assert_eq!(reconstruct(vectors.map(|p| p.as_vec2())).unwrap(), expected);
    assert_eq!(reconstruct(vectors.iter()).unwrap(), expected);
    #[cfg(feature = "mint")]
    {
        let points = pairs.map(|(x, y)| mint::Point2 { x, y });
        assert_eq!(reconstruct(points).unwrap(), expected);
    }
    #[cfg(feature = "geo-types")]
    {
        let points = pairs.map(geo_types::Point::from);
        assert_eq!(reconstruct(points).unwrap(), expected);
        assert_eq!(reconstruct(points.map(|p| p.0)).unwrap(), expected);
    }
}

#[test]
fn no_points_and_one_have_no_curve() {
    assert_eq!(reconstruct([[0.0; 2]; 0]).unwrap(), Curves::default());
    let one = reconstruct([[1.0, 2.0]]).unwrap();
    assert!(one.is_empty());
    assert_eq!(one.isolated(), [0]);
}

#[test]
fn bad_points_are_named() {
    let message = |points: &[[f64; 2]]| reconstruct(points).unwrap_err().to_string();
    assert!(message(&[[0.0, 0.0], [0.0, f64::NAN]]).starts_with("point 1 is (0, NaN)"));
    assert!(message(&[[0.0, 1.0], [1.0, 0.0], [0.0, 1.0]]).starts_with("points 0 and 2 are both"));
}

#[test]
fn merged_points_keep_their_names() {
    let mut points: Vec<DVec2> = ring(20, 5.0).collect();
    points.insert(3, points[0]);
    points.push(points[7]);
    let options = ReconstructOptions {
        merge_duplicates: true,
        ..Default::default()
    };
    let curves = reconstruct_with(&points, &options).unwrap();
    assert_names(&points, &curves);
    assert_eq!(curves.duplicates(), [[3, 0], [21, 7]]);
    let [ring] = curves.polylines() else {
        panic!("{curves:?}")
    };
    let distinct = (0..21).filter(|&i| i != 3).collect::<Vec<_>>();
    assert_eq!(ring.indices(), distinct);
}

#[test]
fn termini_are_indices_of_the_input() {
    // An arc whose ends are two spacings apart; its first point has two names.
    let mut points: Vec<DVec2> = ring(20, 5.0).take(19).collect();
    points.insert(0, points[0]);
    let open = |termini, algorithm| {
        let options = ReconstructOptions {
            algorithm,
            termini,
            merge_duplicates: true,
            ..Default::default()
        };
        reconstruct_with(&points, &options)
    };
    // The second name of the first point is as good as the first.
    let curves = open(&[1, 19], &HnnCrust::MUTUAL).unwrap();
    assert_eq!(curves.leaves(), [0, 19]);
    let refused = open(&[1], &NnCrust).unwrap_err();
    assert!(matches!(
        refused,
        Error::Reconstruct(ReconstructError::TerminiNotHonoured { .. })
    ));
    let absent = open(&[20], &HnnCrust::MUTUAL).unwrap_err();
    assert!(matches!(
        absent,
        Error::NoSuchPoint {
            index: 20,
            count: 20
        }
    ));
}

/// What the README shows first is what the crate doc runs.
#[test]
fn the_readme_begins_as_the_crate_doc_does() {
    let doc = include_str!("../src/lib.rs");
    let doc = doc.split("//! ```\n").nth(1).unwrap();
    let lines = doc
        .lines()
        .map(|line| line.trim_start_matches("//!").trim_start_matches(' '));
    let shown: Vec<&str> = lines.filter(|line| !line.starts_with('#')).collect();
    assert!(shown.len() <= 5);
    let readme = include_str!("../../../README.md");
    let block = readme.split("```rust\n").nth(1).unwrap();
    let block: Vec<&str> = block
        .lines()
        .take(shown.len())
        .map(str::trim_start)
        .collect();
    assert_eq!(
        block,
        shown
            .iter()
            .map(|line| line.trim_start())
            .collect::<Vec<_>>()
    );
}
