//! Points as integers, and the algebra of triangles and pencils of discs on them.

use std::cmp::Ordering;

use curvecrust_geometry::{PointId, PointSet};
use num_bigint::{BigInt, Sign};

pub(crate) type Point = [BigInt; 2];

/// The points of a set, multiplied by 2^100.
pub(crate) struct Exact {
    points: Vec<Point>,
}

impl Exact {
    pub(crate) fn new(points: &PointSet) -> Self {
        let points = points.points().iter();
        Self {
            points: points.map(|p| [integer(p.x), integer(p.y)]).collect(),
        }
    }

    pub(crate) fn at(&self, id: PointId) -> &Point {
        &self.points[id.index()]
    }

    /// (p - from) . (q - from)
    pub(crate) fn dot(&self, from: PointId, p: PointId, q: PointId) -> BigInt {
        dot(
            &sub(self.at(p), self.at(from)),
            &sub(self.at(q), self.at(from)),
        )
    }

    pub(crate) fn distance_squared(&self, p: PointId, q: PointId) -> BigInt {
        self.dot(p, q, q)
    }

    /// The circumcentre of a triangle.
    pub(crate) fn circumcentre(&self, [a, b, c]: [PointId; 3]) -> Ratio2 {
        let (ab, ac) = (sub(self.at(b), self.at(a)), sub(self.at(c), self.at(a)));
        let (bb, cc) = (dot(&ab, &ab), dot(&ac, &ac));
        let w: BigInt = cross(&ab, &ac) * 2;
        let [ax, ay] = self.at(a);
        Ratio2 {
            x: &ac[1] * &bb - &ab[1] * &cc + ax * &w,
            y: &ab[0] * &cc - &ac[0] * &bb + ay * &w,
            w,
        }
        .normalised()
    }

    pub(crate) fn ratio(&self, p: PointId) -> Ratio2 {
        let [x, y] = self.at(p).clone();
        Ratio2 { x, y, w: 1.into() }
    }
}

/// The point (x / w, y / w) with w > 0.
pub(crate) struct Ratio2 {
    pub(crate) x: BigInt,
    pub(crate) y: BigInt,
    pub(crate) w: BigInt,
}

impl Ratio2 {
    fn normalised(self) -> Self {
        if self.w.sign() == Sign::Minus {
            Self {
                x: -self.x,
                y: -self.y,
                w: -self.w,
            }
        } else {
            self
        }
    }

    /// w (self - p)
    pub(crate) fn from(&self, [x, y]: &Point) -> Point {
        [&self.x - x * &self.w, &self.y - y * &self.w]
    }
}

/// The fraction n / d with d > 0.
#[derive(Clone, Debug)]
pub(crate) struct Ratio {
    pub(crate) n: BigInt,
    pub(crate) d: BigInt,
}

impl Ratio {
    pub(crate) fn new(n: BigInt, d: BigInt) -> Self {
        if d.sign() == Sign::Minus {
            Self { n: -n, d: -d }
        } else {
            Self { n, d }
        }
    }

    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        (&self.n * &other.d).cmp(&(&other.n * &self.d))
    }
}

/// The discs through `p` and `q` that no vertex is strictly inside of, by the cotangent of the
/// angle that pq subtends at their boundary on the left.
pub(crate) struct Pencil<'a> {
    p: &'a Point,
    q: &'a Point,
    across: Point,
    pub(crate) low: Option<Ratio>,
    pub(crate) high: Option<Ratio>,
    pub(crate) blocked: bool,
}

impl<'a> Pencil<'a> {
    pub(crate) fn new(p: &'a Point, q: &'a Point) -> Self {
        Self {
            p,
            q,
            across: sub(q, p),
            low: None,
            high: None,
            blocked: false,
        }
    }

    pub(crate) fn avoid(&mut self, v: &Ratio2) {
        let (from_p, from_q) = (v.from(self.p), v.from(self.q));
        let cosine = dot(&from_p, &from_q);
        let sine = cross(&self.across, &from_p) * &v.w;
        let bound = Ratio::new(cosine, sine.clone());
        match sine.sign() {
            Sign::Plus if self.high.as_ref().is_none_or(|h| bound.compare(h).is_lt()) => {
                self.high = Some(bound);
            }
            Sign::Minus if self.low.as_ref().is_none_or(|l| bound.compare(l).is_gt()) => {
                self.low = Some(bound);
            }
            Sign::NoSign => self.blocked |= bound.n.sign() == Sign::Minus,
            _ => {}
        }
    }

    /// How the upper bound compares to the lower one; greater: room for more than one disc.
    pub(crate) fn room(&self) -> Ordering {
        match (&self.low, &self.high) {
            _ if self.blocked => Ordering::Less,
            (Some(low), Some(high)) => high.compare(low),
            _ => Ordering::Greater,
        }
    }
}

pub(crate) fn sub(p: &Point, q: &Point) -> Point {
    [&p[0] - &q[0], &p[1] - &q[1]]
}

pub(crate) fn dot(u: &Point, v: &Point) -> BigInt {
    &u[0] * &v[0] + &u[1] * &v[1]
}

pub(crate) fn cross(u: &Point, v: &Point) -> BigInt {
    &u[0] * &v[1] - &u[1] * &v[0]
}

/// x 2^100 of a multiple of 2^-100.
pub(crate) fn integer(x: f64) -> BigInt {
    let mut scaled = x * 2f64.powi(100);
    let mut twos = 0u32;
    while scaled.abs() >= 2f64.powi(53) {
        scaled /= 2.0;
        twos += 1;
    }
    // A mantissa of 53 bits and its power of two.
    let exact = scaled.abs() < 2f64.powi(53) && (scaled.fract() == 0.0 || twos > 0);
    assert!(exact, "{x} is no multiple of 2^-100");
    #[expect(clippy::cast_possible_truncation, reason = "below 2^63")]
    let mantissa = (scaled * 1024.0) as i64;
    (BigInt::from(mantissa) << twos) / 1024
}
