//! `check`, `evaluate`, `medial-axis`, `draw`, and `completions`.

use crate::harness::{Folder, fixture, json};

/// A folder with samples of a curve of the repository, and the path of that.
fn sampled(condition: &str) -> (Folder, String) {
    let folder = Folder::new();
    let curve = fixture("curves/bunny.svg").display().to_string();
    folder
        .run(&format!("sample {curve} {condition} -o s.csv"))
        .fine();
    (folder, curve)
}

#[test]
fn what_was_sampled_holds_and_fewer_samples_do_not() {
    let (folder, curve) = sampled("--rho 0.9 --max-distance 1%");
    let held = folder.run(&format!(
        "check {curve} s.csv --rho 0.9 --max-distance 1% --json"
    ));
    let held = json(&held.fine());
    assert_eq!(
        (&held["holds"], &held["certain"]),
        (&true.into(), &true.into())
    );
    assert_eq!(held["violations"].as_array().unwrap().len(), 0);
    let rho = &held["effective_rho"];
    assert!(
        rho["lower"].as_f64().unwrap() > 0.8 && rho["upper"].as_f64().unwrap() < 0.9,
        "{rho}"
    );

    // Without its third sample.
    let table = folder.read("s.csv");
    let fewer: Vec<&str> = table
        .lines()
        .enumerate()
        .filter(|&(i, _)| i != 3)
        .map(|l| l.1)
        .collect();
    folder.write("fewer.csv", fewer.join("\n"));
    let run = folder.run(&format!("check {curve} fewer.csv --rho 0.9 --json"));
    assert_eq!(run.status, Some(1), "{}", run.stderr);
    let found = json(&run.stdout);
    assert_eq!(found["holds"], false);
    assert_eq!(found["violations"][0]["samples"], serde_json::json!([1, 2]));
    let run = folder.run(&format!("check {curve} fewer.csv --rho 0.9"));
    assert_eq!(run.status, Some(1));
    assert!(
        run.stdout
            .contains("violated on curve 0 from sample 1 to sample 2: rho is ")
    );
    assert!(
        run.stdout.ends_with("rho < 0.9 does not hold\n"),
        "{}",
        run.stdout
    );

    // Without a condition there is nothing to fail.
    folder.run(&format!("check {curve} fewer.csv")).fine();
    let lone = folder.run(&format!("check {curve} fewer.csv --max-distance 1%"));
    assert_eq!(lone.status, Some(2));
}

#[test]
fn points_off_the_curve_are_no_samples() {
    let (folder, curve) = sampled("--rho 0.9");
    folder.write("off.csv", folder.read("s.csv") + "0,-999,-999\n");
    let error = folder.run(&format!("check {curve} off.csv")).error();
    assert!(
        error.contains("off.csv: sample 49 at (-999, -999) is ")
            && error.contains(" from the curve, farther than the tolerance of "),
        "{error}"
    );
    // Both before the start.
    folder.write("twice.csv", "3,0\n-0.2,0\n1,0\n-0.1,0\n");
    let line = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M 0 0 H 3'/></svg>";
    folder.write("line.svg", line);
    let error = folder.run("check line.svg twice.csv --tolerance 1").error();
    let says = "twice.csv: samples 1 and 3 are at the same place of the curve, near (-0.2, 0)";
    assert!(error.contains(says), "{error}");
}

#[test]
fn algorithms_are_evaluated_against_the_curve() {
    let (folder, curve) = sampled("--rho 0.9");
    let found = json(&folder.run(&format!("evaluate {curve} s.csv --json")).fine());
    assert_eq!(found["results"][0]["algorithm"], "least-detour");
    assert_eq!(found["results"][0]["exact"], true);
    assert_eq!(found["true_edges"], found["points"]);
    let line = format!("evaluate {curve} s.csv --algorithm hnn-crust --algorithm gabriel");
    let run = folder.run(&line);
    assert_eq!(run.status, Some(1), "{}", run.stdout);
    assert_eq!(run.stdout.lines().count(), 4);
}

#[test]
fn the_axis_of_a_stadium_is_its_core() {
    let stadium = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="-2 -2 9 6">
        <path d="M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z"/></svg>"#;
    let folder = Folder::with("stadium.svg", stadium);
    let table = folder.run("medial-axis stadium.svg").fine();
    assert!(table.starts_with("x0,y0,x1,y1\n"));
    let mut inside = 0;
    for row in table.lines().skip(1) {
        let values: Vec<f64> = row.split(',').map(|v| v.parse().unwrap()).collect();
        let [x0, y0, ..] = values[..] else {
            panic!("{row}")
        };
        if (0.1..3.9).contains(&x0) && (0.1..1.9).contains(&y0) {
            assert!((y0 - 1.0).abs() < 1e-3, "{row}");
            inside += 1;
        }
    }
    assert!(inside > 20);
    for name in ["a.svg", "a.geojson", "a.wkt", "a.dxf", "a.json"] {
        folder
            .run(&format!("medial-axis stadium.svg -o {name}"))
            .fine();
    }
    folder
        .read("a.geojson")
        .parse::<geojson::GeoJson>()
        .unwrap();
    folder.read("a.wkt").parse::<wkt::Wkt<f64>>().unwrap();
}

#[test]
fn every_layer_is_drawn() {
    let (folder, curve) = sampled("--rho 0.9");
    let points = fixture("points/violated.xy").display().to_string();
    for (what, ids) in [
        (format!("--curve {curve}"), &["curve"][..]),
        (
            format!("--curve {curve} --medial-axis --points s.csv"),
            &["medial-axis", "curve", "points"],
        ),
        (
            format!("--curve {curve} --lfs --points s.csv --edges"),
            &["lfs", "legend", "edges", "points"],
        ),
        (
            format!("--points {points} --edges crust --violations"),
            &["edges", "violations", "points"],
        ),
    ] {
        let svg = folder.run(&format!("draw {what}")).fine();
        roxmltree::Document::parse(&svg).unwrap();
        let drawn: Vec<&str> = svg
            .split("<g id=\"")
            .skip(1)
            .map(|g| g.split('"').next().unwrap())
            .collect();
        assert_eq!(drawn, ids);
    }
    for nothing in ["draw", "draw --lfs", "draw --points s.csv --lfs"] {
        assert_eq!(folder.run(nothing).status, Some(2), "{nothing}");
    }
}

#[test]
fn the_axis_of_a_picture_does_not_move_its_frame() {
    let (folder, curve) = sampled("--rho 0.9");
    let frame = |line: &str| {
        let svg = folder.run(&format!("draw --curve {curve} {line}")).fine();
        svg.lines().next().unwrap().to_owned()
    };
    assert_eq!(frame(""), frame("--medial-axis"));
}

#[test]
fn shells_get_their_completions_and_every_command_its_example() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = folder.run(&format!("completions {shell}")).fine();
        assert!(script.contains("medial-axis"), "{shell}");
    }
    let help = folder.run("--help").fine();
    let commands = help
        .split("Commands:\n")
        .nth(1)
        .unwrap()
        .split("\n\n")
        .next()
        .unwrap();
    let mut count = 0;
    for line in commands.lines() {
        let name = line.split_whitespace().next().unwrap();
        if name != "help" && line.starts_with("  ") && !line.starts_with("   ") {
            let help = folder.run(&format!("{name} --help")).fine();
            let (_, example) = help.split_once("\nExample").unwrap();
            assert!(
                example.contains(&format!("\n  curvecrust {name}")),
                "{example}"
            );
            count += 1;
        }
    }
    assert_eq!(count, 11);
}
