//! Runs as a whole: the same bytes on any number of threads and after an interruption.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::experiment::{Choice, Kind};
use super::plan::{chosen, named};
use super::rows::metrics;
use super::true_curves::{Named, TrueCurves};
use super::*;
use curvecrust_testing::fixtures::Manifest;

fn options(folder: &Path, experiments: &[&str], trials: u32) -> Options {
    Options {
        experiments: experiments.iter().map(|&name| name.to_owned()).collect(),
        trials: Some(trials),
        quick: true,
        threads: Some(1),
        output: Some(folder.to_path_buf()),
        ..Options::default()
    }
}

fn rows(folder: &Path) -> String {
    fs::read_to_string(folder.join("rows.csv")).unwrap()
}

fn run_whole(options: &Options) -> String {
    let results = run(options, &AtomicBool::new(false)).unwrap().results;
    assert!(results.unwrap().differing.is_empty());
    rows(options.output.as_deref().unwrap())
}

#[test]
fn threads_and_interruptions_change_nothing() {
    let [one, two] = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let experiments = ["corners", "noise", "outliers"];
    let alone = options(one.path(), &experiments, 2);
    let whole = run_whole(&alone);
    let parallel = Options {
        threads: Some(3),
        ..options(two.path(), &experiments, 2)
    };
    assert_eq!(run_whole(&parallel), whole);
    assert!(!whole.contains("nan"));

    // Cut in the middle of a line, as by a kill: resuming repeats the cell.
    fs::write(two.path().join("rows.csv"), &whole[..whole.len() * 2 / 3]).unwrap();
    let resumed = Options {
        resume: true,
        ..parallel
    };
    assert_eq!(run_whole(&resumed), whole);
    let times = |folder: &Path| fs::read_to_string(folder.join("times.csv")).unwrap();
    let without_seconds = |text: &str| -> Vec<String> {
        let keep = |line: &str| line.rsplitn(3, ',').last().unwrap().to_owned();
        text.lines().map(keep).collect()
    };
    assert_eq!(
        without_seconds(&times(one.path())),
        without_seconds(&times(two.path()))
    );
    // Tables and plots are functions of the rows; the page names the run.
    for name in [
        "tables.md",
        "tables.json",
        "plots/overview.svg",
        "cells.csv",
    ] {
        let read = |folder: &Path| fs::read(folder.join(name)).unwrap();
        assert!(read(one.path()) == read(two.path()), "{name}");
    }

    let other = Options {
        seed: Some(1),
        ..resumed
    };
    let outcome = run(&other, &AtomicBool::new(false));
    let error = outcome.err().unwrap().to_string();
    assert!(error.contains("holds another run"), "{error}");
}

#[test]
fn a_stopped_run_keeps_whole_cells() {
    let folder = tempfile::tempdir().unwrap();
    let stopped = options(folder.path(), &["corners"], 2);
    let outcome = run(&stopped, &AtomicBool::new(true)).unwrap();
    assert!(outcome.results.is_none());
    assert_eq!(
        rows(folder.path()),
        records::table::<Row>(&[]).to_csv().unwrap()
    );
    let resumed = Options {
        resume: true,
        ..stopped
    };
    let resumed = run_whole(&resumed);
    let again = tempfile::tempdir().unwrap();
    assert_eq!(run_whole(&options(again.path(), &["corners"], 2)), resumed);
}

#[test]
fn cells_survive_their_csv() {
    let folder = tempfile::tempdir().unwrap();
    let text = run_whole(&options(folder.path(), &["open"], 2));
    let rows: Vec<Row> = records::read(&text).unwrap();
    assert!(
        rows.iter()
            .all(|row| row.error.is_none() && row.values.len() == metrics().count())
    );
    let cells = Cells::of_rows(&rows);
    let text = cells.table().to_csv().unwrap();
    let read = Cells::read(&text).unwrap();
    assert_eq!(read.table().to_csv().unwrap(), text);
}

#[test]
fn a_known_answer_that_differs_is_named() {
    let mut experiments = chosen(&Options::default()).unwrap();
    let rho = experiments
        .iter()
        .position(|e| e.name == "density-rho")
        .unwrap();
    let experiment = experiments.swap_remove(rho);
    let known = &experiment.known[0];
    let row = |x, exact| Row {
        experiment: experiment.name.clone(),
        series: "closed curves/teaser".to_owned(),
        x,
        trial: 7,
        seed: 8,
        algorithm: known.algorithm.clone(),
        points: 1,
        values: vec![Some(curvecrust::evaluate::Bounds::exactly(exact))],
        error: None,
        version: String::new(),
    };
    let rows = [row(0.5, 1.0), row(0.9, 1.0), row(0.9, 0.0), row(1.5, 0.0)];
    let found = known::differing(std::slice::from_ref(&experiment), &rows);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        found[0].contains("1 of 2 trials of closed curves/teaser at 0.9 (first: trial 7, seed 8)")
    );
}

/// The authors' curves take part if they were fetched, and nothing is missed if not.
#[test]
fn the_authors_curves_take_part_when_they_are_there() {
    let manifest = Manifest::read().unwrap();
    let names = named(&manifest, &Choice::Kind(Kind::Authors));
    if !true_curves::authors_curves().is_dir() {
        eprintln!("skipped in part: fixtures/paper was not fetched");
        assert!(names.is_empty());
        return;
    }
    let shown: Vec<String> = names.iter().map(Named::to_string).collect();
    assert_eq!(
        shown,
        ["paper-parallel", "paper-teaser", "paper-bunny", "paper-cat"]
    );
    for name in names {
        assert!(
            !TrueCurves::named(&name).unwrap().parts.is_empty(),
            "{name}"
        );
    }
}

/// What the list says of local feature sizes, measured.
#[test]
fn local_feature_sizes_vary_as_the_manifest_says() {
    let extremes = |name: &str| {
        let curves = TrueCurves::named(&Named::Fixture(name.to_owned())).unwrap();
        let lfs = || {
            curves
                .parts
                .iter()
                .flat_map(|part| part.lfs.iter().copied())
        };
        let [least, most] = [
            lfs().fold(f64::INFINITY, f64::min),
            lfs().fold(0.0, f64::max),
        ];
        [least, most].map(|lfs| lfs / curves.reference.extent())
    };
    let [least, most] = extremes("nautilus");
    println!("nautilus: lfs from {least} to {most} extents");
    assert!(most > 1000.0 * least);
    let [least, most] = extremes("eclipse");
    println!("eclipse: lfs from {least} to {most} extents");
    assert!(least < 0.01);
    let [least, most] = extremes("spiral");
    println!("spiral: lfs from {least} to {most} extents");
    assert!(least < 0.03 && most < 1.1 * least);
}

/// Files of outlines are series, and their lines are trials.
#[test]
fn outlines_take_part_when_files_are_given() {
    let [files, folder] = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    let ring = |count: i32| -> Vec<[f64; 2]> {
        let turn = |i| f64::from(i) * std::f64::consts::TAU / f64::from(count);
        (0..count).map(|i| [turn(i).cos(), turn(i).sin()]).collect()
    };
    let line = |name: &str, count| serde_json::json!({"name": name, "rings": [ring(count)]});
    let text = format!("{}\n{}\n", line("twelve", 12), line("thirty", 30));
    fs::write(files.path().join("circles.ndjson"), text).unwrap();
    let without = options(folder.path(), &["outlines"], 5);
    let error = run(&without, &AtomicBool::new(false)).err().unwrap();
    assert!(error.to_string().contains("--outlines"), "{error}");
    let given = Options {
        outlines: Some(files.path().to_owned()),
        ..without
    };
    let rows: Vec<Row> = records::read(&run_whole(&given)).unwrap();
    let crust = rows.iter().filter(|row| row.algorithm == "crust");
    let crust: Vec<_> = crust.map(|row| (&*row.series, row.points)).collect();
    assert_eq!(crust, [("rings, circles", 12), ("rings, circles", 30)]);
    let exact = metrics().position(|metric| metric.name == "exact").unwrap();
    let is_exact = |row: &Row| row.values[exact].is_some_and(|value| value.lower > 0.5);
    assert!(
        rows.iter()
            .filter(|row| row.algorithm == "hnn-crust")
            .all(is_exact)
    );
}
