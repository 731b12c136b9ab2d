//! `docs/formats.md` says what is so.

use crate::harness::{Folder, fixture, json};
use serde_json::Value;

const FORMATS: &str = include_str!("../../../../docs/formats.md");

/// The text below a heading, up to the next one.
fn section(heading: &str) -> &'static str {
    let start = format!("\n{heading}\n");
    let (_, text) = FORMATS
        .split_once(&start)
        .unwrap_or_else(|| panic!("no {heading}"));
    text.split("\n#").next().unwrap()
}

/// The cells of the rows of the table after a header row.
fn rows(text: &'static str, header: &str) -> Vec<Vec<&'static str>> {
    let (_, table) = text
        .split_once(header)
        .unwrap_or_else(|| panic!("no {header}"));
    let lines = table.trim_start().lines().skip(1);
    let lines = lines.take_while(|line| line.starts_with('|'));
    let cells = |line: &'static str| line.trim_matches(['|', ' ']).split(" | ").map(str::trim);
    lines.map(|line| cells(line).collect()).collect()
}

/// What stands between the outermost backticks.
fn code(cell: &str) -> &str {
    let inside = cell
        .strip_prefix('`')
        .and_then(|rest| rest.strip_suffix('`'))
        .unwrap();
    // Code that holds backticks itself may stand between two of them.
    inside
        .strip_prefix('`')
        .and_then(|rest| rest.strip_suffix('`'))
        .unwrap_or(inside)
}

#[test]
fn every_row_of_bad_input() {
    let rows = rows(
        section("## Bad input"),
        "| what | file | content | what is printed |",
    );
    assert!(rows.len() > 20);
    for row in rows {
        let [what, file, content, printed] = row[..] else {
            panic!("{row:?}")
        };
        let content = code(content).replace("\\n", "\n").replace("\\r", "\r");
        let content = content
            .replace("\\0", "\0")
            .replace("\\u{feff}", "\u{feff}");
        let inner = printed
            .strip_prefix('`')
            .and_then(|rest| rest.strip_suffix('`'))
            .unwrap();
        let folder = Folder::with(code(file), content);
        let run = folder.run(&format!("reconstruct {}", code(file)));
        assert_eq!(run.stderr, format!("{inner}\n"), "{what}");
        let expected = if inner.starts_with("error: ") { 2 } else { 0 };
        assert_eq!(run.status, Some(expected), "{what}");
    }
}

#[test]
fn every_other_bad_input_has_a_test() {
    let tests = [
        include_str!("archives.rs"),
        include_str!("bad_documents.rs"),
        include_str!("columns.rs"),
        include_str!("geometries.rs"),
        include_str!("models.rs"),
        include_str!("scans.rs"),
        include_str!("shapes.rs"),
        include_str!("bad_input.rs"),
        include_str!("content.rs"),
        include_str!("files.rs"),
        include_str!("tiles.rs"),
        include_str!("kept.rs"),
    ]
    .concat();
    let rows = rows(
        section("## Bad input"),
        "| what | what is printed after the file's name |",
    );
    assert!(rows.len() > 10);
    for row in rows {
        let printed = code(row[1]);
        assert!(tests.contains(printed), "no test says {printed}");
    }
}

#[test]
fn objects_have_the_documented_keys() {
    let folder = Folder::new();
    let curve = fixture("curves/wave.svg").display().to_string();
    folder
        .run(&format!("sample {curve} --rho 0.9 -o s.csv"))
        .fine();
    folder.write("z.csv", "x,y,z\n0,0,1\n4,0,2\n2,3,3\n");
    for (command, line) in [
        // What is known, heights and reasons have keys only where they are asked for.
        (
            "reconstruct",
            String::from("reconstruct z.csv --closed --curves 1 --keep z --why"),
        ),
        ("sample", format!("sample {curve} --rho 0.9")),
        ("check", format!("check {curve} s.csv --rho 0.9")),
        ("evaluate", format!("evaluate {curve} s.csv")),
        ("medial-axis", format!("medial-axis {curve}")),
        ("lfs", format!("lfs {curve}")),
        ("puzzle", format!("puzzle {curve}")),
        ("algorithms", String::from("algorithms")),
    ] {
        let object = json(&folder.run(&format!("{line} --json")).stdout);
        let Value::Object(object) = object else {
            panic!("{command}")
        };
        let mut keys: Vec<&str> = object.keys().map(String::as_str).collect();
        let rows = rows(section(&format!("### {command}")), "| key | value |");
        let mut documented: Vec<&str> = rows.iter().map(|row| code(row[0])).collect();
        keys.sort_unstable();
        documented.sort_unstable();
        assert_eq!(keys, documented, "{command}");
    }
}

/// The commands of the README, in a folder with the fixtures, print what it says they print.
#[cfg(unix)]
#[test]
fn the_readme_is_true() {
    use std::path::Path;
    use std::process::Command;
    let readme = include_str!("../../../../README.md");
    let (_, block) = readme.split_once("```console\n").unwrap();
    let (block, _) = block.split_once("```").unwrap();
    let folder = Folder::new();
    std::os::unix::fs::symlink(fixture("."), folder.path().join("fixtures")).unwrap();
    let programs = Path::new(env!("CARGO_BIN_EXE_curvecrust"))
        .parent()
        .unwrap();
    let path = format!("{}:{}", programs.display(), std::env::var("PATH").unwrap());
    let mut count = 0;
    for step in block.split("$ ").skip(1) {
        let (line, printed) = step.split_once('\n').unwrap();
        let mut command = Command::new("sh");
        command
            .args(["-c", &format!("{line} 2>&1")])
            .env("PATH", &path);
        let output = command.current_dir(folder.path()).output().unwrap();
        assert_eq!(String::from_utf8(output.stdout).unwrap(), printed, "{line}");
        assert!(output.status.success(), "{line}");
        count += 1;
    }
    assert!(count > 4);
}
