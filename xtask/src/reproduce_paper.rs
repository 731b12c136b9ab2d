//! `cargo xtask reproduce-paper`: the tables and figures of the paper; see `curvecrust_lab::paper`.

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
    /// A folder of parallel.svg, teaser.svg, bunny.svg and cat.svg, instead of fixtures/paper, if
    /// it was fetched, or the redrawn curves
    #[arg(long, value_name = "DIR")]
    curves: Option<PathBuf>,
    /// Only this estimator of the local feature size: the Voronoi medial axis in double precision,
    /// or that of the paper's authors on points in single precision
    #[arg(long, value_parser = ["voronoi", "shrinking-ball"])]
    lfs: Option<String>,
    /// Only this discretisation: 300 points on every cubic segment, as in the authors' program, or
    /// as many as the local feature size asks for
    #[arg(long, value_parser = ["300", "adaptive"])]
    discretisation: Option<String>,
    /// Draw Figures 1, 3, 4, 8, 9, 10 and 11, and a page with them and the tables, report.html
    #[arg(long)]
    figures: bool,
    /// Print the JSON to stdout, instead of the tables
    #[arg(long)]
    json: bool,
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

/// The settings to run: those of the authors' program and the converged one, or what was asked for.
fn runs(args: &Args) -> Vec<Run> {
    // The authors' estimator needs no more points than theirs: only who names both gets it.
    let both = args.lfs.is_some() && args.discretisation.is_some();
    let is_meant = |run: &Run| {
        let setting = run.setting();
        let is = |asked: &Option<String>, own| asked.as_deref().is_none_or(|name| name == own);
        is(&args.lfs, setting.lfs)
            && is(&args.discretisation, setting.discretisation)
            && (both || *run != Run::ShrinkingBall(CONVERGED))
    };
    let all = [Points::PerSegment, CONVERGED]
        .map(|points| [Run::ShrinkingBall(points), Run::Voronoi(points)]);
    all.into_iter().flatten().filter(is_meant).collect()
}
