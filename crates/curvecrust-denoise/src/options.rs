//! What a caller may know about the curves.

use std::num::NonZeroU32;

use curvecrust_reconstruct::{Known, Shape};

use crate::error::DenoiseError;

/// What is known about the curves that points scatter about; by default nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Whether all curves are closed or all are open.
    pub shape: Option<Shape>,
    /// How many curves there are. Of more, those with the most points are taken.
    pub curves: Option<NonZeroU32>,
    /// The standard deviation of the points from their curves, as a length; 0 if they lie on them.
    pub sigma: Option<f64>,
}

impl Options {
    pub(crate) fn known(&self) -> Known {
        Known {
            shape: self.shape,
            curves: self.curves,
            termini: Vec::new(),
        }
    }

    pub(crate) fn check(&self) -> Result<(), DenoiseError> {
        match self.sigma {
            Some(sigma) if !(sigma >= 0.0 && sigma.is_finite()) => {
                Err(DenoiseError::Sigma { sigma })
            }
            _ => Ok(()),
        }
    }
}
