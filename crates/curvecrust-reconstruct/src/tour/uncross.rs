//! Edges that meet elsewhere than at a common end are exchanged until there are none.
//!
//! - Two edges that cross, or of which one ends inside the other at a point where its curve goes
//!   straight on, are exchanged for the two that keep a tour: by the triangle inequality these are
//!   shorter.
//! - Any other point inside an edge is taken from between its neighbours and put into that edge,
//!   which is shorter too: the point is no way straight on between its neighbours.
//!
//! Signs are exact, so the length falls each time and the steps end. Where straight runs of edges
//! on one line overlap, an end of one of them lies inside an edge of the other, and is no point
//! where the curve goes straight on: unless all points of a closed curve lie on one line, there is
//! a step as long as edges meet. What remains of open curves is due to given termini.

use curvecrust_geometry::{DVec2, orient2d};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::cost::Cost;
use super::order::Order;

/// The tour with no edges that meet elsewhere than at a common end.
pub(super) fn uncrossed(cost: &Cost<'_>, tour: Vec<u32>) -> Vec<u32> {
    let mut uncross = Uncross {
        points: cost.points(),
        cost,
        tour: Order::new(tour),
    };
    loop {
        let mut is_changed = false;
        for meeting in uncross.meetings() {
            is_changed |= uncross.resolve(meeting);
        }
        if !is_changed {
            return uncross.tour.into_inner();
        }
    }
}

/// Where edges meet that should not.
#[derive(Clone, Copy)]
enum Meeting {
    /// Inside both.
    Crossing([u32; 2], [u32; 2]),
    /// A point inside an edge.
    Touch(u32, [u32; 2]),
}

struct Uncross<'a> {
    points: &'a [DVec2],
    cost: &'a Cost<'a>,
    tour: Order,
}

impl Uncross<'_> {
    fn meetings(&self) -> Vec<Meeting> {
        let edges = self
            .tour
            .edges()
            .filter(|edge| !edge.iter().any(|&v| self.cost.is_gap(v)));
        let edges: Vec<[u32; 2]> = edges.collect();
        let corners = |edge: [u32; 2]| edge.map(|v| self.at(v).to_array());
        let boxed = |(index, &edge): (usize, &[u32; 2])| {
            let [a, b] = corners(edge);
            GeomWithData::new(Rectangle::from_corners(a, b), index)
        };
        let tree = RTree::bulk_load(edges.iter().enumerate().map(boxed).collect());
        let mut meetings = Vec::new();
        for &edge in &edges {
            let [a, b] = corners(edge);
            let mut others: Vec<[u32; 2]> = tree
                .locate_in_envelope_intersecting(AABB::from_corners(a, b))
                .map(|other| edges[other.data])
                .filter(|&other| other > edge)
                .collect();
            others.sort_unstable();
            for other in others {
                self.extend(&mut meetings, edge, other);
            }
        }
        meetings
    }

    fn extend(&self, meetings: &mut Vec<Meeting>, e: [u32; 2], f: [u32; 2]) {
        let before = meetings.len();
        for (e, f) in [(e, f), (f, e)] {
            let inside = e.into_iter().filter(|&v| self.is_inside(v, f));
            meetings.extend(inside.map(|v| Meeting::Touch(v, f)));
        }
        let is_apart = !e.iter().any(|v| f.contains(v));
        if meetings.len() == before && is_apart && self.separates(e, f) && self.separates(f, e) {
            meetings.push(Meeting::Crossing(e, f));
        }
    }

    fn at(&self, v: u32) -> DVec2 {
        self.points[v as usize]
    }

    fn orient(&self, vertices: [u32; 3]) -> f64 {
        let [a, b, c] = vertices.map(|v| self.at(v));
        orient2d(a, b, c)
    }

    /// Whether the ends of an edge lie on both sides of the line of another.
    fn separates(&self, [a, b]: [u32; 2], [c, d]: [u32; 2]) -> bool {
        let sides = [self.orient([a, b, c]), self.orient([a, b, d])];
        sides[0] > 0.0 && sides[1] < 0.0 || sides[0] < 0.0 && sides[1] > 0.0
    }

    /// Whether a vertex lies on an edge and is no end of it.
    fn is_inside(&self, v: u32, [a, b]: [u32; 2]) -> bool {
        let [p, low, high] = [
            self.at(v),
            self.at(a).min(self.at(b)),
            self.at(a).max(self.at(b)),
        ];
        let is_in_box = p.cmpge(low).all() && p.cmple(high).all();
        v != a && v != b && is_in_box && self.orient([a, b, v]) == 0.0
    }

    fn is_edge(&self, [a, b]: [u32; 2]) -> bool {
        self.tour.are_joined(a, b)
    }

    /// The edge in the direction of the tour.
    fn directed(&self, [a, b]: [u32; 2]) -> [u32; 2] {
        if self.tour.next(a) == b {
            [a, b]
        } else {
            [b, a]
        }
    }

    /// Whether something changed.
    fn resolve(&mut self, meeting: Meeting) -> bool {
        match meeting {
            Meeting::Crossing(e, f) => {
                let is_there = self.is_edge(e) && self.is_edge(f);
                if is_there {
                    self.exchange(e, f);
                }
                is_there
            }
            Meeting::Touch(v, edge) => self.is_edge(edge) && self.resolve_touch(v, edge),
        }
    }

    /// Replaces two edges by two that keep a tour.
    fn exchange(&mut self, e: [u32; 2], f: [u32; 2]) {
        let ([a, b], [c, d]) = (self.directed(e), self.directed(f));
        self.tour.exchange([a, b, d, c]);
    }

    fn resolve_touch(&mut self, v: u32, edge: [u32; 2]) -> bool {
        let [a, b] = self.directed(edge);
        let [p, q] = [self.tour.previous(v), self.tour.next(v)];
        match [p, q].map(|w| self.cost.is_gap(w)) {
            [false, false] if self.is_inside(v, [p, q]) => {
                let is_across = self.orient([a, b, p]) != 0.0;
                if is_across {
                    self.exchange([p, v], [a, b]);
                }
                is_across
            }
            [false, false] => {
                self.put(v, [a, b]);
                true
            }
            [true, true] => false,
            [is_start, _] if self.cost.is_terminus(v) => {
                // The length falls unless the point lies between the other ends of the new edge.
                let (from, to) = if is_start { (q, b) } else { (p, a) };
                let falls = from != to && !self.is_inside(v, [from, to]);
                if falls {
                    self.exchange(if is_start { [v, q] } else { [p, v] }, [a, b]);
                }
                falls
            }
            [is_start, _] => {
                let (next, beyond) = if is_start {
                    (q, self.tour.next(q))
                } else {
                    (p, self.tour.previous(p))
                };
                let is_possible = !self.cost.is_gap(beyond) || edge.contains(&next);
                if is_possible {
                    self.put(v, [a, b]);
                }
                is_possible
            }
        }
    }

    /// Takes a vertex from between its neighbours and puts it between two others, which are in the
    /// direction of the tour.
    fn put(&mut self, v: u32, [a, b]: [u32; 2]) {
        let [p, q] = [self.tour.previous(v), self.tour.next(v)];
        if b == p {
            self.tour.exchange([a, p, q, v]);
            return;
        }
        self.tour.exchange([p, v, b, a]);
        if a != q {
            self.tour.exchange([p, a, v, q]);
        }
    }
}
