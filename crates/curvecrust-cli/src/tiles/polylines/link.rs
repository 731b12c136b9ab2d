//! The curves that lie in several tiles.

use super::Solved;
use super::row::Row;
use super::trace::{Pieces, Traced};
use curvecrust::DVec2;
use curvecrust::tiles::{PieceSummary, Place, join_pieces};

/// The curves across tiles, and where their pieces lie on them. It is in memory as a whole, and
/// grows with the number of edges that cross borders.
pub(super) struct Across {
    /// Sorted by their names.
    pub(super) rows: Vec<Row>,
    /// For each piece, tile by tile, the number of its curve in `rows` and its place.
    places: Vec<(usize, Place)>,
    /// The number of the first piece of each tile.
    first: Vec<usize>,
    /// The edges of rings across borders, with the numbers of the rings in `rows`.
    pub(super) borders: Vec<(usize, [DVec2; 2])>,
}

impl Across {
    pub(super) fn new(job: &Solved<'_>) -> anyhow::Result<Self> {
        let mut summaries = Vec::new();
        let mut first = vec![0];
        for tile in 0..job.tiles() {
            summaries.extend(Traced::open(job.folder.pieces(tile))?.summaries()?);
            first.push(summaries.len());
        }
        let joined = join_pieces(&summaries)?;
        let rows: Vec<Row> = joined.curves.iter().map(Row::from).collect();
        let places = joined
            .places
            .iter()
            .zip(&summaries)
            .map(|(place, summary)| {
                let found = rows.binary_search_by_key(&place.curve, |row| row.id);
                let number = found.unwrap_or_default();
                let is_turned = joined
                    .curves
                    .get(number)
                    .is_some_and(|c| c.signed_area < 0.0);
                let count = rows.get(number).map_or(0, |row| row.count);
                let place = if is_turned {
                    place.turned(summary.count, count)
                } else {
                    *place
                };
                (number, place)
            });
        let places: Vec<_> = places.collect();
        let is_of_ring = |piece: usize| {
            let (ring, _) = places[piece];
            rows.get(ring).filter(|row| row.closed).map(|_| ring)
        };
        let borders = borders(&summaries, is_of_ring);
        let whole = Pieces::of_curves(rows);
        whole.write(job.folder.across())?;
        Ok(Self {
            rows: whole.rows,
            places,
            first,
            borders,
        })
    }

    /// The numbers of the curves of the pieces of a tile in `rows`, and their places.
    pub(super) fn of_tile(&self, tile: usize) -> &[(usize, Place)] {
        &self.places[self.first[tile]..self.first[tile + 1]]
    }
}

/// The edges between pieces of rings.
fn borders(
    summaries: &[PieceSummary],
    ring: impl Fn(usize) -> Option<usize>,
) -> Vec<(usize, [DVec2; 2])> {
    let mut halves = Vec::new();
    for (piece, summary) in summaries.iter().enumerate() {
        let Some(ring) = ring(piece) else { continue };
        for side in [0, 1] {
            let end = summary.ends[side];
            let half = |link: u64| ([end.min(link), end.max(link)], ring, summary.points[side]);
            halves.extend(summary.links[side].map(half));
        }
    }
    halves.sort_unstable_by_key(|half| half.0);
    let edges = halves.chunk_by(|a, b| a.0 == b.0);
    let edges = edges.filter_map(|halves| match halves {
        [(_, ring, p), (_, _, q)] => Some((*ring, [*p, *q])),
        _ => None,
    });
    edges.collect()
}
