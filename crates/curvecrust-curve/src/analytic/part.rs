//! Parts of analytic curves: quarters of ellipses and straight pieces.

use std::f64::consts::FRAC_PI_2;

use glam::DVec2;

use crate::curve::CurveParam;
use crate::dense::{Builder, DenseCurve, at_most_limit};
use crate::error::{DENSE_LIMIT, DenseError};

/// A smooth part of a curve, one segment of its parameter.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// A quarter of an ellipse, and how many quarter turns it comes after the first.
    Quarter {
        centre: DVec2,
        radii: DVec2,
        turns: u8,
    },
    /// A straight piece, cut into a number of steps.
    Straight { from: DVec2, to: DVec2, steps: u32 },
}

/// The four quarters of an ellipse, counter-clockwise from the positive x axis.
pub(super) fn quarters(radii: DVec2) -> [Part; 4] {
    let centre = DVec2::ZERO;
    [0, 1, 2, 3].map(|turns| Part::Quarter {
        centre,
        radii,
        turns,
    })
}

/// The length of a step along a quarter circle.
pub(super) fn spacing(radius: f64, per_quarter: u32) -> Result<f64, DenseError> {
    if per_quarter == 0 {
        return Err(DenseError::NoPieces { index: 0 });
    }
    Ok(radius * FRAC_PI_2 / f64::from(per_quarter))
}

impl Part {
    pub(super) fn straight(from: DVec2, to: DVec2, spacing: f64) -> Self {
        // One more than the limit is as good as any larger number: it is refused.
        let most = DENSE_LIMIT as f64 + 1.0;
        let steps = (from.distance(to) / spacing).ceil().clamp(1.0, most);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to the limit"
        )]
        let steps = steps as u32;
        Self::Straight { from, to, steps }
    }

    pub(super) fn shifted(self, by: DVec2) -> Self {
        match self {
            Self::Quarter {
                centre,
                radii,
                turns,
            } => Self::Quarter {
                centre: centre + by,
                radii,
                turns,
            },
            Self::Straight { from, to, steps } => Self::Straight {
                from: from + by,
                to: to + by,
                steps,
            },
        }
    }

    fn steps(&self, per_quarter: u32) -> u32 {
        match *self {
            Self::Quarter { .. } => per_quarter,
            Self::Straight { steps, .. } => steps,
        }
    }

    fn point(&self, t: f64) -> DVec2 {
        match *self {
            Self::Quarter {
                centre,
                radii,
                turns,
            } => {
                // Turned from the first quarter, all four are alike to the last bit.
                let (y, x) = (FRAC_PI_2 * t).sin_cos();
                let turned = match turns {
                    0 => DVec2::new(x, y),
                    1 => DVec2::new(-y, x),
                    2 => DVec2::new(-x, -y),
                    _ => DVec2::new(y, -x),
                };
                centre + turned * radii
            }
            // From the nearer end: both are met exactly, and coordinates that are equal stay so.
            Self::Straight { from, to, .. } if t <= 0.5 => from + (to - from) * t,
            Self::Straight { from, to, .. } => to - (to - from) * (1.0 - t),
        }
    }
}

/// The points of components, each a sequence of parts, without the end that a closed one repeats.
pub(super) fn dense(
    components: &[&[Part]],
    closed: bool,
    per_quarter: u32,
) -> Result<DenseCurve, DenseError> {
    if per_quarter == 0 {
        return Err(DenseError::NoPieces { index: 0 });
    }
    let steps = |part: &Part| u64::from(part.steps(per_quarter));
    at_most_limit(components.iter().copied().flatten().map(steps).sum())?;
    let mut builder = Builder::default();
    for (component, parts) in (0u32..).zip(components) {
        builder.component(closed, |push| {
            for (segment, part) in (0u32..).zip(*parts) {
                let mut push_at = |t| {
                    let at = CurveParam {
                        component,
                        segment,
                        t,
                    };
                    push(part.point(t), at);
                };
                let steps = part.steps(per_quarter);
                for i in 0..steps {
                    push_at(f64::from(i) / f64::from(steps));
                }
                if !closed && segment as usize + 1 == parts.len() {
                    push_at(1.0);
                }
            }
        });
    }
    builder.finish()
}
