//! Discs that are rounded outwards.

use curvecrust_geometry::DVec2;

/// A disc that is no smaller than what it stands for.
///
/// Its centre is given as seen from a point near which it lies: as a coordinate it would lose
/// digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// A point.
    pub from: DVec2,
    /// From there to the centre.
    pub to_centre: DVec2,
    /// The radius, rounded up; infinite or NaN if it is beyond the range of doubles.
    pub radius: f64,
}
