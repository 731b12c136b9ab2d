//! The curves of the paper, where its data is at hand.
#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]

use std::fs;
use std::path::Path;

use curvecrust_curve::{Curve, DenseCurve};

fn read(path: &Path) -> Curve {
    let svg = fs::read_to_string(path).unwrap();
    Curve::from_svg(&svg).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn the_curves_of_the_paper() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/paper-data/curves");
    if !folder.is_dir() {
        println!("skipped: the curves of the paper are not here");
        return;
    }
    for (name, segments) in [("parallel", 6), ("teaser", 11), ("bunny", 17), ("cat", 43)] {
        let path = folder.join(format!("{name}.svg"));
        let curve = read(&path);
        assert_eq!(curve.components().len(), 1, "{name}");
        let component = &curve.components()[0];
        assert!(component.is_closed(), "{name}");
        assert_eq!(component.segments().len(), segments, "{name}");
        let dense = DenseCurve::per_segment(&curve, 300).unwrap();
        assert_eq!(dense.len(), 300 * segments, "{name}");
        // The viewBox of each file is its bounding box and a margin of 10, before joins are
        // smoothed.
        let svg = fs::read_to_string(&path).unwrap();
        let (_, rest) = svg.split_once("viewBox=\"").unwrap();
        let (numbers, _) = rest.split_once('"').unwrap();
        let numbers: Vec<f64> = numbers.split(' ').map(|n| n.parse().unwrap()).collect();
        let extent = numbers[2].max(numbers[3]) - 20.0;
        println!("{name}: extent {}, viewBox {numbers:?}", curve.extent());
        assert!((curve.extent() / extent - 1.0).abs() < 1e-4, "{name}");
    }
}
