//! Scans in LAS and LAZ.

use crate::point_files::{error, read};
use las::point::Format;
use las::{Builder, Color, Point, Vlr, Writer};
use serde_json::json;
use std::io::Cursor;

/// A scan of so many points of a line.
fn scan(count: u32, is_packed: bool, vlrs: Vec<Vlr>) -> Vec<u8> {
    scan_of(Format::default(), count, is_packed, vlrs)
}

/// The same with points of a format.
fn scan_of(format: Format, count: u32, is_packed: bool, vlrs: Vec<Vlr>) -> Vec<u8> {
    let mut builder = Builder::from((1, 4));
    builder.point_format = format;
    builder.point_format.is_compressed = is_packed;
    builder.vlrs = vlrs;
    let bytes = Cursor::new(Vec::new());
    let mut writer = Writer::new(bytes, builder.into_header().unwrap()).unwrap();
    for i in 0..count {
        let (x, y, z) = (f64::from(i), f64::from(i * i % 7), 9.0);
        writer
            .write_point(Point {
                x,
                y,
                z,
                gps_time: format.has_gps_time.then_some(z),
                color: format.has_color.then(Color::default),
                nir: format.has_nir.then_some(1),
                ..Point::default()
            })
            .unwrap();
    }
    writer.into_inner().unwrap().into_inner()
}

/// A record of the header for the system of a key of GeoTIFF.
fn system(key: u16, code: u16) -> Vlr {
    let data = [1, 1, 0, 1, key, 0, 1, code];
    Vlr {
        user_id: "LASF_Projection".into(),
        record_id: 34735,
        data: data
            .iter()
            .flat_map(|number: &u16| number.to_le_bytes())
            .collect(),
        ..Vlr::default()
    }
}

/// Writes a number over what stands at a place.
fn with(mut bytes: Vec<u8>, at: usize, number: &[u8]) -> Vec<u8> {
    bytes[at..at + number.len()].copy_from_slice(number);
    bytes
}

#[test]
fn points_packed_or_not() {
    for is_packed in [false, true] {
        let bytes = scan(3, is_packed, vec![]);
        for name in ["p.las", "p.laz", "p"] {
            let (points, message) = read(name, &bytes, "");
            assert_eq!(points, json!([[0.0, 0.0], [1.0, 1.0], [2.0, 4.0]]));
            assert!(message.contains(": heights are left out\n"), "{message}");
        }
        // More than are read at once.
        let (points, _) = read(
            "p.laz",
            scan(60_000, is_packed, vec![]),
            "--algorithm hnn-crust",
        );
        assert_eq!(
            points[59_999],
            json!([59_999.0, f64::from(59_999u32.wrapping_pow(2) % 7)])
        );
    }
}

/// Formats 6 to 8 are packed in layers, here in one chunk and in two.
#[test]
fn points_packed_in_layers() {
    for format in 6..=8 {
        for count in [3, 60_000] {
            let bytes = scan_of(Format::new(format).unwrap(), count, true, vec![]);
            let (points, _) = read("p.laz", bytes, "--algorithm hnn-crust");
            let points = points.as_array().unwrap();
            assert_eq!(points.len(), count as usize, "{format}");
            for (i, point) in (0..count).zip(points) {
                let y = i.wrapping_mul(i) % 7;
                assert_eq!(*point, json!([f64::from(i), f64::from(y)]), "{format}");
            }
        }
    }
}

#[test]
fn reference_systems() {
    for (key, code, note) in [
        (2048, 4326, "EPSG:4326: lengths are in degrees\n"),
        (3072, 25832, "EPSG:25832\n"),
    ] {
        let (_, message) = read("p.las", scan(3, false, vec![system(key, code)]), "");
        assert!(
            message.contains(&format!("p.las: the reference system is {note}")),
            "{message}"
        );
    }
}

#[test]
fn scans_that_are_cut_off() {
    let bytes = scan(3, false, vec![]);
    assert_eq!(
        error("p.las", &bytes[..bytes.len() - 1], ""),
        "error: p.las: it is cut off: of 3 points there are 2"
    );
    let packed = scan(60_000, true, vec![]);
    let cut = error("p.laz", &packed[..packed.len() / 2], "");
    assert!(cut.starts_with("error: p.laz"), "{cut}");
    for end in [4, 100, 230, 375] {
        let cut = error("p.las", &bytes[..end], "");
        assert!(cut.starts_with("error: p.las: "), "{cut}");
    }
    assert_eq!(
        error("p.las", "1 2\n", ""),
        "error: p.las: this is no LAS file: it starts otherwise"
    );
}

/// The decoder needs to know what it unpacks, even if that is nothing.
#[test]
fn scans_without_points() {
    for is_packed in [false, true] {
        let bytes = scan(0, is_packed, vec![]);
        assert_eq!(
            error("p.las", bytes, ""),
            "error: p.las: there are no points"
        );
    }
    // The record about it is missing.
    let mut bytes = scan(3, true, vec![]);
    let at = bytes.windows(6).position(|w| w == b"laszip").unwrap();
    bytes[at] = b'L';
    assert_eq!(
        error("p.laz", bytes, ""),
        "error: p.laz: this is no LAS file: it does not say how its points are packed"
    );
}

/// A thousand billions of points, and a record of that many bytes behind them.
#[test]
fn promises_reserve_nothing() {
    let many = 1_000_000_000_000u64.to_le_bytes();
    for (is_packed, says) in [
        (false, "it is cut off: of 1000000000000 points there are 3"),
        (
            true,
            "it promises 1000000000000 points, more than 64 times its size and 64 MiB can unpack to",
        ),
    ] {
        // The old number of points stands above the new one unless it is zero.
        let bytes = with(scan(3, is_packed, vec![]), 107, &[0; 4]);
        let bytes = with(bytes, 247, &many);
        assert_eq!(error("p.las", &bytes, ""), format!("error: p.las: {says}"));
        let bytes = with(scan(3, is_packed, vec![]), 107, &u32::MAX.to_le_bytes());
        assert!(error("p.las", &bytes, "").contains("4294967295 points"));
    }
    let bytes = scan(3, false, vec![]);
    let end = u64::try_from(bytes.len()).unwrap();
    let bytes = with(
        bytes,
        235,
        &[&end.to_le_bytes()[..], &1u32.to_le_bytes()].concat(),
    );
    let bytes = [bytes, vec![0; 20], many.to_vec(), vec![0; 32]].concat();
    assert_eq!(
        error("p.las", &bytes, ""),
        "error: p.las: this is no LAS file: it is cut off before its extended records"
    );
}
