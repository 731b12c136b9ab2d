//! Whether measured tables agree with known ones.

use std::fmt;

use crate::paper::published;
use crate::paper::rows::{CurveOrigin, PaperReport, Setting};

/// A count of samples, or a number of them, that is not what it should be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Disagreement {
    setting: Setting,
    what: String,
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Setting {
            lfs,
            discretisation,
        } = self.setting;
        write!(f, "{lfs}, {discretisation}: {}", self.what)
    }
}

/// At least this many of the 27 counts of Tables 2 and 3 must be equal in the setting of the
/// authors' program.
const EQUAL_OF_27: usize = 20;

impl PaperReport {
    /// Where the report fails.
    ///
    /// A reconstruction is wrong, or the best start takes more samples than the first. On the
    /// authors' curves with 300 points a segment, a count is more than 1 from the known one; or, in
    /// the setting of the authors' program, fewer than 20 of all 27 counts are equal.
    #[must_use]
    pub fn agreement(&self) -> Vec<Disagreement> {
        let mut found = self.wrong_samplings();
        if self.curves == CurveOrigin::Authors {
            for setting in self.settings() {
                found.extend(self.counts_off(setting));
            }
        }
        found
    }

    fn wrong_samplings(&self) -> Vec<Disagreement> {
        let wrong = |setting, subject: &str| Disagreement {
            setting,
            what: format!("HNN-Crust does not return the manifold boundary of {subject}"),
        };
        let published = self.sampled().filter(|(_, s)| !s.reconstructed);
        let published = published.map(|(subject, s)| wrong(s.setting, &subject.to_string()));
        let converged = Setting {
            lfs: "voronoi",
            discretisation: "adaptive",
        };
        let verified = self.fewest.iter().filter_map(|row| {
            let failed = row.verified.is_some_and(|verified| !verified.reconstructed);
            let subject = format!("verified samples of {}", row.model);
            failed.then(|| wrong(converged, &subject))
        });
        let more = self.fewest.iter().filter(|row| row.fewest > row.greedy);
        let more = more.map(|row| Disagreement {
            setting: converged,
            what: format!(
                "{}: {} of the best start are more than {}",
                row.model, row.fewest, row.greedy
            ),
        });
        published.chain(verified).chain(more).collect()
    }

    fn counts_off(&self, setting: Setting) -> Vec<Disagreement> {
        let known = match (setting.lfs, setting.discretisation) {
            ("shrinking-ball", "300") => published::PAPER,
            ("voronoi", "300") => published::VORONOI,
            _ => return Vec::new(),
        };
        let (mut found, mut all, mut equal) = (Vec::new(), 0, 0);
        for (subject, sampled) in self.sampled().filter(|(_, s)| s.setting == setting) {
            let (counts, Some(known)) = (sampled.counts.columns(), known.counts(subject)) else {
                continue;
            };
            let off = |i: usize| counts[i].abs_diff(known[i]);
            all += 3;
            equal += (0..3).filter(|&i| off(i) == 0).count();
            if (0..3).any(|i| off(i) > 1) {
                found.push(Disagreement {
                    setting,
                    what: format!("{subject}: {counts:?} samples, expected {known:?} within 1"),
                });
            }
        }
        if setting.lfs == "shrinking-ball" && all == 27 && equal < EQUAL_OF_27 {
            found.push(Disagreement {
                setting,
                what: format!("{equal} of 27 counts equal the paper's, expected {EQUAL_OF_27}"),
            });
        }
        found
    }
}
