//! Curves with corners: what is refused, and what samples of their pieces keep.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use std::f64::consts::TAU;

use curvecrust_curve::{BezierPath, CubicBezier, Curve, SplitCurve};
use curvecrust_geometry::{DVec2, Random};
use curvecrust_medial_axis::MedialAxisError;
use curvecrust_reconstruct::{hnn_crust, least_detour};
use curvecrust_sampling::{
    Condition, PlacedSamples, Placement, Sampling, SamplingError, check, sample_curve,
    sample_decoded, sample_fewest, sample_split,
};

fn split(d: &str) -> SplitCurve {
    SplitCurve::from_path_data(d).unwrap()
}

/// Samples of a curve, which are what they promise to be.
fn sampled(split: &SplitCurve, condition: Condition) -> Sampling {
    let sampling = sample_split(split, condition).unwrap();
    let placed = piece_by_piece(split, &sampling);
    let verdict = check(&sampling.measured, &placed, condition);
    assert!(verdict.certain);
    let samples = &sampling.samples;
    // What is attained is that of the worst piece, between samples of the whole.
    let (attained, worst) = (sampling.attained.unwrap(), verdict.worst.unwrap());
    assert_eq!((attained.at, attained.dense), (worst.at, worst.dense));
    let points = |points: &[DVec2], ends: [Option<usize>; 2]| ends.map(|end| points[end.unwrap()]);
    let of_pieces: Vec<DVec2> = placed.placements().iter().map(|p| p.point).collect();
    assert_eq!(
        points(samples.points(), attained.interval.samples),
        points(&of_pieces, worst.interval.samples)
    );
    let component = &samples.components()[attained.interval.component];
    for end in attained.interval.samples {
        assert!(component.range.contains(&end.unwrap()));
    }
    assert_eq!(samples.components().len(), split.components().len());
    for (sampled, whole) in samples.components().iter().zip(split.components()) {
        assert_eq!(sampled.closed, whole.closed);
        assert!(sampled.range.len() >= if whole.closed { 3 } else { 2 });
    }
    for corner in split.corners() {
        let here = samples.points().iter().filter(|&&p| p == corner.at);
        assert_eq!(here.count(), 1, "{corner:?}");
    }
    sampling
}

/// The samples of every piece by itself: a corner is a sample of both pieces that meet there.
fn piece_by_piece(split: &SplitCurve, sampling: &Sampling) -> PlacedSamples {
    let dense = sampling.measured.dense();
    let place = |at: usize| Placement {
        point: dense.points()[at],
        dense: at,
        t: 0.0,
    };
    let mut places = Vec::new();
    for (piece, component) in dense.components().iter().enumerate() {
        let samples = sampling.samples.dense_indices().iter().copied();
        places.extend(samples.filter(|at| component.range.contains(at)).map(place));
        if split.meetings(piece)[1].is_some() {
            places.push(place(component.range.end - 1));
        }
    }
    PlacedSamples::new(&sampling.measured, places).unwrap()
}

fn is_reconstructed(sampling: &Sampling) -> bool {
    let samples = &sampling.samples;
    hnn_crust(&samples.point_set().unwrap()) == samples.manifold_boundary()
}

const SHAPES: [(&str, &str); 11] = [
    ("square", "M 0 0 H 1 V 1 H 0 Z"),
    ("bar", "M 0 0 H 10 V 1 H 0 Z"),
    ("half disc", "M 0 0 A 1 1 0 0 1 2 0 Z"),
    ("lens", "M 0 0 A 1 1 0 0 1 1.6 0 A 1 1 0 0 1 0 0 Z"),
    ("drop", "M 0 0 C 3 2.5 3 -2.5 0 0 Z"),
    ("L", "M 0 0 H 4 V 1 H 1 V 5 H 0 Z"),
    ("zigzag", "M 0 0 L 2 3 L 4 0 L 6 3 L 8 0"),
    (
        "heart",
        "M 0 0 C -2 2 -4 1 -4 -1 C -4 -2.5 -2 -3.5 0 -5 C 2 -3.5 4 -2.5 4 -1 C 4 1 2 2 0 0 Z",
    ),
    ("frame", "M 0 0 H 6 V 6 H 0 Z M 0.5 0.5 H 5.5 V 5.5 H 0.5 Z"),
    (
        "disc in a square",
        "M 0 0 H 4 V 4 H 0 Z M 1 2 A 1 1 0 0 1 3 2 A 1 1 0 0 1 1 2 Z",
    ),
    ("bevel", "M 0 0 H 4 V 3.9 L 3.9 4 H 0 Z"),
];

#[test]
fn corners_are_samples_and_hnn_crust_gets_round_them() {
    let rho = Condition::rho(0.9).unwrap();
    for (name, d) in SHAPES {
        let split = split(d);
        for condition in [
            rho,
            Condition::epsilon(0.47).unwrap(),
            rho.with_hausdorff_limit(0.02).unwrap(),
        ] {
            let sampling = sampled(&split, condition);
            assert!(is_reconstructed(&sampling), "{name} {condition:?}");
        }
    }
}

#[test]
fn without_corners_nothing_changes() {
    let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z M 30 100 C 30 140 90 140 90 100";
    let rho = Condition::rho(0.9).unwrap();
    let sampling = sample_split(&split(d), rho).unwrap();
    let other = sample_curve(&Curve::from_path_data(d).unwrap(), rho).unwrap();
    assert_eq!(sampling, sample_fewest(&other.measured, rho).unwrap());
}

/// Corners that HNN-Crust cannot get round from any samples.
#[test]
fn sharp_corners_are_decoded_by_least_detour() {
    let rho = Condition::rho(0.9).unwrap();
    for d in ["M 0 0 H 4 V 4 Z", "M 0 0 L 6 2 L 0 4 L 2 2 Z"] {
        let found = sample_decoded(&split(d), rho).unwrap();
        assert!(found.is_exact, "{d}");
        let samples = &found.sampling.samples;
        let points = samples.point_set().unwrap();
        assert_eq!(least_detour(&points), samples.manifold_boundary(), "{d}");
        assert_ne!(hnn_crust(&points), samples.manifold_boundary(), "{d}");
    }
}

#[test]
fn what_no_samples_help_is_refused() {
    let rho = Condition::rho(0.9).unwrap();
    let refused = |d| sample_split(&split(d), rho).unwrap_err();
    // Squares that cross, and that have a corner in common.
    for d in [
        "M 0 0 H 4 V 4 H 0 Z M 2 2 H 6 V 6 H 2 Z",
        "M 0 0 H 4 V 4 H 0 Z M 4 4 H 6 V 6 H 4 Z",
    ] {
        let error = refused(d);
        let SamplingError::Measure(MedialAxisError::Touching { at, .. }) = error else {
            panic!("{error}");
        };
        let near = |p: DVec2| at.distance(p) < 1e-5;
        assert!(
            [
                DVec2::new(2.0, 4.0),
                DVec2::new(4.0, 2.0),
                DVec2::splat(4.0)
            ]
            .into_iter()
            .any(near)
        );
    }
}

/// A closed chain of arcs, bent at random, through points at random distances from the origin.
fn random_corners(random: &mut Random) -> SplitCurve {
    let n = 3 + random.below(6);
    let radii: Vec<f64> = (0..n).map(|_| random.fine_between(0.6, 1.0)).collect();
    let at = |i: usize| DVec2::from_angle(TAU * (i % n) as f64 / n as f64) * radii[i % n];
    let arcs = (0..n).map(|i| {
        let (p, q) = (at(i), at(i + 1));
        let bend = random.fine_between(-0.15, 0.15) * (q - p).perp();
        let third = (q - p) / 3.0;
        CubicBezier::new([p, p + third + bend, q - third + bend, q])
    });
    SplitCurve::new(vec![BezierPath::new(arcs.collect(), true)]).unwrap()
}

/// How many corners are farther from one of their neighbours than those are from each other, and
/// clearly farther than from the other one: HNN-Crust would join the neighbours.
fn uneven_corners(split: &SplitCurve, sampling: &Sampling) -> usize {
    let points = sampling.samples.points();
    let at = |corner: DVec2| points.iter().position(|&p| p == corner).unwrap();
    let n = points.len();
    let is_uneven = |&i: &usize| {
        let (s, t) = (points[(i + n - 1) % n], points[(i + 1) % n]);
        let [to_s, to_t] = [s, t].map(|p| points[i].distance(p));
        let far = to_s.max(to_t);
        far >= s.distance(t) && far >= 1.02 * to_s.min(to_t)
    };
    let corners = split.corners().iter().map(|corner| at(corner.at));
    corners.filter(is_uneven).count()
}

#[test]
fn most_random_corners_are_reconstructed() {
    let mut random = Random::new(60);
    let (mut done, mut exact, mut corners, mut uneven) = (0, 0, 0, 0);
    while done < 200 {
        let split = random_corners(&mut random);
        if split.corners().iter().any(|c| c.angle_deg > 118.0) {
            continue;
        }
        let sampling = sampled(&split, Condition::rho(0.9).unwrap());
        done += 1;
        exact += usize::from(is_reconstructed(&sampling));
        corners += split.corners().len();
        uneven += uneven_corners(&split, &sampling);
    }
    assert!(uneven <= corners / 200, "{uneven} of {corners}");
    // No theorem says so: arms that bend towards each other are what fails.
    assert!(exact >= 195, "{exact}");
}
