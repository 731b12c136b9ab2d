//! The tables against what is known, on the redrawn curves and, where they are at hand, on the
//! authors'.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::fewest;
use super::measure::{self, Points, Run};
use super::models::{self, Model};
use super::rows::{CurveOrigin, PaperReport};
use super::{published, tables};
use crate::repository::root;
use std::path::PathBuf;

const PAPER: [Run; 2] = [
    Run::ShrinkingBall(Points::PerSegment),
    Run::Voronoi(Points::PerSegment),
];

/// The authors' curves, if somebody has laid them beside the project or fetched them.
fn authors() -> Option<Vec<Model>> {
    let beside: PathBuf = root().join("../shared/paper-data/curves");
    let fetched = root().join("fixtures/paper/curves");
    let found = [beside, fetched].into_iter().find(|folder| folder.is_dir());
    if found.is_none() {
        println!("skipped: the authors' curves are not at hand (cargo xtask fetch-paper-data)");
    }
    let (origin, models) = models::load(Some(&found?)).unwrap();
    assert_eq!(origin, CurveOrigin::Authors, "recognised by their digest");
    Some(models)
}

fn redrawn() -> Vec<Model> {
    models::redrawn().unwrap()
}

fn report(curves: CurveOrigin, models: &[Model], runs: &[Run]) -> PaperReport {
    PaperReport {
        curves,
        ..measure::tables_2_and_3(models, runs, [true, true]).unwrap()
    }
}

#[test]
fn table_1_has_the_printed_digits() {
    for (row, paper) in measure::table_1().iter().zip(published::TABLE_1) {
        let ours = [row.min_angle_deg, row.circle, row.parallel];
        let printed = [paper.min_angle_deg, paper.circle, paper.parallel];
        for (value, printed) in ours.into_iter().zip(printed) {
            assert!((value - printed).abs() < 1e-9, "{row:?} {paper:?}");
        }
    }
}

#[test]
fn every_sampling_of_the_redrawn_curves_is_reconstructed() {
    let report = report(CurveOrigin::Redrawn, &redrawn(), &PAPER);
    assert_eq!((report.table2.len(), report.table3.len()), (8, 10));
    assert_eq!(report.agreement(), []);
    // The stadium is drawn for this count.
    assert_eq!(report.table2[0].sampled.counts.rho, 20);
}

#[test]
fn the_authors_counts_are_reproduced() {
    let Some(models) = authors() else { return };
    let report = report(CurveOrigin::Authors, &models, &PAPER);
    assert_eq!(report.agreement(), []);
}

#[test]
fn a_count_that_is_off_is_a_disagreement() {
    let mut report = report(CurveOrigin::Authors, &redrawn(), &PAPER[..1]);
    assert!(!report.agreement().is_empty());
    report.table2[1].sampled.reconstructed = false;
    let message: Vec<String> = report.agreement().iter().map(ToString::to_string).collect();
    assert!(
        message[0].contains("manifold boundary of teaser"),
        "{message:?}"
    );
}

#[test]
fn converged_counts_have_converged() {
    for models in [Some(redrawn()), authors()].into_iter().flatten() {
        let counts = |points| {
            let report = report(CurveOrigin::Given, &models, &[Run::Voronoi(points)]);
            assert_eq!(report.agreement(), []);
            let second = report.table2.iter().map(|row| row.sampled.counts);
            let third = report.table3.iter().map(|row| row.sampled.counts);
            let counts = second.chain(third).flat_map(|counts| counts.columns());
            counts.collect::<Vec<_>>()
        };
        let Points::Adaptive(gap_to_lfs) = measure::CONVERGED else {
            panic!("converged counts are adaptive");
        };
        let (here, halved) = (
            counts(measure::CONVERGED),
            counts(Points::Adaptive(gap_to_lfs / 2.0)),
        );
        for (a, b) in here.iter().zip(&halved) {
            let allowed = if *a < 100 { 1.0 } else { 0.01 * *a as f64 };
            assert!(a.abs_diff(*b) as f64 <= allowed, "{here:?} {halved:?}");
        }
    }
}

#[test]
fn fewest_samples_are_fewer_and_reconstructed() {
    let models: Vec<Model> = redrawn().into_iter().take(2).collect();
    let report = PaperReport {
        fewest: fewest::rows(&models, 3).unwrap(),
        ..measure::tables_2_and_3(&[], &[], [false, false]).unwrap()
    };
    assert_eq!(report.agreement(), []);
    assert_eq!(report.fewest.len(), 6);
    for row in &report.fewest {
        assert!(row.fewest <= row.greedy, "{row:?}");
        assert_eq!(row.verified.is_some(), row.condition == "rho < 0.9");
        if let Some(verified) = row.verified {
            assert!(verified.within_lfs < row.greedy, "{row:?}");
            assert!(verified.no_limit < verified.within_percent, "{row:?}");
        }
    }
    let text = tables::markdown(&report);
    assert!(text.starts_with("## Beyond the paper") && text.contains("| teaser   | rho < 0.9"));
    assert_eq!(
        tables::numbers(&report).to_csv().unwrap().lines().count(),
        1 + 2 * (5 + 2 + 2)
    );

    let mut wrong = report;
    wrong.fewest[0].fewest = wrong.fewest[0].greedy + 1;
    assert_eq!(wrong.agreement().len(), 1);
}

#[test]
fn json_has_the_promised_keys() {
    let report = PaperReport {
        table1: measure::table_1(),
        ..report(CurveOrigin::Redrawn, &redrawn(), &PAPER[1..])
    };
    let json: serde_json::Value = serde_json::from_str(&tables::json(&report).unwrap()).unwrap();
    assert_eq!(json["curves"], "redrawn");
    for key in [
        "algorithm",
        "condition",
        "bound",
        "min_angle_deg",
        "circle",
        "parallel",
    ] {
        assert!(json["table1"][6].get(key).is_some(), "{key}");
    }
    for (table, subject) in [("table2", "model"), ("table3", "limit_percent")] {
        let row = &json[table][0];
        for key in [
            subject,
            "lfs",
            "discretisation",
            "rho0.9",
            "eps0.47",
            "eps1/3",
            "reconstructed",
        ] {
            assert!(row.get(key).is_some(), "{key}");
        }
    }
    assert!(json["table3"][0]["limit_percent"].is_null());
    assert_eq!(json["table2"][0]["lfs"], "voronoi");
    assert_eq!(json["table2"][0]["discretisation"], "300");
}

#[test]
fn csv_has_a_line_for_every_number() {
    let report = PaperReport {
        table1: measure::table_1(),
        ..report(CurveOrigin::Redrawn, &redrawn(), &PAPER[1..])
    };
    let csv = tables::numbers(&report).to_csv().unwrap();
    // Three numbers a row of Table 1; three counts and a verdict a row of the others.
    assert_eq!(csv.lines().count(), 1 + 3 * 7 + 4 * (4 + 5));
    assert!(csv.contains("2,redrawn,parallel,voronoi,300,rho < 0.9,20,20"));
}

#[test]
fn a_folder_without_the_curves_is_named() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("cat.svg"), "<svg/>").unwrap();
    let error = models::load(Some(folder.path())).err().unwrap().to_string();
    assert!(
        error.contains("lacks parallel.svg, teaser.svg, bunny.svg"),
        "{error}"
    );
    assert!(
        error.contains(&folder.path().display().to_string()),
        "{error}"
    );
}
