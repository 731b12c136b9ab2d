//! Curves whose points are scattered: dense polylines, open or closed.

mod things;

pub(super) use things::THINGS;

use std::f64::consts::{PI, TAU};

use crate::figure::bounds;
use curvecrust::curve::DenseCurve;
use curvecrust::geometry::{Component, DVec2, Random};
use curvecrust_testing::fixtures;
use things::outline;

/// Points in order, and whether the curve is closed.
#[derive(Clone)]
pub(super) struct Truth {
    pub(super) points: Vec<DVec2>,
    pub(super) closed: bool,
}

pub(super) const NAMES: [&str; 11] = [
    "circle", "ellipse", "fourierA", "fourierB", "rings", "sine", "spiral", "star", "poly",
    "bunny", "mixed",
];
pub(super) fn closed(points: Vec<DVec2>) -> Truth {
    Truth {
        points,
        closed: true,
    }
}

pub(super) fn along(n: u32, from: f64, to: f64, at: impl Fn(f64) -> DVec2) -> Vec<DVec2> {
    (0..n)
        .map(|i| at(from + (to - from) * f64::from(i) / f64::from(n)))
        .collect()
}

fn circle(radius: f64, centre: DVec2) -> Truth {
    closed(along(4000, 0.0, TAU, |t| {
        centre + radius * DVec2::from_angle(t)
    }))
}

fn open(from: f64, to: f64, at: impl Fn(f64) -> DVec2) -> Truth {
    Truth {
        points: along(6001, from, to + (to - from) / 6000.0, at),
        closed: false,
    }
}

fn star(arms: u32, inner: f64) -> Truth {
    let corner = |i: u32| {
        let radius = if i.is_multiple_of(2) {
            1.2
        } else {
            1.2 * inner
        };
        radius * DVec2::from_angle(f64::from(i) * PI / f64::from(arms) + 0.3)
    };
    closed((0..2 * arms).map(corner).collect())
}

fn rectangle(width: f64, height: f64, angle: f64, at: DVec2) -> Truth {
    let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)];
    let turn = DVec2::from_angle(angle);
    closed(corners.map(|c| turn.rotate(DVec2::from(c)) + at).to_vec())
}

fn polygon(corners: &[(f64, f64)]) -> Truth {
    closed(corners.iter().map(|&c| DVec2::from(c)).collect())
}

/// A random trigonometric curve that neither crosses nor bends too much.
fn fourier(seed: u64, terms: i32) -> Truth {
    let mut random = Random::new(seed);
    loop {
        let waves: Vec<(f64, DVec2, DVec2)> = (2..=terms)
            .map(|k| {
                let size = 0.4 / f64::from(k).powf(1.3);
                let mut vector = || size * DVec2::new(random.normal(), random.normal());
                (f64::from(k), vector(), vector())
            })
            .collect();
        let at = |t: f64| {
            let turned = waves.iter().map(|&(k, a, b)| {
                DVec2::from_angle(k * t).rotate(a) + DVec2::from_angle(-k * t).rotate(b)
            });
            DVec2::from_angle(t) + turned.sum::<DVec2>()
        };
        let points = along(8000, 0.0, TAU, at);
        let (low, high) = bounds(&points);
        let scale = 2.0 / (high - low).max_element();
        let points: Vec<DVec2> = points.iter().map(|&p| p * scale).collect();
        let bend = (0..points.len()).map(|i| {
            let at = |s: usize| points[(i + s) % points.len()];
            let [a, b] = [at(40) - at(0), at(80) - at(40)];
            a.angle_to(b).abs() / a.length()
        });
        let truth = closed(points.clone());
        let apart = separation(std::slice::from_ref(&truth));
        if bend.fold(0.0, f64::max) < 30.0 && (0.18..0.9).contains(&apart) {
            return truth;
        }
    }
}

/// A drawing of the fixtures, its larger extent 2.
fn drawing(name: &str) -> anyhow::Result<Vec<Truth>> {
    let dense = DenseCurve::per_segment(&fixtures::curve(name), 100)?;
    let (low, high) = bounds(dense.points());
    let scale = 2.0 / (high - low).max_element();
    let component = |c: &Component| Truth {
        points: dense.points()[c.range.clone()]
            .iter()
            .map(|&p| (p - low) * scale)
            .collect(),
        closed: c.closed,
    };
    Ok(dense.components().iter().map(component).collect())
}

/// The curves of a name; others of the same kind if `held` out.
pub(super) fn curves(name: &str, held: bool) -> anyhow::Result<Vec<Truth>> {
    let h = f64::from(u8::from(held));
    Ok(match name {
        "circle" => vec![circle(1.0, DVec2::ZERO)],
        "ellipse" => vec![closed(along(8000, 0.0, TAU, |t| {
            DVec2::new(1.5 * t.cos(), 0.5 * t.sin())
        }))],
        "fourierA" => vec![fourier(100 + u64::from(held), 5)],
        "fourierB" => vec![fourier(200 + u64::from(held), 7)],
        "rings" => {
            let (radius, x) = if held { (0.45, 0.05) } else { (0.5, 0.0) };
            vec![circle(1.0, DVec2::ZERO), circle(radius, DVec2::new(x, 0.0))]
        }
        "sine" => {
            let (periods, height) = if held { (1.5, 0.7) } else { (2.0, 0.5) };
            vec![open(0.0, TAU * periods, |x| {
                DVec2::new(x / PI, height * x.sin())
            })]
        }
        "spiral" => {
            let turns = if held { 2.2 } else { 2.5 };
            let scale = 1.3 / (TAU * turns);
            vec![open(0.7 * PI, TAU * turns, |t| {
                t * DVec2::from_angle(t) * scale
            })]
        }
        "star" => vec![if held { star(6, 0.5) } else { star(5, 0.45) }],
        "poly" if held => vec![rectangle(2.0, 1.2, 0.35, DVec2::ZERO)],
        "poly" => vec![polygon(&[
            (0.0, 0.0),
            (2.0, 0.0),
            (2.0, 0.8),
            (0.8, 0.8),
            (0.8, 2.0),
            (0.0, 2.0),
        ])],
        "mixed" => vec![
            circle(0.5, DVec2::new(-1.0, 0.2)),
            open(0.0, TAU, |x| {
                DVec2::new(x / PI * 0.8 + 0.2, 0.3 * x.sin() - 0.8)
            }),
            rectangle(0.9, 0.7, 0.3 + 0.4 * h, DVec2::new(0.3, 0.1)),
        ],
        "square" => vec![rectangle(1.6, 1.6, 0.2, DVec2::ZERO)],
        name => match outline(name) {
            Some(outline) => vec![outline],
            None => drawing(name)?,
        },
    })
}

/// The polyline with its first point again, if it is closed, and the lengths up to each point.
pub(super) fn measured(truth: &Truth) -> (Vec<DVec2>, Vec<f64>) {
    let mut points = truth.points.clone();
    if truth.closed {
        points.push(points[0]);
    }
    let mut lengths = vec![0.0];
    for pair in points.windows(2) {
        lengths.push(lengths[lengths.len() - 1] + pair[0].distance(pair[1]));
    }
    (points, lengths)
}

pub(super) fn length(truth: &Truth) -> f64 {
    measured(truth).1.last().copied().unwrap_or(0.0)
}

/// The place at a length along a measured polyline.
pub(super) fn place(points: &[DVec2], lengths: &[f64], at: f64) -> DVec2 {
    let i = lengths
        .partition_point(|&l| l <= at)
        .clamp(1, points.len() - 1);
    let gap = lengths[i] - lengths[i - 1];
    points[i - 1].lerp(
        points[i],
        ((at - lengths[i - 1]) / gap.max(1e-300)).clamp(0.0, 1.0),
    )
}

/// The least distance of two strands: places of two curves, or of one with at least four times as
/// much of the curve between them.
pub(super) fn separation(curves: &[Truth]) -> f64 {
    let mut all = Vec::new();
    for (k, truth) in curves.iter().enumerate() {
        let (points, lengths) = measured(truth);
        let whole = lengths[lengths.len() - 1];
        for i in 0..500 {
            let s = whole * f64::from(i) / 500.0;
            all.push((
                k,
                s,
                if truth.closed { whole } else { f64::INFINITY },
                place(&points, &lengths, s),
            ));
        }
    }
    let mut least = f64::INFINITY;
    for (k, s, whole, p) in all.iter().step_by(3) {
        for (l, t, _, q) in &all {
            let (d, a) = (p.distance(*q), (s - t).abs());
            let apart = if k == l {
                a.min(whole - a)
            } else {
                f64::INFINITY
            };
            if d > 1e-9 && apart >= 4.0 * d {
                least = least.min(d);
            }
        }
    }
    if least.is_finite() {
        return least;
    }
    let points: Vec<DVec2> = curves
        .iter()
        .flat_map(|t| t.points.iter().copied())
        .collect();
    let (low, high) = bounds(&points);
    (high - low).min_element()
}
