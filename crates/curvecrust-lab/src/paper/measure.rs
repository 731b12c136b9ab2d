//! Computes the rows of the tables.

use super::models::Model;
use super::published;
use super::rows::{CurveOrigin, PaperReport, Sampled, Setting, Table1Row, Table2Row, Table3Row};
use anyhow::Context;
use curvecrust::curve::DenseCurve;
use curvecrust::evaluate::EdgeComparison;
use curvecrust::medial_axis::{
    Discretisation, Estimator, MeasureOptions, MeasuredCurve, measure_with,
};
use curvecrust::reconstruct::hnn_crust;
use curvecrust::sampling::{Condition, sample_as_published, theory};
use rayon::prelude::*;

/// An estimator of lfs, and the dense points that it works on.
#[derive(Clone, Copy, PartialEq)]
pub enum Run {
    /// The Voronoi medial axis.
    Voronoi(Points),
    /// The estimator of the paper's authors.
    ShrinkingBall(Points),
}

/// How many dense points a curve gets.
#[derive(Clone, Copy, PartialEq)]
pub enum Points {
    /// 300 a segment, as in the authors' program.
    PerSegment,
    /// As many as lfs asks for: gaps at most this fraction of it.
    Adaptive(f64),
}

/// Points a segment in the authors' program.
const PER_SEGMENT: u32 = 300;
/// Fine enough that counts have converged: half of it changes none by more than 1 %, or 1.
pub const CONVERGED: Points = Points::Adaptive(0.005);
/// Table 3 is about this model.
const LIMITED: &str = "bunny";

impl Run {
    /// What rows say of it.
    #[must_use]
    pub fn setting(self) -> Setting {
        let (lfs, points) = match self {
            Self::Voronoi(points) => ("voronoi", points),
            Self::ShrinkingBall(points) => ("shrinking-ball", points),
        };
        let discretisation = match points {
            Points::PerSegment => "300",
            Points::Adaptive(_) => "adaptive",
        };
        Setting {
            lfs,
            discretisation,
        }
    }

    pub(super) fn measure(self, model: &Model) -> anyhow::Result<MeasuredCurve> {
        let (points, estimator) = match self {
            Self::Voronoi(points) => (points, Estimator::Voronoi),
            Self::ShrinkingBall(points) => (points, Estimator::ShrinkingBall),
        };
        let by = |discretisation| {
            let options = MeasureOptions {
                discretisation,
                estimator,
                ..MeasureOptions::default()
            };
            measure_with(&model.curve, &options)
        };
        let measured = match (points, estimator) {
            (Points::PerSegment, Estimator::ShrinkingBall) => {
                let dense = DenseCurve::per_segment_in_single(&model.curve, PER_SEGMENT)?;
                MeasuredCurve::new(dense, estimator)
            }
            (Points::PerSegment, Estimator::Voronoi) => by(Discretisation::PerSegment(PER_SEGMENT)),
            (Points::Adaptive(gap_to_lfs), _) => by(Discretisation::Adaptive { gap_to_lfs }),
        };
        measured.with_context(|| model.name.to_owned())
    }
}

/// Table 1, from the lemmas, to the digits that the paper prints.
pub(crate) fn table_1() -> Vec<Table1Row> {
    published::TABLE_1
        .iter()
        .map(|row| {
            let angle = if row.angle_from_bound {
                theory::least_angle(row.bound)
            } else {
                row.min_angle_deg.to_radians()
            };
            let tenths = |value: f64| (10.0 * value).round() / 10.0;
            Table1Row {
                algorithm: row.algorithm,
                condition: row.condition,
                bound: row.bound,
                min_angle_deg: angle.to_degrees().round(),
                circle: tenths(theory::samples_on_circle(angle)),
                parallel: tenths(theory::samples_on_parallel_lines(row.bound)),
            }
        })
        .collect()
}

/// Those of Tables 2 and 3 that are wanted, setting by setting in the order of the runs.
pub(crate) fn tables_2_and_3(
    models: &[Model],
    runs: &[Run],
    [second, third]: [bool; 2],
) -> anyhow::Result<PaperReport> {
    let wanted = |model: &&Model| second || (third && model.name == LIMITED);
    let jobs: Vec<(Run, &Model)> = runs
        .iter()
        .flat_map(|&run| models.iter().filter(wanted).map(move |model| (run, model)))
        .collect();
    let done: Vec<(Option<Table2Row>, Vec<Table3Row>)> = jobs
        .into_par_iter()
        .map(|(run, model)| {
            let measured = run.measure(model)?;
            let second = second.then(|| sampled(run, &measured, None)).transpose()?;
            let second = second.map(|sampled| Table2Row {
                model: model.name,
                sampled,
            });
            let limits = published::PAPER.limits.iter().map(|row| row.0);
            let limits = limits.filter(|_| third && model.name == LIMITED);
            let third = limits.map(|limit_percent| {
                let limit = limit_percent.map(|percent| percent / 100.0 * model.curve.extent());
                Ok(Table3Row {
                    limit_percent,
                    sampled: sampled(run, &measured, limit)?,
                })
            });
            Ok((second, third.collect::<anyhow::Result<_>>()?))
        })
        .collect::<anyhow::Result<_>>()?;
    let (second, third): (Vec<_>, Vec<_>) = done.into_iter().unzip();
    Ok(PaperReport {
        curves: CurveOrigin::Given,
        table1: Vec::new(),
        table2: second.into_iter().flatten().collect(),
        table3: third.into_iter().flatten().collect(),
        fewest: Vec::new(),
    })
}

/// Samples as the paper did under its three conditions, and reconstructs.
fn sampled(
    run: Run,
    measured: &MeasuredCurve,
    hausdorff_limit: Option<f64>,
) -> anyhow::Result<Sampled> {
    let mut counts = [0; 3];
    let (mut reconstructed, mut closing_intervals_hold) = (true, true);
    let conditions = [
        Condition::rho(0.9)?,
        Condition::epsilon(0.47)?,
        Condition::epsilon(1.0 / 3.0)?,
    ];
    for (count, condition) in counts.iter_mut().zip(conditions) {
        let condition = match hausdorff_limit {
            Some(limit) => condition.with_hausdorff_limit(limit)?,
            None => condition,
        };
        let sampled = sample_as_published(measured, condition).samples;
        let found = hnn_crust(&sampled.point_set()?);
        let comparison = EdgeComparison::new(&sampled.manifold_boundary(), &found);
        *count = sampled.len();
        reconstructed &= comparison.is_exact();
        let intervals = sampled.closing_intervals();
        closing_intervals_hold &= intervals.iter().all(|interval| interval.holds);
    }
    Ok(Sampled {
        setting: run.setting(),
        counts: counts.into(),
        reconstructed,
        closing_intervals_hold,
    })
}
