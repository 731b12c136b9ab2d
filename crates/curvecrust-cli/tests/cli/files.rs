//! Files are written completely or not at all, and never over others unasked.

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

#[cfg(unix)]
#[test]
fn a_link_to_nothing_is_followed() {
    use std::os::unix::fs::symlink;
    let folder = Folder::with("p.xy", POINTS);
    let link = |to: &str, name: &str| symlink(to, folder.path().join(name)).unwrap();
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    link("sub/other.csv", "link.csv");
    link("link.csv", "twice.csv");
    link("gone/out.csv", "bad.csv");
    link("loop.csv", "loop.csv");
    folder.run("reconstruct p.xy -o twice.csv").fine();
    assert!(folder.read("sub/other.csv").starts_with("chain,kind"));
    for name in ["link.csv", "twice.csv"] {
        assert!(folder.path().join(name).is_symlink());
    }
    // Before any work: the points would be an error too.
    for options in ["", " --force"] {
        let error = |out: &str| {
            folder
                .run(&format!("reconstruct gone.xy -o {out}{options}"))
                .error()
        };
        assert_eq!(
            error("bad.csv"),
            "error: cannot write bad.csv: there is no folder gone"
        );
        assert_eq!(
            error("loop.csv"),
            "error: cannot write loop.csv: its links lead to each other"
        );
    }
}

#[cfg(unix)]
#[test]
fn a_file_of_several_names_is_kept() {
    let folder = Folder::with("p.xy", POINTS);
    folder.write("out.csv", "precious");
    std::fs::hard_link(
        folder.path().join("out.csv"),
        folder.path().join("other.csv"),
    )
    .unwrap();
    let error = folder.run("reconstruct p.xy -o out.csv --force").error();
    assert_eq!(
        error,
        "error: cannot write out.csv: it has 2 names (hard links), of which only this one would be \
         replaced: remove it first"
    );
    assert_eq!(folder.read("other.csv"), "precious");
}

/// By root, who alone may give a file away.
#[cfg(unix)]
#[test]
fn a_file_keeps_its_owner() {
    use std::os::unix::fs::{MetadataExt, chown};
    let folder = Folder::with("p.xy", POINTS);
    folder.write("out.csv", "precious");
    let path = folder.path().join("out.csv");
    if chown(&path, Some(12345), Some(54321)).is_err() {
        eprintln!("skipped: only root can do this");
        return;
    }
    folder.run("reconstruct p.xy -o out.csv --force").fine();
    let found = path.metadata().unwrap();
    assert_eq!((found.uid(), found.gid()), (12345, 54321));
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
        "error: the name out.xyz has no known ending: give --to csv, json, geojson, wkt, wkb, gpx, \
         flatgeobuf, parquet, dxf, svg or npy"
    );
    assert_eq!(
        error("out.xy"),
        "error: this cannot be written as text: use csv, json, geojson, wkt, wkb, gpx, flatgeobuf, \
         parquet, dxf, svg or npy"
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
    let is_written = || {
        let names = folder.names().into_iter();
        let mut parts = names.filter(|name| name.ends_with(".part"));
        parts.any(|name| {
            folder
                .path()
                .join(name)
                .metadata()
                .is_ok_and(|found| found.len() > 0)
        })
    };
    while !is_written() {
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
