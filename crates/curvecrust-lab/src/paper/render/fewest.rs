//! The block after the paper's tables: how few samples there can be, and how few are enough for this sample set.

use super::CONDITIONS;
use super::grid;
use crate::paper::published;
use crate::paper::rows::{CurveOrigin, FewestRow, PaperReport};

/// The block in Markdown; empty without rows.
pub(crate) fn markdown(report: &PaperReport) -> String {
    let Some(first) = report.fewest.first() else {
        return String::new();
    };
    let header = [
        "model",
        "condition",
        "paper",
        "greedy",
        "fewest",
        "verified, within lfs",
        "verified, within 1 %",
        "verified, no limit",
        "reconstructed",
    ];
    let rows: Vec<_> = report.fewest.iter().map(cells).collect();
    let curves = match report.curves {
        CurveOrigin::Authors => "the authors' curves",
        CurveOrigin::Redrawn => "redrawn curves, not those of the paper",
        CurveOrigin::Given => "given curves, not those of the paper",
    };
    let rounds = first.verified.map_or(0, |verified| verified.rounds);
    format!(
        "## Beyond the paper: the fewest samples\n\n\
         voronoi lfs, converged: adaptive points; {curves}\n\n{}\
         Greedy and fewest: certified at every point of the curve, from its first point and from the best of all \
         starts. Verified: after {rounds} rounds of removing and moving samples, for this sample set only; without a \
         limit the polygon need not look like the curve at all.\n\n",
        grid(&header, &rows)
    )
}

fn cells(row: &FewestRow) -> Vec<String> {
    let counts = match row.verified {
        None => [const { String::new() }; 4],
        Some(verified) => [
            verified.within_lfs.to_string(),
            verified.within_percent.to_string(),
            verified.no_limit.to_string(),
            if verified.reconstructed {
                "exactly"
            } else {
                "WRONG"
            }
            .to_owned(),
        ],
    };
    let start = [
        row.model.to_owned(),
        row.condition.to_owned(),
        paper(row).map_or_else(String::new, |n| n.to_string()),
        row.greedy.to_string(),
        row.fewest.to_string(),
    ];
    start.into_iter().chain(counts).collect()
}

/// Every number with its name, and that of the paper.
pub(crate) fn quantities(row: &FewestRow) -> Vec<(&'static str, usize, Option<usize>)> {
    let mut numbers = vec![
        ("greedy", row.greedy, paper(row)),
        ("fewest", row.fewest, paper(row)),
    ];
    if let Some(verified) = row.verified {
        numbers.extend([
            ("verified within lfs", verified.within_lfs, None),
            ("verified within 1 %", verified.within_percent, None),
            ("verified", verified.no_limit, None),
        ]);
    }
    numbers
}

/// What the paper prints for the condition.
fn paper(row: &FewestRow) -> Option<usize> {
    let counts = published::TABLE_2
        .iter()
        .find(|known| known.0 == row.model)?
        .1;
    let column = CONDITIONS.iter().position(|&c| c == row.condition)?;
    counts.get(column).copied()
}
