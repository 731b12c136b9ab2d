//! Whether rows have the answers that are known.

use super::experiment::Experiment;
use crate::compare::rows::Row;

/// Where answers differ from known ones: a line for each series and value of the sweep.
pub(super) fn differing(experiments: &[Experiment], rows: &[Row]) -> Vec<String> {
    let mut found = Vec::new();
    for experiment in experiments {
        for known in &experiment.known {
            let is_meant = |row: &&Row| {
                row.experiment == experiment.name
                    && row.algorithm == known.algorithm
                    && row.x <= known.up_to
                    && !known.except.contains(&row.series)
            };
            let meant: Vec<&Row> = rows.iter().filter(is_meant).collect();
            for cell in
                meant.chunk_by(|a, b| a.series == b.series && a.x.to_bits() == b.x.to_bits())
            {
                let wrong: Vec<&&Row> = cell.iter().filter(|row| !is_exact(row)).collect();
                if let Some(first) = wrong.first() {
                    found.push(format!(
                        "{}: {} is not exact in {} of {} trials of {} at {} (first: trial {}, \
                         seed {}); expected always: {}",
                        experiment.name,
                        known.algorithm,
                        wrong.len(),
                        cell.len(),
                        first.series,
                        first.x,
                        first.trial,
                        first.seed,
                        known.source
                    ));
                }
            }
        }
    }
    found
}

fn is_exact(row: &Row) -> bool {
    // The first of the metrics.
    matches!(row.values.first(), Some(Some(exact)) if exact.lower >= 1.0)
}
