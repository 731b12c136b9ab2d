//! `docs/noise.md` lists constants with their values; they are those of the code. The page is not
//! there in the published crate.
#![allow(
    clippy::expect_used,
    clippy::panic,
    reason = "a test, its helpers included"
)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The values of all constants, by module and name.
fn constants(folder: &Path, found: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        if path.is_dir() {
            constants(&path, found);
            continue;
        }
        let module = path.file_stem().expect("a name").to_string_lossy();
        let text = fs::read_to_string(&path).expect("a source can be read");
        for line in text.lines() {
            let Some((_, rest)) = line.split_once("const ") else {
                continue;
            };
            if let Some((name, value)) = rest.split_once(": ") {
                let value = value.split_once(" = ").map_or("", |(_, value)| value);
                found.insert(format!("{module}::{name}"), value.to_owned());
            }
        }
    }
}

/// The numbers in a text: `5_000` and `5,000` are the same, and `0.5 %` is 0.005.
fn numbers(text: &str) -> Vec<f64> {
    let plain = text.replace(['[', ']', ';'], " ").replace([',', '_'], "");
    let words: Vec<&str> = plain.split_whitespace().collect();
    let number = |(i, word): (usize, &&str)| {
        let value: f64 = word.parse().ok()?;
        let percent = words.get(i + 1) == Some(&"%");
        Some(if percent { value / 100.0 } else { value })
    };
    words.iter().enumerate().filter_map(number).collect()
}

#[test]
fn the_page_has_the_values_of_the_code() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let Ok(page) = fs::read_to_string(here.join("../../docs/noise.md")) else {
        return;
    };
    let mut code = BTreeMap::new();
    constants(&here.join("src"), &mut code);
    let (_, table) = page.split_once("## The constants").expect("the table");
    let mut count = 0;
    for row in table.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<&str> = row.split(" | ").collect();
        let listed = numbers(cells[1]);
        let mut module = "";
        for name in cells[0].split('`').skip(1).step_by(2) {
            let (of, name) = name.split_once("::").unwrap_or((module, name));
            module = of;
            let value = code.get(&format!("{module}::{name}"));
            let value = value.unwrap_or_else(|| panic!("{module}::{name} is no constant"));
            for number in numbers(value) {
                let is_it = |other: &f64| (other - number).abs() < 1e-9;
                assert!(
                    listed.iter().any(is_it),
                    "{module}::{name} is {value}, not {}",
                    cells[1]
                );
            }
            count += 1;
        }
    }
    assert!(count > 30, "{count} constants");
}
