//! Experiments as they stand in `benches/experiments/*.toml`: what each field means.

use super::algorithms;
use crate::compare::results;
use crate::repository::{files, root};
use anyhow::{Context, ensure};
use serde::Deserialize;
use std::fs;

/// An experiment: inputs, a sweep, and what is known of the answers.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Experiment {
    /// The name of its file.
    #[serde(skip)]
    pub(super) name: String,
    pub(super) title: String,
    pub(super) question: String,
    pub(super) seed: u64,
    pub(super) trials: u32,
    #[serde(default = "few")]
    pub(super) quick_trials: u32,
    pub(super) algorithms: Vec<String>,
    pub(super) plots: Vec<String>,
    pub(super) sweep: Sweep,
    pub(super) input: Vec<Input>,
    #[serde(default)]
    pub(super) known: Vec<Known>,
}

fn few() -> u32 {
    10
}

/// What is varied.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sweep {
    pub(super) over: Over,
    /// For the axis, with the unit.
    pub(super) label: String,
    pub(super) values: Vec<f64>,
    /// The values of a quick run.
    pub(super) quick: Vec<f64>,
}

/// What a value of the sweep is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Over {
    /// The bound of the epsilon-sampling condition.
    Epsilon,
    /// The bound of the rho-sampling condition.
    Rho,
    /// The apex angle in degrees.
    Apex,
    /// The distance of two curves, in spacings.
    Gap,
    /// The spacing along the curve, in its least local feature size.
    Spacing,
    /// The standard deviation of both coordinates, in spacings around the sample.
    Noise,
    /// How many outliers there are for each sample.
    Outliers,
    /// The number of points.
    Points,
    /// Of a ring every so many points are taken.
    Every,
}

/// Where points come from. Names of series are the group's, and the curve's after a `/`.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum Input {
    /// Curves of `fixtures/curves` or `fixtures/paper`, or random ones, under a sampling condition:
    /// each step is a random share, between `thinning` and 1, of the longest that the condition
    /// allows; the start is random.
    Curves {
        group: String,
        curves: Choice,
        /// Those of a quick run.
        quick: Choice,
        /// The bound of the epsilon condition where it is not swept.
        epsilon: Option<f64>,
        thinning: f64,
        ends: Ends,
    },
    /// Two straight legs that meet in an apex, closed by an arc.
    Teardrop {
        group: String,
        tip: Tip,
        jitter: f64,
    },
    /// Two closed curves side by side, with long parallel sides.
    Racetracks { group: String, jitter: f64 },
    /// Two circles about one centre.
    Circles { group: String, jitter: f64 },
    /// An open sine arc.
    Sine {
        group: String,
        jitter: f64,
        ends: Ends,
    },
    /// An open spiral with strands at equal distances.
    Spiral {
        group: String,
        jitter: f64,
        ends: Ends,
    },
    /// Five open arcs near each other.
    Arcs {
        group: String,
        jitter: f64,
        ends: Ends,
    },
    /// Small closed curves or open strokes as in drawings and maps, at a distance.
    Shapes {
        group: String,
        shape: Shape,
        jitter: f64,
    },
    /// The rings of each file of a folder that is given to a run; a trial takes one outline.
    Outlines { group: String },
    /// Wavy closed curves that do not touch, at an even spacing of a 50th of their distance.
    Planted { group: String },
}

/// What is at a distance from what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Shape {
    /// Nine circles of five points in a grid.
    Dots,
    /// Six rectangles in a grid.
    Pads,
    /// The ends of a circle that is open, like a letter C.
    LetterC,
    /// Two straight strokes that follow each other on one line.
    StrokesInLine,
    /// Three straight strokes beside each other.
    ParallelStrokes,
}

/// Which curves.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(untagged)]
pub(super) enum Choice {
    /// All of a kind.
    Kind(Kind),
    /// Of the fixtures, by name.
    Names(Vec<String>),
    /// Random closed curves, which no fixture resembles by design.
    Random(RandomCurves),
}

/// Random curves, by seeds that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RandomCurves {
    pub(super) count: u64,
    /// How many frequencies each coordinate has.
    pub(super) terms: u32,
    /// That of the first curve; the second has the next, and so on.
    pub(super) seed: u64,
}

/// Kinds of curves of the fixtures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Kind {
    Closed,
    /// Closed ones of one component.
    OneClosed,
    /// Closed ones of several components.
    SeveralClosed,
    Open,
    /// The four of the paper's authors, if they were fetched: `paper-cat` and so on. All are
    /// closed.
    Authors,
}

/// Whether algorithms that can use the ends of open curves get them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Ends {
    Marked,
    Unmarked,
}

/// Whether the apex is a sample, or in the middle between two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Tip {
    Sampled,
    Skipped,
}

/// An answer that is known: the algorithm finds exactly the true edges, always.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Known {
    pub(super) algorithm: String,
    /// For values of the sweep up to this one.
    pub(super) up_to: f64,
    /// Where the theorem or the experiment that says so can be read.
    pub(super) source: String,
    /// Series that it does not say anything about, such as open curves.
    #[serde(default)]
    pub(super) except: Vec<String>,
}

/// The experiments of the repository, by name.
pub(super) fn all() -> anyhow::Result<Vec<Experiment>> {
    let mut found = Vec::new();
    for path in files(&root().join("benches/experiments"), "toml")? {
        let text =
            fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        found.push(read(&name, &text).with_context(|| format!("in {}", path.display()))?);
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

fn read(name: &str, text: &str) -> anyhow::Result<Experiment> {
    let mut experiment: Experiment = toml::from_str(text)?;
    name.clone_into(&mut experiment.name);
    experiment.check()?;
    Ok(experiment)
}

impl Experiment {
    fn check(&self) -> anyhow::Result<()> {
        ensure!(self.trials > 0, "there must be a trial");
        let sweep = &self.sweep;
        ensure!(!sweep.values.is_empty(), "the sweep has no values");
        for value in sweep.values.iter().chain(&sweep.quick) {
            ensure!(
                value.is_finite() && *value >= 0.0,
                "{value} in the sweep: give numbers of 0 or more"
            );
        }
        let known = self.known.iter().map(|known| &known.algorithm);
        for name in self.algorithms.iter().chain(known) {
            algorithms::named(name)?;
        }
        for input in &self.input {
            let fits = match input {
                Input::Curves { epsilon, .. } => match sweep.over {
                    Over::Epsilon | Over::Rho => epsilon.is_none(),
                    Over::Noise | Over::Outliers => epsilon.is_some(),
                    _ => false,
                },
                Input::Teardrop { .. } => sweep.over == Over::Apex,
                Input::Racetracks { .. } | Input::Circles { .. } | Input::Shapes { .. } => {
                    sweep.over == Over::Gap
                }
                Input::Sine { .. } | Input::Spiral { .. } | Input::Arcs { .. } => {
                    sweep.over == Over::Spacing
                }
                Input::Outlines { .. } => sweep.over == Over::Every,
                Input::Planted { .. } => sweep.over == Over::Points,
            };
            ensure!(
                fits,
                "the sweep over {:?} does not fit the input {input:?}",
                sweep.over
            );
        }
        Ok(())
    }

    /// What tables and plots say of it.
    pub(super) fn described(&self) -> results::Experiment {
        results::Experiment {
            name: self.name.clone(),
            title: self.title.clone(),
            question: self.question.clone(),
            sweep: self.sweep.label.clone(),
            plots: self.plots.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_experiments_can_be_read() {
        let names: Vec<String> = all().unwrap().into_iter().map(|e| e.name).collect();
        assert_eq!(
            names,
            [
                "closeness",
                "corners",
                "density-epsilon",
                "density-rho",
                "gaps",
                "noise",
                "open",
                "outliers",
                "outlines",
                "scale",
                "sparse-epsilon",
                "sparse-rho"
            ]
        );
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let text = include_str!("../../../../benches/experiments/density-rho.toml");
        assert!(read("x", text).is_ok());
        for (from, to, message) in [
            ("over = \"rho\"", "over = \"apex\"", "does not fit"),
            ("\"nn-crust\"", "\"nm-crust\"", "no algorithm \"nm-crust\""),
            ("trials = 100", "trials = 0", "must be a trial"),
            ("thinning", "thining", "unknown field"),
        ] {
            let text = text.replacen(from, to, 1);
            let error = format!("{:#}", read("x", &text).unwrap_err());
            assert!(error.contains(message), "{error}");
        }
    }
}
