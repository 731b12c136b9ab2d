//! The list of fixtures, `fixtures/MANIFEST.toml`.

use crate::root::root;
use anyhow::Context;
use serde::Deserialize;
use std::fs;

/// What the list says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    /// Smooth curves, in the order of the file.
    pub(super) curve: Vec<CurveEntry>,
    /// Bare points.
    #[cfg_attr(not(test), expect(dead_code, reason = "held to the files by a test"))]
    pub(super) points: Vec<PointsEntry>,
}

/// A curve.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(not(test), expect(dead_code, reason = "held to the files by a test"))]
pub(super) struct CurveEntry {
    pub(super) name: String,
    pub(super) file: String,
    pub(super) shows: String,
    pub(super) segments: usize,
    pub(super) components: usize,
    pub(super) closed: bool,
    pub(super) source: String,
    pub(super) licence: String,
}

/// A set of points.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(not(test), expect(dead_code, reason = "held to the files by a test"))]
pub(super) struct PointsEntry {
    pub(super) name: String,
    pub(super) file: String,
    pub(super) shows: String,
    pub(super) points: usize,
    pub(super) source: String,
    pub(super) licence: String,
}

/// The list.
pub(super) fn read() -> anyhow::Result<Manifest> {
    let path = root().join("fixtures/MANIFEST.toml");
    let text =
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    toml::from_str(&text).with_context(|| path.display().to_string())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;
    use crate::compare::scene::{Named, Scene};
    use curvecrust::curve::{BezierPath, Curve};

    /// The files of a folder of the fixtures, as the manifest names them.
    fn files(folder: &str) -> Vec<String> {
        let entries = fs::read_dir(root().join("fixtures").join(folder)).unwrap();
        let name = |e: std::io::Result<fs::DirEntry>| e.unwrap().file_name().into_string().unwrap();
        let mut files: Vec<String> = entries.map(|e| format!("{folder}/{}", name(e))).collect();
        files.sort();
        files
    }

    #[test]
    fn the_manifest_and_the_files_agree() {
        let manifest = read().unwrap();
        let mut named: Vec<&str> = manifest.curve.iter().map(|c| &*c.file).collect();
        named.sort_unstable();
        assert_eq!(named, files("curves"));
        let mut named: Vec<&str> = manifest.points.iter().map(|p| &*p.file).collect();
        named.sort_unstable();
        assert_eq!(named, files("points"));

        for entry in &manifest.curve {
            let text = fs::read_to_string(root().join("fixtures").join(&entry.file)).unwrap();
            let curve = Curve::from_svg(&text).unwrap();
            let name = &entry.name;
            assert_eq!(entry.file, format!("curves/{name}.svg"));
            assert!(text.contains(&format!("id=\"{name}\"")), "{name}");
            let parts = curve.components();
            assert_eq!(parts.len(), entry.components, "{name}");
            assert!(
                parts.iter().all(|part| part.is_closed() == entry.closed),
                "{name}"
            );
            let segments = parts.iter().map(BezierPath::segments).map(<[_]>::len);
            assert_eq!(segments.sum::<usize>(), entry.segments, "{name}");
            assert!(
                !entry.shows.is_empty() && !entry.source.is_empty(),
                "{name}"
            );
            assert_eq!(entry.licence, "MIT OR Apache-2.0", "{name}");
        }
        for entry in &manifest.points {
            let text = fs::read_to_string(root().join("fixtures").join(&entry.file)).unwrap();
            let lines = text
                .lines()
                .filter(|l| !l.starts_with('#') && !l.trim().is_empty());
            assert_eq!(lines.count(), entry.points, "{}", entry.name);
            assert_eq!(entry.file, format!("points/{}.xy", entry.name));
            assert!(!entry.shows.is_empty() && !entry.source.is_empty());
            assert_eq!(entry.licence, "MIT OR Apache-2.0", "{}", entry.name);
        }
    }

    /// At least the kinds of curves that a comparison has to have.
    #[test]
    fn the_curves_are_of_many_kinds() {
        let manifest = read().unwrap();
        let count =
            |holds: fn(&CurveEntry) -> bool| manifest.curve.iter().filter(|&c| holds(c)).count();
        assert!(manifest.curve.len() >= 16);
        assert!(count(|c| !c.closed) >= 2 && count(|c| c.components > 1) >= 2);
        for kind in ["nested rings", "spiral", "1 to 1000", "nearly touching"] {
            assert!(
                manifest.curve.iter().any(|c| c.shows.contains(kind)),
                "{kind}"
            );
        }
    }

    /// What the list says of local feature sizes, measured.
    #[test]
    fn local_feature_sizes_vary_as_the_manifest_says() {
        let extremes = |name: &str| {
            let scene = Scene::named(&Named::Fixture(name.to_owned())).unwrap();
            let lfs = || scene.parts.iter().flat_map(|part| part.lfs.iter().copied());
            let [least, most] = [
                lfs().fold(f64::INFINITY, f64::min),
                lfs().fold(0.0, f64::max),
            ];
            [least, most].map(|lfs| lfs / scene.reference.extent())
        };
        let [least, most] = extremes("nautilus");
        println!("nautilus: lfs from {least} to {most} extents");
        assert!(most > 1000.0 * least);
        let [least, most] = extremes("eclipse");
        println!("eclipse: lfs from {least} to {most} extents");
        assert!(least < 0.01);
        let [least, most] = extremes("spiral");
        println!("spiral: lfs from {least} to {most} extents");
        assert!(least < 0.03 && most < 1.1 * least);
    }
}
