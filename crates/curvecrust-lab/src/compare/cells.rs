//! Means over the trials of a cell: one algorithm on one input at one value of the sweep.

use std::collections::HashMap;
use std::fmt::Write;

use crate::compare::rows::{self, Row, RowError, metrics, quoted, six_digits};

/// The cells of a comparison, in the order of their first rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    cells: Vec<Cell>,
}

/// The trials of one algorithm on one input at one value of the sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The experiment.
    pub experiment: String,
    /// The input.
    pub series: String,
    /// The value of the sweep.
    pub x: f64,
    /// The algorithm.
    pub algorithm: String,
    /// The number of trials, those that failed included.
    pub trials: usize,
    /// How many ended with an error.
    pub errors: usize,
    /// The mean number of points.
    pub points: f64,
    /// For each of [`metrics`], in their order, over the trials that have a finite value.
    pub means: Vec<Mean>,
}

/// The mean of a metric over trials; of a bounded one, of its upper bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mean {
    /// Over how many.
    pub count: usize,
    /// The mean; 0 over none.
    pub mean: f64,
    /// The mean squared deviation from it.
    pub variance: f64,
}

impl Mean {
    /// The mean of what two means were made of.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        let count = self.count + other.count;
        if count == 0 {
            return self;
        }
        let share = |m: Self| m.count as f64 / count as f64;
        let mean = share(self) * self.mean + share(other) * other.mean;
        let spread = |m: Self| share(m) * (m.variance + (m.mean - mean).powi(2));
        Self {
            count,
            mean,
            variance: spread(self) + spread(other),
        }
    }
}

impl Cells {
    /// Takes the means of rows in any order; sums run in the order of the rows.
    #[must_use]
    pub fn of_rows(rows: &[Row]) -> Self {
        let mut cells: Vec<Cell> = Vec::new();
        let mut sums: Vec<Vec<(usize, f64, f64)>> = Vec::new();
        let mut places: HashMap<(&str, &str, u64, &str), usize> = HashMap::new();
        for row in rows {
            let key = (
                &*row.experiment,
                &*row.series,
                row.x.to_bits(),
                &*row.algorithm,
            );
            let place = *places.entry(key).or_insert_with(|| {
                cells.push(Cell::empty(row));
                sums.push(vec![(0, 0.0, 0.0); metrics().count()]);
                cells.len() - 1
            });
            let cell = &mut cells[place];
            cell.trials += 1;
            cell.errors += usize::from(row.error.is_some());
            cell.points += row.points as f64;
            for (sum, value) in sums[place].iter_mut().zip(&row.values) {
                if let Some(value) = value.map(|bounds| bounds.upper).filter(|v| v.is_finite()) {
                    *sum = (sum.0 + 1, sum.1 + value, sum.2 + value * value);
                }
            }
        }
        for (cell, sums) in cells.iter_mut().zip(sums) {
            cell.points /= cell.trials as f64;
            cell.means = sums
                .into_iter()
                .map(|(count, sum, squares)| {
                    let n = count.max(1) as f64;
                    let mean = sum / n;
                    Mean {
                        count,
                        mean,
                        variance: (squares / n - mean * mean).max(0.0),
                    }
                })
                .collect();
        }
        Self { cells }
    }

    /// The cells.
    #[must_use]
    pub fn all(&self) -> &[Cell] {
        &self.cells
    }

    /// Leaves out some.
    pub fn retain(&mut self, keep: impl FnMut(&Cell) -> bool) {
        self.cells.retain(keep);
    }

    /// Takes others in, after its own.
    pub fn extend(&mut self, others: &Self) {
        self.cells.extend_from_slice(&others.cells);
    }

    /// The cells as CSV: for each metric its mean and, as `name.sd`, its standard deviation.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut text = Self::header();
        for cell in &self.cells {
            let _ = write!(
                text,
                "{},{},{},{},{},{},{}",
                quoted(&cell.experiment),
                quoted(&cell.series),
                cell.x,
                quoted(&cell.algorithm),
                cell.trials,
                cell.errors,
                six_digits(cell.points)
            );
            for mean in &cell.means {
                let _ = if mean.count == 0 {
                    write!(text, ",,,")
                } else {
                    let (m, sd) = (six_digits(mean.mean), six_digits(mean.variance.sqrt()));
                    write!(text, ",{},{m},{sd}", mean.count)
                };
            }
            text += "\n";
        }
        text
    }

    /// Reads what [`to_csv`](Self::to_csv) wrote.
    ///
    /// # Errors
    /// If the columns are others, or a field cannot be read: with its line.
    pub fn read(text: &str) -> Result<Self, RowError> {
        let header = Self::header();
        let cells = rows::records(text, &header)?
            .iter()
            .map(|fields| {
                let mean = |i: usize| -> Result<Mean, RowError> {
                    let column = BEFORE.len() + 3 * i;
                    let Some(mean) = fields.optional(column + 1)? else {
                        return Ok(Mean::default());
                    };
                    let deviation: f64 = fields.parse(column + 2)?;
                    Ok(Mean {
                        count: fields.parse(column)?,
                        mean,
                        variance: deviation * deviation,
                    })
                };
                Ok(Cell {
                    experiment: fields.text(0),
                    series: fields.text(1),
                    x: fields.parse(2)?,
                    algorithm: fields.text(3),
                    trials: fields.parse(4)?,
                    errors: fields.parse(5)?,
                    points: fields.parse(6)?,
                    means: (0..metrics().count()).map(mean).collect::<Result<_, _>>()?,
                })
            })
            .collect::<Result<_, RowError>>()?;
        Ok(Self { cells })
    }

    fn header() -> String {
        let means = metrics().map(|m| format!(",{0}.n,{0},{0}.sd", m.name));
        BEFORE.join(",") + &means.collect::<String>() + "\n"
    }
}

const BEFORE: [&str; 7] = [
    "experiment",
    "series",
    "x",
    "algorithm",
    "trials",
    "errors",
    "points",
];

impl Cell {
    fn empty(row: &Row) -> Self {
        Self {
            experiment: row.experiment.clone(),
            series: row.series.clone(),
            x: row.x,
            algorithm: row.algorithm.clone(),
            trials: 0,
            errors: 0,
            points: 0.0,
            means: Vec::new(),
        }
    }
}
