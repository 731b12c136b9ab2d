//! Points as other programs write them.

use crate::harness::{Folder, json};
use serde_json::json;

/// The points that `reconstruct` reads, and what it says.
#[track_caller]
pub(crate) fn read(
    name: &str,
    content: impl AsRef<[u8]>,
    options: &str,
) -> (serde_json::Value, String) {
    let folder = Folder::with(name, content);
    let run = folder.run(&format!("reconstruct {name} --json {options}"));
    let stderr = run.stderr.clone();
    (json(&run.fine())["points"].clone(), stderr)
}

#[track_caller]
pub(crate) fn error(name: &str, content: impl AsRef<[u8]>, options: &str) -> String {
    let folder = Folder::with(name, content);
    folder.run(&format!("reconstruct {name} {options}")).error()
}

#[test]
fn well_known_text() {
    let text = "POINT (1 2)\n# more\nMULTIPOINT Z ((3 4 5),\n (5 6 1))\n\
                SRID=4326;GEOMETRYCOLLECTION (POINT EMPTY, POINT (7 8));\n";
    let (points, message) = read("points.wkt", text, "");
    assert_eq!(
        points,
        json!([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]])
    );
    assert!(
        message.contains("points.wkt: heights are left out"),
        "{message}"
    );
    // Without a name that tells.
    assert_eq!(read("points", text, "").0, points);
    let ring = "POLYGON ((0 0, 4 0, 4 4, 0 0), (1 1, 2 1, 2 2, 1 1))";
    assert_eq!(
        error("ring.wkt", ring, ""),
        "error: ring.wkt, line 1: it holds a POLYGON, which is no point: pass --vertices to take \
         its vertices"
    );
    let (points, message) = read("ring.wkt", ring, "--vertices");
    assert_eq!(points.as_array().unwrap().len(), 6);
    let note =
        "ring.wkt: the last vertices of 2 closed lines repeat the first ones and are left out";
    assert!(message.contains(note), "{message}");
    let open = error("open.wkt", "\nPOINT (1 2\n", "");
    assert_eq!(
        open,
        "error: open.wkt, line 2: this is no well-known text: a bracket is not closed"
    );
    let deep = format!(
        "{}POINT (1 2){}",
        "GEOMETRYCOLLECTION(".repeat(90),
        ")".repeat(90)
    );
    assert!(error("deep.wkt", &deep, "").contains("brackets in brackets"));
    let far = error("far.wkt", "POINT (1 2)\nPOINT (1e999 2)\n", "");
    assert!(far.starts_with("error: far.wkt, line 2: "), "{far}");
    let word = error("word.wkt", "POINT (1 two)\n", "");
    assert!(
        word.starts_with("error: word.wkt, line 1: this is no well-known"),
        "{word}"
    );
}

#[test]
fn reference_systems_of_well_known_text() {
    let message = |text: &str| read("points.wkt", text, "").1;
    for (text, note) in [
        (
            "SRID=4326;POINT (1 2)",
            "the reference system is SRID 4326: lengths are in degrees",
        ),
        (
            "srid=25832;POINT (1 2)",
            "the reference system is SRID 25832\n",
        ),
        (
            "SRID=4326;POINT (1 2)\nSRID=25832;POINT (3 4)\nSRID=4326;POINT (5 6)",
            "points of several reference systems are taken as they are: SRID 4326, SRID 25832\n",
        ),
    ] {
        assert!(message(text).contains(note), "{}", message(text));
    }
    assert_eq!(
        error("points.wkt", "POINT (1 2)\nSRID=WGS84;POINT (1 2)\n", ""),
        "error: points.wkt, line 2: this is no well-known text: the number of SRID cannot be read"
    );
}

#[test]
fn places_of_google_earth() {
    let place =
        "<Placemark><Point><coordinates>\n 11.5,48.1,500 </coordinates></Point></Placemark>";
    let line = "<LineString><coordinates>1,2,0 3,4,0\n5,6</coordinates></LineString>";
    let ring = "<Polygon><outerBoundaryIs><LinearRing><coordinates>0,0 4,0 4,4 0,0</coordinates>\
                </LinearRing></outerBoundaryIs></Polygon>";
    let track = "<gx:Track xmlns:gx='g'><gx:coord>7 8 9</gx:coord></gx:Track>";
    let kml = |inside: &str| {
        format!(
            "<?xml version='1.0'?>\n<!-- a map -->\n<kml xmlns='http://www.opengis.net/kml/2.2'>\
             <Document>\n{inside}</Document></kml>"
        )
    };
    for name in ["map.kml", "map", "map.txt"] {
        let (points, message) = read(name, kml(&(place.to_owned() + track)), "");
        assert_eq!(points, json!([[11.5, 48.1], [7.0, 8.0]]));
        for note in [
            "x is the longitude, y the latitude\n",
            "the reference system is WGS 84: lengths are in degrees\n",
            "heights are left out\n",
        ] {
            assert!(message.contains(note), "{message}");
        }
    }
    assert_eq!(
        error("map.kml", kml(line), ""),
        "error: map.kml, line 4: it holds a LineString, which is no point: pass --vertices to take \
         its vertices"
    );
    let (points, message) = read("map.kml", kml(&(line.to_owned() + ring)), "--vertices");
    assert_eq!(
        points,
        json!([
            [1.0, 2.0],
            [3.0, 4.0],
            [5.0, 6.0],
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0]
        ])
    );
    assert!(
        message.contains("the last vertex of a closed line") && !message.contains("heights"),
        "{message}"
    );
    let bad = kml("<Point><coordinates>1,north</coordinates></Point>");
    assert_eq!(
        error("map.kml", &bad, ""),
        "error: map.kml, line 4: `north` is not a number"
    );
    let short = kml("<Point><coordinates>1</coordinates></Point>");
    assert_eq!(
        error("map.kml", &short, ""),
        "error: map.kml, line 4: a point is x and y, but here is only `1`"
    );
    assert_eq!(
        error("other.kml", "<svg/>", ""),
        "error: other.kml: this is no KML document"
    );
}

#[test]
fn tracks() {
    let track = r#"<?xml version="1.0"?><gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1">
<wpt lat="48.1" lon="11.5"><ele>500</ele></wpt>
<trk><trkseg><trkpt lat="48.2" lon="11.6"/><trkpt lat="48.3" lon="11.8"/></trkseg></trk></gpx>"#;
    for name in ["track.gpx", "track"] {
        let (points, message) = read(name, track, "");
        assert_eq!(points, json!([[11.5, 48.1], [11.6, 48.2], [11.8, 48.3]]));
        assert!(message.contains("lengths are in degrees"), "{message}");
        assert!(message.contains("heights are left out"), "{message}");
    }
    let bad = track.replace("48.2", "north");
    assert_eq!(
        error("bad.gpx", &bad, ""),
        "error: bad.gpx, line 3: `north` is not a number"
    );
    assert_eq!(
        error("other.gpx", "<svg/>", ""),
        "error: other.gpx: this is no GPX document"
    );
}

#[test]
fn vertices_of_models() {
    let model = "# a square\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    for name in ["square.obj", "square"] {
        let (points, message) = read(name, model, "");
        assert_eq!(
            points,
            json!([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
        );
        assert!(!message.contains("heights"), "{message}");
    }
    let short = error("short.obj", "v 1 2 3\nv 4\n", "");
    assert_eq!(
        short,
        "error: short.obj, line 2: a point is x and y, but here is only `v 4`"
    );
}

#[test]
fn records() {
    let text = r#"[{"id": 7, "Longitude": 1.5, "latitude": 2}, {"latitude": 4, "longitude": 3}]"#;
    let (points, message) = read("records.json", text, "");
    assert_eq!(points, json!([[1.5, 2.0], [3.0, 4.0]]));
    assert!(message.contains("lengths are in degrees"), "{message}");
    let (_, message) = read("high.json", r#"[{"x": 1, "y": 2, "z": 3}]"#, "");
    assert!(message.contains("heights are left out"), "{message}");
    let lacking = error("lacking.json", r#"[{"x": 1, "y": 2}, {"x": 1}]"#, "");
    assert!(
        lacking.contains("an object of a point has x and y"),
        "{lacking}"
    );
}

#[test]
fn vertices_of_geojson() {
    let map = r#"{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",
        "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]]]}}"#;
    assert!(error("map.geojson", map, "").ends_with("pass --vertices to take its vertices"));
    let (points, message) = read("map.geojson", map, "--vertices");
    let note = "map.geojson: the last vertex of a closed line repeats the first and is left out";
    assert!(message.contains(note), "{message}");
    assert_eq!(points, json!([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]]));
}

#[test]
fn reference_systems_of_geojson() {
    for (name, note) in [
        ("urn:ogc:def:crs:EPSG::25832", "EPSG:25832\n"),
        ("EPSG:4326", "EPSG:4326: lengths are in degrees\n"),
        (
            "urn:ogc:def:crs:OGC:1.3:CRS84",
            "OGC:CRS84: lengths are in degrees\n",
        ),
    ] {
        let map = format!(
            r#"{{"type": "FeatureCollection",
            "crs": {{"type": "name", "properties": {{"name": "{name}"}}}},
            "features": [{{"type": "Feature", "properties": {{}},
            "geometry": {{"type": "Point", "coordinates": [1, 2]}}}}]}}"#
        );
        let (_, message) = read("map.geojson", map, "");
        let says = format!("map.geojson: the reference system is {note}");
        assert!(message.contains(&says), "{message}");
    }
}

#[test]
fn tables_whose_headers_look_like_geometries() {
    for header in ["point x y", "v x y", "multiplier x y"] {
        let table = format!("{header}\n7 1 2\n8 3 4\n");
        assert_eq!(read("table", &table, "").0, json!([[1.0, 2.0], [3.0, 4.0]]));
    }
}
