//! What borders of tiles cost: how many samples a tile leaves open, by how far around it everything
//! is loaded, and what it takes to close them; and how many edges of least detour, which has no
//! tiles, would be others. Edges that have to be the same are compared with those of all points at
//! once.
//!
//! `cargo run --release -p curvecrust-tiles --example borders -- 1000000`

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a program that measures"
)]

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use curvecrust_geometry::{DVec2, EdgeSet, PointId, PointSet, Progress, Random};
use curvecrust_reconstruct::partial_crust::is_in_all;
use curvecrust_reconstruct::{crust, least_detour};
use curvecrust_tiles::{
    Area, Atlas, Elsewhere, Ids, Partition, Sample, Samples, SolveStars, TilesError, close_stars,
    solve_crust_tile, solve_delaunay_tile,
};
use curvecrust_voronoi::Delaunay;

/// Samples that are read together.
const RUN: usize = 2048;

/// Points of a tile.
const TILE: usize = 100_000;

/// A tile: its samples, its cell, and the samples of others beside it.
type Tile = (Samples, Area, Vec<Sample>);

fn main() {
    let count = std::env::args().nth(1).and_then(|n| n.parse().ok());
    let count = count.unwrap_or(100_000);
    for (name, (points, spacing)) in [("curves", curves(count)), ("uniform", uniform(count))] {
        let points = PointSet::merging_duplicates(points).unwrap().points;
        println!("{name}: {} points", points.len());
        measure("delaunay", solve_delaunay_tile, &points, spacing, delaunay);
        measure("crust", solve_crust_tile, &points, spacing, |points| {
            pairs(&crust(points))
        });
        least_detour_at_borders(&points, spacing);
    }
}

fn measure(
    name: &str,
    solve: SolveStars,
    points: &PointSet,
    spacing: f64,
    at_once: impl Fn(&PointSet) -> Vec<[u64; 2]>,
) {
    let start = Instant::now();
    let mut expected = at_once(points);
    expected.sort_unstable();
    println!(
        "{name}: at once {:.2?}, {} edges",
        start.elapsed(),
        expected.len()
    );
    for halo in HALOS {
        let tiles = tiles(points, halo * spacing);
        let loaded: usize = tiles.iter().map(|(_, _, halo)| halo.len()).sum();
        let start = Instant::now();
        let mut open = 0;
        for (owned, cell, halo_samples) in &tiles {
            let loaded = cell.grown(halo * spacing);
            let stars = solve(owned, halo_samples, &Elsewhere::outside(loaded)).unwrap();
            open += stars.open.len();
        }
        let share = |n: usize| 100.0 * n as f64 / points.len() as f64;
        println!(
            "halo {halo} spacings: {:.3} % open, {:.2} % loaded twice, {:.2?}",
            share(open),
            share(loaded),
            start.elapsed()
        );
    }
    let start = Instant::now();
    let (found, reads, rounds) = closed(solve, &tiles(points, 0.0));
    println!(
        "{:.2?} with all closed, {reads} runs read, {rounds} rounds",
        start.elapsed()
    );
    assert_eq!(found, expected);
}

/// Halos in spacings.
const HALOS: [f64; 7] = [0.0, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0];

/// How many edges of least detour differ if every tile is reconstructed alone, with a halo.
fn least_detour_at_borders(points: &PointSet, spacing: f64) {
    let expected = pairs(&least_detour(points));
    println!("least detour: {} edges", expected.len());
    for halo in HALOS {
        let mut found = Vec::new();
        for (owned, _, others) in tiles(points, halo * spacing) {
            let all: Vec<Sample> = owned.iter().chain(others).collect();
            let places = all.iter().map(|sample| sample.point);
            let local = least_detour(&PointSet::new(places.collect()).unwrap());
            let is_owned = |at: PointId| at.index() < owned.len();
            for ends in local.edges().iter().map(|edge| edge.ends()) {
                let id = |at: PointId| all[at.index()].id;
                let smaller = ends.into_iter().min_by_key(|&at| id(at));
                if smaller.is_some_and(is_owned) {
                    let [p, q] = ends.map(id);
                    found.push([p.min(q), p.max(q)]);
                }
            }
        }
        found.sort_unstable();
        let count = |of: &[[u64; 2]], not_in: &[[u64; 2]]| {
            let is_other = |edge: &&[u64; 2]| not_in.binary_search(edge).is_err();
            of.iter().filter(is_other).count()
        };
        println!(
            "halo {halo} spacings: {} edges missing, {} others instead",
            count(&expected, &found),
            count(&found, &expected)
        );
    }
}

/// The edges of all tiles, how many runs of other tiles were read, and how often tiles were solved.
fn closed(solve: SolveStars, tiles: &[Tile]) -> (Vec<[u64; 2]>, usize, usize) {
    let (mut areas, mut runs) = (Vec::new(), Vec::new());
    for (number, (owned, ..)) in tiles.iter().enumerate() {
        areas.extend(owned.run_areas(RUN));
        let samples: Vec<Sample> = owned.iter().collect();
        runs.extend(samples.chunks(RUN).map(|run| (number, run.to_vec())));
    }
    let atlas = Atlas::new(areas);
    let (mut edges, mut reads, rounds) = (Vec::new(), 0, AtomicUsize::new(0));
    let count = |_, _| {
        rounds.fetch_add(1, Ordering::Relaxed);
    };
    let progress = Progress::new(&count);
    for (number, (owned, cell, _)) in tiles.iter().enumerate() {
        let mut elsewhere = Elsewhere::within(atlas.clone(), *cell);
        let own = (0..runs.len()).filter(|&run| runs[run].0 == number);
        own.for_each(|run| elsewhere.note_read(run));
        let all = Ids::new(owned.ids().to_vec());
        let read = |run: usize| {
            reads += 1;
            Ok::<_, TilesError>(runs[run].1.clone())
        };
        edges.extend(close_stars(solve, owned, all, elsewhere, progress, read).unwrap());
    }
    edges.sort_unstable();
    (edges, reads, rounds.into_inner())
}

fn tiles(points: &PointSet, margin: f64) -> Vec<Tile> {
    let all = points.points();
    let partition = Partition::of(all.to_vec(), (all.len() / TILE).max(9));
    let mut tiles = vec![(Vec::new(), Vec::new()); partition.cells().len()];
    for (id, &point) in (0..).zip(all) {
        let own = partition.cell_of(point);
        for (number, cell) in partition.cells().iter().enumerate() {
            let sample = Sample { id, point };
            if number == own {
                tiles[number].0.push(sample);
            } else if cell.grown(margin).contains(point) {
                tiles[number].1.push(sample);
            }
        }
    }
    let cells = partition.cells().iter();
    let tile = |((own, halo), &cell)| (Samples::new(own).unwrap(), cell, halo);
    tiles.into_iter().zip(cells).map(tile).collect()
}

fn pair(ends: [PointId; 2]) -> [u64; 2] {
    let [p, q] = ends.map(|id| u64::from(u32::from(id)));
    [p.min(q), p.max(q)]
}

fn pairs(edges: &EdgeSet) -> Vec<[u64; 2]> {
    let mut pairs: Vec<_> = edges.edges().iter().map(|edge| pair(edge.ends())).collect();
    pairs.sort_unstable();
    pairs
}

fn delaunay(points: &PointSet) -> Vec<[u64; 2]> {
    let delaunay = Delaunay::new(points);
    let in_all = delaunay.edges().filter(|dual| is_in_all(points, dual));
    in_all.map(|dual| pair(dual.ends)).collect()
}

/// Circles of 1000 points in the cells of a grid, every tenth of them open, and their spacing.
fn curves(count: usize) -> (Vec<DVec2>, f64) {
    let mut random = Random::new(1);
    let curves = count.div_ceil(1000);
    let side = curves.isqrt() + 1;
    let mut points = Vec::with_capacity(count);
    for curve in 0..curves {
        let radius = 0.2 + 0.25 * random.unit();
        let place = DVec2::new((curve % side) as f64, (curve / side) as f64);
        let centre = place + DVec2::new(random.unit(), random.unit()) * 0.1;
        let turn = if curve % 10 == 0 {
            4.0
        } else {
            std::f64::consts::TAU
        };
        points.extend((0..1000).map(|i| {
            let angle = turn * (f64::from(i) + 0.3 * random.unit()) / 1000.0;
            centre + radius * DVec2::from_angle(angle)
        }));
    }
    (points, 0.32 * std::f64::consts::TAU / 1000.0)
}

fn uniform(count: usize) -> (Vec<DVec2>, f64) {
    let mut random = Random::new(2);
    let points = (0..count).map(|_| DVec2::new(random.unit(), random.unit()));
    (points.collect(), (count as f64).sqrt().recip())
}
