//! The sampling conditions.

use std::fmt;

use thiserror::Error;

/// How near a sample has to be to every point of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// Every curve point p has a sample nearer than this times lfs(p) (SGP 2016, Definition 1).
    Epsilon(f64),
    /// Every curve point p of the interval I between consecutive samples has one of them nearer
    /// than this times reach(I) (SGP 2016, Definition 3).
    Rho(f64),
}

impl Bound {
    /// Epsilon or rho.
    #[must_use]
    pub fn value(self) -> f64 {
        match self {
            Self::Epsilon(value) | Self::Rho(value) => value,
        }
    }
}

/// As a bound is written: `rho < 0.9`.
impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Epsilon(value) => write!(f, "epsilon < {value}"),
            Self::Rho(value) => write!(f, "rho < {value}"),
        }
    }
}

/// A [`Bound`], and optionally how far the curve may be from the polygon of the samples.
///
/// # Guarantees
/// The bound lies strictly between 0 and 1, or is a rho of 1; the limit is finite or infinite, and
/// above 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    bound: Bound,
    hausdorff_limit: Option<f64>,
}

/// How far the curve may be from the chord between two consecutive samples, at every point of it:
/// what [`sample_verified`](crate::sample_verified()) keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DeviationLimit {
    /// As far as it likes. Then the manifold boundary need not look like the curve at all: most
    /// curves end up with four samples, of which HNN-Crust returns the quadrilateral.
    None,
    /// Nearer than this length: a Hausdorff limit.
    Length(f64),
    /// Nearer than this fraction of lfs at each point. Up to 1, no chord gets across the medial
    /// axis: the point of the chord that is nearest to a curve point moves along all of it, and is
    /// within lfs every time. So the polygon can be deformed into the curve without touching the
    /// axis.
    OfLfs(f64),
}

/// Why values do not form a [`Condition`].
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ConditionError {
    /// Epsilon is out of range.
    #[error("epsilon is {0}: it must lie strictly between 0 and 1")]
    Epsilon(f64),
    /// Rho is out of range.
    #[error("rho is {0}: it must be above 0 and at most 1")]
    Rho(f64),
    /// The Hausdorff limit is not a positive length.
    #[error("the Hausdorff limit is {0}: it must be a length above 0")]
    HausdorffLimit(f64),
}

impl Condition {
    /// The epsilon-sampling condition.
    ///
    /// The paper claims that HNN-Crust returns the manifold boundary for epsilon < 0.47 (SGP 2016,
    /// Theorem 3). Its proof rests on the claim for rho < 0.9, which fails, but uses it for
    /// rho < 0.887 only; there no counterexample is known.
    ///
    /// # Errors
    /// If epsilon is not strictly between 0 and 1.
    pub fn epsilon(epsilon: f64) -> Result<Self, ConditionError> {
        let valid = (epsilon > 0.0 && epsilon < 1.0).then_some(Bound::Epsilon(epsilon));
        Ok(Self::of(valid.ok_or(ConditionError::Epsilon(epsilon))?))
    }

    /// The rho-sampling condition.
    ///
    /// The paper claims that HNN-Crust returns the manifold boundary for rho < 0.9 (SGP 2016,
    /// Theorem 2). That fails from rho = 0.8950 on: there are smooth curves with such samples on
    /// which it misses an edge. Below, no counterexample is known.
    ///
    /// # Errors
    /// If rho is not above 0 and at most 1.
    pub fn rho(rho: f64) -> Result<Self, ConditionError> {
        let valid = (rho > 0.0 && rho <= 1.0).then_some(Bound::Rho(rho));
        Ok(Self::of(valid.ok_or(ConditionError::Rho(rho))?))
    }

    /// The same condition, and every point of an interval lies nearer than `limit` to the chord of
    /// its two samples. `limit` is a length in the unit of the curve. The samplers of
    /// [`dense_points`](crate::dense_points) take the line through the samples, as the authors'
    /// program does.
    ///
    /// # Errors
    /// If the limit is not above 0, or NaN.
    pub fn with_hausdorff_limit(self, limit: f64) -> Result<Self, ConditionError> {
        if limit > 0.0 {
            Ok(Self {
                hausdorff_limit: Some(limit),
                ..self
            })
        } else {
            Err(ConditionError::HausdorffLimit(limit))
        }
    }

    /// The bound.
    #[must_use]
    pub fn bound(self) -> Bound {
        self.bound
    }

    /// The Hausdorff limit, a length; `None` if the distance to the polygon does not matter.
    #[must_use]
    pub fn hausdorff_limit(self) -> Option<f64> {
        self.hausdorff_limit
    }

    /// The same with another value, which is below the one it has.
    pub(crate) fn with_value(self, value: f64) -> Self {
        let bound = match self.bound {
            Bound::Epsilon(_) => Bound::Epsilon(value),
            Bound::Rho(_) => Bound::Rho(value),
        };
        Self { bound, ..self }
    }

    fn of(bound: Bound) -> Self {
        Self {
            bound,
            hausdorff_limit: None,
        }
    }
}

/// As a condition is written: `rho < 0.9`, or `rho < 0.9 within 0.01`.
impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.bound.fmt(f)?;
        match self.hausdorff_limit {
            None => Ok(()),
            Some(limit) => write!(f, " within {limit}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conditions_are_written_as_in_the_paper() {
        let rho = Condition::rho(0.9).unwrap();
        assert_eq!(rho.to_string(), "rho < 0.9");
        let limited = rho.with_hausdorff_limit(0.01).unwrap();
        assert_eq!(limited.to_string(), "rho < 0.9 within 0.01");
    }

    #[test]
    fn values_out_of_range_are_refused_by_name() {
        assert!(Condition::epsilon(1.0).is_err() && Condition::rho(1.0).is_ok());
        for bad in [0.0, -0.1, 1.5, f64::NAN, f64::INFINITY] {
            let epsilon = Condition::epsilon(bad).unwrap_err().to_string();
            assert!(
                epsilon.starts_with(&format!("epsilon is {bad}")),
                "{epsilon}"
            );
            assert!(Condition::rho(bad).is_err());
        }
        let rho = Condition::rho(0.9).unwrap();
        for bad in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
            assert!(rho.with_hausdorff_limit(bad).is_err());
        }
        assert!(rho.with_hausdorff_limit(f64::INFINITY).is_ok());
    }
}
