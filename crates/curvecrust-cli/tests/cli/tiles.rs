//! `reconstruct --tiles`: the same bytes as at once, whatever the tiles, and whatever happens.

use crate::harness::Folder;
use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// An array of points, as 64 bit numbers.
fn npy(points: &[[f64; 2]]) -> Vec<u8> {
    array(
        "<f8",
        2,
        points.iter().flatten().flat_map(|x| x.to_le_bytes()),
        points.len(),
    )
}

fn array(kind: &str, columns: usize, numbers: impl Iterator<Item = u8>, rows: usize) -> Vec<u8> {
    let fields =
        format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{fields:<117}\n").bytes());
    bytes.extend(numbers);
    bytes
}

/// Rings and open curves that cross many tiles, in no order.
fn curves(count: u32) -> Vec<[f64; 2]> {
    let point = |i: u32| {
        let i = i * 7919 % count;
        let (curve, turn) = (i / 500, f64::from(i % 500) / 500.0);
        let turn = if curve % 2 == 0 { turn } else { 0.8 * turn };
        let angle = turn * std::f64::consts::TAU;
        let radius = 1.0 + 0.2 * (5.0 * angle).sin();
        [
            f64::from(curve) * 2.5 + radius * angle.cos(),
            radius * angle.sin(),
        ]
    };
    (0..count).map(point).collect()
}

/// What a run at once writes.
fn at_once(folder: &Folder, options: &str) -> Vec<u8> {
    let line = format!("reconstruct p.npy {options} -o once.npy --force");
    folder.run(&line).fine();
    fs::read(folder.path().join("once.npy")).unwrap()
}

fn tiled(folder: &Folder, options: &str) -> Vec<u8> {
    let _ = fs::remove_dir_all(folder.path().join("work"));
    let line = format!("reconstruct p.npy --tiles work {options} -o tiled.npy --force");
    folder.run(&line).fine();
    fs::read(folder.path().join("tiled.npy")).unwrap()
}

#[test]
fn the_same_bytes_for_tiles_of_any_size() {
    let folder = Folder::with("p.npy", npy(&curves(3000)));
    for algorithm in ["hnn-crust", "hnn-crust-union", "nn-crust", "crust"] {
        let options = format!("--algorithm {algorithm}");
        let expected = at_once(&folder, &options);
        for size in [40, 1499, 10_000] {
            let options = format!("{options} --tile-points {size} --threads 2");
            assert!(tiled(&folder, &options) == expected, "{options}");
        }
        let options = format!("{options} --memory 64MiB");
        assert!(tiled(&folder, &options) == expected, "{options}");
    }
    // A tile may be a single point.
    let folder = Folder::with("p.npy", npy(&curves(120)));
    let expected = at_once(&folder, "--algorithm hnn-crust");
    assert!(tiled(&folder, "--tile-points 1") == expected);
    let expected = at_once(&folder, "--algorithm crust");
    assert!(tiled(&folder, "--algorithm crust --tile-points 1") == expected);
}

#[test]
fn every_kind_of_array_by_rows() {
    let points = curves(1000);
    let numbers = || points.iter().flatten().copied();
    #[expect(clippy::cast_possible_truncation, reason = "rounded")]
    let single = |x: f64| x as f32;
    let with_heights = points.iter().flat_map(|&[x, y]| [x, y, 7.0]);
    let arrays = [
        array(">f8", 2, numbers().flat_map(f64::to_be_bytes), 1000),
        array(
            "<f4",
            2,
            numbers().flat_map(|x| single(x).to_le_bytes()),
            1000,
        ),
        array(
            ">f4",
            2,
            numbers().flat_map(|x| single(x).to_be_bytes()),
            1000,
        ),
        array("<f8", 3, with_heights.flat_map(f64::to_le_bytes), 1000),
    ];
    for bytes in arrays {
        let folder = Folder::with("p.npy", bytes);
        let expected = at_once(&folder, "--algorithm hnn-crust");
        assert!(tiled(&folder, "--tile-points 90") == expected);
    }
}

#[test]
fn a_last_point_that_repeats_the_first_is_the_first() {
    let mut points = curves(1000);
    points.push(points[0]);
    let folder = Folder::with("p.npy", npy(&points));
    let expected = at_once(&folder, "--algorithm hnn-crust");
    assert!(tiled(&folder, "--tile-points 90") == expected);
    let line = "reconstruct p.npy --tiles work --tile-points 90 -o tiled.npy --force";
    let says = "p.npy: the last point repeats the first, which stands for both\n\
                1000 points in 12 tiles, ";
    let stderr = folder.run(line).stderr;
    assert!(stderr.starts_with(says), "{stderr}");
}

/// The results of tiles that are there, by the end of their names.
fn results(folder: &Folder, end: &str) -> Vec<String> {
    let entries = fs::read_dir(folder.path().join("work"));
    let names = entries.into_iter().flatten().flatten();
    let names = names.filter_map(|entry| entry.file_name().into_string().ok());
    names.filter(|name| name.ends_with(end)).collect()
}

#[test]
fn a_run_that_was_killed_goes_on() {
    check_killed("hnn-crust", ".result");
    check_killed("crust", ".stars");
}

/// Kills a run again and again, when there are so many results.
fn check_killed(algorithm: &str, end: &str) {
    let folder = Folder::with("p.npy", npy(&curves(40_000)));
    let algorithm = format!("--algorithm {algorithm}");
    let expected = at_once(&folder, &algorithm);
    let line = &format!(
        "reconstruct p.npy --tiles work --tile-points 400 {algorithm} -o tiled.npy --force"
    );
    // So many tiles are solved when it is killed.
    for tiles in [0, 1, 30, 70, 99] {
        let mut command = folder.command(line);
        let mut child = command.stderr(Stdio::null()).spawn().unwrap();
        let start = Instant::now();
        while results(&folder, end).len() < tiles && child.try_wait().unwrap().is_none() {
            assert!(start.elapsed() < Duration::from_secs(60));
            std::thread::yield_now();
        }
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let first = folder.path().join(format!("work/tile-000000{end}"));
    let written = fs::metadata(&first)
        .and_then(|found| found.modified())
        .unwrap();
    let first_run = folder.run(line);
    let message = first_run.stderr.clone();
    first_run.fine();
    assert!(fs::read(folder.path().join("tiled.npy")).unwrap() == expected);
    let again = fs::metadata(&first)
        .and_then(|found| found.modified())
        .unwrap();
    assert_eq!(written, again, "what was finished is kept");
    // And once more, when all is done.
    assert_eq!(folder.run(line).stderr, message);
    assert!(fs::read(folder.path().join("tiled.npy")).unwrap() == expected);
}

#[test]
fn bad_points_are_named_by_file_and_row() {
    let mut points = curves(1000);
    points[617][1] = f64::NAN;
    let folder = Folder::with("p.npy", npy(&points));
    let line = "reconstruct p.npy --tiles work --tile-points 100 -o out.npy";
    assert_eq!(
        folder.run(line).error(),
        "error: p.npy, row 618, column 2: `NaN` is not a finite number"
    );
    points[617] = points[3];
    folder.write("p.npy", npy(&points));
    let [x, y] = points[3];
    assert_eq!(
        folder.run(line).error(),
        format!("error: points 3 and 617 are both ({x}, {y}): remove one")
    );
    let bytes = npy(&points);
    folder.write("p.npy", &bytes[..bytes.len() - 1]);
    assert_eq!(
        folder.run(line).error(),
        "error: p.npy: the array is cut off before the end of its 1000 rows"
    );
    assert!(!folder.path().join("out.npy").exists());
}

#[test]
fn a_folder_is_for_one_job() {
    let folder = Folder::with("p.npy", npy(&curves(1000)));
    let line = "reconstruct p.npy --tiles work --tile-points 100 -o out.npy --force";
    folder.run(line).fine();
    let error = |options: &str| folder.run(&format!("{line} {options}")).error();
    let start = "error: the folder work is for another job: ";
    let end = "; give another folder, or delete this one";
    assert_eq!(
        error("--algorithm nn-crust"),
        format!("{start}it runs hnn-crust, not nn-crust{end}")
    );
    let other_size = folder.run(&line.replace("100", "200"));
    assert_eq!(
        other_size.error(),
        format!("{start}it has another --memory{end}")
    );
    folder.write("p.npy", npy(&curves(999)));
    assert_eq!(
        error(""),
        format!(
            "{start}its input has another size or other columns, or was changed at another \
             time{end}"
        )
    );
    fs::create_dir(folder.path().join("mine")).unwrap();
    folder.write("mine/notes.txt", "keep");
    let other = line.replace("work", "mine");
    assert_eq!(
        folder.run(&other).error(),
        "error: cannot use the folder mine: it holds notes.txt, but no tiles: give a new or an \
         empty folder"
    );
    let nowhere = line.replace("work", "no/where");
    let error = folder.run(&nowhere).error();
    assert!(
        error.starts_with("error: cannot use the folder no/where: "),
        "{error}"
    );
}

#[test]
fn missing_and_damaged_tiles_are_named() {
    let folder = Folder::with("p.npy", npy(&curves(1000)));
    let line = "reconstruct p.npy --tiles work --tile-points 100 -o out.npy --force";
    folder.run(line).fine();
    let result = folder.path().join("work/tile-000004.result");
    let bytes = fs::read(&result).unwrap();
    fs::write(&result, &bytes[..bytes.len() - 5]).unwrap();
    assert_eq!(
        folder.run(line).error(),
        "error: cannot read work/tile-000004.result: delete it and start again: it is damaged"
    );
    fs::remove_file(&result).unwrap();
    let error = folder.run(line).error();
    let says = "error: work/tile-000004.result is missing, and work/chunk-000000, from which it is \
                made, cannot be read: delete the folder and start again: ";
    assert!(error.starts_with(says), "{error}");
    assert_eq!(
        results(&folder, ".result").len(),
        10,
        "the others, and what was joined, are kept"
    );
}

/// A limit for the size of files stands for a disk that is full.
#[cfg(unix)]
#[test]
fn a_full_disk_keeps_what_is_finished() {
    let folder = Folder::with("p.npy", npy(&curves(20_000)));
    let expected = at_once(&folder, "--algorithm hnn-crust");
    let line = "reconstruct p.npy --tiles work --tile-points 2000 -o tiled.npy";
    let program = env!("CARGO_BIN_EXE_curvecrust");
    // In KiB: a chunk has 94, the samples of a tile 47, the output 157.
    for (limit, file) in [(80, "work/chunk-000000"), (120, "tiled.npy")] {
        let script = format!("trap '' XFSZ; ulimit -f {limit}; exec {program} {line}");
        let mut command = std::process::Command::new("bash");
        let command = command.args(["-c", &script]).current_dir(folder.path());
        let run: crate::harness::Run = command.output().unwrap().into();
        let error = run.error();
        assert!(
            error.starts_with(&format!("error: cannot write {file}: ")),
            "{error}"
        );
        let left = fs::read_dir(folder.path().join("work")).unwrap();
        let left = left.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        assert!(!left.into_iter().any(|name| name.ends_with(".part")));
    }
    folder.run(line).fine();
    assert!(fs::read(folder.path().join("tiled.npy")).unwrap() == expected);
}

#[test]
fn what_tiles_are_not_for_is_refused() {
    let folder = Folder::with("p.npy", npy(&curves(100)));
    folder.write("p.csv", "x,y\n0,0\n1,0\n");
    let error = |line: &str| {
        folder
            .run(&format!("reconstruct --tiles work {line}"))
            .error()
    };
    assert_eq!(
        error("p.npy --algorithm least-detour"),
        "error: least-detour is not local enough for tiles: use hnn-crust, hnn-crust-union, \
         nn-crust, crust"
    );
    assert_eq!(
        error("p.csv"),
        "error: --tiles reads npy or parquet, and p.csv is csv"
    );
    assert_eq!(
        error("-"),
        "error: --tiles reads the points more than once: give a file"
    );
    assert_eq!(
        error("p.npy --memory 1MB"),
        "error: --memory has to be at least 64 MiB"
    );
    assert_eq!(
        error("p.npy -o out.csv"),
        "error: this cannot be written as csv: use npy"
    );
    for options in ["--closed", "--json", "--merge-duplicates", "--memory much"] {
        let run = folder.run(&format!(
            "reconstruct p.npy --tiles work {options} -o out.npy"
        ));
        assert_eq!(run.status, Some(2), "{options}");
    }
    let fields = "{'descr': '<f8', 'fortran_order': True, 'shape': (1, 2), }";
    let mut columns = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    columns.extend(format!("{fields:<117}\n").bytes());
    columns.extend([0; 16]);
    folder.write("columns.npy", columns);
    assert_eq!(
        error("columns.npy"),
        "error: columns.npy: the array is stored by columns: save it by rows, as \
         numpy.ascontiguousarray has it"
    );
    assert!(!folder.path().join("work").exists());
}
