//! Samplings beyond the bound: what they keep, and that local steps decide as full runs would.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_curve::Curve;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, Segment};
use curvecrust_medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use curvecrust_reconstruct::{AlgorithmInfo, Crust, HnnCrust, Reconstructor, hnn_crust};
use curvecrust_sampling::{
    Condition, DeviationLimit, SampledCurve, Sampling, SamplingError, VerifyOptions, sample,
    sample_uniformly, sample_verified_with,
};
use curvecrust_testing::fixtures;

fn measured(curve: &Curve) -> MeasuredCurve {
    let options = MeasureOptions {
        discretisation: Discretisation::Adaptive { gap_to_lfs: 0.03 },
        ..MeasureOptions::default()
    };
    measure_with(curve, &options).unwrap()
}

fn fixture(wanted: &str) -> MeasuredCurve {
    measured(&fixtures::curve(wanted))
}

fn start(measured: &MeasuredCurve) -> Sampling {
    sample(measured, Condition::rho(0.9).unwrap()).unwrap()
}

fn options(algorithm: &dyn Reconstructor, deviation: DeviationLimit) -> VerifyOptions<'_> {
    VerifyOptions {
        algorithm,
        deviation,
        rounds: 10,
        seed: 2,
        ..VerifyOptions::default()
    }
}

/// The largest distance of a dense point to the chord of its interval, as a fraction of its lfs.
fn deviation(measured: &MeasuredCurve, sampled: &SampledCurve) -> f64 {
    let (dense, mut worst) = (measured.dense(), 0.0f64);
    for component in sampled.components() {
        let samples = &sampled.dense_indices()[component.range.clone()];
        let next = samples.iter().cycle().skip(1);
        let joined = samples.len() - usize::from(!component.closed);
        for (&from, &to) in samples.iter().zip(next).take(joined) {
            let chord = Segment::new(dense.points()[from], dense.points()[to]);
            let mut at = from;
            while at != to {
                worst = worst.max(chord.distance(dense.points()[at]) / measured.lfs().at(at));
                at = dense.next(at).unwrap();
            }
        }
    }
    worst
}

#[test]
fn fewer_samples_are_reconstructed_all_the_same() {
    for (name, most) in [
        ("teaser", 0.85),
        ("bunny", 0.8),
        ("berries", 0.9),
        ("wave", 0.9),
    ] {
        let measured = fixture(name);
        let start = start(&measured);
        let options = options(&HnnCrust::MUTUAL, DeviationLimit::OfLfs(0.9));
        let found = sample_verified_with(&start, &options).unwrap();
        let samples = &found.samples;
        assert!(
            (samples.len() as f64) < most * start.samples.len() as f64,
            "{name} {}",
            samples.len()
        );
        assert_eq!(
            hnn_crust(&samples.point_set().unwrap()),
            samples.manifold_boundary()
        );
        assert!(deviation(&measured, samples) < 0.9);
        let components = start.samples.components();
        assert_eq!(samples.components().len(), components.len());
        // What they attain is told, though nothing asks for it.
        assert!(found.attained.unwrap().bound > start.attained.unwrap().bound);
        let again = sample_verified_with(&start, &options).unwrap();
        assert_eq!(found, again);
    }
}

/// HNN-Crust under another name: nothing is known of what a step can change.
#[derive(Debug)]
struct Unknown;

impl Reconstructor for Unknown {
    fn info(&self) -> AlgorithmInfo {
        let mut info = HnnCrust::MUTUAL.info();
        info.name = "unknown";
        info
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        hnn_crust(points)
    }
}

#[test]
fn local_steps_decide_as_full_runs() {
    for name in ["teaser", "berries", "bunny", "wave"] {
        let measured = fixture(name);
        let start = start(&measured);
        let run = |algorithm: &dyn Reconstructor| {
            let mut options = options(algorithm, DeviationLimit::OfLfs(0.9));
            options.rounds = 3;
            sample_verified_with(&start, &options).unwrap().samples
        };
        let [local, full] = [run(&HnnCrust::MUTUAL), run(&Unknown)];
        let start = &start.samples;
        if start.components().iter().all(|component| component.closed) {
            assert_eq!(local, full, "{name}");
        } else {
            // Local steps ask more of the ends of open curves.
            assert!(
                full.len() < start.len()
                    && local.len() < start.len()
                    && full.len() < local.len() + 3
            );
        }
    }
}

#[test]
fn other_algorithms_and_limits() {
    let measured = fixture("teaser");
    let start = sample(&measured, Condition::epsilon(0.2).unwrap()).unwrap();
    let limit = DeviationLimit::Length(0.5 * measured.lfs().minimum());
    let found = sample_verified_with(&start, &options(&Crust, limit)).unwrap();
    assert!(found.samples.len() < start.samples.len() / 2);
    let points = found.samples.point_set().unwrap();
    assert_eq!(
        Crust.reconstruct(&points),
        found.samples.manifold_boundary()
    );

    // Without a limit what is left need not look like the curve.
    let none = options(&HnnCrust::MUTUAL, DeviationLimit::None);
    let few = sample_verified_with(&start, &none).unwrap().samples;
    assert!(few.len() < 10 && deviation(&measured, &few) > 1.0);
}

/// Without a limit, so that all that counts is what HNN-Crust returns.
#[test]
fn no_single_sample_can_go() {
    for name in ["teaser", "berries"] {
        let measured = fixture(name);
        let mut options = options(&HnnCrust::MUTUAL, DeviationLimit::None);
        options.rounds = 1;
        let found = sample_verified_with(&start(&measured), &options);
        let samples = found.unwrap().samples;
        for component in samples.components() {
            assert!(component.closed, "{name}");
            for removed in component.range.clone() {
                if component.range.len() > 3 {
                    assert!(!holds_without(&samples, removed), "{name} {removed}");
                }
            }
        }
    }
}

/// Whether HNN-Crust returns the closed components without one of their samples.
fn holds_without(samples: &SampledCurve, removed: usize) -> bool {
    let index = |sample: usize| PointId::new(sample - usize::from(sample > removed)).unwrap();
    let joined = samples.components().iter().flat_map(|component| {
        let left: Vec<usize> = component.range.clone().filter(|&s| s != removed).collect();
        let next = left.clone().into_iter().cycle().skip(1);
        left.into_iter().zip(next)
    });
    let edges: Vec<Edge> = joined
        .map(|(s, next)| Edge::new(index(s), index(next)).unwrap())
        .collect();
    let mut points = samples.points().to_vec();
    points.remove(removed);
    let points = PointSet::new(points).unwrap();
    hnn_crust(&points) == EdgeSet::new(points.len(), edges)
}

/// On an arc of less than half a turn HNN-Crust joins any samples in order: the one in the middle
/// of three sees the others at an obtuse angle, and nothing is in the half-plane of an end. So only
/// the ends stay.
#[test]
fn of_an_arc_only_the_ends_stay() {
    let arc = Curve::from_path_data("M -40 9 A 41 41 0 0 1 40 9").unwrap();
    let measured = measured(&arc);
    let start = start(&measured);
    assert!(start.samples.len() > 2);
    let mut options = options(&HnnCrust::MUTUAL, DeviationLimit::None);
    options.rounds = 0;
    let found = sample_verified_with(&start, &options).unwrap();
    assert_eq!(
        found.samples.dense_indices(),
        [0, measured.dense().len() - 1]
    );
}

#[test]
fn what_is_no_start_is_refused() {
    let measured = fixture("teaser");
    let coarse = sample_uniformly(&measured, 150.0).unwrap();
    let verify =
        |start: &Sampling, limit| sample_verified_with(start, &options(&HnnCrust::MUTUAL, limit));
    let refused = verify(&coarse, DeviationLimit::None);
    assert!(matches!(
        refused,
        Err(SamplingError::NotReconstructed {
            algorithm: "hnn-crust"
        })
    ));
    let refused = verify(&start(&measured), DeviationLimit::Length(1e-3));
    assert!(matches!(
        refused,
        Err(SamplingError::LimitExceeded { component: 0, .. })
    ));
    let mut elsewhere = start(&fixture("bunny"));
    elsewhere.measured = measured.clone();
    let refused = verify(&elsewhere, DeviationLimit::None);
    assert!(matches!(
        refused,
        Err(SamplingError::NoSuchPlace { .. } | SamplingError::OffCurve { .. })
    ));
}
