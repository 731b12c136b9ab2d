//! Tables as Markdown, CSV and JSON.

mod fewest;

use std::fmt::Write;

use thiserror::Error;

use super::agreement::limit_name;
use super::published;
use super::rows::{Counts, CurveOrigin, PaperReport, Setting};

/// Why rows cannot be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RenderError {
    /// As CSV.
    #[error("cannot write the rows as CSV")]
    Csv(#[from] csv::Error),
    /// As JSON.
    #[error("cannot write the rows as JSON")]
    Json(#[from] serde_json::Error),
}

pub(crate) const CONDITIONS: [&str; 3] = ["rho < 0.9", "eps < 0.47", "eps < 1/3"];

/// The tables in Markdown, beside what the paper prints, for reading on a terminal too.
#[must_use]
pub fn markdown(report: &PaperReport) -> String {
    let mut text = String::new();
    if !report.table1.is_empty() {
        text += &table_1(report);
    }
    for setting in report.settings() {
        text += &table_2(report, setting);
        text += &table_3(report, setting);
    }
    text + &fewest::markdown(report)
}

/// One line for every number: table, subject, setting, quantity, value, and the paper's value.
///
/// # Errors
/// If the CSV writer fails, which it does not in memory.
pub fn csv(report: &PaperReport) -> Result<String, RenderError> {
    let mut lines = vec![
        [
            "table",
            "curves",
            "subject",
            "lfs",
            "discretisation",
            "quantity",
            "value",
            "paper",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    let curves = origin(report.curves);
    for (row, paper) in report.table1.iter().zip(published::TABLE_1) {
        let subject = format!("{} {} < {:.3}", row.algorithm, row.condition, row.bound);
        let numbers = [
            ("min_angle_deg", row.min_angle_deg, paper.min_angle_deg),
            ("circle", row.circle, paper.circle),
            ("parallel", row.parallel, paper.parallel),
        ];
        for (quantity, value, paper) in numbers {
            let line = [
                "1",
                "",
                &subject,
                "",
                "",
                quantity,
                &value.to_string(),
                &paper.to_string(),
            ];
            lines.push(line.map(str::to_owned).to_vec());
        }
    }
    let second = report.table2.iter().map(|row| {
        let subject = row.model.to_owned();
        (
            "2",
            subject,
            row.setting,
            row.counts,
            row.reconstructed,
            known_2(row.model),
        )
    });
    let third = report.table3.iter().map(|row| {
        let subject = limit_name(row.limit_percent);
        (
            "3",
            subject,
            row.setting,
            row.counts,
            row.reconstructed,
            known_3(row.limit_percent),
        )
    });
    for (table, subject, setting, counts, reconstructed, paper) in second.chain(third) {
        let Setting {
            lfs,
            discretisation,
        } = setting;
        let start = [table, curves, &subject, lfs, discretisation].map(str::to_owned);
        for ((condition, n), paper) in CONDITIONS.into_iter().zip(counts.columns()).zip(paper) {
            let end = [condition.to_owned(), n.to_string(), paper.to_string()];
            lines.push([&start[..], &end[..]].concat());
        }
        let end = [
            "reconstructed".to_owned(),
            reconstructed.to_string(),
            "true".to_owned(),
        ];
        lines.push([&start[..], &end[..]].concat());
    }
    for row in &report.fewest {
        for (quantity, value, paper) in fewest::quantities(row) {
            let line = [
                "fewest",
                curves,
                row.model,
                "voronoi",
                "adaptive",
                &format!("{}, {quantity}", row.condition),
                &value.to_string(),
                &paper.map_or_else(String::new, |n| n.to_string()),
            ];
            lines.push(line.map(str::to_owned).to_vec());
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    for line in lines {
        writer.write_record(line)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The rows as they are: `{"curves", "table1": [...], "table2": [...], "table3": [...], "fewest": [...]}`.
///
/// # Errors
/// If the JSON writer fails, which it does not in memory.
pub fn json(report: &PaperReport) -> Result<String, RenderError> {
    Ok(serde_json::to_string_pretty(report)? + "\n")
}

fn table_1(report: &PaperReport) -> String {
    let header = [
        "algorithm",
        "bound",
        "min angle",
        "paper",
        "circle",
        "paper",
        "parallel",
        "paper",
    ];
    let rows = report
        .table1
        .iter()
        .zip(published::TABLE_1)
        .map(|(row, paper)| {
            vec![
                row.algorithm.to_owned(),
                format!("{} < {}", row.condition, shortest(row.bound)),
                format!("{:.0}°", row.min_angle_deg),
                format!("{:.0}°", paper.min_angle_deg),
                row.circle.to_string(),
                paper.circle.to_string(),
                row.parallel.to_string(),
                paper.parallel.to_string(),
            ]
        });
    "## Table 1: what each sampling condition implies\n\n".to_owned()
        + &grid(&header, &rows.collect::<Vec<_>>())
        + "GathanG's 150° is its own authors' condition, not derived from the bound.\n\n"
}

fn table_2(report: &PaperReport, setting: Setting) -> String {
    let rows = report.table2.iter().filter(|row| row.setting == setting);
    let rows: Vec<_> = rows
        .map(|row| {
            let subject = row.model.to_owned();
            let verdicts = (row.reconstructed, row.closing_intervals_hold);
            counts_row(subject, row.counts, known_2(row.model), verdicts)
        })
        .collect();
    let title = "Table 2: samples needed (and redundant against rho < 0.9)";
    counts_table(title, "model", report.curves, setting, &rows)
}

fn table_3(report: &PaperReport, setting: Setting) -> String {
    let rows = report.table3.iter().filter(|row| row.setting == setting);
    let rows: Vec<_> = rows
        .map(|row| {
            let subject = limit_name(row.limit_percent);
            let verdicts = (row.reconstructed, row.closing_intervals_hold);
            counts_row(subject, row.counts, known_3(row.limit_percent), verdicts)
        })
        .collect();
    let title = "Table 3: the bunny within a Hausdorff distance of its larger extent";
    counts_table(title, "limit", report.curves, setting, &rows)
}

fn counts_table(
    title: &str,
    subject: &str,
    curves: CurveOrigin,
    setting: Setting,
    rows: &[Vec<String>],
) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let [rho, epsilon, third] = CONDITIONS;
    let header = [
        subject,
        rho,
        "paper",
        epsilon,
        "paper",
        third,
        "paper",
        "reconstructed",
        "closing interval",
    ];
    let points = match setting.discretisation {
        "adaptive" => "converged: adaptive points",
        _ => "300 points a segment",
    };
    let curves = match curves {
        CurveOrigin::Authors => "the authors' curves",
        CurveOrigin::Redrawn => "redrawn curves, not those of the paper",
        CurveOrigin::Given => "given curves, not those of the paper",
    };
    format!("## {title}\n\n{} lfs, {points}; {curves}\n\n", setting.lfs) + &grid(&header, rows)
}

fn counts_row(
    subject: String,
    counts: Counts,
    paper: [usize; 3],
    (reconstructed, closing_holds): (bool, bool),
) -> Vec<String> {
    let mut cells = vec![subject];
    for (ours, theirs) in with_redundancy(counts.columns())
        .into_iter()
        .zip(with_redundancy(paper))
    {
        cells.extend([ours, theirs]);
    }
    cells.push(if reconstructed { "exactly" } else { "WRONG" }.to_owned());
    cells.push(
        if closing_holds {
            "holds"
        } else {
            "does not hold"
        }
        .to_owned(),
    );
    cells
}

/// Counts, each after the first with the share of samples that it takes more than the first.
fn with_redundancy(counts: [usize; 3]) -> [String; 3] {
    let [first, ..] = counts;
    counts.map(|n| {
        if n == first {
            return n.to_string();
        }
        let ratio = n as f64 / first as f64;
        format!("{n} ({:.0} %)", 100.0 * (ratio - 1.0))
    })
}

fn known_2(model: &str) -> [usize; 3] {
    let row = published::TABLE_2.into_iter().find(|row| row.0 == model);
    row.map(|row| row.1).unwrap_or_default()
}

fn known_3(limit: Option<f64>) -> [usize; 3] {
    let same = |other: Option<f64>| limit_name(other) == limit_name(limit);
    let row = published::TABLE_3.into_iter().find(|row| same(row.0));
    row.map(|row| row.1).unwrap_or_default()
}

fn origin(curves: CurveOrigin) -> &'static str {
    match curves {
        CurveOrigin::Authors => "authors",
        CurveOrigin::Redrawn => "redrawn",
        CurveOrigin::Given => "given",
    }
}

/// At most three decimals.
fn shortest(value: f64) -> String {
    format!("{value:.3}").trim_end_matches('0').to_owned()
}

/// A Markdown table with columns in line.
pub(crate) fn grid(header: &[&str], rows: &[Vec<String>]) -> String {
    let header: Vec<String> = header.iter().map(|&cell| cell.to_owned()).collect();
    let width = |column: usize| {
        let cells = rows
            .iter()
            .chain([&header])
            .filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let mut text = String::new();
    let mut line = |row: &[String]| {
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(text, "| {cell:<width$} ");
        }
        text += "|\n";
    };
    line(&header);
    line(
        &widths
            .iter()
            .map(|&width| "-".repeat(width))
            .collect::<Vec<_>>(),
    );
    for row in rows {
        line(row);
    }
    text + "\n"
}
