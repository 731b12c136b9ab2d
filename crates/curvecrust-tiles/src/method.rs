//! The algorithms that are local enough for tiles.

use curvecrust_reconstruct::neighbours::{HalfRule, Keep};

/// An algorithm in which every sample chooses its nearest and its half neighbour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// Where the half neighbour is sought.
    pub rule: HalfRule,
    /// Which of the edges that were chosen are kept.
    pub keep: Keep,
}

impl Method {
    /// HNN-Crust: the edges that both of their ends chose.
    pub const HNN_CRUST: Self = Self {
        rule: HalfRule::Bisector,
        keep: Keep::Mutual,
    };
    /// All edges that HNN-Crust considers.
    pub const HNN_CRUST_UNION: Self = Self {
        rule: HalfRule::Bisector,
        keep: Keep::Union,
    };
    /// NN-Crust.
    pub const NN_CRUST: Self = Self {
        rule: HalfRule::RightAngle,
        keep: Keep::Union,
    };

    /// The methods by the names of their algorithms.
    pub const ALL: &[(&str, Self)] = &[
        ("hnn-crust", Self::HNN_CRUST),
        ("hnn-crust-union", Self::HNN_CRUST_UNION),
        ("nn-crust", Self::NN_CRUST),
    ];

    /// The method of an algorithm; `None` if the algorithm is not local.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        let found = Self::ALL.iter().find(|(known, _)| *known == name);
        found.map(|&(_, method)| method)
    }
}
