//! Dense points of closed splines, with exact normals, and lfs by the balls that touch there.

use curvecrust::DVec2;
use curvecrust::geometry::Component;
use curvecrust::sampling::Bound;

/// Dense points of closed splines.
#[derive(Clone, Debug)]
pub struct Dense {
    points: Vec<DVec2>,
    components: Vec<Component>,
    lfs: Vec<f64>,
    per_segment: usize,
}

/// Consecutive dense points of a component, which goes round.
pub(super) struct Stretch<'a> {
    pub(super) component: &'a Component,
    /// The first one.
    pub(super) first: usize,
    /// How many steps to the last one.
    pub(super) length: usize,
}

impl Dense {
    /// Points at equal steps of the parameter of uniform cubic B-splines, the same number on
    /// each segment.
    ///
    /// At each point the smallest ball that touches the curve there and meets another dense point
    /// has its centre near the medial axis (Ma, Bae, Choi 2012, with the normals of the curve
    /// itself); lfs is the distance from the nearest centre.
    ///
    /// None if a curve has a cusp.
    #[must_use]
    pub fn new(splines: &[Vec<DVec2>], per_segment: usize) -> Option<Self> {
        let (mut points, mut normals, mut components) = (Vec::new(), Vec::new(), Vec::new());
        for control in splines {
            let first = points.len();
            for i in 0..control.len() * per_segment {
                let t = (i % per_segment) as f64 / per_segment as f64;
                let [place, velocity] = on_spline(control, i / per_segment, t);
                points.push(place);
                normals.push(velocity.try_normalize()?.perp());
            }
            let range = first..points.len();
            let closed = true;
            components.push(Component { range, closed });
        }
        let centres = centres(&points, &normals);
        let lfs = points.iter().map(|p| nearest(*p, &centres)).collect();
        Some(Self {
            points,
            components,
            lfs,
            per_segment,
        })
    }

    /// The points, spline by spline.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Which points belong to each spline.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// Whether dense points are much nearer to each other than to the medial axis.
    pub(super) fn is_fine(&self) -> bool {
        let limit = 4.0 / self.per_segment as f64;
        let mut gaps = self.components.iter().flat_map(Component::pairs);
        gaps.all(|(i, j)| {
            let gap = self.points[i].distance(self.points[j]);
            gap <= limit * self.lfs[i].min(self.lfs[j])
        })
    }

    /// The segment of a dense point, and the parameter in it.
    pub(super) fn parameter(&self, component: usize, point: usize) -> (usize, f64) {
        let i = point - self.components[component].range.start;
        let at = (i % self.per_segment) as f64 / self.per_segment as f64;
        (i / self.per_segment, at)
    }

    /// The smallest bound of a kind that samples at dense points satisfy, at dense points.
    #[must_use]
    pub fn attained(&self, samples: &[Vec<usize>], kind: Bound) -> f64 {
        let mut most = 0.0_f64;
        for (component, placed) in self.components.iter().zip(samples) {
            let next = placed.iter().skip(1).chain(placed.first());
            for (&first, &to) in placed.iter().zip(next) {
                let stretch = Stretch {
                    component,
                    first,
                    length: component.steps(first, to),
                };
                most = most.max(self.attained_on(&stretch, kind));
            }
        }
        most
    }

    /// Whether the ends of a stretch suffice for its points.
    pub(super) fn holds(&self, stretch: &Stretch<'_>, bound: Bound) -> bool {
        self.attained_on(stretch, bound) < bound.value()
    }

    fn attained_on(&self, stretch: &Stretch<'_>, kind: Bound) -> f64 {
        let Stretch {
            component,
            first,
            length,
        } = stretch;
        let at = |i: usize| component.after(*first, i);
        let (from, to) = (self.points[at(0)], self.points[at(*length)]);
        let inside = (0..=*length).map(at).map(|i| {
            let p = self.points[i];
            (
                p.distance_squared(from).min(p.distance_squared(to)).sqrt(),
                self.lfs[i],
            )
        });
        match kind {
            Bound::Epsilon(_) => inside.map(|(far, lfs)| far / lfs).fold(0.0, f64::max),
            Bound::Rho(_) => {
                let most = inside.fold((0.0, f64::INFINITY), |(far, reach): (f64, f64), (d, l)| {
                    (far.max(d), reach.min(l))
                });
                most.0 / most.1
            }
        }
    }
}

/// A point of a closed uniform cubic B-spline and its derivative.
fn on_spline(control: &[DVec2], segment: usize, t: f64) -> [DVec2; 2] {
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| control[(segment + i) % control.len()]);
    let (s, u, v) = (1.0 - t, t * t, t * t * t);
    let place =
        a * (s * s * s) + b * (3.0 * v - 6.0 * u + 4.0) + c * (1.0 + 3.0 * (t + u - v)) + d * v;
    let velocity = b * (3.0 * u - 4.0 * t) + c * (1.0 + 2.0 * t - 3.0 * u) + d * u - a * (s * s);
    [place / 6.0, velocity / 2.0]
}

/// The centres of the smallest balls that touch at each point, on both sides.
fn centres(points: &[DVec2], normals: &[DVec2]) -> Vec<DVec2> {
    let mut centres = Vec::new();
    for (p, normal) in points.iter().zip(normals) {
        let (mut left, mut right) = (0.0_f64, 0.0_f64);
        for q in points {
            let to = *q - *p;
            let square = to.length_squared();
            if square > 0.0 {
                let bend = 2.0 * normal.dot(to) / square;
                left = left.max(bend);
                right = right.min(bend);
            }
        }
        let both = [left, right].into_iter().filter(|bend| *bend != 0.0);
        centres.extend(both.map(|bend| *p + *normal / bend));
    }
    centres
}

fn nearest(p: DVec2, centres: &[DVec2]) -> f64 {
    let squares = centres.iter().map(|c| c.distance_squared(p));
    squares.fold(f64::INFINITY, f64::min).sqrt()
}
