//! Chains of Béziers whose joins are smooth, and of which a good part is simple.

use std::fmt::{self, Write};

use arbitrary::{Arbitrary, Result, Unstructured};
use curvecrust::DVec2;

/// SVG path data.
#[derive(Clone)]
pub struct Chains(pub String);

impl fmt::Debug for Chains {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.0)
    }
}

impl<'a> Arbitrary<'a> for Chains {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut d = String::new();
        let scale = *u.choose(&[1.0, 1.0, 1.0, 1.0, 0.1, 1e-9, 1e9, 1e-40, 1e55])?;
        for i in 0..u.int_in_range(1..=3)? {
            let centre = DVec2::new(f64::from(i) * 30.0, f64::from(i8::arbitrary(u)?) / 16.0);
            component(u, &mut d, centre, scale)?;
        }
        Ok(Self(d))
    }
}

/// A star-shaped ring, an open wave, or anything.
fn component(u: &mut Unstructured<'_>, d: &mut String, centre: DVec2, scale: f64) -> Result<()> {
    let count = u.int_in_range(2..=7)?;
    let kind = u.int_in_range(0..=4)?;
    let mut knots = Vec::new();
    for i in 0..count {
        let share = f64::from(i) / f64::from(count);
        let (place, direction) = match kind {
            0 | 1 => {
                let out = DVec2::from_angle(std::f64::consts::TAU * share);
                (centre + (2.0 + length(u)?) * out, out.perp())
            }
            2 => {
                let up = length(u)? - 2.0;
                (centre + DVec2::new(3.0 * f64::from(i), up), DVec2::X)
            }
            _ => {
                let place = centre + 4.0 * DVec2::new(length(u)?, length(u)?);
                (place, DVec2::from_angle(length(u)? * 6.0))
            }
        };
        let tilt = DVec2::from_angle(f64::from(u.int_in_range(-8..=8i32)?) * 0.06);
        let arms = [length(u)?, length(u)?];
        knots.push((place * scale, tilt.rotate(direction) * scale, arms));
    }
    let (start, ..) = knots[0];
    // Writing to a string cannot fail.
    let _ = write!(d, "M {} {} ", start.x, start.y);
    let closed = kind != 2 && u.ratio(7, 8)?;
    let next = knots.iter().cycle().skip(1);
    for ((p, u, a), (q, v, b)) in knots
        .iter()
        .zip(next)
        .take(knots.len() - usize::from(!closed))
    {
        let (first, second) = (p + u * a[0], q - v * b[1]);
        let _ = write!(d, "C {} {} {} {} ", first.x, first.y, second.x, second.y);
        let _ = write!(d, "{} {} ", q.x, q.y);
    }
    if closed {
        d.push_str("Z ");
    }
    Ok(())
}

/// Between 0 and 4, for the most part not near 0.
fn length(u: &mut Unstructured<'_>) -> Result<f64> {
    let byte = u8::arbitrary(u)?;
    Ok(match byte {
        0 => 0.0,
        1 => 1e-12,
        _ => f64::from(byte) / 64.0,
    })
}
