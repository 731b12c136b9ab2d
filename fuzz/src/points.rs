//! Points whose coordinates like to be equal, collinear, cocircular or a few ulps apart.

use std::fmt;

use arbitrary::{Arbitrary, Result, Unstructured};
use curvecrust::DVec2;

/// The most points: an error of an algorithm shows in few.
const MOST: usize = 120;

/// Points on which exact decisions, ties and scales matter; some may be equal, or no number.
#[derive(Clone)]
pub struct NearlyDegenerate(pub Vec<DVec2>);

impl fmt::Debug for NearlyDegenerate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "vec![")?;
        for DVec2 { x, y } in &self.0 {
            writeln!(f, "    DVec2::new({}, {}),", shown(*x), shown(*y))?;
        }
        write!(f, "]")
    }
}

/// A number as Rust has it.
fn shown(x: f64) -> String {
    if x.is_finite() {
        format!("{x:?}")
    } else {
        format!("f64::from_bits({:#x})", x.to_bits())
    }
}

impl<'a> Arbitrary<'a> for NearlyDegenerate {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut points: Vec<DVec2> = Vec::new();
        while !u.is_empty() && points.len() < MOST {
            add(u, &mut points)?;
        }
        points.truncate(MOST);
        place(u, &mut points)?;
        Ok(Self(points))
    }
}

/// Adds a point or a few that have something in common, with each other or with those before.
fn add(u: &mut Unstructured<'_>, points: &mut Vec<DVec2>) -> Result<()> {
    match u.int_in_range(0..=9)? {
        // On a small grid.
        0 | 1 => points.push(small(u)?),
        // Anywhere.
        2 => points.push(DVec2::new(dyadic(u)?, dyadic(u)?)),
        3 => points.push(DVec2::new(f64::arbitrary(u)?, small(u)?.x)),
        // An earlier one, or a few ulps from it.
        4 => {
            let p = earlier(u, points)?;
            points.push(DVec2::new(nudged(u, p.x)?, nudged(u, p.y)?));
        }
        // The coordinates of two earlier ones, or what lies between them.
        5 => {
            let (p, q) = (earlier(u, points)?, earlier(u, points)?);
            points.push(match u.int_in_range(0..=3)? {
                0 => DVec2::new(p.x, q.y),
                1 => p.midpoint(q),
                2 => 2.0 * q - p,
                _ => p + (q - p).perp(),
            });
        }
        // A row.
        6 => {
            let (from, step) = (earlier(u, points)?, small(u)?);
            let count = u.int_in_range(2..=20)?;
            points.extend((0..count).map(|i| from + f64::from(i) * step));
        }
        // On a circle, exactly.
        7 => {
            let centre = earlier(u, points)?;
            let scale = 2f64.powi(u.int_in_range(-4..=4)?);
            let [(a, b), (c, d)] = [(63.0, 16.0), (56.0, 33.0)];
            let all = [(65.0, 0.0), (a, b), (c, d), (39.0, 52.0), (25.0, 60.0)];
            for _ in 0..u.int_in_range(3..=12)? {
                let (x, y) = *u.choose(&all)?;
                let p = if u.arbitrary()? { (x, y) } else { (y, -x) };
                let p = DVec2::from(p) * if u.arbitrary()? { scale } else { -scale };
                points.push(centre + p);
            }
        }
        // On a circle but for rounding, or on two that almost coincide.
        8 => {
            let (count, centre) = (u.int_in_range(3..=24)?, earlier(u, points)?);
            let radius = dyadic(u)?;
            let other = 1.0 + f64::from(u.int_in_range(-4..=4i32)?) * 1e-12;
            points.extend((0..count).map(|i| {
                let angle = f64::from(i) * std::f64::consts::TAU / f64::from(count);
                let radius = if i % 2 == 0 { radius } else { radius * other };
                centre + radius * DVec2::from_angle(angle)
            }));
        }
        // A cluster around an earlier one.
        _ => {
            let centre = earlier(u, points)?;
            let size = 2f64.powi(u.int_in_range(-60..=-20)?);
            for _ in 0..u.int_in_range(2..=8)? {
                points.push(centre + small(u)? * size);
            }
        }
    }
    Ok(())
}

/// Scales and shifts all points, for the most part by nothing.
fn place(u: &mut Unstructured<'_>, points: &mut [DVec2]) -> Result<()> {
    let (scale, shift) = match u.int_in_range(0..=15)? {
        0 => (2f64.powi(-140), 0.0),
        1 => (2f64.powi(190), 0.0),
        2 => (1.0, 1e15),
        3 => (1e-300, 0.0),
        4 => (1e300, 0.0),
        5 => (1e-12, 1.0),
        6 => (0.1, 0.0),
        _ => return Ok(()),
    };
    for p in points {
        *p = *p * scale + shift;
    }
    Ok(())
}

fn small(u: &mut Unstructured<'_>) -> Result<DVec2> {
    let byte = u8::arbitrary(u)?;
    let digit = |bits: u8| f64::from(bits & 15) - 8.0;
    Ok(DVec2::new(digit(byte), digit(byte >> 4)))
}

/// Few digits, over many powers of two.
fn dyadic(u: &mut Unstructured<'_>) -> Result<f64> {
    let digits = f64::from(i16::arbitrary(u)?);
    let exponent = if u.ratio(1, 8)? {
        u.int_in_range(-60..=60)?
    } else {
        u.int_in_range(-12..=0)?
    };
    Ok(digits * 2f64.powi(exponent))
}

fn earlier(u: &mut Unstructured<'_>, points: &[DVec2]) -> Result<DVec2> {
    if points.is_empty() {
        return small(u);
    }
    Ok(*u.choose(points)?)
}

fn nudged(u: &mut Unstructured<'_>, x: f64) -> Result<f64> {
    Ok(match u.int_in_range(-3..=3)? {
        -1 => x.next_down(),
        1 => x.next_up(),
        // Also an ulp of 1 away.
        ulps @ (-2 | 2) => x + f64::from(ulps) * f64::EPSILON,
        _ => x,
    })
}
