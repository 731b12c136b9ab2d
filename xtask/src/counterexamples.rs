//! `cargo xtask counterexamples`: samples on which algorithms fail, and how sparse they are.

use curvecrust_lab::counterexamples::{
    Counterexample, Search, all, two_curves, two_sparser_curves,
};
use curvecrust_lab::{root, write_atomically};
use std::process::ExitCode;
use std::time::Instant;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Search for samples on which this algorithm fails; they are written if their bound is less
    /// than that of those that are there
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
    #[arg(long, default_value_t = 30_000, requires = "search")]
    trials: usize,
}

/// Proves the bounds of all, or searches for another one. Status 1 if a bound is not proven or an
/// algorithm is right.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let Some(algorithm) = &args.search else {
        return check();
    };
    let search = Search {
        algorithm,
        rho: args.rho,
        control: args.control,
        rings: args.rings,
        seed: args.seed,
        trials: args.trials,
    };
    match search.run()? {
        Some(found) => keep(&found)?,
        None => println!("none found"),
    }
    Ok(ExitCode::SUCCESS)
}

fn check() -> anyhow::Result<ExitCode> {
    let mut wrong = false;
    for one in all()? {
        let start = Instant::now();
        let fails = one.reconstructor()?.reconstruct(&one.samples.points()?) != one.samples.truth();
        let proven = one.samples.prove();
        let says = match &proven {
            Ok(boxes) if fails => format!("proven with {boxes} boxes, and it fails"),
            Ok(_) => "the algorithm is right".to_owned(),
            Err(why) => why.to_string(),
        };
        let (name, bound) = (one.name(), one.samples.bound.value());
        let seconds = start.elapsed().as_secs_f64();
        println!("{name:<24} < {bound:<6} {says}, {seconds:.1} s");
        wrong |= !fails || proven.is_err();
    }
    let names = ["petals", "flower", "sparser petals", "sparser flower"];
    let curves = two_curves()?.into_iter().chain(two_sparser_curves()?);
    for (name, one) in names.into_iter().zip(curves) {
        let proven = one.prove();
        let says = match &proven {
            Ok(boxes) => format!("proven with {boxes} boxes"),
            Err(why) => why.to_string(),
        };
        println!("two curves, {name} < {} {says}", one.bound.value());
        wrong |= proven.is_err();
    }
    Ok(ExitCode::from(u8::from(wrong)))
}

/// Writes what was found if it is better than what is there.
fn keep(found: &Counterexample) -> anyhow::Result<()> {
    let (name, bound) = (found.name(), found.samples.bound.value());
    println!("{name} < {bound}");
    let known = all()?.into_iter().find(|one| one.name() == name);
    match known.map(|one| one.samples.bound.value()) {
        Some(known) if known <= bound => println!("the known one has {known}"),
        _ => {
            let file = format!("fixtures/counterexamples/{name}.splines");
            write_atomically(&root().join(&file), found.to_text())?;
            println!("wrote {file}; run cargo xtask docs for its other files");
        }
    }
    Ok(())
}
