//! Symmetric positive matrices of cubic splines: a band, and for closed curves a border.
//!
//! A basis function of a cubic B-spline meets three others on each side. For an open curve this is
//! a band of half width 3. For a closed one the last three unknowns also meet the first ones; kept
//! as a border of three full rows, they leave the rest a band, and the factor has the same pattern.

/// The half width of the band, and the number of rows of a border.
const WIDTH: usize = 3;

/// A symmetric matrix, or its factor L D L^T, by the columns of its lower triangle.
#[derive(Clone, Debug)]
pub(crate) struct Banded {
    /// Entries (j, j) to (j + 3, j) of column j.
    band: Vec<[f64; WIDTH + 1]>,
    /// Entries of column j in the border; all zero without one.
    rows: Vec<[f64; WIDTH]>,
    /// The border with itself, lower triangle and its mirror image.
    corner: [[f64; WIDTH]; WIDTH],
    border: usize,
}

impl Banded {
    /// The zero matrix of a number of unknowns, of which a cyclic one has at least 4.
    pub(crate) fn zero(unknowns: usize, cyclic: bool) -> Self {
        let border = if cyclic { WIDTH.min(unknowns) } else { 0 };
        let inner = unknowns - border;
        Self {
            band: vec![[0.0; WIDTH + 1]; inner],
            rows: vec![[0.0; WIDTH]; inner],
            corner: [[0.0; WIDTH]; WIDTH],
            border,
        }
    }

    fn inner(&self) -> usize {
        self.band.len()
    }

    fn unknowns(&self) -> usize {
        self.inner() + self.border
    }

    /// An entry of the pattern; 0 outside of it.
    fn get(&self, i: usize, j: usize) -> f64 {
        let (low, high, inner) = (i.min(j), i.max(j), self.inner());
        if low >= inner {
            self.corner[high - inner][low - inner]
        } else if high >= inner {
            self.rows[low][high - inner]
        } else {
            self.band[low].get(high - low).copied().unwrap_or(0.0)
        }
    }

    /// Adds to the entries (i, j) and (j, i), which are in the pattern.
    pub(crate) fn add(&mut self, i: usize, j: usize, value: f64) {
        let (low, high, inner) = (i.min(j), i.max(j), self.inner());
        if low >= inner {
            self.corner[high - inner][low - inner] += value;
            if low != high {
                self.corner[low - inner][high - inner] += value;
            }
        } else if high >= inner {
            self.rows[low][high - inner] += value;
        } else if let Some(entry) = self.band[low].get_mut(high - low) {
            *entry += value;
        }
    }

    /// Adds the outer product of a row with four entries with itself.
    pub(crate) fn add_outer(&mut self, columns: [usize; 4], row: [f64; 4], weight: f64) {
        for a in 0..4 {
            for b in 0..=a {
                self.add(columns[a], columns[b], weight * row[a] * row[b]);
            }
        }
    }

    /// This matrix and `factor` times another of the same pattern, and a little on the diagonal,
    /// which keeps unknowns that no point and no penalty holds.
    pub(crate) fn plus(&self, factor: f64, other: &Self, ridge: f64) -> Self {
        let mut sum = self.clone();
        for (column, more) in sum.band.iter_mut().zip(&other.band) {
            for (entry, more) in column.iter_mut().zip(more) {
                *entry += factor * more;
            }
            column[0] += ridge;
        }
        for (column, more) in sum.rows.iter_mut().zip(&other.rows) {
            for (entry, more) in column.iter_mut().zip(more) {
                *entry += factor * more;
            }
        }
        for a in 0..self.border {
            for b in 0..self.border {
                sum.corner[a][b] += factor * other.corner[a][b];
            }
            sum.corner[a][a] += ridge;
        }
        sum
    }

    /// The factor L D L^T: D on the diagonal, L below it.
    pub(crate) fn factor(mut self) -> Factor {
        let inner = self.inner();
        for j in 0..inner {
            let pivot = positive(self.band[j][0]);
            self.band[j][0] = pivot;
            let reach = WIDTH.min(inner - 1 - j);
            let (column, row) = (self.band[j], self.rows[j]);
            for a in 1..=reach {
                let l = column[a] / pivot;
                for (b, entry) in column.iter().enumerate().take(reach + 1).skip(a) {
                    self.band[j + a][b - a] -= l * entry;
                }
                for (below, entry) in self.rows[j + a].iter_mut().zip(row) {
                    *below -= l * entry;
                }
                self.band[j][a] = l;
            }
            for (below, r) in self.corner.iter_mut().zip(row) {
                for (below, s) in below.iter_mut().zip(row) {
                    *below -= r * s / pivot;
                }
            }
            self.rows[j] = row.map(|entry| entry / pivot);
        }
        for j in 0..self.border {
            let pivot = positive(self.corner[j][j]);
            self.corner[j][j] = pivot;
            for a in j + 1..self.border {
                let l = self.corner[a][j] / pivot;
                for b in j + 1..=a {
                    let lower = self.corner[b][j];
                    // Column j of row b < a is already divided.
                    let value = if b < a { lower * pivot } else { lower };
                    self.corner[a][b] -= l * value;
                }
                self.corner[a][j] = l;
            }
        }
        Factor(self)
    }

    /// The trace of the product with another symmetric matrix of the same pattern.
    pub(crate) fn trace_of_product(&self, other: &Self) -> f64 {
        let mut sum = 0.0;
        for j in 0..self.inner() {
            for (a, (x, y)) in self.band[j].iter().zip(&other.band[j]).enumerate() {
                sum += if a == 0 { x * y } else { 2.0 * x * y };
            }
            for r in 0..self.border {
                sum += 2.0 * self.rows[j][r] * other.rows[j][r];
            }
        }
        for r in 0..self.border {
            for s in 0..self.border {
                sum += self.corner[r][s] * other.corner[r][s];
            }
        }
        sum
    }

    /// The quadratic form of a row with four entries.
    pub(crate) fn quadratic_form(&self, columns: [usize; 4], row: [f64; 4]) -> f64 {
        let mut sum = 0.0;
        for a in 0..4 {
            for b in 0..4 {
                sum += row[a] * row[b] * self.get(columns[a], columns[b]);
            }
        }
        sum
    }
}

/// A pivot that rounding has not made zero or negative.
fn positive(pivot: f64) -> f64 {
    pivot.max(f64::MIN_POSITIVE.sqrt())
}

/// L D L^T of a [`Banded`] matrix.
#[derive(Clone, Debug)]
pub(crate) struct Factor(Banded);

impl Factor {
    /// The unknowns for a right side.
    pub(crate) fn solve(&self, mut x: Vec<glam::DVec2>) -> Vec<glam::DVec2> {
        let m = &self.0;
        let (inner, unknowns) = (m.inner(), m.unknowns());
        for j in 0..inner {
            let known = x[j];
            for a in 1..=WIDTH.min(inner - 1 - j) {
                x[j + a] -= m.band[j][a] * known;
            }
            for r in 0..m.border {
                x[inner + r] -= m.rows[j][r] * known;
            }
        }
        for j in 0..m.border {
            for a in j + 1..m.border {
                let known = x[inner + j];
                x[inner + a] -= m.corner[a][j] * known;
            }
        }
        for j in (0..unknowns).rev() {
            if j >= inner {
                let r = j - inner;
                x[j] /= m.corner[r][r];
                for a in r + 1..m.border {
                    let known = x[inner + a];
                    x[j] -= m.corner[a][r] * known;
                }
            } else {
                x[j] /= m.band[j][0];
                for a in 1..=WIDTH.min(inner - 1 - j) {
                    let known = x[j + a];
                    x[j] -= m.band[j][a] * known;
                }
                for r in 0..m.border {
                    let known = x[inner + r];
                    x[j] -= m.rows[j][r] * known;
                }
            }
        }
        x
    }

    /// The entries of the inverse that lie in the pattern.
    ///
    /// Source: K. Takahashi, J. Fagan, M.-S. Chin, *Formation of a Sparse Bus Impedance Matrix*,
    /// 1973; for splines M. Hutchinson, F. de Hoog, *Smoothing Noisy Data with Spline Functions*,
    /// 1985.
    pub(crate) fn inverse(&self) -> Banded {
        let m = &self.0;
        let (inner, unknowns) = (m.inner(), m.unknowns());
        let mut z = Banded::zero(unknowns, m.border > 0);
        for j in (0..unknowns).rev() {
            let mut below: [(usize, f64); 2 * WIDTH] = [(0, 0.0); 2 * WIDTH];
            let mut count = 0;
            let mut push = |index: usize, l: f64| {
                below[count] = (index, l);
                count += 1;
            };
            let pivot = if j >= inner {
                for a in j - inner + 1..m.border {
                    push(inner + a, m.corner[a][j - inner]);
                }
                m.corner[j - inner][j - inner]
            } else {
                for a in 1..=WIDTH.min(inner - 1 - j) {
                    push(j + a, m.band[j][a]);
                }
                for r in 0..m.border {
                    push(inner + r, m.rows[j][r]);
                }
                m.band[j][0]
            };
            let below = &below[..count];
            for &(i, _) in below {
                let value: f64 = below.iter().map(|&(k, l)| l * z.get(k, i)).sum();
                z.add(i, j, -value);
            }
            let value: f64 = below.iter().map(|&(k, l)| l * z.get(k, j)).sum();
            z.add(j, j, 1.0 / pivot - value);
        }
        z
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_geometry::Random;
    use glam::DVec2;

    /// A random positive matrix of the pattern, also full.
    fn random(unknowns: usize, cyclic: bool, seed: u64) -> (Banded, Vec<Vec<f64>>) {
        let mut random = Random::new(seed);
        let mut sparse = Banded::zero(unknowns, cyclic);
        let mut full = vec![vec![0.0; unknowns]; unknowns];
        let last = if cyclic { unknowns } else { unknowns - 3 };
        for start in (0..last).chain(0..last) {
            let columns = [0, 1, 2, 3].map(|a| (start + a) % unknowns);
            let row = [0; 4].map(|_| random.normal());
            sparse.add_outer(columns, row, 1.0);
            for a in 0..4 {
                for b in 0..4 {
                    full[columns[a]][columns[b]] += row[a] * row[b];
                }
            }
        }
        (sparse.plus(0.0, &sparse, 0.1), {
            full.iter_mut()
                .enumerate()
                .for_each(|(i, row)| row[i] += 0.1);
            full
        })
    }

    #[test]
    fn solutions_and_inverses_are_those_of_the_full_matrix() {
        for (unknowns, cyclic) in [
            (4, false),
            (9, false),
            (4, true),
            (5, true),
            (8, true),
            (30, true),
        ] {
            let (sparse, full) = random(unknowns, cyclic, 7);
            let factor = sparse.clone().factor();
            let inverse = factor.inverse();
            let mut trace = 0.0;
            for i in 0..unknowns {
                let mut unit = vec![DVec2::ZERO; unknowns];
                unit[i] = DVec2::new(1.0, -2.0);
                let x = factor.solve(unit);
                for (j, row) in full.iter().enumerate() {
                    let product: f64 = row.iter().zip(&x).map(|(a, x)| a * x.x).sum();
                    let wanted = if i == j { 1.0 } else { 0.0 };
                    assert!((product - wanted).abs() < 1e-9, "{unknowns} {cyclic}");
                    if sparse.get(i, j).abs() > 0.0 {
                        assert!((inverse.get(i, j) - x[j].x).abs() < 1e-9, "{i} {j}");
                    }
                    trace += x[j].x * full[i][j];
                }
            }
            assert!((inverse.trace_of_product(&sparse) - trace).abs() < 1e-8);
        }
    }
}
