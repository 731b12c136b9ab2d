//! `curvecrust sample` and `curvecrust lfs`.

use crate::harness::{Folder, fixture, json};
use std::fmt::Write;

const CIRCLE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 4">
<path d="M 3 2 A 1 1 0 0 1 1 2 A 1 1 0 0 1 3 2 Z"/></svg>"#;

#[test]
fn samples_of_a_drawing_shuffled_are_found_again() {
    let folder = Folder::new();
    let curve = fixture("curves/teaser.svg");
    let line = format!("sample {} --rho 0.9 -o samples.csv", curve.display());
    folder.run(&line).fine();
    let table = folder.read("samples.csv");
    let (header, rows) = table.split_once('\n').unwrap();
    let mut rows: Vec<&str> = rows.lines().collect();
    let count = rows.len();
    rows.sort_by_key(|row| row.bytes().rev().collect::<Vec<_>>());
    folder.write("shuffled.csv", format!("{header}\n{}\n", rows.join("\n")));
    let run = folder.run("reconstruct shuffled.csv -o found.json");
    assert!(
        run.stderr
            .contains("1 ring, 0 leaves, 0 isolated points, 0 violations"),
        "{}",
        run.stderr
    );
    let found = json(&folder.read("found.json"));
    assert_eq!(found["edges"].as_array().unwrap().len(), count);
}

#[test]
fn a_circle_takes_as_many_samples_as_the_theory_says() {
    let folder = Folder::with("circle.svg", CIRCLE);
    let found = json(&folder.run("sample circle.svg --rho 0.9 --json").fine());
    // Consecutive samples are at most 4 asin(rho / 2) apart, as seen from the centre.
    assert_eq!(found["count"], 4);
    assert_eq!(found["condition"], "rho");
    assert_eq!(found["bound"], 0.9);
    assert_eq!(found["components"][0]["end"], 4);
    let hausdorff = found["hausdorff"]["upper"].as_f64().unwrap();
    assert!(hausdorff > 0.2 && hausdorff < 0.45, "{hausdorff}");

    let near = json(
        &folder
            .run("sample circle.svg --rho 0.9 --max-distance 1% --json")
            .fine(),
    );
    let length = json(
        &folder
            .run("sample circle.svg --rho 0.9 --max-distance 0.02 --json")
            .fine(),
    );
    // The extent is 2 up to the error of arcs.
    assert_eq!(near["count"], length["count"]);
    assert!(near["hausdorff"]["upper"].as_f64().unwrap() < 0.0201);
}

#[test]
fn every_format_holds_the_same_samples() {
    let folder = Folder::with("circle.svg", CIRCLE);
    let sample = |to: &str| {
        folder
            .run(&format!("sample circle.svg --epsilon 0.3 --to {to}"))
            .fine()
    };
    let object = json(&sample("json"));
    let samples = object["samples"].as_array().unwrap();
    let mut text = String::new();
    for p in samples {
        let (x, y) = (p[0].as_f64().unwrap(), p[1].as_f64().unwrap());
        writeln!(text, "{x} {y}").unwrap();
    }
    assert_eq!(sample("text"), text);
    assert_eq!(
        sample("csv").replace("0,", "").replace(',', " "),
        format!("curve x y\n{text}").replace("0,", "")
    );
    assert_eq!(
        json(&sample("geojson"))["features"][0]["geometry"]["coordinates"],
        object["samples"]
    );
}

#[test]
fn counts_are_ordered_and_only_the_verified_one_is_beyond_the_bound() {
    let folder = Folder::new();
    let curve = fixture("curves/bunny.svg").display().to_string();
    let sample = |how: &str| {
        let line = format!("sample {curve} --epsilon 0.4 --count {how} --json");
        let run = folder.run(&line);
        assert_eq!(run.stderr.contains("verified"), how == "verified");
        json(&run.fine())
    };
    let [verified, fewest, greedy] = ["verified", "fewest", "greedy"].map(sample);
    let count = |object: &serde_json::Value| object["count"].as_u64().unwrap();
    assert!(count(&verified) < count(&fewest) && count(&fewest) <= count(&greedy));
    let attained = |object: &serde_json::Value| object["attained"]["upper"].as_f64();
    assert!(attained(&fewest).unwrap() < 0.4 && attained(&greedy).unwrap() < 0.4);
    assert!(attained(&verified).is_none_or(|epsilon| epsilon > 0.4));
}

#[test]
fn a_condition_is_asked_for() {
    let folder = Folder::with("circle.svg", CIRCLE);
    let length = "give a length above 0";
    let share = "give a share above 0 and at most 1";
    let rho = |value| format!("rho is {value}: it must be above 0 and at most 1");
    let epsilon = |value| format!("epsilon is {value}: it must lie strictly between 0 and 1");
    for (options, says) in [
        ("", "--rho <RHO>"),
        ("--rho 0.9 --epsilon 0.4", "cannot be used with"),
        ("--rho 1.5", &rho("1.5")),
        ("--rho 0", &rho("0")),
        ("--rho -0.5", &rho("-0.5")),
        ("--rho NaN", &rho("NaN")),
        ("--epsilon 1", &epsilon("1")),
        ("--epsilon -1", &epsilon("-1")),
        ("--epsilon inf", &epsilon("inf")),
        ("--rho 0.9 --max-distance 0%", length),
        ("--rho 0.9 --max-distance -1", length),
        ("--rho 0.9 --max-distance NaN", length),
        ("--rho 0.9 --gap 0", share),
        ("--rho 0.9 --gap -1", share),
    ] {
        let run = folder.run(&format!("sample circle.svg {options}"));
        assert_eq!(run.status, Some(2));
        assert!(run.stderr.contains(says), "{}", run.stderr);
    }
}

#[test]
fn too_many_samples_are_counted() {
    let folder = Folder::with("circle.svg", CIRCLE);
    let limit = "the Hausdorff limit is 1e-15, which asks for about 7";
    for (options, says) in [
        ("--rho 1e-8", "rho is 1e-8, which asks for about 31"),
        (
            "--epsilon 1e-8 --gap 0.02",
            "epsilon is 1e-8, which asks for about 31",
        ),
        ("--rho 2e-6", "rho is 2e-6, which asks for about 15"),
        ("--rho 0.9 --max-distance 1e-15", limit),
    ] {
        let error = folder.run(&format!("sample circle.svg {options}")).error();
        let says = format!("error: circle.svg: {says}");
        assert!(error.starts_with(&says), "{error}");
        assert!(error.ends_with("take a larger one"), "{error}");
    }
}

#[test]
fn places_without_a_local_feature_size_are_named() {
    let two = |x: f64| {
        let other = format!("<circle cx='{x}' cy='2' r='1'/></svg>");
        CIRCLE.replace("</svg>", &other)
    };
    let folder = Folder::with("crossing.svg", two(2.8));
    folder.write("touching.svg", two(4.0));
    // At (2.4, 1.083...) or (2.4, 2.916...), which of the two is not said.
    let crossing = "error: crossing.svg: <path> in line 2 and <circle> in line 2: \
                    components ";
    let touching = "error: touching.svg: <path> in line 2 and <circle> in line 2: near (3, 2) the \
                    curve touches itself or another";
    for (line, says) in [
        ("crossing.svg --strokes together", crossing),
        ("crossing.svg --corners refuse", crossing),
        ("crossing.svg --gap 0.05", crossing),
        ("touching.svg --strokes together", touching),
    ] {
        let error = folder.run(&format!("sample {line} --rho 0.9")).error();
        assert!(error.starts_with(says), "{error}");
    }
}

#[test]
fn lfs_of_a_circle_is_its_radius() {
    let folder = Folder::with("circle.svg", CIRCLE);
    let table = folder.run("lfs circle.svg").fine();
    let mut rows = table.lines();
    assert_eq!(rows.next(), Some("curve,x,y,lfs"));
    let mut count = 0;
    for row in rows {
        let lfs: f64 = row.rsplit(',').next().unwrap().parse().unwrap();
        assert!((lfs - 1.0).abs() < 1e-3, "{row}");
        count += 1;
    }
    let object = json(&folder.run("lfs circle.svg --json --quiet").fine());
    assert_eq!(
        object["components"][0]["lfs"].as_array().unwrap().len(),
        count
    );
    assert_eq!(object["components"][0]["closed"], true);
}

const BADGE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40">
<path d="M 0 0 H 30 V 20 H 0 Z"/><circle cx="15" cy="10" r="4"/></svg>"#;

#[test]
fn corners_are_refused_by_name_or_become_samples() {
    let folder = Folder::with("badge.svg", BADGE);
    let refused = folder
        .run("sample badge.svg --rho 0.9 --corners refuse")
        .error();
    for corner in ["at (0, 0)", "at (30, 0)", "at (30, 20)", "at (0, 20)"] {
        assert!(refused.contains(corner), "{refused}");
    }
    assert!(refused.ends_with("pass --corners split"), "{refused}");
    folder.run("draw --curve badge.svg").fine();
    folder.run("draw --curve badge.svg --lfs").fine();
    let refused = folder
        .run("draw --curve badge.svg --corners refuse")
        .error();
    assert!(refused.contains("at (30, 20)"), "{refused}");
    let run = folder.run("sample badge.svg --rho 0.9 -o samples.json");
    assert!(
        run.stderr.contains(
            "4 corners, which no theorem covers: least detour returns exactly the polygon"
        ),
        "{}",
        run.stderr
    );
    run.fine();
    let found = json(&folder.read("samples.json"));
    assert_eq!(found["components"].as_array().unwrap().len(), 2);
    assert_eq!(found["components"][0]["closed"], true);
    for corner in [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [0.0, 20.0]] {
        let samples = found["samples"].as_array().unwrap();
        let here = samples.iter().filter(|&s| *s == serde_json::json!(corner));
        assert_eq!(here.count(), 1);
    }
    let sharp = BADGE.replace("V 20 H 0 Z", "L 0 3 Z");
    folder.write("sharp.svg", sharp);
    let run = folder.run("sample sharp.svg --rho 0.9 -o sharp.csv");
    assert!(
        run.stderr
            .contains("least detour returns exactly the polygon"),
        "{}",
        run.stderr
    );
    run.fine();
}

#[test]
fn gaps_of_rounding_errors_are_joined_and_named() {
    // The last point misses the start by rounding, which would be two corners beside each other.
    let d = "M 0 0 H 30 V 20 H 0 V 0.0004 Z";
    let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="{d}"/></svg>"#);
    let folder = Folder::with("plate.svg", &svg);
    let run = folder.run("sample plate.svg --rho 0.9 -o plate.json");
    assert!(
        run.stderr
            .contains("plate.svg: a gap of at most 0.01 % of the drawing joined, first at (0, 0)"),
        "{}",
        run.stderr
    );
    assert!(run.stderr.contains("4 corners"), "{}", run.stderr);
    run.fine();
    let run = folder.run("sample plate.svg --rho 0.9 --snap 0 -o apart.json");
    assert!(!run.stderr.contains("joined"), "{}", run.stderr);
}

#[test]
fn samples_say_how_they_are_known_to_suffice() {
    let folder = Folder::with("circle.svg", CIRCLE);
    folder.write("badge.svg", BADGE);
    for (line, guaranteed, says) in [
        (
            "circle.svg --rho 0.88",
            "theorem",
            "; HNN-Crust is proven to return",
        ),
        (
            "circle.svg --epsilon 0.45",
            "theorem",
            "; HNN-Crust is proven to return",
        ),
        (
            "circle.svg --rho 0.9",
            "running",
            "; least detour returns exactly",
        ),
        (
            "circle.svg --epsilon 0.5",
            "running",
            "; least detour returns exactly",
        ),
        (
            "badge.svg --rho 0.9",
            "running",
            "least detour returns exactly",
        ),
    ] {
        let run = folder.run(&format!("sample {line} --json"));
        assert!(run.stderr.contains(says), "{line}: {}", run.stderr);
        assert_eq!(json(&run.fine())["guaranteed"], guaranteed, "{line}");
    }
}
