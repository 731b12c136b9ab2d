//! Tables of the answers, and everything as JSON.

use serde::Serialize;

use crate::compare::heat_map::HeatMap;
use crate::compare::results::{Answers, ExperimentResults, Faultless, Panel};
use crate::table::{Field, Section, Table, rounded};

/// All tables: the overview, then every panel of every experiment.
#[must_use]
pub fn markdown(results: &[ExperimentResults], algorithms: &[&str]) -> String {
    let mut text = overview(results, algorithms);
    for result in results {
        let experiment = &result.experiment;
        text += &format!(
            "## {}: {}\n\n{}\n\n",
            experiment.name,
            experiment.title,
            experiment.question.trim()
        );
        for panel in &result.panels {
            text += &section(panel.title(), panel, &experiment.sweep).to_markdown(3);
        }
    }
    text
}

/// The share of trials with exactly the true edges, by experiment and algorithm.
#[must_use]
pub fn overview(results: &[ExperimentResults], algorithms: &[&str]) -> String {
    let map = HeatMap::new(results, algorithms);
    if map.rows.is_empty() {
        return String::new();
    }
    let names = map.rows.iter().map(|row| row.0.as_str());
    let mut table = Table::new(["exactly the true edges"].into_iter().chain(names));
    for (i, name) in map.columns.iter().enumerate() {
        let shares = map.rows.iter().map(|row| row.1.get(i).copied().flatten());
        let shares = shares.map(|share| share.map_or(Field::Missing, Field::Share));
        let row = [name.as_str().into()].into_iter().chain(shares);
        table.rows.push(row.collect());
    }
    let section = Section {
        title: "Overview: share of trials, over all values of each sweep".to_owned(),
        about: String::new(),
        table,
        note: String::new(),
    };
    section.to_markdown(2)
}

/// What matters most of each experiment, by the values of its sweep: the share of trials with
/// exactly the true edges, run time and memory.
#[must_use]
pub fn by_value(results: &[ExperimentResults]) -> String {
    let mut text = String::new();
    for result in results {
        let matters = |panel: &&Panel| matches!(&*panel.metric, "exact" | "run_time" | "memory");
        for panel in result.panels.iter().filter(matters) {
            let title = format!("{}, {}", result.experiment.name, panel.title());
            text += &section(title, panel, &result.experiment.sweep).to_markdown(3);
        }
    }
    text
}

fn section(title: String, panel: &Panel, sweep: &str) -> Section {
    let about = match panel.unit.as_str() {
        "share" => String::new(),
        "extents" => "In extents of the curve.".to_owned(),
        unit => format!("In {unit}."),
    };
    Section {
        title,
        about,
        table: values(panel, sweep),
        note: String::new(),
    }
}

/// The values of a panel: a row per value of the sweep, a column per algorithm.
#[must_use]
pub fn values(panel: &Panel, sweep: &str) -> Table {
    let answers = panel.lines.iter().flat_map(|line| &line.answers);
    let mut xs: Vec<f64> = answers.map(|answer| answer.x).collect();
    xs.sort_by(f64::total_cmp);
    xs.dedup_by(|a, b| a.to_bits() == b.to_bits());

    let names = panel.lines.iter().map(|line| line.algorithm.as_str());
    let mut table = Table::new([sweep].into_iter().chain(names));
    let mut push = |name: Field, of: &dyn Fn(&Answers) -> Option<Field>| {
        let fields = panel.lines.iter();
        let fields = fields.map(|line| of(line).unwrap_or(Field::Missing));
        table.rows.push([name].into_iter().chain(fields).collect());
    };
    let share = panel.unit == "share";
    for x in xs {
        push(Field::rounded(x, 6), &|line| {
            let mut answers = line.answers.iter();
            let mean = answers.find(|a| a.x.to_bits() == x.to_bits())?.mean;
            Some(if share {
                Field::Share(mean)
            } else {
                Field::rounded(mean, 3)
            })
        });
    }
    match panel.metric.as_str() {
        "exact" => push("always".into(), &|line| {
            Some(Field::Written(match line.faultless()? {
                Faultless::UpTo(x) => format!("≤ {}", rounded(x, 6)),
                Faultless::From(x) => format!("≥ {}", rounded(x, 6)),
            }))
        }),
        "run_time" => push("exponent of n".into(), &|line| {
            Some(Field::rounded(line.slope()?, 3))
        }),
        "memory" => push("bytes a point, at last".into(), &|line| {
            let last = line.answers.last()?;
            Some(Field::rounded(last.mean * 1_048_576.0 / last.x, 3))
        }),
        _ => {}
    }
    table
}

/// The results as they are.
///
/// # Errors
/// If the JSON writer fails, which it does not in memory.
pub fn json(results: &[ExperimentResults]) -> serde_json::Result<String> {
    #[derive(Serialize)]
    struct Document<'a> {
        experiments: &'a [ExperimentResults],
    }
    let document = Document {
        experiments: results,
    };
    Ok(serde_json::to_string_pretty(&document)? + "\n")
}
