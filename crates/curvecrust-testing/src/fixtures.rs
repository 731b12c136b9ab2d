//! The folder `fixtures`: drawings and point sets made for this project, and their list
//! `MANIFEST.toml`.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use curvecrust_curve::Curve;
use curvecrust_geometry::DVec2;
use serde::Deserialize;

/// The list of fixtures.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Smooth curves, in the order of the file.
    #[serde(rename = "curve")]
    pub curves: Vec<CurveEntry>,
    /// Bare points, in the order of the file.
    pub points: Vec<PointsEntry>,
}

/// A drawing of the list.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CurveEntry {
    /// Its name, which is the id of its path.
    pub name: String,
    /// Its file, from the folder of the list.
    pub file: String,
    /// What is special about it.
    pub shows: String,
    /// The number of its cubics.
    pub segments: usize,
    /// The number of its components.
    pub components: usize,
    /// Whether its components are closed.
    pub closed: bool,
    /// Where it comes from.
    pub source: String,
    /// On what terms.
    pub licence: String,
}

/// A point set of the list.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointsEntry {
    /// Its name.
    pub name: String,
    /// Its file, from the folder of the list.
    pub file: String,
    /// What is special about it.
    pub shows: String,
    /// The number of its points.
    pub points: usize,
    /// Where it comes from.
    pub source: String,
    /// On what terms.
    pub licence: String,
}

/// A file of the folder `fixtures`, or with the name `.` the folder itself.
#[must_use]
pub fn path(name: &str) -> PathBuf {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    crates.join(name)
}

impl Manifest {
    /// Reads the list.
    ///
    /// # Errors
    /// The file cannot be read, or is no such list.
    pub fn read() -> io::Result<Self> {
        let path = path("MANIFEST.toml");
        let text = fs::read_to_string(&path)?;
        let place = |error| io::Error::other(format!("{}: {error}", path.display()));
        toml::from_str(&text).map_err(place)
    }
}

/// All curves with their names, sorted by them.
#[must_use]
pub fn curves() -> Vec<(String, Curve)> {
    let entries = Manifest::read().unwrap().curves.into_iter();
    let mut curves: Vec<_> = entries.map(|e| (e.name, read_curve(&e.file))).collect();
    curves.sort_by(|a, b| a.0.cmp(&b.0));
    assert!(curves.len() >= 20);
    curves
}

/// The curve of a name.
#[must_use]
pub fn curve(name: &str) -> Curve {
    read_curve(&format!("curves/{name}.svg"))
}

/// All point sets with their names, sorted by them; the points in the order of their files.
#[must_use]
pub fn points() -> Vec<(String, Vec<DVec2>)> {
    let entries = Manifest::read().unwrap().points.into_iter();
    let mut points: Vec<_> = entries.map(|e| (e.name, read_points(&e.file))).collect();
    points.sort_by(|a, b| a.0.cmp(&b.0));
    points
}

fn read_curve(file: &str) -> Curve {
    let document = fs::read_to_string(path(file)).unwrap();
    Curve::from_svg(&document).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn read_points(file: &str) -> Vec<DVec2> {
    let text = fs::read_to_string(path(file)).unwrap();
    xy_points(&text)
}

/// The points of a text with `x y` on each line; what follows a `#` is a comment.
#[must_use]
pub fn xy_points(text: &str) -> Vec<DVec2> {
    let point = |line: &str| {
        let line = line.split('#').next()?;
        let mut numbers = line.split_whitespace().map(|n| n.parse().unwrap());
        Some(DVec2::new(numbers.next()?, numbers.next()?))
    };
    text.lines().filter_map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_curve::BezierPath;

    /// The files of a folder of the fixtures, as the list names them.
    fn files(folder: &str) -> Vec<String> {
        let entries = fs::read_dir(path(folder)).unwrap();
        let name = |e: io::Result<fs::DirEntry>| e.unwrap().file_name().into_string().unwrap();
        let mut files: Vec<String> = entries.map(|e| format!("{folder}/{}", name(e))).collect();
        files.sort();
        files
    }

    #[test]
    fn the_list_and_the_files_agree() {
        let manifest = Manifest::read().unwrap();
        let mut named: Vec<&str> = manifest.curves.iter().map(|c| &*c.file).collect();
        named.sort_unstable();
        assert_eq!(named, files("curves"));
        let mut named: Vec<&str> = manifest.points.iter().map(|p| &*p.file).collect();
        named.sort_unstable();
        assert_eq!(named, files("points"));

        for entry in &manifest.curves {
            let name = &entry.name;
            assert_eq!(entry.file, format!("curves/{name}.svg"));
            let text = fs::read_to_string(path(&entry.file)).unwrap();
            assert!(text.contains(&format!("id=\"{name}\"")), "{name}");
            let curve = curve(name);
            let parts = curve.components();
            assert_eq!(parts.len(), entry.components, "{name}");
            let closed = parts.iter().filter(|part| part.is_closed()).count();
            assert_eq!(closed, if entry.closed { parts.len() } else { 0 }, "{name}");
            let segments = parts.iter().map(BezierPath::segments).map(<[_]>::len);
            assert_eq!(segments.sum::<usize>(), entry.segments, "{name}");
            assert!(
                !entry.shows.is_empty() && !entry.source.is_empty(),
                "{name}"
            );
            assert_eq!(entry.licence, "MIT OR Apache-2.0", "{name}");
        }
        for entry in &manifest.points {
            assert_eq!(
                read_points(&entry.file).len(),
                entry.points,
                "{}",
                entry.name
            );
            assert_eq!(entry.file, format!("points/{}.xy", entry.name));
            assert!(!entry.shows.is_empty() && !entry.source.is_empty());
            assert_eq!(entry.licence, "MIT OR Apache-2.0", "{}", entry.name);
        }
    }

    /// At least the kinds of curves that a comparison has to have.
    #[test]
    fn the_curves_are_of_many_kinds() {
        let curves = Manifest::read().unwrap().curves;
        let count = |holds: fn(&CurveEntry) -> bool| curves.iter().filter(|&c| holds(c)).count();
        assert!(count(|c| !c.closed) >= 2 && count(|c| c.components > 1) >= 2);
        for kind in ["nested rings", "spiral", "1 to 1000", "nearly touching"] {
            assert!(curves.iter().any(|c| c.shows.contains(kind)), "{kind}");
        }
    }

    #[test]
    fn comments_and_blank_lines_are_no_points() {
        let points = xy_points("# x y\n1 2\n\n 3\t4 # five\n");
        assert_eq!(points, [DVec2::new(1.0, 2.0), DVec2::new(3.0, 4.0)]);
    }
}
