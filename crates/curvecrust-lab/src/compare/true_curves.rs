//! The true curves of a cell: dense points in order, and what outputs are measured against.

use super::fourier;
use crate::repository::root;
use anyhow::Context;
use curvecrust::DVec2;
use curvecrust::curve::Curve;
use curvecrust::evaluate::Reference;
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use std::f64::consts::{PI, TAU};
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

/// Curves as dense points, one part after the other.
pub(super) struct TrueCurves {
    pub(super) parts: Vec<Part>,
    pub(super) reference: Reference,
}

/// A part of the curves.
pub(super) struct Part {
    pub(super) points: Vec<DVec2>,
    pub(super) closed: bool,
    /// The local feature size at each point, if it was measured.
    pub(super) lfs: Vec<f64>,
}

/// A curve that takes part by its name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Named {
    /// Of `fixtures/curves`.
    Fixture(String),
    /// Of the paper's authors.
    Authors(String),
    /// A random closed curve.
    Random { terms: u32, seed: u64 },
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fixture(name) => f.write_str(name),
            Self::Authors(name) => write!(f, "paper-{name}"),
            Self::Random { seed, .. } => write!(f, "random-{seed}"),
        }
    }
}

/// Where the authors' curves are, if they were fetched.
pub(super) fn authors_curves() -> PathBuf {
    root().join("fixtures/paper/curves")
}

/// The dense points are this fraction of the local feature size apart.
const GAP_TO_LFS: f64 = 0.02;
/// How far chords may be from the curve that they stand for, in extents.
const FLATNESS: f64 = 2e-4;

impl TrueCurves {
    /// A curve with its local feature size.
    pub(super) fn named(name: &Named) -> anyhow::Result<Self> {
        let curve = match name {
            Named::Fixture(name) => drawn(&root().join("fixtures/curves").join(name))?,
            Named::Authors(name) => drawn(&authors_curves().join(name))?,
            Named::Random { terms, seed } => fourier::curve(*terms, *seed)?,
        };
        let options = MeasureOptions {
            discretisation: Discretisation::Adaptive {
                gap_to_lfs: GAP_TO_LFS,
            },
            ..MeasureOptions::default()
        };
        let measured = measure_with(&curve, &options)?;
        Ok(Self {
            reference: Reference::of_curve(&curve, FLATNESS * curve.extent()),
            parts: parts(&measured),
        })
    }

    /// Polygons and open polylines, and whether each is closed.
    pub(super) fn polygonal(parts: Vec<(Vec<DVec2>, bool)>) -> Self {
        let part = |(points, closed)| Part {
            points,
            closed,
            lfs: Vec::new(),
        };
        let parts: Vec<Part> = parts.into_iter().map(part).collect();
        let sides = parts.iter().flat_map(|part| {
            let next = part.points.iter().cycle().skip(1);
            let count = part.points.len() - usize::from(!part.closed);
            part.points.iter().zip(next).take(count)
        });
        Self {
            reference: Reference::of_segments(sides.map(|(&a, &b)| Segment::new(a, b))),
            parts,
        }
    }

    /// Two straight legs that meet at the origin in an angle, and the arc of radius 10 that touches
    /// both. The first point is the apex.
    pub(super) fn teardrop(apex_degrees: f64) -> Self {
        let half = apex_degrees.to_radians() / 2.0;
        let radius = 10.0;
        let leg = radius / half.tan();
        let centre = DVec2::new(radius / half.sin(), 0.0);
        let touch = DVec2::from_angle(half) * leg;
        let mut points: Vec<DVec2> = straight(DVec2::ZERO, touch, 0.25).collect();
        let from = PI / 2.0 + half;
        points.extend(arc(centre, radius, from, -from, 200));
        let back = DVec2::new(touch.x, -touch.y);
        points.extend(straight(back, DVec2::ZERO, 0.25));
        Self::polygonal(vec![(points, true)])
    }

    /// Two stadiums of radius 8 and core length 24, one above the other at a distance.
    pub(super) fn racetracks(gap: f64) -> Self {
        let (radius, half) = (8.0, 12.0);
        let track = |y: f64| {
            let right = DVec2::new(half, y);
            let left = DVec2::new(-half, y);
            let down = DVec2::new(0.0, -radius);
            let mut points: Vec<DVec2> = straight(left + down, right + down, 0.25).collect();
            points.extend(arc(right, radius, -PI / 2.0, PI / 2.0, 100));
            points.extend(straight(right - down, left - down, 0.25));
            points.extend(arc(left, radius, PI / 2.0, 3.0 * PI / 2.0, 100));
            (points, true)
        };
        let y = radius + gap / 2.0;
        Self::polygonal(vec![track(-y), track(y)])
    }

    /// Circles about the origin, the inner one of radius 10, at a distance.
    pub(super) fn circles(gap: f64) -> Self {
        let circle = |radius| (arc(DVec2::ZERO, radius, 0.0, TAU, 400), true);
        Self::polygonal(vec![circle(10.0), circle(10.0 + gap)])
    }

    /// Two periods of a sine, 2.5 times as high as wide; the least radius of curvature is 1.
    pub(super) fn sine() -> Self {
        let at = |i: i32| {
            let phase = 2.0 * TAU * f64::from(i) / 1000.0;
            2.5 * DVec2::new(phase, 2.5 * phase.sin())
        };
        Self::polygonal(vec![((0..=1000).map(at).collect(), false)])
    }

    /// Three turns of an Archimedean spiral with strands 2 apart: half of that is the least local
    /// feature size. It starts with a radius of 2.
    pub(super) fn spiral() -> Self {
        let at = |i: i32| {
            let angle = 3.0 * TAU * f64::from(i) / 1500.0;
            DVec2::from_angle(angle) * (2.0 + angle / PI)
        };
        Self::polygonal(vec![((0..=1500).map(at).collect(), false)])
    }

    /// Five half circles of radius 3 like tiles of a roof: ends point at the middle of the next row
    /// or at nothing, not at each other. They are a little more than 2 apart: half of that is the
    /// least local feature size.
    pub(super) fn arcs() -> Self {
        let tile = |(x, y)| {
            let centre = DVec2::new(x, y);
            let mut points = arc(centre, 3.0, 0.0, PI, 300);
            points.push(centre - DVec2::new(3.0, 0.0));
            (points, false)
        };
        Self::polygonal(TILES.map(tile).to_vec())
    }
}

/// The centres of the half circles of [`TrueCurves::arcs`].
pub(crate) const TILES: [(f64, f64); 5] = [
    (0.0, 0.0),
    (8.0, 0.7),
    (-4.0, -5.0),
    (4.0, -5.7),
    (12.0, -5.0),
];

/// The curve of a drawing, whose name is given without its ending.
fn drawn(path: &Path) -> anyhow::Result<Curve> {
    let path = path.with_extension("svg");
    let text =
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    Curve::from_svg(&text).with_context(|| path.display().to_string())
}

fn parts(measured: &MeasuredCurve) -> Vec<Part> {
    let dense = measured.dense();
    let of = |component: &curvecrust::geometry::Component| Part {
        points: dense.points()[component.range.clone()].to_vec(),
        closed: component.closed,
        lfs: measured.lfs().values()[component.range.clone()].to_vec(),
    };
    dense.components().iter().map(of).collect()
}

/// Points from `a` on, without `b`.
pub(super) fn straight(a: DVec2, b: DVec2, step: f64) -> impl Iterator<Item = DVec2> {
    let steps = (a.distance(b) / step).ceil().max(1.0);
    let count = std::iter::successors(Some(0.0), |k| Some(k + 1.0));
    count
        .take_while(move |k| *k < steps)
        .map(move |k| a.lerp(b, k / steps))
}

/// Points of an arc, without its end.
pub(crate) fn arc(centre: DVec2, radius: f64, from: f64, to: f64, steps: u32) -> Vec<DVec2> {
    let at = |i| from + (to - from) * f64::from(i) / f64::from(steps);
    (0..steps)
        .map(|i| centre + radius * DVec2::from_angle(at(i)))
        .collect()
}
