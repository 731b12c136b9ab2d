//! Connect-the-closest-dot puzzles: the solver joins the dots exactly as the curve does.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_curve::{Curve, SplitCurve};
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, Random, Segment};
use curvecrust_medial_axis::{MeasuredCurve, measure, measure_pieces, strokes_of};
use curvecrust_reconstruct::closest_dot::Dots;
use curvecrust_sampling::{Puzzle, PuzzleOptions, SamplingError, sample_puzzle};
use curvecrust_testing::{curves, fixtures};

/// The edges, and the least margin, by the definition: each dot and each of its colours against
/// all dots.
fn solved(dots: &Dots) -> (EdgeSet, f64) {
    let points = dots.points().points();
    let (mut edges, mut margin) = (Vec::new(), f64::INFINITY);
    for (i, p) in points.iter().enumerate() {
        for colour in &dots.colours()[i] {
            let others = points.iter().enumerate().zip(dots.colours());
            let others = others.filter(|((j, _), set)| *j != i && set.contains(colour));
            let mut others: Vec<(f64, usize)> =
                others.map(|((j, q), _)| (p.distance(*q), j)).collect();
            others.sort_by(|a, b| a.0.total_cmp(&b.0));
            edges.extend(
                others.first().and_then(|&(_, j)| {
                    Edge::new(PointId::new(i).unwrap(), PointId::new(j).unwrap())
                }),
            );
            if let [first, second, ..] = others[..] {
                margin = margin.min(second.0 / first.0 - 1.0);
            }
        }
    }
    (EdgeSet::new(points.len(), edges), margin)
}

/// The largest distance of a dense point to the chord of its interval, and the same as a share of
/// its lfs.
fn deviation(measured: &MeasuredCurve, puzzle: &Puzzle) -> [f64; 2] {
    let (dense, samples) = (measured.dense(), &puzzle.sampling.samples);
    let mut worst = [0.0f64; 2];
    for component in samples.components() {
        for (from, to) in component.pairs() {
            let [mut at, to] = [from, to].map(|i| samples.dense_indices()[i]);
            let chord = Segment::new(dense.points()[at], dense.points()[to]);
            while at != to {
                let distance = chord.distance(dense.points()[at]);
                worst = [
                    worst[0].max(distance),
                    worst[1].max(distance / measured.lfs().at(at)),
                ];
                at = dense.next(at).unwrap();
            }
        }
    }
    worst
}

/// Makes a puzzle, and checks all that is promised of it.
fn checked(measured: &MeasuredCurve, options: &PuzzleOptions<'_>) -> Puzzle {
    let puzzle = sample_puzzle(measured, options).unwrap();
    let samples = &puzzle.sampling.samples;
    let (edges, margin) = solved(&puzzle.dots);
    assert_eq!(edges, samples.manifold_boundary());
    assert!(margin >= options.margin, "{margin}");
    assert!((puzzle.margin() - margin).abs() < 1e-12 || margin.is_infinite());
    let [distance, of_lfs] = deviation(measured, &puzzle);
    assert!(distance < options.max_distance.unwrap_or(f64::INFINITY));
    assert!(of_lfs < 1.0);
    for (here, there) in samples
        .components()
        .iter()
        .zip(measured.dense().components())
    {
        assert!(here.len() >= if there.closed { 3 } else { 2 });
    }
    // Numbers of colours are those from 0 on, and a dot has one for each of its edges at most.
    let count = u32::try_from(puzzle.dots.colour_count()).unwrap();
    let all = || puzzle.dots.colours().iter().flatten();
    assert!(all().all(|&colour| u32::from(colour) < count));
    assert!(
        puzzle
            .dots
            .colours()
            .iter()
            .all(|set| (1..=2).contains(&set.len()))
    );
    assert_eq!(puzzle, sample_puzzle(measured, options).unwrap());
    puzzle
}

#[test]
fn every_fixture_comes_back_with_its_margin() {
    for (name, curve) in fixtures::curves() {
        let measured = measure(&curve).unwrap();
        let far = checked(&measured, &PuzzleOptions::default());
        let near = PuzzleOptions {
            max_distance: Some(0.01 * curve.extent()),
            ..PuzzleOptions::default()
        };
        let near = checked(&measured, &near);
        let wide = PuzzleOptions {
            margin: 0.3,
            ..PuzzleOptions::default()
        };
        checked(&measured, &wide);
        assert!(
            near.dots.points().len() >= far.dots.points().len(),
            "{name}"
        );
        assert!(near.dots.colour_count() <= 16, "{name}");
    }
}

#[test]
fn random_smooth_curves_come_back() {
    let mut random = Random::new(11);
    let mut count = 0;
    while count < 40 {
        let curve = curves::random_closed(&mut random);
        // Curves that cross have no lfs.
        let Ok(measured) = measure(&curve) else {
            continue;
        };
        let options = PuzzleOptions {
            margin: random.fine_between(0.02, 0.5),
            max_distance: Some(random.fine_between(0.002, 0.1) * curve.extent()),
            least_step: random.fine_between(0.2, 1.0),
            ..PuzzleOptions::default()
        };
        checked(&measured, &options);
        count += 1;
    }
}

#[test]
fn a_power_of_two_changes_nothing_but_the_size() {
    let puzzle = |scale: f64| {
        let d = format!(
            "M 0 0 C {} 0 {} {} 0 {} S {} 0 0 0 Z",
            8.0 * scale,
            8.0 * scale,
            8.0 * scale,
            8.0 * scale,
            -8.0 * scale
        );
        let measured = measure(&Curve::from_path_data(&d).unwrap()).unwrap();
        checked(&measured, &PuzzleOptions::default())
    };
    let (small, large) = (puzzle(1.0), puzzle(1024.0));
    assert_eq!(small.dots.colours(), large.dots.colours());
    let dense = |puzzle: &Puzzle| puzzle.sampling.samples.dense_indices().to_vec();
    assert_eq!(dense(&small), dense(&large));
}

#[test]
fn a_straight_line_is_two_dots() {
    let line = Curve::from_path_data("M 0 0 H 10").unwrap();
    let puzzle = checked(&measure(&line).unwrap(), &PuzzleOptions::default());
    assert_eq!(
        puzzle.dots.points().points(),
        [DVec2::ZERO, DVec2::X * 10.0]
    );
    assert_eq!(puzzle.dots.colour_count(), 1);
}

#[test]
fn corners_are_dots() {
    let square = SplitCurve::from_path_data("M 0 0 H 4 V 4 H 0 Z").unwrap();
    let pieces = measure_pieces(&square).unwrap();
    let measured = strokes_of(&square, &pieces).unwrap();
    let corners: Vec<DVec2> = square.corners().iter().map(|corner| corner.at).collect();
    let options = PuzzleOptions {
        fixed: &corners,
        ..PuzzleOptions::default()
    };
    let puzzle = sample_puzzle(&measured, &options).unwrap();
    let dots = puzzle.dots.points().points();
    assert!(corners.iter().all(|corner| dots.contains(corner)));
    assert_eq!(
        solved(&puzzle.dots).0,
        puzzle.sampling.samples.manifold_boundary()
    );
}

#[test]
fn what_is_out_of_range_is_said() {
    let measured = measure(&fixtures::curve("wave")).unwrap();
    let default = PuzzleOptions::default();
    let refused = |options: PuzzleOptions<'_>| sample_puzzle(&measured, &options).unwrap_err();
    for margin in [0.0, -0.1, 1.5, f64::NAN, f64::INFINITY] {
        let error = refused(PuzzleOptions { margin, ..default });
        assert!(matches!(
            error,
            SamplingError::Parameter {
                name: "the margin",
                ..
            }
        ));
        let error = refused(PuzzleOptions {
            least_step: margin,
            ..default
        });
        assert!(matches!(
            error,
            SamplingError::Parameter {
                name: "the least step",
                ..
            }
        ));
    }
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let max_distance = Some(length);
        let error = refused(PuzzleOptions {
            max_distance,
            ..default
        });
        assert!(matches!(
            error,
            SamplingError::Parameter {
                name: "the largest distance",
                ..
            }
        ));
    }
    let max_distance = Some(1e-9);
    let error = refused(PuzzleOptions {
        max_distance,
        ..default
    });
    assert!(matches!(error, SamplingError::TooCoarse { .. }), "{error}");
}
