//! What is told holds in every result, one closed curve is a simple polygon, and small ones cost
//! least.

#![allow(
    clippy::panic,
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    reason = "a test that fails panics, and its numbers are small"
)]

mod places;

use std::num::NonZeroU32;

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, Random};
use curvecrust_reconstruct::{
    ALGORITHMS, Known, LeastDetour, ReconstructError, Reconstructor, Shape,
};
use places::{Place, are_on_a_line, is_simple, random_places, set};

/// As many random sets of each kind; all that was promised where the build is fast.
const SETS: u64 = if cfg!(debug_assertions) { 40 } else { 3_400 };

fn known(shape: Option<Shape>, curves: u32, termini: &[u32]) -> Known {
    Known {
        shape,
        curves: NonZeroU32::new(curves),
        termini: termini.iter().map(|&v| v.into()).collect(),
    }
}

fn cost(points: &PointSet, tour: &[usize], is_closed: bool) -> f64 {
    let at = |i: usize| points.points()[tour[i % tour.len()]];
    let n = tour.len();
    let length = |i: usize| at(i).distance(at(i + 1));
    let lengths: f64 = (0..n - usize::from(!is_closed)).map(length).sum();
    let detour = |i: usize| length(i) + length(i + 1) - at(i).distance(at(i + 2));
    lengths
        + (0..if is_closed { n } else { n - 2 })
            .map(detour)
            .sum::<f64>()
}

/// The least cost over all orders of the points, and such an order.
fn cheapest(points: &PointSet, is_closed: bool) -> (f64, Vec<usize>) {
    fn extend(
        points: &PointSet,
        is_closed: bool,
        tour: &mut Vec<usize>,
        best: &mut (f64, Vec<usize>),
    ) {
        if tour.len() == points.len() {
            let cost = cost(points, tour, is_closed);
            if cost < best.0 {
                *best = (cost, tour.clone());
            }
        }
        for v in 0..points.len() {
            if !tour.contains(&v) {
                tour.push(v);
                extend(points, is_closed, tour, best);
                tour.pop();
            }
        }
    }
    let mut best = (f64::INFINITY, Vec::new());
    let mut start = if is_closed { vec![0] } else { Vec::new() };
    extend(points, is_closed, &mut start, &mut best);
    best
}

fn order(edges: &EdgeSet) -> Vec<usize> {
    let chains = edges.chains();
    assert_eq!(chains.len(), 1);
    chains[0].vertices().iter().map(|v| v.index()).collect()
}

#[test]
fn one_closed_curve_is_a_simple_polygon() {
    for kind in 0..3 {
        for seed in 0..SETS {
            let places = random_places(kind, seed, if seed % 50 == 0 { 200 } else { 40 });
            let found = LeastDetour.reconstruct_known(&set(&places), &Known::ONE_CLOSED_CURVE);
            if are_on_a_line(&places) {
                let count = places.len();
                assert_eq!(found, Err(ReconstructError::ClosedOnALine { count }));
                continue;
            }
            let found = found.unwrap();
            assert!(found.degrees().iter().all(|&d| d == 2), "{places:?}");
            assert_eq!(order(&found).len(), places.len());
            assert!(is_simple(&places, &found), "{places:?}");
        }
    }
}

#[test]
fn one_open_curve_is_a_simple_path() {
    for kind in 0..3 {
        for seed in 0..SETS {
            let places = random_places(kind, seed, 40);
            let found = LeastDetour
                .reconstruct_known(&set(&places), &Known::ONE_OPEN_CURVE)
                .unwrap();
            assert_eq!(order(&found).len(), places.len());
            assert_eq!(found.len() + 1, places.len());
            assert!(is_simple(&places, &found), "{places:?}");
        }
    }
}

#[test]
fn small_curves_cost_least() {
    for kind in 0..3 {
        for seed in 0..SETS.min(400) {
            let places = random_places(kind, seed, if seed % 20 == 0 { 8 } else { 7 });
            let points = set(&places);
            for is_closed in [true, false] {
                if is_closed && are_on_a_line(&places) {
                    continue;
                }
                let told = if is_closed {
                    Known::ONE_CLOSED_CURVE
                } else {
                    Known::ONE_OPEN_CURVE
                };
                let found = LeastDetour.reconstruct_known(&points, &told).unwrap();
                let (least, best) = cheapest(&points, is_closed);
                let count = best.len() - usize::from(!is_closed);
                let id = |i: usize| PointId::new(best[i % best.len()]).unwrap();
                let edges = (0..count).filter_map(|i| Edge::new(id(i), id(i + 1)));
                // What costs least may cross itself.
                if is_simple(&places, &EdgeSet::new(best.len(), edges)) {
                    let found = cost(&points, &order(&found), is_closed);
                    assert!(
                        found <= least * (1.0 + 1e-9),
                        "{is_closed} {found} {least} {places:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn what_is_known_holds() {
    let shapes = [None, Some(Shape::Closed), Some(Shape::Open)];
    for kind in 0..3 {
        for seed in 0..SETS {
            let places = random_places(kind, seed, 50);
            let points = set(&places);
            let mut random = Random::new(seed);
            let shape = shapes[random.below(3)];
            let curves = random.below(6) as u32;
            let termini: &[u32] = match (shape, random.below(3)) {
                (Some(Shape::Closed), _) | (_, 0) => &[],
                (_, 1) => &[1],
                _ => &[0, 2],
            };
            let told = known(shape, curves, termini);
            let found = match LeastDetour.reconstruct_known(&points, &told) {
                Ok(found) => found,
                Err(
                    ReconstructError::ClosedOnALine { .. }
                    | ReconstructError::TooFewPoints { .. }
                    | ReconstructError::CurvesNotFound { .. },
                ) => continue,
                Err(error) => panic!("{error}"),
            };
            let degrees = found.degrees();
            assert!(degrees.iter().all(|&d| d <= 2));
            assert!(
                told.termini.iter().all(|t| degrees[t.index()] <= 1),
                "{told:?} {places:?}"
            );
            let chains = found.chains();
            if curves > 0 {
                assert_eq!(chains.len(), curves as usize, "{told:?} {places:?}");
                assert!(found.isolated().is_empty(), "{told:?} {places:?}");
            }
            match shape {
                Some(Shape::Closed) => {
                    assert!(degrees.iter().all(|&d| d == 2), "{told:?} {places:?}");
                }
                Some(Shape::Open) => assert!(chains.iter().all(|c| !c.is_closed())),
                None => {}
            }
        }
    }
}

#[test]
fn order_scale_and_shift_do_not_matter() {
    let tellings = [
        Known::ONE_CLOSED_CURVE,
        Known::ONE_OPEN_CURVE,
        known(Some(Shape::Closed), 0, &[]),
        known(Some(Shape::Closed), 3, &[]),
        known(Some(Shape::Open), 3, &[]),
        known(Some(Shape::Open), 0, &[]),
        known(None, 2, &[]),
    ];
    for seed in 0..SETS.min(12) {
        let places = random_places((seed % 3) as usize, seed, 40);
        let count = places.len() as u32;
        for told in &tellings {
            let Ok(expected) = LeastDetour.reconstruct_known(&set(&places), told) else {
                continue;
            };
            let moved: Vec<Place> = places
                .iter()
                .map(|&(x, y)| (4 * (x - 7), 4 * (y + 99)))
                .collect();
            assert_eq!(
                LeastDetour.reconstruct_known(&set(&moved), told).as_ref(),
                Ok(&expected)
            );
            let mut turned = places.clone();
            turned.reverse();
            let found = LeastDetour.reconstruct_known(&set(&turned), told).unwrap();
            let back = |v: PointId| PointId::from(count - 1 - u32::from(v));
            let back = found
                .edges()
                .iter()
                .filter_map(|e| Edge::new(back(e.a()), back(e.b())));
            assert_eq!(
                EdgeSet::new(places.len(), back),
                expected,
                "{told:?} {places:?}"
            );
        }
    }
}

#[test]
fn what_cannot_be_is_an_error() {
    let row = set(&[(0, 0), (1, 1), (2, 2), (5, 5)]);
    let bent = set(&[(0, 0), (1, 1), (2, 2), (5, 0)]);
    let told = |points: &PointSet, told: Known| LeastDetour.reconstruct_known(points, &told);
    let closed = Some(Shape::Closed);
    let open = Some(Shape::Open);
    for curves in [0, 1] {
        let count = 4;
        assert_eq!(
            told(&row, known(closed, curves, &[])),
            Err(ReconstructError::ClosedOnALine { count })
        );
    }
    let few = |curves, needed| {
        Err(ReconstructError::TooFewPoints {
            count: 4,
            curves,
            needed,
        })
    };
    assert_eq!(told(&bent, known(closed, 2, &[])), few(2, 6));
    assert_eq!(told(&bent, known(open, 3, &[])), few(3, 6));
    assert_eq!(told(&bent, known(None, 5, &[])), few(5, 10));
    assert_eq!(
        told(&bent, known(closed, 1, &[2])),
        Err(ReconstructError::TerminiOfClosedCurves { termini: 1 })
    );
    assert_eq!(
        told(&bent, known(open, 1, &[2, 0, 1, 1])),
        Err(ReconstructError::TooManyTermini {
            termini: 3,
            curves: 1
        })
    );
    assert!(matches!(
        told(&bent, known(open, 1, &[4])),
        Err(ReconstructError::TerminusNotAPoint { .. })
    ));
    // Two closed curves would each need a point off the line.
    let handle = set(&[(0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (2, 1)]);
    assert_eq!(
        told(&handle, known(closed, 2, &[])),
        Err(ReconstructError::CurvesNotFound { asked: 2, found: 1 })
    );
    let none = PointSet::default();
    assert_eq!(told(&none, known(closed, 0, &[])), Ok(EdgeSet::default()));
    assert!(told(&none, Known::ONE_OPEN_CURVE).is_err());
    for algorithm in ALGORITHMS {
        let info = algorithm.info();
        let found = algorithm.reconstruct_known(&bent, &Known::ONE_CLOSED_CURVE);
        if info.honours_known {
            assert_eq!(found.unwrap().degrees(), [2; 4], "{}", info.name);
        } else {
            let refused = ReconstructError::KnownNotHonoured {
                algorithm: info.name,
            };
            assert_eq!(found, Err(refused));
        }
        assert_eq!(
            algorithm.reconstruct_known(&bent, &Known::default()),
            Ok(algorithm.reconstruct(&bent))
        );
    }
}

#[test]
fn given_ends_are_the_ends() {
    // Along a spiral whose ends are given, and one end that lies in the middle of a row.
    let spiral: Vec<Place> = (0..60)
        .map(|i| {
            let (angle, radius) = (f64::from(i) * 0.35, 20.0 + 9.0 * f64::from(i));
            ((radius * angle.cos()) as i64, (radius * angle.sin()) as i64)
        })
        .collect();
    let found = LeastDetour
        .reconstruct_known(&set(&spiral), &known(None, 1, &[59, 0]))
        .unwrap();
    assert_eq!(order(&found), (0..60).collect::<Vec<_>>());
    let row: Vec<Place> = (0..7).map(|x| (x, 0)).collect();
    let found = LeastDetour
        .reconstruct_known(&set(&row), &known(Some(Shape::Open), 1, &[3]))
        .unwrap();
    assert!(found.leaves().contains(&3.into()));
}

#[test]
fn thin_tips_and_few_corners_are_closed() {
    // A wedge whose sides are nearer to each other than the points along them.
    let wedge: Vec<Place> = (1..=8)
        .map(|i| (10 * i, i))
        .chain((1..=8).rev().map(|i| (10 * i, -i)))
        .collect();
    let corners = vec![(0, 0), (3, 0), (3, 1), (0, 1)];
    let triangle = vec![(0, 0), (4, 1), (2, 5)];
    for ring in [wedge, corners, triangle] {
        let found = LeastDetour
            .reconstruct_known(&set(&ring), &Known::ONE_CLOSED_CURVE)
            .unwrap();
        let expected: Vec<usize> = (0..ring.len()).collect();
        assert_eq!(order(&found), expected);
        let why = LeastDetour
            .explain_known(&set(&ring), &Known::ONE_CLOSED_CURVE)
            .unwrap()
            .unwrap();
        assert_eq!(why.edges.len(), ring.len());
        assert!(why.free_ends.is_empty());
    }
}

/// Where what is known joins an end with what was rejected without it, there is nothing to reject.
#[test]
fn no_edge_is_rejected_that_is_there() {
    let (mut random, mut rejected) = (Random::new(11), 0);
    for _ in 0..60 {
        let mut place = || DVec2::new(random.unit(), random.unit());
        let points = PointSet::new((0..20).map(|_| place()).collect()).unwrap();
        for curves in 1..3 {
            let known = known(Some(Shape::Open), curves, &[]);
            let why = LeastDetour.explain_known(&points, &known).unwrap().unwrap();
            let edges = why.edge_set(points.len());
            assert_eq!(
                edges,
                LeastDetour.reconstruct_known(&points, &known).unwrap()
            );
            for end in &why.free_ends {
                let partner = end.rejected.map(|rejected| rejected.partner);
                let edge = partner.and_then(|partner| Edge::new(end.point, partner));
                rejected += usize::from(edge.is_some());
                assert!(edge.is_none_or(|edge| !edges.contains(edge)));
            }
        }
    }
    assert!(rejected > 0);
}
