//! Tables as people have them.

use crate::harness::{Folder, Run, json};

/// What is read from a file, and what is noted about it.
fn read(name: &str, content: &str, options: &str) -> (Vec<[f64; 2]>, Vec<String>) {
    let folder = Folder::with(name, content);
    let run = folder.run(&format!("reconstruct {name} --json {options}"));
    let notes = notes(&run, name);
    let object = json(&run.fine());
    (
        serde_json::from_value(object["points"].clone()).unwrap(),
        notes,
    )
}

/// The lines of stderr that are about the file.
fn notes(run: &Run, name: &str) -> Vec<String> {
    let lines = run.stderr.lines();
    let start = format!("{name}: ");
    let notes = lines.filter_map(|line| line.strip_prefix(&start));
    notes.map(str::to_owned).collect()
}

const TWO: [[f64; 2]; 2] = [[1.5, 2.5], [3.0, 4.0]];

#[test]
fn columns_are_known_by_many_names() {
    for [x, y] in [
        ["lon", "lat"],
        ["Longitude", "Latitude"],
        ["Easting", "Northing"],
        ["X (m)", "Y (m)"],
        ["x [mm]", "y [mm]"],
    ] {
        let table = format!("{y},id,{x}\n2.5,0,1.5\n4,1,3\n");
        let degrees = if x.starts_with(['l', 'L']) {
            ": lengths are in degrees"
        } else {
            ""
        };
        let note = format!("x is the column `{x}`, y is `{y}`{degrees}");
        assert_eq!(read("p.csv", &table, ""), (TWO.to_vec(), vec![note]));
    }
    // As plain as can be: nothing to note.
    for [x, y] in [["x", "y"], ["X", "Y"]] {
        let table = format!("curve;{x};{y}\n0;1.5;2.5\n1;3;4\n");
        assert_eq!(read("p.csv", &table, ""), (TWO.to_vec(), vec![]));
    }
    // Of two pairs, the first.
    let both = "lon,lat,x,y\n0,0,1.5,2.5\n0,0,3,4\n";
    assert_eq!(read("p.csv", both, ""), (TWO.to_vec(), vec![]));
    let text = "  name easting northing\n a 1.5 2.5\n b 3 4\n";
    assert_eq!(read("p.xy", text, "").0, TWO);
}

/// What stands in quotes neither ends a line nor separates columns.
#[test]
fn names_of_columns_may_be_in_quotes() {
    for name in [
        "\"name\nof the\npoint\"",
        "\"name;\tof\nthe\n\"\"best\"\" point\"",
    ] {
        let table = format!("{name},x,y\np,1.5,2.5\nq,3,4\n");
        assert_eq!(read("p.csv", &table, ""), (TWO.to_vec(), vec![]));
    }
}

#[test]
fn columns_can_be_named() {
    let table = "x,y,u,V\n0,0,1.5,2.5\n0,0,3,4\n";
    let note = "x is the column `u`, y is `V`".to_owned();
    assert_eq!(
        read("p.csv", table, "--x u --y v"),
        (TWO.to_vec(), vec![note])
    );
    let folder = Folder::with("p.csv", table);
    folder.write("p.json", "[[1, 2]]");
    folder.write("bare.csv", "1,2\n");
    let error = |line: &str| folder.run(line).error();
    assert_eq!(
        error("reconstruct p.csv --x u --y w"),
        "error: p.csv, line 1: no column is named `w`: there are `x`, `y`, `u`, `V`"
    );
    assert_eq!(
        error("reconstruct bare.csv --x u --y v"),
        "error: bare.csv, line 1: no column is named `u`: there are `1`, `2`"
    );
    assert_eq!(
        error("reconstruct p.json --x u --y v"),
        "error: p.json: --x and --y name columns of tables, but this is json"
    );
    let run = folder.run("reconstruct p.csv --x u");
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("--y <NAME>"), "{}", run.stderr);
    folder.run("draw --points p.csv --x u --y v").fine();
}

#[test]
fn heights_are_left_out_and_noted() {
    let third = "of three columns without names, the third is left out";
    let heights = "heights are left out";
    let geojson = r#"{"type": "MultiPoint", "coordinates": [[1.5, 2.5, 9], [3, 4, 9]]}"#;
    for (name, content, note) in [
        ("p.csv", "1.5,2.5,9\n3,4,9\n", third),
        ("p.xy", "1.5 2.5 9\n3 4 9\n", third),
        ("p.csv", "x,y,z\n1.5,2.5,9\n3,4,9\n", "`z` is left out"),
        ("p.json", "[[1.5, 2.5, 9], [3, 4, 9]]", heights),
        ("p.geojson", geojson, heights),
    ] {
        let found = read(name, content, "");
        assert_eq!(found, (TWO.to_vec(), vec![note.to_owned()]), "{content}");
    }
    let numbers = [1.5, 2.5, 9.0, 3.0, 4.0, 9.0f64];
    let fields = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }";
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(u16::try_from(fields.len()).unwrap().to_le_bytes());
    bytes.extend(fields.bytes());
    bytes.extend(numbers.iter().flat_map(|v| v.to_le_bytes()));
    let folder = Folder::with("p.npy", bytes);
    let run = folder.run("reconstruct p.npy --json");
    assert_eq!(notes(&run, "p.npy"), [heights]);
    assert_eq!(json(&run.fine())["points"], serde_json::json!(TWO));
}

#[test]
fn decimals_may_follow_a_comma() {
    for content in [
        "1,5;2,5\n3;4\n",
        "x;y\n1,5;2,5\n3,0;4\n",
        "1,5\t2,5\n3\t4,0\n",
        "\"x, m\";x;y\n\"1, 2\";1,5;2,5\n;3,0;4\n",
    ] {
        for name in ["p.csv", "p.txt", "nameless"] {
            assert_eq!(read(name, content, "").0, TWO, "{content}");
        }
    }
    // Where commas are between the columns, they are in no number.
    let error = Folder::with("p.csv", "1,5,2,5\n")
        .run("reconstruct p.csv")
        .error();
    assert!(error.contains("4 columns without names"), "{error}");
    let error = Folder::with("p.csv", "x;y\n1.234,5;2\n")
        .run("reconstruct p.csv")
        .error();
    assert!(error.ends_with("`1.234,5` is not a number"), "{error}");
}

#[test]
fn text_may_have_commas() {
    for content in ["1.5, 2.5\n3, 4\n", "1.5,2.5\n3,4\n", "1.5; 2.5\n3; 4\n"] {
        assert_eq!(
            read("p.txt", content, ""),
            (TWO.to_vec(), vec![]),
            "{content}"
        );
    }
}

#[test]
fn a_title_is_left_out_and_noted() {
    let note = "line 1 is taken for a title";
    for (name, content) in [
        ("wing.dat", "NACA 0012\n1.5 2.5\n3 4\n"),
        ("wing.dat", "CLARK Y\n  1.5  2.5\n  3  4\n"),
        ("wing.dat", "Clark Y, smoothed by hand\n\n1.5 2.5\n3 4\n"),
        ("p.csv", "My points\nx,y\n1.5,2.5\n3,4\n"),
        ("p.csv", "My points\n1.5,2.5\n3,4\n"),
    ] {
        let found = read(name, content, "");
        assert_eq!(found, (TWO.to_vec(), vec![note.to_owned()]), "{content}");
    }
    // A bad point is no title.
    for (name, content) in [("p.csv", "foo,1\n1,2\n"), ("p.xy", "id px py\n0 1 2\n")] {
        let folder = Folder::with(name, content);
        folder.run(&format!("reconstruct {name}")).error();
    }
}

#[test]
fn a_ring_may_end_where_it_starts() {
    let ring = "0 0\n1 0\n1 1\n0 1\n0 0\n";
    let folder = Folder::with("p.xy", ring);
    let run = folder.run("reconstruct p.xy --json");
    assert_eq!(
        notes(&run, "p.xy"),
        ["the last point repeats the first, which stands for both"]
    );
    let object = json(&run.fine());
    assert_eq!(object["points"].as_array().unwrap().len(), 5);
    let duplicates = serde_json::json!([{"point": 4, "same_as": 0}]);
    assert_eq!(object["duplicates"], duplicates);
    assert_eq!(object["edges"].as_array().unwrap().len(), 4);
    // Others stay an error.
    let twice = folder
        .pipe("reconstruct -", "0 0\n1 0\n1 0\n0 1\n0 0\n")
        .error();
    assert!(twice.contains("points 1 and 2 are both (1, 0)"), "{twice}");
}
