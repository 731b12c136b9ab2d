//! `curvecrust reconstruct --tiles`: points that memory cannot hold.

use super::Outcome;
use crate::args;
use crate::console::Console;
use crate::format::{self, Format};
use crate::input;
use crate::number::counted;
use crate::output::Output;
use crate::points::ColumnNames;
use crate::tiles::{self, Done, Found, LEAST_MEMORY, Limits, Place, Points, Wanted, Way};
use anyhow::{Context, bail};
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// The formats that are read; folders hold the last one.
const FORMATS: &[Format] = &[
    Format::Npy,
    #[cfg(feature = "parquet")]
    Format::Parquet,
];

/// Which points are reconstructed, where and how, and where the edges go.
#[derive(Debug)]
pub(crate) struct Job {
    points: Points,
    folder: PathBuf,
    algorithm: &'static str,
    way: Way,
    limits: Limits,
    wanted: Wanted,
}

impl Job {
    /// The job of `--tiles FOLDER`.
    pub(crate) fn new(args: args::Reconstruct, folder: PathBuf) -> anyhow::Result<Self> {
        let algorithm = args.algorithm.info().name;
        let way = Way::of_name(algorithm).with_context(|| {
            let names = Way::names().join(", ");
            format!("{algorithm} is not local enough for tiles: use {names}")
        })?;
        let path = args.points.path;
        if input::is_standard(&path) {
            bail!("--tiles reads the points more than once: give a file");
        }
        let reading = args.points.reading;
        let format = match reading.from.or_else(|| Format::of_name(&path)) {
            None if path.is_dir() => FORMATS.last().copied().unwrap_or(Format::Npy),
            None => Format::Npy,
            Some(format) if FORMATS.contains(&format) => format,
            Some(other) => bail!(
                "--tiles reads {}, and {} is {}",
                format::listed(FORMATS),
                path.display(),
                other.name()
            ),
        };
        let columns = reading.x.zip(reading.y);
        let points = Points {
            path,
            format,
            columns: columns.map(|(x, y)| ColumnNames { x, y }),
        };
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
            points,
            folder,
            algorithm,
            way,
            limits: Limits {
                memory,
                tile_points: tile_points.map(NonZeroUsize::get),
            },
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let Self {
            points,
            folder,
            algorithm,
            way,
            limits,
            wanted,
        } = self;
        let done = tiles::run(&points, &folder, algorithm, way, limits, &wanted, console)?;
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
            let curves = counted(usize::try_from(curves).unwrap_or(usize::MAX), "curve");
            format!("{curves}, {closed} of them closed, {across} in several tiles")
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
