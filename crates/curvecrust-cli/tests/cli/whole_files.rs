//! Files are written whole or not at all, and never over others unasked.

use crate::harness::{Folder, Run};
use std::io::Read;
use std::process::Stdio;

const POINTS: &str = "0 0\n1 0\n2 0\n";

#[test]
fn an_existing_file_is_kept_unless_forced() {
    let folder = Folder::with("p.xy", POINTS);
    folder.write("out.csv", "precious");
    let error = folder.run("reconstruct p.xy -o out.csv").error();
    assert_eq!(error, "error: out.csv exists: pass --force to overwrite it");
    assert_eq!(folder.read("out.csv"), "precious");
    folder.run("reconstruct p.xy -o out.csv --force").fine();
    assert!(folder.read("out.csv").starts_with("chain,kind"));
    assert_eq!(folder.names(), ["out.csv", "p.xy"]);
}

#[cfg(unix)]
#[test]
fn a_file_has_the_permissions_of_a_new_one() {
    use std::fs;
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::with("p.xy", POINTS);
    let mode = |name: &str| {
        fs::metadata(folder.path().join(name))
            .unwrap()
            .permissions()
            .mode()
    };
    folder.run("reconstruct p.xy -o out.csv").fine();
    assert_eq!(mode("out.csv"), mode("p.xy"));

    // A file that is replaced keeps its own, and a link to it stays a link.
    fs::set_permissions(
        folder.path().join("out.csv"),
        PermissionsExt::from_mode(0o640),
    )
    .unwrap();
    symlink("out.csv", folder.path().join("link.csv")).unwrap();
    folder.run("reconstruct p.xy -o link.csv --force").fine();
    assert_eq!(mode("out.csv") & 0o777, 0o640);
    assert!(folder.path().join("link.csv").is_symlink());
}

#[test]
fn what_cannot_be_written_is_an_error_and_leaves_nothing() {
    let folder = Folder::with("p.xy", POINTS);
    let error = |out: &str| folder.run(&format!("reconstruct p.xy -o {out}")).error();
    assert_eq!(error("."), "error: cannot write .: it is a folder");
    assert_eq!(
        error("gone/out.csv"),
        "error: cannot write gone/out.csv: there is no folder gone"
    );
    assert_eq!(
        error("out.xyz"),
        "error: the name out.xyz tells no format: give --to csv, json, geojson, wkt, dxf, svg or npy"
    );
    assert_eq!(
        error("out.xy"),
        "error: this cannot be written as text: use csv, json, geojson, wkt, dxf, svg or npy"
    );
    assert_eq!(folder.names(), ["p.xy"]);
}

/// Where nobody may make a file, not even root.
#[cfg(target_os = "linux")]
#[test]
fn an_output_that_is_not_writable_is_an_error() {
    let folder = Folder::with("p.xy", POINTS);
    let found = folder
        .run("reconstruct p.xy -o /sys/curvecrust.csv")
        .error();
    let says = "error: cannot write /sys/curvecrust.csv: ";
    // The second where /sys is mounted to be read only.
    let reasons = [
        "permission denied",
        "read-only filesystem or storage medium",
    ];
    assert!(
        reasons.map(|r| format!("{says}{r}")).contains(&found),
        "{found}"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    let folder = Folder::with("p.xy", POINTS);
    let error = folder.run("reconstruct p.xy -o /dev/full --to csv").error();
    assert_eq!(
        error,
        "error: cannot write /dev/full: No space left on device (os error 28)"
    );
    let full = std::fs::File::options()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let run: Run = folder
        .command("reconstruct p.xy")
        .stdout(full)
        .output()
        .unwrap()
        .into();
    assert_eq!(
        run.error(),
        "error: cannot write to stdout: No space left on device (os error 28)"
    );
}

/// A file system of 64 kB, in a name space of its own, where that is allowed.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_fills_up_keeps_no_half_file() {
    use std::process::Command;
    let folder = Folder::new();
    let many: String = (0..10_000).map(|i| format!("{i} 0\n")).collect();
    folder.write("many.xy", many);
    std::fs::create_dir(folder.path().join("disk")).unwrap();
    let in_disk = |script: &str| {
        let script = format!("mount -t tmpfs -o size=64k none disk && {script}");
        let mut command = Command::new("unshare");
        command.args(["--user", "--map-root-user", "--mount", "sh", "-c", &script]);
        command.current_dir(folder.path()).output()
    };
    if !in_disk("true").is_ok_and(|run| run.status.success()) {
        eprintln!("skipped: no file system can be mounted here");
        return;
    }
    let program = env!("CARGO_BIN_EXE_curvecrust");
    let line = format!("{{ '{program}' reconstruct many.xy -o disk/out.csv; ls -A disk; }}");
    let run: Run = in_disk(&line).unwrap().into();
    assert_eq!(run.stdout, "");
    assert_eq!(
        run.stderr,
        "error: cannot write disk/out.csv: No space left on device (os error 28)\n"
    );
}

#[cfg(unix)]
#[test]
fn who_stops_reading_hears_no_complaint() {
    let folder = Folder::new();
    let many: String = (0..100_000).map(|i| format!("{i} 0\n")).collect();
    folder.write("many.xy", many);
    let mut child = folder
        .command("reconstruct many.xy --quiet")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdout = child.stdout.take().unwrap();
    stdout.read_exact(&mut [0; 100]).unwrap();
    drop(stdout);
    let run: Run = child.wait_with_output().unwrap().into();
    assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""));
}

#[cfg(unix)]
#[test]
fn interrupted_it_leaves_no_half_file() {
    use std::process::Command;
    let folder = Folder::new();
    // Half a million points are written for long enough to be interrupted.
    let many: String = (0..500_000).map(|i| format!("{i} 0\n")).collect();
    folder.write("many.xy", many);
    let mut command = folder.command("reconstruct many.xy -o out.geojson");
    let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
    while !folder.names().iter().any(|name| name.ends_with(".part")) {
        assert!(child.try_wait().unwrap().is_none(), "it was too fast");
        std::thread::yield_now();
    }
    let id = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &id])
            .status()
            .unwrap()
            .success()
    );
    let run: Run = child.wait_with_output().unwrap().into();
    assert_eq!((run.status, run.stderr.as_str()), (Some(130), ""));
    assert_eq!(folder.names(), ["many.xy"]);
}
