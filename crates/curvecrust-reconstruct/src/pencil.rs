//! The pencil of discs through two samples, and how a Voronoi vertex cuts it.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::rc::Rc;

use curvecrust_geometry::{DVec2, PointId, PointSet};
use num_bigint::BigInt;
use num_traits::{RefNum, Signed};

use crate::exact::{Vector, cross, dot, integers, small_integers, sub};
use crate::voronoi_vertex::VoronoiVertex;

/// Half a unit in the last place of 1: the relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// All discs with p and q on their boundary, each named by the cotangent of the angle that
/// pq subtends at its boundary on the left: 0 for the smallest disc, more for centres to the left.
pub(crate) struct Pencil<'a> {
    points: &'a PointSet,
    ends: [PointId; 2],
    p: DVec2,
    q: DVec2,
    /// q - p.
    across: DVec2,
    /// The exact cotangents computed so far, by vertex: on a grid all are asked for again and
    /// again.
    exact: RefCell<HashMap<*const VoronoiVertex, Rc<Cotangent>>>,
}

/// Where a Voronoi vertex cuts a pencil: discs with larger cotangents hold it if it is to the left
/// of pq, those with smaller ones if it is to the right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cut<'a> {
    vertex: &'a VoronoiVertex,
    /// The cotangent is between these.
    pub(crate) least: f64,
    pub(crate) most: f64,
}

/// What a Voronoi vertex does to a pencil.
pub(crate) enum Effect<'a> {
    /// It is to the left: no disc beyond the cut is free of it.
    Above(Cut<'a>),
    /// It is to the right: no disc before the cut is free of it.
    Below(Cut<'a>),
    /// It lies between p and q, inside every disc.
    Everywhere,
    /// It lies on the line through p and q, outside of every disc.
    Nowhere,
}

impl<'a> Pencil<'a> {
    pub(crate) fn new(points: &'a PointSet, ends: [PointId; 2]) -> Self {
        let [p, q] = ends.map(|id| points[id]);
        Self {
            points,
            ends,
            p,
            q,
            across: q - p,
            exact: RefCell::default(),
        }
    }

    /// Centre, as seen from an origin, and squared radius of a disc, the radius enlarged by more
    /// than all rounding errors, so that the disc holds the rounded place of each vertex inside the
    /// true disc; `None` beyond the range of doubles.
    pub(crate) fn disc(&self, cotangent: f64, origin: DVec2) -> Option<(DVec2, f64)> {
        let to_centre = self.to_centre(cotangent);
        let centre = (self.p - origin) + to_centre;
        // A vertex errs by 2^-20 of its distance to a sample, so by 2^-19 of the radius.
        let radius = to_centre.length() * (1.0 + 2f64.powi(-18)) + 64.0 * U * centre.length();
        let squared = radius * radius;
        squared.is_finite().then_some((centre, squared))
    }

    /// The first end.
    pub(crate) fn start(&self) -> DVec2 {
        self.p
    }

    /// The distance of both ends.
    pub(crate) fn length(&self) -> f64 {
        libm::hypot(self.across.x, self.across.y)
    }

    /// From the first end to the centre of a disc.
    pub(crate) fn to_centre(&self, cotangent: f64) -> DVec2 {
        (self.across + cotangent * self.across.perp()) / 2.0
    }

    /// What the vertex does: the side exactly, the cut with bounds.
    ///
    /// It is seen from the nearer end: from the other one, all that is close to the nearer one
    /// looks as if it were on the line through both.
    pub(crate) fn effect<'v>(&self, vertex: &'v VoronoiVertex) -> Effect<'v> {
        let [from_p, from_q] = [self.p, self.q].map(|end| vertex.seen_from(end));
        let (seen, to_other_end) = if from_p.error <= from_q.error {
            (from_p, self.across)
        } else {
            (from_q, -self.across)
        };
        // Vertices of slivers are so far that squares of their distances would overflow.
        let size = seen.vector.abs().max_element();
        let direction = seen.vector / size;
        let error = seen.error / size;
        let width = self.across.length();
        let sine = self.across.perp_dot(direction);
        let cosine = size * direction.length_squared() - direction.dot(to_other_end);
        let sine_error = width * (16.0 * U + error);
        // An error of 1 or more, whose square would count, passes no test of the sine.
        let cosine_error = (16.0 * U + error) * 4.0 * (size + width);
        // Not so if anything is infinite or NaN, too.
        if sine.abs() > 2.0 * sine_error {
            let cotangent = cosine / sine;
            let error = 4.0 * (cosine_error + cotangent.abs() * sine_error) / sine.abs();
            let cut = Cut::new(vertex, cotangent, error);
            return if sine > 0.0 {
                Effect::Above(cut)
            } else {
                Effect::Below(cut)
            };
        }
        let exact = self.exact(vertex);
        let Cotangent { cosine, sine } = &*exact;
        let cut = Cut::new(vertex, 0.0, f64::INFINITY);
        if sine.is_positive() {
            Effect::Above(cut)
        } else if sine.is_negative() {
            Effect::Below(cut)
        } else if cosine.is_negative() {
            Effect::Everywhere
        } else {
            Effect::Nowhere
        }
    }

    /// Compares the places of two cuts, exactly.
    pub(crate) fn compare(&self, a: &Cut<'_>, b: &Cut<'_>) -> Ordering {
        if a.most < b.least {
            Ordering::Less
        } else if a.least > b.most {
            Ordering::Greater
        } else if std::ptr::eq(a.vertex, b.vertex) {
            Ordering::Equal
        } else {
            let (a, b) = (self.exact(a.vertex), self.exact(b.vertex));
            let same_side = a.sine.is_positive() == b.sine.is_positive();
            let order = (&a.cosine * &b.sine).cmp(&(&b.cosine * &a.sine));
            if same_side { order } else { order.reverse() }
        }
    }

    fn exact(&self, vertex: &VoronoiVertex) -> Rc<Cotangent> {
        let mut known = self.exact.borrow_mut();
        let entry = known.entry(std::ptr::from_ref(vertex));
        let exact = entry.or_insert_with(|| Rc::new(self.compute_exact(vertex)));
        Rc::clone(exact)
    }

    /// The cotangent of the angle that pq subtends at the vertex, from the coordinates of its
    /// triangle.
    fn compute_exact(&self, vertex: &VoronoiVertex) -> Cotangent {
        let ([p, q], [a, b, c]) = (self.ends, vertex.corners);
        let points = [p, q, a, b, c].map(|id| self.points[id]);
        match small_integers(points, 6) {
            Some(points) => Cotangent::of(&points),
            None => Cotangent::of(&integers(points).0),
        }
    }
}

impl<'a> Cut<'a> {
    fn new(vertex: &'a VoronoiVertex, cotangent: f64, error: f64) -> Self {
        Self {
            vertex,
            least: cotangent - error,
            most: cotangent + error,
        }
    }
}

/// Cosine and sine of an angle, times the same positive number.
struct Cotangent {
    cosine: BigInt,
    sine: BigInt,
}

impl Cotangent {
    /// Of the angle that `pq` subtends at the circumcentre of `a`, `b`, `c`.
    fn of<T: Signed + Into<BigInt>>([p, q, a, b, c]: &[Vector<T>; 5]) -> Self
    where
        for<'t> &'t T: RefNum<T>,
    {
        let across = sub(q, p);
        let (place, weight) = circumcentre([p, a, b, c]);
        let far_end = across.each_ref().map(|x| x * &weight);
        Self {
            cosine: dot(&place, &sub(&place, &far_end)).into(),
            sine: (cross(&across, &place) * weight).into(),
        }
    }
}

/// The circumcentre of `a`, `b`, `c` is at `p + place / weight`, the result.
pub(crate) fn circumcentre<T: Signed>([p, a, b, c]: [&Vector<T>; 4]) -> (Vector<T>, T)
where
    for<'t> &'t T: RefNum<T>,
{
    let to_corner = sub(a, p);
    let (ab, ac) = (sub(b, a), sub(c, a));
    let (bb, cc) = (dot(&ab, &ab), dot(&ac, &ac));
    let weight = {
        let area = cross(&ab, &ac);
        &area + &area
    };
    let place = [
        &to_corner[0] * &weight + &ac[1] * &bb - &ab[1] * &cc,
        &to_corner[1] * &weight + &ab[0] * &cc - &ac[0] * &bb,
    ];
    (place, weight)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::ToPrimitive;

    /// Two ends, and where a vertex at (7, -3) is as seen from them.
    const ENDS: [([f64; 2], [f64; 2]); 6] = [
        ([1.0, 2.0], [4.0, -9.0]),
        ([4.0, -9.0], [1.0, 2.0]),
        ([8.0, -1.0], [9.0, 30.0]),
        ([-1.0, -3.0], [3.0, 5.0]),
        // On the line through the ends: between them, and not.
        ([5.0, -4.0], [11.0, -1.0]),
        ([9.0, -2.0], [11.0, -1.0]),
    ];

    /// The ends, and a triangle around a vertex that is known, by points of the grid at distance
    /// 65.
    fn planted(ends: ([f64; 2], [f64; 2]), scale: f64) -> PointSet {
        let corners = [[70.0, 13.0], [-9.0, 60.0], [-26.0, -59.0]];
        let all = [ends.0, ends.1].into_iter().chain(corners);
        PointSet::new(all.map(|p| DVec2::from(p) * scale).collect()).unwrap()
    }

    fn ids<const N: usize>(ids: [u32; N]) -> [PointId; N] {
        ids.map(PointId::from)
    }

    /// Multiples of 10007 are beyond the reach of 128 bits.
    #[test]
    fn a_planted_vertex_cuts_where_it_is() {
        for (ends, scale) in ENDS.into_iter().flat_map(|e| [(e, 1.0), (e, 10_007.0)]) {
            let points = planted(ends, scale);
            let vertex = VoronoiVertex::new(&points, ids([2, 3, 4]));
            let pencil = Pencil::new(&points, ids([0, 1]));
            let to_vertex = DVec2::new(7.0, -3.0) - DVec2::from(ends.0);
            let across = DVec2::from(ends.1) - DVec2::from(ends.0);
            let cosine = to_vertex.dot(to_vertex - across);
            let sine = across.perp_dot(to_vertex);

            let exact = pencil.exact(&vertex);
            let Cotangent { cosine: c, sine: s } = &*exact;
            let times = |x: &BigInt, by: f64| x * by.to_i64().unwrap();
            assert_eq!(times(c, sine), times(s, cosine), "{ends:?}");
            assert_eq!(s.is_positive(), sine > 0.0, "{ends:?}");
            assert_eq!(c.is_positive(), cosine > 0.0, "{ends:?}");

            let (cut, left) = match pencil.effect(&vertex) {
                Effect::Above(cut) => (cut, true),
                Effect::Below(cut) => (cut, false),
                Effect::Everywhere => {
                    assert!(sine.abs() <= 0.0 && cosine < 0.0, "{ends:?}");
                    continue;
                }
                Effect::Nowhere => {
                    assert!(sine.abs() <= 0.0 && cosine > 0.0, "{ends:?}");
                    continue;
                }
            };
            assert!(if left { sine > 0.0 } else { sine < 0.0 }, "{ends:?}");
            let cotangent = cosine / sine;
            assert!(cut.least <= cotangent && cotangent <= cut.most, "{ends:?}");
            assert!(
                cut.most - cut.least < 1e-10 * (1.0 + cotangent.abs()),
                "{ends:?}"
            );
        }
    }

    /// In a debug build, where an overflow panics.
    #[test]
    fn small_integers_fit_into_128_bits() {
        let most = 262_143.0;
        let corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]]
            .map(|[x, y]| DVec2::new(f64::from(x), f64::from(y)) * most);
        for which in 0..4usize.pow(4) {
            let corner = |place: u32| corners[which / 4usize.pow(place) % 4];
            let points = [DVec2::ZERO, corner(0), corner(1), corner(2), corner(3)];
            let of_small = Cotangent::of(&small_integers(points, 6).unwrap());
            let exact = Cotangent::of(&integers(points).0);
            assert_eq!((of_small.cosine, of_small.sine), (exact.cosine, exact.sine));
        }
    }

    #[test]
    fn discs_are_hardly_larger_than_they_are() {
        let points = planted(ENDS[0], 1.0);
        let pencil = Pencil::new(&points, ids([0, 1]));
        let (p, q) = (DVec2::new(1.0, 2.0), DVec2::new(4.0, -9.0));
        for cotangent in [-1e6, -3.0, 0.0, 0.5, 10.0] {
            for origin in [DVec2::ZERO, DVec2::new(1e6, -1e6)] {
                let (centre, squared) = pencil.disc(cotangent, origin).unwrap();
                let radius = p.distance(q) / 2.0 * f64::hypot(1.0, cotangent);
                let to_ends = [p, q].map(|end| (centre + origin).distance(end));
                let rounding = 1e-13 * (centre.length() + origin.length());
                assert!(
                    to_ends
                        .iter()
                        .all(|d| (d - radius).abs() <= 1e-12 * radius + rounding)
                );
                let most = radius * (1.0 + 2f64.powi(-17)) + rounding;
                assert!(
                    radius * (1.0 + 2f64.powi(-19)) <= squared.sqrt() && squared.sqrt() <= most
                );
            }
        }
        assert!(pencil.disc(1e300, DVec2::ZERO).is_none());
    }
}
