//! Chains of thinned places, in order along the curves.

use glam::DVec2;

use curvecrust_geometry::{EdgeSet, MergedPoints, PointSet};
use curvecrust_reconstruct::{LeastDetour, Reconstructor};

use crate::band::Member;
use crate::spline::Guide;
use crate::tree::Tree;

/// The distance between thinned places, in scales.
const SPACING: f64 = 0.5;
/// Two ends are bridged that are at most this many spacings apart.
const BRIDGE: f64 = 6.0;
/// If the strip between them holds at least this share of the points that the density at both ends
/// lets expect.
const FILLED: f64 = 0.4;
/// The edges at an end that tell the density there.
const EDGES: usize = 6;

/// Places in order along a curve.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    /// Positions in the list of places.
    pub(crate) vertices: Vec<usize>,
    pub(crate) closed: bool,
}

/// A thinned place of the band.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) at: DVec2,
    pub(crate) spacing: f64,
    pub(crate) sigma: f64,
}

/// A Poisson disk of the places of the band: those that moved least first.
pub(crate) fn thinned(points: &[DVec2], members: &[Member]) -> Vec<Place> {
    let moved = |m: &Member| m.place.distance(points[m.index]) / m.radius;
    let mut order: Vec<(f64, usize)> = members.iter().map(moved).zip(0..).collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let places: Vec<DVec2> = members.iter().map(|m| m.place).collect();
    let tree = Tree::new(&places);
    let mut covered = vec![false; places.len()];
    let mut kept = Vec::new();
    for (_, i) in order {
        if covered[i] {
            continue;
        }
        let spacing = SPACING * members[i].radius;
        for j in tree.within(places[i], spacing) {
            covered[j] = true;
        }
        kept.push(i);
    }
    kept.sort_unstable();
    let place = |&i: &usize| Place {
        at: places[i],
        spacing: SPACING * members[i].radius,
        sigma: members[i].sigma,
    };
    kept.iter().map(place).collect()
}

/// The chains of least detour through the places, of three or more.
pub(crate) fn chains(places: &[Place]) -> Vec<Chain> {
    let Some(set) = as_set(places.iter().map(|p| p.at)) else {
        return Vec::new();
    };
    chains_of(&LeastDetour.reconstruct(&set.points), |v| set.origin[v])
}

/// Points of the unit box as a set that algorithms take, in which equal ones are one.
pub(crate) fn as_set(points: impl Iterator<Item = DVec2>) -> Option<MergedPoints> {
    // Moved away from zero, below whose magnitude predicates lose digits.
    let moved = points.map(|p| p + DVec2::ONE).collect();
    PointSet::merging_duplicates(moved).ok()
}

/// The chains of edges that have three places or more; `place` gives that of a vertex.
pub(crate) fn chains_of(edges: &EdgeSet, place: impl Fn(usize) -> usize) -> Vec<Chain> {
    let found = edges.chains().into_iter().map(|chain| Chain {
        closed: chain.is_closed(),
        vertices: chain.vertices().iter().map(|v| place(v.index())).collect(),
    });
    found.filter(|chain| chain.vertices.len() >= 3).collect()
}

/// An end of an open chain.
#[derive(Clone, Copy)]
struct End {
    chain: usize,
    at_last: bool,
    vertex: usize,
    /// Points a length along the chain there.
    density: f64,
}

/// Joins ends of chains where the points go on between them.
pub(crate) fn bridged(
    chains: Vec<Chain>,
    places: &[Place],
    points: &[DVec2],
    tree: &Tree,
) -> Vec<Chain> {
    let strip = Strip {
        places,
        points,
        tree,
    };
    let mut ends = Vec::new();
    for (c, chain) in chains.iter().enumerate().filter(|(_, chain)| !chain.closed) {
        for at_last in [false, true] {
            let mut inwards = chain.vertices.clone();
            if at_last {
                inwards.reverse();
            }
            inwards.truncate(EDGES + 1);
            ends.push(End {
                chain: c,
                at_last,
                vertex: inwards[0],
                density: strip.density(&inwards),
            });
        }
    }
    let around = Tree::new(&ends.iter().map(|e| places[e.vertex].at).collect::<Vec<_>>());
    let mut pairs = Vec::new();
    for (x, a) in ends.iter().enumerate() {
        // The other end may have the larger spacing: it then finds this one.
        let reach = BRIDGE * places[a.vertex].spacing;
        for y in around.within(places[a.vertex].at, reach) {
            let (x, y) = (x.min(y), x.max(y));
            let short = ends[x].chain == ends[y].chain && chains[ends[x].chain].vertices.len() < 4;
            if x == y || short {
                continue;
            }
            if let Some(gap) = strip.gap(&ends[x], &ends[y]) {
                pairs.push((gap, x, y));
            }
        }
    }
    pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut partner = vec![None; ends.len()];
    for (_, x, y) in pairs {
        if partner[x].is_none() && partner[y].is_none() {
            (partner[x], partner[y]) = (Some(y), Some(x));
        }
    }
    join(chains, &ends, &partner)
}

/// Follows chains and bridges.
fn join(chains: Vec<Chain>, ends: &[End], partner: &[Option<usize>]) -> Vec<Chain> {
    let mut joined: Vec<Chain> = chains.iter().filter(|c| c.closed).cloned().collect();
    let mut used = vec![false; chains.len()];
    // The two ends of a chain are neighbours in the list.
    let other = |end: usize| end ^ 1;
    // Free ends first: what is left then goes round.
    let free = (0..ends.len()).filter(|&e| partner[e].is_none());
    for first in free.chain(0..ends.len()) {
        if used[ends[first].chain] {
            continue;
        }
        let mut vertices = Vec::new();
        let mut enters = first;
        let closed = loop {
            let chain = ends[enters].chain;
            used[chain] = true;
            let along = chains[chain].vertices.iter().copied();
            if ends[enters].at_last {
                vertices.extend(along.rev());
            } else {
                vertices.extend(along);
            }
            match partner[other(enters)] {
                None => break false,
                Some(next) if next == first => break true,
                Some(next) => enters = next,
            }
        };
        joined.push(Chain { vertices, closed });
    }
    joined
}

struct Strip<'a> {
    places: &'a [Place],
    points: &'a [DVec2],
    tree: &'a Tree,
}

impl Strip<'_> {
    /// The points within half a width of the segment from a to b, not beyond its ends.
    fn count(&self, a: DVec2, b: DVec2, half_width: f64) -> usize {
        let length = a.distance(b);
        let direction = (b - a).normalize_or_zero();
        let near = self.tree.within(a.midpoint(b), length / 2.0 + half_width);
        let inside = near.iter().filter(|&&i| {
            let p = self.points[i] - a;
            let along = p.dot(direction);
            (0.0..=length).contains(&along) && direction.perp_dot(p).abs() <= half_width
        });
        inside.count()
    }

    /// Points a length along places in order.
    fn density(&self, along: &[usize]) -> f64 {
        let (mut count, mut length) = (0, 0.0);
        for pair in along.windows(2) {
            let [a, b] = [self.places[pair[0]], self.places[pair[1]]];
            count += self.count(a.at, b.at, 3.0 * a.sigma + 0.1 * a.spacing);
            length += a.at.distance(b.at);
        }
        if length > 0.0 {
            count as f64 / length
        } else {
            0.0
        }
    }

    /// The width of the gap between two ends in spacings, if points fill it.
    fn gap(&self, x: &End, y: &End) -> Option<f64> {
        let [a, b] = [self.places[x.vertex], self.places[y.vertex]];
        let (distance, spacing) = (a.at.distance(b.at), a.spacing.max(b.spacing));
        let half_width = 3.0 * a.sigma.max(b.sigma) + 0.1 * spacing;
        let expected = x.density.min(y.density) * distance;
        let found = self.count(a.at, b.at, half_width) as f64;
        (distance <= BRIDGE * spacing && found >= FILLED * expected).then_some(distance / spacing)
    }
}

/// The polyline of a chain; at the ends of an open one a spacing longer, for points that scatter
/// beyond.
pub(crate) fn guide(places: &[Place], chain: &Chain) -> Guide {
    let mut along: Vec<Place> = chain.vertices.iter().map(|&v| places[v]).collect();
    if let (false, [first, second, .., before, last]) = (chain.closed, &*along) {
        let beyond = |end: &Place, inner: &Place| Place {
            at: end.at + (end.at - inner.at).normalize_or_zero() * end.spacing,
            ..*end
        };
        let (start, end) = (beyond(first, second), beyond(last, before));
        along.insert(0, start);
        along.push(end);
    }
    let guide = Guide {
        vertices: along.iter().map(|p| p.at).collect(),
        spacing: along.iter().map(|p| p.spacing).collect(),
        sigma: along.iter().map(|p| p.sigma).collect(),
        closed: false,
        creases: Vec::new(),
        even: false,
    };
    if chain.closed { guide.closed() } else { guide }
}
