//! Figures 3, 4 and 11: bare points, reconstructed.

use super::edges;
use crate::figure::{Figure, Layer, Panel};
use crate::paper::page::Exhibit;
use crate::repository::root;
use anyhow::{Context, bail};
use curvecrust::DVec2;
use curvecrust::geometry::{EdgeSet, PointId, PointSet};
use curvecrust::reconstruct::{crust, hnn_crust};

/// The point sets of the figures.
pub(crate) struct PointSets {
    /// Whether those of Figures 3 and 11 are the authors'.
    fetched: bool,
    sharp: PointSet,
    open: PointSet,
    pub(crate) violated: Vec<PointSet>,
}

const SHARP: &str = include_str!("../../../../../fixtures/points/sharp-angles.xy");
const OPEN: &str = include_str!("../../../../../fixtures/points/open-and-closed.xy");
const VIOLATED: &str = include_str!("../../../../../fixtures/points/violated.xy");

impl PointSets {
    /// Those drawn for this project.
    pub(crate) fn redrawn() -> anyhow::Result<Self> {
        Ok(Self {
            fetched: false,
            sharp: parse(SHARP).context("fixtures/points/sharp-angles.xy")?,
            open: parse(OPEN).context("fixtures/points/open-and-closed.xy")?,
            violated: vec![parse(VIOLATED).context("fixtures/points/violated.xy")?],
        })
    }

    /// The authors', if they were fetched. They have none of open curves, for Figure 4.
    pub(super) fn load() -> anyhow::Result<Self> {
        let folder = root().join("fixtures").join("paper").join("points");
        if !folder.is_dir() {
            return Self::redrawn();
        }
        let read = |name: &str| {
            let path = folder.join(name);
            let text = std::fs::read_to_string(&path)
                .with_context(|| format!("cannot read {}", path.display()))?;
            parse(&text).with_context(|| path.display().to_string())
        };
        Ok(Self {
            fetched: true,
            sharp: read("crocodile-conf.p2d")?,
            violated: vec![read("ventilator.p2d")?, read("mushroom.p2d")?],
            ..Self::redrawn()?
        })
    }
}

/// `x y` lines; empty ones and those that start with # are no points. Points given twice are one.
fn parse(text: &str) -> anyhow::Result<PointSet> {
    let mut points = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let numbers: Vec<f64> = line
            .split_whitespace()
            .map_while(|word| word.parse().ok())
            .collect();
        let [x, y] = numbers[..] else {
            bail!("line {}: `{line}` is not two numbers", i + 1);
        };
        points.push(DVec2::new(x, y));
    }
    Ok(PointSet::merging_duplicates(points)?.points)
}

/// Crust against HNN-Crust where consecutive samples meet at sharp angles.
pub(crate) fn figure_3(sets: &PointSets) -> Exhibit {
    let points = &sets.sharp;
    let (theirs, ours) = (crust(points), hnn_crust(points));
    let text = format!(
        "{} samples{}. Crust needs angles of more than 90° between consecutive edges and breaks \
         where they are sharper; HNN-Crust succeeds down to 60°. On a closed curve every sample \
         has two edges: rings and squares mark those that have not, {} for Crust and {} for \
         HNN-Crust.",
        points.len(),
        if sets.fetched {
            " of the authors"
        } else {
            " of a closed curve drawn for this project"
        },
        odd(&theirs),
        odd(&ours),
    );
    Exhibit {
        number: 3,
        heading: "sharp angles".to_owned(),
        text,
        figure: Figure {
            title: "Crust and HNN-Crust on samples that meet at sharp angles".to_owned(),
            columns: 2,
            panels: vec![
                marked("Crust", points, &theirs),
                marked("HNN-Crust", points, &ours),
            ],
        },
    }
}

/// Crust against HNN-Crust on open and closed curves.
pub(crate) fn figure_4(sets: &PointSets) -> Exhibit {
    let points = &sets.open;
    let (theirs, ours) = (crust(points), hnn_crust(points));
    let chains = ours.chains();
    let text = format!(
        "{} samples of four open arcs and three closed curves near each other, drawn for this \
         project. Crust joins an arc with a closed curve. HNN-Crust keeps only edges that both \
         ends choose, joins nothing that lies apart, and returns {} chains, {} of them closed: \
         its {} leaves are the ends of the arcs.",
        points.len(),
        chains.len(),
        chains.iter().filter(|chain| chain.is_closed()).count(),
        ours.leaves().len(),
    );
    Exhibit {
        number: 4,
        heading: "open and closed curves".to_owned(),
        text,
        figure: Figure {
            title: "Samples of open and closed curves, reconstructed by Crust and by HNN-Crust"
                .to_owned(),
            columns: 3,
            panels: vec![
                bare(points),
                marked("Crust", points, &theirs),
                marked("HNN-Crust", points, &ours),
            ],
        },
    }
}

/// HNN-Crust where the sampling condition is violated.
pub(crate) fn figure_11(sets: &PointSets) -> Exhibit {
    let found: Vec<EdgeSet> = sets.violated.iter().map(hnn_crust).collect();
    let panels = sets.violated.iter().zip(&found);
    let panels =
        panels.flat_map(|(points, found)| [bare(points), marked("HNN-Crust", points, found)]);
    let leaves: Vec<String> = found
        .iter()
        .map(|edges| edges.leaves().len().to_string())
        .collect();
    let text = format!(
        "Samples of closed curves with corners too sharp or strands too close for ρ < 0.9. \
         HNN-Crust keeps only edges on which both ends agree, and so shows where the condition is \
         violated: by leaves ({}), in rings like samples left alone. The paper sets the heuristic \
         GathanG beside it, which is not part of this project.",
        leaves.join(" and "),
    );
    Exhibit {
        number: 11,
        heading: "where the condition is violated".to_owned(),
        text,
        figure: Figure {
            title: "Samples that violate the condition, and their reconstruction by HNN-Crust \
                   with its leaves"
                .to_owned(),
            columns: 2,
            panels: panels.collect(),
        },
    }
}

fn bare(points: &PointSet) -> Panel {
    Panel {
        caption: format!("{} samples", points.len()),
        frame: None,
        layers: vec![Layer::Points(points.points().to_vec())],
    }
}

/// What an algorithm found, with marks where it is not closed.
pub(crate) fn marked(algorithm: &str, points: &PointSet, found: &EdgeSet) -> Panel {
    let (leaves, isolated, junctions) = (found.leaves(), found.isolated(), found.junctions());
    let at = |ids: &[PointId]| ids.iter().map(|&id| points[id]).collect::<Vec<_>>();
    let caption = format!(
        "{algorithm}: {} edges\nleaves {}, isolated {}, junctions {}",
        found.len(),
        leaves.len(),
        isolated.len(),
        junctions.len(),
    );
    Panel {
        caption,
        frame: None,
        layers: vec![
            Layer::Edges(edges(points, found)),
            Layer::Points(points.points().to_vec()),
            Layer::Leaves([at(&leaves), at(&isolated)].concat()),
            Layer::Junctions(at(&junctions)),
        ],
    }
}

/// How many samples have other than two edges.
fn odd(edges: &EdgeSet) -> usize {
    edges
        .degrees()
        .into_iter()
        .filter(|&degree| degree != 2)
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_no_point_is_named() {
        assert_eq!(parse("# head\n1 2\n\n3 4\n1 2\n").unwrap().len(), 2);
        for bad in ["1 2\n3", "1 2\n3 x", "1 2\n3 4 5"] {
            let message = parse(bad).unwrap_err().to_string();
            assert!(message.starts_with("line 2"), "{message}");
        }
    }
}
