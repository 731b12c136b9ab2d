//! `cargo xtask reproduce-paper --figures`: Figures 1, 3, 4, 8, 9, 10 and 11 of the paper, and a
//! page with them and the tables.

mod bare;
mod covering;
mod rolling;
mod sampled;
#[cfg(test)]
mod tests;

use super::models::Model;
use super::page::{self, Exhibit};
use super::rows::PaperReport;
use crate::png;
use crate::repository::write_atomically;
use curvecrust::geometry::{EdgeSet, PointSet, Segment};
use std::path::Path;

pub(crate) use bare::{PointSets, figure_3, marked};
pub(crate) use sampled::{bunny, figure_1};

/// Every figure, in the paper's order.
fn all(models: &[Model], points: &PointSets) -> anyhow::Result<Vec<Exhibit>> {
    Ok(vec![
        figure_1(models)?,
        figure_3(points),
        bare::figure_4(points),
        covering::figure_8(),
        sampled::figure_9(models)?,
        sampled::figure_10(models)?,
        bare::figure_11(points),
    ])
}

/// Draws all into `folder`, as SVG and PNG, and the page.
pub(super) fn write(report: &PaperReport, models: &[Model], folder: &Path) -> anyhow::Result<()> {
    let figures = all(models, &PointSets::load()?)?;
    let rasteriser = png::Rasteriser::new();
    for exhibit in &figures {
        let svg = exhibit.figure.to_svg();
        let name = format!("figure-{}", exhibit.number);
        write_atomically(&folder.join(format!("{name}.png")), rasteriser.png(&svg)?)?;
        write_atomically(&folder.join(format!("{name}.svg")), svg)?;
    }
    write_atomically(&folder.join("report.html"), page::page(report, &figures))
}

/// Where the edges run.
fn edges(points: &PointSet, edges: &EdgeSet) -> Vec<Segment> {
    let ends = edges.edges().iter();
    ends.map(|edge| Segment::new(points[edge.a()], points[edge.b()]))
        .collect()
}
