//! Samples of closed splines, and a bound that they are proven to satisfy.

use super::dense::Dense;
use crate::figure::bounds;
use anyhow::Context;
use curvecrust::DVec2;
use curvecrust::geometry::{Component, EdgeSet, PointSet};
use curvecrust::sampling::Bound;
use curvecrust_proof::{ClosedSpline, SampledSplines, SamplingCondition};

/// Samples of closed splines, and the sampling condition that they satisfy.
#[derive(Clone, Debug)]
pub struct ProvenSamples {
    /// The condition, and the bound for which it is proven.
    pub bound: Bound,
    /// The curves and the samples.
    pub sampled: SampledSplines,
}

/// Boxes narrower than this, in the unit of the curves, are given up.
const LEAST: f64 = 4e-6;

impl ProvenSamples {
    /// From their text: a line of the condition and the bound, then the splines.
    pub(super) fn from_text(text: &str) -> anyhow::Result<Self> {
        let (head, splines) = text.split_once('\n').context("one line")?;
        let (condition, bound) = head.split_once(' ').context("no condition and bound")?;
        let value: f64 = bound.parse()?;
        let bound = match condition {
            "epsilon" => Bound::Epsilon(value),
            "rho" => Bound::Rho(value),
            other => anyhow::bail!("no condition {other}"),
        };
        Ok(Self {
            bound,
            sampled: splines.parse()?,
        })
    }

    pub(super) fn to_text(&self) -> String {
        let (condition, value) = (self.condition(), self.bound.value());
        format!("{condition} {value}\n{}", self.sampled)
    }

    /// The name of the condition.
    #[must_use]
    pub fn condition(&self) -> &'static str {
        match self.bound {
            Bound::Epsilon(_) => "epsilon",
            Bound::Rho(_) => "rho",
        }
    }

    /// The samples, spline by spline.
    ///
    /// # Errors
    /// If two are equal.
    pub fn points(&self) -> anyhow::Result<PointSet> {
        let splines = self.sampled.splines.iter().zip(&self.sampled.samples);
        let places = splines.flat_map(|(spline, samples)| {
            samples.iter().map(|(segment, at)| {
                DVec2::from_array(spline.point(*segment, *at).map(|side| side.middle()))
            })
        });
        Ok(PointSet::new(places.collect())?)
    }

    /// The polygons of the samples.
    #[must_use]
    pub fn truth(&self) -> EdgeSet {
        let counts: Vec<usize> = self.sampled.samples.iter().map(Vec::len).collect();
        polygons(&counts)
    }

    /// Its splines as Béziers, in the syntax of SVG paths.
    #[must_use]
    pub fn path_data(&self) -> String {
        let mut data = String::new();
        for control in self.control() {
            for i in 0..control.len() {
                let [a, b, c, d] = [0, 1, 2, 3].map(|k| control[(i + k) % control.len()]);
                let [start, end] = [(a + 4.0 * b + c) / 6.0, (b + 4.0 * c + d) / 6.0];
                let [out, into] = [(2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0];
                if i == 0 {
                    data += &format!("M {} {} ", start.x, start.y);
                }
                data += &format!(
                    "C {} {} {} {} {} {} ",
                    out.x, out.y, into.x, into.y, end.x, end.y
                );
            }
            data += "Z ";
        }
        data.trim_end().to_owned()
    }

    /// The files that the program reads: the curve as SVG and the samples as CSV, by their names.
    ///
    /// # Errors
    /// Those of [`points`](Self::points).
    pub fn files(&self, name: &str) -> anyhow::Result<[(String, String); 2]> {
        let points = self.points()?;
        let (low, high) = bounds(points.points());
        let margin = 0.1 * (high - low).max_element();
        let (from, size) = (low - margin, high - low + 2.0 * margin);
        let view = format!("{:.2} {:.2} {:.2} {:.2}", from.x, from.y, size.x, size.y);
        let width = margin / 30.0;
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{view}\"><path fill=\"none\" \
             stroke=\"black\" stroke-width=\"{width:.4}\" d=\"{}\"/></svg>\n",
            self.path_data()
        );
        let rows = points.points().iter().map(|p| format!("{},{}\n", p.x, p.y));
        let csv = "x,y\n".to_owned() + &rows.collect::<String>();
        Ok([(format!("{name}.svg"), svg), (format!("{name}.csv"), csv)])
    }

    /// The control points of its splines.
    #[must_use]
    pub fn control(&self) -> Vec<Vec<DVec2>> {
        let points = |spline: &ClosedSpline| {
            let all = spline.control.iter().copied();
            all.map(DVec2::from_array).collect()
        };
        self.sampled.splines.iter().map(points).collect()
    }

    /// Proves that the samples satisfy the condition for the bound; says how many boxes it took.
    ///
    /// # Errors
    /// If it cannot be proven.
    pub fn prove(&self) -> anyhow::Result<usize> {
        Ok(prove(&self.sampled, self.bound)?)
    }
}

pub(super) fn prove(
    sampled: &SampledSplines,
    bound: Bound,
) -> Result<usize, curvecrust_proof::Undecided> {
    let condition = match bound {
        Bound::Epsilon(_) => SamplingCondition::Epsilon,
        Bound::Rho(_) => SamplingCondition::Rho,
    };
    sampled.prove(condition, bound.value(), LEAST)
}

/// Polygons one after the other, with these numbers of points.
pub(super) fn polygons(counts: &[usize]) -> EdgeSet {
    let mut edges = Vec::new();
    let mut first = 0;
    for count in counts {
        let range = first..first + count;
        first = range.end;
        let closed = true;
        edges.extend(Component { range, closed }.edges());
    }
    EdgeSet::new(first, edges)
}

/// Splines and samples at dense points, as the proof takes them.
pub(super) fn sampled(
    splines: &[Vec<DVec2>],
    dense: &Dense,
    samples: &[Vec<usize>],
) -> SampledSplines {
    let control = splines.iter().map(|control| ClosedSpline {
        control: control.iter().map(|point| point.to_array()).collect(),
    });
    let placed = samples.iter().enumerate().map(|(component, placed)| {
        let parameter = |i: &usize| dense.parameter(component, *i);
        placed.iter().map(parameter).collect()
    });
    SampledSplines {
        splines: control.collect(),
        samples: placed.collect(),
    }
}
