//! The numbers that the paper prints.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016, Tables 1 to 3. Counts of samples are in the order rho < 0.9, epsilon < 0.47, epsilon <
//! 1/3.

use super::rows::Subject;

/// A row of Table 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The algorithm that the bound is for.
    pub algorithm: &'static str,
    /// The condition's variable: `epsilon` or `rho`.
    pub condition: &'static str,
    /// What it has to stay below.
    pub bound: f64,
    /// Whether the paper derives the angle from the bound; GathanG's is its own authors' condition.
    pub angle_from_bound: bool,
    /// The least angle between consecutive edges, in degrees.
    pub min_angle_deg: f64,
    /// Samples on a circle.
    pub circle: f64,
    /// Samples on parallel lines as long as their distance.
    pub parallel: f64,
}

/// Table 1.
pub const TABLE_1: [Bound; 7] = [
    bound("GathanG", "epsilon", 0.5, [150.0, 12.0, 2.0], false),
    bound("Crust", "epsilon", 0.2, [157.0, 15.7, 5.0], true),
    bound("NN-Crust", "epsilon", 1.0 / 3.0, [142.0, 9.4, 3.0], true),
    bound(
        "NN-Crust (not proven)",
        "epsilon",
        0.4,
        [134.0, 7.8, 2.5],
        true,
    ),
    bound(
        "Lenz 2006 (not proven)",
        "epsilon",
        0.48,
        [124.0, 6.5, 2.1],
        true,
    ),
    bound("HNN-Crust", "epsilon", 0.47, [126.0, 6.6, 2.1], true),
    bound("HNN-Crust", "rho", 0.9, [73.0, 3.4, 1.1], true),
];

const fn bound(
    algorithm: &'static str,
    condition: &'static str,
    bound: f64,
    [min_angle_deg, circle, parallel]: [f64; 3],
    angle_from_bound: bool,
) -> Bound {
    Bound {
        algorithm,
        condition,
        bound,
        angle_from_bound,
        min_angle_deg,
        circle,
        parallel,
    }
}

/// Tables 2 and 3.
pub struct Known {
    /// Table 2: the model and its counts.
    pub models: [(&'static str, [usize; 3]); 4],
    /// Table 3: the Hausdorff limit in per cent of the larger extent, `None` for no limit, and the
    /// counts on the bunny.
    pub limits: [(Option<f64>, [usize; 3]); 5],
}

/// What the paper prints.
pub const PAPER: Known = Known {
    models: [
        ("parallel", [20, 35, 48]),
        ("teaser", [26, 43, 61]),
        ("bunny", [58, 94, 131]),
        ("cat", [180, 254, 356]),
    ],
    limits: [
        (None, [58, 94, 131]),
        (Some(1.0), [60, 94, 131]),
        (Some(0.3), [73, 99, 133]),
        (Some(0.1), [105, 123, 148]),
        (Some(0.03), [173, 186, 204]),
    ],
};

/// What a prototype of this project counted on the authors' curves with the Voronoi medial axis in
/// double precision, at 300 points a segment. No noise of single precision makes medial points too
/// near, so the counts are a little lower than the paper's.
pub const VORONOI: Known = Known {
    models: [
        ("parallel", [20, 35, 47]),
        ("teaser", [26, 43, 61]),
        ("bunny", [57, 92, 128]),
        ("cat", [173, 247, 346]),
    ],
    limits: [
        (None, [57, 92, 128]),
        (Some(1.0), [59, 93, 128]),
        (Some(0.3), [73, 98, 131]),
        (Some(0.1), [105, 123, 147]),
        (Some(0.03), [173, 186, 203]),
    ],
};

impl Known {
    /// The counts for a model or a limit, if the tables have it.
    #[must_use]
    pub fn counts(&self, subject: Subject) -> Option<[usize; 3]> {
        let mut models = self.models.iter().map(|row| (Subject::Model(row.0), row.1));
        let mut limits = self.limits.iter().map(|row| (Subject::Limit(row.0), row.1));
        let row = models
            .find(|row| row.0 == subject)
            .or_else(|| limits.find(|row| row.0 == subject))?;
        Some(row.1)
    }
}
