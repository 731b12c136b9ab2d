//! Where strokes touch, and what is cut off of them there.

use std::collections::HashMap;

use glam::DVec2;

use crate::bezier::CubicBezier;
use crate::bezier_path::BezierPath;

/// A stroke as points at about equal distances.
pub(super) struct Dense {
    pub(super) points: Vec<DVec2>,
    /// The segment and the parameter of each.
    pub(super) places: Vec<(usize, f64)>,
    /// How far along the stroke each is.
    along: Vec<f64>,
    length: f64,
    closed: bool,
    path: BezierPath,
}

/// Points of all strokes, at most: where many are in one place, the time goes with their square.
pub(super) const POINTS: usize = 200_000;

/// A place where another stroke touches this one.
pub(super) struct Touch {
    pub(super) stroke: usize,
    /// The segment and the parameter there.
    pub(super) place: (usize, f64),
    pub(super) at: DVec2,
}

/// A point of a stroke: the indices of both.
type Id = (usize, usize);

impl Dense {
    pub(super) fn new(path: &BezierPath, step: f64) -> Self {
        let mut dense = Self {
            points: Vec::new(),
            places: Vec::new(),
            along: Vec::new(),
            length: 0.0,
            closed: path.is_closed(),
            path: path.clone(),
        };
        let mut last = path
            .segments()
            .first()
            .map_or(DVec2::ZERO, CubicBezier::start);
        for (index, segment) in path.segments().iter().enumerate() {
            let [a, b, c, d] = segment.control_points();
            let length = a.distance(b) + b.distance(c) + c.distance(d);
            let count = (length / step).ceil().clamp(1.0, POINTS as f64);
            let mut i = 0.0;
            while i < count && dense.points.len() <= POINTS {
                let p = segment.point(i / count);
                dense.length += p.distance(last);
                last = p;
                // Many short segments are as few long ones.
                if dense
                    .along
                    .last()
                    .is_none_or(|at| dense.length - at > step / 2.0)
                {
                    dense.push(p, (index, i / count));
                }
                i += 1.0;
            }
        }
        if let Some(segment) = path.segments().last() {
            dense.length += last.distance(segment.end());
            if !path.is_closed() {
                dense.push(segment.end(), (path.segments().len() - 1, 1.0));
            }
        }
        dense
    }

    fn push(&mut self, p: DVec2, place: (usize, f64)) {
        self.points.push(p);
        self.places.push(place);
        self.along.push(self.length);
    }

    /// How far it is along the stroke from one point to another.
    fn between(&self, i: usize, j: usize) -> f64 {
        let ahead = (self.along[i] - self.along[j]).abs();
        if self.closed {
            ahead.min(self.length - ahead)
        } else {
            ahead
        }
    }

    /// The distance along the stroke from a point to the nearer end; infinite if the stroke is
    /// closed.
    fn to_end(&self, i: usize) -> f64 {
        if self.closed {
            f64::INFINITY
        } else {
            self.along[i].min(self.length - self.along[i])
        }
    }

    /// The place nearest to a point, between the neighbours of one.
    fn nearest(&self, i: usize, to: DVec2) -> ((usize, f64), DVec2) {
        let (segment, t) = self.places[i];
        let bezier = &self.path.segments()[segment];
        let neighbour = |j: usize| self.places.get(j).filter(|place| place.0 == segment);
        let low = i
            .checked_sub(1)
            .and_then(neighbour)
            .map_or(t, |place| place.1);
        let high = neighbour(i + 1).map_or(1.0, |place| place.1);
        let (mut low, mut high) = (low, high);
        for _ in 0..80 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if bezier.point(a).distance_squared(to) <= bezier.point(b).distance_squared(to) {
                high = b;
            } else {
                low = a;
            }
        }
        let t = f64::midpoint(low, high);
        // As near as squared distances can tell.
        let at = bezier.point(t);
        let join = 1e-6 * bezier.start().distance(bezier.end());
        if at.distance(bezier.start()) <= join {
            ((segment, 0.0), bezier.start())
        } else if at.distance(bezier.end()) <= join {
            ((segment, 1.0), bezier.end())
        } else {
            ((segment, t), at)
        }
    }
}

/// Points in cells as wide as the gap.
struct Grid<'a> {
    dense: &'a [Dense],
    gap: f64,
    cells: HashMap<[i64; 2], Vec<Id>>,
}

impl<'a> Grid<'a> {
    fn new(dense: &'a [Dense], gap: f64) -> Self {
        let mut cells: HashMap<_, Vec<Id>> = HashMap::new();
        for (stroke, of) in dense.iter().enumerate() {
            for (i, &p) in of.points.iter().enumerate() {
                cells.entry(cell(p, gap)).or_default().push((stroke, i));
            }
        }
        Self { dense, gap, cells }
    }

    /// The points of other strokes, or of far parts of the same, within a distance, which is not
    /// above the gap; in the order of the strokes.
    fn near(&self, (stroke, i): Id, distance: f64) -> Vec<Id> {
        let p = self.dense[stroke].points[i];
        let [x, y] = cell(p, self.gap);
        let cells = (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y]));
        let here = cells.filter_map(|cell| self.cells.get(&cell)).flatten();
        let near = here.copied().filter(|&(other, j)| {
            let is_far = other != stroke || self.dense[stroke].between(i, j) > FAR * self.gap;
            is_far && self.dense[other].points[j].distance_squared(p) <= distance * distance
        });
        let mut near: Vec<Id> = near.collect();
        near.sort_unstable();
        near
    }
}

/// Parts of one stroke that are farther apart along it than this many gaps are as of two.
const FAR: f64 = 3.0;

#[expect(
    clippy::cast_possible_truncation,
    reason = "some hundred gaps in an extent"
)]
fn cell(p: DVec2, gap: f64) -> [i64; 2] {
    [(p.x / gap).floor() as i64, (p.y / gap).floor() as i64]
}

/// Which points of which stroke are cut off, and where strokes touch that run through.
pub(super) fn cut(dense: &[Dense], gap: f64) -> (Vec<Vec<bool>>, Vec<Touch>) {
    let grid = Grid::new(dense, gap);
    let mut pairs: Vec<(bool, Id, Id)> = Vec::new();
    for (stroke, of) in dense.iter().enumerate() {
        for i in 0..of.points.len() {
            for other in grid.near((stroke, i), gap / 8.0) {
                let id = (stroke, i);
                let ends = [id, other].map(|(s, i)| dense[s].to_end(i) <= gap);
                let loses = match ends {
                    [true, false] => true,
                    [false, true] => false,
                    _ => id > other,
                };
                if loses {
                    // Those at ends come first.
                    pairs.push((!ends[0], id, other));
                }
            }
        }
    }
    pairs.sort_unstable();
    let mut is_cut: Vec<Vec<bool>> = dense.iter().map(|d| vec![false; d.points.len()]).collect();
    let mut touches: Vec<Touch> = Vec::new();
    for (_, (stroke, i), (other, j)) in pairs {
        if is_cut[stroke][i] || is_cut[other][j] {
            continue;
        }
        let (place, at) = meeting(&dense[stroke], i, &dense[other], j, gap);
        if touches.iter().all(|touch| touch.at.distance(at) > gap) {
            touches.push(Touch {
                stroke: other,
                place,
                at,
            });
        }
        let n = dense[stroke].points.len();
        let is_near = |k: usize| {
            let near = grid.near((stroke, k), gap);
            near.iter().any(|&(o, _)| o == other)
        };
        let closed = dense[stroke].closed;
        for forward in [true, false] {
            let mut k = i;
            for _ in 0..n {
                is_cut[stroke][k] = true;
                let next = match (forward, closed) {
                    (true, true) => (k + 1) % n,
                    (false, true) => (k + n - 1) % n,
                    (true, false) if k + 1 < n => k + 1,
                    (false, false) if k > 0 => k - 1,
                    _ => break,
                };
                if !is_near(next) {
                    break;
                }
                k = next;
            }
        }
    }
    (is_cut, touches)
}

/// The place on a stroke where another touches or crosses it, near points of both.
fn meeting(cut: &Dense, i: usize, through: &Dense, j: usize, gap: f64) -> ((usize, f64), DVec2) {
    if cut.to_end(i) <= gap {
        let is_start = cut.along[i] <= gap;
        let end = if is_start { 0 } else { cut.points.len() - 1 };
        return through.nearest(j, cut.points[end]);
    }
    let mut found = through.nearest(j, cut.points[i]);
    // Each nearest to the other: where lines cross at an angle, they come together fast.
    for _ in 0..ROUNDS {
        let (_, on_cut) = cut.nearest(i, found.1);
        found = through.nearest(j, on_cut);
    }
    found
}

/// How often the nearest points of two strokes are looked for in turn.
const ROUNDS: usize = 60;
