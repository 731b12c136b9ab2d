//! Outlines from elsewhere: files of rings, whose points are the samples.
//!
//! Each line of a file is a JSON object with a `name` and `rings`, lists of pairs. The rings are
//! the truth: an edge joins each point to the next one.

use super::drawn::{Drawn, Sampled};
use super::true_curves::TrueCurves;
use crate::repository::files;
use anyhow::{Context, ensure};
use curvecrust::DVec2;
use curvecrust::geometry::{Component, EdgeSet, PointSet};
use serde::Deserialize;
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// A file of outlines.
#[derive(Debug)]
pub(super) struct Outlines {
    /// Of the file, without its ending.
    pub(super) name: String,
    outlines: Vec<Outline>,
}

/// Rings that belong together.
#[derive(Debug, Deserialize)]
struct Outline {
    name: String,
    rings: Vec<Vec<[f64; 2]>>,
}

/// The files of a folder that end in `.ndjson`, by their names.
pub(super) fn of_folder(folder: &Path) -> anyhow::Result<Vec<Outlines>> {
    let paths = files(folder, "ndjson")?;
    ensure!(
        !paths.is_empty(),
        "{} has no file that ends in .ndjson",
        folder.display()
    );
    paths.iter().map(|path| Outlines::read(path)).collect()
}

impl Outlines {
    fn read(path: &Path) -> anyhow::Result<Self> {
        let place = || path.display().to_string();
        let text = fs::read_to_string(path).with_context(place)?;
        let lines = text.lines().enumerate();
        let lines = lines.filter(|(_, line)| !line.trim().is_empty());
        let outlines = lines.map(|(i, line)| {
            serde_json::from_str(line).with_context(|| format!("{}, line {}", place(), i + 1))
        });
        let name = path.file_stem().unwrap_or_default();
        Ok(Self {
            name: name.to_string_lossy().into_owned(),
            outlines: outlines.collect::<anyhow::Result<_>>()?,
        })
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.outlines.len()
    }

    /// Every so many points of each ring of an outline; a ring keeps three points or more.
    pub(super) fn draw(&self, index: usize, every: usize) -> anyhow::Result<Drawn> {
        let outline = &self.outlines[index];
        let rings = outline.rings.iter().map(|ring| thinned(ring, every));
        let rings: Vec<Vec<DVec2>> = rings.collect();
        let mut edges = Vec::new();
        let mut first = 0;
        for ring in &rings {
            let range = first..first + ring.len();
            first = range.end;
            edges.extend(
                Component {
                    range,
                    closed: true,
                }
                .edges(),
            );
        }
        let points = PointSet::new(rings.concat()).with_context(|| outline.name.clone())?;
        let parts = rings.into_iter().map(|ring| (ring, true)).collect();
        Ok(Drawn {
            sampled: Sampled {
                boundary: EdgeSet::new(points.len(), edges),
                points,
                termini: Vec::new(),
            },
            curves: Arc::new(TrueCurves::polygonal(parts)),
        })
    }
}

/// Every so many points of a ring, and without the first one again at its end.
fn thinned(ring: &[[f64; 2]], every: usize) -> Vec<DVec2> {
    let mut ring: Vec<DVec2> = ring.iter().copied().map(DVec2::from_array).collect();
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    let every = every.clamp(1, (ring.len() / 3).max(1));
    ring.into_iter().step_by(every).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_are_read_and_thinned() {
        let folder = tempfile::tempdir().unwrap();
        let ring: Vec<[f64; 2]> = (0..12)
            .map(|i| DVec2::from_angle(f64::from(i) * 0.5).to_array())
            .collect();
        let closed = [&ring[..], &ring[..1]].concat();
        let line =
            serde_json::json!({"name": "two", "rings": [closed, [[9, 9], [10, 9], [9, 10]]]});
        fs::write(
            folder.path().join("b.ndjson"),
            format!("{line}\n\n{line}\n"),
        )
        .unwrap();
        fs::write(folder.path().join("a.txt"), "").unwrap();
        let [outlines] = &of_folder(folder.path()).unwrap()[..] else {
            panic!("there is one file")
        };
        assert_eq!((&*outlines.name, outlines.len()), ("b", 2));
        for (every, points) in [(1, 12 + 3), (2, 6 + 3), (100, 3 + 3)] {
            let drawn = outlines.draw(1, every).unwrap();
            assert_eq!(drawn.sampled.points.len(), points);
            let chains = drawn.sampled.boundary.chains();
            assert_eq!(chains.len(), 2);
            assert!(chains.iter().all(|chain| chain.is_closed()));
        }
    }

    #[test]
    fn what_is_no_outline_is_named_with_its_line() {
        let folder = tempfile::tempdir().unwrap();
        assert!(of_folder(folder.path()).is_err());
        let text = "{\"name\": \"a\", \"rings\": []}\n{\"name\": \"b\"}\n";
        fs::write(folder.path().join("x.ndjson"), text).unwrap();
        let error = format!("{:#}", of_folder(folder.path()).unwrap_err());
        assert!(error.contains("x.ndjson, line 2"), "{error}");
    }
}
