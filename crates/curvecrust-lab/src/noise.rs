//! Curves fitted to points that scatter: experiments with known curves.
//!
//! A cell is a curve, a number of points, how far they scatter, and how many others there are. Each
//! is drawn with several seeds, a curve is fitted, and it is compared with the known one.

mod corners;
mod curves;
mod draw;
mod sample;
mod score;

use std::ops::Range;
use std::path::Path;
use std::time::Instant;

use anyhow::Context;
use curvecrust::denoise::{Fitted, denoise};
use curvecrust::geometry::{DVec2, PointSet, Random};
use rayon::prelude::*;

use crate::table::{Field, Table};
use curves::THINGS;
use curves::{NAMES, Truth, curves, separation};
use sample::{Cell, Density, Noise, Sample, sample};
use score::{Score, score};

/// An experiment by its name.
pub const EXPERIMENTS: [&str; 8] = [
    "levels", "outliers", "varied", "clean", "circles", "things", "nothing", "corners",
];

const CELL: Cell = Cell {
    name: "circle",
    held: false,
    n: 300,
    sigma: 1.0,
    outliers: 0.0,
    density: Density::Uniform,
    noise: Noise::Gauss,
};

/// Cells that are reported in one row.
struct Row {
    what: String,
    cells: Vec<Cell>,
}

/// What is drawn, and what is kept of it.
#[derive(Clone, Debug)]
pub struct Draws<'a> {
    /// The seeds of each cell.
    pub seeds: Range<u64>,
    /// Only rows whose name begins with this.
    pub rows: &'a str,
    /// A folder for pictures of what went wrong, and of the first seed.
    pub pictures: Option<&'a Path>,
}

/// Runs an experiment; its name is one of [`EXPERIMENTS`].
///
/// `tell` is given each row of the table as it is ready.
///
/// # Errors
/// An unknown name, or a picture that cannot be written.
pub fn run(
    experiment: &str,
    draws: &Draws<'_>,
    mut tell: impl FnMut(&[Field]),
) -> anyhow::Result<Table> {
    let mut table = Table {
        header: header(experiment),
        rows: Vec::new(),
    };
    let mut add = |row: Vec<Field>| {
        tell(&row);
        table.rows.push(row);
    };
    match experiment {
        "circles" => EXTENTS
            .iter()
            .filter(|extent| extent.to_string().starts_with(draws.rows))
            .for_each(|&extent| add(circles(extent, &draws.seeds))),
        "corners" => corners::rows(draws, add)?,
        "nothing" => SIZES
            .iter()
            .filter(|n| n.to_string().starts_with(draws.rows))
            .for_each(|&n| add(nothing(n, &draws.seeds))),
        _ => {
            let rows = rows(experiment).context("there is no such experiment")?;
            for row in rows.iter().filter(|row| row.what.starts_with(draws.rows)) {
                if let Some(fields) = measured(row, draws)? {
                    add(fields);
                }
            }
        }
    }
    Ok(table)
}

fn header(experiment: &str) -> Vec<String> {
    let names: &[&str] = match experiment {
        "circles" => &["extent", "rings %", "rms"],
        "corners" => &corners::HEADER,
        "nothing" => &["points", "no curve of a square %", "no curve of a disc %"],
        _ => &[
            "points", "inputs", "right %", "rms", "largest", "back", "kept %", "found %",
            "seconds", "wrong",
        ],
    };
    names.iter().map(|&name| name.to_owned()).collect()
}

/// Every curve of the kind, and the ones held out.
fn all(change: impl Fn(Cell) -> Cell) -> Vec<Cell> {
    let both = [false, true].map(|held| NAMES.map(|name| change(Cell { name, held, ..CELL })));
    both.into_iter().flatten().collect()
}

fn rows(experiment: &str) -> Option<Vec<Row>> {
    let mut rows = Vec::new();
    let mut add = |what: String, cells: Vec<Cell>| rows.push(Row { what, cells });
    match experiment {
        "levels" => {
            for n in [100, 300, 1000] {
                for sigma in [0.2, 0.5, 1.0, 2.0, 4.0] {
                    let what = format!("{n}, sigma {sigma}");
                    add(what, all(|c| Cell { n, sigma, ..c }));
                }
            }
        }
        "outliers" => {
            for n in [300, 1000] {
                for outliers in [0.05, 0.1, 0.2, 0.3] {
                    let what = format!("{n}, {} % outliers", 100.0 * outliers);
                    add(what, all(|c| Cell { n, outliers, ..c }));
                }
            }
        }
        "varied" => {
            for n in [100, 300] {
                for (what, density, noise) in [
                    ("density varies", Density::Varying, Noise::Gauss),
                    ("noise varies", Density::Uniform, Noise::Varying),
                    ("noise in a disc", Density::Uniform, Noise::Disc),
                ] {
                    add(
                        format!("{n}, {what}"),
                        all(|c| Cell {
                            n,
                            density,
                            noise,
                            ..c
                        }),
                    );
                }
            }
        }
        "clean" => {
            for n in [300, 1000] {
                for outliers in [0.0, 0.02, 0.05, 0.1, 0.2] {
                    let what = format!("{n}, {} % outliers", 100.0 * outliers);
                    add(
                        what,
                        all(|c| Cell {
                            n,
                            sigma: 0.0,
                            outliers,
                            ..c
                        }),
                    );
                }
            }
        }
        "things" => {
            for n in [200, 400, 1000] {
                for (what, sigma, noise) in [
                    ("sigma 0.5", 0.5, Noise::Gauss),
                    ("sigma 1", 1.0, Noise::Gauss),
                    ("sigma 2", 2.0, Noise::Gauss),
                    ("in a disc of 2", 2.0, Noise::Disc),
                ] {
                    let thing = |name| Cell {
                        name,
                        n,
                        sigma,
                        noise,
                        ..CELL
                    };
                    let (thick, thin): (Vec<Cell>, _) =
                        THINGS.map(thing).into_iter().partition(|cell| {
                            curves(cell.name, false).is_ok_and(|t| is_fair(cell, &t))
                        });
                    add(format!("{n}, {what}"), thick);
                    add(format!("{n}, {what}, thin parts"), thin);
                }
            }
        }
        _ => return None,
    }
    Some(rows)
}

fn fit(sample: &Sample) -> anyhow::Result<Fitted> {
    let merged = PointSet::merging_duplicates(sample.points.clone())?;
    let mut fitted = denoise(&merged.points);
    let places = merged
        .representative
        .iter()
        .map(|id| fitted.places[id.index()]);
    fitted.places = places.collect();
    Ok(fitted)
}

/// Whether strands are six deviations and three spacings apart.
fn is_fair(cell: &Cell, truth: &[Truth]) -> bool {
    let whole: f64 = truth.iter().map(curves::length).sum();
    let spacing = whole / cell.n as f64;
    let apart = separation(truth);
    6.0 * cell.sigma * spacing <= apart && 3.0 * spacing <= apart
}

/// The scores of all seeds of a cell, each with the deviation.
fn scores(cell: &Cell, draws: &Draws<'_>) -> anyhow::Result<Vec<(Score, f64)>> {
    let truth = curves(cell.name, cell.held)?;
    if !THINGS.contains(&cell.name) && !is_fair(cell, &truth) {
        return Ok(Vec::new());
    }
    let one = |seed: u64| {
        let sample = sample(cell, &truth, seed);
        let fitted = fit(&sample)?;
        let score = score(&truth, &sample, &fitted);
        if let Some(folder) = draws.pictures
            && (!score.right || seed == draws.seeds.start)
        {
            let mark = if score.right { "" } else { "wrong-" };
            let Cell {
                name,
                n,
                sigma,
                outliers,
                ..
            } = cell;
            let file = folder.join(format!("{mark}{name}-{n}-{sigma}-{outliers}-{seed}.svg"));
            std::fs::write(file, draw::picture(&truth, &sample, &fitted))?;
        }
        Ok((score, sample.sigma))
    };
    draws.seeds.clone().into_par_iter().map(one).collect()
}

/// One row for many cells: what is right, and how far off the right ones are, in deviations.
fn measured(row: &Row, draws: &Draws<'_>) -> anyhow::Result<Option<Vec<Field>>> {
    let start = Instant::now();
    let (mut all, mut wrong) = (Vec::new(), Vec::new());
    for cell in &row.cells {
        let found = scores(cell, draws)?;
        let fails = found.iter().filter(|(score, _)| !score.right).count();
        if fails > 0 {
            wrong.push(format!("{} {fails}", cell.name));
        }
        all.extend(found);
    }
    if all.is_empty() {
        return Ok(None);
    }
    let right: Vec<&(Score, f64)> = all.iter().filter(|(score, _)| score.right).collect();
    let unit = |sigma: f64| if sigma > 0.0 { sigma } else { 1.0 };
    let apart = |of: fn(&Score) -> f64| mean(right.iter().map(|(s, sigma)| of(s) / unit(*sigma)));
    let share = |of: fn(&Score) -> f64| {
        let values = || all.iter().map(|(score, _)| of(score));
        match values().any(f64::is_finite) {
            true => Field::Share(mean(values())),
            false => Field::Missing,
        }
    };
    let share_right = right.len() as f64 / all.len() as f64;
    Ok(Some(vec![
        row.what.clone().into(),
        all.len().into(),
        Field::Share(share_right),
        Field::rounded(apart(|s| s.rms), 3),
        Field::rounded(apart(|s| s.max), 3),
        Field::rounded(apart(|s| s.back), 3),
        share(|s| s.kept),
        share(|s| s.found),
        Field::rounded(start.elapsed().as_secs_f64(), 2),
        wrong.join(", ").into(),
    ]))
}

/// 0 of no values.
fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let finite = values.filter(|value| value.is_finite());
    let (sum, count) = finite.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

/// The extents of noise of FitConnect's circles.
const EXTENTS: [f64; 5] = [0.1, 0.25, 0.5, 0.75, 1.0];

/// Circles of 100 even points whose noise is radial and grows along them.
///
/// Source: S. Ohrhallinger, M. Wimmer, *FitConnect*, 2018.
fn circles(extent: f64, seeds: &Range<u64>) -> Vec<Field> {
    let one = |seed: u64| {
        let mut random = Random::new(seed);
        let points = (0..100).map(|i| {
            let share = f64::from(i) / 100.0;
            let radius = 1.0 + extent * share * random.between(-1.0, 1.0);
            radius * DVec2::from_angle(share * std::f64::consts::TAU)
        });
        let fitted = denoise(&PointSet::new(points.collect()).ok()?);
        let [curve] = &*fitted.curves else {
            return None;
        };
        let line = curve.polyline(1e-3);
        let squares = line.iter().map(|p| (p.length() - 1.0).powi(2));
        curve.closed.then(|| mean(squares).sqrt())
    };
    let found: Vec<Option<f64>> = seeds.clone().into_par_iter().map(one).collect();
    let rings = found.iter().flatten().count() as f64 / found.len() as f64;
    let rms = mean(found.into_iter().flatten());
    vec![extent.into(), Field::Share(rings), Field::rounded(rms, 3)]
}

const SIZES: [u32; 5] = [30, 100, 300, 1000, 3000];

/// Points that form no curve.
fn nothing(n: u32, seeds: &Range<u64>) -> Vec<Field> {
    let is_empty = |points: Vec<DVec2>| {
        PointSet::new(points).is_ok_and(|points| denoise(&points).curves.is_empty())
    };
    let one = |seed: u64| {
        let mut random = Random::new(seed);
        let square = (0..n).map(|_| DVec2::new(random.unit(), random.unit()));
        let square = is_empty(square.collect());
        let disc = (0..n).map(|_| {
            let angle = random.between(0.0, std::f64::consts::TAU);
            random.unit().sqrt() * DVec2::from_angle(angle)
        });
        (square, is_empty(disc.collect()))
    };
    let found: Vec<(bool, bool)> = seeds.clone().into_par_iter().map(one).collect();
    let share = |of: fn(&(bool, bool)) -> bool| {
        Field::Share(found.iter().filter(|pair| of(pair)).count() as f64 / found.len() as f64)
    };
    vec![
        Field::Count(n.into()),
        share(|pair| pair.0),
        share(|pair| pair.1),
    ]
}
