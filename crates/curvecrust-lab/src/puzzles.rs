//! `docs/results/puzzles.md`: dots and colours of connect-the-closest-dot puzzles, beside samples.

use crate::table::{Field, Table};
use anyhow::Context;
use curvecrust::curve::Curve;
use curvecrust::medial_axis::{MeasuredCurve, measure};
use curvecrust::sampling::{
    Condition, DeviationLimit, PuzzleOptions, VerifyOptions, sample_fewest, sample_puzzle,
    sample_verified_with,
};
use curvecrust_testing::fixtures;
use rayon::prelude::*;

/// The page.
pub(crate) const NAME: &str = "docs/results/puzzles.md";

/// The Hausdorff limit of the second table, as a share of the extent.
const LIMIT: f64 = 0.01;
/// Rounds of the search for samples that can go.
const ROUNDS: usize = 30;

const HEADER: [&str; 6] = [
    "curve",
    "rho < 0.9",
    "verified",
    "dots",
    "colours",
    "dots of two colours",
];

const OPENING: &str = "\
<!-- Made by `cargo xtask docs`. -->

# Dots and colours beside samples

A connect-the-closest-dot puzzle joins each dot with the closest other dot of its colour
([how it works](../algorithms.md#dots-in-colours)).
Its colours do the work that a sampling condition does for bare points.
The tables count both on the twenty curves of `fixtures/curves`:

- *rho < 0.9*: the fewest samples that keep the condition, from the best of all starts.
  HNN-Crust joins them.
- *verified*: samples with which HNN-Crust still returns the polygon, after 30 rounds of search.
  Nothing is guaranteed for other samples.
- *dots*, *colours*: of a puzzle with a margin of 10 %.
  A dot has one colour or two; the last column counts those with two.
";

const WITHIN_LFS: &str = "
## Nearer than the local feature size

Between two dots, and two verified samples, the curve is nearer to the chord than lfs.
So no chord crosses the medial axis, but the polygon is a coarse picture of the curve.

";

const WITHIN_LIMIT: &str = "
## Within 1 % of the extent

No point of the curve is farther from its chord than 1 % of the curve's larger side, in all columns.
This is what `curvecrust puzzle` does.

";

/// What is counted on a curve, in the order of the header.
type Counts = [usize; HEADER.len() - 1];

/// The page as Markdown.
pub(crate) fn page() -> anyhow::Result<String> {
    let counts: Vec<(String, [Counts; 2])> = fixtures::curves()
        .into_par_iter()
        .map(|(name, curve)| {
            let counts = both(&curve).with_context(|| name.clone())?;
            Ok((name, counts))
        })
        .collect::<anyhow::Result<_>>()?;
    let table = |which: usize| {
        let rows = counts
            .iter()
            .map(|(name, counts)| (name.as_str(), counts[which]));
        table(rows).to_markdown()
    };
    let (lfs, limit) = (table(0), table(1));
    Ok(format!("{OPENING}{WITHIN_LFS}{lfs}{WITHIN_LIMIT}{limit}"))
}

/// A row for each curve, and their sum; the colours of all are no sum of anything.
fn table<'a>(rows: impl Iterator<Item = (&'a str, Counts)>) -> Table {
    let mut table = Table::new(HEADER);
    let mut sums = Counts::default();
    for (name, counts) in rows {
        for (sum, count) in sums.iter_mut().zip(counts) {
            *sum += count;
        }
        let fields = counts.map(Field::from).into_iter();
        table
            .rows
            .push([Field::from(name)].into_iter().chain(fields).collect());
    }
    let mut last: Vec<Field> = sums.map(Field::from).to_vec();
    last[3] = Field::Missing;
    last.insert(0, Field::from("all"));
    table.rows.push(last);
    table
}

/// Without a limit but lfs, and with one.
fn both(curve: &Curve) -> anyhow::Result<[Counts; 2]> {
    let measured = measure(curve)?;
    let rho = Condition::rho(0.9)?;
    let limit = LIMIT * curve.extent();
    Ok([
        counts(&measured, rho, DeviationLimit::OfLfs(1.0), None)?,
        counts(
            &measured,
            rho.with_hausdorff_limit(limit)?,
            DeviationLimit::Length(limit),
            Some(limit),
        )?,
    ])
}

fn counts(
    measured: &MeasuredCurve,
    condition: Condition,
    deviation: DeviationLimit,
    max_distance: Option<f64>,
) -> anyhow::Result<Counts> {
    let fewest = sample_fewest(measured, condition)?;
    let options = VerifyOptions {
        deviation,
        rounds: ROUNDS,
        ..VerifyOptions::default()
    };
    let verified = sample_verified_with(&fewest, &options)?;
    let options = PuzzleOptions {
        max_distance,
        ..PuzzleOptions::default()
    };
    let dots = sample_puzzle(measured, &options)?.dots;
    let several = dots.colours().iter().filter(|colours| colours.len() > 1);
    Ok([
        fewest.samples.len(),
        verified.samples.len(),
        dots.points().len(),
        dots.colour_count(),
        several.count(),
    ])
}
