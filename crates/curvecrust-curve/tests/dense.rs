//! Dense points: where they are, who their neighbours are, and that refining keeps them.
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]
#![allow(
    clippy::float_cmp,
    reason = "points that must be kept are kept bit by bit"
)]

use curvecrust_curve::{
    BezierPath, CubicBezier, Curve, CurveParam, DENSE_LIMIT, DenseCurve, DenseError,
};
use curvecrust_geometry::Component;
use glam::DVec2;
use proptest::prelude::*;

/// A closed component of 16 segments and an open one of 2.
fn curve() -> Curve {
    let step = std::f64::consts::TAU / 16.0;
    let handle = 4.0 / 3.0 * (step / 4.0).tan();
    let around = DVec2::new(6.0, 5.0);
    let arc = |i: u32| {
        let [a, b] = [i, (i + 1) % 16].map(|i| DVec2::from_angle(f64::from(i) * step));
        let inner = [a + handle * a.perp(), b - handle * b.perp()];
        CubicBezier::new([a, inner[0], inner[1], b].map(|p| around + p))
    };
    let circle = BezierPath::new((0..16).map(arc).collect(), true);
    let open = Curve::from_path_data("M0 0 C0 1 1 2 2 2 S4 3 4 4").unwrap();
    Curve::new([vec![circle], open.components().to_vec()].concat()).unwrap()
}

fn param(component: u32, segment: u32, t: f64) -> CurveParam {
    CurveParam {
        component,
        segment,
        t,
    }
}

#[test]
fn per_segment_is_the_discretisation_of_the_paper() {
    let curve = curve();
    for n in [1, 3, 300] {
        let dense = DenseCurve::per_segment(&curve, n).unwrap();
        let count = n as usize;
        let expected = [
            Component {
                range: 0..16 * count,
                closed: true,
            },
            Component {
                range: 16 * count..18 * count + 1,
                closed: false,
            },
        ];
        assert_eq!(dense.components(), expected);
        assert_eq!(dense.params()[count], param(0, 1, 0.0));
        assert_eq!(dense.params()[18 * count], param(1, 1, 1.0));
        assert_eq!(dense.points()[18 * count], DVec2::new(4.0, 4.0));
        for (&p, &at) in dense.points().iter().zip(dense.params()) {
            assert_eq!(p, curve.point(at));
        }
    }
}

#[test]
fn neighbours_wrap_on_closed_components_only() {
    let dense = DenseCurve::per_segment(&curve(), 2).unwrap();
    let last = dense.len() - 1;
    assert_eq!((dense.previous(0), dense.next(0)), (Some(31), Some(1)));
    assert_eq!((dense.previous(31), dense.next(31)), (Some(30), Some(0)));
    assert_eq!((dense.previous(32), dense.next(32)), (None, Some(33)));
    assert_eq!((dense.previous(last), dense.next(last)), (Some(35), None));
    assert_eq!(
        (dense.previous(last + 1), dense.next(last + 1)),
        (None, None)
    );
    assert_eq!((dense.component_of(31), dense.component_of(32)), (0, 1));
}

#[test]
fn doubling_every_gap_is_per_segment_with_twice_the_number() {
    let curve = curve();
    for n in [1, 2, 5, 64] {
        let coarse = DenseCurve::per_segment(&curve, n).unwrap();
        let refined = coarse.refined(&curve, &vec![2; coarse.len()]).unwrap();
        let fine = DenseCurve::per_segment(&curve, 2 * n).unwrap();
        assert_eq!(refined.components(), fine.components());
        for i in 0..fine.len() {
            let (a, b) = (refined.params()[i], fine.params()[i]);
            assert_eq!((a.component, a.segment), (b.component, b.segment));
            assert!((a.t - b.t).abs() < 1e-15);
            assert!(refined.points()[i].distance(fine.points()[i]) < 1e-13);
        }
    }
}

#[test]
fn gaps_over_the_end_of_a_segment_are_cut_in_both() {
    let curve = curve();
    let points = |params: &[CurveParam]| params.iter().map(|&at| curve.point(at)).collect();
    let params = vec![
        param(0, 3, 0.5),
        param(1, 0, 0.0),
        param(1, 0, 0.5),
        param(1, 1, 0.5),
    ];
    let components = vec![
        Component {
            range: 0..1,
            closed: true,
        },
        Component {
            range: 1..4,
            closed: false,
        },
    ];
    let dense = DenseCurve::new(points(&params), params, components).unwrap();
    let refined = dense.refined(&curve, &[1, 1, 4, 7]).unwrap();
    let expected = [
        param(0, 3, 0.5),
        param(1, 0, 0.0),
        param(1, 0, 0.5),
        param(1, 0, 0.75),
        param(1, 1, 0.0),
        param(1, 1, 0.25),
        param(1, 1, 0.5),
    ];
    assert_eq!(refined.params(), expected);
}

#[test]
fn single_precision() {
    let dense = DenseCurve::per_segment(&curve(), 7).unwrap();
    let single = DenseCurve::per_segment_in_single(&curve(), 7).unwrap();
    assert_eq!(single.params(), dense.params());
    for (p, q) in dense.points().iter().zip(single.points()) {
        assert!(p.distance(*q) <= 1e-5);
        assert_eq!(*q, q.as_vec2().as_dvec2());
    }
    let huge = Curve::from_path_data("M0 0 H1e40").unwrap();
    assert!(matches!(
        DenseCurve::per_segment_in_single(&huge, 1),
        Err(DenseError::Coordinate { .. })
    ));
}

#[test]
fn what_cannot_be_is_an_error() {
    let curve = curve();
    let dense = DenseCurve::per_segment(&curve, 2).unwrap();
    let with = |i: usize, n: u32| {
        let mut pieces = vec![1; dense.len()];
        pieces[i] = n;
        dense.refined(&curve, &pieces)
    };
    assert_eq!(
        DenseCurve::per_segment(&curve, 0),
        Err(DenseError::NoPieces { index: 0 })
    );
    assert_eq!(
        DenseCurve::per_segment(&curve, u32::MAX),
        Err(DenseError::TooMany {
            count: 18 * u64::from(u32::MAX)
        })
    );
    assert_eq!(with(3, 0), Err(DenseError::NoPieces { index: 3 }));
    let too_many = DENSE_LIMIT as u64 + 1;
    let pieces = u32::try_from(DENSE_LIMIT - dense.len() + 2).unwrap();
    assert_eq!(
        with(3, pieces),
        Err(DenseError::TooMany { count: too_many })
    );
    assert_eq!(
        dense.refined(&curve, &[1]).unwrap_err().to_string(),
        "37 points, but 1 numbers of pieces: give one for each"
    );
    let other = Curve::from_path_data("M0 0 H1").unwrap();
    assert_eq!(
        dense.refined(&other, &vec![1; dense.len()]),
        Err(DenseError::Param { index: 0 })
    );
}

#[test]
fn explicit_points_are_checked() {
    let points = vec![DVec2::ZERO, DVec2::X, DVec2::Y];
    let params = vec![param(0, 0, 0.0), param(0, 0, 0.5), param(1, 0, 0.0)];
    let parts = |ranges: &[(usize, usize)]| -> Vec<Component> {
        let component = |&(start, end)| Component {
            range: start..end,
            closed: false,
        };
        ranges.iter().map(component).collect()
    };
    let good = parts(&[(0, 2), (2, 3)]);
    assert!(DenseCurve::new(points.clone(), params.clone(), good.clone()).is_ok());
    for (ranges, component) in [
        (vec![], 0),
        (vec![(0, 2)], 1),
        (vec![(0, 2), (2, 4)], 1),
        (vec![(0, 2), (1, 3)], 1),
        (vec![(0, 2), (2, 2), (2, 3)], 1),
    ] {
        assert_eq!(
            DenseCurve::new(points.clone(), params.clone(), parts(&ranges)),
            Err(DenseError::Range { component }),
            "{ranges:?}"
        );
    }
    for (index, wrong) in [
        (0, param(1, 0, 0.0)),
        (0, param(0, 0, f64::NAN)),
        (1, param(0, 0, 1.5)),
        (1, param(0, 0, 0.0)),
        (2, param(0, 1, 0.0)),
    ] {
        let mut params = params.clone();
        params[index] = wrong;
        assert_eq!(
            DenseCurve::new(points.clone(), params, good.clone()),
            Err(DenseError::Param { index })
        );
    }
    for x in [f64::NAN, f64::INFINITY, 1e61] {
        let points = vec![DVec2::ZERO, DVec2::new(0.0, x), DVec2::Y];
        assert!(matches!(
            DenseCurve::new(points, params.clone(), good.clone()),
            Err(DenseError::Coordinate { index: 1, .. })
        ));
    }
    assert!(DenseCurve::new(vec![], vec![], vec![]).unwrap().is_empty());
}

proptest! {
    #[test]
    fn refining_keeps_points_and_order(
        n in 1u32..4,
        pieces in prop::collection::vec(1u32..6, 64),
        again in prop::collection::vec(1u32..4, 512),
    ) {
        let curve = curve();
        let coarse = DenseCurve::per_segment(&curve, n).unwrap();
        let mut dense = coarse.clone();
        for list in [&pieces, &again] {
            let list: Vec<u32> = list.iter().copied().cycle().take(dense.len()).collect();
            let cut = |i: usize| dense.next(i).map_or(1, |_| list[i] as usize);
            let count: usize = (0..dense.len()).map(cut).sum();
            dense = dense.refined(&curve, &list).unwrap();
            prop_assert_eq!(dense.len(), count);
        }
        let mut kept = dense.points().iter();
        prop_assert!(coarse.points().iter().all(|p| kept.any(|q| q == p)));
        for (i, &at) in dense.params().iter().enumerate() {
            prop_assert!(dense.points()[i].distance(curve.point(at)) < 1e-13);
            prop_assert_eq!(dense.next(i).and_then(|j| dense.previous(j)).unwrap_or(i), i);
        }
    }
}

#[test]
fn a_closed_component_of_one_point_is_refined_all_round() {
    // One segment that closes smoothly cannot be drawn as a cubic; two can.
    let arc = |s: f64| {
        let x = DVec2::new(s, 0.0);
        let handle = DVec2::new(0.0, 4.0 / 3.0 * s);
        CubicBezier::new([x, x + handle, -x + handle, -x])
    };
    let circle = BezierPath::new(vec![arc(1.0), arc(-1.0)], true);
    let curve = Curve::new(vec![circle]).unwrap();
    let component = Component {
        range: 0..1,
        closed: true,
    };
    let start = DenseCurve::new(vec![DVec2::X], vec![param(0, 0, 0.0)], vec![component]).unwrap();
    assert_eq!(start.next(0), Some(0));
    let refined = start.refined(&curve, &[4]).unwrap();
    assert_eq!(refined, DenseCurve::per_segment(&curve, 2).unwrap());
}
