//! Measures the fits on scattered points of known curves, and draws them.
//!
//! `measure levels|outliers|clean|circles|things|nothing|time [seeds] [folder of pictures]`

mod curves;
mod draw;
mod sample;
mod score;

use std::time::Instant;

use curvecrust_denoise::{Fitted, denoise};
use curvecrust_geometry::{DVec2, PointSet, Random};
use rayon::prelude::*;

use curves::{NAMES, THINGS, Truth, curves, separation};
use sample::{Cell, Density, Noise, Sample, sample};
use score::{Score, score};

const CELL: Cell = Cell {
    name: "circle",
    held: false,
    n: 300,
    sigma: 1.0,
    outliers: 0.0,
    density: Density::Uniform,
    noise: Noise::Gauss,
};

fn fit(sample: &Sample) -> Fitted {
    let merged = PointSet::merging_duplicates(sample.points.clone()).unwrap();
    let mut fitted = denoise(&merged.points);
    fitted.places = merged.representative.iter().map(|id| fitted.places[id.index()]).collect();
    fitted
}

/// Whether strands are far enough apart for the noise.
fn is_fair(cell: &Cell, truth: &[Truth]) -> bool {
    let whole: f64 = truth.iter().map(curves::length).sum();
    let spacing = whole / cell.n as f64;
    let apart = separation(truth);
    6.0 * cell.sigma * spacing <= apart && 3.0 * spacing <= apart
}

/// All seeds of a cell.
fn run(cell: &Cell, seeds: u64, folder: Option<&str>) -> Option<Vec<(Score, f64)>> {
    let truth = curves(cell.name, cell.held);
    if !is_fair(cell, &truth) {
        return None;
    }
    let one = |seed: u64| {
        let sample = sample(cell, &truth, seed);
        let fitted = fit(&sample);
        let score = score(&truth, &sample, &fitted);
        if let Some(folder) = folder
            && (!score.right || seed == 1)
        {
            let mark = if score.right { "" } else { "wrong-" };
            let Cell { name, n, sigma, outliers, .. } = cell;
            let file = format!("{folder}/{mark}{name}-{n}-{sigma}-{outliers}-{seed}.svg");
            std::fs::write(file, draw::picture(&truth, &sample, &fitted)).unwrap();
        }
        (score, sample.sigma)
    };
    Some((1..=seeds).into_par_iter().map(one).collect())
}

/// Prints one line for many cells: what is right, and how far off the right ones are.
fn report(label: &str, cells: &[Cell], seeds: u64, folder: Option<&str>) {
    let start = Instant::now();
    let (mut right, mut all) = (0, 0);
    let (mut rms, mut max, mut back, mut kept, mut found) = (vec![], vec![], vec![], vec![], vec![]);
    let mut wrong = Vec::new();
    for cell in cells {
        let Some(scores) = run(cell, seeds, folder) else { continue };
        let fails = scores.iter().filter(|(s, _)| !s.right).count();
        if fails > 0 {
            wrong.push(format!("{} {fails}", cell.name));
        }
        for (score, sigma) in scores {
            all += 1;
            kept.push(score.kept);
            found.push(score.found);
            if score.right {
                right += 1;
                let unit = if sigma > 0.0 { sigma } else { 1.0 };
                rms.push(score.rms / unit);
                max.push(score.max / unit);
                back.push(score.back / unit);
            }
        }
    }
    if all == 0 {
        return;
    }
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len().max(1) as f64;
    println!(
        "{label:32} right {right:4}/{all:4} = {:5.1} %  rms {:.3} max {:.2} back {:.2}  kept {:.3} \
         found {:.3}  {:.1} s  wrong: {}",
        100.0 * f64::from(right) / f64::from(all),
        mean(&rms), mean(&max), mean(&back), mean(&kept), mean(&found),
        start.elapsed().as_secs_f64(),
        wrong.join(", ")
    );
}

fn cells(change: impl Fn(Cell) -> Cell) -> Vec<Cell> {
    let both = [false, true].map(|held| NAMES.map(|name| change(Cell { name, held, ..CELL })));
    both.into_iter().flatten().collect()
}

fn levels(seeds: u64, folder: Option<&str>, sizes: &[usize]) {
    for &n in sizes {
        for sigma in [0.2, 0.5, 1.0, 2.0, 4.0] {
            let all = cells(|c| Cell { n, sigma, ..c });
            report(&format!("n {n} sigma {sigma}"), &all, seeds, folder);
        }
    }
}

fn outliers(seeds: u64, folder: Option<&str>) {
    for n in [300, 1000] {
        for outliers in [0.05, 0.1, 0.2, 0.3] {
            let all = cells(|c| Cell { n, outliers, ..c });
            report(&format!("n {n} sigma 1 outliers {outliers}"), &all, seeds, folder);
        }
    }
}

fn varied(seeds: u64, folder: Option<&str>) {
    for n in [100, 300] {
        for sigma in [0.5, 1.0] {
            let all = cells(|c| Cell { n, sigma, density: Density::Varying, ..c });
            report(&format!("n {n} sigma {sigma} density varies"), &all, seeds, folder);
            let all = cells(|c| Cell { n, sigma, noise: Noise::Varying, ..c });
            report(&format!("n {n} sigma {sigma} noise varies"), &all, seeds, folder);
            let all = cells(|c| Cell { n, sigma, noise: Noise::Disc, ..c });
            report(&format!("n {n} sigma {sigma} disc"), &all, seeds, folder);
        }
    }
}

/// Clean points: how many inputs give what least detour gives, and topology with outliers.
fn clean(seeds: u64, folder: Option<&str>) {
    use curvecrust_reconstruct::least_detour;
    for n in [50, 100, 300, 1000] {
        for density in [Density::Uniform, Density::Even, Density::Varying] {
            let all = cells(|c| Cell { n, sigma: 0.0, density, ..c });
            let mut wrong = Vec::new();
            let (mut same, mut count) = (0, 0);
            for cell in &all {
                let truth = curves(cell.name, cell.held);
                if !is_fair(cell, &truth) {
                    continue;
                }
                for seed in 1..=seeds {
                    let sample = sample(cell, &truth, seed);
                    let points = PointSet::new(sample.points.clone()).unwrap();
                    count += 1;
                    if denoise(&points).edges == Some(least_detour(&points)) {
                        same += 1;
                    } else {
                        wrong.push(format!("{} {seed}", cell.name));
                    }
                }
            }
            println!("clean n {n} {density:?}: same {same}/{count} not: {}", wrong.join(", "));
        }
    }
    for n in [300, 1000] {
        for outliers in [0.02, 0.05, 0.1, 0.2] {
            let all = cells(|c| Cell { n, sigma: 0.0, outliers, ..c });
            report(&format!("clean n {n} outliers {outliers}"), &all, seeds, folder);
        }
    }
}

/// Circles whose noise is radial and grows along them.
fn circles(seeds: u64) {
    for extent in [0.1, 0.25, 0.5, 0.75, 1.0] {
        let (mut rings, mut rms) = (0, Vec::new());
        for seed in 1..=seeds {
            let mut random = Random::new(seed);
            let points: Vec<DVec2> = (0..100)
                .map(|i| {
                    let share = f64::from(i) / 100.0;
                    let radius = 1.0 + extent * share * random.between(-1.0, 1.0);
                    radius * DVec2::from_angle(share * std::f64::consts::TAU)
                })
                .collect();
            let fitted = denoise(&PointSet::new(points).unwrap());
            if let [curve] = &*fitted.curves
                && curve.closed
            {
                rings += 1;
                let line = curve.polyline(1e-3);
                let squares: f64 = line.iter().map(|p| (p.length() - 1.0).powi(2)).sum();
                rms.push((squares / line.len() as f64).sqrt());
            }
        }
        let mean = rms.iter().sum::<f64>() / rms.len().max(1) as f64;
        println!("circle extent {extent}: rings {rings}/{seeds} rms {mean:.4}");
    }
}

fn things(seeds: u64, folder: Option<&str>) {
    for n in [300, 1000] {
        for sigma in [0.5, 1.0, 1.5] {
            for name in THINGS {
                let cell = Cell { name, n, sigma, ..CELL };
                report(&format!("{name} n {n} sigma {sigma}"), &[cell], seeds, folder);
            }
        }
    }
}

/// Points that form no curve.
fn nothing(seeds: u64) {
    for n in [30, 100, 300, 1000, 3000] {
        let (mut square, mut disc) = (0, 0);
        for seed in 1..=seeds {
            let mut random = Random::new(seed);
            let uniform: Vec<DVec2> = (0..n).map(|_| DVec2::new(random.unit(), random.unit())).collect();
            square += usize::from(denoise(&PointSet::new(uniform).unwrap()).curves.is_empty());
            let filled = (0..n)
                .map(|_| random.unit().sqrt() * DVec2::from_angle(random.between(0.0, 7.0)))
                .collect();
            disc += usize::from(denoise(&PointSet::new(filled).unwrap()).curves.is_empty());
        }
        println!("n {n}: no curve of a square {square}/{seeds}, of a disc {disc}/{seeds}");
    }
}

fn time() {
    for n in [1000, 3000, 10_000, 30_000, 100_000, 1_000_000] {
        for (name, sigma) in [("fourierB", 0.5), ("fourierB", 1.0), ("fourierB", 4.0)] {
            let cell = Cell { name, n, sigma, ..CELL };
            let truth = curves(name, false);
            let sample = sample(&cell, &truth, 1);
            let start = Instant::now();
            let fitted = fit(&sample);
            let seconds = start.elapsed().as_secs_f64();
            let score = score(&truth, &sample, &fitted);
            println!("n {n} sigma {sigma}: {seconds:.3} s, right {}, rms {:.3}", score.right, score.rms / sample.sigma);
        }
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let seeds = arguments.get(1).and_then(|s| s.parse().ok()).unwrap_or(3);
    let folder = arguments.get(2).map(String::as_str);
    match arguments.first().map(String::as_str) {
        Some("levels") => levels(seeds, folder, &[100, 300, 1000]),
        Some("level") => levels(seeds, None, &[folder.and_then(|n| n.parse().ok()).unwrap_or(300)]),
        Some("outliers") => outliers(seeds, folder),
        Some("varied") => varied(seeds, folder),
        Some("clean") => clean(seeds, folder),
        Some("circles") => circles(seeds),
        Some("things") => things(seeds, folder),
        Some("nothing") => nothing(seeds),
        Some("time") => time(),
        _ => println!("levels, outliers, varied, clean, circles, things, nothing or time"),
    }
}
