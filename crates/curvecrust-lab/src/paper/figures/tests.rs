//! The figures against the tables, and the page.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::sampled::{LIMIT_PERCENT, SETTING};
use super::*;
use crate::paper::rows::Counts;
use crate::paper::{measure, models};

fn redrawn() -> Vec<Exhibit> {
    all(&models::redrawn().unwrap(), &PointSets::redrawn().unwrap()).unwrap()
}

fn captions(figures: &[Exhibit], number: u8) -> Vec<&str> {
    let exhibit = figures
        .iter()
        .find(|exhibit| exhibit.number == number)
        .unwrap();
    let panels = exhibit.figure.panels.iter();
    panels.map(|panel| panel.caption.as_str()).collect()
}

#[test]
fn counts_in_captions_are_those_of_the_tables() {
    let models = models::redrawn().unwrap();
    let report = measure::tables_2_and_3(&models, &[SETTING], [true, true]).unwrap();
    let figures = redrawn();
    let counts = |name: &str| -> Counts {
        report
            .table2
            .iter()
            .find(|row| row.model == name)
            .unwrap()
            .sampled
            .counts
    };
    let both = |c: Counts| {
        [
            format!("ε < 1/3: {} samples", c.epsilon_third),
            format!("ρ < 0.9: {} samples", c.rho),
        ]
    };

    let [third, rho] = both(counts("teaser"));
    let middle = format!("ε < 0.47: {} samples", counts("teaser").epsilon);
    assert_eq!(captions(&figures, 1), [third, middle, rho]);
    let nine = ["parallel", "bunny", "cat"]
        .map(|name| both(counts(name)))
        .concat();
    assert_eq!(captions(&figures, 9), nine);
    let limited = report
        .table3
        .iter()
        .find(|row| row.limit_percent == Some(LIMIT_PERCENT));
    let ten =
        both(limited.unwrap().sampled.counts).map(|caption| caption.replace(':', " within 1 %:"));
    assert_eq!(captions(&figures, 10), ten);
}

#[test]
fn bare_points_show_what_the_paper_says() {
    let figures = redrawn();
    let three = captions(&figures, 3);
    let none = "leaves 0, isolated 0, junctions 0";
    assert_eq!(three[1], format!("HNN-Crust: 20 edges\n{none}"));
    assert!(!three[0].ends_with(none), "{three:?}");
    // Four arcs have eight ends.
    let four = captions(&figures, 4);
    assert!(
        four[2].ends_with("leaves 8, isolated 0, junctions 0"),
        "{four:?}"
    );
    assert!(four[1].ends_with("junctions 2"), "{four:?}");
    assert!(!captions(&figures, 11)[1].ends_with(none));
    // The ninth is not in the paper: it is not covered.
    assert_eq!(captions(&figures, 8).len(), 9);
}

#[test]
fn figures_are_the_same_every_time() {
    let (once, again) = (redrawn(), redrawn());
    let rasteriser = png::Rasteriser::new();
    for (a, b) in once.iter().zip(&again) {
        let (a, b) = (a.figure.to_svg(), b.figure.to_svg());
        assert!(a == b);
        assert!(rasteriser.png(&a).unwrap() == rasteriser.png(&b).unwrap());
    }
}

#[test]
fn captions_are_drawn_without_a_font_of_the_machine() {
    let rasteriser = png::Rasteriser::new();
    let svg = |word: &str| {
        let svg = redrawn()[1].figure.to_svg();
        svg.replace("Crust", word)
    };
    assert!(rasteriser.png(&svg("Crust")).unwrap() != rasteriser.png(&svg("")).unwrap());
}

#[test]
fn the_page_is_whole_and_refers_to_nothing_outside() {
    let models = models::redrawn().unwrap();
    let report = PaperReport {
        table1: measure::table_1(),
        ..measure::tables_2_and_3(&models, &[SETTING], [true, true]).unwrap()
    };
    let page = page::page(&report, &redrawn());
    for number in [1, 3, 4, 8, 9, 10, 11] {
        assert_eq!(page.matches(&format!("id=\"figure-{number}\"")).count(), 1);
    }
    for table in ["Table 1", "Table 2", "Table 3"] {
        assert!(page.contains(&format!("<h2>{table}")), "{table}");
    }
    let page = page.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for outside in [
        "http:", "https:", "src=", "href", "url(", "@import", "<script", "<link",
    ] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());
}
