//! Means over the trials of a cell: one algorithm on one input at one value of the sweep.

use std::collections::HashMap;

use crate::compare::records::{self, Line, Record};
use crate::compare::rows::{Row, metrics};
use crate::table::{Field, Table};

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

    /// The cells as a table.
    #[must_use]
    pub fn table(&self) -> Table {
        records::table(&self.cells)
    }

    /// Reads what [`table`](Self::table) gave as CSV.
    ///
    /// # Errors
    /// If the columns are others, or a field cannot be read: with its line.
    pub fn read(text: &str) -> anyhow::Result<Self> {
        let cells = records::read(text)?;
        Ok(Self { cells })
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

/// For each metric the number of trials that have it, as `name.n`, its mean and, as `name.sd`, its
/// standard deviation.
impl Record for Cell {
    fn columns() -> Vec<String> {
        let means = metrics().map(|m| m.name);
        let means = means.flat_map(|name| [".n", "", ".sd"].map(|end| format!("{name}{end}")));
        BEFORE.into_iter().map(str::to_owned).chain(means).collect()
    }

    fn fields(&self) -> Vec<Field> {
        let mut fields = vec![
            self.experiment.as_str().into(),
            self.series.as_str().into(),
            self.x.into(),
            self.algorithm.as_str().into(),
            self.trials.into(),
            self.errors.into(),
            Field::rounded(self.points, 6),
        ];
        for mean in &self.means {
            fields.extend(if mean.count == 0 {
                [Field::Missing, Field::Missing, Field::Missing]
            } else {
                let deviation = mean.variance.sqrt();
                [
                    mean.count.into(),
                    Field::rounded(mean.mean, 6),
                    Field::rounded(deviation, 6),
                ]
            });
        }
        fields
    }

    fn of_line(line: &Line<'_>) -> anyhow::Result<Self> {
        let mean = |i: usize| -> anyhow::Result<Mean> {
            let column = BEFORE.len() + 3 * i;
            let Some(mean) = line.optional(column + 1)? else {
                return Ok(Mean::default());
            };
            let deviation: f64 = line.parse(column + 2)?;
            Ok(Mean {
                count: line.parse(column)?,
                mean,
                variance: deviation * deviation,
            })
        };
        Ok(Self {
            experiment: line.text(0).to_owned(),
            series: line.text(1).to_owned(),
            x: line.parse(2)?,
            algorithm: line.text(3).to_owned(),
            trials: line.parse(4)?,
            errors: line.parse(5)?,
            points: line.parse(6)?,
            means: (0..metrics().count()).map(mean).collect::<Result<_, _>>()?,
        })
    }
}

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
