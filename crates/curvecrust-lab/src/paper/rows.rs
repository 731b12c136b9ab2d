//! Rows of the paper's tables, as measured.

use serde::Serialize;
use std::fmt;

/// Whose drawings the tables were computed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum CurveOrigin {
    /// The curves of the paper.
    Authors,
    /// This project's drawings of the same subjects: counts are of other curves than the paper's.
    Redrawn,
    /// Other curves of the same names.
    Given,
}

/// How lfs was estimated, on which dense points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Setting {
    /// `shrinking-ball` or `voronoi`.
    pub lfs: &'static str,
    /// `300` points a segment, or `adaptive`.
    pub discretisation: &'static str,
}

/// Numbers of samples under the three conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// For rho < 0.9.
    #[serde(rename = "rho0.9")]
    pub rho: usize,
    /// For epsilon < 0.47.
    #[serde(rename = "eps0.47")]
    pub epsilon: usize,
    /// For epsilon < 1/3.
    #[serde(rename = "eps1/3")]
    pub epsilon_third: usize,
}

impl Counts {
    /// In the order of the paper's columns.
    #[must_use]
    pub fn columns(self) -> [usize; 3] {
        [self.rho, self.epsilon, self.epsilon_third]
    }
}

impl From<[usize; 3]> for Counts {
    fn from([rho, epsilon, epsilon_third]: [usize; 3]) -> Self {
        Self {
            rho,
            epsilon,
            epsilon_third,
        }
    }
}

/// What a sampling bound implies, to the digits that the paper prints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table1Row {
    /// The algorithm that the bound is for.
    pub algorithm: &'static str,
    /// `epsilon` or `rho`.
    pub condition: &'static str,
    /// What it has to stay below.
    pub bound: f64,
    /// The least angle between consecutive edges, in degrees.
    pub min_angle_deg: f64,
    /// Samples on a circle.
    pub circle: f64,
    /// Samples on parallel lines as long as their distance.
    pub parallel: f64,
}

/// What sampling under the three conditions gave.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Sampled {
    /// How lfs was estimated.
    #[serde(flatten)]
    pub setting: Setting,
    /// The numbers of samples.
    #[serde(flatten)]
    pub counts: Counts,
    /// Whether HNN-Crust returns exactly the manifold boundary of every one of the samplings.
    pub reconstructed: bool,
    /// Whether the condition holds on the interval from the last sample back to the first, too.
    pub closing_intervals_hold: bool,
}

/// What sampling one model took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table2Row {
    /// The model's name.
    pub model: &'static str,
    /// What it took.
    #[serde(flatten)]
    pub sampled: Sampled,
}

/// What sampling the bunny took under a Hausdorff limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table3Row {
    /// The limit in per cent of the larger extent; `None` for no limit.
    pub limit_percent: Option<f64>,
    /// What it took.
    #[serde(flatten)]
    pub sampled: Sampled,
}

/// The fewest samples of one model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FewestRow {
    /// The model's name.
    pub model: &'static str,
    /// `rho < 0.9`, `eps < 0.47` or `eps < 1/3`.
    pub condition: &'static str,
    /// Certified greedy samples from the first point of the curve.
    pub greedy: usize,
    /// From the best of all starts.
    pub fewest: usize,
    /// What is enough for HNN-Crust, beginning with the greedy samples; for rho alone.
    pub verified: Option<VerifiedCounts>,
}

/// Numbers of samples from which HNN-Crust has been seen to return exactly the manifold boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct VerifiedCounts {
    /// With chords within lfs of the curve: none gets across the medial axis.
    pub within_lfs: usize,
    /// With chords within 1 % of the larger extent.
    pub within_percent: usize,
    /// However far the chords are.
    pub no_limit: usize,
    /// How often samples were shaken for each.
    pub rounds: usize,
    /// Whether HNN-Crust returns exactly the manifold boundary of all three.
    pub reconstructed: bool,
}

/// The tables, or those of them that were asked for; the others are empty.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PaperReport {
    /// Whose curves these are.
    pub curves: CurveOrigin,
    /// Table 1.
    pub table1: Vec<Table1Row>,
    /// Table 2, setting by setting.
    pub table2: Vec<Table2Row>,
    /// Table 3, setting by setting.
    pub table3: Vec<Table3Row>,
    /// The fewest samples of every model.
    pub fewest: Vec<FewestRow>,
}

/// What a row of Table 2 or 3 is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Subject {
    /// A model.
    Model(&'static str),
    /// The bunny within a Hausdorff limit in per cent of its larger extent; `None` for no limit.
    Limit(Option<f64>),
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Model(name) => f.write_str(name),
            Self::Limit(None) => f.write_str("∞"),
            Self::Limit(Some(percent)) => write!(f, "{percent} %"),
        }
    }
}

impl PaperReport {
    /// The rows of Table 2, then those of Table 3.
    pub fn sampled(&self) -> impl Iterator<Item = (Subject, Sampled)> {
        let second = self.table2.iter();
        let second = second.map(|row| (Subject::Model(row.model), row.sampled));
        let third = self.table3.iter();
        second.chain(third.map(|row| (Subject::Limit(row.limit_percent), row.sampled)))
    }

    /// The settings that Tables 2 and 3 were computed in, in order.
    #[must_use]
    pub fn settings(&self) -> Vec<Setting> {
        let mut settings: Vec<Setting> = Vec::new();
        for (_, sampled) in self.sampled() {
            if !settings.contains(&sampled.setting) {
                settings.push(sampled.setting);
            }
        }
        settings
    }
}
