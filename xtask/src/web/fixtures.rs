//! The fixtures as a script of the page.

use anyhow::Context;
use curvecrust_lab::root;
use serde::Deserialize;
use serde_json::{Value, json};
use std::fs;

/// What is read of the list of fixtures.
#[derive(Deserialize)]
struct Manifest {
    #[serde(rename = "curve")]
    curves: Vec<Entry>,
    points: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    name: String,
    file: String,
}

/// A script that exports all curves as SVG and all point sets as lists of coordinates.
pub(super) fn script() -> anyhow::Result<String> {
    let manifest: Manifest = toml::from_str(&read("MANIFEST.toml")?)?;
    let mut curves = Vec::new();
    for Entry { name, file } in &manifest.curves {
        curves.push(json!({"name": name, "svg": read(file)?}));
    }
    let mut points = Vec::new();
    for Entry { name, file } in &manifest.points {
        points.push(json!({"name": name, "points": coordinates(&read(file)?)?}));
    }
    let (curves, points) = (Value::Array(curves), Value::Array(points));
    Ok(format!(
        "// Written by `cargo xtask web`.\nexport const curves = {curves};\nexport const points = {points};\n"
    ))
}

fn read(file: &str) -> anyhow::Result<String> {
    let path = root().join("fixtures").join(file);
    fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))
}

/// The numbers of a text with `x y` on each line, without comments.
fn coordinates(text: &str) -> anyhow::Result<Vec<f64>> {
    let lines = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or_default());
    let words = lines.flat_map(str::split_whitespace);
    words
        .map(|word| word.parse().with_context(|| format!("{word} is no number")))
        .collect()
}
