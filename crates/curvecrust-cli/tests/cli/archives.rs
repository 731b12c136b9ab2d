//! Archives of NumPy arrays.

use crate::harness::Folder;
use crate::point_files::{error, read};
use serde_json::json;
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// An array of little-endian doubles.
fn array(shape: &str, numbers: &[f64]) -> Vec<u8> {
    let fields = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(u16::try_from(fields.len()).unwrap().to_le_bytes());
    bytes.extend(fields.bytes());
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

fn archive(method: CompressionMethod, files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for (name, bytes) in files {
        writer.start_file(*name, options).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

fn packed(files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    archive(CompressionMethod::Deflated, files)
}

#[test]
fn one_array_of_points() {
    let rows = array("(2, 2)", &[1.0, 2.0, 3.0, 4.0]);
    for method in [CompressionMethod::Stored, CompressionMethod::Deflated] {
        let bytes = archive(method, &[("arr_0.npy", rows.clone())]);
        for name in ["p.npz", "p", "p.csv"] {
            let (points, message) = read(name, &bytes, "");
            assert_eq!(points, json!([[1.0, 2.0], [3.0, 4.0]]));
            assert!(!message.contains("p.npz:"), "{message}");
        }
        // What cannot be read from any place is held in memory.
        let found = Folder::new().pipe("reconstruct -", &bytes).fine();
        assert!(found.ends_with(",3,4\n"), "{found}");
    }
}

#[test]
fn arrays_of_coordinates() {
    let x = ("x.npy", array("(2,)", &[1.0, 3.0]));
    let y = ("y.npy", array("(2,)", &[2.0, 4.0]));
    let c = ("c.npy", array("(3,)", &[1.0, 2.0, 3.0]));
    let expected = json!([[1.0, 2.0], [3.0, 4.0]]);
    let bytes = packed(&[c.clone(), y.clone(), x.clone()]);
    let (points, message) = read("p.npz", &bytes, "");
    assert_eq!(points, expected);
    assert!(message.contains("p.npz: `c` is left out\n"), "{message}");
    let (points, message) = read("p.npz", &bytes, "--x y --y x");
    assert_eq!(points, json!([[2.0, 1.0], [4.0, 3.0]]));
    assert!(
        message.contains("p.npz: x is the array `y`, y is `x`; `c` is left out\n"),
        "{message}"
    );
    assert_eq!(
        error("p.npz", &bytes, "--x x --y z"),
        "error: p.npz: no array is named `z`: there are `c`, `y`, `x`"
    );
    assert_eq!(
        error("p.npz", &bytes, "--x x --y c"),
        "error: p.npz: the arrays `x` and `c` have 2 and 3 rows"
    );
    assert_eq!(
        error("p.npz", packed(&[c, x]), ""),
        "error: p.npz: which holds points? There are `c`, `x`: pass --x and --y with the names of two"
    );
    assert_eq!(
        error("p.npz", packed(&[y]), ""),
        "error: p.npz: array `y`: the shape is (2,): points have the shape (n, 2)"
    );
}

#[test]
fn archives_that_hold_no_points() {
    let bytes = packed(&[("a.npy", array("(2, 2)", &[1.0, 2.0, 3.0, f64::NAN]))]);
    assert_eq!(
        error("p.npz", &bytes, ""),
        "error: p.npz: array `a`, row 2, column 2: `NaN` is not a finite number"
    );
    // Bytes change, or the end is missing.
    let good = archive(
        CompressionMethod::Stored,
        &[("a.npy", array("(1, 2)", &[1.0, 2.0]))],
    );
    let at = good
        .windows(8)
        .position(|w| w == 2f64.to_le_bytes())
        .unwrap();
    let mut bad = good.clone();
    bad[at] ^= 1;
    assert_eq!(
        error("p.npz", &bad, ""),
        "error: p.npz: array `a`: Invalid checksum"
    );
    for end in [40, good.len() - 30] {
        let cut = error("p.npz", &good[..end], "");
        assert!(cut.starts_with("error: p.npz: "), "{cut}");
    }
    assert!(error("p.npz", "1 2\n", "").starts_with("error: p.npz: "));
}

/// A hundred megabytes of zeros in a hundred kilobytes.
#[test]
fn a_bomb_does_not_go_off() {
    let rows = 1 << 23;
    let bytes = packed(&[(
        "a.npy",
        array(&format!("({rows}, 2)"), &vec![0.0; 2 * rows]),
    )]);
    assert!(bytes.len() < 1 << 18, "{}", bytes.len());
    assert_eq!(
        error("bomb.npz", bytes, ""),
        "error: bomb.npz: array `a`: it unpacks to more than 64 times its packed size and 64 MiB: \
         save it as .npy"
    );
}
