//! The root mean square of distances: how far a reconstruction is from the curve on average.
//!
//! Each directed value is the square root of the mean, by length, of the squared distance to the
//! other. It is found at the middles of short pieces. A distance changes by at most as much as the
//! point moves, so by Minkowski's inequality the value is off by at most the root mean square of
//! the distance to the middle: h / sqrt(12) for pieces of length h. The bounds say so; the error
//! itself is of order h^2. That arcs are a little longer than the chords that stand for them is not
//! part of the bounds: it changes the value by a fraction of (flatness / chord)^2.

use curvecrust_geometry::{DVec2, Segment, SegmentTree};

use crate::bounds::Bounds;
use crate::reference::{Polygon, Reference};

/// The two directed root mean squares. Both are infinite when the polygon has no edge.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RootMeanSquare {
    /// Of the distance to the polygon, over the curve.
    pub curve_to_polygon: Bounds,
    /// Of the distance to the curve, over the polygon.
    pub polygon_to_curve: Bounds,
}

/// Both directions, each with bounds `tolerance` and twice the flatness apart.
pub(crate) fn between(reference: &Reference, polygon: &Polygon, tolerance: f64) -> RootMeanSquare {
    let widened = |found: Bounds| Bounds {
        lower: (found.lower - reference.flatness()).max(0.0),
        upper: found.upper + reference.flatness(),
    };
    // The bounds are h / sqrt(12) to either side.
    let step = tolerance * 3f64.sqrt();
    RootMeanSquare {
        curve_to_polygon: widened(directed(reference.chords(), &polygon.tree, step)),
        polygon_to_curve: widened(directed(&polygon.sides, reference.tree(), step)),
    }
}

/// The root mean square of the distance to `to`, over the segments `from` in pieces of at most
/// `step`.
fn directed(from: &[Segment], to: &SegmentTree, step: f64) -> Bounds {
    let (mut squares, mut slack, mut length) = (0.0, 0.0, 0.0);
    let mut last: Option<Segment> = None;
    for segment in from {
        let pieces = (segment.length() / step).ceil().max(1.0);
        let h = segment.length() / pieces;
        let mut k = 0.5;
        while k < pieces {
            let p: DVec2 = segment.a.lerp(segment.b, k / pieces);
            let found = match last {
                Some(near) => to.nearest_after(p, near),
                None => to.nearest(p),
            };
            let Some((near, distance)) = found else {
                return Bounds::exactly(f64::INFINITY);
            };
            last = Some(near);
            squares += distance * distance * h;
            k += 1.0;
        }
        slack += h * h * segment.length() / 12.0;
        length += segment.length();
    }
    if length > 0.0 {
        let (mean, slack) = ((squares / length).sqrt(), (slack / length).sqrt());
        Bounds {
            lower: (mean - slack).max(0.0),
            upper: mean + slack,
        }
    } else {
        Bounds::exactly(f64::INFINITY)
    }
}
