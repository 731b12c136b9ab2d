//! A proof that a tour is the shortest: M. Held, R. M. Karp, "The Traveling-Salesman Problem and
//! Minimum Spanning Trees: Part II", Mathematical Programming 1, 1971.
//!
//! Let every point have a price, and an edge cost its length and the prices of both ends. Every
//! tour then costs its length and twice all prices, so the cheapest tour is the shortest. A 1-tree
//! is a spanning tree of all points but the first, and two edges at the first; a tour is one. So no
//! tour is shorter than the cheapest 1-tree, less twice all prices: that is a bound.
//!
//! 1. **Prices.** They rise where the cheapest 1-tree has more than two edges and fall where it has
//!    less ([`Ascent`]), with the edges between near points alone.
//! 2. **All pairs.** What the 1-tree costs more if it must have an edge is the edge's alpha-value
//!    (Helsgaun 2000). If one is negative, the edge was missed in step 1, which is repeated with
//!    it. Else the bound holds, and edges whose alpha-value exceeds the gap between bound and tour
//!    are in no shorter tour: few are left.
//! 3. **Branch and bound** with these: prices are changed and edges left out by turns. Where that
//!    does not end, an edge at a point with more than two is first forbidden, then required.

mod ascent;
mod moats;
mod one_tree;

use curvecrust_geometry::{EdgeSet, Interrupt, PointSet};
use curvecrust_voronoi::Delaunay;

use crate::tour::Near;

pub(crate) use ascent::Ascent;
pub(crate) use one_tree::{Link, OneTree};

/// Rounds of changed prices in step 1, which is done so many times.
const ROUNDS: u16 = 300;
const TRIES: usize = 10;

/// Rounds between two times of leaving out edges in step 3, and altogether.
const BRANCH_ROUNDS: u16 = 60;
const MOST_ROUNDS: usize = 20_000;

/// So many edges for each point, or so many branches at once, are too many.
const MOST_LINKS: usize = 50;
const MOST_BRANCHES: usize = 100;

/// In a number of rounds, the steps fall from one share of the way to the length to another.
const FIRST_STEP: f64 = 1.0;
const FIRST_BRANCH_STEP: f64 = 0.3;
const LAST_STEP: f64 = 0.002;

/// What counts as equally long, as a share of the tour.
const ROUNDING: f64 = 1e-12;

/// Whether a tour through the points, of which there are three or more, is proven to be the
/// shortest.
pub(crate) fn proves(points: &PointSet, tour: &EdgeSet) -> bool {
    let places = points.points();
    let near = Near::new(points, &Delaunay::new(points));
    let ends = tour.edges().iter().map(|edge| edge.ends().map(u32::from));
    let own: Vec<Link> = ends.map(|ends| Link::new(places, ends)).collect();
    let length = own.iter().map(|link| link.length).sum();
    let proof = Proof { points, length };
    let mut links = near.links(places);
    links.extend(own);
    links.sort_unstable_by_key(|link| link.ends);
    links.dedup_by_key(|link| link.ends);
    match proof.root(links) {
        Root::Done(is_proven) => is_proven,
        Root::Open(branch) => proof.branches(branch),
    }
}

/// What is left after step 2.
enum Root {
    /// Nothing.
    Done(bool),
    Open(Branch),
}

/// A part of all tours: those of some edges, among them all required ones.
struct Branch {
    links: Vec<Link>,
    prices: Vec<f64>,
}

struct Proof<'a> {
    points: &'a PointSet,
    /// Of the tour.
    length: f64,
}

impl Proof<'_> {
    /// What a 1-tree says: whether no tour of the branch is shorter; `None` if that stays open.
    fn verdict(&self, tree: &OneTree) -> Option<bool> {
        if !tree.is_whole || tree.bound >= self.length * (1.0 - ROUNDING) {
            return Some(true);
        }
        tree.is_tour()
            .then_some(self.length <= tree.length * (1.0 + ROUNDING))
    }

    /// Changes prices in so many rounds, from a first step on; a verdict ends that.
    fn rise(&self, ascent: &mut Ascent, links: &[Link], rounds: u16, first: f64) -> Option<bool> {
        let interrupt = Interrupt::current();
        (0..rounds).find_map(|round| {
            interrupt.check();
            let fall = libm::pow(LAST_STEP, f64::from(round) / f64::from(rounds));
            self.verdict(ascent.step(links, self.length, first * fall))
        })
    }

    /// Steps 1 and 2.
    fn root(&self, mut links: Vec<Link>) -> Root {
        let mut ascent = Ascent::new(vec![0.0; self.points.len()], &links);
        for _ in 0..TRIES {
            // The verdict is about near points alone; that about all pairs is taken below.
            let _ = self.rise(&mut ascent, &links, ROUNDS, FIRST_STEP);
            let (prices, tree) = ascent.best(&links);
            let Some((missed, kept)) = self.all_pairs(prices, tree) else {
                return Root::Done(false);
            };
            if missed.is_empty() {
                let branch = || Branch {
                    links: kept,
                    prices: prices.to_vec(),
                };
                let verdict = self.verdict(tree);
                return verdict.map_or_else(|| Root::Open(branch()), Root::Done);
            }
            links.extend(missed);
            // The greatest bound so far was one without these edges.
            ascent.best(&links);
        }
        Root::Done(false)
    }

    /// The edges that would make the 1-tree cheaper, and those that may be in a shorter tour;
    /// `None` if these are too many.
    fn all_pairs(&self, prices: &[f64], tree: &OneTree) -> Option<(Vec<Link>, Vec<Link>)> {
        let interrupt = Interrupt::current();
        let places = self.points.points();
        let (rounding, gap) = (ROUNDING * self.length, self.length - tree.bound);
        let (mut missed, mut kept) = (Vec::new(), Vec::new());
        let ids = || self.points.ids().map(u32::from);
        for v in ids() {
            interrupt.check();
            for w in ids().skip(v as usize + 1) {
                let link = Link::new(places, [v, w]);
                let alpha = link.cost(prices) - tree.replaced(link.ends);
                if alpha < -rounding {
                    missed.push(link);
                }
                if alpha <= gap + rounding {
                    kept.push(link);
                }
            }
            if kept.len() > MOST_LINKS * places.len() {
                return None;
            }
        }
        Some((missed, kept))
    }

    /// Step 3.
    fn branches(&self, root: Branch) -> bool {
        let mut open = vec![root];
        let mut rounds = 0;
        while let Some(branch) = open.pop() {
            let mut ascent = Ascent::new(branch.prices, &branch.links);
            let mut links = branch.links;
            let verdict = loop {
                rounds += usize::from(BRANCH_ROUNDS);
                if rounds > MOST_ROUNDS {
                    return false;
                }
                let verdict = self.rise(&mut ascent, &links, BRANCH_ROUNDS, FIRST_BRANCH_STEP);
                let before = links.len();
                if verdict.is_some() || !self.leave_out(&mut ascent, &mut links) {
                    break verdict.or(Some(true));
                }
                // Rather part the branch than go on for a few edges.
                if links.len() * 20 > before * 19 {
                    break None;
                }
            };
            match verdict {
                Some(true) => {}
                Some(false) => return false,
                None => {
                    let (prices, tree) = ascent.best(&links);
                    open.extend(parted(&links, prices, tree));
                }
            }
            if open.len() > MOST_BRANCHES {
                return false;
            }
        }
        true
    }

    /// Leaves out edges that are in no shorter tour, and requires those without which a point has
    /// less than two; whether each point has two.
    fn leave_out(&self, ascent: &mut Ascent, links: &mut Vec<Link>) -> bool {
        let (prices, tree) = ascent.best(links);
        let most = self.length * (1.0 + ROUNDING) - tree.bound;
        links.retain(|link| {
            link.is_required || link.cost(prices) - tree.replaced(link.ends) <= most
        });
        let count = self.points.len();
        let degrees = degrees(links.iter(), count);
        for link in links.iter_mut() {
            link.is_required |= link.ends.iter().any(|&v| degrees[v as usize] == 2);
        }
        let required = required_degrees(links, count);
        let is_full = |v: u32| required[v as usize] >= 2;
        links.retain(|link| link.is_required || !link.ends.iter().any(|&v| is_full(v)));
        degrees.iter().all(|&degree| degree >= 2) && required.iter().all(|&count| count <= 2)
    }
}

/// The branches with and without an edge of the 1-tree, the longest at a point that has more than
/// two of them, and of these where most are required: with one more, others are left out.
fn parted(links: &[Link], prices: &[f64], tree: &OneTree) -> Vec<Branch> {
    let required = required_degrees(links, prices.len());
    let rank = |link: &Link| {
        let ranks = link.ends.map(|v| {
            let degree = tree.degrees[v as usize];
            (degree > 2, required[v as usize], degree)
        });
        ranks[0].max(ranks[1])
    };
    let free = tree.links.iter().copied();
    let free = free.filter(|&i| !links[i as usize].is_required);
    let parting = free.max_by(|&i, &j| {
        let [e, f] = [i, j].map(|i| &links[i as usize]);
        let degrees = rank(e).cmp(&rank(f));
        degrees.then(e.length.total_cmp(&f.length)).then(j.cmp(&i))
    });
    let Some(parting) = parting.map(|i| i as usize) else {
        return Vec::new();
    };
    let branch = |links: Vec<Link>| Branch {
        links,
        prices: prices.to_vec(),
    };
    let mut without = links.to_vec();
    without.remove(parting);
    let mut with = links.to_vec();
    with[parting].is_required = true;
    vec![branch(with), branch(without)]
}

/// How many edges are at each of so many points.
fn degrees<'a>(links: impl Iterator<Item = &'a Link>, count: usize) -> Vec<u32> {
    let mut degrees = vec![0; count];
    for v in links.flat_map(|link| link.ends) {
        degrees[v as usize] += 1;
    }
    degrees
}

fn required_degrees(links: &[Link], count: usize) -> Vec<u32> {
    degrees(links.iter().filter(|link| link.is_required), count)
}
