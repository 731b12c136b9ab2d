//! `cargo xtask counterexamples`: samples on which algorithms fail, and how sparse they are.

use anyhow::Context;
use curvecrust::reconstruct::ALGORITHMS;
use curvecrust::sampling::Bound;
use curvecrust_lab::counterexamples::{Counterexample, Search, all, certified};
use curvecrust_lab::{root, write_atomically};
use std::process::ExitCode;
use std::time::Instant;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Search for one on which this algorithm fails; it is written if its bound is less than that
    /// of the one that is there
    #[arg(long, value_name = "ALGORITHM")]
    search: Option<String>,
    /// Search by the rho condition instead of epsilon
    #[arg(long, requires = "search")]
    rho: bool,
    /// How many control points the curve has
    #[arg(long, default_value_t = 8, requires = "search")]
    control: usize,
    /// How many small rings there are beside it
    #[arg(long, default_value_t = 0, requires = "search")]
    rings: usize,
    /// Where random numbers start
    #[arg(long, default_value_t = 1, requires = "search")]
    seed: u64,
    /// How many curves are tried
    #[arg(long, default_value_t = 50_000, requires = "search")]
    trials: usize,
}

/// Proves the bounds of all, or searches for another one. Status 1 if a bound is not proven or an
/// algorithm is right.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    match &args.search {
        Some(algorithm) => search(algorithm, args),
        None => check(),
    }
}

fn check() -> anyhow::Result<ExitCode> {
    let mut wrong = false;
    for found in all()? {
        let start = Instant::now();
        let fails = found.reconstructor()?.reconstruct(&found.points()?) != found.truth();
        let proven = found.prove();
        let says = match &proven {
            Ok(boxes) if fails => format!("proven with {boxes} boxes, and it fails"),
            Ok(_) => "the algorithm is right".to_owned(),
            Err(why) => why.to_string(),
        };
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{:<18} {:<18} {says}, {seconds:.1} s",
            found.algorithm,
            shown(found.bound)
        );
        wrong |= !fails || proven.is_err();
    }
    Ok(ExitCode::from(u8::from(wrong)))
}

fn search(name: &str, args: &Args) -> anyhow::Result<ExitCode> {
    let mut known = ALGORITHMS.iter().copied();
    let algorithm = known.find(|algorithm| algorithm.info().name == name);
    let search = Search {
        algorithm: algorithm.with_context(|| format!("no algorithm {name}"))?,
        kind: if args.rho {
            Bound::Rho(1.0)
        } else {
            Bound::Epsilon(1.0)
        },
        control: args.control,
        rings: args.rings,
        seed: args.seed,
        trials: args.trials,
    };
    let Some(found) = search.run() else {
        println!("{name}: none found");
        return Ok(ExitCode::SUCCESS);
    };
    let found = certified(&search, found)?;
    let same = |other: &Counterexample| {
        other.name() == found.name()
    };
    let known = all()?.into_iter().find(same).map(|other| other.bound);
    println!(
        "{name}: {}, known: {}",
        shown(found.bound),
        known.map_or("none".to_owned(), shown)
    );
    if known.is_none_or(|known| found.bound.value() < known.value()) {
        let file = format!("fixtures/counterexamples/{}.splines", found.name());
        write_atomically(&root().join(&file), found.to_text())?;
        println!("wrote {file}; run cargo xtask docs for its other files");
    } else if let Some(known) = known {
        println!("the known one has {known}");
    }
    Ok(ExitCode::SUCCESS)
}
