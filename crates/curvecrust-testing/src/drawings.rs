//! Drawings as people make them, of any number of cubics: what is ordinary and repeats itself, on
//! which no cost may grow faster than the drawing.

use std::f64::consts::TAU;
use std::fmt::Write;

use curvecrust_curve::{BezierPath, CubicBezier, Curve};
use curvecrust_geometry::DVec2;

/// A drawing of about the size that is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Drawing {
    /// What it is.
    pub name: &'static str,
    /// A drawing of about this many cubics.
    pub curve: fn(usize) -> Curve,
}

/// What the others are compared with: one smooth closed curve.
pub const ONE_CURVE: Drawing = Drawing {
    name: "one curve",
    curve: |n| gear(n, 5, 0.2),
};

/// Drawings that repeat something.
pub const DRAWINGS: &[Drawing] = &[
    drawing("wave", wave),
    drawing("wave, uneven", uneven_wave),
    drawing("wave on an arc", wave_on_an_arc),
    drawing("comb", comb),
    drawing("gear", |n| gear(n, n.div_ceil(4), 8.0 / n as f64)),
    drawing("spiral", spiral),
    drawing("circles in a row", circles),
    drawing("lines of text", text),
];

const fn drawing(name: &'static str, curve: fn(usize) -> Curve) -> Drawing {
    Drawing { name, curve }
}

/// Arcs of parabolas along the x axis, in turn above and below it.
#[must_use]
pub fn wave(n: usize) -> Curve {
    from_path(
        "M 0 0",
        (0..n).map(|i| ["q .5 1 1 0", "q .5 -1 1 0"][i % 2].to_owned()),
    )
}

/// The same with crests of which no three are on one line.
fn uneven_wave(n: usize) -> Curve {
    let width = |i: usize| 1.0 + 0.3 * (i as f64 * 0.618_033_988_749_894_9).fract();
    from_path(
        "M 0 0",
        (0..n).map(|i| {
            let w = width(i);
            let h = if i % 2 == 0 { w } else { -w };
            format!("q {} {h} {w} 0", w / 2.0)
        }),
    )
}

/// A wave around three quarters of a circle: rays between its crests fan out, or meet.
fn wave_on_an_arc(n: usize) -> Curve {
    let (waves, depth) = (n.div_ceil(4) as f64, 8.0 / n as f64);
    let angle = |i: usize| 0.75 * TAU * i as f64 / n as f64;
    let knots = (0..=n).map(|i| Wavy { waves, depth }.at(angle(i)));
    curve(vec![through(
        &knots.collect::<Vec<_>>(),
        0.75 * TAU / n as f64,
        false,
    )])
}

/// Teeth four times as long as they are wide, with round ends.
fn comb(n: usize) -> Curve {
    let tooth = ["v 4 a .5 .5 0 0 0 1 0", "v -4 a .5 .5 0 0 1 1 0"];
    from_path(
        "M 0 0",
        (0..n.div_ceil(27)).map(|i| tooth[i % 2].to_owned()),
    )
}

/// A circle of radius 1 with waves of its radius, by `n` cubics.
fn gear(n: usize, waves: usize, depth: f64) -> Curve {
    let n = n.max(8);
    let waves = waves as f64;
    let knots = (0..n).map(|i| Wavy { waves, depth }.at(TAU * i as f64 / n as f64));
    curve(vec![through(
        &knots.collect::<Vec<_>>(),
        TAU / n as f64,
        true,
    )])
}

/// An Archimedean spiral, its arms 6.3 apart and its cubics about 8 long.
fn spiral(n: usize) -> Curve {
    const LENGTH: f64 = 8.0;
    let knot = |i: usize| {
        // The angle is also the radius, so that half of its square is about the length.
        let angle = (4.0 * TAU * TAU + 2.0 * LENGTH * i as f64).sqrt();
        let direction = DVec2::from_angle(angle);
        let by_angle = direction + angle * direction.perp();
        [angle * direction, by_angle * (LENGTH / angle)]
    };
    curve(vec![through(
        &(0..=n).map(knot).collect::<Vec<_>>(),
        1.0,
        false,
    )])
}

/// Circles of radius 1, their centres 3 apart.
fn circles(n: usize) -> Curve {
    let ring = |i: usize| format!("M {} 0 a 1 1 0 0 0 2 0 a 1 1 0 0 0 -2 0 Z", 3 * i);
    from_path("", (0..n.div_ceil(52)).map(ring))
}

/// Hooks, bars, rings inside rings and curls, in lines of 60.
fn text(n: usize) -> Curve {
    const GLYPHS: [&str; 4] = [
        "m 0 6 v -3 a 2 2 0 0 1 4 0 v 3",
        "m 1 1 v 5 a .5 .5 0 0 0 1 0 v -5 a .5 .5 0 0 0 -1 0 Z",
        "m 0 3 a 2 3 0 0 0 4 0 a 2 3 0 0 0 -4 0 Z m .8 0 a 1.2 2 0 0 1 2.4 0 a 1.2 2 0 0 1 -2.4 0 Z",
        "m 4 1 a 2 1 0 0 0 -2 -1 a 1.5 1.5 0 0 0 0 3 a 1.5 1.5 0 0 1 0 3 a 2 1 0 0 1 -2 -1",
    ];
    let glyph = |i: usize| {
        let kind = (i + i / 60 * 7) * 5 % 7 % 4;
        format!("M {} {} {}", i % 60 * 5, i / 60 * 10, GLYPHS[kind])
    };
    from_path("", (0..n.div_ceil(66)).map(glyph))
}

/// A circle of radius 1 whose radius oscillates.
struct Wavy {
    waves: f64,
    depth: f64,
}

impl Wavy {
    /// The point at an angle, and the derivative by it.
    fn at(&self, angle: f64) -> [DVec2; 2] {
        let (sine, cosine) = (self.waves * angle).sin_cos();
        let direction = DVec2::from_angle(angle);
        let (radius, slope) = (1.0 + self.depth * cosine, -self.depth * self.waves * sine);
        [
            radius * direction,
            slope * direction + radius * direction.perp(),
        ]
    }
}

/// The cubics through points with derivatives, by a parameter that goes in equal steps.
fn through(knots: &[[DVec2; 2]], step: f64, closed: bool) -> BezierPath {
    let piece = |([p, dp], [q, dq]): (&[DVec2; 2], &[DVec2; 2])| {
        CubicBezier::new([*p, p + dp * (step / 3.0), q - dq * (step / 3.0), *q])
    };
    let count = if closed { knots.len() } else { knots.len() - 1 };
    let next = knots.iter().cycle().skip(1);
    BezierPath::new(
        knots.iter().zip(next).take(count).map(piece).collect(),
        closed,
    )
}

fn curve(components: Vec<BezierPath>) -> Curve {
    Curve::new(components).unwrap()
}

fn from_path(start: &str, pieces: impl Iterator<Item = String>) -> Curve {
    let mut data = start.to_owned();
    for piece in pieces {
        write!(data, " {piece}").unwrap();
    }
    Curve::from_path_data(&data).unwrap()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_are_of_about_the_size_asked_for() {
        for drawing in DRAWINGS.iter().chain([&ONE_CURVE]) {
            for n in [50, 1_000] {
                let curve = (drawing.curve)(n);
                let cubics = curve.components().iter().map(|c| c.segments().len());
                let cubics = cubics.sum::<usize>();
                assert!(
                    2 * cubics > n && cubics < 2 * n,
                    "{}: {cubics}",
                    drawing.name
                );
            }
        }
    }
}
