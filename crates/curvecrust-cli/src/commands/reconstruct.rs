//! `curvecrust reconstruct`: points to curves.

mod hints;
pub(super) mod polygons;
mod result;
mod summary;
pub(super) mod tiled;
mod why;

use super::Outcome;
use super::bare_points::{BarePoints, PointSource};
use crate::args::{self, Algorithm, Keep};
use crate::console::Console;
use crate::format::Format;
use crate::output::{GEOMETRIES, Layer, Output, Picture, Results, npy};
use anyhow::{Context, bail, ensure};
use curvecrust::geometry::{EdgeSet, PointSet};
use curvecrust::reconstruct::{
    Explanation, Known, LeastDetour, ReconstructError, Reconstruction, Reconstructor,
};
use result::Found;
pub(crate) use result::paths;
use summary::Summary;

/// Which points are reconstructed and how, and where the curves go.
#[derive(Debug)]
pub(crate) struct Job {
    points: PointSource,
    algorithm: Algorithm,
    known: args::Known,
    /// A file of ends of curves.
    termini: Option<PointSource>,
    /// Whether the reasons of edges and of open ends are told.
    why: bool,
    results: Results,
}

impl Job {
    pub(crate) fn new(args: args::Reconstruct) -> anyhow::Result<Self> {
        let formats = [GEOMETRIES, &[Format::Npy]].concat();
        let results = Results::new(args.output, args.json, &formats)?;
        if args.why && !(results.json || results.writes(Format::Json)) {
            bail!("JSON alone has room for reasons: give --json with --why");
        }
        let mut points = PointSource::from(args.points);
        if args.keep == Some(Keep::Z) {
            let flat = [Format::Svg, Format::Npy];
            if let Some(format) = flat.into_iter().find(|&format| results.writes(format)) {
                bail!("{} holds no heights: leave out --keep", format.name());
            }
            points = points.with_heights();
        }
        Ok(Self {
            results,
            points,
            algorithm: args.algorithm,
            why: args.why,
            termini: args.known.termini_from.clone().map(PointSource::of_termini),
            known: args.known,
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let bare = self.points.read(console)?;
        let mut known = known(&self.known, &bare)?;
        if let Some(source) = &self.termini {
            let termini = bare.points_at(&source.read(console)?);
            known
                .termini
                .extend(termini.with_context(|| source.name())?);
        }
        let (edges, why) = console.during("reconstructing", |_| {
            if self.why {
                explained(self.algorithm, &bare.points, &known)
            } else {
                let edges = self.algorithm.reconstruct_known(&bare.points, &known)?;
                Ok((edges, None))
            }
        })?;
        ensure_reasons(self.why, why.as_ref(), self.algorithm)?;
        let summary = Summary::new(&bare, &edges, &known.termini);
        let hints = hints::hints(&bare, &edges);
        console.during("writing", |_| self.write(&bare, &known, edges, why))?;
        if let Some(note) = self.results.leaves_out(bare.system.as_ref()) {
            console.note(note);
        }
        console.note(summary);
        for hint in hints {
            console.note(hint);
        }
        Ok(Outcome::Fine)
    }

    fn write(
        &self,
        bare: &BarePoints,
        known: &Known,
        edges: EdgeSet,
        why: Option<Explanation>,
    ) -> anyhow::Result<()> {
        let Results { output, json } = &self.results;
        // Edges alone need not be ordered, for which many points would take much memory.
        if let Some(output) = output.as_ref().filter(|o| o.format == Format::Npy) {
            let edges = edges.edges().iter();
            let rows = edges.map(|edge| edge.ends().map(|v| bare.row(v)));
            output.write(|out| npy::write_u32(out, rows))?;
            if !json {
                return Ok(());
            }
        }
        let found = Found {
            algorithm: self.algorithm.info().name,
            bare,
            known,
            curves: Reconstruction::new(&bare.points, edges)?,
            why,
        };
        if let Some(output) = output {
            write_curves(output, &found)?;
        }
        self.results.print_json(|| Ok(&found))
    }
}

/// What the user knows, in terms of the points.
fn known(args: &args::Known, bare: &BarePoints) -> anyhow::Result<Known> {
    let termini = args.terminus.iter().map(|&row| bare.point(row));
    Ok(Known {
        shape: args.shape(),
        curves: args.curves,
        termini: termini.collect::<Result<_, _>>()?,
    })
}

/// The edges, with reasons by algorithms that give some.
pub(crate) fn explained(
    algorithm: Algorithm,
    points: &PointSet,
    known: &Known,
) -> Result<(EdgeSet, Option<Explanation>), ReconstructError> {
    match algorithm.explain_known(points, known)? {
        Some(why) => Ok((why.edge_set(points.len()), Some(why))),
        None => Ok((algorithm.reconstruct_known(points, known)?, None)),
    }
}

/// An error where reasons are asked for that an algorithm does not give.
pub(crate) fn ensure_reasons(
    wanted: bool,
    why: Option<&Explanation>,
    algorithm: Algorithm,
) -> anyhow::Result<()> {
    ensure!(
        why.is_some() || !wanted,
        "{} gives no reasons for its edges: leave out --why",
        algorithm.info().name
    );
    Ok(())
}

/// Writes edges between points as `reconstruct` does by default, in every format but `npy`.
pub(super) fn write_edges(
    output: &Output,
    bare: &BarePoints,
    edges: EdgeSet,
) -> anyhow::Result<()> {
    let found = Found {
        algorithm: LeastDetour.info().name,
        bare,
        known: &Known::default(),
        curves: Reconstruction::new(&bare.points, edges)?,
        why: None,
    };
    write_curves(output, &found)
}

/// Writes the curves, in every format but the one that holds edges alone.
fn write_curves(output: &Output, found: &Found<'_>) -> anyhow::Result<()> {
    match output.format {
        Format::Csv => output.write(|out| found.write_csv(out)),
        Format::Json => output.write_json(found),
        Format::Svg => {
            let points = &found.bare.points;
            let edges = Layer::Edges(paths(points, &found.curves));
            let layers = vec![edges, Layer::Points(points.points())];
            output.write(|out| Picture { layers }.write(out))
        }
        Format::Npy => Ok(()),
        _ => {
            let (rings, heights) = (found.rings(), found.bare.point_heights());
            let features = found.features(&rings, heights.as_deref());
            output.write_features(features, found.bare.system.as_ref())
        }
    }
}
