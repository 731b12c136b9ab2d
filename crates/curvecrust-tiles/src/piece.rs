//! The chains of one tile, up to its border.

use curvecrust_geometry::DVec2;
use curvecrust_geometry::point_set::by_coordinates;

use crate::area::Area;
use crate::exact_sum::ExactSum;

/// Consecutive samples of a chain that belong to one tile, from border to border.
///
/// # Guarantees
/// - Consecutive samples are joined by an edge; in a closed piece, which is a whole ring, the last
///   and the first too.
/// - At an end without a link, the chain ends: the sample there has one edge, or more than two.
/// - A closed piece starts and goes on as the [`Chain`](curvecrust_geometry::Chain) that it is.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Piece {
    pub(crate) vertices: Vec<u64>,
    pub(crate) links: [Option<u64>; 2],
    pub(crate) closed: bool,
}

/// A piece without its inner samples: all that it takes to join pieces of different tiles.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceSummary {
    /// The first and the last sample.
    pub ends: [u64; 2],
    /// Where they are.
    pub points: [DVec2; 2],
    /// The samples of other tiles that follow the ends, outwards.
    pub links: [Option<u64>; 2],
    /// The samples that follow the ends, inwards; behind a single sample the link on the other
    /// side, or itself.
    pub inner: [u64; 2],
    /// The sample with the smallest id.
    pub least: Least,
    /// The number of samples.
    pub count: u64,
    /// The length of the edges, without those to the links.
    pub length: ExactSum,
    /// The sum of the cross products of the ends of these edges, twice the area between them and
    /// the origin: of a ring with all links twice its signed area. Zero if the chain ends here.
    pub twice_area: ExactSum,
    /// Where the samples are.
    pub area: Area,
    /// Where the sample is that comes first by x, then y.
    pub leftmost: DVec2,
    /// Whether the piece is a whole ring.
    pub closed: bool,
}

/// The sample of a piece with the smallest id: rings start there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Least {
    /// The sample.
    pub id: u64,
    /// Its position in the piece.
    pub position: u64,
    /// The samples before and after it on the chain; itself where the chain ends.
    pub beside: [u64; 2],
}

impl Piece {
    /// The ids of the samples, in order along the chain.
    #[must_use]
    pub fn vertices(&self) -> &[u64] {
        &self.vertices
    }

    /// The samples of other tiles that come before the first and after the last one; `None` where
    /// the chain ends, and in a closed piece.
    #[must_use]
    pub fn links(&self) -> [Option<u64>; 2] {
        self.links
    }

    /// Whether the piece is a whole ring.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// Whether the piece is a whole chain: its tile can make a curve of its summary alone, and only
    /// the other pieces have to be joined across tiles.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.links == [None, None]
    }

    /// What others need to know about the piece. `place` returns where a sample of the tile is.
    #[must_use]
    pub fn summary(&self, place: impl Fn(u64) -> DVec2) -> PieceSummary {
        let places: Vec<DVec2> = self.vertices.iter().map(|&id| place(id)).collect();
        self.summary_of(&places)
    }

    /// The same, given where the samples are, in the order of [`vertices`](Self::vertices).
    #[must_use]
    pub fn summary_of(&self, places: &[DVec2]) -> PieceSummary {
        let vertices = &self.vertices;
        let count = vertices.len();
        let at = |index: usize| vertices.get(index).copied().unwrap_or_default();
        let ends = [at(0), at(count.saturating_sub(1))];
        let [before, after] = self.links;
        let inner = if count > 1 {
            [at(1), at(count - 2)]
        } else {
            [after.unwrap_or(ends[0]), before.unwrap_or(ends[0])]
        };
        let place = |index: usize| places.get(index).copied().unwrap_or_default();
        let (mut length, mut twice_area) = (ExactSum::default(), ExactSum::default());
        let may_be_of_ring = self.closed || self.links.iter().all(Option::is_some);
        let steps = places.windows(2).map(|pair| (pair[0], pair[1]));
        let closing = self
            .closed
            .then(|| (place(count.saturating_sub(1)), place(0)));
        for (from, to) in steps.chain(closing) {
            length.add(from.distance(to));
            if may_be_of_ring {
                add_cross(&mut twice_area, from, to);
            }
        }
        let leftmost = places.iter().copied().min_by(|&a, &b| by_coordinates(a, b));
        PieceSummary {
            ends,
            points: [place(0), place(count.saturating_sub(1))],
            links: self.links,
            inner,
            least: self.least(),
            count: count as u64,
            length,
            twice_area,
            area: Area::of(places.iter().copied()),
            leftmost: leftmost.unwrap_or_default(),
            closed: self.closed,
        }
    }

    fn least(&self) -> Least {
        let vertices = self.vertices.iter().copied().enumerate();
        let (position, id) = vertices.min_by_key(|&(_, id)| id).unwrap_or_default();
        let beside = |index: Option<usize>, link: Option<u64>, round: Option<&u64>| {
            let inside = index.and_then(|index| self.vertices.get(index));
            let round = round.filter(|_| self.closed);
            inside.or(round).copied().or(link).unwrap_or(id)
        };
        let [first, last] = [self.vertices.first(), self.vertices.last()];
        Least {
            id,
            position: position as u64,
            beside: [
                beside(position.checked_sub(1), self.links[0], last),
                beside(Some(position + 1), self.links[1], first),
            ],
        }
    }
}

/// Adds the cross product of two places.
pub(crate) fn add_cross(sum: &mut ExactSum, from: DVec2, to: DVec2) {
    sum.add_product(from.x, to.y);
    sum.add_product(-from.y, to.x);
}
