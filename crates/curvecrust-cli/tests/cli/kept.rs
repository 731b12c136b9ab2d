//! What is carried along with the points: heights, and the reference system.

use crate::harness::{Folder, json};
use serde_json::{Value, json};

/// A square with heights, as tables and texts have them.
const SQUARES: &[(&str, &str)] = &[
    ("named.csv", "z,x,y\n1,0,0\n2,2,0\n3,2,2\n4.5,0,2\n"),
    (
        "height.csv",
        "x;y;Height (m)\n0;0;1\n2;0;2\n2;2;3\n0;2;4,5\n",
    ),
    ("p.xy", "0 0 1\n2 0 2\n2 2 3\n0 2 4.5\n"),
    ("p.json", "[[0,0,1],[2,0,2],[2,2,3],[0,2,4.5]]"),
    (
        "objects.json",
        r#"[{"x":0,"y":0,"z":1},{"z":2,"x":2,"y":0},{"x":2,"y":2,"Z":3},{"x":0,"y":2,"z":4.5}]"#,
    ),
    ("p.obj", "v 0 0 1\nv 2 0 2\nv 2 2 3\nv 0 2 4.5\n"),
    (
        "p.kml",
        "<kml><LineString><coordinates>0,0,1 2,0,2 2,2,3 0,2,4.5 0,0,1</coordinates></LineString></kml>",
    ),
    #[cfg(feature = "ply")]
    (
        "p.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float z\n\
         property float y\nend_header\n0 1 0\n2 2 0\n2 3 2\n0 4.5 2\n",
    ),
];

fn heights() -> Value {
    json!([1.0, 2.0, 3.0, 4.5])
}

#[test]
fn heights_are_read_where_they_are_wanted() {
    for (name, content) in SQUARES {
        let folder = Folder::with(name, content);
        let line = match *name {
            "p.kml" => format!("reconstruct {name} --vertices --keep z --json"),
            _ => format!("reconstruct {name} --keep z --json"),
        };
        let run = folder.run(&line);
        let (heights_are, z_is) = ("heights are left out", "`z` is left out");
        let message = &run.stderr;
        assert!(
            !message.contains(heights_are) && !message.contains(z_is),
            "{name}: {message}"
        );
        let found = json(&run.fine());
        assert_eq!(found["z"], heights(), "{name}");
        assert_eq!(
            found["points"],
            json!([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]),
            "{name}"
        );
        // They change nothing else.
        let run = folder.run(&line.replace(" --keep z", ""));
        let mut plain = json(&run.fine());
        plain["z"] = heights();
        assert_eq!(plain, found, "{name}");
    }
}

/// The formats that hold heights, each with what it writes of the square.
const WRITTEN: &[(&str, &str)] = &[
    ("csv", "0,ring,0,3,0,2,4.5\n"),
    ("wkt", "POLYGON Z((0 0 1, 2 0 2, 2 2 3, 0 2 4.5, 0 0 1))\n"),
    (
        "geojson",
        "[[[0.0,0.0,1.0],[2.0,0.0,2.0],[2.0,2.0,3.0],[0.0,2.0,4.5],[0.0,0.0,1.0]]]",
    ),
    ("gpx", "<trkpt lat=\"2\" lon=\"0\"><ele>4.5</ele></trkpt>"),
    ("dxf", "VERTEX\n8\nrings\n70\n32\n10\n0\n20\n2\n30\n4.5\n"),
];

#[test]
fn heights_are_written() {
    let folder = Folder::with("p.xy", "0 0 1\n2 0 2\n2 2 3\n0 2 4.5\n");
    for (format, expected) in WRITTEN {
        folder
            .run(&format!("reconstruct p.xy --keep z -o out.{format}"))
            .fine();
        let written = folder.read(&format!("out.{format}"));
        assert!(written.contains(expected), "{format}: {written}");
    }
    for format in ["svg", "npy"] {
        let error = folder
            .run(&format!("reconstruct p.xy --keep z -o out.{format}"))
            .error();
        assert_eq!(
            error,
            format!("error: {format} holds no heights: leave out --keep")
        );
    }
}

#[test]
fn heights_come_back_from_every_format_of_geometries() {
    let folder = Folder::with("p.xy", "0 0 1\n2 0 2\n2 2 3\n0 2 4.5\n");
    let formats = [
        "geojson",
        "wkt",
        "gpx",
        #[cfg(feature = "wkb")]
        "wkb",
        #[cfg(feature = "flatgeobuf")]
        "fgb",
        #[cfg(feature = "parquet")]
        "parquet",
    ];
    for format in formats {
        folder
            .run(&format!("reconstruct p.xy --keep z -o out.{format}"))
            .fine();
        // A track has no closed lines.
        let repeated = if format == "gpx" {
            " --merge-duplicates"
        } else {
            ""
        };
        let line = format!("reconstruct out.{format} --vertices --keep z --json{repeated}");
        let found = json(&folder.run(&line).fine());
        let mut expected = heights();
        if format == "gpx" {
            expected = json!([1.0, 2.0, 3.0, 4.5, 1.0]);
        }
        assert_eq!(found["z"], expected, "{format}");
    }
}

#[test]
fn merged_points_have_the_height_of_the_one_that_stands_for_them() {
    let folder = Folder::with("p.csv", "x,y,z\n0,0,1\n1,0,2\n0,0,9\n1,1,3\n");
    let table = folder
        .run("reconstruct p.csv --keep z --merge-duplicates")
        .fine();
    assert!(table.contains(",0,0,0,1\n"), "{table}");
    assert!(!table.contains(",9\n"), "{table}");
    let object = json(
        &folder
            .run("reconstruct p.csv --keep z --merge-duplicates --json")
            .fine(),
    );
    assert_eq!(object["z"], json!([1.0, 2.0, 9.0, 3.0]));
}

#[test]
fn a_point_without_a_height_is_named() {
    for (name, content, expected) in [
        (
            "p.csv",
            "x,y\n1,2\n",
            "p.csv, line 2: there is no height to keep",
        ),
        (
            "p.xy",
            "1 2\n3 4\n",
            "p.xy, line 1: there is no height to keep",
        ),
        (
            "p.csv",
            "x,y,z\n1,2,3\n4,5,\n",
            "p.csv, line 3, field 3: `` is not a number",
        ),
        (
            "p.csv",
            "x,y,z\n1,2,nan\n",
            "p.csv, line 2, field 3: `NaN` is not a finite number",
        ),
        (
            "p.json",
            r#"[{"x":1,"y":2,"z":3},{"x":4,"y":5}]"#,
            "p.json, point 2: there is no height to keep",
        ),
        (
            "p.wkt",
            "MULTIPOINT (1 2)",
            "p.wkt, line 1: there is no height to keep",
        ),
        (
            "p.gpx",
            "<gpx>\n<wpt lat=\"1\" lon=\"2\"><ele>high</ele></wpt></gpx>",
            "p.gpx, line 2: `high` is not a number",
        ),
        (
            "p.svg",
            r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>"#,
            "p.svg: there is no height to keep",
        ),
    ] {
        let folder = Folder::with(name, content);
        let error = folder.run(&format!("reconstruct {name} --keep z")).error();
        assert_eq!(error, format!("error: {expected}"));
    }
}

/// An open curve that nearly closes, and a ring: ends that are near each other are told.
#[test]
fn the_ends_of_open_curves_are_marked_and_taken() {
    let arc = "M 3 2 A 1 1 0 1 1 2.9 1.6";
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="{arc}"/><circle cx="9" r="1"/></svg>"#
    );
    let folder = Folder::with("arc.svg", svg);
    let run = folder.run("sample arc.svg --rho 0.5 -o s.csv");
    let says = "arc.svg: 1 curve is open, which no theorem covers; the ends are marked, for \
                `reconstruct --termini-from`";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    let table = folder.read("s.csv");
    assert!(
        table.starts_with("curve,x,y,terminus\n0,3,2,1\n"),
        "{table}"
    );
    assert_eq!(table.lines().filter(|line| line.ends_with(",1")).count(), 2);
    folder.run("sample arc.svg --rho 0.5 -o s.json").fine();
    let termini = json(&folder.read("s.json"))["termini"].clone();
    let count = termini.as_array().unwrap().len();
    assert_eq!(count, 2);
    let checked = folder.run("check arc.svg s.csv --rho 0.5 --json");
    assert!(
        checked.stderr.contains("1 curve is open"),
        "{}",
        checked.stderr
    );
    assert_eq!(json(&checked.fine())["termini"], termini);
    for from in ["s.csv", "s.json"] {
        let line = format!("reconstruct s.csv --termini-from {from} --json");
        let found = json(&folder.run(&line).fine());
        assert_eq!(found["known"]["termini"], termini, "{from}");
        assert_eq!(found["leaves"], termini, "{from}");
    }
    // Without marks all points are ends.
    folder.write("ends.xy", "3 2\n");
    let found = json(
        &folder
            .run("reconstruct s.csv --termini-from ends.xy --json")
            .fine(),
    );
    assert_eq!(found["known"]["termini"], json!([0]));
    folder.write("ends.xy", "3 2\n7 7\n");
    assert_eq!(
        folder
            .run("reconstruct s.csv --termini-from ends.xy")
            .error(),
        "error: ends.xy: there is no point at (7, 7)"
    );
    folder.write("bad.json", r#"{"points": [[1, 2]], "termini": [1]}"#);
    assert_eq!(
        folder
            .run("reconstruct s.csv --termini-from bad.json")
            .error(),
        "error: bad.json: `termini` names the point 1, which is not there"
    );
    // Closed curves have none.
    folder.write(
        "ring.svg",
        r#"<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>"#,
    );
    let run = folder.run("sample ring.svg --rho 0.5");
    assert!(!run.stderr.contains("open"), "{}", run.stderr);
    assert!(run.fine().starts_with("curve,x,y\n"));
}

/// A line in metres, as GeoJSON had it before RFC 7946.
const METRES: &str = r#"{"type":"FeatureCollection",
    "crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},
    "features":[{"type":"Feature","properties":null,
    "geometry":{"type":"MultiPoint","coordinates":[[1000,0],[2000,0],[3000,0]]}}]}"#;

#[test]
fn the_reference_system_goes_along() {
    let folder = Folder::with("p.geojson", METRES);
    let formats = [
        "geojson",
        #[cfg(feature = "wkb")]
        "wkb",
        #[cfg(feature = "flatgeobuf")]
        "fgb",
    ];
    for format in formats {
        folder
            .run(&format!("reconstruct p.geojson -o out.{format}"))
            .fine();
        let run = folder.run(&format!("reconstruct out.{format} --vertices"));
        assert!(run.stderr.contains("25832\n"), "{format}: {}", run.stderr);
        if format == "fgb" {
            // Whose code it is, with the length in front.
            let bytes = std::fs::read(folder.path().join("out.fgb")).unwrap();
            assert!(bytes.windows(8).any(|word| word == b"\x04\0\0\0EPSG"));
        }
    }
    let message = folder.run("reconstruct p.geojson -o out.wkt").stderr;
    assert!(!message.contains("left out"), "{message}");
}

#[cfg(feature = "parquet")]
#[test]
fn geoparquet_has_projjson_or_says_that_it_has_none() {
    let folder = Folder::with("p.geojson", METRES);
    let message = folder.run("reconstruct p.geojson -o out.parquet").stderr;
    let note = "the reference system EPSG:25832 is left out: parquet takes it as PROJJSON alone\n";
    assert!(message.contains(note), "{message}");
    let message = folder.run("reconstruct out.parquet --vertices").stderr;
    assert!(!message.contains("reference system"), "{message}");
    folder.write("p.geojson", METRES.replace("25832", "4326"));
    let message = folder
        .run("reconstruct p.geojson -o degrees.parquet")
        .stderr;
    assert!(!message.contains("left out"), "{message}");
    let message = folder.run("reconstruct degrees.parquet --vertices").stderr;
    assert!(message.contains("OGC:CRS84"), "{message}");
}

#[cfg(feature = "shapefile")]
#[test]
fn a_code_is_found_in_well_known_text() {
    let text = r#"PROJCS["UTM",GEOGCS["E",AUTHORITY["EPSG","4258"]],UNIT["m",1]AUTHORITY_"#;
    let cases = [
        (
            text.replace("AUTHORITY_", r#",AUTHORITY["EPSG","25832"]]"#),
            true,
        ),
        (text.replace("AUTHORITY_", "]"), false),
        (
            r#"PROJCRS["UTM",BASEGEOGCRS["E",ID["EPSG",4258]],ID["EPSG",25832]]"#.to_owned(),
            true,
        ),
    ];
    for (text, has_code) in cases {
        let points = crate::shapes::of_points(&[[1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]);
        let folder = Folder::with("p.shp", points);
        folder.write("p.prj", &text);
        let message = folder.run("reconstruct p.shp -o out.geojson").stderr;
        assert_eq!(!message.contains("left out"), has_code, "{text}: {message}");
        assert_eq!(folder.read("out.geojson").contains("EPSG::25832"), has_code);
    }
}
