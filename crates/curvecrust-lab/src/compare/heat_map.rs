//! Algorithms against experiments: the share of trials with exactly the true edges.

use crate::compare::chart::Width;
use crate::compare::results::{ExperimentResults, Panel};
use crate::drawing::{Within, document, rectangle, text, text_width};
use crate::table::percent;
use curvecrust::DVec2;
use svg::Node;

/// A table of shares, as plots and tables show it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeatMap {
    /// Experiment and group of inputs.
    pub columns: Vec<String>,
    /// Algorithm, and its shares; `None` where it was not run.
    pub rows: Vec<(String, Vec<Option<f64>>)>,
}

impl HeatMap {
    /// The mean over all values of each sweep.
    #[must_use]
    pub fn new(results: &[ExperimentResults], algorithms: &[&str]) -> Self {
        let panels: Vec<(&ExperimentResults, &Panel)> = results
            .iter()
            .flat_map(|result| result.panels.iter().map(move |panel| (result, panel)))
            .filter(|(_, panel)| panel.metric == "exact")
            .collect();
        let column = |&(result, panel): &(&ExperimentResults, &Panel)| {
            let groups = panels
                .iter()
                .filter(|p| p.0.experiment.name == result.experiment.name);
            if groups.count() > 1 {
                format!("{}: {}", result.experiment.name, panel.group)
            } else {
                result.experiment.name.clone()
            }
        };
        let share = |panel: &Panel, algorithm: &str| {
            let line = panel
                .lines
                .iter()
                .find(|line| line.algorithm == algorithm)?;
            let sum: f64 = line.answers.iter().map(|a| a.mean).sum();
            Some(sum / line.answers.len() as f64)
        };
        let rows = algorithms.iter().map(|&algorithm| {
            let shares = panels.iter().map(|(_, panel)| share(panel, algorithm));
            (algorithm.to_owned(), shares.collect::<Vec<_>>())
        });
        Self {
            columns: panels.iter().map(column).collect(),
            rows: rows
                .filter(|row| row.1.iter().any(Option::is_some))
                .collect(),
        }
    }

    /// The table as SVG, one line per experiment: it stays narrow however many there are.
    #[must_use]
    pub fn to_svg(&self, width: Width, within: Within) -> String {
        let widest = |names: &mut dyn Iterator<Item = &String>| {
            names.map(|name| text_width(name)).fold(0.0, f64::max)
        };
        let slanted = widest(&mut self.rows.iter().map(|row| &row.0)) * 0.72;
        // On a telephone, names stand above their cells.
        let (left, wide, name_line) = match width {
            Width::Wide => (widest(&mut self.columns.iter()) + 24.0, 58.0, 0.0),
            Width::Narrow => (12.0, 35.0, 22.0),
        };
        let (cell, high) = (30.0, 30.0 + name_line);
        let top = 40.0 + slanted + 14.0;
        let height = top + high * self.columns.len() as f64 + 14.0;
        // There, the title says once what the cells have no room for.
        let title = match width {
            Width::Wide => "Exactly the true edges, share of trials",
            Width::Narrow => "Exactly the true edges, % of trials",
        };
        let cells = left + wide * self.rows.len() as f64 + slanted.max(20.0);
        let all = cells.max(24.0 + 1.25 * text_width(title));
        let written = |share: Option<f64>| {
            let share = share.map_or("–".to_owned(), percent);
            match width {
                Width::Wide => share,
                Width::Narrow => share.replace(" %", ""),
            }
        };
        let size = DVec2::new(all.ceil(), height.ceil());
        let mut svg = document(title, size, within).set("class", "plot");
        svg.append(text("head", DVec2::new(12.0, 22.0), title));
        for (i, (algorithm, shares)) in self.rows.iter().enumerate() {
            let x = left + wide * i as f64;
            let (tx, ty) = ((x + wide / 2.0 - 4.0).round(), (top - 8.0).round());
            let turned = format!("translate({tx} {ty}) rotate(-45)");
            let name = text("name", DVec2::ZERO, algorithm);
            svg.append(name.set("transform", turned));
            for (j, &share) in shares.iter().enumerate() {
                let corner = DVec2::new(x, top + high * j as f64 + name_line);
                let middle = corner + DVec2::new(wide, cell) / 2.0;
                let square = DVec2::new(wide - 2.0, cell - 2.0);
                let square = rectangle("band fill1", (corner + 1.0).round(), square);
                let opacity = 0.04 + 0.5 * share.unwrap_or(0.0);
                svg.append(square.set("style", format!("fill-opacity:{opacity:.2}")));
                let at = (middle + DVec2::new(0.0, 4.5)).round();
                svg.append(text("value", at, &written(share)).set("text-anchor", "middle"));
            }
        }
        for (j, name) in self.columns.iter().enumerate() {
            let line = match width {
                Width::Wide => cell / 2.0 + 4.5,
                Width::Narrow => name_line - 5.0,
            };
            let y = (top + high * j as f64 + line).round();
            svg.append(text("name", DVec2::new(12.0, y), name));
        }
        svg.to_string() + "\n"
    }
}
