//! Random smooth closed curves: both coordinates are trigonometric polynomials of the parameter,
//! with normal coefficients that fall with the frequency.
//!
//! Curves that cross themselves, or come so near to it that most samples would be there, are drawn
//! again. The curve is the chain of cubics through points of the polynomial, with its tangents.

use anyhow::bail;
use curvecrust::DVec2;
use curvecrust::curve::{BezierPath, CubicBezier, Curve};
use curvecrust::geometry::{Random, Segment};
use std::f64::consts::TAU;

/// Cubics of a curve.
const PIECES: u32 = 128;
/// Coefficients of the frequency k have this power of 1 / k as their deviation.
const FALL: f64 = 1.5;
/// How near strands may be to each other, in extents.
const APART: f64 = 0.02;
/// So many are drawn before giving up.
const DRAWS: u32 = 10_000;

/// The first curve of a sequence of random ones that does not come too near to itself.
pub(super) fn curve(terms: u32, seed: u64) -> anyhow::Result<Curve> {
    let mut random = Random::new(seed);
    for _ in 0..DRAWS {
        let drawn = Polynomial::draw(terms, &mut random);
        if !drawn.comes_near_itself() {
            return Ok(Curve::new(vec![drawn.component()])?);
        }
    }
    bail!(
        "of {DRAWS} random curves with {terms} terms, each comes too near to itself: ask for \
        fewer terms"
    )
}

/// The coefficients of cosine and sine, from the frequency 1 on.
struct Polynomial(Vec<[DVec2; 2]>);

impl Polynomial {
    fn draw(terms: u32, random: &mut Random) -> Self {
        let mut normal = || DVec2::new(random.normal(), random.normal());
        let mut term = |k: u32| [(); 2].map(|()| normal() / f64::from(k).powf(FALL));
        Self((1..=terms).map(&mut term).collect())
    }

    /// The point and the derivative at a parameter, of which a turn is 2 pi.
    fn at(&self, t: f64) -> [DVec2; 2] {
        let mut at = [DVec2::ZERO; 2];
        for (k, [cosine, sine]) in (1..).map(f64::from).zip(&self.0) {
            let (s, c) = (k * t).sin_cos();
            at[0] += c * *cosine + s * *sine;
            at[1] += k * (c * *sine - s * *cosine);
        }
        at
    }

    fn component(&self) -> BezierPath {
        let step = TAU / f64::from(PIECES);
        let knot = |i: u32| self.at(f64::from(i % PIECES) * step);
        let piece = |i: u32| {
            let ([a, da], [b, db]) = (knot(i), knot(i + 1));
            CubicBezier::new([a, a + da * (step / 3.0), b - db * (step / 3.0), b])
        };
        BezierPath::new((0..PIECES).map(piece).collect(), true)
    }

    /// Whether two points are nearer than strands may be, though the way between them along the
    /// curve is more than a half circle's over that distance.
    fn comes_near_itself(&self) -> bool {
        let steps = 4 * PIECES as usize;
        let points: Vec<DVec2> = (0..steps)
            .map(|i| self.at(TAU * i as f64 / steps as f64)[0])
            .collect();
        let sides: Vec<Segment> = (0..steps)
            .map(|i| Segment::new(points[i], points[(i + 1) % steps]))
            .collect();
        let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let apart = APART * (high - low).max_element();
        let mut along = vec![0.0];
        for side in &sides {
            along.push(along[along.len() - 1] + side.length());
        }
        let whole = along[steps];
        points.iter().enumerate().any(|(i, &p)| {
            (i + 1..steps).any(|j| {
                let way = along[j] - along[i];
                way.min(whole - way) > 2.0 * apart && sides[j].distance(p) < apart
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_curves_are_smooth_and_stay_apart_from_themselves() {
        for seed in 1001..1017 {
            let polynomial = Polynomial::draw(7, &mut Random::new(seed));
            let near = polynomial.comes_near_itself();
            let curve = curve(7, seed).unwrap();
            assert_eq!(curve, super::curve(7, seed).unwrap());
            let [component] = curve.components() else {
                panic!("one component")
            };
            assert!(component.is_closed());
            assert_eq!(component.segments().len(), PIECES as usize);
            // The first that was drawn, unless that comes near itself.
            let start = component.segments()[0].start();
            assert_eq!(start == polynomial.at(0.0)[0], !near, "{seed}");
        }
    }

    #[test]
    fn an_eight_comes_near_itself_and_a_circle_does_not() {
        let circle = [DVec2::X, DVec2::Y];
        let eight = [[DVec2::ZERO, DVec2::X], [DVec2::ZERO, DVec2::Y]];
        assert!(!Polynomial(vec![circle]).comes_near_itself());
        assert!(Polynomial(eight.to_vec()).comes_near_itself());
    }
}
