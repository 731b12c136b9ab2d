//! From the rows to everything people read: a pure function, and the files it goes to.

use super::algorithms;
use super::experiment::Experiment;
use crate::compare::cells::Cells;
use crate::compare::chart::Width;
use crate::compare::heat_map::HeatMap;
use crate::compare::results::ExperimentResults;
use crate::compare::rows::Timing;
use crate::compare::{page, tables};
use crate::drawing::Within;
use crate::png::Rasteriser;
use crate::repository::write_atomically;
use anyhow::Context;
use rayon::prelude::*;
use std::fs;
use std::path::Path;

/// What experiments answered, and the algorithms that took part in the order of their list.
pub(super) struct Answered {
    pub(super) results: Vec<ExperimentResults>,
    pub(super) algorithms: Vec<&'static str>,
}

/// The answers in cells and times.
pub(super) fn answered(experiments: &[Experiment], cells: &Cells, times: &[Timing]) -> Answered {
    // Those that took part: a chart has fewer looks of lines than there are algorithms.
    let mut algorithms = algorithms::names();
    algorithms.retain(|name| {
        cells.all().iter().any(|cell| cell.algorithm == *name)
            || times.iter().any(|timing| timing.algorithm == *name)
    });
    let results: Vec<ExperimentResults> = experiments
        .iter()
        .map(|experiment| ExperimentResults::new(experiment.described(), cells, times, &algorithms))
        .filter(|result| !result.panels.is_empty())
        .collect();
    Answered {
        results,
        algorithms,
    }
}

/// The texts made of answers: their names, and what is in them.
pub(super) fn texts(
    Answered {
        results,
        algorithms,
    }: &Answered,
    facts: &[(String, String)],
) -> anyhow::Result<Vec<(String, String)>> {
    let mut texts = vec![
        (
            "tables.md".to_owned(),
            tables::markdown(results, algorithms),
        ),
        ("tables.json".to_owned(), tables::json(results)?),
        (
            "index.html".to_owned(),
            page::html(results, algorithms, facts),
        ),
    ];
    let map = HeatMap::new(results, algorithms);
    if !map.rows.is_empty() {
        texts.push((
            "plots/overview.svg".to_owned(),
            map.to_svg(Width::Wide, Within::File),
        ));
    }
    for result in results {
        let groups: Vec<&str> = result
            .panels
            .iter()
            .map(|panel| panel.group.as_str())
            .collect();
        let one_group = groups.iter().all(|group| Some(group) == groups.first());
        for panel in &result.panels {
            let group = if one_group {
                String::new()
            } else {
                format!(
                    "-{}",
                    panel.group.replace([' ', ','], "-").replace("--", "-")
                )
            };
            let name = format!(
                "plots/{}{group}-{}.svg",
                result.experiment.name, panel.metric
            );
            let chart = panel.chart(&result.experiment.sweep);
            texts.push((name, chart.to_svg(Width::Wide, Within::File)));
        }
    }
    Ok(texts)
}

/// Writes the texts, and each plot as PNG too.
pub(super) fn write(folder: &Path, texts: &[(String, String)]) -> anyhow::Result<()> {
    let plots = folder.join("plots");
    if plots.is_dir() {
        fs::remove_dir_all(&plots).context("cannot remove the plots of an earlier run")?;
    }
    fs::create_dir_all(&plots).with_context(|| format!("cannot make {}", plots.display()))?;
    for (name, text) in texts {
        write_atomically(&folder.join(name), text)?;
    }
    let rasteriser = Rasteriser::new();
    let plots = texts.par_iter().filter(|(name, _)| name.ends_with(".svg"));
    plots.try_for_each(|(name, text)| {
        let picture = rasteriser.png(text).with_context(|| name.clone())?;
        write_atomically(&folder.join(name).with_extension("png"), picture)
    })
}
