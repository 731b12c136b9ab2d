//! From the edges of a tile to pieces of chains.

use crate::ids::Ids;
use crate::piece::Piece;

/// The neighbours of the samples of a tile.
struct Graph {
    /// A sample's index is its position here.
    ids: Ids,
    /// Neighbours of the sample at index v: `to[first[v]..first[v + 1]]`.
    first: Vec<usize>,
    to: Vec<Neighbour>,
    /// Of a sample at which no piece ends its two neighbours, else [`STOP`]: walks go from one to
    /// the next, and what is small stays in the cache. Empty if there are too many samples.
    inner: Vec<[u32; 2]>,
}

/// What stands for the neighbours of a sample at which pieces end.
const STOP: [u32; 2] = [u32::MAX; 2];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Neighbour {
    /// The index of a sample of the tile.
    Inside(usize),
    /// The id of a sample of another one.
    Outside(u64),
}

/// The chains of the samples of a tile, cut where they leave it and at junctions, sorted.
///
/// `ids` are those of the samples of the tile, in any order; `edges` are all edges with at least
/// one end among them, each once, in any order. Edges without such an end are left out. Every edge
/// between two samples of the tile is in exactly one piece, and every other one is the link of one.
/// A sample without an edge is in none.
///
/// ```
/// use curvecrust_tiles::pieces;
///
/// // A chain 1-2-3-4-5, of which this tile has 2, 3 and 5.
/// let found = pieces(&[2, 3, 5], &[[1, 2], [2, 3], [3, 4], [4, 5]]);
/// assert_eq!(found[0].vertices(), [2, 3]);
/// assert_eq!(found[0].links(), [Some(1), Some(4)]);
/// assert_eq!((found[1].vertices(), found[1].links()), (&[5][..], [None, Some(4)]));
/// ```
#[must_use]
pub fn pieces(ids: &[u64], edges: &[[u64; 2]]) -> Vec<Piece> {
    let graph = Graph::new(ids, edges);
    let mut found = Vec::new();
    let mut is_inner = vec![false; graph.len()];
    let stops = (0..graph.len()).filter(|&v| graph.is_stop(v));
    for stop in stops {
        for &to in graph.of(stop) {
            match to {
                Neighbour::Inside(second) => {
                    let path = graph.walk(stop, second);
                    for &v in &path[1..path.len() - 1] {
                        is_inner[v] = true;
                    }
                    // Each path is walked from both of its ends and kept once.
                    if path.iter().le(path.iter().rev()) {
                        found.push(graph.piece(&path, false));
                    }
                }
                Neighbour::Outside(link) => found.extend(graph.alone(stop, link)),
            }
        }
    }
    for start in 0..graph.len() {
        if !is_inner[start]
            && let Some([second, _]) = graph.inner(start)
        {
            let mut ring = graph.walk(start, second);
            ring.pop();
            for &v in &ring {
                is_inner[v] = true;
            }
            found.push(graph.piece(&ring, true));
        }
    }
    found.sort_unstable();
    found
}

impl Graph {
    fn new(ids: &[u64], edges: &[[u64; 2]]) -> Self {
        let ids = Ids::new(ids.to_vec());
        let index = |id: &u64| ids.position(*id);
        let mut pairs: Vec<(usize, u64)> = Vec::with_capacity(2 * edges.len());
        for [p, q] in edges {
            pairs.extend(index(p).map(|at| (at, *q)));
            pairs.extend(index(q).map(|at| (at, *p)));
        }
        // Smaller neighbours come first.
        pairs.sort_unstable();
        pairs.dedup();
        let mut first = vec![0; ids.as_slice().len() + 1];
        for &(at, _) in &pairs {
            first[at + 1] += 1;
        }
        for at in 1..first.len() {
            first[at] += first[at - 1];
        }
        let neighbour = |(_, id): (usize, u64)| match index(&id) {
            Some(at) => Neighbour::Inside(at),
            None => Neighbour::Outside(id),
        };
        let to = pairs.into_iter().map(neighbour).collect();
        let mut graph = Self {
            ids,
            first,
            to,
            inner: Vec::new(),
        };
        if u32::try_from(graph.len()).is_ok() {
            let inner = |v: usize| graph.neighbours(v).map_or(STOP, |pair| pair.map(small));
            graph.inner = (0..graph.len()).map(inner).collect();
        }
        graph
    }

    /// The number of samples.
    fn len(&self) -> usize {
        self.ids.as_slice().len()
    }

    fn id(&self, v: usize) -> u64 {
        self.ids.as_slice()[v]
    }

    fn of(&self, v: usize) -> &[Neighbour] {
        &self.to[self.first[v]..self.first[v + 1]]
    }

    /// The two neighbours of a sample at which no piece ends.
    fn neighbours(&self, v: usize) -> Option<[usize; 2]> {
        match *self.of(v) {
            [Neighbour::Inside(p), Neighbour::Inside(q)] => Some([p, q]),
            _ => None,
        }
    }

    /// The same, faster.
    fn inner(&self, v: usize) -> Option<[usize; 2]> {
        match self.inner.get(v) {
            Some(&STOP) => None,
            Some(&pair) => Some(pair.map(|at| at as usize)),
            None => self.neighbours(v),
        }
    }

    /// Whether pieces end at a sample.
    fn is_stop(&self, v: usize) -> bool {
        self.inner(v).is_none()
    }

    /// From a sample by way of a second one to the next stop, or back to the first.
    fn walk(&self, start: usize, second: usize) -> Vec<usize> {
        let mut path = vec![start, second];
        let (mut from, mut at) = (start, second);
        while at != start
            && let Some([p, q]) = self.inner(at)
        {
            (from, at) = (at, if p == from { q } else { p });
            path.push(at);
        }
        path
    }

    /// The link of a chain that does not end at a stop: to the neighbour outside, the other of two.
    fn link(&self, stop: usize) -> Option<u64> {
        match *self.of(stop) {
            [Neighbour::Outside(id), Neighbour::Inside(_)]
            | [Neighbour::Inside(_), Neighbour::Outside(id)] => Some(id),
            _ => None,
        }
    }

    fn piece(&self, path: &[usize], closed: bool) -> Piece {
        let end = |at: Option<&usize>| at.and_then(|&at| self.link(at));
        Piece {
            vertices: path.iter().map(|&at| self.id(at)).collect(),
            links: [end(path.first()), end(path.last())],
            closed,
        }
    }

    /// The piece of a single sample that goes with a link, if there is one that is not found by
    /// way of another link or neighbour.
    fn alone(&self, v: usize, link: u64) -> Option<Piece> {
        let links = match *self.of(v) {
            [Neighbour::Outside(before), Neighbour::Outside(after)] => {
                // Found by way of each.
                (link == before).then_some([Some(before), Some(after)])?
            }
            [_, _] => return None,
            _ => [None, Some(link)],
        };
        Some(Piece {
            vertices: vec![self.id(v)],
            links,
            closed: false,
        })
    }
}

/// An index that is less than a number of 32 bits.
fn small(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
