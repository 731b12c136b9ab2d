//! The process that unpacks LAZ, and how it may end.

use crate::harness::Folder;
use crate::point_files::read;
use las::{Builder, Point, Writer, point::Format};
use std::io::Cursor;

/// A scan of so many points with times.
fn scan(count: u32) -> Vec<u8> {
    let mut builder = Builder::from((1, 2));
    builder.point_format = Format::new(1).unwrap();
    builder.point_format.is_compressed = true;
    let header = builder.into_header().unwrap();
    let mut writer = Writer::new(Cursor::new(Vec::new()), header).unwrap();
    for i in (0..count).map(f64::from) {
        let point = Point {
            x: i,
            y: i * i % 7.0,
            gps_time: Some(100.0 + i / 4.0),
            ..Point::default()
        };
        writer.write_point(point).unwrap();
    }
    writer.into_inner().unwrap().into_inner()
}

/// A scan of 20 points that laspy wrote, with a run of ones in the packed points: the decoder reads
/// there, again and again, that a time belongs to another sequence.
const DAMAGED: &[u8] = include_bytes!("../data/full-stack.laz");

#[test]
fn a_full_stack_is_an_error() {
    let folder = Folder::with("p.laz", DAMAGED);
    let says = |name: &str| format!("error: {name}: the LAZ data cannot be decompressed: ");
    for line in [
        "reconstruct p.laz -o out.csv",
        "fit p.laz -o out.svg",
        "draw --points p.laz -o out.svg",
    ] {
        let message = folder.run(line).error();
        assert!(message.starts_with(&says("p.laz")), "{message}");
    }
    let message = folder.pipe("reconstruct - -o out.csv", DAMAGED).error();
    assert!(message.starts_with(&says("stdin")), "{message}");
    assert_eq!(folder.names(), ["p.laz"]);
}

#[test]
fn a_pipe_is_unpacked_as_a_file_is() {
    let bytes = scan(5000);
    let expected = Folder::with("p.laz", &bytes)
        .run("reconstruct p.laz --algorithm hnn-crust")
        .fine();
    let folder = Folder::new();
    let run = folder.pipe("reconstruct - --algorithm hnn-crust", &bytes);
    assert_eq!(run.fine(), expected);
    let (points, _) = read("p.laz", &bytes, "--algorithm hnn-crust");
    assert_eq!(points.as_array().unwrap().len(), 5000);
}

/// Nobody finds it by accident.
#[test]
fn it_is_no_command() {
    let folder = Folder::new();
    for line in ["--help", "completions bash", "completions zsh"] {
        assert!(!folder.run(line).fine().contains("decode-laz"), "{line}");
    }
}

#[cfg(target_os = "linux")]
mod ends {
    use super::scan;
    use crate::harness::{Folder, Run};
    use std::fs;
    use std::io::Write;
    use std::process::{Child, Command, Stdio};
    use std::thread::sleep;
    use std::time::Duration;

    /// The status of a process: its parent, and whether it runs.
    fn status(id: &str) -> Option<(u32, bool)> {
        let status = fs::read_to_string(format!("/proc/{id}/stat")).ok()?;
        let (_, fields) = status.rsplit_once(')')?;
        let mut fields = fields.split_whitespace();
        let is_running = fields.next()? != "Z";
        Some((fields.next()?.parse().ok()?, is_running))
    }

    /// What a function finds within half a minute.
    #[track_caller]
    fn awaited<T>(find: impl Fn() -> Option<T>) -> T {
        for _ in 0..3000 {
            if let Some(found) = find() {
                return found;
            }
            sleep(Duration::from_millis(10));
        }
        panic!("nothing came");
    }

    /// The program with a part of a file on stdin, the process that waits for the rest, and that.
    fn half_way(folder: &Folder) -> (Child, String, Vec<u8>) {
        let mut command = folder.command("reconstruct - -o out.csv");
        let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut program = pipes.stderr(Stdio::piped()).spawn().unwrap();
        let mut bytes = scan(20_000);
        let rest = bytes.split_off(8192);
        program.stdin.as_mut().unwrap().write_all(&bytes).unwrap();
        let decoder = awaited(|| {
            let entries = fs::read_dir("/proc").unwrap();
            let mut names = entries.filter_map(|e| e.ok()?.file_name().into_string().ok());
            // Until it is the program, it is a copy of the one that starts it.
            let is_it = |id: &str| {
                let words = fs::read(format!("/proc/{id}/cmdline")).unwrap_or_default();
                words.windows(10).any(|word| word == b"decode-laz")
            };
            names.find(|id| {
                status(id).is_some_and(|(parent, _)| parent == program.id()) && is_it(id)
            })
        });
        (program, decoder, rest)
    }

    #[test]
    fn a_decoder_that_is_killed_is_an_error() {
        let folder = Folder::new();
        let (mut program, decoder, rest) = half_way(&folder);
        let kill = Command::new("kill").args(["-KILL", &decoder]).status();
        assert!(kill.unwrap().success());
        // Nobody may take it any more.
        let _ = program.stdin.take().unwrap().write_all(&rest);
        let run: Run = program.wait_with_output().unwrap().into();
        assert_eq!(
            run.error(),
            "error: stdin: the LAZ data cannot be decompressed: signal 9 ended its decoder"
        );
        assert_eq!(folder.names(), [""; 0]);
    }

    #[test]
    fn a_decoder_ends_with_its_program() {
        let folder = Folder::new();
        let (mut program, decoder, _) = half_way(&folder);
        program.kill().unwrap();
        program.wait().unwrap();
        awaited(|| status(&decoder).is_none_or(|(_, runs)| !runs).then_some(()));
        assert_eq!(folder.names(), [""; 0]);
    }
}
