//! The program's readers of points, one format each and by what content looks like.

#![no_main]

use libfuzzer_sys::fuzz_target;

/// The last one is empty: there the format is guessed.
const EXTENSIONS: [&str; 17] = [
    "csv", "xy", "json", "geojson", "npy", "svg", "wkt", "gpx", "kml", "npz", "ply", "wkb", "shp",
    "las", "fgb", "parquet", "",
];

/// How many times as much as is packed may come out, in points, and how many at least.
const RATIO: usize = 64;
const LEAST: usize = 4 << 20;

/// Whether this is LAZ: `laz` 0.13 calls itself once for each sequence of GPS times that a point
/// switches to, and damaged data switch without end, until the stack is full. The program has a
/// process of its own for that, which a fuzz target cannot start.
fn is_compressed_scan(bytes: &[u8]) -> bool {
    bytes.starts_with(b"LASF") && bytes.get(104).is_some_and(|format| format & 0x80 != 0)
}

fuzz_target!(|input: (u8, &[u8])| {
    let (which, bytes) = input;
    if is_compressed_scan(bytes) {
        return;
    }
    let extension = EXTENSIONS[usize::from(which) % EXTENSIONS.len()];
    let everything = usize::from(which) >= EXTENSIONS.len() && which % 2 == 0;
    match curvecrust_cli::count_points(bytes.to_vec(), extension, everything) {
        Ok(points) => assert!(0 < points && points <= RATIO * bytes.len() + LEAST),
        // Fit for a terminal.
        Err(message) => assert!(!message.chars().any(|c| c.is_control() && c != '\n')),
    }
});
