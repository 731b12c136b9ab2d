//! `cargo xtask reproduce-paper`: the tables and figures of the paper; see `curvecrust_lab::paper`.

use clap::ValueEnum;
use curvecrust_lab::paper::measure::{CONVERGED, Points, Run};
use curvecrust_lab::paper::{self, Options};
use std::path::PathBuf;
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Only this table; 4 is the block of the fewest samples
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=4))]
    table: Option<u8>,
    /// How long to look for fewer samples that are verified: so often are they shaken
    #[arg(long, value_name = "N", default_value_t = 100)]
    rounds: usize,
    /// A folder of parallel.svg, teaser.svg, bunny.svg and cat.svg, instead of fixtures/paper, if it was fetched, or
    /// the redrawn curves
    #[arg(long, value_name = "DIR")]
    curves: Option<PathBuf>,
    /// Only this estimator of the local feature size
    #[arg(long, value_enum)]
    lfs: Option<Lfs>,
    /// Only this discretisation
    #[arg(long, value_enum)]
    discretisation: Option<Discretisation>,
    /// Draw Figures 1, 3, 4, 8, 9, 10 and 11, and a page with them and the tables, report.html
    #[arg(long)]
    figures: bool,
    /// Print the JSON to stdout, instead of the tables
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Lfs {
    /// The Voronoi medial axis, in double precision
    Voronoi,
    /// The estimator of the paper's authors, on points in single precision
    ShrinkingBall,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Discretisation {
    /// 300 points on every cubic segment, as in the paper
    #[value(name = "300")]
    Paper,
    /// As many points as the local feature size asks for
    Adaptive,
}

/// Prints the tables and writes them under target/paper.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let reproduction = paper::reproduce(&Options {
        table: args.table,
        rounds: args.rounds,
        curves: args.curves.clone(),
        runs: runs(args),
    })?;
    let text = if args.json {
        &reproduction.json
    } else {
        &reproduction.markdown
    };
    print!("{text}");
    eprintln!(
        "wrote tables.md, tables.csv and tables.json under {}",
        reproduction.folder.display()
    );
    if args.figures {
        reproduction.draw()?;
        eprintln!("drew figures 1, 3, 4, 8, 9, 10 and 11 and report.html there");
    }

    let failures = reproduction.report.agreement();
    for failure in &failures {
        eprintln!("failed: {failure}");
    }
    Ok(ExitCode::from(u8::from(!failures.is_empty())))
}

/// The settings to run: those of the paper and of its converged values, or what was asked for.
fn runs(args: &Args) -> Vec<Run> {
    let usual = [
        (Lfs::ShrinkingBall, Discretisation::Paper),
        (Lfs::Voronoi, Discretisation::Paper),
        (Lfs::Voronoi, Discretisation::Adaptive),
    ];
    let asked = args.lfs.zip(args.discretisation);
    let settings: Vec<_> = match asked {
        Some(pair) => vec![pair],
        None => usual
            .into_iter()
            .filter(|&(lfs, discretisation)| {
                args.lfs.is_none_or(|only| only == lfs)
                    && args
                        .discretisation
                        .is_none_or(|only| only == discretisation)
            })
            .collect(),
    };
    let run = |(lfs, discretisation)| match (lfs, discretisation) {
        (Lfs::Voronoi, Discretisation::Paper) => Run::Voronoi(Points::PerSegment),
        (Lfs::Voronoi, Discretisation::Adaptive) => Run::Voronoi(CONVERGED),
        (Lfs::ShrinkingBall, Discretisation::Paper) => Run::ShrinkingBall(Points::PerSegment),
        (Lfs::ShrinkingBall, Discretisation::Adaptive) => Run::ShrinkingBall(CONVERGED),
    };
    settings.into_iter().map(run).collect()
}
