//! Projection by brute force, the ends of components, and places that are none.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

mod common;

use common::arch;
use curvecrust_curve::Curve;
use curvecrust_geometry::{DVec2, Random, Segment};
use curvecrust_medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use curvecrust_sampling::{PlacedSamples, Placement, SamplingError};

fn measured(d: &str, per_segment: u32) -> MeasuredCurve {
    let curve = Curve::from_path_data(d).unwrap();
    let options = MeasureOptions {
        discretisation: Discretisation::PerSegment(per_segment),
        ..MeasureOptions::default()
    };
    measure_with(&curve, &options).unwrap()
}

/// A stadium and an arch beside it.
fn curves() -> MeasuredCurve {
    measured(
        "M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z M 10 0 C 10 4 16 4 16 0",
        12,
    )
}

#[test]
fn projections_are_the_nearest_places() {
    let measured = curves();
    let (dense, mut random) = (measured.dense(), Random::new(11));
    let chord = |i: usize| {
        Some(Segment::new(
            dense.points()[i],
            dense.points()[dense.next(i)?],
        ))
    };
    for _ in 0..400 {
        let p = DVec2::new(
            random.fine_between(-3.0, 19.0),
            random.fine_between(-3.0, 5.0),
        );
        let found = PlacedSamples::project(&measured, &[p], 20.0).unwrap();
        let place = found.samples.placements()[0];
        let chords = (0..dense.len()).filter_map(chord);
        let nearest = chords.map(|c| c.distance(p)).fold(f64::INFINITY, f64::min);
        assert!((found.distances[0] - nearest).abs() < 1e-12);
        // At an open end there is no chord, and t is 0.
        let (start, end) =
            chord(place.dense).map_or([dense.points()[place.dense]; 2].into(), |c| (c.a, c.b));
        assert!((0.0..1.0).contains(&place.t) && place.point == p);
        assert!((start.lerp(end, place.t).distance(p) - nearest).abs() < 1e-12);
        let component = dense.component_of(place.dense);
        let expected = [[0..1, 1..1], [0..0, 0..1]][component].clone();
        assert_eq!(found.samples.components(), expected);
    }
}

#[test]
fn a_sample_may_be_as_far_as_the_tolerance() {
    let line = measured("M 0 0 H 3", 3);
    let above = [DVec2::new(1.5, 0.25)];
    let found = PlacedSamples::project(&line, &above, 0.25).unwrap();
    let expected = Placement {
        point: above[0],
        dense: 1,
        t: 0.5,
    };
    assert_eq!(found.samples.placements(), [expected]);
    let refused = PlacedSamples::project(&line, &above, 0.25f64.next_down());
    assert!(matches!(
        refused,
        Err(SamplingError::OffCurve { index: 0, .. })
    ));
    assert!(PlacedSamples::project(&line, &above, -0.25).is_err());
}

/// The last gap of a closed component begins at its last point; behind that of an open one there is
/// none.
#[test]
fn only_closed_components_go_on_behind_their_last_point() {
    let measured = curves();
    let dense = measured.dense();
    let place = |dense: usize, t| Placement {
        point: measured.dense().points()[dense],
        dense,
        t,
    };
    let [stadium, arch] = dense.components() else {
        panic!()
    };
    let (seam, end) = (stadium.range.end - 1, arch.range.end - 1);
    let both = [
        place(seam, 0.5),
        place(0, 0.0),
        place(arch.range.start, 0.0),
        place(end, 0.0),
    ];
    let samples = PlacedSamples::new(&measured, both.to_vec()).unwrap();
    assert_eq!(samples.components(), [0..2, 2..4]);
    let refused = [
        PlacedSamples::new(&measured, vec![place(end, f64::MIN_POSITIVE)]),
        PlacedSamples::new(&measured, vec![place(0, -0.5)]),
        PlacedSamples::new(
            &measured,
            vec![Placement {
                dense: dense.len(),
                ..both[0]
            }],
        ),
    ];
    for refused in refused {
        assert!(matches!(
            refused,
            Err(SamplingError::NoSuchPlace { index: 0, .. })
        ));
    }
    // The components in the wrong order.
    let refused = PlacedSamples::new(&measured, vec![both[2], both[1]]);
    let expected = SamplingError::OutOfOrder {
        index: 1,
        component: 0,
    };
    assert_eq!(refused, Err(expected));
}

#[test]
fn samples_out_of_place_are_refused() {
    let arch = arch();
    let place = |dense, t| Placement {
        point: arch.dense().points()[dense],
        dense,
        t,
    };
    let last = arch.dense().len() - 1;
    let out_of_order = Err(SamplingError::OutOfOrder {
        index: 2,
        component: 0,
    });
    for second in [place(3, 0.0), place(3, 0.5), place(7, 0.5)] {
        let samples = vec![place(1, 0.0), place(7, 0.5), second];
        assert_eq!(PlacedSamples::new(&arch, samples), out_of_order);
    }
    for bad in [place(last, 0.5), place(0, 1.0), place(0, f64::NAN)] {
        let refused = PlacedSamples::new(&arch, vec![bad]);
        assert!(matches!(
            refused,
            Err(SamplingError::NoSuchPlace { index: 0, .. })
        ));
    }

    let off = [DVec2::ZERO, DVec2::new(3.0, 3.5)];
    let refused = PlacedSamples::project(&arch, &off, 0.1).unwrap_err();
    let SamplingError::OffCurve {
        index,
        at,
        distance,
        ..
    } = refused
    else {
        panic!("{refused}");
    };
    assert!((index, at) == (1, off[1]) && (distance - 0.5).abs() < 1e-3);

    // Both before the start: the place of both is the start.
    let twice = [DVec2::new(6.0, 0.0), DVec2::new(0.0, -0.1), DVec2::ZERO];
    let refused = PlacedSamples::project(&arch, &twice, 0.1).unwrap_err();
    let same = SamplingError::SamePlace {
        samples: [1, 2],
        at: twice[1],
    };
    assert_eq!(refused, same);
    assert!(PlacedSamples::project(&arch, &[DVec2::NAN], 0.1).is_err());
    for bad in [f64::NAN, -1.0, f64::INFINITY] {
        let refused = PlacedSamples::project(&arch, &[DVec2::ZERO], bad).unwrap_err();
        assert!(matches!(
            refused,
            SamplingError::Parameter {
                name: "tolerance",
                ..
            }
        ));
    }

    let backwards = [DVec2::new(6.0, 0.0), DVec2::new(3.0, 3.01), DVec2::ZERO];
    let projected = PlacedSamples::project(&arch, &backwards, 0.1).unwrap();
    assert_eq!(projected.indices, [2, 1, 0]);
    assert!((projected.distances[1] - 0.01).abs() < 1e-4);
}

#[test]
fn the_boundary_of_projected_samples_joins_neighbours_by_their_indices() {
    let d = "M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z M 3 0 H 9";
    let measured = measured(d, 12);
    let points = [
        (9.0, 0.0),
        (0.0, 1.0),
        (3.0, 0.0),
        (1.0, 0.0),
        (5.0, 0.0),
        (-1.0, 0.0),
    ];
    let points = points.map(|(x, y)| DVec2::new(x, y));
    let placed = PlacedSamples::project(&measured, &points, 1e-3).unwrap();
    let found = placed.manifold_boundary(&measured);
    let pairs: Vec<_> = found
        .edges()
        .iter()
        .map(|e| e.ends().map(|v| v.index()))
        .collect();
    assert_eq!(pairs, [[0, 4], [1, 3], [1, 5], [2, 4], [3, 5]]);
}
