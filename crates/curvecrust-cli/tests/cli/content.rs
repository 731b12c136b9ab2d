//! What content is, whatever it is named.

use crate::bad_input::error;
use crate::harness::Folder;

/// The bytes by which files of other kinds start, and what they are called.
#[rustfmt::skip]
const FOREIGN: &[(&[u8], &str)] = &[
    (b"PK\x03\x04\x14\0\0\0\x08\0[Content_Types].xml", "an Excel workbook or its like: save its sheet as CSV"),
    (b"PK\x03\x04\x14\0\0\0\x08\0doc.kml", "a KMZ archive: unpack it first, and take the .kml in it"),
    (b"PK\x03\x04\x14\0\0\0\x08\0a.txt", "a zip archive: unpack it first"),
    (b"\x1f\x8b\x08\0\0\0\0\0", "compressed by gzip: unpack it first"),
    (b"\x89PNG\r\n\x1a\n\0\0", "a PNG picture: trace it with a drawing program, and save the drawing as SVG"),
    (b"%PDF-1.7\n", "a PDF document: save it as SVG"),
    (b"SQLite format 3\0\x10\0", "an SQLite database: save the points as CSV"),
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file: save the points as CSV or as a NumPy array"),
];

#[test]
fn files_of_other_kinds_are_named_and_never_quoted() {
    for (content, what) in FOREIGN {
        for name in ["p", "p.csv", "p.txt", "p.json", "p.svg", "p.bin"] {
            assert_eq!(error(name, content), format!("{name}: this is {what}"));
        }
        let folder = Folder::with("p.csv", content);
        let error = folder.run("reconstruct p.csv --from csv").error();
        assert_eq!(error, format!("error: p.csv: this is {what}"));
    }
    assert_eq!(
        error("p.png", b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"),
        "p.png: this is a PNG picture: trace it with a drawing program, and save the drawing as SVG"
    );
    let mut package = b"SQLite format 3\0".to_vec();
    package.resize(68, 0);
    package.extend(b"GPKG");
    assert_eq!(
        error("p.gpkg", package),
        "p.gpkg: this is a GeoPackage: save its layer as GeoJSON, FlatGeobuf or GeoParquet"
    );
}

/// Doubles, the bytes of a compressed file, text of two bytes a letter.
#[test]
fn binary_data_are_not_quoted() {
    let doubles: Vec<u8> = (1..99).flat_map(|i| f64::from(i).to_le_bytes()).collect();
    let noise: Vec<u8> = (0..999u32)
        .map(|i| i.wrapping_mul(2_654_435_761).to_be_bytes()[0])
        .collect();
    let wide: Vec<u8> = "1 2\n3 4\n".bytes().flat_map(|byte| [byte, 0]).collect();
    for content in [doubles, noise, wide] {
        for name in ["p", "p.csv", "p.txt", "p.json", "p.svg", "p.wkt"] {
            let says = format!("{name}: this is binary data of a kind that is not known");
            assert_eq!(error(name, &content), says);
        }
    }
    // Letters of other languages and other codes are text.
    let latin = b"H\xf6he,x,y\n1,2,3\n".to_vec();
    let greek = "μήκος,x,y\n1,2,3\n".as_bytes().to_vec();
    for content in [latin, greek] {
        let folder = Folder::with("p.csv", content);
        assert!(folder.run("reconstruct p.csv").fine().ends_with(",0,2,3\n"));
    }
}

#[test]
fn content_decides_what_text_is() {
    let npy = [
        &b"\x93NUMPY\x01\x00\x3b\x00"[..],
        b"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }",
        &1.0f64.to_le_bytes(),
        &2.0f64.to_le_bytes(),
    ];
    let npy = npy.concat();
    let contents: [&[u8]; 9] = [
        b"1 2\n",
        b"x,y\n1,2\n",
        b"[m] [m]\n1 2\n",
        b"[[1, 2]]",
        br#"{"type": "Point", "coordinates": [1, 2]}"#,
        b"SRID=25832;POINT (1 2)",
        b"<gpx><wpt lon='1' lat='2'/></gpx>",
        b"# a model\nv 1 2 0\n",
        &npy,
    ];
    for content in contents {
        for name in ["p.txt", "p.dat", "p", "p.bin"] {
            let folder = Folder::with(name, content);
            let found = folder.run(&format!("reconstruct {name}")).fine();
            assert!(found.ends_with(",0,1,2\n"), "{name}: {found}");
        }
    }
    // A magic number stands above the name, and what is asked for has to agree with it.
    let folder = Folder::with("p.csv", npy);
    assert!(folder.run("reconstruct p.csv").fine().ends_with(",0,1,2\n"));
    assert_eq!(
        folder.run("reconstruct p.csv --from csv").error(),
        "error: p.csv: this is npy, not csv: leave out --from"
    );
    // What is asked for stands above what text looks like.
    let folder = Folder::with("p.txt", "[[1, 2]]");
    let error_of = folder.run("reconstruct p.txt --from csv").error();
    assert!(error_of.starts_with("error: p.txt, line 1"), "{error_of}");
    assert_eq!(
        error("p.txt", "0\nSECTION\n2\n"),
        "p.txt: points cannot be read from dxf: use csv, text, json, geojson, wkt, gpx, kml, obj, npy, svg, npz, ply, wkb, shapefile, \
         las, flatgeobuf or parquet"
    );
    assert_eq!(
        error("p.xml", "<?xml version='1.0'?>\n<o:osm/>"),
        "p.xml: this is XML of `osm`: of XML, svg, gpx and kml hold points"
    );
}
