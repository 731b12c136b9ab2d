//! `cargo xtask docs`: the files under docs that are made, not written.

use crate::compare::published;
use crate::method;
use crate::reproduce_paper::figures::{self, PointSets};
use crate::reproduce_paper::models;
use crate::root::root;
use crate::whole::write_whole;
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Write nothing; exit with status 1 if a file is not what would be written
    #[arg(long)]
    check: bool,
}

/// Writes or checks every generated file.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let mut stale = false;
    let images = images()?.into_iter();
    let images = images.map(|(name, text)| (name.to_owned(), text));
    for (name, text) in images.chain(published::made()?) {
        let path = root().join(&name);
        if !args.check {
            write_whole(&path, &text)?;
            println!("wrote {name}");
        } else if std::fs::read_to_string(&path).ok().as_ref() != Some(&text) {
            println!("{name} is stale: run cargo xtask docs");
            stale = true;
        }
    }
    Ok(ExitCode::from(u8::from(stale)))
}

/// Figures of the paper on our own curves and points, for the README, and those of `docs/method.md`.
fn images() -> anyhow::Result<Vec<(&'static str, String)>> {
    let models = models::redrawn()?;
    let points = PointSets::redrawn()?;
    Ok(vec![
        (
            "docs/images/teaser.svg",
            figures::figure_1(&models)?.figure.to_svg(),
        ),
        ("docs/images/bunny.svg", figures::bunny(&models)?.to_svg()),
        (
            "docs/images/sharp-angles.svg",
            figures::figure_3(&points).figure.to_svg(),
        ),
        (
            "docs/images/near-strands.svg",
            method::near_strands()?.to_svg(),
        ),
        (
            "docs/images/sharp-corner.svg",
            method::sharp_corner()?.to_svg(),
        ),
        (
            "docs/images/facing-ends.svg",
            method::facing_ends()?.to_svg(),
        ),
        ("docs/images/gap-ahead.svg", method::gap_ahead()?.to_svg()),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_files_are_fresh() {
        assert_eq!(run(&Args { check: true }).unwrap(), ExitCode::SUCCESS);
    }
}
