//! `curvecrust`, the program: samples of smooth curves, ordered curves from bare points, and
//! pictures of both.
//!
//! [`args`] is what was typed, [`commands`] what is done, one file each; [`points`] reads and
//! [`output`] writes, one file a format. It is a library for its fuzz target's sake, and promises
//! nothing but [`main`]: depend on `curvecrust`.

mod args;
mod commands;
mod console;
mod format;
mod input;
mod output;
mod points;

use args::{Cli, Command};
use clap::Parser;
use commands::Outcome;
use console::Console;
use format::Format;
use input::Source;
use points::{Flaw, PointsError};
use std::io;
use std::path::Path;
use std::process::ExitCode;

/// Runs the program on the arguments of this process.
#[must_use]
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    let console = Console::new(cli.quiet);
    match run(&cli, &console) {
        Ok(Outcome::Fine) => ExitCode::SUCCESS,
        Ok(Outcome::Failed) => ExitCode::from(1),
        // Who reads our output has seen enough.
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            console.error(&error);
            ExitCode::from(2)
        }
    }
}

fn run(cli: &Cli, console: &Console) -> anyhow::Result<Outcome> {
    if let Some(threads) = cli.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads.get())
            .build_global()?;
    }
    match &cli.command {
        Command::Sample(args) => commands::sample::run(args, console),
        Command::Reconstruct(args) => commands::reconstruct::run(args, console),
        Command::Check(args) => commands::check::run(args, console),
        Command::Evaluate(args) => commands::evaluate::run(args, console),
        Command::MedialAxis(args) => commands::medial_axis::run(args, console),
        Command::Lfs(args) => commands::lfs::run(args, console),
        Command::Draw(args) => commands::draw::run(args, console),
        Command::Algorithms(args) => commands::algorithms::run(args),
        Command::Completions(args) => commands::completions::run(args),
    }
}

/// How many points a file of the format with this extension holds, or what is said about it: the
/// door by which the readers are fuzzed.
#[doc(hidden)]
pub fn count_points(bytes: Vec<u8>, extension: &str) -> Result<usize, String> {
    let path = Path::new("fuzzed").with_extension(extension);
    let points = Source::new(io::Cursor::new(bytes))
        .map_err(Flaw::from)
        .and_then(|source| points::read_source(source, Format::of_name(&path)));
    match points {
        Ok(points) => Ok(points.len()),
        Err(flaw) => {
            let error = PointsError::new(path.display().to_string(), flaw);
            Err(console::printable(&error.to_string()))
        }
    }
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    error
        .chain()
        .filter_map(|cause| cause.downcast_ref::<io::Error>())
        .any(|cause| cause.kind() == io::ErrorKind::BrokenPipe)
}
