//! Dense points of which some face each other.

use curvecrust_curve::{Curve, DenseCurve, DenseError};

use crate::lfs::LocalFeatureSize;

/// Where gaps face each other, lfs is about the radius of the disc: at least this share of it.
const LFS: f64 = 0.5;

/// Dense points, some gaps of which face others.
pub(crate) struct Facing {
    pub(crate) dense: DenseCurve,
    /// The radius of the smaller disc at the ends of the gap after each point, if it faces another.
    pub(crate) radii: Vec<Option<f64>>,
}

impl Facing {
    /// No gap faces another.
    pub(crate) fn none(dense: DenseCurve) -> Self {
        let radii = vec![None; dense.len()];
        Self { dense, radii }
    }

    /// Leaves gaps that face others in one piece. If one of them cannot be left, since another part
    /// of the curve spans it or lfs is not what the discs say, none faces another any more.
    pub(crate) fn keep(&mut self, pieces: &mut [u32], spanning: &[usize], lfs: &LocalFeatureSize) {
        let holds = |i: usize, radius: f64| {
            let next = self.dense.next(i).unwrap_or(i);
            lfs.at(i).min(lfs.at(next)) >= LFS * radius
        };
        let mut faced = (0..).zip(&self.radii).filter_map(|(i, r)| Some((i, (*r)?)));
        // What lfs is shows only when all other gaps are short enough.
        let rest = pieces.iter().zip(&self.radii);
        let settled = rest.clone().all(|(&n, radius)| n == 1 || radius.is_some());
        if spanning.iter().any(|&gap| self.radii[gap].is_some())
            || (settled && !faced.all(|(i, radius)| holds(i, radius)))
        {
            self.radii.fill(None);
        }
        for (n, radius) in pieces.iter_mut().zip(&self.radii) {
            if radius.is_some() {
                *n = 1;
            }
        }
    }

    /// Cuts gaps into pieces; those that face others are in one.
    pub(crate) fn refined(&self, curve: &Curve, pieces: &[u32]) -> Result<Self, DenseError> {
        let dense = self.dense.refined(curve, pieces)?;
        let mut radii = Vec::with_capacity(dense.len());
        for (i, (&n, &radius)) in pieces.iter().zip(&self.radii).enumerate() {
            let n = self.dense.next(i).map_or(1, |_| n);
            radii.extend((0..n).map(|_| radius));
        }
        Ok(Self { dense, radii })
    }
}
