//! Tables in Parquet, and geometries in GeoParquet.

use crate::harness::Folder;
use crate::point_files::{error, read};
use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, FloatType, Int32Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use serde_json::json;
use std::sync::Arc;

pub(crate) type Group<'a> = SerializedRowGroupWriter<'a, Vec<u8>>;

/// A file with a schema, the metadata `geo` and so many groups of rows.
pub(crate) fn file(
    schema: &str,
    geo: Option<&str>,
    compression: Compression,
    groups: &[&dyn Fn(&mut Group<'_>)],
) -> Vec<u8> {
    let schema = Arc::new(parse_message_type(&format!("message table {{ {schema} }}")).unwrap());
    let geo = geo.map(|geo| vec![KeyValue::new("geo".into(), geo.to_owned())]);
    let properties = WriterProperties::builder()
        .set_compression(compression)
        .set_key_value_metadata(geo)
        .build();
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
    for write in groups {
        let mut group = writer.next_row_group().unwrap();
        write(&mut group);
        group.close().unwrap();
    }
    writer.into_inner().unwrap()
}

/// Writes the next column of a group; where levels are given, those of 0 have no value.
pub(crate) fn column<T: DataType>(group: &mut Group<'_>, values: &[T::T], levels: Option<&[i16]>) {
    let mut column = group.next_column().unwrap().unwrap();
    column
        .typed::<T>()
        .write_batch(values, levels, None)
        .unwrap();
    column.close().unwrap();
}

const XYZ: &str = "required double z; required double x; required float y;";

fn xyz(compression: Compression) -> Vec<u8> {
    let row = |x: f64, y: f32| {
        move |group: &mut Group<'_>| {
            column::<DoubleType>(group, &[9.0], None);
            column::<DoubleType>(group, &[x], None);
            column::<FloatType>(group, &[y], None);
        }
    };
    file(XYZ, None, compression, &[&row(1.5, 2.5), &row(3.0, 4.0)])
}

/// A point as well-known binary.
pub(crate) fn point(x: f64, y: f64) -> ByteArray {
    [&[1, 1, 0, 0, 0][..], &x.to_le_bytes(), &y.to_le_bytes()]
        .concat()
        .into()
}

fn geometries(crs: &str, values: &[ByteArray]) -> Vec<u8> {
    let about = format!(r#"{{"encoding": "WKB", "geometry_types": []{crs}}}"#);
    let geo =
        format!(r#"{{"version": "1.1.0", "primary_column": "g", "columns": {{"g": {about}}}}}"#);
    let write = |group: &mut Group<'_>| {
        column::<Int32Type>(group, &vec![7; values.len() + 1], None);
        // The second row has none.
        let mut levels = vec![1; values.len() + 1];
        levels[1] = 0;
        column::<ByteArrayType>(group, values, Some(&levels));
    };
    let schema = "required int32 x; optional binary g;";
    file(schema, Some(&geo), Compression::SNAPPY, &[&write])
}

/// Metadata of nothing but columns in each other.
fn nested(levels: u32) -> Vec<u8> {
    let mut metadata = b"\x15\x02\x19\xfc".to_vec();
    let mut count = levels + 1;
    while count > 127 {
        metadata.push(u8::try_from(count % 128).unwrap() | 128);
        count /= 128;
    }
    metadata.push(u8::try_from(count).unwrap());
    for _ in 0..levels {
        metadata.extend(b"\x35\x00\x18\x01a\x15\x02\x00");
    }
    metadata.extend(b"\x15\x0a\x25\x00\x18\x01x\x00\x16\x00\x19\x0c\x00");
    let length = u32::try_from(metadata.len()).unwrap().to_le_bytes();
    [b"PAR1", &metadata[..], &length, b"PAR1"].concat()
}

/// The crate calls itself for each.
#[test]
fn columns_in_columns_do_not_fill_the_stack() {
    for levels in [65, 1000, 1_000_000] {
        assert_eq!(
            error("p.parquet", nested(levels), ""),
            "error: p.parquet: the table cannot be read: its columns are more than 64 levels deep"
        );
    }
    let shallow = error("p.parquet", nested(64), "");
    assert!(
        shallow.contains("no columns are named x and y"),
        "{shallow}"
    );
}

/// A field that nobody knows: two billion truth values, which take no byte.
#[test]
fn lists_have_no_more_things_than_bytes() {
    let list = b"\x15\x02\x19\x0c\xf9\x0f\xf1\xff\xff\xff\xff\x07\x00";
    let length = u32::try_from(list.len()).unwrap().to_le_bytes();
    let bytes = [b"PAR1", &list[..], &length, b"PAR1"].concat();
    assert_eq!(
        error("p.parquet", bytes, ""),
        "error: p.parquet: the table cannot be read: its metadata are damaged"
    );
}

#[test]
fn columns_of_numbers() {
    let zstd = Compression::ZSTD(Default::default());
    for compression in [
        Compression::UNCOMPRESSED,
        Compression::SNAPPY,
        Compression::LZ4_RAW,
        zstd,
    ] {
        let bytes = xyz(compression);
        for name in ["p.parquet", "p", "p.csv"] {
            let (points, message) = read(name, &bytes, "");
            assert_eq!(points, json!([[1.5, 2.5], [3.0, 4.0]]));
            assert!(message.contains(": `z` is left out\n"), "{message}");
        }
        let found = Folder::new().pipe("reconstruct -", &bytes).fine();
        assert!(found.ends_with(",3,4\n"), "{found}");
    }
    let bytes = xyz(Compression::SNAPPY);
    let (points, message) = read("p.parquet", &bytes, "--x z --y X");
    assert_eq!(points, json!([[9.0, 1.5], [9.0, 3.0]]));
    assert!(
        message.contains(": x is the column `z`, y is `x`\n"),
        "{message}"
    );
    assert_eq!(
        error("p.parquet", &bytes, "--x z --y u"),
        "error: p.parquet: no column is named `u`: there are `z`, `x`, `y`"
    );
}

#[test]
fn longitudes_and_latitudes() {
    let write = |group: &mut Group<'_>| {
        column::<Int32Type>(group, &[48, 49], None);
        column::<DoubleType>(group, &[11.5], Some(&[1, 0]));
    };
    let schema = "required int32 lat; optional double lon;";
    let bytes = file(schema, None, Compression::SNAPPY, &[&write]);
    assert_eq!(
        error("p.parquet", &bytes, ""),
        "error: p.parquet, row 2: the column `lon` has no number"
    );
    let (points, message) = read("p.parquet", &bytes, "--x lat --y lat --merge-duplicates");
    assert_eq!(points, json!([[48.0, 48.0], [49.0, 49.0]]));
    let write = |group: &mut Group<'_>| {
        column::<Int32Type>(group, &[48, 49], None);
        column::<DoubleType>(group, &[11.5, 12.5], None);
    };
    let schema = "required int32 lat; required double lon;";
    let bytes = file(schema, None, Compression::SNAPPY, &[&write]);
    let (points, noted) = read("p.parquet", &bytes, "");
    assert_eq!(points, json!([[11.5, 48.0], [12.5, 49.0]]));
    assert!(
        noted.contains("x is the column `lon`, y is `lat`: lengths are in degrees"),
        "{message}"
    );
}

#[test]
fn columns_of_geometries() {
    let values = [point(1.0, 2.0), point(3.0, 4.0)];
    let utm = r#", "crs": {"type": "ProjectedCRS", "name": "UTM"}"#;
    let degrees = r#", "crs": {"type": "GeographicCRS", "name": "ETRS89"}"#;
    for (crs, note) in [
        (
            "",
            "the reference system is OGC:CRS84: lengths are in degrees\n",
        ),
        (
            degrees,
            "the reference system is ETRS89: lengths are in degrees\n",
        ),
        (utm, "the reference system is UTM\n"),
    ] {
        let (points, message) = read("p.parquet", geometries(crs, &values), "");
        assert_eq!(points, json!([[1.0, 2.0], [3.0, 4.0]]));
        assert!(message.contains(&format!("p.parquet: {note}")), "{message}");
    }
    let (_, message) = read("p.parquet", geometries(r#", "crs": null"#, &values), "");
    assert!(!message.contains("reference system"), "{message}");
    let cut = geometries("", &[point(1.0, 2.0), ByteArray::from(vec![1, 1, 0, 0, 0])]);
    assert_eq!(
        error("p.parquet", cut, ""),
        "error: p.parquet, row 3: this is no well-known binary: the geometry is cut off"
    );
    let line = [
        &[1, 2, 0, 0, 0, 1, 0, 0, 0][..],
        &point(5.0, 6.0).data()[5..],
    ]
    .concat();
    let line = geometries("", &[line.into()]);
    assert_eq!(
        error("p.parquet", &line, ""),
        "error: p.parquet, row 1: it holds a LineString, which is no point: pass --vertices to take \
         its vertices"
    );
    assert_eq!(
        read("p.parquet", &line, "--vertices").0,
        json!([[5.0, 6.0]])
    );
}

#[test]
fn points_in_columns_of_a_group() {
    let geo = r#"{"primary_column": "g", "columns": {"g": {"encoding": "point", "crs": null}}}"#;
    let write = |group: &mut Group<'_>| {
        column::<DoubleType>(group, &[1.0, 3.0], None);
        column::<DoubleType>(group, &[2.0, 4.0], None);
    };
    let schema = "required group g { required double x; required double y; }";
    let bytes = file(schema, Some(geo), Compression::SNAPPY, &[&write]);
    assert_eq!(
        read("p.parquet", bytes, "").0,
        json!([[1.0, 2.0], [3.0, 4.0]])
    );
    let other = geo.replace("point", "polygon");
    let bytes = file(schema, Some(&other), Compression::SNAPPY, &[&write]);
    assert_eq!(
        error("p.parquet", bytes, ""),
        "error: p.parquet: the table cannot be read: its geometries are in the encoding `polygon`: \
         save them as WKB"
    );
}

#[test]
fn tables_that_hold_no_points() {
    let write = |group: &mut Group<'_>| {
        column::<DoubleType>(group, &[f64::NAN], None);
        column::<ByteArrayType>(group, &["one".into()], None);
    };
    let names = |x: &str, y: &str| format!("required double {x}; required binary {y} (UTF8);");
    let of = |x: &str, y: &str, options: &str| {
        let bytes = file(&names(x, y), None, Compression::SNAPPY, &[&write]);
        error("p.parquet", bytes, options)
    };
    assert_eq!(
        of("a", "b", ""),
        "error: p.parquet: no columns are named x and y: there are `a`, `b`; pass --x and --y with \
         two of them"
    );
    assert_eq!(
        of("x", "y", ""),
        "error: p.parquet: the column `y` is of the type BYTE_ARRAY: coordinates are numbers"
    );
    assert_eq!(
        of("x", "y", "--x x --y x"),
        "error: p.parquet, row 1: `NaN` is not a finite number"
    );
    assert_eq!(
        error("p.parquet", file(XYZ, None, Compression::SNAPPY, &[]), ""),
        "error: p.parquet: there are no points"
    );
}

#[test]
fn tables_that_are_cut_off() {
    let bytes = xyz(Compression::SNAPPY);
    for end in [4, 8, 40, bytes.len() - 9, bytes.len() - 1] {
        let cut = error("p.parquet", &bytes[..end], "");
        assert!(
            cut.starts_with("error: p.parquet: the table cannot be read: "),
            "{cut}"
        );
    }
    assert!(error("p.parquet", "x,y\n1,2\n", "").contains("the table cannot be read"));
}

/// A page of 48 bytes that says it unpacks to two billions.
#[test]
fn a_bomb_does_not_go_off() {
    let bytes = xyz(Compression::SNAPPY);
    // The header of the first page: its kind, its size unpacked, and packed.
    let [0x15, kind, 0x15, size, 0x15, ref rest @ ..] = bytes[4..] else {
        panic!("{:?}", &bytes[..20])
    };
    assert_eq!(size, 16);
    let many = [0xfe, 0xff, 0xff, 0xff, 0x0f];
    let bytes = [&bytes[..4], &[0x15, kind, 0x15], &many, &[0x15], rest].concat();
    let says = error("p.parquet", bytes, "--x z --y z");
    assert!(
        says.contains("a page unpacks to more than 64 times the file and 64 MiB"),
        "{says}"
    );
}
