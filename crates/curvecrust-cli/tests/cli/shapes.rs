//! Shapefiles.

use crate::harness::{Folder, json};
use crate::point_files::{error, read};
use serde_json::json;

fn little(counts: &[u32], numbers: &[f64]) -> Vec<u8> {
    let mut bytes: Vec<u8> = counts
        .iter()
        .flat_map(|count| count.to_le_bytes())
        .collect();
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

/// A file of records.
fn shapefile(records: &[Vec<u8>]) -> Vec<u8> {
    let length: usize = records.iter().map(|record| 8 + record.len()).sum();
    let words = |bytes: usize| u32::try_from(bytes / 2).unwrap().to_be_bytes();
    let mut bytes = [&9994u32.to_be_bytes()[..], &[0; 20], &words(100 + length)].concat();
    bytes.resize(100, 0);
    for record in records {
        bytes.extend([&[0; 4][..], &words(record.len()), record].concat());
    }
    bytes
}

/// A file of points.
pub(crate) fn of_points(points: &[[f64; 2]]) -> Vec<u8> {
    let records = points.iter().map(|point| little(&[1], point));
    shapefile(&records.collect::<Vec<_>>())
}

/// Parts of a polygon or a line, without a box.
fn parts(kind: u32, starts: &[u32], vertices: &[f64]) -> Vec<u8> {
    let count = u32::try_from(vertices.len() / 2).unwrap();
    let head = little(&[kind], &[0.0; 4]);
    let counts = little(&[u32::try_from(starts.len()).unwrap(), count], &[]);
    [head, counts, little(starts, vertices)].concat()
}

const RINGS: [f64; 16] = [
    0.0, 0.0, 4.0, 0.0, 4.0, 4.0, 0.0, 0.0, 1.0, 1.0, 2.0, 1.0, 2.0, 2.0, 1.0, 1.0,
];

#[test]
fn points_and_multipoints() {
    let many = [little(&[8], &[0.0; 4]), little(&[2], &[5.0, 6.0, 7.0, 8.0])].concat();
    let records = [
        little(&[1], &[1.0, 2.0]),
        // Nothing, a height and a measure.
        little(&[0], &[]),
        little(&[11], &[3.0, 4.0, 9.0, 9.0]),
        many,
    ];
    let bytes = shapefile(&records);
    for name in ["p.shp", "p", "p.txt"] {
        let (points, message) = read(name, &bytes, "");
        assert_eq!(
            points,
            json!([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]])
        );
        assert!(message.contains(": heights are left out\n"), "{message}");
    }
}

#[test]
fn vertices_and_the_system_beside() {
    let folder = Folder::with("ring.shp", shapefile(&[parts(5, &[0, 4], &RINGS)]));
    let refused = folder.run("reconstruct ring.shp").error();
    assert_eq!(
        refused,
        "error: ring.shp, shape 1: it holds a Polygon, which is no point: pass --vertices to take \
         its vertices"
    );
    let geographic = "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\"]]";
    for (text, note) in [
        (
            geographic.to_owned(),
            "GCS_WGS_1984: lengths are in degrees\n",
        ),
        (format!("PROJCS[\"UTM\",{geographic}]"), "UTM\n"),
    ] {
        folder.write("ring.prj", text);
        let run = folder.run("reconstruct ring.shp --vertices --json");
        let message = run.stderr.clone();
        assert!(
            message.contains(&format!("ring.shp: the reference system is {note}")),
            "{message}"
        );
        assert!(
            message.contains("the last vertices of 2 closed lines"),
            "{message}"
        );
        let points = &json(&run.fine())["points"];
        assert_eq!(points.as_array().unwrap().len(), 6);
    }
}

#[test]
fn shapes_that_cannot_be_read() {
    let point = little(&[1], &[1.0, 2.0]);
    let good = shapefile(&[point.clone(), point.clone()]);
    let says =
        |place: &str, what: &str| format!("error: p.shp{place}: this is no Shapefile: {what}");
    for end in [good.len() - 1, good.len() - 21, good.len() - 25] {
        assert_eq!(
            error("p.shp", &good[..end], ""),
            says(", shape 2", "the file is cut off")
        );
    }
    assert_eq!(
        error("p.shp", &good[..50], ""),
        says("", "its header is cut off")
    );
    assert_eq!(
        error("p.shp", "1 2\n3 4\n", ""),
        says("", "it starts otherwise")
    );
    let of = |record: Vec<u8>| error("p.shp", shapefile(&[record]), "--vertices");
    let short = says(", shape 1", "the record is shorter than its shape");
    assert_eq!(of(little(&[1], &[1.0])), short);
    // More points and parts than there can be.
    assert_eq!(
        of([little(&[8], &[0.0; 4]), little(&[u32::MAX], &[])].concat()),
        short
    );
    assert_eq!(
        of([little(&[3], &[0.0; 4]), little(&[u32::MAX; 2], &[])].concat()),
        short
    );
    for starts in [&[0, 9][..], &[1], &[4, 0], &[]] {
        let wrong = says(", shape 1", "its parts are not in order");
        assert_eq!(of(parts(5, starts, &RINGS)), wrong);
    }
    assert_eq!(
        of(little(&[7], &[])),
        says(", shape 1", "its type is 7, which is not known")
    );
    let far = of(little(&[1], &[1.0, f64::NAN]));
    assert_eq!(far, "error: p.shp, shape 1: `NaN` is not a finite number");
}
