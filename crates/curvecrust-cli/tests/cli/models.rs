//! Models in PLY.

use crate::point_files::{error, read};
use serde_json::json;

const HEADER: &str = "comment made by hand\nelement material 1\nproperty list uchar short ids\n\
                      element vertex 2\nproperty float z\nproperty double x\nproperty short y\n\
                      element face 1\nproperty list uchar int vertex_indices\nend_header\n";

/// The bytes of a model, by what makes bytes of a number.
macro_rules! model {
    ($format:literal, $bytes:ident) => {{
        let mut bytes = format!("ply\nformat {} 1.0\n{HEADER}", $format).into_bytes();
        bytes.extend([2, 0, 7, 0, 7]);
        for (x, y) in [(1.5f64, -2i16), (3.0, 4)] {
            bytes.extend(9f32.$bytes());
            bytes.extend(x.$bytes());
            bytes.extend(y.$bytes());
        }
        bytes.extend([3, 0, 0, 0]);
        bytes
    }};
}

fn ascii(body: &str) -> String {
    format!("ply\nformat ascii 1.0\n{HEADER}{body}")
}

#[test]
fn vertices_in_every_encoding() {
    let text = ascii("2 7 7\n9 1.5 -2\n\n9 3 4\n3 0 1 0\n").into_bytes();
    let little = model!("binary_little_endian", to_le_bytes);
    let big = model!("binary_big_endian", to_be_bytes);
    for bytes in [&text, &little, &big] {
        for name in ["p.ply", "p", "p.obj"] {
            let (points, message) = read(name, bytes, "");
            assert_eq!(points, json!([[1.5, -2.0], [3.0, 4.0]]));
            assert!(message.contains(": `z` is left out\n"), "{message}");
        }
    }
    let (points, message) = read("p.ply", &little, "--x Z --y x");
    assert_eq!(points, json!([[9.0, 1.5], [9.0, 3.0]]));
    assert!(message.contains(": `y` is left out\n"), "{message}");
    assert_eq!(
        error("p.ply", &little, "--x x --y u"),
        "error: p.ply: no column is named `u`: there are `z`, `x`, `y`"
    );
}

#[test]
fn models_that_are_cut_off() {
    let little = model!("binary_little_endian", to_le_bytes);
    let body = little.len() - 4 - 14;
    for (end, found) in [(body, 1), (body - 1, 0), (body + 13, 1)] {
        let says = format!("error: p.ply: it is cut off: of 2 vertices there are {found}");
        assert_eq!(error("p.ply", &little[..end], ""), says);
    }
    let text = ascii("2 7 7\n9 1.5 -2\n");
    assert_eq!(
        error("p.ply", text, ""),
        "error: p.ply: it is cut off: of 2 vertices there are 1"
    );
    let many = String::from_utf8_lossy(&little[..body]).replace("vertex 2", "vertex 1000000000000");
    let says = "error: p.ply: it is cut off: of 1000000000000 vertices there are ";
    assert!(error("p.ply", many, "").starts_with(says));
}

#[test]
fn models_that_hold_no_points() {
    let header = |text: &str| format!("ply\n{text}\nend_header\n");
    for (content, says) in [
        (
            ascii("2 7 7\n9 north 4\n"),
            ", line 14: `north` is not a number",
        ),
        (
            ascii("2 7 7\n9 4\n"),
            ", line 14: a point is x and y, but here is only `9 4`",
        ),
        (
            header("format ascii 1.0"),
            ": this is no PLY file: it has no vertices",
        ),
        (
            header("element vertex 1\nproperty int x\nproperty int y"),
            ": this is no PLY file: it has no format",
        ),
        (
            header("format gzip 1.0"),
            ", line 2: this is no PLY file: `format gzip 1.0` is no line of a header",
        ),
        (
            header("format ascii 1.0\nelement vertex 1\nproperty quad x"),
            ", line 4: this is no PLY file: `property quad x` is no line of a header",
        ),
        (
            header("format ascii 1.0\nelement vertex 1\nproperty int x\nproperty int z"),
            ": no column is named `y`: there are `x`, `z`",
        ),
        (
            format!("ply\ncomment {}", "a".repeat(1 << 17)),
            ": this is no PLY file: its header does not end",
        ),
        (
            "text\n".into(),
            ": this is no PLY file: it starts otherwise",
        ),
    ] {
        assert_eq!(error("p.ply", content, ""), format!("error: p.ply{says}"));
    }
    let mut bytes = model!("binary_little_endian", to_le_bytes);
    let at = bytes.len() - 4 - 10;
    bytes[at..at + 8].copy_from_slice(&f64::INFINITY.to_le_bytes());
    assert_eq!(
        error("p.ply", &bytes, ""),
        "error: p.ply, vertex 2: `inf` is not a finite number"
    );
}
