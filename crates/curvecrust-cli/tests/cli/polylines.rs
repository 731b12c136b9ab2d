//! `reconstruct --tiles --polylines`: the curves are those of all points at once.

use crate::harness::Folder;
use curvecrust::DVec2;
use curvecrust::geometry::{PointSet, Random};
use curvecrust::reconstruct::{ALGORITHMS, Reconstruction};
use curvecrust::tiles::{Area, ExactSum};
use curvecrust_testing::hard_points::{HARD_POINTS, polygon, shuffled, spiral, well_spread};
use curvecrust_testing::strategies::{any_points, even_runs, point_set};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

/// A row of `curves.npy`.
#[derive(Debug, PartialEq)]
struct Row {
    first: u64,
    count: u64,
    length: u64,
    area: u64,
    low: DVec2,
    high: DVec2,
    parent: i64,
    nesting: i32,
    closed: bool,
}

/// An array of points, as 64 bit numbers.
fn npy(points: &PointSet) -> Vec<u8> {
    let rows = points.len();
    let fields = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, 2), }}");
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{fields:<117}\n").bytes());
    let numbers = points.points().iter().flat_map(|p| p.to_array());
    bytes.extend(numbers.flat_map(f64::to_le_bytes));
    bytes
}

/// The elements of an array, each so many bytes.
fn elements(path: &Path, bytes: usize) -> Vec<Vec<u8>> {
    let content = fs::read(path).unwrap();
    let header = usize::from(u16::from_le_bytes([content[8], content[9]])) + 10;
    assert_eq!(header % 64, 0);
    let text = String::from_utf8(content[10..header].to_vec()).unwrap();
    let shape = text.split("'shape': (").nth(1).unwrap();
    let rows: usize = shape.split(',').next().unwrap().parse().unwrap();
    assert_eq!(content.len(), header + rows * bytes, "{text}");
    let elements = content[header..].chunks(bytes);
    elements.map(<[u8]>::to_vec).collect()
}

fn word(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap())
}

fn rows(folder: &Path) -> Vec<Row> {
    let row = |bytes: Vec<u8>| {
        let number = |at: usize| f64::from_bits(word(&bytes, at));
        Row {
            first: word(&bytes, 0),
            count: word(&bytes, 8),
            length: word(&bytes, 16),
            area: word(&bytes, 24),
            low: DVec2::new(number(32), number(40)),
            high: DVec2::new(number(48), number(56)),
            parent: word(&bytes, 64).cast_signed(),
            nesting: i32::from_le_bytes(bytes[72..76].try_into().unwrap()),
            closed: bytes[76] == 1,
        }
    };
    let rows = elements(&folder.join("curves.npy"), 77);
    rows.into_iter().map(row).collect()
}

/// The points of each curve, put together from the pieces of all tiles; and every edge once.
fn curves(folder: &Path) -> (Vec<Vec<u64>>, Vec<[u64; 2]>) {
    let mut pieces = BTreeMap::new();
    let mut edges = Vec::new();
    for tile in 0.. {
        let path = folder.join(format!("tile-{tile:06}.points.npy"));
        if !path.exists() {
            break;
        }
        let points: Vec<u64> = elements(&path, 4)
            .iter()
            .map(|bytes| u32::from_le_bytes(bytes[..].try_into().unwrap()).into())
            .collect();
        let mut next = 0;
        let path = folder.join(format!("tile-{tile:06}.pieces.npy"));
        let mut keys = Vec::new();
        for fields in elements(&path, 40) {
            let [curve, start, offset, count, after] =
                [0, 8, 16, 24, 32].map(|at| word(&fields, at));
            assert_eq!(offset, next);
            next += count;
            let number = |n: u64| usize::try_from(n).unwrap();
            let of_piece = points[number(offset)..number(next)].to_vec();
            let steps = of_piece.windows(2).map(|pair| [pair[0], pair[1]]);
            edges.extend(steps);
            let last = of_piece[of_piece.len() - 1];
            edges.extend((after != last).then_some([last, after]));
            keys.push((curve, start));
            assert!(pieces.insert((curve, start), of_piece).is_none());
        }
        assert_eq!(next, points.len() as u64);
        assert!(keys.is_sorted());
    }
    let mut curves: Vec<Vec<u64>> = Vec::new();
    for ((curve, start), of_piece) in pieces {
        if start == 0 {
            assert_eq!(curve, curves.len() as u64);
            curves.push(Vec::new());
        }
        let so_far = curves.last_mut().unwrap();
        assert_eq!(start, so_far.len() as u64);
        so_far.extend(of_piece);
    }
    for edge in &mut edges {
        edge.sort_unstable();
    }
    edges.sort_unstable();
    (curves, edges)
}

/// Compares the result in a folder with what all points at once give.
fn assert_same(folder: &Path, points: &PointSet, algorithm: &str, name: &str) {
    let found = ALGORITHMS.iter().find(|a| a.info().name == algorithm);
    let expected = Reconstruction::by(*found.unwrap(), points);
    let (curves, edges) = curves(folder);
    let rows = rows(folder);
    assert_eq!(rows.len(), expected.chains().len(), "{name}");
    assert_eq!(curves.len(), expected.chains().len(), "{name}");
    for ((nested, curve), row) in expected.chains().iter().zip(curves).zip(&rows) {
        let chain = &nested.chain;
        let ids = chain.vertices().iter().map(|&id| u64::from(u32::from(id)));
        let ids: Vec<u64> = ids.collect();
        assert_eq!(curve, ids, "{name}");
        let mut length = ExactSum::default();
        let mut twice_area = ExactSum::default();
        let places: Vec<DVec2> = chain.vertices().iter().map(|&id| points[id]).collect();
        let next = places.iter().cycle().skip(1);
        for (a, b) in places.iter().zip(next).take(chain.edge_count()) {
            length.add(a.distance(*b));
            if chain.is_closed() {
                twice_area.add_product(a.x, b.y);
                twice_area.add_product(-a.y, b.x);
            }
        }
        let area = Area::of(places);
        let of_chain = Row {
            first: ids[0],
            count: ids.len() as u64,
            length: length.value().to_bits(),
            area: (twice_area.value() / 2.0).to_bits(),
            low: area.low,
            high: area.high,
            parent: nested
                .parent
                .map_or(-1, |parent| i64::try_from(parent).unwrap()),
            nesting: nested
                .nesting
                .map_or(-1, |nesting| i32::try_from(nesting).unwrap()),
            closed: chain.is_closed(),
        };
        assert_eq!(*row, of_chain, "{name}");
    }
    let expected = expected.edges().edges().iter();
    let expected = expected.map(|edge| edge.ends().map(|id| u64::from(u32::from(id))));
    assert_eq!(edges, expected.collect::<Vec<_>>(), "{name}");
}

/// Runs the program on tiles of some size and compares; returns the table of curves.
fn check(points: &PointSet, algorithm: &str, size: usize, name: &str) -> Vec<u8> {
    let folder = Folder::with("p.npy", npy(points));
    let line = format!(
        "reconstruct p.npy --tiles work --tile-points {size} --algorithm {algorithm} \
         --polylines out --threads 2"
    );
    let name = format!("{name}, {algorithm}, tiles of {size}");
    assert_eq!(folder.run(&line).fine(), "", "{name}");
    assert_eq!(folder.names(), ["out", "p.npy", "work"]);
    let out = folder.path().join("out");
    assert_same(&out, points, algorithm, &name);
    fs::read(out.join("curves.npy")).unwrap()
}

/// The same for tiles of few points, of some, and of all: of one point where there are not too many
/// tiles for a test then.
fn check_all(points: &PointSet, algorithm: &str, name: &str) {
    let least = if points.len() < 100 { 1 } else { 30 };
    let sizes = [least, 7.max(least), 50, points.len()];
    let tables = sizes.map(|size| check(points, algorithm, size, name));
    assert!(tables.iter().all(|table| *table == tables[0]), "{name}");
}

/// Rings in rings, near each other and too near for tiles, and an open curve among them.
fn rings_in_rings(count: usize) -> PointSet {
    let ring = |i: usize| {
        let (radius, shift) = (1.0 + 0.4 * i as f64, DVec2::new(0.07 * i as f64, 0.0));
        let points = polygon(20 + 12 * i).into_iter();
        points.map(move |p| radius * p + shift)
    };
    let small = (0..count).flat_map(|i| {
        let shift = DVec2::from_angle(i as f64) * (0.25 * i as f64);
        polygon(8).into_iter().map(move |p| 0.05 * p + shift)
    });
    let open = polygon(80).into_iter().take(22).map(|p| 5.0 * p);
    let all = (0..count).flat_map(ring).chain(small).chain(open).collect();
    point_set(shuffled(all))
}

#[test]
fn curves_do_not_depend_on_tiles() {
    for algorithm in ["hnn-crust", "hnn-crust-union", "nn-crust", "crust"] {
        check_all(&rings_in_rings(2), algorithm, "few rings in rings");
        check_all(&rings_in_rings(8), algorithm, "rings in rings");
        check_all(&point_set(well_spread(40)), algorithm, "well spread");
    }
    for points in [40, 400]
        .map(|n| [spiral(n), polygon(n)])
        .into_iter()
        .flatten()
    {
        let points = shuffled(points);
        check_all(&point_set(points), "hnn-crust", "one curve");
    }
    check_all(&point_set(vec![DVec2::ONE]), "hnn-crust", "one point");
}

#[test]
fn hard_points_in_tiles_of_any_size() {
    for hard in HARD_POINTS {
        // Most of the time goes to files, of which each tile has a dozen.
        let few = point_set((hard.points)(16));
        check(&few, "hnn-crust", 1, hard.name);
        let points = point_set((hard.points)(72));
        check(&points, "hnn-crust-union", 9, hard.name);
        check(&points, "nn-crust", 40, hard.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(if cfg!(debug_assertions) { 30 } else { 400 }))]

    #[test]
    fn any_points_in_any_tiles(
        points in any_points().prop_filter("some points", |points| !points.is_empty()),
        size in 1..40usize,
        algorithm in prop::sample::select(vec!["hnn-crust", "hnn-crust-union", "nn-crust", "crust"]),
    ) {
        check(&points, algorithm, size, "any points");
    }

    #[test]
    fn open_rows_in_any_tiles(points in even_runs(), size in 1..40usize) {
        check(&point_set(points), "hnn-crust", size, "rows");
    }
}

/// The files of a result.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let file = |entry: fs::DirEntry| {
        let name = entry.file_name().into_string().unwrap();
        (name, fs::read(entry.path()).unwrap())
    };
    entries.map(file).collect()
}

#[test]
fn a_run_that_was_killed_goes_on() {
    let circle = |i: usize| {
        let points = polygon(40).into_iter();
        let centre = DVec2::new((i % 10) as f64, (i / 10) as f64);
        points.map(move |p| 0.4 * p + centre)
    };
    let large = polygon(2000).into_iter().map(|p| 10.0 * p + 5.0);
    let points = point_set(shuffled((0..100).flat_map(circle).chain(large).collect()));
    let folder = Folder::with("p.npy", npy(&points));
    let line = |work: &str, out: &str| {
        format!("reconstruct p.npy --tiles {work} --tile-points 200 --polylines {out}")
    };
    let started = std::time::Instant::now();
    folder.run(&line("work", "out")).fine();
    let whole = started.elapsed();
    assert_same(
        &folder.path().join("out"),
        &points,
        "hnn-crust",
        "not killed",
    );
    let mut random = Random::new(26);
    for _ in 0..12 {
        let mut command = folder.command(&line("killed", "killed-out"));
        let mut child = command.stderr(Stdio::null()).spawn().unwrap();
        let share = random.below(1000) as f64 / 1000.0;
        std::thread::sleep(whole.mul_f64(share).min(Duration::from_secs(60)));
        let ended = child.try_wait().unwrap();
        child.kill().unwrap();
        child.wait().unwrap();
        let out = folder.path().join("killed-out");
        if ended.is_some() || out.exists() {
            // All is there as soon as anything is.
            assert!(files(&out) == files(&folder.path().join("out")));
            fs::remove_dir_all(out).unwrap();
            fs::remove_dir_all(folder.path().join("killed")).unwrap();
        }
    }
    folder.run(&line("killed", "killed-out")).fine();
    let [one, other] = ["out", "killed-out"].map(|out| files(&folder.path().join(out)));
    assert!(one == other);
    assert!(!folder.path().join("killed-out.part").exists());
}

#[test]
fn where_curves_are_written() {
    let points = point_set(shuffled(polygon(300)));
    let folder = Folder::with("p.npy", npy(&points));
    let line = "reconstruct p.npy --tiles work --tile-points 50 --polylines out";
    let run = folder.run(line);
    assert_eq!(
        run.stderr,
        "300 points in 6 tiles, 18 of them asked other tiles: 1 curve, 1 of them closed, 1 in \
         several tiles; work can be deleted\n"
    );
    let first = files(&folder.path().join("out"));
    assert_eq!(first.len(), 13);
    assert_eq!(
        folder.run(line).error(),
        "error: out exists: pass --force to overwrite it"
    );
    folder.write("out/tile-000077.points.npy", "of an earlier result");
    // With edges too, and in the folder of tiles that is there.
    let forced = format!("{line} --force -o edges.npy");
    let stderr = folder.run(&forced).stderr;
    assert!(stderr.contains(": 300 edges, 1 curve, "), "{stderr}");
    assert!(first == files(&folder.path().join("out")));
    assert!(folder.path().join("edges.npy").exists());
    folder.write("out/notes.txt", "keep");
    assert_eq!(
        folder.run(&forced).error(),
        "error: cannot write the folder out: it holds notes.txt, which is no part of such a \
         result: give a new or an empty folder"
    );
    assert_eq!(
        folder.run(&line.replace(" out", " no/out")).error(),
        "error: cannot write the folder no/out: there is no folder no"
    );
    assert_eq!(
        folder.run(&line.replace(" out", " work")).error(),
        "error: --tiles and --polylines are one folder: give two"
    );
    let run = folder.run("reconstruct p.npy --polylines out");
    assert_eq!(run.status, Some(2));
}

#[test]
fn damaged_pieces_are_named() {
    let folder = Folder::with("p.npy", npy(&point_set(shuffled(polygon(300)))));
    let line = "reconstruct p.npy --tiles work --tile-points 50 --polylines out";
    folder.run(line).fine();
    let first = files(&folder.path().join("out"));
    let path = folder.path().join("work/tile-000002.pieces");
    let bytes = fs::read(&path).unwrap();
    fs::write(&path, &bytes[..bytes.len() - 1]).unwrap();
    let forced = format!("{line} --force");
    assert_eq!(
        folder.run(&forced).error(),
        "error: cannot read work/tile-000002.pieces: delete it and start again: it is damaged"
    );
    fs::remove_file(path).unwrap();
    folder.run(&forced).fine();
    assert!(first == files(&folder.path().join("out")));
}
