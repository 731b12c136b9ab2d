//! Pieces of chains from all tiles, joined to whole curves.

use curvecrust_geometry::DVec2;
use curvecrust_geometry::point_set::by_coordinates;

use crate::area::Area;
use crate::error::TilesError;
use crate::exact_sum::ExactSum;
use crate::piece::{PieceSummary, add_cross};

/// The name of a curve: its first two samples, which no other curve has.
///
/// Sorted by their names, curves are in the order of the chains of an
/// [`EdgeSet`](curvecrust_geometry::EdgeSet).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CurveId {
    /// The first sample.
    pub first: u64,
    /// The second one.
    pub second: u64,
}

/// What is known about a whole curve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Curve {
    /// Its name.
    pub id: CurveId,
    /// Whether it is a ring.
    pub closed: bool,
    /// The number of samples; one where an open curve begins and ends counts twice.
    pub count: u64,
    /// The sum of the lengths of its edges, rounded once: it does not depend on the tiles.
    pub length: f64,
    /// The area inside a ring, without rounding error until it is rounded once; negative if the
    /// ring runs clockwise. Zero for an open curve.
    pub signed_area: f64,
    /// Where its samples are.
    pub area: Area,
    /// Where the sample is that comes first by x, then y: [`surrounding`](crate::surrounding) asks
    /// whether other rings lie around it.
    pub leftmost: DVec2,
}

/// Where a piece is on its curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Place {
    /// The curve.
    pub curve: CurveId,
    /// The number of samples of the curve that come before the piece; on a ring, counting goes on
    /// at 0 where it reaches the number of all samples.
    pub start: u64,
    /// Whether the curve runs through the piece from its last sample to its first.
    pub reversed: bool,
}

impl Place {
    /// The place of a piece of some samples on a ring of more, if the ring runs the other way from
    /// the same first sample.
    ///
    /// ```
    /// # use curvecrust_geometry::DVec2;
    /// # use curvecrust_tiles::{join_pieces, pieces};
    /// let edges = [[0, 1], [1, 2], [2, 3], [0, 3]];
    /// let [piece] = &pieces(&[0, 1, 2, 3], &edges)[..] else { panic!() };
    /// let place = join_pieces(&[piece.summary(|_| DVec2::ZERO)])?.places[0];
    /// assert_eq!((place.start, place.reversed), (0, false)); // 0-1-2-3
    /// let place = place.turned(4, 4);
    /// assert_eq!((place.start, place.reversed), (1, true)); // 3-2-1 from position 1, then 0
    /// # Ok::<(), curvecrust_tiles::TilesError>(())
    /// ```
    #[must_use]
    pub fn turned(self, piece: u64, ring: u64) -> Self {
        let last = self.start.saturating_add(piece).saturating_sub(1) % ring.max(1);
        Self {
            curve: self.curve,
            start: (ring - last) % ring.max(1),
            reversed: !self.reversed,
        }
    }
}

/// The curves of all tiles.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct JoinedCurves {
    /// The curves, sorted by their names.
    pub curves: Vec<Curve>,
    /// The place of each piece, in the order of their summaries.
    pub places: Vec<Place>,
}

/// A piece and the direction in which a curve runs through it.
#[derive(Clone, Copy, Debug)]
struct Step {
    piece: usize,
    reversed: bool,
}

/// Joins the pieces of all tiles, in any order, by their links.
///
/// Pieces that are whole chains need no others: each can be given by itself, or left out.
///
/// Direction and start of every curve are those of the
/// [`Chain`](curvecrust_geometry::Chain) with the same samples.
///
/// ```
/// use curvecrust_geometry::DVec2;
/// use curvecrust_tiles::{join_pieces, pieces};
///
/// // The ring 0-1-2-3 of a unit square; one tile has 1 and 2, the other 3 and 0.
/// let edges = [[0, 1], [1, 2], [2, 3], [0, 3]];
/// let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
/// let corner = |id: u64| DVec2::from(corners[id as usize]);
/// let all = [pieces(&[1, 2], &edges), pieces(&[3, 0], &edges)].concat();
/// let summaries: Vec<_> = all.iter().map(|piece| piece.summary(corner)).collect();
/// let joined = join_pieces(&summaries)?;
/// let [ring] = &joined.curves[..] else { panic!() };
/// assert_eq!((ring.closed, ring.count, ring.length), (true, 4, 4.0));
/// // 0 comes first; 1 and 2 follow, then 3.
/// assert_eq!((all[0].vertices(), joined.places[0].start), (&[1, 2][..], 1));
/// assert_eq!((all[1].vertices(), joined.places[1].start), (&[0, 3][..], 3));
/// assert!(joined.places[1].reversed);
/// # Ok::<(), curvecrust_tiles::TilesError>(())
/// ```
///
/// # Errors
/// A link to which no piece has the other side.
pub fn join_pieces(summaries: &[PieceSummary]) -> Result<JoinedCurves, TilesError> {
    let joiner = Joiner::new(summaries);
    let mut found = JoinedCurves::default();
    let unplaced = Place {
        curve: CurveId {
            first: 0,
            second: 0,
        },
        start: 0,
        reversed: false,
    };
    found.places = vec![unplaced; summaries.len()];
    let mut is_placed = vec![false; summaries.len()];
    let is_end = |piece: usize, side: usize| {
        !summaries[piece].closed && summaries[piece].links[side].is_none()
    };
    // What has an end first; what is left are rings.
    let pieces = || 0..summaries.len();
    let from_ends = pieces().flat_map(|piece| [(piece, Some(0)), (piece, Some(1))]);
    for (piece, side) in from_ends.chain(pieces().map(|piece| (piece, None))) {
        if is_placed[piece] || side.is_some_and(|side| !is_end(piece, side)) {
            continue;
        }
        let reversed = side == Some(1);
        let steps = joiner.walk(Step { piece, reversed })?;
        for step in &steps {
            is_placed[step.piece] = true;
        }
        match side {
            Some(_) => joiner.open(steps, &mut found),
            None => joiner.ring(steps, &mut found),
        }
    }
    found.curves.sort_unstable_by_key(|curve| curve.id);
    Ok(found)
}

struct Joiner<'a> {
    summaries: &'a [PieceSummary],
    /// The sample of each end and its link, the piece and its side, sorted.
    ends: Vec<([u64; 2], usize, usize)>,
}

impl<'a> Joiner<'a> {
    fn new(summaries: &'a [PieceSummary]) -> Self {
        let mut ends = Vec::new();
        for (piece, summary) in summaries.iter().enumerate() {
            for side in [0, 1] {
                let link = summary.links[side];
                ends.extend(link.map(|link| ([summary.ends[side], link], piece, side)));
            }
        }
        ends.sort_unstable();
        Self { summaries, ends }
    }

    /// The piece behind another one; `None` where the chain ends.
    fn next(&self, step: Step) -> Result<Option<Step>, TilesError> {
        let summary = &self.summaries[step.piece];
        let side = usize::from(!step.reversed);
        let Some(link) = summary.links[side] else {
            return Ok(None);
        };
        let from = summary.ends[side];
        let found = self.ends.binary_search_by_key(&[link, from], |end| end.0);
        let Ok(found) = found else {
            return Err(TilesError::NoPiece { from, to: link });
        };
        let (_, piece, side) = self.ends[found];
        Ok(Some(Step {
            piece,
            reversed: side == 1,
        }))
    }

    /// From a piece on to the end of the chain, or around.
    fn walk(&self, start: Step) -> Result<Vec<Step>, TilesError> {
        let mut steps = vec![start];
        let mut at = start;
        while let Some(next) = self.next(at)? {
            // Links that do not match could lead into a ring without the start.
            if next.piece == start.piece || steps.len() > self.summaries.len() {
                break;
            }
            steps.push(next);
            at = next;
        }
        Ok(steps)
    }

    /// The end of a piece at which a curve enters or leaves it.
    fn side(step: Step, is_exit: bool) -> usize {
        usize::from(step.reversed != is_exit)
    }

    /// Adds an open curve, given the way from one of its ends.
    fn open(&self, mut steps: Vec<Step>, found: &mut JoinedCurves) {
        let [Some(&first), Some(&last)] = [steps.first(), steps.last()] else {
            return;
        };
        let name = |step: Step, is_exit| {
            let (summary, side) = (&self.summaries[step.piece], Self::side(step, is_exit));
            CurveId {
                first: summary.ends[side],
                second: summary.inner[side],
            }
        };
        let (here, there) = (name(first, false), name(last, true));
        if there < here {
            steps.reverse();
            for step in &mut steps {
                step.reversed = !step.reversed;
            }
        }
        self.add(&steps, here.min(there), 0, false, found);
    }

    /// Adds a ring, given the way around it.
    fn ring(&self, mut steps: Vec<Step>, found: &mut JoinedCurves) {
        let least = |step: &Step| self.summaries[step.piece].least;
        let Some(at) = (0..steps.len()).min_by_key(|&at| least(&steps[at]).id) else {
            return;
        };
        steps.rotate_left(at);
        let first = least(&steps[0]);
        let [before, after] = first.beside;
        // On to the smaller neighbour.
        let reversed = before < after;
        if steps[0].reversed != reversed {
            steps[1..].reverse();
            for step in &mut steps {
                step.reversed = !step.reversed;
            }
        }
        let count = self.summaries[steps[0].piece].count;
        let skipped = if reversed {
            count.saturating_sub(first.position.saturating_add(1))
        } else {
            first.position
        };
        let id = CurveId {
            first: first.id,
            second: before.min(after),
        };
        self.add(&steps, id, skipped, true, found);
    }

    /// Adds a curve that starts behind some samples of its first piece.
    fn add(
        &self,
        steps: &[Step],
        curve: CurveId,
        skipped: u64,
        closed: bool,
        found: &mut JoinedCurves,
    ) {
        let summaries = || steps.iter().map(|step| &self.summaries[step.piece]);
        let count = summaries().fold(0u64, |count, s| count.saturating_add(s.count));
        let (mut length, mut twice_area) = (ExactSum::default(), ExactSum::default());
        let mut start = count.saturating_sub(skipped);
        for (at, &step) in steps.iter().enumerate() {
            let summary = &self.summaries[step.piece];
            length.add_sum(&summary.length);
            if closed {
                twice_area.add_signed(&summary.twice_area, step.reversed);
            }
            let next = steps.get(at + 1).or(steps.first().filter(|_| closed));
            // A ring of one closed piece has all of its edges already.
            if let Some(&next) = next.filter(|_| !summary.closed) {
                let from = summary.points[Self::side(step, true)];
                let to = self.summaries[next.piece].points[Self::side(next, false)];
                length.add(from.distance(to));
                if closed {
                    add_cross(&mut twice_area, from, to);
                }
            }
            found.places[step.piece] = Place {
                curve,
                start: start % count.max(1),
                reversed: step.reversed,
            };
            start = start.saturating_add(summary.count);
        }
        found.curves.push(Curve {
            id: curve,
            closed,
            count,
            length: length.value(),
            signed_area: twice_area.value() / 2.0,
            area: summaries().fold(Area::NOTHING, |area, s| area.union(s.area)),
            leftmost: summaries()
                .map(|summary| summary.leftmost)
                .min_by(|&a, &b| by_coordinates(a, b))
                .unwrap_or_default(),
        });
    }
}
