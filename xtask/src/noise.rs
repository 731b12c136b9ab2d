//! `cargo xtask noise`: curves fitted to points that scatter about known ones.

use clap::builder::PossibleValuesParser;
use curvecrust_lab::noise::{Draws, EXPERIMENTS, run as measure};
use std::path::PathBuf;
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// The experiments [default: all]
    #[arg(value_name = "EXPERIMENT", value_parser = PossibleValuesParser::new(EXPERIMENTS))]
    experiments: Vec<String>,
    /// Draws of each input
    #[arg(long, value_name = "N", default_value_t = 3)]
    seeds: u64,
    /// The seed of the first draw: what is developed on some seeds is reported on others
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    first: u64,
    /// Only rows whose name begins with this
    #[arg(long, value_name = "TEXT", default_value = "")]
    rows: String,
    /// A folder for pictures of what went wrong, and of the first draw of the rest
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
}

/// Prints one table for each experiment.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    if let Some(folder) = &args.pictures {
        std::fs::create_dir_all(folder)?;
    }
    let all = EXPERIMENTS.map(str::to_owned);
    let chosen = if args.experiments.is_empty() {
        &all[..]
    } else {
        &args.experiments
    };
    let draws = Draws {
        seeds: args.first..args.first + args.seeds,
        rows: &args.rows,
        pictures: args.pictures.as_deref(),
    };
    for experiment in chosen {
        let table = measure(experiment, &draws, |row| {
            eprintln!("{experiment}: {}", row[0]);
        })?;
        println!("\n### {experiment}\n\n{}", table.to_markdown());
    }
    Ok(ExitCode::SUCCESS)
}
