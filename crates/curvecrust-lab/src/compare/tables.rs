//! Tables as Markdown, and everything as JSON.

use serde::Serialize;

use crate::compare::heat_map::{HeatMap, percent};
use crate::compare::rows::six_digits;
use crate::compare::sheet::{Answers, Faultless, Panel, Sheet};
use crate::paper::render::{RenderError, grid};

/// All tables: the overview, then every panel of every experiment.
#[must_use]
pub fn markdown(sheets: &[Sheet], algorithms: &[&str]) -> String {
    let mut text = overview(sheets, algorithms);
    for sheet in sheets {
        let experiment = &sheet.experiment;
        text += &format!(
            "## {}: {}\n\n{}\n\n",
            experiment.name,
            experiment.title,
            experiment.question.trim()
        );
        for panel in &sheet.panels {
            text += &format!("### {}\n\n", panel.title());
            text += &panel_table(panel, &experiment.sweep);
        }
    }
    text
}

/// The share of trials with exactly the true edges, by experiment and algorithm.
#[must_use]
pub fn overview(sheets: &[Sheet], algorithms: &[&str]) -> String {
    let map = HeatMap::new(sheets, algorithms);
    if map.rows.is_empty() {
        return String::new();
    }
    let mut header = vec!["exactly the true edges"];
    header.extend(map.rows.iter().map(|row| row.0.as_str()));
    let lines: Vec<Vec<String>> = map
        .columns
        .iter()
        .enumerate()
        .map(|(i, name)| {
            let shares = map
                .rows
                .iter()
                .map(|row| percent(row.1.get(i).copied().flatten()));
            [name.clone()].into_iter().chain(shares).collect()
        })
        .collect();
    "## Overview: share of trials, over all values of each sweep\n\n".to_owned()
        + &grid(&header, &lines)
}

/// What matters most of each experiment, by the values of its sweep: the share of trials with exactly
/// the true edges, run time and memory.
#[must_use]
pub fn by_value(sheets: &[Sheet]) -> String {
    let mut text = String::new();
    for sheet in sheets {
        let matters = |panel: &&Panel| matches!(&*panel.metric, "exact" | "run_time" | "memory");
        for panel in sheet.panels.iter().filter(matters) {
            text += &format!("### {}, {}\n\n", sheet.experiment.name, panel.title());
            text += &panel_table(panel, &sheet.experiment.sweep);
        }
    }
    text
}

/// The values of a panel: a line per value of the sweep, a column per algorithm.
pub(crate) fn panel_cells(panel: &Panel, sweep: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let mut xs: Vec<f64> = panel
        .lines
        .iter()
        .flat_map(|line| line.answers.iter().map(|a| a.x))
        .collect();
    xs.sort_by(f64::total_cmp);
    xs.dedup_by(|a, b| a.to_bits() == b.to_bits());
    let share = panel.unit == "share";
    let cell = |line: &Answers, x: f64| {
        let answer = line.answers.iter().find(|a| a.x.to_bits() == x.to_bits());
        match answer {
            Some(answer) if share => percent(Some(answer.mean)),
            Some(answer) => three_digits(answer.mean),
            None => "–".to_owned(),
        }
    };
    let mut header = vec![sweep.to_owned()];
    header.extend(panel.lines.iter().map(|line| line.algorithm.clone()));
    let mut lines: Vec<Vec<String>> = xs
        .iter()
        .map(|&x| {
            let cells = panel.lines.iter().map(|line| cell(line, x));
            [six_digits(x)].into_iter().chain(cells).collect()
        })
        .collect();
    let closing = |name: &str, of: &dyn Fn(&Answers) -> Option<String>| {
        let cells = panel
            .lines
            .iter()
            .map(|line| of(line).unwrap_or("–".to_owned()));
        [name.to_owned()]
            .into_iter()
            .chain(cells)
            .collect::<Vec<String>>()
    };
    match panel.metric.as_str() {
        "exact" => lines.push(closing("always", &|line| {
            Some(match line.faultless()? {
                Faultless::UpTo(x) => format!("≤ {}", six_digits(x)),
                Faultless::From(x) => format!("≥ {}", six_digits(x)),
            })
        })),
        "run_time" => lines.push(closing("exponent of n", &|line| {
            Some(three_digits(line.slope()?))
        })),
        "memory" => lines.push(closing("bytes a point, at last", &|line| {
            let last = line.answers.last()?;
            Some(three_digits(last.mean * 1_048_576.0 / last.x))
        })),
        _ => {}
    }
    (header, lines)
}

fn panel_table(panel: &Panel, sweep: &str) -> String {
    let (header, lines) = panel_cells(panel, sweep);
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let unit = match panel.unit.as_str() {
        "share" => String::new(),
        "extents" => "In extents of the curve.\n\n".to_owned(),
        unit => format!("In {unit}.\n\n"),
    };
    unit + &grid(&header, &lines)
}

fn three_digits(value: f64) -> String {
    let rounded = format!("{value:.2e}").parse::<f64>().unwrap_or(value);
    six_digits(rounded)
}

/// The sheets as they are.
///
/// # Errors
/// If the JSON writer fails, which it does not in memory.
pub fn json(sheets: &[Sheet]) -> Result<String, RenderError> {
    #[derive(Serialize)]
    struct Document<'a> {
        experiments: &'a [Sheet],
    }
    let document = Document {
        experiments: sheets,
    };
    Ok(serde_json::to_string_pretty(&document)? + "\n")
}
