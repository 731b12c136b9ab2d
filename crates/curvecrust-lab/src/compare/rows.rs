//! What experiments write: one row per trial and algorithm.

use curvecrust::evaluate::{Bounds, Evaluation, METRICS, Metric, Precision};
use thiserror::Error;

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
    /// The most memory that the reconstruction held beyond its points, in bytes, if it was measured.
    pub memory: Option<u64>,
}

/// Why a file does not hold rows.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RowError {
    /// It is no CSV.
    #[error("the rows are no CSV")]
    Csv(#[from] csv::Error),
    /// The columns are others.
    #[error("the columns are {found:?}, not {wanted:?}: the file is of another version")]
    Columns {
        /// The header of the file.
        found: String,
        /// The header it should have.
        wanted: String,
    },
    /// A field cannot be read.
    #[error("line {line}, column {column}: {value:?} cannot be read")]
    Field {
        /// The line in the file, from 1.
        line: u64,
        /// The name of the column.
        column: String,
        /// What is there.
        value: String,
    },
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
const AFTER: [&str; 2] = ["error", "version"];

impl Row {
    /// The names of the columns: a bounded metric has two, `name.lower` and `name.upper`.
    #[must_use]
    pub fn header() -> String {
        let mut columns: Vec<String> = BEFORE.map(str::to_owned).to_vec();
        for metric in metrics() {
            if metric.precision == Precision::Bounded {
                columns.push(format!("{}.lower", metric.name));
                columns.push(format!("{}.upper", metric.name));
            } else {
                columns.push(metric.name.to_owned());
            }
        }
        columns.extend(AFTER.map(str::to_owned));
        columns.join(",") + "\n"
    }

    /// The values of an evaluation.
    #[must_use]
    pub fn values_of(evaluation: &Evaluation) -> Vec<Option<Bounds>> {
        metrics().map(|metric| metric.of(evaluation)).collect()
    }

    /// The row as a line of CSV, with six significant digits.
    #[must_use]
    pub fn to_line(&self) -> String {
        let mut fields = vec![
            quoted(&self.experiment),
            quoted(&self.series),
            self.x.to_string(),
            self.trial.to_string(),
            self.seed.to_string(),
            quoted(&self.algorithm),
            self.points.to_string(),
        ];
        for (i, metric) in metrics().enumerate() {
            let value = self.values.get(i).copied().flatten();
            fields.push(value.map_or(String::new(), |v| six_digits(v.lower)));
            if metric.precision == Precision::Bounded {
                fields.push(value.map_or(String::new(), |v| six_digits(v.upper)));
            }
        }
        fields.push(quoted(self.error.as_deref().unwrap_or_default()));
        fields.push(quoted(&self.version));
        fields.join(",") + "\n"
    }

    /// Reads a file of rows.
    ///
    /// # Errors
    /// If the columns are others, or a field cannot be read: with its line.
    pub fn read(text: &str) -> Result<Vec<Self>, RowError> {
        records(text, &Self::header())?
            .iter()
            .map(|fields| {
                let mut values = Vec::new();
                let mut column = BEFORE.len();
                for metric in metrics() {
                    let lower = fields.optional(column)?;
                    column += 1;
                    let upper = if metric.precision == Precision::Bounded {
                        column += 1;
                        fields.optional(column - 1)?
                    } else {
                        lower
                    };
                    let bounds = lower.zip(upper);
                    values.push(bounds.map(|(lower, upper)| Bounds { lower, upper }));
                }
                let error = fields.text(column);
                Ok(Self {
                    experiment: fields.text(0),
                    series: fields.text(1),
                    x: fields.parse(2)?,
                    trial: fields.parse(3)?,
                    seed: fields.parse(4)?,
                    algorithm: fields.text(5),
                    points: fields.parse(6)?,
                    values: if error.is_empty() { values } else { Vec::new() },
                    error: (!error.is_empty()).then_some(error),
                    version: fields.text(column + 1),
                })
            })
            .collect()
    }
}

impl Timing {
    /// The names of the columns.
    #[must_use]
    pub fn header() -> String {
        "experiment,series,x,trial,algorithm,points,seconds,memory\n".to_owned()
    }

    /// The timing as a line of CSV.
    #[must_use]
    pub fn to_line(&self) -> String {
        let memory = self.memory.map(|bytes| bytes.to_string());
        format!(
            "{},{},{},{},{},{},{},{}\n",
            quoted(&self.experiment),
            quoted(&self.series),
            self.x,
            self.trial,
            quoted(&self.algorithm),
            self.points,
            six_digits(self.seconds),
            memory.unwrap_or_default()
        )
    }

    /// Reads a file of timings.
    ///
    /// # Errors
    /// If the columns are others, or a field cannot be read: with its line.
    pub fn read(text: &str) -> Result<Vec<Self>, RowError> {
        records(text, &Self::header())?
            .iter()
            .map(|fields| {
                let memory = fields.text(7);
                Ok(Self {
                    experiment: fields.text(0),
                    series: fields.text(1),
                    x: fields.parse(2)?,
                    trial: fields.parse(3)?,
                    algorithm: fields.text(4),
                    points: fields.parse(5)?,
                    seconds: fields.parse(6)?,
                    memory: if memory.is_empty() {
                        None
                    } else {
                        Some(fields.parse(7)?)
                    },
                })
            })
            .collect()
    }
}

/// A record, with its header for messages.
pub(crate) struct Fields<'a> {
    record: csv::StringRecord,
    header: &'a str,
}

impl Fields<'_> {
    pub(crate) fn text(&self, column: usize) -> String {
        self.record.get(column).unwrap_or_default().to_owned()
    }

    pub(crate) fn parse<T: std::str::FromStr>(&self, column: usize) -> Result<T, RowError> {
        let value = self.record.get(column).unwrap_or_default();
        value.parse().map_err(|_| RowError::Field {
            line: self.record.position().map_or(0, csv::Position::line),
            column: self
                .header
                .trim_end()
                .split(',')
                .nth(column)
                .unwrap_or("?")
                .to_owned(),
            value: value.to_owned(),
        })
    }

    pub(crate) fn optional(&self, column: usize) -> Result<Option<f64>, RowError> {
        match self.record.get(column) {
            None | Some("") => Ok(None),
            Some(_) => self.parse(column).map(Some),
        }
    }
}

/// The records of a file with the given header.
pub(crate) fn records<'a>(text: &str, header: &'a str) -> Result<Vec<Fields<'a>>, RowError> {
    let first = text.lines().next().unwrap_or_default();
    if first != header.trim_end() {
        return Err(RowError::Columns {
            found: first.to_owned(),
            wanted: header.trim_end().to_owned(),
        });
    }
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let fields = reader.records().map(|record| {
        Ok(Fields {
            record: record?,
            header,
        })
    });
    fields.collect()
}

/// A number with six significant digits, without zeros at the end.
pub(crate) fn six_digits(value: f64) -> String {
    match format!("{value:.5e}").parse::<f64>() {
        // Never -0, which is a sum of nothing.
        Ok(rounded) => (rounded + 0.0).to_string(),
        Err(_) => value.to_string(),
    }
}

/// A text as a field of CSV.
pub(crate) fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;

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
        let text: String = rows.iter().map(Row::to_line).collect();
        assert_eq!(Row::read(&(Row::header() + &text)).unwrap(), rows);

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
        let text = Timing::header() + &timing.to_line();
        assert_eq!(Timing::read(&text).unwrap(), [timing]);
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        let text = Row::header() + &row().to_line().replace(",3,", ",x,");
        let message = Row::read(&text).unwrap_err().to_string();
        assert_eq!(message, "line 2, column trial: \"x\" cannot be read");
        assert!(matches!(Row::read("a,b\n"), Err(RowError::Columns { .. })));
    }

    #[test]
    fn six_digits_are_kept() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0 / 3.0, "0.333333"),
            (1.5e-9, "0.0000000015"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(six_digits(value), text);
        }
    }
}
