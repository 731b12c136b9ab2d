//! No two files of a crate import each other, but a parent and its child: what a file stands on can
//! be read without it. Read from the sources; the tests at the end of a file may look anywhere.
#![allow(
    clippy::expect_used,
    clippy::panic,
    reason = "a test, its helpers included"
)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The modules of a crate by their paths, such as `compare::rows`, and their code.
type Modules = BTreeMap<String, String>;

fn modules(folder: &Path, parent: &str, found: &mut Modules) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let stem = path.file_stem().expect("a name").to_string_lossy();
        let name = match (parent, &*stem) {
            ("", "lib" | "main") => String::new(),
            ("", stem) => stem.to_owned(),
            (parent, stem) => format!("{parent}::{stem}"),
        };
        if path.is_dir() {
            modules(&path, &name, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).expect("a source can be read");
            found.insert(name, code_of(&text));
        }
    }
}

/// A source without comments and the tests at its end.
fn code_of(text: &str) -> String {
    let lines = text.lines();
    let lines = lines.filter(|line| !line.trim_start().starts_with("//"));
    let mut code = lines.collect::<Vec<_>>().join("\n");
    if let Some(tests) = code.find("#[cfg(test)]\nmod tests {") {
        code.truncate(tests);
    }
    code
}

/// The paths that code names, from `crate`, `super` or `self` on, groups in braces taken apart.
fn paths(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for start in ["crate::", "super::", "self::"] {
        for (at, _) in code.match_indices(start) {
            let before = code[..at].chars().next_back();
            if !before.is_some_and(|c| c.is_alphanumeric() || "_:".contains(c)) {
                follow(&code[at..], "", &mut found);
            }
        }
    }
    found
}

/// Follows a path to its ends; gives what stands behind it.
fn follow<'a>(code: &'a str, before: &str, found: &mut Vec<String>) -> &'a str {
    let Some(mut rest) = code.strip_prefix('{') else {
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let end = code.find(|c| !is_name(c)).unwrap_or(code.len());
        let path = format!("{before}{}", &code[..end]);
        return match code[end..].strip_prefix("::") {
            Some(rest) => follow(rest, &(path + "::"), found),
            None => {
                found.push(path);
                &code[end..]
            }
        };
    };
    loop {
        rest = follow(rest.trim_start(), before, found);
        match rest.find([',', '}']) {
            Some(at) if rest[at..].starts_with(',') => rest = &rest[at + 1..],
            Some(at) => return &rest[at + 1..],
            None => return "",
        }
    }
}

/// The module that a path from another one leads to, or into.
fn target<'a>(path: &str, from: &str, modules: &'a Modules) -> Option<&'a str> {
    let mut place: Vec<&str> = from.split("::").filter(|name| !name.is_empty()).collect();
    for name in path.split("::") {
        match name {
            "crate" => place.clear(),
            "super" => drop(place.pop()),
            "self" => {}
            name => place.push(name),
        }
    }
    (0..=place.len()).rev().find_map(|n| {
        let (name, _) = modules.get_key_value(&place[..n].join("::"))?;
        Some(name.as_str())
    })
}

fn is_within(child: &str, parent: &str) -> bool {
    parent.is_empty() || child.starts_with(&format!("{parent}::"))
}

/// What each module imports, but for its parents and children.
fn imports(modules: &Modules) -> BTreeMap<&str, BTreeSet<&str>> {
    let of = |(name, code): (&String, &String)| -> BTreeSet<&str> {
        let paths = paths(code);
        let targets = paths.iter().filter_map(|path| target(path, name, modules));
        let apart = |t: &&str| t != name && !is_within(t, name) && !is_within(name, t);
        targets.filter(apart).collect()
    };
    let all = modules.iter();
    all.map(|(name, code)| (name.as_str(), of((name, code))))
        .collect()
}

/// A module that is on a way from itself to itself, if there is one.
fn circle(mut imports: BTreeMap<&str, BTreeSet<&str>>) -> Vec<String> {
    // Modules that import none of those left are on no circle.
    while let Some(free) = imports
        .iter()
        .find(|(_, of)| of.iter().all(|m| !imports.contains_key(m)))
        .map(|(name, _)| *name)
    {
        imports.remove(free);
    }
    let left = imports.iter();
    left.map(|(name, of)| format!("{name} imports {of:?}"))
        .collect()
}

#[test]
fn no_two_files_import_each_other() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let crates = fs::read_dir(root.join("crates")).expect("the crates can be read");
    let crates = crates.map(|entry| entry.expect("the crates can be read").path());
    let others = ["xtask", "benches"].map(|folder| root.join(folder));
    let mut wrong = Vec::new();
    for sources in crates.chain(others).map(|folder| folder.join("src")) {
        if sources.is_dir() {
            let mut found = Modules::new();
            modules(&sources, "", &mut found);
            let circle = circle(imports(&found));
            wrong.extend(
                circle
                    .iter()
                    .map(|line| format!("{}: {line}", sources.display())),
            );
        }
    }
    assert!(wrong.is_empty(), "circles among:\n{}", wrong.join("\n"));
}

#[test]
fn a_circle_is_found_and_a_parent_is_none() {
    let modules = |codes: &[(&str, &str)]| -> Modules {
        let codes = codes.iter();
        codes
            .map(|(name, code)| ((*name).to_owned(), code_of(code)))
            .collect()
    };
    let parent = modules(&[
        ("", "mod a;"),
        ("a", "use self::b::B;"),
        ("a::b", "use super::A;"),
    ]);
    assert!(circle(imports(&parent)).is_empty());
    let three = modules(&[
        ("", ""),
        ("a", "use crate::{b::B, c::{C, D}};"),
        ("b", "fn f() -> super::c::C {}"),
        (
            "c",
            "// use crate::b;\n#[cfg(test)]\nmod tests { use crate::a; }",
        ),
    ]);
    assert!(circle(imports(&three)).is_empty());
    let back = modules(&[("a", "use crate::b::B;"), ("b", "use super::a::A;")]);
    assert_eq!(circle(imports(&back)).len(), 2);
}
