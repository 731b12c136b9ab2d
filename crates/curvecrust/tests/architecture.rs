//! The design's invariants, read from `cargo metadata` and the sources. See `ARCHITECTURE.md`.
#![allow(
    clippy::expect_used,
    clippy::panic,
    reason = "a test, its helpers included"
)]

use cargo_metadata::semver::VersionReq;
use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Package};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The crates that each library may use, without the prefix of their names: what lies before it in
/// the flow of data. A new crate gets its line here.
const LIBRARIES: &[(&str, &[&str])] = &[
    ("geometry", &[]),
    ("curve", &["geometry"]),
    ("voronoi", &["geometry"]),
    ("medial-axis", &["geometry", "curve", "voronoi"]),
    // An algorithm sees bare points: neither curves nor what is derived from them.
    ("reconstruct", &["geometry", "voronoi"]),
    ("denoise", &["geometry", "voronoi", "reconstruct"]),
    ("tiles", &["geometry", "voronoi", "reconstruct"]),
    // Samples are verified by an algorithm; nothing leads back.
    (
        "sampling",
        &["geometry", "curve", "voronoi", "medial-axis", "reconstruct"],
    ),
    (
        "evaluate",
        &["geometry", "curve", "voronoi", "medial-axis", "sampling"],
    ),
    ("curvecrust", ALL_BUT_FACADE),
];
const ALL_BUT_FACADE: &[&str] = &[
    "geometry",
    "curve",
    "voronoi",
    "medial-axis",
    "sampling",
    "evaluate",
    "reconstruct",
    "denoise",
    "tiles",
];

/// What is no library: it may use every library, and nothing uses it.
const PROGRAMS: &[&str] = &["cli", "python", "web", "benches", "xtask"];

/// What is not published: it may use every library, and only what is not published uses it.
const LABORATORY: &[&str] = &["lab", "proof", "testing"];

/// Foreign crates that only these of ours may name, in whatever kind of dependency.
const NAMED_BY: &[(&str, &[&str])] = &[
    ("spade", &["voronoi"]),
    ("kurbo", &["curve"]),
    ("simplecss", &["curve"]),
    // The program and the page read points from SVG, which are no curves.
    ("roxmltree", &["curve", "cli", "web"]),
    ("svgtypes", &["curve", "cli"]),
    ("flatgeobuf", &["cli"]),
    ("las", &["cli"]),
    ("laz", &["cli"]),
    ("parquet", &["cli"]),
    ("zip", &["cli"]),
    ("anyhow", &["cli", "lab", "xtask"]),
    ("clap", &["cli", "xtask"]),
    ("pyo3", &["python"]),
    ("numpy", &["python"]),
];

/// What libraries never do. Words of the language and paths, as they stand in a source.
const NOT_IN_LIBRARIES: &[&str] = &[
    "println!",
    "eprintln!",
    "print!",
    "eprint!",
    "dbg!",
    "std::fs",
    "fs::",
    "File::",
    "std::env",
    "std::process",
    "process::exit",
];

const MOST_LINES: usize = 400;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The packages of the workspace; the network is not needed.
fn workspace() -> Metadata {
    MetadataCommand::new()
        .manifest_path(root().join("Cargo.toml"))
        .no_deps()
        .exec()
        .expect("cargo metadata reads the workspace")
}

/// The name of one of our crates without the prefix they share.
fn short(name: &str) -> &str {
    name.strip_prefix("curvecrust-").unwrap_or(name)
}

/// Whether the rules for libraries bind a package.
fn is_library(package: &Package) -> bool {
    let name = short(&package.name);
    !PROGRAMS.contains(&name) && !LABORATORY.contains(&name)
}

fn is_published(package: &Package) -> bool {
    package.publish.is_none()
}

/// The names of what a package is built with: not what only its tests use.
fn built_with(package: &Package) -> impl Iterator<Item = &str> {
    let dependencies = package.dependencies.iter();
    dependencies
        .filter(|d| d.kind != DependencyKind::Development)
        .map(|d| d.name.as_str())
}

/// Every Rust file below a folder, sorted.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn sources_of(package: &Package) -> Vec<PathBuf> {
    let manifest = package.manifest_path.as_std_path();
    sources(&manifest.with_file_name("src"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("cannot read {}: {e}", path.display()))
}

#[track_caller]
fn assert_none(violations: &[String], rule: &str) {
    assert!(violations.is_empty(), "{rule}:\n{}", violations.join("\n"));
}

#[test]
fn dependencies_follow_the_flow_of_data() {
    let metadata = workspace();
    let ours: BTreeSet<&str> = metadata.packages.iter().map(|p| p.name.as_str()).collect();
    let mut wrong = Vec::new();
    for package in metadata.packages.iter().filter(|p| is_library(p)) {
        let name = package.name.as_str();
        let Some((_, may_use)) = LIBRARIES.iter().find(|(n, _)| *n == short(name)) else {
            wrong.push(format!("{name} has no line in LIBRARIES"));
            continue;
        };
        let back = built_with(package).filter(|d| ours.contains(d) && !may_use.contains(&short(d)));
        wrong.extend(back.map(|d| format!("{name} uses {d}")));
    }
    assert_none(&wrong, "a dependency that the design does not have");
}

#[test]
fn nothing_uses_a_program() {
    let metadata = workspace();
    let mut wrong = Vec::new();
    for package in &metadata.packages {
        let all = package.dependencies.iter().map(|d| d.name.as_str());
        let programs = all.filter(|d| PROGRAMS.contains(&short(d)));
        // `python -m curvecrust` is the program.
        let programs = programs.filter(|d| [short(&package.name), short(d)] != ["python", "cli"]);
        wrong.extend(programs.map(|d| format!("{} uses {d}", package.name)));
    }
    assert_none(&wrong, "a program used as a library");
}

#[test]
fn nothing_published_uses_the_laboratory() {
    let metadata = workspace();
    let mut wrong = Vec::new();
    for package in &metadata.packages {
        let in_the_laboratory = LABORATORY.contains(&short(&package.name));
        if in_the_laboratory && is_published(package) {
            wrong.push(format!("{} is published", package.name));
        }
        let used = built_with(package).filter(|d| LABORATORY.contains(&short(d)));
        let used = used.filter(|_| is_published(package));
        wrong.extend(used.map(|d| format!("{} uses {d}", package.name)));
    }
    assert_none(&wrong, "the laboratory is not the product");
}

/// A dev-dependency without a version is left out of what is published.
#[test]
fn packages_leave_out_what_serves_tests() {
    let metadata = workspace();
    let mut wrong = Vec::new();
    for package in metadata.packages.iter().filter(|p| is_published(p)) {
        let ours = package.dependencies.iter();
        let kept = ours.filter(|d| short(&d.name) == "testing" && d.req != VersionReq::STAR);
        wrong.extend(kept.map(|_| package.name.to_string()));
    }
    assert_none(&wrong, "the test support is named with a version");
}

/// Invariant 1, of what the crates really use, whatever the table above allows.
#[test]
fn no_algorithm_can_see_the_truth() {
    let metadata = workspace();
    let mut reached = BTreeSet::from(["curvecrust-reconstruct"]);
    let mut open = vec!["curvecrust-reconstruct"];
    while let Some(name) = open.pop() {
        let package = metadata.packages.iter().find(|p| p.name == name);
        for used in package.into_iter().flat_map(built_with) {
            if reached.insert(used) {
                open.push(used);
            }
        }
    }
    assert!(reached.contains("curvecrust-geometry"));
    for truth in ["curve", "medial-axis", "sampling", "evaluate"] {
        let truth = format!("curvecrust-{truth}");
        assert!(
            !reached.contains(truth.as_str()),
            "curvecrust-reconstruct reaches {truth}"
        );
    }
}

/// Invariant 2, and the half of 3 that is about errors and arguments.
#[test]
fn foreign_crates_stay_behind_their_door() {
    let metadata = workspace();
    let mut wrong = Vec::new();
    for (foreign, doors) in NAMED_BY {
        for package in &metadata.packages {
            let names = package.dependencies.iter().any(|d| d.name == *foreign);
            if names && !doors.contains(&short(&package.name)) {
                wrong.push(format!("{} names {foreign}", package.name));
            }
        }
    }
    assert_none(&wrong, "a foreign crate that others have to hide");
}

/// Invariant 3. The lints `print_stdout` and `print_stderr` hold the printing; this scan, which
/// leaves out comments and the tests at the end of a file, holds the rest.
#[test]
fn libraries_print_nothing_read_no_files_and_never_exit() {
    let metadata = workspace();
    let mut wrong = Vec::new();
    for package in metadata.packages.iter().filter(|p| is_library(p)) {
        let is_test = |p: &PathBuf| p.ends_with("tests.rs") || p.iter().any(|c| c == "tests");
        for path in sources_of(package).iter().filter(|p| !is_test(p)) {
            let text = read(path);
            let code = text.lines().take_while(|l| *l != "#[cfg(test)]");
            for (number, line) in code.enumerate() {
                let comment = line.trim_start().starts_with("//");
                for word in NOT_IN_LIBRARIES.iter().filter(|w| !comment && has(line, w)) {
                    wrong.push(format!("{}:{}: {word}", path.display(), number + 1));
                }
            }
        }
    }
    assert_none(&wrong, "only programs do this");
}

/// Whether a line holds a word, and not only as the end of a longer one.
fn has(line: &str, word: &str) -> bool {
    let begins = |at: usize| {
        let before = line[..at].chars().next_back();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
    };
    line.match_indices(word).any(|(at, _)| begins(at))
}

#[test]
fn words_are_not_ends_of_words() {
    assert!(has("    println!()", "println!") && has("crate::fs::x", "fs::"));
    assert!(!has("use crate::lfs::Lfs;", "fs::") && !has("eprintln!()", "println!"));
}

#[test]
fn files_are_short() {
    let metadata = workspace();
    let mut wrong = Vec::new();
    for path in metadata.packages.iter().flat_map(sources_of) {
        let lines = read(&path).lines().count();
        if lines > MOST_LINES {
            wrong.push(format!("{}: {lines} lines", path.display()));
        }
    }
    assert_none(&wrong, "files of at most 400 lines");
}

#[test]
fn packages_are_fit_for_publishing() {
    let metadata = workspace();
    let workspace_manifest = read(&root().join("Cargo.toml"));
    let mut wrong = Vec::new();
    for package in metadata.packages.iter() {
        let name = &package.name;
        let manifest = read(package.manifest_path.as_std_path());
        let mut must = |holds: bool, what: &str| {
            if !holds {
                wrong.push(format!("{name}: {what}"));
            }
        };
        let linted = if ["python", "web"].contains(&short(name)) {
            // The macros of PyO3 expand to unsafe code, and exported names count as it.
            let clippy = workspace_manifest
                .split_once("[workspace.lints.clippy]\n")
                .and_then(|(_, after)| after.split("\n\n").next());
            let denied = "\n[lints.rust]\nunsafe_code = \"deny\"\n";
            manifest.contains(denied) && clippy.is_some_and(|lints| manifest.contains(lints))
        } else {
            manifest.contains("\n[lints]\nworkspace = true\n")
        };
        must(linted, "the lints of the workspace");
        must(
            package.license.as_deref() == Some("MIT OR Apache-2.0"),
            "license",
        );
        must(package.rust_version.is_some(), "rust-version");
        if !is_published(package) {
            continue;
        }
        let described = |text: &Option<String>| text.as_ref().is_some_and(|t| !t.is_empty());
        must(described(&package.description), "description");
        must((1..=5).contains(&package.keywords.len()), "1 to 5 keywords");
        must(!package.categories.is_empty(), "categories");
        let folder = package.manifest_path.with_file_name("");
        // Copies and no links, which not every system can check out.
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let copy = fs::read_to_string(folder.join(licence));
            let same = copy.is_ok_and(|text| text == read(&root().join(licence)));
            must(same, &format!("a copy of the top {licence}"));
        }
        let readme = package.readme();
        must(
            readme.is_some_and(|path| path.is_file() && path.starts_with(&folder)),
            "a readme of its own",
        );
        if package.targets.iter().any(|target| target.is_bin()) {
            continue;
        }
        let pages = format!("https://docs.rs/{name}");
        must(package.documentation == Some(pages), "documentation");
        let page = &package.metadata["docs"]["rs"];
        must(page["all-features"] == true, "all features on docs.rs");
    }
    assert_none(&wrong, "metadata that is missing");
}

#[test]
fn the_map_is_short_and_names_what_exists() {
    let map = read(&root().join("ARCHITECTURE.md"));
    let lines = map.lines().count();
    assert!(lines <= 150, "ARCHITECTURE.md has {lines} lines");

    let paths: Vec<PathBuf> = ["crates", "xtask", "benches"]
        .iter()
        .flat_map(|folder| sources(&root().join(folder)))
        .collect();
    let manifest = read(&root().join("Cargo.toml"));
    let texts: Vec<String> = paths.iter().map(|p| read(p)).chain([manifest]).collect();
    let is_name = |s: &str| s.chars().all(|c| c.is_alphanumeric() || "_:".contains(c));
    let exists = |name: &str| {
        if name.ends_with(".rs") {
            paths.iter().any(|path| path.ends_with(name))
        } else {
            let mut parts = name.split("::");
            !is_name(name) || parts.all(|part| texts.iter().any(|text| has(text, part)))
        }
    };
    // Names stand between backticks, every second part of a line.
    let names = map.lines().flat_map(|l| l.split('`').skip(1).step_by(2));
    let stale: Vec<String> = names.filter(|n| !exists(n)).map(String::from).collect();
    assert_none(&stale, "ARCHITECTURE.md names what is not there");
}
