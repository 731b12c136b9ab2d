//! The report as one HTML page: figures and tables side by side, nothing fetched from elsewhere.
//!
//! Panels wrap on narrow windows instead of shrinking, captions are text of the page, and colours
//! follow the reader's light or dark scheme.

use crate::figure::Figure;
use crate::paper::rows::PaperReport;
use crate::paper::tables;
use crate::table::BREAK;
use maud::{Markup, PreEscaped, Render, html};

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

/// The whole report: the figures and the [`sections`](tables::sections) of tables.
#[must_use]
pub fn page(report: &PaperReport, figures: &[Exhibit]) -> String {
    let title = "Curve Reconstruction with Many Fewer Samples, reproduced";
    let body = html! {
        h1 { (title) } (BREAK)
        p {
            "Figures and tables of the paper by S. Ohrhallinger, S. A. Mitchell and M. Wimmer \
             (SGP 2016), drawn and measured by \
             " code { "cargo xtask reproduce-paper --figures" } ". Counts in the captions are \
             those of the tables in the setting of the authors' program: shrinking-ball lfs, 300 \
             points a segment."
        } (BREAK)
        main { (BREAK)
            div { (BREAK) @for exhibit in figures { (exhibit) } } (BREAK)
            div.tables { (BREAK) @for section in tables::sections(report) { (section) } } (BREAK)
        } (BREAK)
    };
    crate::page::page(title, "report", &body)
}

impl Render for Exhibit {
    fn render(&self) -> Markup {
        let figure = &self.figure;
        let drawings = figure.drawings();
        html! {
            section id={ "figure-" (self.number) } { (BREAK)
                h2 { "Figure " (self.number) ": " (self.heading) } (BREAK)
                p { (self.text) } (BREAK)
                div.panels style={ "--columns: " (figure.columns) } { (BREAK)
                    @for (drawing, panel) in drawings.iter().zip(&figure.panels) {
                        figure { (PreEscaped(drawing)) figcaption { (panel.caption) } } (BREAK)
                    }
                } (BREAK)
                ul.marks.faint { (BREAK)
                    @for (mark, name) in figure.legend() {
                        li { (PreEscaped(mark)) (name) } (BREAK)
                    }
                } (BREAK)
            } (BREAK)
        }
    }
}
