//! The edges that a tile is not certain of, with samples of other tiles.

use std::collections::BTreeSet;

use curvecrust_geometry::{Interrupt, Progress};

use crate::elsewhere::Elsewhere;
use crate::error::TilesError;
use crate::ids::Ids;
use crate::sample::{Sample, Samples};
use crate::stars::Stars;

/// What finds the stars of a tile: [`solve_delaunay_tile`](crate::solve_delaunay_tile) or
/// [`solve_crust_tile`](crate::solve_crust_tile).
pub type SolveStars = fn(&Samples, &[Sample], &Elsewhere) -> Result<Stars, TilesError>;

/// The edges of some samples of a tile with samples of other tiles, ascending: of each those that
/// lead to larger ids.
///
/// `open` are the ids of these samples, such as those of [`Stars::open`]; the edges of the others
/// are known. `elsewhere` knows where all samples are that are not `owned`. `read` gives the
/// samples of an area of its atlas, each at most once. Every round solves with what is known, and
/// reads the nearest area that each open sample asks for. It ends, as nothing is open when all is
/// read. Reports how many of these samples are certain.
///
/// # Errors
/// Those of `read`, and of a sample at the place of another one.
pub fn close_stars<E: From<TilesError>>(
    solve: SolveStars,
    owned: &Samples,
    mut open: Ids,
    mut elsewhere: Elsewhere,
    progress: Progress<'_>,
    mut read: impl FnMut(usize) -> Result<Vec<Sample>, E>,
) -> Result<Vec<[u64; 2]>, E> {
    let interrupt = Interrupt::current();
    let total = open.as_slice().len();
    let mut others: Vec<Sample> = Vec::new();
    let mut edges = Vec::new();
    while !open.as_slice().is_empty() {
        let is_open = |sample: &Sample| open.position(sample.id).is_some();
        let (ours, mut halo): (Vec<Sample>, Vec<Sample>) = owned.iter().partition(is_open);
        halo.extend_from_slice(&others);
        let stars = solve(&Samples::new(ours)?, &halo, &elsewhere)?;
        edges.extend(stars.edges);
        let asked: BTreeSet<usize> = stars.open.iter().map(|star| star.ask).collect();
        for area in asked {
            interrupt.check();
            others.extend(read(area)?);
            elsewhere.note_read(area);
        }
        open = Ids::new(stars.open.iter().map(|star| star.sample.id).collect());
        progress.report(total - open.as_slice().len(), total);
    }
    edges.sort_unstable();
    Ok(edges)
}
