//! Well-known binary.

use crate::point_files::{error, read};
use serde_json::json;

/// A geometry with the numbers behind its type, little-endian.
fn geometry(kind: u32, counts: &[u32], numbers: &[f64]) -> Vec<u8> {
    let mut bytes = vec![1];
    bytes.extend(kind.to_le_bytes());
    bytes.extend(counts.iter().flat_map(|count| count.to_le_bytes()));
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

/// A point, big-endian.
fn big(x: f64, y: f64) -> Vec<u8> {
    [
        &[0][..],
        &1u32.to_be_bytes(),
        &x.to_be_bytes(),
        &y.to_be_bytes(),
    ]
    .concat()
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

const SRID: u32 = 0x2000_0000;

#[test]
fn points_of_every_dialect() {
    // ISO's heights and measures, PostGIS's, and both orders of bytes in one geometry.
    let parts = [
        geometry(7, &[3], &[]),
        big(1.0, 2.0),
        geometry(1001, &[], &[3.0, 4.0, 9.0]),
        geometry(4, &[2], &[]),
        geometry(0xC000_0001, &[], &[5.0, 6.0, 9.0, 9.0]),
        geometry(1, &[], &[f64::NAN, f64::NAN]),
    ];
    let bytes = [parts.concat(), big(7.0, 8.0)].concat();
    for name in ["p.wkb", "p", "p.txt"] {
        let (points, message) = read(name, &bytes, "");
        assert_eq!(
            points,
            json!([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]])
        );
        assert!(message.contains(": heights are left out\n"), "{message}");
        assert!(message.contains(": measures are left out\n"), "{message}");
    }
}

#[test]
fn reference_systems() {
    let point = geometry(1 | SRID, &[4326], &[1.0, 2.0]);
    let note = "the reference system is SRID 4326: lengths are in degrees\n";
    assert!(read("p.ewkb", &point, "").1.contains(note));
    // As databases print it.
    let other = hexadecimal(&geometry(1 | SRID, &[25832], &[3.0, 4.0]));
    for text in [format!("{other}\n"), format!("\\x{other}\r\n\n")] {
        let (points, message) = read("p.wkb", &text, "");
        assert_eq!(points, json!([[3.0, 4.0]]));
        assert!(
            message.contains("the reference system is SRID 25832\n"),
            "{message}"
        );
    }
    let lines = format!("{}\n{other}\n", hexadecimal(&point));
    for name in ["p.txt", "p"] {
        let (points, message) = read(name, &lines, "");
        assert_eq!(points, json!([[1.0, 2.0], [3.0, 4.0]]));
        assert!(message.contains("SRID 4326, SRID 25832"), "{message}");
    }
}

#[test]
fn vertices_of_lines_and_polygons() {
    let ring = [0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 0.0];
    let polygon = geometry(3, &[1, 4], &ring);
    assert_eq!(
        error("p.wkb", &polygon, ""),
        "error: p.wkb, geometry 1: it holds a Polygon, which is no point: pass --vertices to take \
         its vertices"
    );
    let (points, message) = read("p.wkb", &polygon, "--vertices");
    assert_eq!(points, json!([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]]));
    assert!(
        message.contains("the last vertex of a closed line repeats the first"),
        "{message}"
    );
    let lines = [
        geometry(5, &[1], &[]),
        geometry(2, &[2], &[1.0, 2.0, 3.0, 4.0]),
    ]
    .concat();
    let (points, _) = read("p.wkb", &lines, "--vertices");
    assert_eq!(points, json!([[1.0, 2.0], [3.0, 4.0]]));
}

#[test]
fn geometries_that_cannot_be_read() {
    let first = big(1.0, 2.0);
    let with = |second: &[u8]| error("p.wkb", [&first, second].concat(), "--vertices");
    let cut = "error: p.wkb, geometry 2: this is no well-known binary: the geometry is cut off";
    assert_eq!(with(&first[..20]), cut);
    // More points, rings and parts than there can be.
    for kind in [2, 3, 4, 7] {
        assert_eq!(with(&geometry(kind, &[u32::MAX], &[])), cut);
    }
    let says =
        |what: &str| format!("error: p.wkb, geometry 2: this is no well-known binary: {what}");
    // A circular string is no point.
    assert_eq!(
        with(&geometry(8, &[0], &[])),
        says("its type is 8: 1 to 7 are known, points to collections")
    );
    assert_eq!(
        with(&[2]),
        says("the order of bytes is 2, and has to be 0 or 1")
    );
    let deep = geometry(7, &[1], &[]).repeat(100_000);
    assert_eq!(with(&deep), says("geometries in geometries"));
    let far = error(
        "p.wkb",
        [first.clone(), big(1.0, f64::INFINITY)].concat(),
        "",
    );
    assert_eq!(
        far,
        "error: p.wkb, geometry 2: `inf` is not a finite number"
    );
    assert_eq!(
        error("p.wkb", "POINT (1 2)\n", ""),
        "error: p.wkb, line 1: this is no well-known binary: these are no hexadecimal digits"
    );
    let twice = hexadecimal(&first).repeat(2);
    assert_eq!(
        error("p.wkb", twice, ""),
        "error: p.wkb, line 1: this is no well-known binary: the line goes on after its geometry"
    );
}
