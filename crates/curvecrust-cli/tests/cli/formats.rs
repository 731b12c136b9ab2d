//! Every format of points, and every format of results read back by a reader that is not ours.

use crate::harness::{Folder, fixture, json};
use serde_json::Value;

/// Points that a shortest decimal must hold.
const POINTS: [[f64; 2]; 4] = [
    [0.1, -0.2],
    [1.0 / 3.0, 2e-7],
    [12345.678901234567, 4.0],
    [5.0, 1e20],
];

/// What is read from a file, by way of the object that the program prints.
fn read(folder: &Folder, line: &str) -> Vec<[f64; 2]> {
    let object = json(&folder.run(&format!("reconstruct {line} --json -q")).fine());
    serde_json::from_value(object["points"].clone()).unwrap()
}

fn npy(descr: &str, order: &str, shape: &str, numbers: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': {descr}, 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [
        b"\x93NUMPY\x01\x00",
        &length[..],
        header.as_bytes(),
        numbers,
    ]
    .concat()
}

#[test]
fn points_are_read_from_every_format() {
    let folder = Folder::new();
    let pairs = serde_json::to_string(&POINTS).unwrap();
    let text: String = POINTS.iter().map(|[x, y]| format!("{x} {y}\n")).collect();
    folder.write("p.csv", text.replace(' ', ","));
    folder.write("p.xy", &text);
    folder.write("p.json", &pairs);
    folder.write(
        "object.json",
        format!(r#"{{"samples": {pairs}, "count": 4}}"#),
    );
    let multi = format!(r#"{{"coordinates": {pairs}, "type": "MultiPoint"}}"#);
    folder.write("p.geojson", &multi);
    folder.write(
        "features.json",
        format!(
            r#"{{"type": "FeatureCollection", "features": [
            {{"type": "Feature", "geometry": null, "properties": null}},
            {{"type": "Feature", "geometry": {multi}, "properties": {{}}}}]}}"#
        ),
    );
    let rows: Vec<u8> = POINTS
        .iter()
        .flatten()
        .flat_map(|v| v.to_le_bytes())
        .collect();
    folder.write("p.npy", npy("'<f8'", "False", "(4, 2)", &rows));
    let columns = (0..2).flat_map(|c| POINTS.iter().map(move |p| p[c]));
    let columns: Vec<u8> = columns.flat_map(f64::to_be_bytes).collect();
    folder.write("columns.npy", npy("'>f8'", "True", "(4, 2)", &columns));
    let circles: String = POINTS
        .iter()
        .map(|[x, y]| format!(r#"<circle cx="{x}" cy="{y}" r="1"/>"#))
        .collect();
    let svg = |inside: &str| format!(r#"<svg xmlns="http://www.w3.org/2000/svg">{inside}</svg>"#);
    folder.write("p.svg", svg(&format!("{circles}<path d='M 7 8 L 9 9'/>")));
    for name in [
        "p.csv",
        "p.xy",
        "p.json",
        "object.json",
        "p.geojson",
        "features.json",
        "p.npy",
        "columns.npy",
        "p.svg",
    ] {
        assert_eq!(read(&folder, name), POINTS, "{name}");
        // Without a known ending, by its content.
        let content = std::fs::read(folder.path().join(name)).unwrap();
        folder.write("nameless", &content);
        assert_eq!(read(&folder, "nameless"), POINTS, "{name}");
    }
}

#[test]
fn single_precision_is_exact() {
    let numbers: Vec<u8> = [0.1f32, 2.5, 3.0, 4.0]
        .iter()
        .flat_map(|v| v.to_le_bytes())
        .collect();
    let folder = Folder::with("p.npy", npy("'<f4'", "False", "(2, 2)", &numbers));
    assert_eq!(
        read(&folder, "p.npy"),
        [[f64::from(0.1f32), 2.5], [3.0, 4.0]]
    );
}

#[test]
fn vertices_of_paths_are_points() {
    let inside = r#"
        <defs><path d="M 100 100 L 200 200"/></defs>
        <g transform="translate(10 20)">
          <path transform="scale(2)" d="M 0 0 h 1 v 1 C 5 5 6 6 0 1 Z m 3 3 l 1 0 0 1 -1 -1 z"/>
          <path style="display: none" d="M 50 50 L 60 60"/>
        </g>
        <polyline points="1,2 3,4"/>"#;
    let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg">{inside}</svg>"#);
    let folder = Folder::with("p.svg", svg);
    let square = [[10.0, 20.0], [12.0, 20.0], [12.0, 22.0], [10.0, 22.0]];
    let triangle = [[16.0, 26.0], [18.0, 26.0], [18.0, 28.0]];
    let line = [[1.0, 2.0], [3.0, 4.0]];
    assert_eq!(
        read(&folder, "p.svg"),
        [&square[..], &triangle, &line].concat()
    );
}

/// A ring with a hole in it, an open chain and a point alone.
fn varied() -> Folder {
    let mut text = String::new();
    for (radius, count) in [(10.0, 30), (5.0, 20)] {
        for i in 0..count {
            let (sin, cos) = (f64::from(i) / f64::from(count) * std::f64::consts::TAU).sin_cos();
            text += &format!("{} {}\n", radius * cos, radius * sin);
        }
    }
    for i in 0..6 {
        text += &format!("{} 30.5\n", f64::from(i) * 0.7);
    }
    Folder::with("p.xy", text + "90 90\n")
}

/// The chains of the object that the program prints, as polylines.
fn chains(object: &Value) -> Vec<Vec<[f64; 2]>> {
    let points: Vec<[f64; 2]> = serde_json::from_value(object["points"].clone()).unwrap();
    let rings = object["rings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|ring| &ring["points"]);
    let open = object["open_chains"].as_array().unwrap().iter();
    let ids = |chain: &Value| -> Vec<usize> { serde_json::from_value(chain.clone()).unwrap() };
    rings
        .chain(open)
        .map(|c| ids(c).iter().map(|&i| points[i]).collect())
        .collect()
}

#[test]
fn geojson_and_wkt_hold_what_the_object_holds() {
    let folder = varied();
    let object = json(&folder.run("reconstruct p.xy --json -o out.geojson").fine());
    folder.run("reconstruct p.xy -o out.wkt").fine();
    let chains = chains(&object);
    assert_eq!(chains.len(), 3);

    let geojson: geojson::FeatureCollection = folder.read("out.geojson").parse().unwrap();
    let geometries: Vec<_> = geojson
        .features
        .iter()
        .map(|f| f.geometry.clone().unwrap())
        .collect();
    let [polygon, line, points] = &geometries[..] else {
        panic!("{geometries:?}")
    };
    let geojson::GeometryValue::Polygon { coordinates } = &polygon.value else {
        panic!("{polygon:?}")
    };
    let rings: Vec<Vec<[f64; 2]>> = coordinates
        .iter()
        .map(|ring| ring.iter().map(|p| [p[0], p[1]]).collect())
        .collect();
    let [outside, hole] = &rings[..] else {
        panic!("{rings:?}")
    };
    assert!(area(outside) > 0.0 && area(hole) < 0.0);
    assert_eq!(outside[..30], chains[0]);
    assert_eq!(outside[30..], outside[..1]);
    let mut back: Vec<_> = hole[1..].to_vec();
    back.reverse();
    assert_eq!(back, chains[1]);
    assert!(matches!(
        line.value,
        geojson::GeometryValue::LineString { .. }
    ));
    assert!(matches!(
        points.value,
        geojson::GeometryValue::MultiPoint { .. }
    ));

    let read: wkt::Wkt<f64> = folder.read("out.wkt").parse().unwrap();
    let wkt::Wkt::GeometryCollection(collection) = read else {
        panic!("{read:?}")
    };
    let [
        wkt::Wkt::Polygon(polygon),
        wkt::Wkt::LineString(line),
        wkt::Wkt::MultiPoint(points),
    ] = collection.geometries()
    else {
        panic!("{collection:?}")
    };
    let pairs = |line: &wkt::types::LineString<f64>| -> Vec<[f64; 2]> {
        line.coords().iter().map(|c| [c.x, c.y]).collect()
    };
    assert_eq!(polygon.rings().iter().map(pairs).collect::<Vec<_>>(), rings);
    assert_eq!(pairs(line), chains[2]);
    assert_eq!(points.points().len(), 1);
}

fn area(ring: &[[f64; 2]]) -> f64 {
    ring.windows(2)
        .map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1])
        .sum()
}

#[test]
fn a_picture_holds_the_points_exactly() {
    let folder = varied();
    folder.run("reconstruct p.xy -o out.svg").fine();
    assert_eq!(read(&folder, "out.svg"), read(&folder, "p.xy"));
}

#[test]
fn dxf_holds_every_chain() {
    let folder = varied();
    let object = json(&folder.run("reconstruct p.xy --json -o out.dxf").fine());
    let text = folder.read("out.dxf");
    let lines: Vec<&str> = text.lines().collect();
    let groups: Vec<(i32, &str)> = lines
        .chunks(2)
        .map(|g| (g[0].parse().unwrap(), g[1]))
        .collect();
    let mut found: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut entity = "";
    let mut x = 0.0;
    for (code, value) in groups {
        match (code, entity) {
            (0, _) => entity = value,
            (66, "POLYLINE") => found.push(Vec::new()),
            (10, "VERTEX") => x = value.parse().unwrap(),
            (20, "VERTEX") => found.last_mut().unwrap().push([x, value.parse().unwrap()]),
            _ => {}
        }
    }
    let mut expected = chains(&object);
    // The hole runs the other way.
    expected[1][1..].reverse();
    assert_eq!(found, expected);
}

#[test]
fn npy_holds_edges_and_samples() {
    let folder = varied();
    let object = json(&folder.run("reconstruct p.xy --json -o out.npy").fine());
    let bytes = std::fs::read(folder.path().join("out.npy")).unwrap();
    assert_eq!(bytes.len() % 8, 0);
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\0");
    assert_eq!(
        usize::from(u16::from_le_bytes([bytes[8], bytes[9]])) + 10,
        128
    );
    let ids: Vec<u32> = bytes[128..]
        .chunks(4)
        .map(|b| u32::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let edges: Vec<[u32; 2]> = serde_json::from_value(object["edges"].clone()).unwrap();
    assert_eq!(
        ids.chunks(2).map(|p| [p[0], p[1]]).collect::<Vec<_>>(),
        edges
    );

    let curve = fixture("curves/wave.svg");
    let line = format!("sample {} --rho 0.9 --json -o samples.npy", curve.display());
    let samples = json(&folder.run(&line).fine());
    let samples: Vec<[f64; 2]> = serde_json::from_value(samples["samples"].clone()).unwrap();
    assert_eq!(read(&folder, "samples.npy"), samples);
}

/// What is written is read again, by the readers of points.
#[test]
fn wkb_and_gpx_hold_what_wkt_holds() {
    let folder = varied();
    let points = |name: &str| {
        folder.run(&format!("reconstruct p.xy -o {name}")).fine();
        let options = "--vertices --merge-duplicates --json";
        let run = folder.run(&format!("reconstruct {name} {options}"));
        json(&run.fine())["points"].clone()
    };
    let expected = points("out.wkt");
    assert_eq!(points("out.wkb"), expected);
    // Tracks are closed, and points alone come first.
    let track = points("out.gpx");
    let (track, expected) = (track.as_array().unwrap(), expected.as_array().unwrap());
    assert!(track.len() > expected.len());
    assert!(expected.iter().all(|point| track.contains(point)));
    folder.write("far.xy", "0 0\n1 0\n2 91\n");
    let error = folder.run("reconstruct far.xy -o far.gpx").error();
    assert!(
        error.ends_with("gpx holds longitudes and latitudes, and (2, 91) is none"),
        "{error}"
    );
    assert!(!folder.names().contains(&"far.gpx".to_owned()));
}
