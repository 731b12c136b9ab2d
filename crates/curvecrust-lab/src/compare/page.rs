//! All of a comparison as one HTML file that needs no other.
//!
//! Every chart is there twice, wide and narrow, and the page shows the one that fits; colours follow
//! the reader's choice of light or dark.

use crate::compare::chart::{Paper, Width};
use crate::compare::heat_map::HeatMap;
use crate::compare::sheet::Sheet;
use crate::compare::style::{dark, escaped, light};
use crate::compare::tables::panel_cells;

const STYLE: &str = "\
:root { color-scheme: light dark; --paper: #fff; --ink: #1c2126; --faint: #59636e; --line: #e3e6ea; --link: #0b6fb3 }
@media (prefers-color-scheme: dark) { :root { --paper: #14181c; --ink: #e8ebee; --faint: #a4aeb8; --line: #2d343b; --link: #6cb8f0 } }
body { margin: 0 auto; padding: 1.2rem 1rem 4rem; max-width: 60rem; background: var(--paper); color: var(--ink); font: 16px/1.55 system-ui, 'DejaVu Sans', sans-serif }
h1 { font-size: 1.6rem; line-height: 1.25 } h2 { font-size: 1.25rem; margin: 2.6rem 0 .4rem; padding-top: .8rem; border-top: 1px solid var(--line) }
p { max-width: 44rem } a { color: var(--link) } .faint { color: var(--faint) }
figure { margin: 1.2rem 0 } figure svg { max-width: 100%; height: auto; display: block } .narrow { display: none }
.scroll { overflow-x: auto } .scroll svg { max-width: none } table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums }
th, td { padding: .25rem .7rem .25rem 0; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap } th:first-child, td:first-child { text-align: left }
details { margin: .4rem 0 1.4rem } summary { cursor: pointer; color: var(--link) } nav a { margin-right: 1rem; white-space: nowrap }
@media (max-width: 700px) { .wide { display: none } .narrow { display: block } body { padding: .6rem .7rem 3rem } }
";

/// The page; `facts` are shown at its end, such as version and machine.
#[must_use]
pub fn html(sheets: &[Sheet], algorithms: &[&str], facts: &[(String, String)]) -> String {
    let mut body = String::new();
    for (name, value) in facts {
        body += &format!("{}: {}<br>\n", escaped(name), escaped(value));
    }
    let body = format!("<p class=\"faint\">\n{body}</p>\n");
    let links = sheets.iter().map(|sheet| {
        let name = escaped(&sheet.experiment.name);
        format!("<a href=\"#{name}\">{name}</a>\n")
    });
    let links = format!("<nav>\n{}</nav>\n", links.collect::<String>());
    let map = HeatMap::new(sheets, algorithms);
    let map = if map.rows.is_empty() {
        String::new()
    } else {
        let [wide, narrow] = [Width::Wide, Width::Narrow].map(|w| map.to_svg(w, Paper::Page));
        format!(
            "<figure class=\"scroll\">\n<div class=\"wide\">\n{wide}</div>\n\
             <div class=\"narrow\">\n{narrow}</div>\n<figcaption class=\"faint\">The mean over the values of each sweep: \
             where an algorithm breaks is in the charts.</figcaption>\n</figure>\n"
        )
    };
    let sections: String = sheets.iter().map(section).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>curvecrust: reconstruction algorithms compared</title>\n<style>\n{STYLE}{}\
         @media (prefers-color-scheme: dark) {{\n{}}}\n</style>\n</head>\n<body>\n\
         <h1>Which algorithm for my points, and where does each one break?</h1>\n\
         <p>Points are sampled from known curves and given to each algorithm as bare points. \
         Bands are 95 % confidence intervals; of times and memory, from the least to the largest. \
         Lines over shares and distances are drawn a little apart, so that equal ones can be seen.</p>\n{links}{map}{sections}\
         <h2>Where these numbers come from</h2>\n{body}</body>\n</html>\n",
        light(),
        dark()
    )
}

fn section(sheet: &Sheet) -> String {
    let experiment = &sheet.experiment;
    let name = escaped(&experiment.name);
    let mut text = format!(
        "<h2 id=\"{name}\">{}</h2>\n<p>{}</p>\n",
        escaped(&experiment.title),
        escaped(experiment.question.trim())
    );
    for panel in &sheet.panels {
        let chart = panel.chart(&experiment.sweep);
        text += "<figure>\n";
        for (class, width) in [("wide", Width::Wide), ("narrow", Width::Narrow)] {
            let svg = chart.to_svg(width, Paper::Page);
            text += &format!("<div class=\"{class}\">\n{svg}</div>\n");
        }
        text += "</figure>\n";
        let (header, lines) = panel_cells(panel, &experiment.sweep);
        let row = |cells: &[String], tag: &str| {
            let cells = cells
                .iter()
                .map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell)));
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        let lines: String = lines.iter().map(|line| row(line, "td")).collect();
        text += &format!(
            "<details><summary>the numbers</summary>\n<div class=\"scroll\"><table>\n{}{lines}</table></div></details>\n",
            row(&header, "th")
        );
    }
    text
}
