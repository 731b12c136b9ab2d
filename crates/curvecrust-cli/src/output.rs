//! Results in files, one module a format.

mod atomic;
mod dxf;
#[cfg(feature = "flatgeobuf")]
mod flatgeobuf;
mod geojson;
#[cfg(feature = "parquet")]
mod geoparquet;
mod gpx;
pub(crate) mod npy;
mod shape;
mod svg;
mod wkb;
mod wkt;

pub(crate) use crate::number::Number;
pub(crate) use shape::{Attribute, Attributes, Feature, Kind, Places, Position, Shape, Streamed};
pub(crate) use svg::{Layer, Path, Picture};

use crate::format::{self, Format};
use crate::points::System;
use crate::{args, input};
use anyhow::bail;
use atomic::Target;
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether something was printed to a stdout that was closed.
static LOST: AtomicBool = AtomicBool::new(false);

/// The formats that points, lines and polygons are written in, the one of stdout first.
pub(crate) const GEOMETRIES: &[Format] = &[
    Format::Csv,
    Format::Json,
    Format::Geojson,
    Format::Wkt,
    Format::Wkb,
    Format::Gpx,
    #[cfg(feature = "flatgeobuf")]
    Format::Flatgeobuf,
    #[cfg(feature = "parquet")]
    Format::Parquet,
    Format::Dxf,
    Format::Svg,
];

/// What becomes of a result: a file, or text on stdout, and the JSON object of `--json`.
#[derive(Debug)]
pub(crate) struct Results {
    /// `None` if the JSON object on stdout is all that was asked for.
    pub(crate) output: Option<Output>,
    /// Whether the JSON object is printed to stdout.
    pub(crate) json: bool,
}

/// Where a result goes, and in which format.
#[derive(Debug)]
pub(crate) struct Output {
    /// `None` for stdout.
    target: Option<Target>,
    pub(crate) format: Format,
}

impl Results {
    /// Settles places and format before any work is done.
    pub(crate) fn new(args: args::Output, json: bool, formats: &[Format]) -> anyhow::Result<Self> {
        let is_stdout = args.output.as_deref().is_none_or(input::is_standard);
        let output = if json && is_stdout {
            None
        } else {
            Some(Output::new(args.output, args.to, args.force, formats)?)
        };
        Ok(Self { output, json })
    }

    /// Whether something is written in a format.
    pub(crate) fn writes(&self, format: Format) -> bool {
        self.output.as_ref().is_some_and(|o| o.format == format)
    }

    /// What the user should know of a reference system that is left out, if there is one.
    pub(crate) fn leaves_out(&self, system: Option<&System>) -> Option<String> {
        self.output.as_ref()?.leaves_out(system?)
    }

    /// Prints the JSON object, if it was asked for.
    pub(crate) fn print_json<T: Serialize>(
        &self,
        object: impl FnOnce() -> anyhow::Result<T>,
    ) -> anyhow::Result<()> {
        if self.json {
            print_json(&object()?)?;
        }
        Ok(())
    }
}

impl Output {
    /// Settles place and format before any work is done. The format is the one given, else that of
    /// the file's name, else the first of `formats`.
    pub(crate) fn new(
        path: Option<PathBuf>,
        to: Option<Format>,
        force: bool,
        formats: &[Format],
    ) -> anyhow::Result<Self> {
        let path = path.filter(|path| !input::is_standard(path));
        let named = path.as_deref().and_then(Format::of_name);
        let name = path.as_ref().map(|path| path.display().to_string());
        let target = path.map(|path| Target::new(path, force)).transpose()?;
        let format = match (to.or(named), name) {
            (Some(format), _) => format,
            (None, None) => formats[0],
            (None, Some(name)) => bail!(
                "the name {name} has no known ending: give --to {}",
                format::listed(formats)
            ),
        };
        if !formats.contains(&format) {
            bail!(
                "this cannot be written as {}: use {}",
                format.name(),
                format::listed(formats)
            );
        }
        Ok(Self { target, format })
    }

    /// Writes everything, or nothing.
    pub(crate) fn write(
        &self,
        content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
    ) -> anyhow::Result<()> {
        match &self.target {
            Some(target) => target.write(content),
            None => to_stdout(content),
        }
    }

    /// Writes shapes, with the reference system of their coordinates, in a format of geometries.
    pub(crate) fn write_features<'a, P: Attributes + Serialize>(
        &self,
        features: impl Iterator<Item = Feature<'a, P>>,
        system: Option<&System>,
    ) -> anyhow::Result<()> {
        self.write(|out| match self.format {
            Format::Geojson => geojson::write(out, features, system),
            Format::Wkt => wkt::write(out, features),
            Format::Wkb => wkb::write(out, features, system),
            #[cfg(feature = "flatgeobuf")]
            Format::Flatgeobuf => flatgeobuf::write(out, features, system),
            #[cfg(feature = "parquet")]
            Format::Parquet => geoparquet::write(out, features, system),
            Format::Gpx => gpx::write(out, features),
            Format::Dxf => dxf::write(out, features),
            other => Err(unsupported(other)),
        })
    }

    /// What the user should know of a reference system that the format has a place for, but not in
    /// the terms that the points' file has.
    fn leaves_out(&self, system: &System) -> Option<String> {
        let wants = match self.format {
            Format::Wkb | Format::Geojson if system.epsg().is_none() => "a code of EPSG",
            #[cfg(feature = "parquet")]
            Format::Parquet if !geoparquet::names(system) => "PROJJSON",
            _ => return None,
        };
        let (format, name) = (self.format.name(), system.name());
        Some(format!(
            "the reference system {name} is left out: {format} takes it as {wants} alone"
        ))
    }

    /// Writes one JSON object.
    pub(crate) fn write_json(&self, object: &impl Serialize) -> anyhow::Result<()> {
        self.write(|out| json(out, object))
    }
}

/// Prints one JSON object to stdout.
pub(crate) fn print_json(object: &impl Serialize) -> anyhow::Result<()> {
    to_stdout(|out| json(out, object))
}

/// Prints to stdout.
pub(crate) fn to_stdout(
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> anyhow::Result<()> {
    if stdout_was_closed() {
        LOST.store(true, Ordering::Relaxed);
    }
    atomic::buffered(io::stdout(), content)
        .map_err(|error| anyhow::Error::new(error).context("cannot write to stdout"))
}

/// Whether something was printed that nobody can ever read.
pub(crate) fn was_lost() -> bool {
    LOST.load(Ordering::Relaxed)
}

/// Whether there was no stdout when the program started. Rust opens the null device in its place,
/// also for reading, which `> /dev/null` does not.
fn stdout_was_closed() -> bool {
    #[cfg(unix)]
    {
        use std::fs::{File, metadata};
        use std::io::Read;
        use std::os::fd::AsFd;
        use std::os::unix::fs::MetadataExt;
        let device = |file: &File| Some(file.metadata().ok()?.rdev());
        let null = metadata("/dev/null").map(|null| null.rdev()).ok();
        let stdout = io::stdout().as_fd().try_clone_to_owned().map(File::from);
        stdout.is_ok_and(|mut out| {
            null.is_some() && device(&out) == null && out.read(&mut [0]).is_ok()
        })
    }
    #[cfg(not(unix))]
    false
}

fn json(out: &mut dyn Write, object: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *out, object)?;
    writeln!(out)
}

/// A command has offered a format that it does not write.
fn unsupported(format: Format) -> io::Error {
    let message = format!("{} is not for this", format.name());
    io::Error::new(io::ErrorKind::Unsupported, message)
}
