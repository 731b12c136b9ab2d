//! Threads, closed pipes and signals.
#![cfg(unix)]

use crate::harness::{Folder, Run, fixture};
use std::process::{Command, Stdio};

const SQUARE: &str = "0 0\n1 0\n1 1\n0 1\n";

/// As in a container that limits threads: none has the stack that is asked for here.
#[test]
fn where_no_thread_starts_the_calling_one_works() {
    let folder = Folder::with("p.xy", SQUARE);
    let expected = folder.run("reconstruct p.xy").fine();
    for options in ["", "--threads 2", "--threads 1"] {
        for output in ["", "-o out.csv --force"] {
            let mut command = folder.command(&format!("reconstruct p.xy {options} {output}"));
            let command = command.env("RUST_MIN_STACK", (1u64 << 60).to_string());
            let run: Run = command.output().unwrap().into();
            let stderr = run.stderr.clone();
            assert!(!stderr.contains("panic"), "{stderr}");
            let written = run.fine();
            let found = if output.is_empty() {
                written
            } else {
                folder.read("out.csv")
            };
            assert_eq!(found, expected);
            if options == "--threads 2" {
                assert!(
                    stderr.starts_with("only 1 of 2 threads could be started\n"),
                    "{stderr}"
                );
            }
        }
    }
}

#[test]
fn threads_are_limited_by_the_processors() {
    let folder = Folder::with("p.xy", SQUARE);
    let run = folder.run("reconstruct p.xy --threads 100000");
    let says = "--threads 100000 is limited to ";
    assert!(run.stderr.starts_with(says), "{}", run.stderr);
    run.fine();
    let run = folder.run("reconstruct p.xy --threads 1 --quiet");
    assert_eq!(run.stderr, "");
}

/// A pipe that nobody reads.
fn closed_pipe() -> Stdio {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    writer.into()
}

#[test]
fn a_verdict_needs_no_reader() {
    let folder = Folder::new();
    let curve = fixture("curves/wave.svg").display().to_string();
    folder
        .run(&format!("sample {curve} --rho 0.9 -o s.csv"))
        .fine();
    for (line, status) in [
        (format!("check {curve} s.csv --rho 0.1 -q"), 1),
        (format!("check {curve} s.csv --rho 0.1 -q --json"), 1),
        (format!("check {curve} s.csv --rho 0.9 -q"), 0),
        (format!("evaluate {curve} s.csv"), 0),
        (String::from("algorithms"), 0),
    ] {
        let mut command = folder.command(&line);
        let run: Run = command.stdout(closed_pipe()).output().unwrap().into();
        assert_eq!(
            (run.status, run.stderr.as_str()),
            (Some(status), ""),
            "{line}"
        );
    }
}

/// Rust's runtime puts the null device in the place of a stdout that is closed: nothing fails, but
/// it is said.
#[test]
fn what_a_closed_stdout_loses_is_said() {
    let folder = Folder::with("p.xy", SQUARE);
    let run = |line: &str| -> Run {
        let program = env!("CARGO_BIN_EXE_curvecrust");
        let mut command = Command::new("sh");
        command.args(["-c", &format!("'{program}' {line}")]);
        command.current_dir(folder.path()).output().unwrap().into()
    };
    let says = "stdout is closed: what was printed there is lost\n";
    let closed = run("reconstruct p.xy >&-");
    assert_eq!(closed.status, Some(0));
    assert!(closed.stderr.ends_with(says), "{}", closed.stderr);
    for line in [
        "reconstruct p.xy -o out.csv >&-",
        "reconstruct p.xy > /dev/null",
    ] {
        let run = run(line);
        assert_eq!(run.status, Some(0));
        assert!(!run.stderr.contains("closed"), "{line}: {}", run.stderr);
    }
}

/// Kills a program while it writes, so that it cannot clean up.
#[test]
fn what_a_killed_run_left_is_removed_by_the_next() {
    let folder = Folder::with("p.xy", SQUARE);
    let many: String = (0..500_000).map(|i| format!("{i} 0\n")).collect();
    folder.write("many.xy", many);
    let left = |folder: &Folder| {
        let names = folder.names().into_iter();
        names
            .filter(|name| name.ends_with(".part"))
            .collect::<Vec<_>>()
    };
    let mut command = folder.command("reconstruct many.xy --algorithm hnn-crust -o out.geojson");
    let mut child = command.stderr(Stdio::null()).spawn().unwrap();
    // The first one is removed at once: it only shows that there could be one.
    let is_written = || {
        let sizes = left(&folder).into_iter();
        let sizes = sizes.filter_map(|name| folder.path().join(name).metadata().ok());
        sizes.map(|found| found.len()).any(|size| size > 0)
    };
    while !is_written() {
        assert!(child.try_wait().unwrap().is_none(), "it was too fast");
        std::thread::yield_now();
    }
    // While it is written, it is nobody else's.
    assert!(
        Command::new("kill")
            .args(["-STOP", &child.id().to_string()])
            .status()
            .unwrap()
            .success()
    );
    folder.run("reconstruct p.xy -o first.csv").fine();
    assert_eq!(left(&folder).len(), 1);
    child.kill().unwrap();
    child.wait().unwrap();
    folder.run("reconstruct p.xy -o second.csv").fine();
    assert_eq!(
        folder.names(),
        ["first.csv", "many.xy", "p.xy", "second.csv"]
    );
}
