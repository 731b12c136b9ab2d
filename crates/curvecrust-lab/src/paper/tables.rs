//! From rows to tables: those of the paper beside what it prints, one of all numbers, and JSON.

use super::published;
use super::rows::{CurveOrigin, FewestRow, PaperReport, Setting, Subject};
use crate::table::{Field, Section, Table};

const CONDITIONS: [&str; 3] = ["rho < 0.9", "eps < 0.47", "eps < 1/3"];

/// Every table that has rows, for reading.
#[must_use]
pub fn sections(report: &PaperReport) -> Vec<Section> {
    let mut sections = vec![table_1(report)];
    for setting in report.settings() {
        sections.push(table_2(report, setting));
        sections.push(table_3(report, setting));
    }
    sections.push(fewest(report));
    sections.retain(|section| !section.table.rows.is_empty());
    sections
}

/// The [`sections`] as Markdown.
#[must_use]
pub fn markdown(report: &PaperReport) -> String {
    let sections = sections(report);
    sections.iter().map(|s| s.to_markdown(2)).collect()
}

/// The rows as they are: `{"curves", "table1": [...], "table2": [...], "table3": [...], "fewest":
/// [...]}`.
///
/// # Errors
/// If the JSON writer fails, which it does not in memory.
pub fn json(report: &PaperReport) -> serde_json::Result<String> {
    Ok(serde_json::to_string_pretty(report)? + "\n")
}

/// One line for every number: table, subject, setting, quantity, value, and the paper's value.
#[must_use]
pub fn numbers(report: &PaperReport) -> Table {
    let mut table = Table::new([
        "table",
        "curves",
        "subject",
        "lfs",
        "discretisation",
        "quantity",
        "value",
        "paper",
    ]);
    for (row, paper) in report.table1.iter().zip(published::TABLE_1) {
        let subject = format!("{} {} < {:.3}", row.algorithm, row.condition, row.bound);
        for (quantity, value, paper) in [
            ("min_angle_deg", row.min_angle_deg, paper.min_angle_deg),
            ("circle", row.circle, paper.circle),
            ("parallel", row.parallel, paper.parallel),
        ] {
            let start = ["1", "", &subject, "", "", quantity].map(Field::from);
            table.rows.push(with(start, value, paper));
        }
    }
    let curves = match report.curves {
        CurveOrigin::Authors => "authors",
        CurveOrigin::Redrawn => "redrawn",
        CurveOrigin::Given => "given",
    };
    for (subject, sampled) in report.sampled() {
        let number = match subject {
            Subject::Model(_) => "2",
            Subject::Limit(_) => "3",
        };
        let paper = published::PAPER.counts(subject).unwrap_or_default();
        let (subject, setting) = (subject.to_string(), sampled.setting);
        let start = |quantity: &str| {
            let (lfs, points) = (setting.lfs, setting.discretisation);
            [number, curves, &subject, lfs, points, quantity].map(Field::from)
        };
        let columns = CONDITIONS.into_iter().zip(sampled.counts.columns());
        for ((condition, n), paper) in columns.zip(paper) {
            table.rows.push(with(start(condition), n, paper));
        }
        let reconstructed = sampled.reconstructed.to_string();
        let start = start("reconstructed");
        table.rows.push(with(start, reconstructed, "true"));
    }
    for row in &report.fewest {
        for (quantity, value, paper) in quantities(row) {
            let quantity = format!("{}, {quantity}", row.condition);
            let start = [
                "fewest", curves, row.model, "voronoi", "adaptive", &quantity,
            ];
            let start = start.map(Field::from);
            table.rows.push(with(start, value, Field::count(paper)));
        }
    }
    table
}

fn with(start: [Field; 6], value: impl Into<Field>, paper: impl Into<Field>) -> Vec<Field> {
    start
        .into_iter()
        .chain([value.into(), paper.into()])
        .collect()
}

fn table_1(report: &PaperReport) -> Section {
    let mut table = Table::new([
        "algorithm",
        "bound",
        "min angle",
        "paper",
        "circle",
        "paper",
        "parallel",
        "paper",
    ]);
    for (row, paper) in report.table1.iter().zip(published::TABLE_1) {
        // At most three decimals.
        let bound = format!("{:.3}", row.bound);
        let bound = bound.trim_end_matches('0');
        let degrees = |angle: f64| Field::Written(format!("{angle:.0}°"));
        table.rows.push(vec![
            row.algorithm.into(),
            format!("{} < {bound}", row.condition).into(),
            degrees(row.min_angle_deg),
            degrees(paper.min_angle_deg),
            Field::Number(row.circle),
            Field::Number(paper.circle),
            Field::Number(row.parallel),
            Field::Number(paper.parallel),
        ]);
    }
    Section {
        title: "Table 1: what each sampling condition implies".to_owned(),
        about: String::new(),
        table,
        note: "GathanG's 150° is its own authors' condition, not derived from the bound."
            .to_owned(),
    }
}

fn table_2(report: &PaperReport, setting: Setting) -> Section {
    let title = "Table 2: samples needed (and redundant against rho < 0.9)";
    let is_meant = |subject: Subject| matches!(subject, Subject::Model(_));
    counts(report, setting, [title, "model"], is_meant)
}

fn table_3(report: &PaperReport, setting: Setting) -> Section {
    let title = "Table 3: the bunny within a Hausdorff distance of its larger extent";
    let is_meant = |subject: Subject| matches!(subject, Subject::Limit(_));
    counts(report, setting, [title, "limit"], is_meant)
}

fn counts(
    report: &PaperReport,
    setting: Setting,
    [title, subject]: [&str; 2],
    is_meant: fn(Subject) -> bool,
) -> Section {
    let [rho, epsilon, third] = CONDITIONS;
    let mut table = Table::new([
        subject,
        rho,
        "paper",
        epsilon,
        "paper",
        third,
        "paper",
        "reconstructed",
        "closing interval",
    ]);
    for (subject, sampled) in report.sampled() {
        if sampled.setting != setting || !is_meant(subject) {
            continue;
        }
        let ours = with_redundancy(sampled.counts.columns());
        let paper = with_redundancy(published::PAPER.counts(subject).unwrap_or_default());
        let holds = if sampled.closing_intervals_hold {
            "holds"
        } else {
            "does not hold"
        };
        let mut fields = vec![Field::from(subject.to_string())];
        fields.extend(ours.into_iter().zip(paper).flat_map(<[_; 2]>::from));
        fields.extend([verdict(sampled.reconstructed).into(), holds.into()]);
        table.rows.push(fields);
    }
    let points = match setting.discretisation {
        "adaptive" => "converged: adaptive points",
        _ => "300 points a segment",
    };
    Section {
        title: title.to_owned(),
        about: format!("{} lfs, {points}; {}", setting.lfs, whose(report.curves)),
        table,
        note: String::new(),
    }
}

fn whose(curves: CurveOrigin) -> &'static str {
    match curves {
        CurveOrigin::Authors => "the authors' curves",
        CurveOrigin::Redrawn => "redrawn curves, not those of the paper",
        CurveOrigin::Given => "given curves, not those of the paper",
    }
}

fn verdict(reconstructed: bool) -> &'static str {
    if reconstructed { "exactly" } else { "WRONG" }
}

/// Counts, each after the first with the share of samples that it takes more than the first.
fn with_redundancy(counts: [usize; 3]) -> [Field; 3] {
    let [first, ..] = counts;
    counts.map(|n| {
        let more = 100.0 * (n as f64 / first as f64 - 1.0);
        if n == first {
            n.into()
        } else {
            Field::Written(format!("{n} ({more:.0} %)"))
        }
    })
}

/// The block after the paper's tables: how few samples there can be.
fn fewest(report: &PaperReport) -> Section {
    let mut table = Table::new([
        "model",
        "condition",
        "paper",
        "greedy",
        "fewest",
        "verified, within lfs",
        "verified, within 1 %",
        "verified, no limit",
        "reconstructed",
    ]);
    for row in &report.fewest {
        let verified = |of: fn(_) -> usize| Field::count(row.verified.map(of));
        table.rows.push(vec![
            row.model.into(),
            row.condition.into(),
            Field::count(paper(row)),
            row.greedy.into(),
            row.fewest.into(),
            verified(|v| v.within_lfs),
            verified(|v| v.within_percent),
            verified(|v| v.no_limit),
            row.verified
                .map_or(Field::Empty, |v| verdict(v.reconstructed).into()),
        ]);
    }
    let rounds = report.fewest.iter().find_map(|row| row.verified);
    let rounds = rounds.map_or(0, |verified| verified.rounds);
    Section {
        title: "Beyond the paper: the fewest samples".to_owned(),
        about: format!(
            "voronoi lfs, converged: adaptive points; {}",
            whose(report.curves)
        ),
        table,
        note: format!(
            "Greedy and fewest: certified at every point of the curve, from its first point and \
             from the best of all starts. Verified: after {rounds} rounds of removing and moving \
             samples, for this sample set only; without a limit the polygon need not look like \
             the curve at all."
        ),
    }
}

/// Every number with its name, and that of the paper.
fn quantities(row: &FewestRow) -> Vec<(&'static str, usize, Option<usize>)> {
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
    let counts = published::PAPER.counts(Subject::Model(row.model))?;
    let column = CONDITIONS.iter().position(|&c| c == row.condition)?;
    counts.get(column).copied()
}
