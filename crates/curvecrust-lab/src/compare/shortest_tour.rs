//! A reference: the shortest closed tour through all points, as far as local search finds it.
//!
//! A curve sampled densely enough is the shortest tour of its samples (Giesen, "Curve
//! Reconstruction, the Traveling Salesman Problem and Menger's Theorem on Length", SoCG 1999),
//! which also holds at corners and often far beyond what local rules can do; but there is one curve
//! in it, and that is closed. So it shows how much is to be had for one closed curve, and is no
//! algorithm for points of which nothing is known.
//!
//! 2-opt (Croes 1958) and Or-opt (Or 1976) on lists of neighbours, and again after each of many
//! exchanges of short neighbouring paths at random places, undone unless the tour became shorter
//! (Martin, Otto, Felten 1991). Quadratic in the number of points: for some hundreds.

use curvecrust::DVec2;
use curvecrust::geometry::point_set::by_coordinates;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet, Random};
use curvecrust::reconstruct::{AlgorithmInfo, Reconstructor};

/// The reference.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortestTour;

/// Exchanges are tried with so many neighbours of a point.
const NEIGHBOURS: usize = 8;
/// Paths of up to so many points are moved elsewhere.
const LONGEST_MOVED: usize = 3;
/// Random exchanges for each point, and the longest path of one.
const KICKS: usize = 2;
const LONGEST_KICK: usize = 12;
/// What counts as shorter, as a share of the tour.
const SHORTER: f64 = 1e-12;

impl Reconstructor for ShortestTour {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo::new(
            "shortest-tour",
            "a reference of this project, after J. Giesen, Curve Reconstruction, the Traveling \
             Salesman Problem and Menger's Theorem on Length, SoCG 1999",
            "n^2 and more",
        )
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        // In an order of their own, so that that of the points does not matter.
        let mut ids: Vec<PointId> = points.ids().collect();
        ids.sort_by(|&p, &q| by_coordinates(points[p], points[q]));
        let places: Vec<DVec2> = ids.iter().map(|&id| points[id]).collect();
        let tour = shortest(&places);
        let next = tour.iter().cycle().skip(1);
        let edges = tour
            .iter()
            .zip(next)
            .filter_map(|(&a, &b)| Edge::new(ids[a], ids[b]));
        EdgeSet::new(points.len(), edges)
    }
}

/// The indices of the points in the order of a short tour.
fn shortest(points: &[DVec2]) -> Vec<usize> {
    let count = points.len();
    let near = neighbours(points);
    let mut tour = Tour::of_nearest(points, &near);
    tour.improve((0..count).collect());
    // Of the three tours through four points, 2-opt finds the shortest.
    let kicks = if count < 5 { 0 } else { KICKS * count };
    let mut random = Random::new(1);
    let mut length = tour.length();
    for _ in 0..kicks {
        let kept = tour.order.clone();
        let changed = tour.kick(&mut random);
        tour.improve(changed);
        let found = tour.length();
        if found < length - tour.shorter {
            length = found;
        } else {
            tour.set(kept);
        }
    }
    tour.order
}

/// The nearest other points of each, nearest first.
fn neighbours(points: &[DVec2]) -> Vec<Vec<usize>> {
    let of = |p: usize| {
        let distance = |&q: &usize| points[p].distance_squared(points[q]);
        let mut others: Vec<usize> = (0..points.len()).filter(|&q| q != p).collect();
        let nearer = |a: &usize, b: &usize| distance(a).total_cmp(&distance(b)).then(a.cmp(b));
        if others.len() > NEIGHBOURS {
            others.select_nth_unstable_by(NEIGHBOURS, nearer);
            others.truncate(NEIGHBOURS);
        }
        others.sort_unstable_by(nearer);
        others
    };
    (0..points.len()).map(of).collect()
}

/// A closed tour.
struct Tour<'a> {
    points: &'a [DVec2],
    near: &'a [Vec<usize>],
    order: Vec<usize>,
    /// Where each point is in the order.
    place: Vec<usize>,
    /// Smaller gains are rounding.
    shorter: f64,
}

/// Ways along a tour.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    On,
    Back,
}

impl Way {
    const BOTH: [Self; 2] = [Self::On, Self::Back];

    fn other(self) -> Self {
        match self {
            Self::On => Self::Back,
            Self::Back => Self::On,
        }
    }
}

impl<'a> Tour<'a> {
    /// From the first point on, always to the nearest that is left.
    fn of_nearest(points: &'a [DVec2], near: &'a [Vec<usize>]) -> Self {
        let mut left: Vec<usize> = (0..points.len()).rev().collect();
        let mut order: Vec<usize> = left.pop().into_iter().collect();
        while let Some(&last) = order.last() {
            let distance = |&q: &usize| points[last].distance_squared(points[q]);
            let nearest = left
                .iter()
                .enumerate()
                .min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
            let Some((at, _)) = nearest else { break };
            order.push(left.swap_remove(at));
        }
        let mut tour = Self {
            points,
            near,
            place: vec![0; order.len()],
            order: Vec::new(),
            shorter: 0.0,
        };
        tour.set(order);
        tour.shorter = SHORTER * tour.length();
        tour
    }

    fn set(&mut self, order: Vec<usize>) {
        for (place, &p) in order.iter().enumerate() {
            self.place[p] = place;
        }
        self.order = order;
    }

    fn step(&self, p: usize, way: Way) -> usize {
        let (place, count) = (self.place[p], self.order.len());
        match way {
            Way::On if place + 1 == count => self.order[0],
            Way::On => self.order[place + 1],
            Way::Back => self.order[(if place == 0 { count } else { place }) - 1],
        }
    }

    fn distance(&self, p: usize, q: usize) -> f64 {
        self.points[p].distance(self.points[q])
    }

    fn length(&self) -> f64 {
        let next = self.order.iter().cycle().skip(1);
        let steps = self.order.iter().zip(next);
        steps.map(|(&p, &q)| self.distance(p, q)).sum()
    }

    /// Exchanges edges around the given points, and where that changed something, until none makes
    /// the tour shorter.
    fn improve(&mut self, mut open: Vec<usize>) {
        let mut is_open = vec![false; self.order.len()];
        for &p in &open {
            is_open[p] = true;
        }
        while let Some(p) = open.pop() {
            is_open[p] = false;
            let changed = self.exchanged(p).or_else(|| self.moved(p));
            for q in changed.into_iter().flatten() {
                if !is_open[q] {
                    is_open[q] = true;
                    open.push(q);
                }
            }
        }
    }

    /// 2-opt: for the edges a-b and c-e the edges a-c and b-e, if these are shorter.
    fn exchanged(&mut self, a: usize) -> Option<Vec<usize>> {
        for way in Way::BOTH {
            let b = self.step(a, way);
            let old = self.distance(a, b);
            for &c in &self.near[a] {
                let gain = old - self.distance(a, c);
                if gain <= self.shorter {
                    break;
                }
                let e = self.step(c, way);
                if gain + self.distance(c, e) - self.distance(b, e) > self.shorter {
                    match way {
                        Way::On => self.reverse(b, c),
                        Way::Back => self.reverse(c, b),
                    }
                    return Some(vec![a, b, c, e]);
                }
            }
        }
        None
    }

    /// Turns the path from `first` on to `last` round, or the rest of the tour, which is the same.
    fn reverse(&mut self, first: usize, last: usize) {
        let count = self.order.len();
        let (mut i, mut j) = (self.place[first], self.place[last]);
        let mut inside = (j + count - i) % count + 1;
        if 2 * inside > count {
            (i, j) = ((j + 1) % count, (i + count - 1) % count);
            inside = count - inside;
        }
        for _ in 0..inside / 2 {
            self.order.swap(i, j);
            self.place[self.order[i]] = i;
            self.place[self.order[j]] = j;
            i = (i + 1) % count;
            j = (j + count - 1) % count;
        }
    }

    /// Or-opt: moves a short path that starts at `a` between two other neighbours, one of them near
    /// to `a`.
    fn moved(&mut self, a: usize) -> Option<Vec<usize>> {
        let most = LONGEST_MOVED.min(self.order.len().saturating_sub(3));
        for way in Way::BOTH {
            let before = self.step(a, way.other());
            let mut path = vec![a];
            while path.len() <= most {
                let end = path[path.len() - 1];
                let after = self.step(end, way);
                let gain = self.distance(before, a) + self.distance(end, after)
                    - self.distance(before, after);
                if let Some([c, e]) = self.place_for(&path, gain) {
                    self.put(&path, [before, after], [c, e], way);
                    return Some(vec![before, a, end, after, c, e]);
                }
                path.push(after);
            }
        }
        None
    }

    /// The neighbours between which a path costs less than is gained by taking it away: one for its
    /// start, one for its end.
    fn place_for(&self, path: &[usize], gain: f64) -> Option<[usize; 2]> {
        let (start, end) = (path[0], path[path.len() - 1]);
        for &c in &self.near[start] {
            let rest = gain - self.distance(start, c);
            if rest <= self.shorter {
                return None;
            }
            if path.contains(&c) {
                continue;
            }
            for way in Way::BOTH {
                let e = self.step(c, way);
                let cost = self.distance(end, e) - self.distance(c, e);
                if !path.contains(&e) && rest - cost > self.shorter {
                    return Some([c, e]);
                }
            }
        }
        None
    }

    /// Takes a path out from between two points and puts it in with its start beside `c` and its
    /// end beside `e`.
    fn put(&mut self, path: &[usize], [before, after]: [usize; 2], [c, e]: [usize; 2], way: Way) {
        let mut order = Vec::with_capacity(self.order.len());
        let mut p = after;
        loop {
            order.push(p);
            let next = self.step(p, way);
            if (p, next) == (c, e) {
                order.extend(path);
            } else if (p, next) == (e, c) {
                order.extend(path.iter().rev());
            }
            if p == before {
                break;
            }
            p = next;
        }
        self.set(order);
    }

    /// Exchanges two neighbouring paths at a random place, and says which points have other
    /// neighbours now.
    fn kick(&mut self, random: &mut Random) -> Vec<usize> {
        let count = self.order.len();
        let most = LONGEST_KICK.min((count - 1) / 2);
        let (first, second) = (1 + random.below(most), 1 + random.below(most));
        let start = random.below(count);
        let at = |k: usize| (start + k) % count;
        let places: Vec<usize> = (0..first + second).map(at).collect();
        let mut paths: Vec<usize> = places.iter().map(|&place| self.order[place]).collect();
        paths.rotate_left(first);
        for (&place, &p) in places.iter().zip(&paths) {
            self.order[place] = p;
            self.place[p] = place;
        }
        let ends = [0, second - 1, second, first + second - 1].map(|k| self.order[at(k)]);
        let around = [at(count - 1), at(first + second)].map(|place| self.order[place]);
        ends.into_iter().chain(around).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random_points(count: usize, seed: u64) -> Vec<DVec2> {
        let mut random = Random::new(seed);
        (0..count)
            .map(|_| DVec2::new(random.unit(), random.unit()))
            .collect()
    }

    fn length(points: &[DVec2], tour: &[usize]) -> f64 {
        let next = tour.iter().cycle().skip(1);
        tour.iter()
            .zip(next)
            .map(|(&p, &q)| points[p].distance(points[q]))
            .sum()
    }

    /// The shortest length over all orders of what is left.
    fn brute_force(points: &[DVec2], tour: &mut Vec<usize>) -> f64 {
        if tour.len() == points.len() {
            return length(points, tour);
        }
        let mut best = f64::INFINITY;
        for p in 0..points.len() {
            if !tour.contains(&p) {
                tour.push(p);
                best = best.min(brute_force(points, tour));
                tour.pop();
            }
        }
        best
    }

    #[test]
    fn small_tours_are_the_shortest() {
        for count in 1..8 {
            for seed in 0..20 {
                let points = random_points(count, seed);
                let mut tour = shortest(&points);
                let found = length(&points, &tour);
                tour.sort_unstable();
                assert!(tour.into_iter().eq(0..count));
                let best = brute_force(&points, &mut vec![0]);
                assert!(
                    found <= best * (1.0 + 1e-9),
                    "{count} {seed}: {found} {best}"
                );
            }
        }
        assert!(ShortestTour.reconstruct(&PointSet::default()).is_empty());
    }

    #[test]
    fn a_ragged_circle_is_found_whatever_the_order() {
        let mut random = Random::new(3);
        let on_circle = (0..60).map(|i| {
            let angle = std::f64::consts::TAU * (f64::from(i) + random.between(-0.45, 0.45)) / 60.0;
            DVec2::from_angle(angle)
        });
        let circle: Vec<DVec2> = on_circle.collect();
        for shift in [0, 7, 23] {
            let mut points = circle.clone();
            points.rotate_left(shift);
            let set = PointSet::new(points).unwrap();
            let edges = ShortestTour.reconstruct(&set);
            let ids: Vec<PointId> = set.ids().collect();
            let ring = (0..60).filter_map(|i| Edge::new(ids[i], ids[(i + 1) % 60]));
            assert_eq!(edges, EdgeSet::new(60, ring));
        }
    }
}
