//! Every row of the table of bad input in `docs/formats.md`.

use crate::harness::{Folder, Run};

/// The error about a file of that name and content.
#[track_caller]
pub(crate) fn error(name: &str, content: impl AsRef<[u8]>) -> String {
    let folder = Folder::with(name, content);
    let error = folder.run(&format!("reconstruct {name}")).error();
    error.strip_prefix("error: ").unwrap().to_owned()
}

#[test]
fn nothing_at_all() {
    for name in ["p.csv", "p.xy"] {
        assert_eq!(error(name, ""), format!("{name}: there are no points"));
        assert_eq!(
            error(name, "# nothing\n"),
            format!("{name}: there are no points")
        );
    }
    assert_eq!(error("p.csv", "x,y\n"), "p.csv: there are no points");
}

#[test]
fn lines_that_are_no_points() {
    assert_eq!(
        error("p.csv", "x,y\n1,2\n3\n"),
        "p.csv, line 3: a point is x and y, but here is only `3`"
    );
    assert_eq!(
        error("p.xy", "1 2\n3\n"),
        "p.xy, line 2: a point is x and y, but here is only `3`"
    );
    assert_eq!(
        error("p.xy", "1 2\n3 4 5\n"),
        "p.xy, line 2, column 5: a point is x and y, but `5` follows"
    );
    assert_eq!(
        error("p.csv", "x,y\n1,2\n3,4,5\n"),
        "p.csv, line 3: the line has 3 columns, the first has 2"
    );
    assert_eq!(
        error("p.csv", "1,2,3,4\n"),
        "p.csv, line 1: 4 columns without names: head those of the coordinates x and y"
    );
    assert_eq!(
        error("p.csv", "a,b\n1,2\n"),
        "p.csv, line 1: no columns are named x and y: there are `a`, `b`; \
         pass --x and --y with two of them"
    );
    assert_eq!(
        error("p.csv", "x,y,X\n1,2,3\n"),
        "p.csv, line 1: `x`, `X` could both be meant: pass --x and --y with the names of two columns"
    );
    assert_eq!(
        error("p.xy", "1 2 3\n4 5\n"),
        "p.xy, line 2: the line has 2 columns, the first has 3"
    );
}

#[test]
fn lines_are_counted_as_editors_do() {
    for (content, line) in [
        ("x,y\r\n1,2\r\nfoo,3\r\n", 3),
        ("x,y\n# one\n\n# two\nfoo,3\n", 5),
        ("# one\r\n\r\nx,y\r\n\r\nfoo,3", 5),
        ("name,x,y\n\"two\nlines\",1,2\na,foo,3\n", 4),
    ] {
        let found = error("p.csv", content);
        assert!(
            found.starts_with(&format!("p.csv, line {line}, field ")),
            "{found}"
        );
    }
    assert_eq!(
        error("p.csv", "x,y\r\n\r\n1\r\n"),
        "p.csv, line 3: a point is x and y, but here is only `1`"
    );
}

/// The first 4,096 bytes hold nothing but a comment.
#[test]
fn long_comments_hide_nothing() {
    let comment = format!("# {}\n", "a, b; ".repeat(1000));
    for (name, content) in [
        ("p.tsv", "x\ty\n1\t2\n"),
        ("nameless", "1;2\n"),
        ("nameless", "1 2\n"),
        ("nameless", "[[1, 2]]"),
    ] {
        let folder = Folder::with(name, comment.clone() + content);
        let run = folder.run(&format!("reconstruct {name}"));
        if content.starts_with('[') {
            // JSON has no comments: it is known, and refused as what it is.
            let error = run.error();
            assert!(
                error.starts_with("error: nameless, line 1, column 1: "),
                "{error}"
            );
        } else {
            assert!(run.fine().ends_with(",0,1,2\n"));
        }
    }
    let named = "\"a; b\",x,y\n1,2,3\n";
    let folder = Folder::with("p.csv", named);
    assert!(folder.run("reconstruct p.csv").fine().ends_with(",0,2,3\n"));
}

#[test]
fn text_where_a_number_should_be() {
    assert_eq!(
        error("p.csv", "name,x,y\na,1,2\nb,3,four\n"),
        "p.csv, line 3, field 3: `four` is not a number"
    );
    assert_eq!(
        error("p.xy", "1 2\n\n  3   four\n"),
        "p.xy, line 3, column 7: `four` is not a number"
    );
    assert_eq!(
        error("p.xy", "1 2\n3 4\0\n"),
        "p.xy, line 2, column 3: `4\\0` is not a number"
    );
    assert_eq!(
        error("p.csv", "1,2\n3,\0\n"),
        "p.csv, line 2, field 2: `\\0` is not a number"
    );
}

#[test]
fn numbers_that_are_no_coordinates() {
    for bad in ["NaN", "inf", "-inf", "1e400"] {
        assert_eq!(
            error("p.csv", format!("x,y\n1,{bad}\n")),
            format!("p.csv, line 2, field 2: `{bad}` is not a finite number")
        );
        assert_eq!(
            error("p.xy", format!("{bad} 1\n")),
            format!("p.xy, line 1, column 1: `{bad}` is not a finite number")
        );
    }
    for bad in ["1e300", "1e-300"] {
        let found = error("p.xy", format!("1 {bad}\n"));
        let says = format!("p.xy, line 1, column 3: `{bad}` is out of range: scale the points");
        assert!(found.starts_with(&says), "{found}");
    }
}

#[test]
fn text_of_other_systems_is_read() {
    for content in ["\u{feff}x,y\r\n1,2\r\n3,4\r\n", "\u{feff}1,2\n3,4"] {
        let folder = Folder::with("p.csv", content);
        let found = folder.run("reconstruct p.csv -q").fine();
        assert!(found.ends_with("0,1,2\n0,open,,1,3,4\n"), "{found}");
    }
    Folder::with("p.xy", "\u{feff}1 2\r\n3\t4\r\n")
        .run("reconstruct p.xy")
        .fine();
    assert_eq!(
        error("p.csv", b"\xff\xfe1\0,\x002\0"),
        "p.csv: the text is UTF-16: save it as UTF-8"
    );
}

#[test]
fn arrays_that_hold_no_points() {
    for (content, says) in [
        (
            "[[1, 2], [3]]",
            "line 1, column 12: a point is [x, y], but here is less",
        ),
        (
            "[[1, 2],\n[3, 4, 5]]",
            "line 2, column 9: a point is [x, y], but here is more",
        ),
        (
            "[[1, \"b\"]]",
            "line 1, column 8: invalid type: string \"b\", expected f64",
        ),
        (
            "[[1, null]]",
            "line 1, column 9: invalid type: null, expected f64",
        ),
        ("[[1, 1e400]]", "line 1, column 10: number out of range"),
        ("[[1, 2]", "line 1, column 7: EOF while parsing a list"),
        (
            "{\"a\": 1}",
            "the object has neither `points` nor `samples`, nor is it GeoJSON",
        ),
    ] {
        let found = error("p.json", content);
        let found = found
            .strip_prefix("p.json")
            .unwrap()
            .trim_start_matches([':', ',', ' ']);
        assert_eq!(found, says);
    }
    assert_eq!(error("p.json", "[]"), "p.json: there are no points");
}

#[test]
fn geojson_that_holds_no_points() {
    let says =
        "p.geojson: it holds a LineString, which is no point: pass --vertices to take its vertices";
    let line = r#"{"type": "LineString", "coordinates": [[1, 2], [3, 4]]}"#;
    assert_eq!(error("p.geojson", line), says);
    let feature = format!(r#"{{"type": "Feature", "properties": {{}}, "geometry": {line}}}"#);
    assert_eq!(error("p.geojson", feature), says);
    assert_eq!(
        error("p.geojson", r#"{"type": "Point", "coordinates": [1]}"#),
        "p.geojson: A position must contain two or more elements, but got `1`"
    );
    let far = |x| format!(r#"{{"type": "MultiPoint", "coordinates": [[1, 2], [{x}, 0]]}}"#);
    let feature =
        |g: &str| format!(r#"{{"type": "Feature", "properties": {{}}, "geometry": {g}}}"#);
    let features = [feature(&far("3")), feature(&far("1e300"))].join(",");
    let collection = format!(r#"{{"type": "FeatureCollection", "features": [{features}]}}"#);
    for (content, place) in [
        (far("1e300"), "position 2"),
        (collection, "feature 2, position 2"),
    ] {
        let found = error("p.geojson", content);
        let says = format!("p.geojson, {place}: `1e300` is out of range");
        assert!(found.starts_with(&says), "{found}");
    }
    assert_eq!(
        error(
            "p.geojson",
            "{\"type\": \"Point\",\n\"coordinates\": [1, \"b\"]}"
        ),
        "p.geojson, line 2, column 22: invalid type: string \"b\", expected f64"
    );
    assert_eq!(
        error(
            "p.geojson",
            r#"{"type": "FeatureCollection", "features": []}"#
        ),
        "p.geojson: there are no points"
    );
}

#[test]
fn numpy_arrays_that_hold_no_points() {
    let npy = |descr: &str, shape: &str, numbers: &[u8]| {
        let header = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}\n");
        let length = u16::try_from(header.len()).unwrap().to_le_bytes();
        [
            b"\x93NUMPY\x01\x00",
            &length[..],
            header.as_bytes(),
            numbers,
        ]
        .concat()
    };
    let ones: Vec<u8> = [1.0f64; 4].iter().flat_map(|v| v.to_le_bytes()).collect();
    for (content, says) in [
        (
            npy("'<f8'", "(2, 2)", &ones[..31]),
            "the array is cut off before the end of its 2 rows",
        ),
        (
            npy("'<f8'", "(2, 2)", &[&ones[..], b"!"].concat()),
            "the file goes on after the 2 rows of its array",
        ),
        (
            npy("'<f8'", "(4,)", &ones),
            "the shape is (4,): points have the shape (n, 2)",
        ),
        (
            npy("'<f8'", "(4294967295, 2)", &ones),
            "the array has 4294967295 rows: at most 4294967294 points are read at once",
        ),
        (
            npy("'<f8'", "(1, 4)", &ones),
            "the shape is (1, 4): points have the shape (n, 2)",
        ),
        (
            npy("'<i8'", "(2, 2)", &ones),
            "the numbers are `<i8`: save them as float64 or float32",
        ),
        (
            npy("[('x', '<f8')]", "(2, 2)", &ones),
            "the numbers are `[('x', '<f8')]`: save them as float64 or float32",
        ),
        (npy("'<f8'", "(0, 2)", &[]), "there are no points"),
        (b"\x93NUMPY\x01\x00\x10".to_vec(), "this is no NumPy array"),
        (b"1 2\n".to_vec(), "this is no NumPy array"),
        (
            npy("'<f8'", "(99999999999999999999, 2)", &ones),
            "the shape is (99999999999999999999, 2): points have the shape (n, 2)",
        ),
    ] {
        assert_eq!(error("p.npy", content), format!("p.npy: {says}"));
    }
    let nan: Vec<u8> = [1.0, f64::NAN]
        .iter()
        .flat_map(|v: &f64| v.to_le_bytes())
        .collect();
    assert_eq!(
        error("p.npy", npy("'<f8'", "(1, 2)", &nan)),
        "p.npy, row 1, column 2: `NaN` is not a finite number"
    );
    let far: Vec<u8> = [1e-300f64, 2.0]
        .iter()
        .flat_map(|v| v.to_le_bytes())
        .collect();
    let found = error("p.npy", npy("'<f8'", "(1, 2)", &far));
    assert!(
        found.starts_with("p.npy, row 1, column 1: `1e-300` is out of range"),
        "{found}"
    );
    let maybe = b"{'descr': '<f8', 'fortran_order': Maybe, 'shape': (0, 2), }";
    let maybe = [
        &b"\x93NUMPY\x01\x00"[..],
        &[u8::try_from(maybe.len()).unwrap(), 0],
        maybe,
    ]
    .concat();
    assert_eq!(
        error("p.npy", maybe),
        "p.npy: `fortran_order` is `Maybe`: it has to be True or False"
    );
    // Cut off at 64 KiB, the header would still have all its keys.
    let header = "{'descr': '<f8', 'fortran_order': False, 'shape': (0, 2), }".to_owned();
    let header = header + &" ".repeat(1 << 16);
    let length = u32::try_from(header.len()).unwrap().to_le_bytes();
    let long = [&b"\x93NUMPY\x02\x00"[..], &length, header.as_bytes()].concat();
    assert_eq!(
        error("p.npy", long),
        "p.npy: the header of the array is more than 65536 bytes long"
    );
}

#[test]
fn formats_that_hold_no_points() {
    assert_eq!(
        error("p.dxf", "0\n"),
        "p.dxf: points cannot be read from dxf: use csv, text, json, geojson, wkt, gpx, kml, obj, npy, svg, npz, ply, wkb, shapefile, \
         las, flatgeobuf or parquet"
    );
}

#[test]
fn no_file() {
    let folder = Folder::new();
    assert_eq!(
        folder.run("reconstruct gone.csv").error(),
        "error: gone.csv: No such file or directory (os error 2)"
    );
    assert_eq!(
        folder.run("reconstruct .").error(),
        "error: .: Is a directory (os error 21)"
    );
    assert_eq!(
        folder.run("reconstruct -").error(),
        "error: stdin: there are no points"
    );
}

#[cfg(unix)]
#[test]
fn stdin_closed() {
    use std::process::Command;
    let program = env!("CARGO_BIN_EXE_curvecrust");
    let line = format!("exec '{program}' reconstruct - <&-");
    let run: Run = Command::new("sh")
        .args(["-c", &line])
        .output()
        .unwrap()
        .into();
    assert_eq!(run.error(), "error: stdin: there are no points");
}
