//! What experiments write: one row per trial and algorithm.

use curvecrust::evaluate::{Bounds, Evaluation, METRICS, Metric, Precision};

use crate::compare::records::{Line, Record};
use crate::table::Field;

/// What one algorithm made of one input.
///
/// Everything in it is the same on every run; times are [`Timing`]s, in a file of their own.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The experiment.
    pub experiment: String,
    /// The input, such as the name of a curve.
    pub series: String,
    /// The value of what the experiment sweeps.
    pub x: f64,
    /// The number of the trial, from 0.
    pub trial: u32,
    /// The seed of the trial's random numbers.
    pub seed: u64,
    /// The algorithm.
    pub algorithm: String,
    /// How many points it was given.
    pub points: usize,
    /// The values of [`metrics`], in their order; none if there is an error.
    pub values: Vec<Option<Bounds>>,
    /// Why there is no result.
    pub error: Option<String>,
    /// The version of the project that made the row.
    pub version: String,
}

/// The time, and memory if it was measured, that a row took.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// The experiment.
    pub experiment: String,
    /// The input.
    pub series: String,
    /// The value of what the experiment sweeps.
    pub x: f64,
    /// The number of the trial, from 0.
    pub trial: u32,
    /// The algorithm.
    pub algorithm: String,
    /// How many points it was given.
    pub points: usize,
    /// Seconds of the reconstruction alone.
    pub seconds: f64,
    /// The most memory that the reconstruction held beyond its points, in bytes, if it was
    /// measured.
    pub memory: Option<u64>,
}

/// The metrics of a row: all but those by a clock.
pub fn metrics() -> impl Iterator<Item = &'static Metric> {
    METRICS.iter().filter(|m| m.precision != Precision::Timed)
}

const BEFORE: [&str; 7] = [
    "experiment",
    "series",
    "x",
    "trial",
    "seed",
    "algorithm",
    "points",
];

impl Row {
    /// The values of an evaluation.
    #[must_use]
    pub fn values_of(evaluation: &Evaluation) -> Vec<Option<Bounds>> {
        metrics().map(|metric| metric.of(evaluation)).collect()
    }
}

/// A bounded metric has two columns, `name.lower` and `name.upper`; numbers have six significant
/// digits.
impl Record for Row {
    fn columns() -> Vec<String> {
        let mut columns: Vec<String> = BEFORE.map(str::to_owned).to_vec();
        for metric in metrics() {
            if metric.precision == Precision::Bounded {
                columns.push(format!("{}.lower", metric.name));
                columns.push(format!("{}.upper", metric.name));
            } else {
                columns.push(metric.name.to_owned());
            }
        }
        columns.extend(["error", "version"].map(str::to_owned));
        columns
    }

    fn fields(&self) -> Vec<Field> {
        let mut fields = vec![
            self.experiment.as_str().into(),
            self.series.as_str().into(),
            self.x.into(),
            Field::Count(self.trial.into()),
            Field::Count(self.seed),
            self.algorithm.as_str().into(),
            self.points.into(),
        ];
        for (i, metric) in metrics().enumerate() {
            let value = self.values.get(i).copied().flatten();
            let rounded = |of: fn(Bounds) -> f64| {
                value.map_or(Field::Missing, |bounds| Field::rounded(of(bounds), 6))
            };
            fields.push(rounded(|bounds| bounds.lower));
            if metric.precision == Precision::Bounded {
                fields.push(rounded(|bounds| bounds.upper));
            }
        }
        fields.push(self.error.as_deref().unwrap_or_default().into());
        fields.push(self.version.as_str().into());
        fields
    }

    fn of_line(line: &Line<'_>) -> anyhow::Result<Self> {
        let mut values = Vec::new();
        let mut column = BEFORE.len();
        for metric in metrics() {
            let lower = line.optional(column)?;
            column += 1;
            let upper = if metric.precision == Precision::Bounded {
                column += 1;
                line.optional(column - 1)?
            } else {
                lower
            };
            let bounds = lower.zip(upper);
            values.push(bounds.map(|(lower, upper)| Bounds { lower, upper }));
        }
        let error = line.text(column).to_owned();
        Ok(Self {
            experiment: line.text(0).to_owned(),
            series: line.text(1).to_owned(),
            x: line.parse(2)?,
            trial: line.parse(3)?,
            seed: line.parse(4)?,
            algorithm: line.text(5).to_owned(),
            points: line.parse(6)?,
            values: if error.is_empty() { values } else { Vec::new() },
            error: (!error.is_empty()).then_some(error),
            version: line.text(column + 1).to_owned(),
        })
    }
}

impl Record for Timing {
    fn columns() -> Vec<String> {
        [
            "experiment",
            "series",
            "x",
            "trial",
            "algorithm",
            "points",
            "seconds",
            "memory",
        ]
        .map(str::to_owned)
        .to_vec()
    }

    fn fields(&self) -> Vec<Field> {
        vec![
            self.experiment.as_str().into(),
            self.series.as_str().into(),
            self.x.into(),
            Field::Count(self.trial.into()),
            self.algorithm.as_str().into(),
            self.points.into(),
            Field::rounded(self.seconds, 6),
            self.memory.map_or(Field::Missing, Field::Count),
        ]
    }

    fn of_line(line: &Line<'_>) -> anyhow::Result<Self> {
        Ok(Self {
            experiment: line.text(0).to_owned(),
            series: line.text(1).to_owned(),
            x: line.parse(2)?,
            trial: line.parse(3)?,
            algorithm: line.text(4).to_owned(),
            points: line.parse(5)?,
            seconds: line.parse(6)?,
            memory: line.optional(7)?,
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;
    use crate::compare::records;

    fn row() -> Row {
        Row {
            experiment: "noise".into(),
            series: "two, \"quoted\"".into(),
            x: 0.1,
            trial: 3,
            seed: u64::MAX,
            algorithm: "crust".into(),
            points: 12,
            values: metrics()
                .enumerate()
                .map(|(i, m)| {
                    let lower = 0.125 * i as f64;
                    let wide = f64::from(u8::from(m.precision == Precision::Bounded));
                    (i != 2).then_some(Bounds {
                        lower,
                        upper: lower + wide,
                    })
                })
                .collect(),
            error: None,
            version: "1.2.3".into(),
        }
    }

    #[test]
    fn rows_are_read_as_they_were_written() {
        let failed = Row {
            values: Vec::new(),
            error: Some("line 1\nline 2".into()),
            ..row()
        };
        let rows = vec![row(), failed];
        let text = records::table(&rows).to_csv().unwrap();
        assert_eq!(records::read::<Row>(&text).unwrap(), rows);

        let timing = Timing {
            experiment: "scale".into(),
            series: "s".into(),
            x: 1000.0,
            trial: 0,
            algorithm: "crust".into(),
            points: 1000,
            seconds: 0.25,
            memory: Some(1 << 40),
        };
        let timings = [timing];
        let text = records::table(&timings).to_csv().unwrap();
        assert_eq!(records::read::<Timing>(&text).unwrap(), timings);
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        let text = records::table(&[row()]).to_csv().unwrap();
        let message = |text: &str| records::read::<Row>(text).unwrap_err().to_string();
        assert_eq!(
            message(&text.replace(",3,", ",x,")),
            "line 2, column trial: \"x\" cannot be read"
        );
        assert!(message("a,b\n").contains("of another version"));
    }
}
