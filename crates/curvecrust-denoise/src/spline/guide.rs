//! Where a spline starts from.

use glam::DVec2;

/// A polyline and, at its vertices, how long an interval may be and how far points scatter.
#[derive(Clone, Debug)]
pub(crate) struct Guide {
    pub(crate) vertices: Vec<DVec2>,
    pub(crate) spacing: Vec<f64>,
    pub(crate) sigma: Vec<f64>,
    pub(crate) closed: bool,
}

impl Guide {
    /// The same from its other end.
    pub(crate) fn turned(mut self) -> Self {
        self.vertices.reverse();
        self.spacing.reverse();
        self.sigma.reverse();
        self
    }

    /// This and then another one, as one that is open.
    pub(crate) fn and_then(mut self, other: Self) -> Self {
        self.vertices.extend(other.vertices);
        self.spacing.extend(other.spacing);
        self.sigma.extend(other.sigma);
        self
    }

    /// With its ends joined, counter-clockwise.
    pub(crate) fn closed(self) -> Self {
        let next = self.vertices.iter().cycle().skip(1);
        let pairs = self.vertices.iter().zip(next);
        let area: f64 = pairs.map(|(a, b)| a.perp_dot(*b)).sum();
        let turned = if area < 0.0 { self.turned() } else { self };
        Self {
            closed: true,
            ..turned
        }
    }
}
