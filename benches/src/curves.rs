//! Medial axis, lfs and sampling of one dense smooth curve.

use std::error::Error;

use curvecrust_curve::{Curve, CurveParam, DenseCurve};
use curvecrust_geometry::Component;
use curvecrust_medial_axis::{Estimator, MeasuredCurve};
use curvecrust_sampling::{Condition, sample, sample_at_dense_points, sample_curve, sample_fewest};

use crate::comparison::{Goal, Row, Task, medians, per_element};
use crate::stages::Sizes;
use curvecrust_testing::planted::one_curve;

/// The points of `one_curve`, in order along the curve.
///
/// # Errors
/// None for sizes that the generator takes.
pub fn dense_one_curve(count: usize) -> Result<DenseCurve, Box<dyn Error>> {
    let points = one_curve(count)?.points.points().to_vec();
    let params = (0..count).map(|i| CurveParam {
        component: 0,
        segment: 0,
        t: i as f64 / count as f64,
    });
    let whole = Component {
        range: 0..count,
        closed: true,
    };
    Ok(DenseCurve::new(points, params.collect(), vec![whole])?)
}

/// The whole of lfs (Delaunay, axis, all queries): its time, its growth and its precision. One
/// thread.
///
/// # Errors
/// None for these sizes.
pub fn lfs(sizes: Sizes) -> Result<Vec<Row>, Box<dyn Error>> {
    let counts = [sizes.small, sizes.medium, sizes.large];
    let dense: Vec<DenseCurve> = counts
        .into_iter()
        .map(dense_one_curve)
        .collect::<Result<_, _>>()?;
    let lfs = |i: usize| {
        let dense: &DenseCurve = &dense[i];
        Task::new("lfs", move || {
            MeasuredCurve::new(dense.clone(), Estimator::Voronoi)
        })
    };
    let times = medians((0..3).map(lfs).collect(), sizes.rounds.div_ceil(2));
    let [small, medium, large] = [0, 1, 2].map(|i| per_element(times[i], counts[i]));
    let exponent = (times[2] / times[0]).ln() / (counts[2] as f64 / counts[0] as f64).ln();
    Ok(vec![
        Row {
            what: format!("lfs of one-curve {}, seconds", counts[1]),
            measured: format!("{medium} a point"),
            figure: times[1],
            goal: Goal::AtMost(0.35),
        },
        Row {
            what: format!(
                "growth of lfs, one-curve {} to {}, exponent",
                counts[0], counts[2]
            ),
            measured: format!("{small}, {large} a point"),
            figure: exponent,
            goal: Goal::AtMost(1.15),
        },
        Row {
            what: format!(
                "lfs against brute-force shrinking balls, one-curve {}",
                counts[0]
            ),
            measured: "relative difference in the mean, times 10^4".to_owned(),
            figure: 1e4 * difference(&dense[0])?,
            goal: Goal::AtMost(1.0),
        },
    ])
}

/// Sampling with lfs given, and the whole way from a drawing to samples; one thread.
///
/// # Errors
/// None for these sizes.
pub fn sampling(sizes: Sizes) -> Result<Vec<Row>, Box<dyn Error>> {
    let counts = [sizes.small, sizes.medium, sizes.large];
    let measured = |count| -> Result<MeasuredCurve, Box<dyn Error>> {
        Ok(MeasuredCurve::new(
            dense_one_curve(count)?,
            Estimator::Voronoi,
        )?)
    };
    let measured: Vec<MeasuredCurve> =
        counts.into_iter().map(measured).collect::<Result<_, _>>()?;
    let mut rows = samplers(&measured[2], sizes.rounds)?;
    rows.extend(growth(&measured, sizes.rounds)?);
    rows.push(pipeline(sizes.rounds)?);
    Ok(rows)
}

/// The time of certified sampling per dense point, from few of them to many.
fn growth(measured: &[MeasuredCurve], rounds: usize) -> Result<Vec<Row>, Box<dyn Error>> {
    let mut rows = Vec::new();
    for (name, condition) in conditions()? {
        let task = |measured| Task::new(name, move || sample(measured, condition));
        let times = medians(measured.iter().map(task).collect(), rounds.div_ceil(2));
        let counts = measured.iter().map(|measured| measured.dense().len());
        let each: Vec<f64> = times
            .iter()
            .zip(counts.clone())
            .map(|(t, n)| t / n as f64)
            .collect();
        let least = each.iter().copied().fold(f64::INFINITY, f64::min);
        let most = each.iter().copied().fold(0.0, f64::max);
        let sizes: Vec<String> = counts.clone().map(|count| count.to_string()).collect();
        let times: Vec<String> = times
            .iter()
            .zip(counts)
            .map(|(&t, n)| per_element(t, n))
            .collect();
        rows.push(Row {
            what: format!(
                "certified sampling, {name}, one-curve {}: most / least time a point",
                sizes.join(", ")
            ),
            measured: format!("{} a point", times.join(", ")),
            figure: most / least,
            goal: Goal::AtMost(1.5),
        });
    }
    Ok(rows)
}

/// A drawing of 43 cubic segments.
pub const CAT: &str = include_str!("../../fixtures/curves/cat.svg");

/// From the text of a drawing to certified samples.
fn pipeline(rounds: usize) -> Result<Row, Box<dyn Error>> {
    let rho = Condition::rho(0.9)?;
    let run = || -> Result<usize, Box<dyn Error>> {
        let curve = Curve::from_svg(CAT)?;
        Ok(sample_curve(&curve, rho)?.samples.len())
    };
    let count = run()?;
    let times = medians(vec![Task::new("pipeline", run)], rounds);
    Ok(Row {
        what: "SVG of 43 cubic segments (cat) to certified samples, rho < 0.9, milliseconds"
            .to_owned(),
        measured: format!("{count} samples"),
        figure: 1e3 * times[0],
        goal: Goal::AtMost(100.0),
    })
}

fn conditions() -> Result<[(&'static str, Condition); 2], Box<dyn Error>> {
    Ok([
        ("rho < 0.9", Condition::rho(0.9)?),
        ("epsilon < 0.47", Condition::epsilon(0.47)?),
    ])
}

fn samplers(measured: &MeasuredCurve, rounds: usize) -> Result<Vec<Row>, Box<dyn Error>> {
    let count = measured.dense().len();
    let mut rows = Vec::new();
    for (name, condition) in conditions()? {
        let tasks = vec![
            Task::new("certified", || sample(measured, condition)),
            Task::new("dense points", || {
                sample_at_dense_points(measured, condition)
            }),
            Task::new("fewest", || sample_fewest(measured, condition)),
        ];
        let times = medians(tasks, rounds.div_ceil(3));
        let row = |what: &str, seconds, goal| Row {
            what: format!("{what}, {name}, one-curve {count}, seconds"),
            measured: format!("{} a point", per_element(seconds, count)),
            figure: seconds,
            goal: Goal::AtMost(goal),
        };
        rows.extend([
            row("certified sampling", times[0], 0.15),
            row("sampling at dense points", times[1], 0.15),
            row("fewest samples", times[2], 1.0),
        ]);
    }
    Ok(rows)
}

/// The mean relative difference of the two estimators of lfs.
fn difference(dense: &DenseCurve) -> Result<f64, Box<dyn Error>> {
    let [voronoi, balls] = [Estimator::Voronoi, Estimator::ShrinkingBall]
        .map(|estimator| MeasuredCurve::new(dense.clone(), estimator));
    let (voronoi, balls) = (voronoi?, balls?);
    let pairs = voronoi.lfs().values().iter().zip(balls.lfs().values());
    let sum: f64 = pairs.map(|(a, b)| (a / b - 1.0).abs()).sum();
    Ok(sum / dense.len() as f64)
}
