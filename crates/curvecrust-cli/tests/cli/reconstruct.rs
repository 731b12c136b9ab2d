//! `curvecrust reconstruct` and `curvecrust algorithms`.

use crate::harness::{Folder, fixture, json};
use serde_json::json;

/// The corners of a rectangle, walked round, and one corner again.
const RECTANGLE: &str = "0 0\n0 2\n3 2\n3 0\n0 2\n";

#[test]
fn the_table_of_a_ring() {
    let folder = Folder::with("ring.csv", "x,y\n0,0\n0,2\n3,2\n3,0\n");
    let run = folder.run("reconstruct ring.csv");
    assert_eq!(
        run.stderr,
        "4 points, 4 edges: 1 chain, 1 ring, 0 leaves, 0 isolated points, 0 violations\n"
    );
    assert_eq!(
        run.fine(),
        "chain,kind,nesting,point,x,y\n\
         0,ring,0,0,0,0\n\
         0,ring,0,3,3,0\n\
         0,ring,0,2,3,2\n\
         0,ring,0,1,0,2\n"
    );
}

#[test]
fn termini_open_a_ring() {
    let folder = Folder::with("ring.xy", "0 0\n0 2\n3 2\n3 0\n");
    let run = folder.run("reconstruct ring.xy --terminus 0 --terminus 3");
    assert_eq!(
        run.stderr,
        "4 points, 3 edges: 1 chain, 0 rings, 2 leaves, 0 isolated points, 0 violations\n"
    );
    let unknown = folder.run("reconstruct ring.xy --terminus 4").error();
    assert_eq!(
        unknown,
        "error: there is no point 4: there are 4, counted from 0"
    );
    let deaf = folder
        .run("reconstruct ring.xy --terminus 0 --algorithm crust")
        .error();
    assert!(
        deaf.starts_with("error: crust does not honour termini"),
        "{deaf}"
    );
}

#[test]
fn what_is_known_is_kept() {
    // A long rectangle by its corners: told nothing, no ring.
    let folder = Folder::with("corners.xy", "0 0\n9 0\n9 1\n0 1\n");
    let run = folder.run("reconstruct corners.xy --closed --curves 1 --json");
    let found = json(&run.fine());
    assert_eq!(found["edges"], json!([[0, 1], [0, 3], [1, 2], [2, 3]]));
    assert_eq!(
        found["known"],
        json!({"shape": "closed", "curves": 1, "termini": []})
    );
    let run = folder.run("reconstruct corners.xy --open --curves 1 --terminus 1 --terminus 0");
    assert!(
        run.stderr.contains("1 chain, 0 rings, 2 leaves"),
        "{}",
        run.stderr
    );
    let told_nothing = json(&folder.run("reconstruct corners.xy --json").fine());
    assert!(told_nothing.get("known").is_none());
}

#[test]
fn what_cannot_be_met_is_an_error_of_one_line() {
    let folder = Folder::with("row.xy", "0 0\n1 1\n2 2\n5 5\n");
    for (told, start) in [
        ("--closed", "error: all 4 points lie on one line"),
        (
            "--closed --curves 2",
            "error: 4 points are too few for 2 such curves",
        ),
        (
            "--curves 3",
            "error: 4 points are too few for 3 such curves",
        ),
        (
            "--curves 1 --algorithm crust",
            "error: crust cannot use whether curves are closed",
        ),
        (
            "--curves 1 --terminus 0 --terminus 1 --terminus 2",
            "error: 3 points are marked as termini, but 1 curves have 2 ends",
        ),
    ] {
        let error = folder.run(&format!("reconstruct row.xy {told}")).error();
        assert!(error.starts_with(start), "{error}");
        assert_eq!(error.lines().count(), 1);
    }
}

#[test]
fn duplicates_are_refused_or_merged_and_points_keep_their_numbers() {
    let folder = Folder::with("twice.xy", format!("0 0\n{RECTANGLE}"));
    let refused = folder.run("reconstruct twice.xy").error();
    assert_eq!(
        refused,
        "error: twice.xy: points 0 and 1 are both (0, 0): remove one, or pass --merge-duplicates"
    );
    let run = folder.run("reconstruct twice.xy --merge-duplicates --algorithm hnn-crust --json");
    assert!(
        run.stderr
            .starts_with("4 points (2 duplicates merged), 4 edges"),
        "{}",
        run.stderr
    );
    assert_eq!(
        json(&run.fine()),
        json!({
            "algorithm": "hnn-crust",
            "points": [[0.0, 0.0], [0.0, 0.0], [0.0, 2.0], [3.0, 2.0], [3.0, 0.0], [0.0, 2.0]],
            "edges": [[0, 2], [0, 4], [2, 3], [3, 4]],
            "rings": [{ "points": [0, 4, 3, 2], "nesting": 0 }],
            "open_chains": [],
            "leaves": [],
            "isolated": [],
            "junctions": [],
            "duplicates": [
                { "point": 1, "same_as": 0 },
                { "point": 5, "same_as": 2 },
            ],
        })
    );
}

#[test]
fn one_point_is_isolated() {
    let run = Folder::new().pipe("reconstruct -", "1.5 2\n");
    assert_eq!(
        run.stderr,
        "1 point, 0 edges: 0 chains, 0 rings, 0 leaves, 1 isolated point, 1 violation\n"
    );
    assert_eq!(
        run.fine(),
        "chain,kind,nesting,point,x,y\n,isolated,,0,1.5,2\n"
    );
}

#[test]
fn without_a_known_ending_the_format_is_found_by_the_content() {
    let folder = Folder::new();
    let tables = [
        "0 0\n1 0\n",
        "0,0\n1,0\n",
        "x;y\n0;0\n1;0\n",
        "name\ty\tx\na\t0\t0\nb\t0\t1\n",
    ];
    for table in tables {
        let found = folder.pipe("reconstruct - --quiet", table).fine();
        assert!(
            found.ends_with("0,open,,0,0,0\n0,open,,1,1,0\n"),
            "{table}: {found}"
        );
    }
    folder.write("points", "0 0\n1 0\n");
    folder.run("reconstruct points").fine();
}

#[test]
fn every_algorithm_is_listed_and_runs() {
    let folder = Folder::new();
    let points = fixture("points/open-and-closed.xy");
    let listed = json(&folder.run("algorithms --json").fine());
    let text = folder.run("algorithms").fine();
    for entry in listed["algorithms"].as_array().unwrap() {
        let name = entry["name"].as_str().unwrap();
        assert!(text.contains(&format!("{name}\n")), "{text}");
        let line = format!(
            "reconstruct {} --json -q --algorithm {name}",
            points.display()
        );
        let found = json(&folder.run(&line).fine());
        assert_eq!(found["algorithm"], name);
        assert!(!found["edges"].as_array().unwrap().is_empty());
    }
}

#[test]
fn neither_threads_nor_runs_show() {
    let folder = Folder::new();
    let points = fixture("points/sharp-angles.xy");
    for format in ["csv", "json", "geojson", "svg"] {
        let with = |threads: u32| {
            let points = points.display();
            folder
                .run(&format!(
                    "reconstruct {points} --to {format} --threads {threads}"
                ))
                .fine()
        };
        assert_eq!(with(1), with(2));
    }
}

#[test]
fn every_edge_and_every_open_end_has_its_reason() {
    let folder = Folder::new();
    // Two rows, of which the second ends far from the last point.
    folder.write(
        "rows.xy",
        "0 0\n1 0\n2 0\n3 0\n4 0\n0 9\n1 9\n2 9\n3 9\n16 9\n",
    );
    let found = json(&folder.run("reconstruct rows.xy --json --why").fine());
    let edges = found["edges"].as_array().unwrap();
    let reasons = found["reasons"].as_array().unwrap();
    assert_eq!(edges.len(), reasons.len());
    for (edge, why) in edges.iter().zip(reasons) {
        let is_certified = *edge != json!([3, 4]) && *edge != json!([7, 8]);
        assert_eq!(why["reason"] == "certified", is_certified, "{edge}");
        assert_eq!(why["margin_at_most"].is_null(), is_certified, "{edge}");
        assert!(is_certified || why["margin_at_most"].as_f64().unwrap() > 0.0);
    }
    let ends = found["open_ends"].as_array().unwrap();
    let of: Vec<_> = ends
        .iter()
        .map(|end| end["point"].as_u64().unwrap())
        .collect();
    assert_eq!(of, [0, 4, 5, 8, 9]);
    assert_eq!(
        (&ends[4]["partner"], &ends[4]["free_ends"]),
        (&json!(8), &json!(2))
    );
    assert!(ends[4]["cost_at_most"].as_f64().unwrap() > 0.0);

    // They take longer than the edges: nobody waits who does not ask.
    let found = json(&folder.run("reconstruct rows.xy --json").fine());
    assert!(found.get("reasons").is_none() && found.get("open_ends").is_none());
    let error = folder.run("reconstruct rows.xy --why").error();
    assert_eq!(
        error,
        "error: JSON alone has room for reasons: give --json with --why"
    );
    let picture = folder.run("draw --points rows.xy --edges --why").fine();
    for group in ["certified", "completed", "rejected"] {
        assert!(picture.contains(&format!("id=\"{group}\"")), "{picture}");
    }
    // Algorithms that follow from their definition have no reasons beyond it.
    for line in [
        "draw --points rows.xy --edges crust --why",
        "reconstruct rows.xy --algorithm crust --json --why",
    ] {
        let refused = folder.run(line).error();
        assert_eq!(
            refused,
            "error: crust gives no reasons for its edges: leave out --why"
        );
    }
}

#[test]
fn points_that_are_nearly_equal_are_named_and_merged() {
    let folder = Folder::new();
    let circle = |scale: f64| {
        (0..40).map(move |i| {
            let angle = f64::from(i) * std::f64::consts::TAU / 40.0;
            format!("{} {}\n", scale * angle.cos(), scale * angle.sin())
        })
    };
    let near: String = circle(1.0).chain(circle(1.0 + 1e-9).take(3)).collect();
    folder.write("near.xy", &near);
    let run = folder.run("reconstruct near.xy");
    assert!(
        run.stderr.contains(
            "points 0 and 40 are only 1.0e-9 apart, less than a millionth of the spacing, \
             and 2 more such pairs: --merge-within takes such points for one"
        ),
        "{}",
        run.stderr
    );
    for within in ["1e-7", "0.001%"] {
        let run = folder.run(&format!(
            "reconstruct near.xy --merge-within {within} --json"
        ));
        assert_eq!(
            run.stderr,
            "40 points (3 duplicates merged), 40 edges: 1 chain, 1 ring, 0 leaves, 0 isolated points, \
             0 violations\n"
        );
        let found = json(&run.fine());
        // Those of smaller x stand, and every row keeps its place.
        assert_eq!(found["points"].as_array().unwrap().len(), 43);
        assert_ne!(found["points"][0], found["points"][40]);
        assert_eq!(found["duplicates"][0], json!({ "point": 40, "same_as": 0 }));
    }
}

#[test]
fn points_that_scatter_are_said_to() {
    let folder = Folder::new();
    let noisy: String = (0_u32..200)
        .map(|i| {
            let angle = f64::from(i) * std::f64::consts::TAU / 200.0;
            let radius = 1.0 + 0.15 * f64::from((17 * i * i + 5 * i) % 101) / 101.0;
            format!("{} {}\n", radius * angle.cos(), radius * angle.sin())
        })
        .collect();
    folder.write("noisy.xy", &noisy);
    let run = folder.run("reconstruct noisy.xy");
    assert!(
        run.stderr.contains("may scatter about their curves"),
        "{}",
        run.stderr
    );
}
