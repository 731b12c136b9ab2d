//! What a reconstruction of many points takes beyond the points themselves.

use crate::harness::Folder;
use std::fs;
use std::io::Read;
use std::process::{Child, Stdio};
use std::time::Duration;

/// Circles of 1000 points, every ring of its own or in another, far from the order of the curves.
fn circles(count: u32) -> Vec<u8> {
    let rows = 1000 * count;
    let fields = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, 2), }}");
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(format!("{fields:<117}\n").bytes());
    // 611 and 1000 count have no factor in common unless 13 or 47 divides the count.
    for i in (0..rows).map(|i| i * 611 % rows) {
        let (circle, turn) = (
            i / 1000,
            std::f64::consts::TAU * f64::from(i % 1000) / 1000.0,
        );
        let radius = f64::from(1 + circle % 2);
        let centre = f64::from(circle / 2) * 5.0;
        bytes.extend((centre + radius * turn.cos()).to_le_bytes());
        bytes.extend((radius * turn.sin()).to_le_bytes());
    }
    bytes
}

/// The most memory that a run has held, in bytes, when it has less than a pipe's content left to
/// print.
fn peak(folder: &Folder, line: &str) -> u64 {
    let mut command = folder.command(line);
    let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
    let mut stdout = child.stdout.take().unwrap();
    let mut peak = 0;
    let mut buffer = vec![0; 1 << 16];
    while stdout.read(&mut buffer).unwrap() > 0 {
        peak = peak.max(so_far(&child));
    }
    assert!(child.wait().unwrap().success());
    peak
}

/// The most memory that a program has held; 0 when it has ended.
fn so_far(child: &Child) -> u64 {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    let kilobytes: Option<u64> =
        line.and_then(|l| l.trim().strip_suffix("kB")?.trim().parse().ok());
    1024 * kilobytes.unwrap_or(0)
}

#[test]
fn every_output_is_written_within_64_bytes_a_point() {
    let count = 300;
    let folder = Folder::with("few.npy", circles(2));
    folder.write("many.npy", circles(count));
    for format in ["csv", "json", "geojson", "wkt", "wkb", "dxf", "svg"] {
        let of = |name: &str| {
            let line = format!(
                "reconstruct {name} --algorithm hnn-crust --to {format} --quiet --threads 2"
            );
            peak(&folder, &line)
        };
        let (least, most) = (of("few.npy"), of("many.npy"));
        let beyond = most.saturating_sub(least) as f64 / f64::from(1000 * count) - 16.0;
        // 30.6 of ten million: most while neighbours are sought, whatever is written then.
        assert!(beyond < 64.0, "{format}: {beyond} bytes a point");
    }
}

#[test]
fn tiles_stay_within_their_memory() {
    let folder = Folder::with("many.npy", circles(1000));
    for output in [
        "-o edges.npy",
        "--polylines curves",
        "-o edges.npy --algorithm crust --force",
    ] {
        let line = "reconstruct many.npy --tiles work --memory 64MiB --quiet --threads 2";
        let mut child = folder.command(&format!("{line} {output}")).spawn().unwrap();
        let mut peak = 0;
        while child.try_wait().unwrap().is_none() {
            peak = peak.max(so_far(&child));
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(child.wait().unwrap().success());
        assert!((1..64 << 20).contains(&peak), "{output} {peak} bytes");
        fs::remove_dir_all(folder.path().join("work")).unwrap();
    }
}
