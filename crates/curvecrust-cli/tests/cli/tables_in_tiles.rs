//! `reconstruct --tiles` on Parquet files: the edges of the same points in an array.

use crate::columns::{Group, column, file, point};
use crate::harness::Folder;
use curvecrust_testing::hard_points::{polygon, shuffled, spiral};
use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, FloatType};
use std::fs;

/// A ring and a spiral around it.
fn points() -> Vec<[f64; 2]> {
    let ring = polygon(500).into_iter();
    let around = spiral(700).into_iter();
    let all = ring.map(|p| 5.0 * p).chain(around.map(|p| 0.7 * p));
    let points = shuffled(all.collect()).into_iter();
    points.map(|p| p.to_array()).collect()
}

fn npy(points: &[[f64; 2]]) -> Vec<u8> {
    let rows = points.len();
    let fields = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, 2), }}");
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{fields:<117}\n").bytes());
    bytes.extend(points.iter().flatten().flat_map(|x| x.to_le_bytes()));
    bytes
}

/// A table with two columns, in groups of so many rows.
fn table(names: [&str; 2], points: &[[f64; 2]], rows: usize) -> Vec<u8> {
    let [x, y] = names;
    let schema = format!("required double {x}; required double {y};");
    let write = |part: &[[f64; 2]], group: &mut Group<'_>| {
        for axis in [0, 1] {
            let numbers: Vec<f64> = part.iter().map(|p| p[axis]).collect();
            column::<DoubleType>(group, &numbers, None);
        }
    };
    let groups: Vec<_> = points
        .chunks(rows)
        .map(|part| move |group: &mut Group<'_>| write(part, group))
        .collect();
    let groups: Vec<&dyn Fn(&mut Group<'_>)> = groups.iter().map(|g| g as _).collect();
    file(&schema, None, Compression::SNAPPY, &groups)
}

const GEO: &str = r#"{"version": "1.1.0", "primary_column": "g",
    "columns": {"g": {"encoding": "WKB", "geometry_types": []}}}"#;

/// A table of geometries; a row without one is null.
fn geometries(values: &[Option<ByteArray>]) -> Vec<u8> {
    let write = |group: &mut Group<'_>| {
        let levels: Vec<i16> = values.iter().map(|value| value.is_some().into()).collect();
        let values: Vec<ByteArray> = values.iter().flatten().cloned().collect();
        column::<ByteArrayType>(group, &values, Some(&levels));
    };
    file(
        "optional binary g;",
        Some(GEO),
        Compression::SNAPPY,
        &[&write],
    )
}

/// The edges of points that are in a file or folder named `from`.
fn edges(folder: &Folder, from: &str, options: &str) -> Vec<u8> {
    let _ = fs::remove_dir_all(folder.path().join("work"));
    let line = format!("reconstruct {from} --tiles work {options} -o edges.npy --force");
    folder.run(&line).fine();
    fs::read(folder.path().join("edges.npy")).unwrap()
}

/// A folder with the points in an array, and the edges of these.
fn with_array(points: &[[f64; 2]]) -> (Folder, Vec<u8>) {
    let folder = Folder::with("p.npy", npy(points));
    folder
        .run("reconstruct p.npy --algorithm hnn-crust -o once.npy")
        .fine();
    let expected = fs::read(folder.path().join("once.npy")).unwrap();
    (folder, expected)
}

#[test]
fn tables_give_the_edges_of_an_array() {
    let points = points();
    let (folder, expected) = with_array(&points);
    folder.write("p.parquet", table(["x", "y"], &points, 170));
    folder.write("lon.parquet", table(["lon", "lat"], &points, 5000));
    folder.write("ab.parquet", table(["a", "b"], &points, 1));
    let values = points.iter().map(|&[x, y]| Some(point(x, y)));
    folder.write("geo.parquet", geometries(&values.collect::<Vec<_>>()));
    fs::create_dir(folder.path().join("parts")).unwrap();
    folder.write("parts/b.parquet", table(["x", "y"], &points[601..], 100));
    folder.write("parts/a.parquet", table(["x", "y"], &points[..600], 250));
    folder.write("parts/a2.parquet", table(["x", "y"], &points[600..601], 3));
    folder.write("parts/none.parquet", table(["x", "y"], &[], 3));
    folder.write("parts/_SUCCESS", "");
    for size in ["40", "177", "5000"] {
        let options = format!("--tile-points {size}");
        for from in ["p.parquet", "lon.parquet", "geo.parquet", "parts"] {
            assert!(edges(&folder, from, &options) == expected, "{from}, {size}");
        }
        let options = format!("{options} --x a --y b");
        assert!(edges(&folder, "ab.parquet", &options) == expected);
    }
    let curves = |from: &str, out: &str| {
        let _ = fs::remove_dir_all(folder.path().join("work"));
        let line = format!("reconstruct {from} --tiles work --tile-points 50 --polylines {out}");
        folder.run(&line).fine();
        fs::read(folder.path().join(out).join("curves.npy")).unwrap()
    };
    assert!(curves("parts", "of-parts") == curves("p.npy", "of-array"));
    let stderr = folder
        .run("reconstruct lon.parquet --tiles new -o edges.npy --force")
        .stderr;
    assert!(
        stderr.starts_with("lon.parquet: x is the column `lon`, y is `lat`: "),
        "{stderr}"
    );
}

#[test]
fn numbers_may_be_of_other_types() {
    #[expect(clippy::cast_possible_truncation, reason = "rounded")]
    let single: Vec<[f32; 2]> = points().iter().map(|p| p.map(|x| x as f32)).collect();
    let points: Vec<[f64; 2]> = single.iter().map(|p| p.map(f64::from)).collect();
    let (folder, expected) = with_array(&points);
    let write = |group: &mut Group<'_>| {
        for axis in [0, 1] {
            let numbers: Vec<f32> = single.iter().map(|p| p[axis]).collect();
            column::<FloatType>(group, &numbers, None);
        }
    };
    let schema = "required float x; required float y;";
    folder.write(
        "p.parquet",
        file(schema, None, Compression::SNAPPY, &[&write]),
    );
    assert!(edges(&folder, "p.parquet", "--tile-points 90") == expected);
}

#[test]
fn bad_points_are_named_by_file_group_and_row() {
    let mut points = points();
    points[617][1] = f64::NAN;
    let folder = Folder::new();
    fs::create_dir(folder.path().join("parts")).unwrap();
    folder.write("parts/a.parquet", table(["x", "y"], &points[..300], 100));
    folder.write("parts/b.parquet", table(["x", "y"], &points[300..], 100));
    let error = |from: &str| {
        let line = format!("reconstruct {from} --tiles work --tile-points 100 -o out.npy");
        folder.run(&line).error()
    };
    assert_eq!(
        error("parts"),
        "error: parts/b.parquet, row group 4, row 18: `NaN` is not a finite number"
    );
    let values = points.iter().map(|&[x, y]| Some(point(x, y)));
    let mut values: Vec<_> = values.collect();
    folder.write("p.parquet", geometries(&values));
    assert_eq!(
        error("p.parquet"),
        "error: p.parquet, row group 1, row 618: `NaN` is not a finite number"
    );
    values[20] = None;
    folder.write("p.parquet", geometries(&values));
    assert_eq!(
        error("p.parquet"),
        "error: p.parquet, row group 1, row 21: with --tiles every row has to be one point, and \
         this one is not"
    );
    folder.write("parts/c.parquet", "none");
    assert!(error("parts").starts_with("error: parts/c.parquet: "));
    fs::create_dir(folder.path().join("empty")).unwrap();
    assert_eq!(error("empty"), "error: empty: there are no points");
    folder.write("p.npy", npy(&points));
    assert_eq!(
        error("p.npy --x a --y b"),
        "error: p.npy: --x and --y name columns of tables, but this is npy"
    );
}
