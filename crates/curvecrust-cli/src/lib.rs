//! `curvecrust`, the program: samples of smooth curves, ordered curves from bare points, and
//! pictures of both.
//!
//! [`args`] are the arguments as typed. [`commands`] make jobs of them and run these, one file
//! each. [`points`] reads and [`output`] writes, one file a format. This is a library only so that
//! the readers can be fuzzed and Python can run it, and promises nothing but [`main`] and
//! [`run_on`]: depend on `curvecrust`.

// What readers share is there for each of them.
#![cfg_attr(
    not(all(
        feature = "flatgeobuf",
        feature = "las",
        feature = "npz",
        feature = "parquet",
        feature = "ply",
        feature = "shapefile",
        feature = "wkb"
    )),
    allow(dead_code, reason = "what the readers of other features use")
)]

mod again;
mod args;
mod commands;
mod console;
mod format;
mod input;
mod number;
mod output;
mod points;
mod threads;
mod tiles;

use args::Cli;
use clap::Parser;
use commands::{Job, Outcome};
use console::Console;
use format::Format;
use input::Source;
use points::{Flaw, PointsError};
use std::ffi::OsString;
use std::io;
use std::path::Path;
use std::process::ExitCode;

/// Runs the program on the arguments of this process.
#[must_use]
pub fn main() -> ExitCode {
    let this = std::env::current_exe().map(|path| vec![path.into_os_string()]);
    ExitCode::from(run_on(std::env::args_os(), this.unwrap_or_default()))
}

/// Runs the program on arguments, the first of which is its name, and returns its exit code. It
/// does as a process does: it starts the threads of the process and ends at Ctrl-C.
///
/// It starts itself again for what may end a process, by the words of a command and arguments
/// behind them. Without words this process does all the work.
#[must_use]
pub fn run_on(args: impl IntoIterator<Item = OsString>, again: Vec<OsString>) -> u8 {
    let args: Vec<_> = args.into_iter().collect();
    #[cfg(feature = "las")]
    if let Some(code) = points::serve_decoder(&args) {
        return code;
    }
    again::set(again);
    let cli = match Cli::try_parse_from(args) {
        Ok(cli) => cli,
        Err(usage) => {
            // That nobody reads the help is no reason to fail.
            let _ = usage.print();
            return if usage.use_stderr() { 2 } else { 0 };
        }
    };
    let console = Console::new(cli.quiet);
    match run(cli, &console) {
        Ok(Outcome::Fine) => 0,
        Ok(Outcome::Failed) => 1,
        Err(error) => {
            console.error(&error);
            2
        }
    }
}

fn run(cli: Cli, console: &Console) -> anyhow::Result<Outcome> {
    let job = Job::new(cli.command)?;
    if job.computes() {
        threads::start(cli.threads, console)?;
    }
    let outcome = job.run(console)?;
    if output::was_lost() {
        console.note("stdout is closed: what was printed there is lost");
    }
    Ok(outcome)
}

/// The number of points in a file of the format with this extension, or the message about it; by
/// `everything` also the vertices of lines and polygons, all with their heights. Fuzz targets call
/// the readers by it.
#[doc(hidden)]
pub fn count_points(bytes: Vec<u8>, extension: &str, everything: bool) -> Result<usize, String> {
    let path = Path::new("fuzzed").with_extension(extension);
    let list = Source::new(io::Cursor::new(bytes))
        .map_err(Flaw::from)
        .and_then(|source| {
            let named = Format::of_content_named(&path);
            let options = points::ReadOptions {
                columns: None,
                vertices: everything,
                heights: everything,
                termini: everything,
            };
            points::read_source(source, None, named, &options)
        });
    match list {
        Ok(list) => Ok(list
            .heights
            .map_or(list.points.len(), |heights| heights.len())),
        Err(flaw) => {
            let error = PointsError::new(path.display().to_string(), flaw);
            Err(console::printable(&error.to_string()))
        }
    }
}
