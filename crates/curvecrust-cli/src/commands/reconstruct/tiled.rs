//! `curvecrust reconstruct --tiles`: points that memory cannot hold.

use super::Outcome;
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::input;
use crate::output::Output;
use crate::tiles::{self, Done, Found, LEAST_MEMORY, Limits, Place, Wanted};
use anyhow::{Context, bail};
use curvecrust::tiles::Method;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Which points are reconstructed, where and how, and where the edges go.
#[derive(Debug)]
pub(crate) struct Job {
    input: PathBuf,
    folder: PathBuf,
    algorithm: &'static str,
    method: Method,
    limits: Limits,
    wanted: Wanted,
}

impl Job {
    /// The job of `--tiles FOLDER`.
    pub(crate) fn new(args: args::Reconstruct, folder: PathBuf) -> anyhow::Result<Self> {
        let algorithm = args.algorithm.info().name;
        let method = Method::of_name(algorithm).with_context(|| {
            let names: Vec<&str> = Method::ALL.iter().map(|(name, _)| *name).collect();
            let names = names.join(", ");
            format!("{algorithm} is not local enough for tiles: use {names}")
        })?;
        let input = args.points.path;
        let from = args.points.reading.from.or_else(|| Format::of_name(&input));
        if input::is_standard(&input) {
            bail!("--tiles reads the points more than once: give a file");
        }
        if let Some(other) = from.filter(|&format| format != Format::Npy) {
            bail!(
                "--tiles reads npy alone, and {} is {}",
                input.display(),
                other.name()
            );
        }
        let args::Tiles {
            memory,
            tile_points,
            polylines,
            ..
        } = args.tiles;
        if memory < LEAST_MEMORY {
            bail!("--memory has to be at least {} MiB", LEAST_MEMORY >> 20);
        }
        let args::Output { output, to, force } = args.output;
        let has_edges = polylines.is_none() || output.is_some() || to.is_some();
        let edges = has_edges.then(|| Output::new(output, to, force, &[Format::Npy]));
        if polylines.as_ref() == Some(&folder) {
            bail!("--tiles and --polylines are one folder: give two");
        }
        let curves = polylines.map(|path| Place::new(path, force));
        Ok(Self {
            wanted: Wanted {
                edges: edges.transpose()?,
                curves: curves.transpose()?,
            },
            input,
            folder,
            algorithm,
            method,
            limits: Limits {
                memory,
                tile_points: tile_points.map(NonZeroUsize::get),
            },
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let Self {
            input,
            folder,
            algorithm,
            method,
            limits,
            wanted,
        } = self;
        let done = tiles::run(&input, &folder, algorithm, method, limits, &wanted, console)?;
        let Done {
            points,
            tiles,
            open,
            edges,
            curves,
        } = done;
        let mut found = Vec::new();
        found.extend(edges.map(|edges| format!("{edges} edges")));
        found.extend(curves.map(|found| {
            let Found {
                curves,
                closed,
                across,
            } = found;
            format!("{curves} curves, {closed} of them closed, {across} in several tiles")
        }));
        console.note(format_args!(
            "{points} points in {tiles} tiles, {open} of them asked other tiles: {}; {} can be \
             deleted",
            found.join(", "),
            folder.display()
        ));
        Ok(Outcome::Fine)
    }
}
