//! A set of Delaunay triangles whose boundary is made a simple ring through all points: the second
//! part of S. Ohrhallinger, S. Mudur, "An Efficient Algorithm for Determining an Aesthetic Shape
//! Connecting Unorganized 2D Points", Computer Graphics Forum 32(8), 2013.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use curvecrust_geometry::{PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use crate::adjacency::Adjacency;

/// Instead of a triangle: outside of the hull.
const NONE: u32 = u32::MAX;

/// Some triangles of a triangulation: the inside.
pub(crate) struct Region<'a> {
    points: &'a PointSet,
    corners: Vec<[u32; 3]>,
    /// The triangles across the sides, the first of which is between the first two corners.
    beside: Vec<[u32; 3]>,
    is_inside: Vec<bool>,
    /// At every vertex, how many edges part the inside from the outside.
    boundary: Vec<u32>,
    /// At every vertex, how many triangles are inside.
    inner: Vec<u32>,
    /// The triangles at every vertex.
    around: Adjacency,
}

impl<'a> Region<'a> {
    /// The triangles that cannot be reached from outside of the hull without crossing a wall.
    pub(crate) fn within(points: &'a PointSet, delaunay: &Delaunay, walls: &[[u32; 2]]) -> Self {
        let mut walls: Vec<[u32; 2]> = walls.iter().copied().map(ascending).collect();
        walls.sort_unstable();
        let mut region = Self::empty(points, delaunay);
        let mut is_outside = vec![false; region.corners.len()];
        let mut reached = Vec::new();
        let is_open = |side: [u32; 2]| walls.binary_search(&ascending(side)).is_err();
        for face in region.faces() {
            let sides = region.sides(face);
            if sides
                .into_iter()
                .any(|(side, next)| next == NONE && is_open(side))
            {
                is_outside[face as usize] = true;
                reached.push(face);
            }
        }
        while let Some(face) = reached.pop() {
            for (side, next) in region.sides(face) {
                if next != NONE && !is_outside[next as usize] && is_open(side) {
                    is_outside[next as usize] = true;
                    reached.push(next);
                }
            }
        }
        for face in region.faces().filter(|&face| !is_outside[face as usize]) {
            region.turn(face);
        }
        region
    }

    fn empty(points: &'a PointSet, delaunay: &Delaunay) -> Self {
        let corners: Vec<[u32; 3]> = delaunay
            .triangles()
            .map(|corners| corners.map(u32::from))
            .collect();
        let mut beside = vec![[NONE; 3]; corners.len()];
        for dual in delaunay.edges() {
            let ends = dual.ends.map(u32::from);
            let faces = dual
                .triangles
                .map(|face| face.and_then(|face| u32::try_from(face).ok()));
            for (face, other) in [(faces[0], faces[1]), (faces[1], faces[0])] {
                let Some(face) = face else { continue };
                let corners = corners[face as usize];
                let apex = corners.iter().position(|v| !ends.contains(v));
                // The side that follows the apex counter-clockwise is across from it.
                let side = apex.map_or(0, |apex| (apex + 1) % 3);
                beside[face as usize][side] = other.unwrap_or(NONE);
            }
        }
        let mut lists = vec![Vec::new(); points.len()];
        for (face, corners) in (0u32..).zip(&corners) {
            for &corner in corners {
                lists[corner as usize].push(face);
            }
        }
        Self {
            points,
            is_inside: vec![false; corners.len()],
            corners,
            beside,
            boundary: vec![0; points.len()],
            inner: vec![0; points.len()],
            around: Adjacency::of_lists(&lists),
        }
    }

    fn faces(&self) -> impl Iterator<Item = u32> + use<> {
        (0u32..).take(self.corners.len())
    }

    /// The sides of a triangle, each with the triangle across it.
    fn sides(&self, face: u32) -> [([u32; 2], u32); 3] {
        let [a, b, c] = self.corners[face as usize];
        let [ab, bc, ca] = self.beside[face as usize];
        [([a, b], ab), ([b, c], bc), ([c, a], ca)]
    }

    fn is_within(&self, face: u32) -> bool {
        face != NONE && self.is_inside[face as usize]
    }

    fn squared(&self, [v, w]: [u32; 2]) -> f64 {
        let [v, w] = [v, w].map(|v| self.points[PointId::from(v)]);
        v.distance_squared(w)
    }

    /// Moves a triangle from outside to inside or back.
    fn turn(&mut self, face: u32) {
        let was_inside = self.is_inside[face as usize];
        for (side, next) in self.sides(face) {
            let becomes_boundary = self.is_within(next) == was_inside;
            for end in side {
                let edges = &mut self.boundary[end as usize];
                *edges = if becomes_boundary {
                    *edges + 1
                } else {
                    *edges - 1
                };
            }
        }
        for corner in self.corners[face as usize] {
            let inner = &mut self.inner[corner as usize];
            *inner = if was_inside { *inner - 1 } else { *inner + 1 };
        }
        self.is_inside[face as usize] = !was_inside;
    }

    /// Whether all triangles around the vertex are inside.
    fn is_interior(&self, v: u32) -> bool {
        self.boundary[v as usize] == 0 && self.inner[v as usize] > 0
    }

    /// Whether the inside triangles at a vertex are a single fan, or all.
    fn is_regular(&self, v: u32) -> bool {
        self.boundary[v as usize] == 2 || self.is_interior(v)
    }

    /// Turning a triangle, with what the boundary grows by.
    fn step(&self, face: u32) -> Step {
        let is_inside = self.is_within(face);
        let sides = self.sides(face);
        let mut grows = sides.map(|(side, next)| {
            let length = self.squared(side).sqrt();
            if self.is_within(next) == is_inside {
                length
            } else {
                -length
            }
        });
        // The sum is the same in whatever order the sides are.
        grows.sort_unstable_by(f64::total_cmp);
        let mut squared = sides.map(|(side, _)| self.squared(side));
        squared.sort_unstable_by(f64::total_cmp);
        Step {
            cost: grows.iter().sum(),
            sides: squared,
            face,
        }
    }

    /// Moves outside triangles inside, at vertices whose inside triangles are no single fan, until
    /// there is no such vertex: the one first that lengthens the boundary least.
    pub(crate) fn inflate(&mut self) {
        let mut steps = BinaryHeap::new();
        for face in self.faces() {
            self.push_outside(&mut steps, face);
        }
        while let Some(step) = steps.pop() {
            if !self.may_inflate(step.face) {
                continue;
            }
            if self.step(step.face) != step {
                self.push_outside(&mut steps, step.face);
                continue;
            }
            let corners = self.corners[step.face as usize];
            let was_regular = corners.map(|v| self.is_regular(v));
            self.turn(step.face);
            // Triangles across its sides cost less now; those at a vertex that has become irregular
            // were not waiting.
            for (_, next) in self.sides(step.face) {
                self.push_outside(&mut steps, next);
            }
            for (v, was_regular) in corners.into_iter().zip(was_regular) {
                if was_regular && !self.is_regular(v) {
                    for &face in self.around.of(v) {
                        self.push_outside(&mut steps, face);
                    }
                }
            }
        }
    }

    /// Whether a triangle is outside, at a vertex whose inside triangles are no single fan.
    fn may_inflate(&self, face: u32) -> bool {
        let corners = self.corners.get(face as usize);
        !self.is_within(face) && corners.is_some_and(|c| c.iter().any(|&v| !self.is_regular(v)))
    }

    fn push_outside(&self, steps: &mut BinaryHeap<Step>, face: u32) {
        if self.may_inflate(face) {
            steps.push(self.step(face));
        }
    }

    /// Moves inside triangles outside until no point is in the interior, or none can be: each time
    /// the triangle with one side on the boundary and its third corner in the interior that
    /// lengthens the boundary least. So the boundary stays simple.
    pub(crate) fn sculpt(&mut self) {
        let mut steps = BinaryHeap::new();
        for face in self.faces() {
            self.push_removable(&mut steps, face);
        }
        while let Some(Step { face, .. }) = steps.pop() {
            if !self.is_removable(face) {
                continue;
            }
            self.turn(face);
            for (_, next) in self.sides(face) {
                self.push_removable(&mut steps, next);
            }
        }
    }

    fn push_removable(&self, steps: &mut BinaryHeap<Step>, face: u32) {
        if self.is_removable(face) {
            steps.push(self.step(face));
        }
    }

    /// Whether a triangle is inside, with one side on the boundary and its third corner in the
    /// interior.
    fn is_removable(&self, face: u32) -> bool {
        if !self.is_within(face) {
            return false;
        }
        let sides = self.sides(face);
        let mut on_boundary = sides.iter().filter(|(_, next)| !self.is_within(*next));
        let (Some((side, _)), None) = (on_boundary.next(), on_boundary.next()) else {
            return false;
        };
        let mut others = self.corners[face as usize].into_iter();
        let apex = others.find(|v| !side.contains(v));
        apex.is_some_and(|apex| self.is_interior(apex))
    }

    /// The edges between inside and outside.
    pub(crate) fn boundary(&self) -> Vec<[u32; 2]> {
        let inside = self.faces().filter(|&face| self.is_within(face));
        let sides = inside.flat_map(|face| self.sides(face));
        let on_boundary = sides.filter(|&(_, next)| !self.is_within(next));
        on_boundary.map(|(side, _)| side).collect()
    }
}

fn ascending([v, w]: [u32; 2]) -> [u32; 2] {
    [v.min(w), v.max(w)]
}

/// A triangle that may be moved, and what it costs; the cheapest is the greatest.
#[derive(Clone, Copy, Debug)]
struct Step {
    cost: f64,
    /// The squared lengths of its sides, ascending: costs are sums, in which a difference of short
    /// sides may be rounded away.
    sides: [f64; 3],
    face: u32,
}

impl Ord for Step {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_cost = other.cost.total_cmp(&self.cost);
        let sides = other.sides.iter().zip(&self.sides);
        let by_sides = sides.map(|(theirs, ours)| theirs.total_cmp(ours));
        by_sides
            .fold(by_cost, Ordering::then)
            .then_with(|| other.face.cmp(&self.face))
    }
}

impl PartialOrd for Step {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Step {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Step {}
