//! `curvecrust fit`, and `draw --fit`.

use crate::harness::{Folder, json};
use serde_json::json;
use std::fmt::Write;

/// Points that scatter about a circle of radius 10 about (100, 50), as a table; the last 12 belong
/// to none.
fn scattered() -> String {
    let mut table = String::from("x,y\n");
    // A sequence of low discrepancy in place of random numbers.
    let part = |i: u32, step: f64| (f64::from(i) * step).fract();
    for i in 0..300 {
        let angle = std::f64::consts::TAU * part(i, 0.618_033_988_749_895);
        let noise = part(i, 0.754_877_666_246_693) + part(i, 0.569_840_290_998_053) - 1.0;
        let radius = 10.0 + 0.8 * noise;
        let (x, y) = (100.0 + radius * angle.cos(), 50.0 + radius * angle.sin());
        writeln!(table, "{x},{y}").unwrap();
    }
    for i in 0..12 {
        let (x, y) = (f64::from(i % 4), f64::from(i / 4));
        writeln!(table, "{},{}", 95.0 + 3.0 * x, 46.0 + 4.0 * y).unwrap();
    }
    table
}

#[test]
fn a_scattered_circle_in_every_format() {
    let folder = Folder::with("scan.csv", scattered());
    let run = folder.run("fit scan.csv --json --inliers in.csv");
    let summary = run.stderr.clone();
    let found = json(&run.fine());
    assert!(
        summary.starts_with("312 points, 12 outliers: 1 closed and 0 open curve, from which"),
        "{summary}"
    );
    assert_eq!(found["clean"], json!(false));
    assert_eq!(found["edges"], json!(null));
    assert_eq!(found["outliers"], json!((300..312).collect::<Vec<_>>()));
    let sigma = found["sigma"].as_f64().unwrap();
    assert!((0.2..0.45).contains(&sigma), "{sigma}");
    let curve = &found["curves"][0];
    assert_eq!(curve["closed"], json!(true));
    assert_eq!(curve["points"], json!(300));
    assert_eq!(curve["corners"], json!([]));
    for cubic in curve["cubics"].as_array().unwrap() {
        let [x, y] = [0, 1].map(|k| cubic[0][k].as_f64().unwrap());
        let radius = (x - 100.0).hypot(y - 50.0);
        assert!((radius - 10.0).abs() < 0.2, "{radius}");
    }
    assert_eq!(folder.read("in.csv").lines().count(), 301);
    let table = folder.run("fit scan.csv").fine();
    assert!(
        table.starts_with("chain,kind,nesting,point,x,y\n0,ring,0,,"),
        "{table}"
    );
    let map = json(&folder.run("fit scan.csv --to geojson").fine());
    let feature = &map["features"][0];
    assert_eq!(feature["geometry"]["type"], json!("Polygon"));
    assert_eq!(feature["properties"]["kind"], json!("ring"));
    // A picture is the same by either command.
    let svg = folder.run("fit scan.csv --to svg").fine();
    assert!(
        svg.contains(r#"<g id="band""#) && svg.contains(" C "),
        "{svg}"
    );
    assert_eq!(folder.run("draw --points scan.csv --fit").fine(), svg);
    // Outliers are in a group of their own.
    let document = roxmltree::Document::parse(&svg).unwrap();
    for (id, count) in [("outliers", 12), ("points", 300)] {
        let group = document
            .descendants()
            .find(|n| n.attribute("id") == Some(id));
        let nodes = group.unwrap().descendants().skip(1);
        let nodes: Vec<_> = nodes.filter(roxmltree::Node::is_element).collect();
        assert_eq!(nodes.len(), count, "{id}");
        assert!(nodes.iter().all(|n| n.has_tag_name("circle")), "{id}");
    }
    for format in ["wkt", "dxf"] {
        folder.run(&format!("fit scan.csv --to {format}")).fine();
    }
}

#[test]
fn finer_lines_have_more_vertices() {
    let folder = Folder::with("scan.csv", scattered());
    let lines = |tolerance: &str| {
        let run = folder.run(&format!("fit scan.csv --tolerance {tolerance}"));
        run.fine().lines().count()
    };
    assert!(lines("0.0001") > 2 * lines("0.01"));
    let error = folder.run("fit scan.csv --tolerance 0").error();
    assert_eq!(
        error,
        "error: --tolerance is 0: give a finite length above 0"
    );
}

#[test]
fn points_on_their_curve_give_what_reconstruct_gives() {
    let ring = "x,y\n0,0\n1,0\n2,0\n2,1\n2,2\n1,2\n0,2\n0,1\n";
    let folder = Folder::with("ring.csv", ring);
    for format in ["csv", "geojson", "wkt", "dxf", "svg"] {
        let [fit, reconstruct] = ["fit", "reconstruct"].map(|command| {
            folder
                .run(&format!("{command} ring.csv --to {format}"))
                .fine()
        });
        assert_eq!(fit, reconstruct, "{format}");
    }
    let run = folder.run("fit ring.csv");
    assert_eq!(
        run.stderr,
        "8 points, 0 outliers: 1 closed and 0 open curve, on which the points lie\n"
    );
}

#[test]
fn what_is_no_curve_and_what_is_wrong_is_said() {
    // A lattice, each point moved a little.
    let mut table = String::from("x,y\n");
    for i in 0u32..400 {
        let part = |step: f64| (f64::from(i) * step).fract();
        let (x, y) = (part(0.754_877_666_246_693), part(0.569_840_290_998_053));
        writeln!(table, "{x},{y}").unwrap();
    }
    let folder = Folder::with("square.csv", table);
    let run = folder.run("fit square.csv");
    assert_eq!(run.stderr, "400 points form no curve\n");
    assert_eq!(run.fine(), "chain,kind,nesting,point,x,y\n");
    let error = folder.run("fit square.csv --sigma -1").error();
    assert_eq!(
        error,
        "error: sigma is -1: give a finite length of 0 or more, or none"
    );
}
