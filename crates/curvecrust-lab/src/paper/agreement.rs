//! Whether measured tables agree with known ones.

use std::fmt;

use crate::paper::published;
use crate::paper::rows::{Counts, CurveOrigin, PaperReport, Setting};

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

/// Of how many counts of Tables 2 and 3 in the paper's own setting at least so many must be equal.
const EQUAL_OF_27: usize = 20;

impl PaperReport {
    /// Where the report fails: wrong reconstructions; more samples from the best start than from the first; and on the authors' curves, in the settings
    /// of 300 points a segment, counts more than 1 from the known ones, or, in the paper's own
    /// setting, fewer than 20 of all 27 counts equal.
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
        let second = self.table2.iter().filter(|row| !row.reconstructed);
        let third = self.table3.iter().filter(|row| !row.reconstructed);
        let wrong = |setting, subject| Disagreement {
            setting,
            what: format!("HNN-Crust does not return the manifold boundary of {subject}"),
        };
        let converged = Setting {
            lfs: "voronoi",
            discretisation: "adaptive",
        };
        let verified = self.fewest.iter().filter_map(|row| {
            let failed = row.verified.is_some_and(|verified| !verified.reconstructed);
            failed.then(|| wrong(converged, format!("verified samples of {}", row.model)))
        });
        let more = self.fewest.iter().filter(|row| row.fewest > row.greedy);
        let more = more.map(|row| Disagreement {
            setting: converged,
            what: format!(
                "{}: {} of the best start are more than {}",
                row.model, row.fewest, row.greedy
            ),
        });
        second
            .map(|row| wrong(row.setting, row.model.to_owned()))
            .chain(third.map(|row| wrong(row.setting, limit_name(row.limit_percent))))
            .chain(verified)
            .chain(more)
            .collect()
    }

    fn counts_off(&self, setting: Setting) -> Vec<Disagreement> {
        let (second, third) = match (setting.lfs, setting.discretisation) {
            ("shrinking-ball", "300") => (published::TABLE_2, published::TABLE_3),
            ("voronoi", "300") => (published::VORONOI_TABLE_2, published::VORONOI_TABLE_3),
            _ => return Vec::new(),
        };
        let rows = self.table2.iter().filter(|row| row.setting == setting);
        let of_models = rows.filter_map(|row| {
            let known = second.iter().find(|known| known.0 == row.model)?.1;
            Some((row.model.to_owned(), row.counts, known))
        });
        let rows = self.table3.iter().filter(|row| row.setting == setting);
        let of_limits = rows.filter_map(|row| {
            let same = |limit: Option<f64>| limit_name(limit) == limit_name(row.limit_percent);
            let known = third.iter().find(|known| same(known.0))?.1;
            Some((limit_name(row.limit_percent), row.counts, known))
        });
        let compared: Vec<(String, Counts, [usize; 3])> = of_models.chain(of_limits).collect();
        let pairs = || {
            let columns = compared
                .iter()
                .map(|(_, counts, known)| counts.columns().into_iter().zip(*known));
            columns.flatten()
        };

        let mut found: Vec<Disagreement> = compared
            .iter()
            .filter(|(_, counts, known)| {
                let pairs = counts.columns().into_iter().zip(*known);
                pairs.into_iter().any(|(n, known)| n.abs_diff(known) > 1)
            })
            .map(|(subject, counts, known)| Disagreement {
                setting,
                what: format!(
                    "{subject}: {:?} samples, expected {known:?} within 1",
                    counts.columns()
                ),
            })
            .collect();
        let equal = pairs().filter(|(n, known)| n == known).count();
        if setting.lfs == "shrinking-ball" && pairs().count() == 27 && equal < EQUAL_OF_27 {
            found.push(Disagreement {
                setting,
                what: format!("{equal} of 27 counts equal the paper's, expected {EQUAL_OF_27}"),
            });
        }
        found
    }
}

/// A Hausdorff limit as the paper prints it.
pub(crate) fn limit_name(percent: Option<f64>) -> String {
    percent.map_or_else(|| "∞".to_owned(), |percent| format!("{percent} %"))
}
