//! How dense points of a curve are chosen, and what is measured at them.

use curvecrust_curve::{Curve, DenseCurve};
use curvecrust_geometry::Progress;

use crate::axis::MedialAxis;
use crate::error::MedialAxisError;
use crate::gaps::GapLimits;
use crate::measured_curve::{Estimator, MeasuredCurve};
use crate::refine::{axis, refine};

/// How dense points are chosen on a smooth curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Discretisation {
    /// The same number of points on every cubic segment, at equal steps of its parameter. The
    /// program of the paper's authors takes 300; the paper itself names no number.
    PerSegment(u32),
    /// As many points as needed: the gap between neighbours is at most this fraction of the lfs at
    /// both of them, and of the radius of curvature. With the Voronoi estimator, the axis itself
    /// comes from points that may be a few times farther apart, which costs it little precision.
    Adaptive {
        /// The fraction, above 0 and at most 1.
        gap_to_lfs: f64,
    },
}

/// Gaps of at most 0.02 of the lfs.
impl Default for Discretisation {
    fn default() -> Self {
        Self::Adaptive {
            gap_to_lfs: GAP_TO_LFS,
        }
    }
}

/// The largest gap between dense points as a fraction of lfs, where none is given.
pub(crate) const GAP_TO_LFS: f64 = 0.02;

/// How [`measure_with`] goes about it.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeasureOptions<'a> {
    /// How dense points are chosen; adaptively, with gaps of at most 0.02 of lfs, by default.
    pub discretisation: Discretisation,
    /// Where adaptive gaps would make more than 250,000 dense points, gaps grow up to this
    /// fraction of lfs, if it is the larger one; 0 by default, which keeps them.
    pub gap_to_lfs_of_many: f64,
    /// How lfs is estimated; from the Voronoi diagram by default.
    pub estimator: Estimator,
    /// Hears how many dense points there are, of about how many that will be.
    pub progress: Progress<'a>,
}

/// Discretises a curve with gaps of at most 0.02 of its lfs, which it estimates from the Voronoi
/// diagram.
///
/// # Errors
/// Those of [`measure_with`].
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::measure;
///
/// let circle = Curve::from_path_data("M 2 0 A 2 2 0 0 1 -2 0 A 2 2 0 0 1 2 0 Z")?;
/// let measured = measure(&circle)?;
/// assert!((measured.lfs().minimum() - 2.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn measure(curve: &Curve) -> Result<MeasuredCurve, MedialAxisError> {
    measure_with(curve, &MeasureOptions::default())
}

/// Discretises a curve and estimates its lfs, by the given [options](MeasureOptions).
///
/// # Errors
/// [`GapToLfs`](MedialAxisError::GapToLfs), [`Dense`](MedialAxisError::Dense) for more points than
/// the limit, and where the curve crosses or touches itself or another, or is discretised too
/// coarsely to tell.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::{Discretisation, MeasureOptions, measure_with};
///
/// let arch = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0")?;
/// let discretisation = Discretisation::PerSegment(300);
/// let options = MeasureOptions { discretisation, ..MeasureOptions::default() };
/// assert_eq!(measure_with(&arch, &options)?.dense().len(), 301);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn measure_with(
    curve: &Curve,
    options: &MeasureOptions<'_>,
) -> Result<MeasuredCurve, MedialAxisError> {
    let MeasureOptions {
        discretisation,
        gap_to_lfs_of_many,
        estimator,
        progress,
    } = *options;
    match discretisation {
        Discretisation::PerSegment(n) => {
            let dense = DenseCurve::per_segment(curve, n)?;
            progress.report(dense.len(), dense.len());
            MeasuredCurve::new(dense, estimator)
        }
        Discretisation::Adaptive { gap_to_lfs } => {
            let refined = refine(
                curve,
                GapLimits::new(gap_to_lfs, gap_to_lfs_of_many)?,
                progress,
            )?;
            match estimator {
                Estimator::Voronoi => Ok(refined),
                Estimator::ShrinkingBall => {
                    MeasuredCurve::new(refined.into_dense(), Estimator::ShrinkingBall)
                }
            }
        }
    }
}

/// The medial axis of a curve, and the dense points that it is of, with the lfs at each.
///
/// Gaps are as the [options](MeasureOptions) say, but for long strands that are near each other:
/// their points may be farther apart, where they face each other, and their axis is as precise. So
/// it takes far fewer pieces than lfs takes dense points.
///
/// # Errors
/// Those of [`measure_with`].
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::{MeasureOptions, measure, measure_axis};
///
/// // Two circles, a thousandth of their radius apart.
/// let d = "M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z
///          M 1.001 0 A 1.001 1.001 0 0 1 -1.001 0 A 1.001 1.001 0 0 1 1.001 0 Z";
/// let curve = Curve::from_path_data(d)?;
/// let (axis, _) = measure_axis(&curve, &MeasureOptions::default())?;
/// assert!(50 * axis.len() < measure(&curve)?.dense().len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn measure_axis(
    curve: &Curve,
    options: &MeasureOptions<'_>,
) -> Result<(MedialAxis, MeasuredCurve), MedialAxisError> {
    match options.discretisation {
        Discretisation::Adaptive { gap_to_lfs } => {
            let gaps = GapLimits::new(gap_to_lfs, options.gap_to_lfs_of_many)?;
            axis(curve, gaps, options.progress, 1.0)
        }
        Discretisation::PerSegment(_) => {
            let measured = measure_with(curve, options)?;
            Ok((MedialAxis::new(measured.dense())?, measured))
        }
    }
}
