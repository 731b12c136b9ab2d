//! Cells have about equally many points, whatever the points are.

use curvecrust_geometry::{DVec2, Random};
use curvecrust_testing::hard_points::HARD_POINTS;
use curvecrust_testing::strategies::point_set;
use curvecrust_tiles::Partition;

/// The most points of a cell.
fn largest(points: &[DVec2], partition: &Partition) -> usize {
    let mut counts = vec![0; partition.cells().len()];
    for &point in points {
        let cell = partition.cell_of(point);
        assert!(partition.cells()[cell].contains(point));
        counts[cell] += 1;
    }
    counts.into_iter().max().unwrap_or(0)
}

#[test]
fn cells_of_hard_points_are_fair() {
    for hard in HARD_POINTS {
        let points = point_set((hard.points)(2000)).points().to_vec();
        for cells in [1, 2, 3, 10, 64] {
            let partition = Partition::of(points.clone(), cells);
            let fair = points.len().div_ceil(cells);
            let largest = largest(&points, &partition);
            assert!(largest <= 2 * fair, "{}: {largest} of {fair}", hard.name);
        }
    }
}

#[test]
fn cells_of_a_cross_are_fair() {
    let mut random = Random::new(4);
    let points = (0..4000).map(|i| {
        let at = random.between(-1.0, 1.0);
        if i % 2 == 0 {
            DVec2::new(at, 0.0)
        } else {
            DVec2::new(0.0, at)
        }
    });
    let points: Vec<DVec2> = points.collect();
    let partition = Partition::of(points.clone(), 16);
    assert!(largest(&points, &partition) <= 500);
}

#[test]
fn points_that_do_not_differ_are_not_cut() {
    let twins = vec![DVec2::ONE; 10];
    assert_eq!(Partition::of(twins, 4).cells().len(), 1);
    assert_eq!(Partition::of(Vec::new(), 4).cells().len(), 1);
    assert_eq!(
        Partition::of(vec![DVec2::NAN, DVec2::ONE], 4).cells().len(),
        1
    );
    assert_eq!(
        Partition::of(vec![DVec2::ZERO, DVec2::ONE], 0)
            .cells()
            .len(),
        1
    );
}
