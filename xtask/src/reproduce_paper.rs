//! `cargo xtask reproduce-paper`: Tables 1 to 3 of the paper, measured and set beside the printed
//! numbers, each sampling reconstructed; how few samples there can be; and its figures.

mod fewest;
pub(crate) mod figures;
pub(crate) mod models;
mod tables;
#[cfg(test)]
mod tests;

use crate::root::root;
use crate::whole::write_whole;
use anyhow::Context;
use clap::ValueEnum;
use curvecrust::report::{PaperReport, render};
use std::path::PathBuf;
use std::process::ExitCode;
use tables::{Points, Run};

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
    let (origin, models) = models::load(args.curves.as_deref())?;
    let report = PaperReport {
        curves: origin,
        table1: if shows(args, 1) {
            tables::table_1()
        } else {
            Vec::new()
        },
        fewest: if shows(args, 4) && runs(args).contains(&Run::Voronoi(tables::CONVERGED)) {
            fewest::rows(&models, args.rounds)?
        } else {
            Vec::new()
        },
        ..tables::tables_2_and_3(&models, &runs(args), [shows(args, 2), shows(args, 3)])?
    };

    let markdown = render::markdown(&report);
    let json = render::json(&report)?;
    let folder = root().join("target").join("paper");
    std::fs::create_dir_all(&folder)
        .with_context(|| format!("cannot make {}", folder.display()))?;
    write_whole(&folder.join("tables.md"), &markdown)?;
    write_whole(&folder.join("tables.csv"), &render::csv(&report)?)?;
    write_whole(&folder.join("tables.json"), &json)?;
    print!("{}", if args.json { &json } else { &markdown });
    eprintln!(
        "wrote tables.md, tables.csv and tables.json under {}",
        folder.display()
    );

    if args.figures {
        figures::write(&report, &models, &folder)?;
        eprintln!("drew figures 1, 3, 4, 8, 9, 10 and 11 and report.html there");
    }

    let failures = report.agreement();
    for failure in &failures {
        eprintln!("failed: {failure}");
    }
    Ok(ExitCode::from(u8::from(!failures.is_empty())))
}

fn shows(args: &Args, table: u8) -> bool {
    args.table.is_none_or(|only| only == table)
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
        (Lfs::Voronoi, Discretisation::Adaptive) => Run::Voronoi(tables::CONVERGED),
        (Lfs::ShrinkingBall, Discretisation::Paper) => Run::ShrinkingBall(Points::PerSegment),
        (Lfs::ShrinkingBall, Discretisation::Adaptive) => Run::ShrinkingBall(tables::CONVERGED),
    };
    settings.into_iter().map(run).collect()
}
