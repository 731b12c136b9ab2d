//! The run that is committed, in `docs/results/compare`: means and times, where they come from, and
//! the tables, plots and page made of them, which `cargo xtask docs --check` holds to these.

use super::experiment;
use super::records;
use super::write;
use crate::compare::cells::Cells;
use crate::compare::rows::Timing;
use crate::repository::output_of;
use crate::repository::root;
use crate::repository::write_atomically;
use anyhow::Context;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// Where it is, below the root.
pub const FOLDER: &str = "docs/results/compare";
/// What is made of the rest; the page holds all plots.
const MADE: [&str; 3] = ["tables.md", "index.html", "plots/overview.svg"];

/// Runs, the latest of each experiment.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(super) struct Runs {
    pub(super) run: Vec<Run>,
}

/// Where results come from.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(super) struct Run {
    pub(super) experiments: Vec<String>,
    pub(super) version: String,
    /// The commit of the working tree, marked if there were changes.
    pub(super) commit: String,
    pub(super) machine: String,
    pub(super) threads: usize,
    pub(super) rust: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) seconds: Option<f64>,
}

impl Run {
    /// Of this program, here and now.
    pub(super) fn here(experiments: Vec<String>, threads: usize, seconds: Option<f64>) -> Self {
        let commit = output_of("git", &["rev-parse", "--short=12", "HEAD"]);
        // What an earlier run published is no change of the program.
        let results = format!(":(exclude){FOLDER}");
        let status = [
            "status",
            "--porcelain",
            "--untracked-files=no",
            "--",
            ".",
            &results,
        ];
        let changed = output_of("git", &status).is_some();
        let commit = commit.map(|c| {
            if changed {
                format!("{c}, with changes")
            } else {
                c
            }
        });
        let unknown = || "unknown".to_owned();
        Self {
            experiments,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: commit.unwrap_or_else(unknown),
            machine: processor().unwrap_or_else(unknown),
            threads,
            rust: output_of("rustc", &["--version"]).unwrap_or_else(unknown),
            seconds,
        }
    }

    /// For the page.
    pub(super) fn facts(&self) -> (String, String) {
        let Self {
            version,
            commit,
            machine,
            threads,
            rust,
            seconds,
            ..
        } = self;
        let took = match seconds {
            Some(seconds) => format!("{seconds} s"),
            None => "resumed".to_owned(),
        };
        (
            self.experiments.join(", "),
            format!(
                "version {version}, commit {commit}; {machine}, {threads} threads, {rust}; {took}"
            ),
        )
    }
}

fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("model name"))?;
    let name = line.trim_start_matches([' ', '\t', ':']).trim();
    let count = text
        .lines()
        .filter(|line| line.starts_with("processor"))
        .count();
    Some(format!("{name}, {count} processors"))
}

/// Puts a run among the published ones, in the place of earlier ones of its experiments.
pub(super) fn publish(run: Run, cells: &Cells, times: &[Timing]) -> anyhow::Result<()> {
    let folder = root().join(FOLDER);
    fs::create_dir_all(folder.join("plots")).with_context(|| format!("cannot make {FOLDER}"))?;
    let (mut runs, mut all_cells, mut all_times) = read(&folder).unwrap_or_default();
    let is_new = |experiment: &String| run.experiments.contains(experiment);
    all_cells.retain(|cell| !is_new(&cell.experiment));
    all_cells.extend(cells);
    all_times.retain(|timing| !is_new(&timing.experiment));
    // Times of a reconstruction of a few hundred points are no result; those of `scale` are.
    all_times.extend(
        times
            .iter()
            .filter(|timing| timing.memory.is_some())
            .cloned(),
    );
    for earlier in &mut runs.run {
        earlier.experiments.retain(|experiment| !is_new(experiment));
    }
    runs.run.retain(|run| !run.experiments.is_empty());
    runs.run.push(run);
    write_atomically(&folder.join("run.toml"), toml::to_string(&runs)?)?;
    write_atomically(&folder.join("cells.csv"), all_cells.table().to_csv()?)?;
    let times = records::table(&all_times).to_csv()?;
    write_atomically(&folder.join("times.csv"), times)?;
    for (name, text) in made()? {
        write_atomically(&root().join(name), text)?;
    }
    Ok(())
}

fn read(folder: &Path) -> anyhow::Result<(Runs, Cells, Vec<Timing>)> {
    let text = |name: &str| {
        let path = folder.join(name);
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))
    };
    Ok((
        toml::from_str(&text("run.toml")?)?,
        Cells::read(&text("cells.csv")?)?,
        records::read(&text("times.csv")?)?,
    ))
}

/// The files that are made of the published means and times, and what they should hold; none if
/// nothing is published.
///
/// # Errors
/// If what is published cannot be read.
pub fn made() -> anyhow::Result<Vec<(String, String)>> {
    let folder = root().join(FOLDER);
    if !folder.join("run.toml").exists() {
        return Ok(Vec::new());
    }
    let (runs, cells, times) = read(&folder)?;
    let facts: Vec<_> = runs.run.iter().map(Run::facts).collect();
    let answered = write::answered(&experiment::all()?, &cells, &times);
    let texts = write::texts(&answered, &facts)?;
    let made = texts
        .into_iter()
        .filter(|(name, _)| MADE.contains(&name.as_str()));
    Ok(made
        .map(|(name, text)| (format!("{FOLDER}/{name}"), text))
        .collect())
}
