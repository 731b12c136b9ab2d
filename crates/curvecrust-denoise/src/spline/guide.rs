//! Where a spline starts from.

use glam::DVec2;

/// A polyline and, at its vertices, how long an interval may be and how far points scatter.
#[derive(Clone, Debug)]
pub(crate) struct Guide {
    pub(crate) vertices: Vec<DVec2>,
    pub(crate) spacing: Vec<f64>,
    pub(crate) sigma: Vec<f64>,
    pub(crate) closed: bool,
    /// Vertices where the direction may jump, ascending; of a closed one with any, the first
    /// vertex is one.
    pub(crate) creases: Vec<usize>,
    /// Whether the spline starts at an even pace, between creases, whatever the spacing.
    pub(crate) even: bool,
}

impl Guide {
    /// The same from its other end, without creases.
    pub(crate) fn turned(mut self) -> Self {
        self.vertices.reverse();
        self.spacing.reverse();
        self.sigma.reverse();
        self.creases.clear();
        self
    }

    /// This and then another one, as one that is open, without the creases of the other.
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
