//! What an experiment asks, and what its cells answer: a panel for each metric that it plots.

use serde::Serialize;

use crate::compare::axis::{Axis, Format, Scale};
use crate::compare::cells::{Cell, Cells, Mean};
use crate::compare::chart::{Chart, Line, Mark};
use crate::compare::rows::{Timing, metrics};

/// What an experiment asks.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Experiment {
    /// Its name, such as `noise`.
    pub name: String,
    /// One line.
    pub title: String,
    /// What it does and asks, in some sentences.
    pub question: String,
    /// What it sweeps, with the unit.
    pub sweep: String,
    /// The names of the metrics to plot, of `run_time` and of `memory`.
    pub plots: Vec<String>,
}

/// An experiment and its answers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExperimentResults {
    /// The experiment.
    pub experiment: Experiment,
    /// The panels, by group of inputs, then by metric.
    pub panels: Vec<Panel>,
}

/// A metric against the sweep, on a group of inputs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Panel {
    /// The inputs: what their names have before a `/`.
    pub group: String,
    /// The name of the metric.
    pub metric: String,
    /// Its unit.
    pub unit: String,
    /// What is known of each algorithm.
    pub lines: Vec<Answers>,
}

/// An algorithm in a panel.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answers {
    /// The algorithm.
    pub algorithm: String,
    /// Its place in the list of all algorithms: its look in plots.
    pub look: usize,
    /// Ascending in x.
    pub answers: Vec<Answer>,
}

/// The mean of a metric at one value of the sweep.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The value of the sweep.
    pub x: f64,
    /// Over how many trials.
    pub trials: usize,
    /// The mean; of times and memory the median.
    pub mean: f64,
    /// The lower end of a 95 % confidence interval of the mean; of times the least.
    pub low: f64,
    /// The upper end of it; of times the largest.
    pub high: f64,
}

impl ExperimentResults {
    /// Collects the answers to an experiment; `algorithms` are all there are, in their order.
    #[must_use]
    pub fn new(
        experiment: Experiment,
        cells: &Cells,
        timings: &[Timing],
        algorithms: &[&str],
    ) -> Self {
        let cells: Vec<&Cell> = cells
            .all()
            .iter()
            .filter(|cell| cell.experiment == experiment.name)
            .collect();
        let timings: Vec<&Timing> = timings
            .iter()
            .filter(|timing| timing.experiment == experiment.name)
            .collect();
        let names = || {
            let of_cells = cells.iter().map(|cell| &cell.series);
            of_cells.chain(timings.iter().map(|timing| &timing.series))
        };
        let mut groups: Vec<&str> = Vec::new();
        for name in names().map(|series| group_of(series)) {
            if !groups.contains(&name) {
                groups.push(name);
            }
        }
        let mut panels = Vec::new();
        for group in groups {
            for metric in &experiment.plots {
                let lines = algorithms.iter().enumerate().map(|(look, &algorithm)| {
                    let of_cells = || {
                        let own = cells.iter().copied();
                        own.filter(|c| c.algorithm == algorithm && group_of(&c.series) == group)
                    };
                    let of_timings = || {
                        let own = timings.iter().copied();
                        own.filter(|t| t.algorithm == algorithm && group_of(&t.series) == group)
                    };
                    let answers = match metric.as_str() {
                        "run_time" => medians(of_timings().map(|t| (t.x, t.seconds))),
                        "memory" => medians(
                            of_timings()
                                .filter_map(|t| Some((t.x, t.memory? as f64 / 1_048_576.0))),
                        ),
                        _ => means(of_cells(), metric),
                    };
                    Answers {
                        algorithm: algorithm.to_owned(),
                        look,
                        answers,
                    }
                });
                let lines: Vec<Answers> = lines.filter(|line| !line.answers.is_empty()).collect();
                if !lines.is_empty() {
                    panels.push(Panel {
                        group: group.to_owned(),
                        metric: metric.clone(),
                        unit: unit_of(metric).to_owned(),
                        lines,
                    });
                }
            }
        }
        Self { experiment, panels }
    }
}

/// What the name of an input has before a `/`.
fn group_of(series: &str) -> &str {
    series.split_once('/').map_or(series, |parts| parts.0)
}

fn unit_of(metric: &str) -> &'static str {
    match metric {
        "run_time" => "s",
        "memory" => "MiB",
        _ => metrics().find(|m| m.name == metric).map_or("", |m| m.unit),
    }
}

/// The means of a metric over cells with the same x, ascending in x.
fn means<'a>(cells: impl Iterator<Item = &'a Cell>, metric: &str) -> Vec<Answer> {
    let Some(index) = metrics().position(|m| m.name == metric) else {
        return Vec::new();
    };
    let mut found: Vec<(f64, Mean)> = cells
        .filter_map(|cell| Some((cell.x, *cell.means.get(index)?)))
        .filter(|(_, mean)| mean.count > 0)
        .collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let share = unit_of(metric) == "share";
    found
        .chunk_by(|a, b| a.0.to_bits() == b.0.to_bits())
        .map(|same| {
            let all = same
                .iter()
                .fold(Mean::default(), |all, cell| all.with(cell.1));
            let [low, high] = if share { wilson(all) } else { normal(all) };
            Answer {
                x: same.first().map_or(0.0, |cell| cell.0),
                trials: all.count,
                mean: all.mean,
                low,
                high,
            }
        })
        .collect()
}

/// For a confidence of 95 %.
const Z: f64 = 1.96;

/// Wilson's interval for a share of successes.
fn wilson(mean: Mean) -> [f64; 2] {
    let (n, p) = (mean.count as f64, mean.mean);
    let centre = p + Z * Z / (2.0 * n);
    let spread = Z * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).max(0.0).sqrt();
    let scale = 1.0 + Z * Z / n;
    [(centre - spread) / scale, (centre + spread) / scale].map(|v| v.clamp(0.0, 1.0))
}

fn normal(mean: Mean) -> [f64; 2] {
    let spread = Z * (mean.variance / mean.count as f64).sqrt();
    [(mean.mean - spread).max(0.0), mean.mean + spread]
}

/// The median, the least and the largest value for each x, ascending in x.
fn medians(values: impl Iterator<Item = (f64, f64)>) -> Vec<Answer> {
    let mut found: Vec<(f64, f64)> = values.collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    found
        .chunk_by(|a, b| a.0.to_bits() == b.0.to_bits())
        .filter_map(|same| {
            let (low, high) = (same.first()?, same.last()?);
            let (_, median) = *same.get(same.len() / 2)?;
            Some(Answer {
                x: low.0,
                trials: same.len(),
                mean: median,
                low: low.1,
                high: high.1,
            })
        })
        .collect()
}

impl Panel {
    /// What the panel shows, in words.
    #[must_use]
    pub fn title(&self) -> String {
        let what = match self.metric.as_str() {
            "exact" => "exactly the true edges",
            "edge_precision" => "found edges that are true",
            "edge_recall" => "true edges that were found",
            "topology" => "the right number of closed and open curves",
            "hausdorff" => "Hausdorff distance to the curve",
            "rms_curve" => "root mean square distance, curve to output",
            "rms_output" => "root mean square distance, output to curve",
            "min_angle" => "least angle between edges",
            "run_time" => "run time",
            "memory" => "peak memory beyond the points",
            other => other,
        };
        format!("{}: {what}", self.group)
    }

    /// The panel as a chart over what the experiment sweeps.
    #[must_use]
    pub fn chart(&self, sweep: &str) -> Chart {
        let log = matches!(self.metric.as_str(), "run_time" | "memory");
        let share = self.unit == "share";
        let scale = if log { Scale::Log } else { Scale::Linear };
        let lines = self.lines.iter().map(|line| Line {
            // Of memory, what does not grow is too large a part.
            name: match line.slope().filter(|_| self.metric == "run_time") {
                Some(slope) => format!("{} n^{slope:.2}", line.algorithm),
                None => line.algorithm.clone(),
            },
            look: line.look,
            marks: line
                .answers
                .iter()
                .map(|a| Mark {
                    x: a.x,
                    y: a.mean,
                    band: [a.low, a.high],
                })
                .collect(),
        });
        let measured = match self.unit.as_str() {
            "share" => match self.metric.as_str() {
                "exact" | "topology" => "share of trials",
                _ => "share of edges",
            },
            "extents" => "extents of the curve",
            "s" => "seconds",
            unit => unit,
        };
        Chart {
            title: self.title(),
            x: Axis {
                label: sweep.to_owned(),
                scale,
                range: None,
                format: Format::Plain,
            },
            y: Axis {
                label: measured.to_owned(),
                scale,
                range: share.then_some([0.0, 1.0]),
                format: if share {
                    Format::Percent
                } else {
                    Format::Plain
                },
            },
            lines: lines.collect(),
        }
    }
}

impl Answers {
    /// The slope of the line on log axes by least squares: the exponent of a power law.
    #[must_use]
    pub fn slope(&self) -> Option<f64> {
        let positive = self.answers.iter().filter(|a| a.x > 0.0 && a.mean > 0.0);
        let logs: Vec<(f64, f64)> = positive.map(|a| (a.x.ln(), a.mean.ln())).collect();
        let n = logs.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / n;
        let (x, y) = (mean(|p| p.0), mean(|p| p.1));
        let along: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
        let square: f64 = logs.iter().map(|p| (p.0 - x).powi(2)).sum();
        (logs.len() > 2).then(|| along / square)
    }

    /// The values of the sweep, from its easy end on, for which every trial was a full success.
    #[must_use]
    pub fn faultless(&self) -> Option<Faultless> {
        let faultless = |a: &&Answer| a.mean >= 1.0;
        let up_to = self.answers.iter().take_while(faultless).last();
        let from = || self.answers.iter().rev().take_while(faultless).last();
        match up_to {
            Some(last) => Some(Faultless::UpTo(last.x)),
            None => from().map(|first| Faultless::From(first.x)),
        }
    }
}

/// For which values of a sweep an algorithm never failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Faultless {
    /// All that were tried up to this one.
    UpTo(f64),
    /// All that were tried from this one on.
    From(f64),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_and_slopes() {
        let mean = |count, mean| Mean {
            count,
            mean,
            variance: mean * (1.0 - mean),
        };
        // Textbook values.
        let [low, high] = wilson(mean(10, 0.5));
        assert!((low - 0.2366).abs() < 1e-3 && (high - 0.7634).abs() < 1e-3);
        let [low, high] = wilson(mean(100, 1.0));
        assert!((low - 0.963).abs() < 1e-3 && high >= 1.0 - 1e-12);

        let line = Answers {
            algorithm: String::new(),
            look: 0,
            answers: medians(
                [10.0, 100.0, 1000.0]
                    .into_iter()
                    .map(|x: f64| (x, x.powf(1.5))),
            ),
        };
        assert!((line.slope().unwrap_or(0.0) - 1.5).abs() < 1e-9);
    }

    #[test]
    fn means_of_means_are_means_of_all() {
        let of = |values: &[f64]| {
            let n = values.len() as f64;
            let mean = values.iter().sum::<f64>() / n;
            Mean {
                count: values.len(),
                mean,
                variance: values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n,
            }
        };
        let (a, b) = ([1.0, 4.0], [2.0, 8.0, 9.0]);
        let (both, all) = (of(&a).with(of(&b)), of(&[1.0, 4.0, 2.0, 8.0, 9.0]));
        assert_eq!(both.count, all.count);
        assert!((both.mean - all.mean).abs() < 1e-12);
        assert!((both.variance - all.variance).abs() < 1e-12);
    }
}
