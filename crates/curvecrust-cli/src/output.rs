//! Results in files, one module a format.

mod dxf;
mod geojson;
pub(crate) mod npy;
mod number;
mod shape;
mod svg;
mod whole;
mod wkt;

pub(crate) use number::Number;
pub(crate) use shape::{Feature, Places, Shape, Streamed};
pub(crate) use svg::{Layer, Path, Picture};

use crate::args;
use crate::format::{self, Format};
use anyhow::bail;
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;

/// Where a result goes, and in which format.
#[derive(Debug)]
pub(crate) struct Output {
    /// `None` for stdout.
    path: Option<PathBuf>,
    force: bool,
    pub(crate) format: Format,
}

impl Output {
    /// Settles place and format before any work is done; `None` if nothing is to be written but the
    /// JSON object on stdout.
    ///
    /// The format is the one given, else that of the file's name, else the first of `formats`.
    pub(crate) fn new(
        args: &args::Output,
        json: bool,
        formats: &[Format],
    ) -> anyhow::Result<Option<Self>> {
        let path = args.output.clone().filter(|path| path.as_os_str() != "-");
        if json && path.is_none() {
            return Ok(None);
        }
        if let Some(path) = &path {
            whole::check(path, args.force)?;
        }
        let named = path.as_deref().and_then(Format::of_name);
        let format = match (args.to.or(named), &path) {
            (Some(format), _) => format,
            (None, None) => formats[0],
            (None, Some(path)) => bail!(
                "the name {} tells no format: give --to {}",
                path.display(),
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
        Ok(Some(Self {
            path,
            force: args.force,
            format,
        }))
    }

    /// Writes the whole, or nothing.
    pub(crate) fn write(
        &self,
        content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> anyhow::Result<()> {
        match &self.path {
            Some(path) => whole::write(path, self.force, content),
            None => to_stdout(content),
        }
    }

    /// Writes shapes in a format that knows nothing but geometry.
    pub(crate) fn write_features<'a, P: Serialize>(
        &self,
        features: impl Iterator<Item = Feature<'a, P>>,
    ) -> anyhow::Result<()> {
        self.write(|out| match self.format {
            Format::Geojson => geojson::write(out, features),
            Format::Wkt => wkt::write(out, features),
            Format::Dxf => dxf::write(out, features),
            other => Err(unsupported(other)),
        })
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
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> anyhow::Result<()> {
    whole::buffered(io::stdout().lock(), content)
        .map_err(|error| anyhow::Error::new(error).context("cannot write to stdout"))
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
