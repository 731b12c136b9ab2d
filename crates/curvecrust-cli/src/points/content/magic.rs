//! The first bytes by which files say what they are.

use crate::format::Format;

/// What a magic number stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Magic {
    /// A format that points are read from.
    Readable(Format),
    /// Something else, and what to do with it.
    Foreign {
        what: &'static str,
        advice: &'static str,
    },
}

/// What the first bytes stand for, if anything.
pub(super) fn find(head: &[u8]) -> Option<Magic> {
    if head.starts_with(b"PK\x03\x04") {
        return Some(archive(head));
    }
    if head.starts_with(b"SQLite format 3\0") {
        let is_package = head.get(68..72).is_some_and(|id| id.starts_with(b"GP"));
        return Some(if is_package { GEOPACKAGE } else { DATABASE });
    }
    if head.starts_with(b"RIFF") {
        let kind = head.get(8..12).unwrap_or_default();
        return (kind == b"WEBP").then_some(picture("a WebP picture"));
    }
    if head.starts_with(b"BM") {
        // Text may start so; the size of a picture is followed by four zeros.
        return (head.get(6..10) == Some(&[0; 4])).then_some(picture("a BMP picture"));
    }
    if head.starts_with(b"ply") {
        let follows = head.get(3).is_some_and(|byte| b"\r\n".contains(byte));
        return follows.then_some(Magic::Readable(Format::Ply));
    }
    if is_well_known_binary(head) {
        return Some(Magic::Readable(Format::Wkb));
    }
    let mut readable = READABLE.iter();
    if let Some((_, format)) = readable.find(|(start, _)| head.starts_with(start)) {
        return Some(Magic::Readable(*format));
    }
    let mut foreign = FOREIGN.iter();
    let (_, what, advice) = foreign.find(|(start, ..)| head.starts_with(start))?;
    Some(Magic::Foreign { what, advice })
}

const READABLE: &[(&[u8], Format)] = &[
    (b"\x93NUMPY", Format::Npy),
    (b"\0\0\x27\x0a", Format::Shapefile),
    (b"LASF", Format::Las),
    (b"fgb\x03fgb", Format::Flatgeobuf),
    (b"PAR1", Format::Parquet),
];

const UNPACK: &str = "unpack it first";
const TRACE: &str = "trace it with a drawing program, and save the drawing as SVG";
const SHEET: &str = "save its sheet as CSV";
const ARRAY: &str = "save the points as CSV or as a NumPy array";
const MAP: &str = "save its layer as GeoJSON, FlatGeobuf or GeoParquet";
const DRAWING: &str = "save it as SVG";
const SCAN: &str = "save it as LAS or PLY";

const GEOPACKAGE: Magic = Magic::Foreign {
    what: "a GeoPackage",
    advice: MAP,
};
const DATABASE: Magic = Magic::Foreign {
    what: "an SQLite database",
    advice: "save the points as CSV",
};

const FOREIGN: &[(&[u8], &str, &str)] = &[
    (b"PK\x05\x06", "an empty zip archive", UNPACK),
    (b"\x1f\x8b", "compressed by gzip", UNPACK),
    (b"BZh", "compressed by bzip2", UNPACK),
    (b"\xfd7zXZ\0", "compressed by xz", UNPACK),
    (b"\x28\xb5\x2f\xfd", "compressed by Zstandard", UNPACK),
    (b"7z\xbc\xaf\x27\x1c", "a 7-Zip archive", UNPACK),
    (b"Rar!\x1a\x07", "a RAR archive", UNPACK),
    (b"\x89PNG\r\n\x1a\n", "a PNG picture", TRACE),
    (b"\xff\xd8\xff", "a JPEG picture", TRACE),
    (b"GIF8", "a GIF picture", TRACE),
    (b"II*\0", "a TIFF picture", TRACE),
    (b"MM\0*", "a TIFF picture", TRACE),
    (b"II+\0", "a TIFF picture", TRACE),
    (b"MM\0+", "a TIFF picture", TRACE),
    (b"%PDF", "a PDF document", DRAWING),
    (b"%!PS", "a PostScript document", DRAWING),
    (b"\xc5\xd0\xd3\xc6", "a PostScript document", DRAWING),
    (b"AC10", "a DWG drawing", DRAWING),
    (b"AutoCAD Binary DXF", "a binary DXF drawing", DRAWING),
    (
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
        "a document of an older Microsoft Office",
        SHEET,
    ),
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file", ARRAY),
    (b"CDF\x01", "a NetCDF file", ARRAY),
    (b"CDF\x02", "a NetCDF file", ARRAY),
    (b"MATLAB 5.0 MAT-file", "a MATLAB file", ARRAY),
    (b"\x80\x02", "a Python pickle", ARRAY),
    (b"\x80\x03", "a Python pickle", ARRAY),
    (b"\x80\x04", "a Python pickle", ARRAY),
    (b"\x80\x05", "a Python pickle", ARRAY),
    (b"ARROW1", "an Arrow file", "save it as Parquet"),
    (b"FEA1", "a Feather file", "save it as Parquet"),
    (b"PARE", "an encrypted Parquet file", "decrypt it first"),
    (b"ORC", "an ORC file", "save it as Parquet"),
    (b"Obj\x01", "an Avro file", "save it as Parquet"),
    (b"glTF", "a binary glTF model", "save it as PLY or OBJ"),
    (b"ASTM-E57", "an E57 scan", SCAN),
    (b"# .PCD", "a PCD scan", SCAN),
    (b"\x7fELF", "a program", ARRAY),
    (b"MZ\x90\0", "a program", ARRAY),
];

const fn picture(what: &'static str) -> Magic {
    Magic::Foreign {
        what,
        advice: TRACE,
    }
}

/// Whether the first bytes are those of a geometry: an order of bytes, and a type by it.
fn is_well_known_binary(head: &[u8]) -> bool {
    let (flags, high, low) = match *head {
        [1, low, high, 0, flags, ..] | [0, flags, 0, high, low, ..] => (flags, high, low),
        _ => return false,
    };
    let kind = u16::from_be_bytes([high, low]);
    flags & 0x1f == 0 && matches!(kind % 1000, 1..=7) && kind < 4000
}

/// What a zip archive holds, by the names of what comes first in it.
fn archive(head: &[u8]) -> Magic {
    let has = |name: &[u8]| head.windows(name.len()).any(|window| window == name);
    let (what, advice) = if has(b".npy") {
        return Magic::Readable(Format::Npz);
    } else if has(b"[Content_Types].xml") || has(b"xl/workbook") {
        ("an Excel workbook or its like", SHEET)
    } else if has(b"mimetypeapplication/vnd.oasis") {
        ("an OpenDocument file", SHEET)
    } else if has(b".kml") {
        ("a KMZ archive", "unpack it first, and take the .kml in it")
    } else if has(b".shp") || has(b".shx") || has(b".dbf") {
        (
            "a zipped Shapefile",
            "unpack it first, and take the .shp in it",
        )
    } else {
        ("a zip archive", UNPACK)
    };
    Magic::Foreign { what, advice }
}
