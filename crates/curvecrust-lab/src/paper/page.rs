//! The report as one HTML page: figures and tables side by side, nothing fetched from elsewhere.
//!
//! Panels wrap on narrow windows instead of shrinking, captions are text of the page, and colours
//! follow the reader's light or dark scheme.

use std::fmt::Write;

use crate::figure::{Figure, STYLE};
use crate::paper::render;
use crate::paper::rows::PaperReport;

/// A figure of the paper, as drawn here.
#[derive(Clone, Debug, PartialEq)]
pub struct Exhibit {
    /// Its number in the paper.
    pub number: u8,
    /// What it is about, in a few words.
    pub heading: String,
    /// What is to be seen, in a few sentences.
    pub text: String,
    /// The drawing.
    pub figure: Figure,
}

const PAGE_STYLE: &str = "\
:root { color-scheme: light dark; --ink: #1c1c1c; --soft: #555; --line: #d5d5d5; --paper: #fff; --card: #fafafa } \
@media (prefers-color-scheme: dark) { \
:root { --ink: #e8e8e8; --soft: #aab0b8; --line: #363b42; --paper: #15181c; --card: #1b1f24 } } \
* { box-sizing: border-box } \
body { margin: 0 auto; padding: 1rem; max-width: 120rem; background: var(--paper); color: var(--ink); \
font: 1rem/1.5 system-ui, 'Noto Sans', 'DejaVu Sans', sans-serif } \
h1 { font-size: 1.6rem; line-height: 1.25 } h2 { font-size: 1.15rem; margin: 0 0 .4rem } \
p { max-width: 48rem; margin: .4rem 0 } \
main { display: grid; gap: 1.5rem; grid-template-columns: minmax(0, 1fr) } \
@media (min-width: 84rem) { main { grid-template-columns: minmax(0, 1fr) minmax(0, 1fr) } \
.tables { position: sticky; top: 1rem; align-self: start; max-height: calc(100vh - 2rem); overflow-y: auto } } \
section { border: 1px solid var(--line); border-radius: .5rem; background: var(--card); \
padding: 1rem; margin: 0 0 1.5rem } \
.panels { display: grid; gap: .5rem; grid-template-columns: \
repeat(auto-fit, minmax(min(100%, max(15rem, 100% / (var(--columns) + 1))), 1fr)) } \
figure { margin: 0; text-align: center; align-self: start } \
figure svg { width: 100%; max-width: 26rem; height: auto } \
figcaption { font-size: .88rem; white-space: pre-line } \
.marks { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; padding: 0; \
margin: .8rem 0 0; color: var(--soft); font-size: .9rem } \
.marks li { display: flex; align-items: center; gap: .4rem } .marks svg { flex: none } \
.wide { overflow-x: auto } \
table { border-collapse: collapse; font-size: .8rem; font-variant-numeric: tabular-nums } \
th, td { padding: .25rem .4rem; border-bottom: 1px solid var(--line); text-align: left; white-space: nowrap } \
td:last-child { white-space: normal } \
th { color: var(--soft); font-weight: 600; white-space: normal; vertical-align: bottom }";

/// The whole report: the tables of [`render::markdown`] and the figures.
#[must_use]
pub fn page(report: &PaperReport, figures: &[Exhibit]) -> String {
    let figures: String = figures.iter().map(exhibit).collect();
    let tables = tables(&render::markdown(report));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Curve Reconstruction with Many Fewer Samples, reproduced</title>\n\
         <style>{PAGE_STYLE}\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>Curve Reconstruction with Many Fewer Samples, reproduced</h1>\n\
         <p>Figures and tables of the paper by S. Ohrhallinger, S. A. Mitchell and M. Wimmer (SGP 2016), \
         drawn and measured by <code>cargo xtask reproduce-paper --figures</code>. Counts in the captions \
         are those of the tables in the paper's own setting: shrinking-ball lfs, 300 points a segment.</p>\n\
         <main>\n<div>\n{figures}</div>\n<div class=\"tables\">\n{tables}</div>\n</main>\n</body>\n</html>\n"
    )
}

fn exhibit(exhibit: &Exhibit) -> String {
    let mut text = format!(
        "<section id=\"figure-{n}\">\n<h2>Figure {n}: {}</h2>\n<p>{}</p>\n<div class=\"panels\" \
         style=\"--columns: {}\">\n",
        escaped(&exhibit.heading),
        escaped(&exhibit.text),
        exhibit.figure.columns,
        n = exhibit.number,
    );
    let figure = &exhibit.figure;
    for (drawing, panel) in figure.drawings().iter().zip(&figure.panels) {
        let caption = escaped(&panel.caption);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "<figure>{drawing}<figcaption>{caption}</figcaption></figure>"
        );
    }
    text += "</div>\n<ul class=\"marks\">\n";
    for (mark, name) in figure.legend() {
        let _ = writeln!(text, "<li>{mark}{}</li>", escaped(name));
    }
    text + "</ul>\n</section>\n"
}

/// The Markdown of [`render::markdown`] as HTML: headings, paragraphs and tables.
fn tables(markdown: &str) -> String {
    let mut text = String::new();
    for block in markdown
        .split("\n\n")
        .map(str::trim)
        .filter(|b| !b.is_empty())
    {
        if let Some(heading) = block.strip_prefix("## ") {
            if !text.is_empty() {
                text += "</section>\n";
            }
            let _ = writeln!(text, "<section>\n<h2>{}</h2>", escaped(heading));
        } else if block.starts_with('|') {
            text += &table(block);
        } else {
            let _ = writeln!(text, "<p>{}</p>", escaped(block));
        }
    }
    if text.is_empty() {
        text
    } else {
        text + "</section>\n"
    }
}

/// A sign between two words, in one line with them.
const UNBROKEN: &str = "\u{a0}&lt;\u{a0}";

fn table(block: &str) -> String {
    let mut text = "<div class=\"wide\"><table>\n".to_owned();
    for (i, line) in block
        .lines()
        .filter(|line| line.starts_with('|'))
        .enumerate()
    {
        if i == 1 {
            continue; // The rule below the header.
        }
        let tag = if i == 0 { "th" } else { "td" };
        let cells = line.trim_matches('|').split('|').map(str::trim);
        let cells: String = cells
            .map(|cell| {
                format!(
                    "<{tag}>{}</{tag}>",
                    escaped(cell).replace(" &lt; ", UNBROKEN)
                )
            })
            .collect();
        let _ = writeln!(text, "<tr>{cells}</tr>");
    }
    text += "</table></div>\n";
    // What follows a table directly is a note on it.
    for line in block.lines().filter(|line| !line.starts_with('|')) {
        let _ = writeln!(text, "<p>{}</p>", escaped(line));
    }
    text
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markdown_becomes_headings_paragraphs_and_tables() {
        let html = tables("## A < B\n\nwords\n\n| x | y |\n| - | - |\n| 1 | 2 |\n\n");
        assert_eq!(
            html,
            "<section>\n<h2>A &lt; B</h2>\n<p>words</p>\n<div class=\"wide\"><table>\n\
             <tr><th>x</th><th>y</th></tr>\n<tr><td>1</td><td>2</td></tr>\n</table></div>\n</section>\n"
        );
        assert_eq!(tables(""), "");
    }
}
