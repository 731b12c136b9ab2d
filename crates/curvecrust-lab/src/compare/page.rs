//! All of a comparison as one HTML file that needs no other.
//!
//! Every chart is there twice, wide and narrow, and the page shows the one that fits; colours
//! follow the reader's choice of light or dark.

use crate::compare::chart::Width;
use crate::compare::heat_map::HeatMap;
use crate::compare::results::{ExperimentResults, Panel};
use crate::compare::tables;
use crate::drawing::Within;
use crate::table::BREAK;
use maud::{Markup, PreEscaped, html};

/// The page; `facts` are shown at its end, such as version and machine.
#[must_use]
pub fn html(
    results: &[ExperimentResults],
    algorithms: &[&str],
    facts: &[(String, String)],
) -> String {
    let map = HeatMap::new(results, algorithms);
    let body = html! {
        h1 { "Which algorithm for my points, and where does each one break?" } (BREAK)
        p {
            "Points are sampled from known curves and given to each algorithm as bare points. \
             Bands are 95 % confidence intervals; of times and memory, from the least to the \
             largest. Lines over shares and distances are drawn a little apart, so that equal \
             ones can be seen."
        } (BREAK)
        nav { (BREAK)
            @for ExperimentResults { experiment, .. } in results {
                a href={ "#" (experiment.name) } { (experiment.name) } (BREAK)
            }
        } (BREAK)
        @if !map.rows.is_empty() {
            figure.scroll { (BREAK)
                (both(|width| map.to_svg(width, Within::Page)))
                figcaption {
                    "The mean over the values of each sweep: where an algorithm breaks is in the \
                    charts."
                } (BREAK)
            } (BREAK)
        }
        @for ExperimentResults { experiment, panels } in results {
            h2 id=(experiment.name) { (experiment.title) } (BREAK)
            p { (experiment.question.trim()) } (BREAK)
            @for panel in panels { (charted(panel, &experiment.sweep)) }
        }
        h2 { "Where these numbers come from" } (BREAK)
        p.faint { (BREAK)
            @for (name, value) in facts { (name) ": " (value) br; (BREAK) }
        } (BREAK)
    };
    crate::page::page(
        "curvecrust: reconstruction algorithms compared",
        "comparison",
        &body,
    )
}

/// A plot for wide and for narrow windows.
fn both(plot: impl Fn(Width) -> String) -> Markup {
    html! {
        @for (class, width) in [("wide", Width::Wide), ("narrow", Width::Narrow)] {
            div class=(class) { (BREAK) (PreEscaped(plot(width))) (BREAK) } (BREAK)
        }
    }
}

/// A panel as a chart, and its numbers.
fn charted(panel: &Panel, sweep: &str) -> Markup {
    let chart = panel.chart(sweep);
    html! {
        figure { (BREAK) (both(|width| chart.to_svg(width, Within::Page))) } (BREAK)
        details { (BREAK)
            summary { "the numbers" } (BREAK)
            (tables::values(panel, sweep))
        } (BREAK)
    }
}
