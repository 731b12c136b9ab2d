//! No condition of the checker refutes what a real curve has: a false lemma would be found here.
//!
//! The curves are strands of random smooth curvature with an obstacle on each side, their medial
//! axis by shrinking balls, brute force.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_geometry::Random;
use curvecrust_proof::{Curves, Interval, Leaf, Reason};
use std::f64::consts::TAU;

type Point = [f64; 2];

/// Points of a strand are this far apart; lfs is measured with an error below 1 %.
const STEP: f64 = 0.01;
const HALF: usize = 400;

/// Where the arc of a strand ends, as a length along it.
const ARC: f64 = 0.55;

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn distance(a: Point, b: Point) -> f64 {
    dot(minus(a, b), minus(a, b)).sqrt()
}

/// Points of a curve, the angles of its tangents, and the radii of its largest free tangent discs
/// to the left and to the right.
struct Strand {
    points: Vec<Point>,
    angles: Vec<f64>,
    radii: Vec<[f64; 2]>,
}

impl Strand {
    /// For arcs, the curvature is constant up to the last place of s1.
    fn random(curves: Curves, random: &mut Random) -> Self {
        let bend = random.between(0.0, 1.1);
        let waves = [0.0, 0.7, 1.9].map(|frequency| {
            let phase = random.between(0.0, TAU);
            (bend * random.between(-1.0, 1.0), frequency, phase)
        });
        // Waves, or two arcs with a short ramp between them: there many bounds are tight.
        let ends = [0, 1].map(|_| random.between(-1.0, 1.0));
        let (switch, width) = (random.between(-1.0, 0.5), random.between(0.03, 0.5));
        let in_waves = random.unit() < 0.4;
        let curvature = |s: f64| -> f64 {
            if curves == Curves::Arcs && s < ARC {
                return ends[0];
            }
            if in_waves {
                let waves = waves.iter();
                return waves.map(|(a, f, phase)| a * (f * s + phase).sin()).sum();
            }
            let share = 0.5 + 0.5 * ((s - switch) / width).tanh();
            ends[0] + (ends[1] - ends[0]) * share
        };
        let (mut at, mut angle) = ([0.0, 0.0], 0.0);
        let (mut points, mut angles, mut bends) = (vec![], vec![], vec![]);
        for i in 0..=2 * HALF {
            #[expect(clippy::cast_precision_loss, reason = "small")]
            let s = STEP * (i as f64 - HALF as f64);
            points.push(at);
            angles.push(angle);
            bends.push(curvature(s));
            let middle = angle + 0.5 * STEP * curvature(s + 0.25 * STEP);
            at = [at[0] + STEP * middle.cos(), at[1] + STEP * middle.sin()];
            angle += STEP * curvature(s + 0.5 * STEP);
        }
        let mut strand = Self {
            points,
            angles,
            radii: vec![],
        };
        strand.radii = (0..bends.len()).map(|i| strand.free(i, bends[i])).collect();
        strand
    }

    fn normal(&self, i: usize) -> Point {
        [-self.angles[i].sin(), self.angles[i].cos()]
    }

    /// The radii of free discs at a point, by its curvature and all points that are not next to it.
    fn free(&self, i: usize, curvature: f64) -> [f64; 2] {
        [1.0, -1.0].map(|side| {
            let mut radius = if side * curvature > 0.0 {
                1.0 / curvature.abs()
            } else {
                1e3
            };
            for (j, point) in self.points.iter().enumerate() {
                if i.abs_diff(j) > 5 {
                    radius = radius.min(self.touching(i, side, *point));
                }
            }
            radius
        })
    }

    /// The radius of the disc that touches the curve at a point and passes through another.
    fn touching(&self, i: usize, side: f64, other: Point) -> f64 {
        let w = minus(other, self.points[i]);
        let rise = side * dot(w, self.normal(i));
        if rise > 0.0 {
            dot(w, w) / (2.0 * rise)
        } else {
            1e3
        }
    }

    /// The point at some height on the normal of a point; negative heights are on the right.
    fn raised(&self, i: usize, height: f64) -> Point {
        let ([x, y], n) = (self.points[i], self.normal(i));
        [x + height * n[0], y + height * n[1]]
    }

    /// The centres of the largest free discs that do not hold the obstacles either.
    fn axis(&self, obstacles: &[Point]) -> Vec<Point> {
        let center = |i: usize, side: f64, radius: f64| {
            let touching = obstacles.iter().map(|o| self.touching(i, side, *o));
            self.raised(i, side * touching.fold(radius, f64::min))
        };
        let pair =
            |(i, radii): (usize, &[f64; 2])| [center(i, 1.0, radii[0]), center(i, -1.0, radii[1])];
        self.radii.iter().enumerate().flat_map(pair).collect()
    }
}

/// What a real curve has, in the coordinates of the proof.
struct Real {
    unknowns: [Interval; 4],
    rho: Interval,
    /// |x s1|.
    midpoint: f64,
    z: Point,
    /// Centres of balls that nearly touch the curve and z.
    centers: Vec<Point>,
}

/// A random index.
fn index(low: usize, high: usize, random: &mut Random) -> usize {
    low + random.below(high - low)
}

/// Chooses s0, q, s1 and z; none if they are no configuration of the proof.
fn choose(strand: &Strand, random: &mut Random) -> Option<Real> {
    let s1 = index(HALF - 50, HALF + 50, random);
    let s0 = index(s1 - 170, s1 - 20, random);
    let q = index(s0 + 1, s1, random);
    let side = if random.unit() < 0.5 { 1.0 } else { -1.0 };
    let radius = strand.radii[q][usize::from(side < 0.0)];
    let height = random.between(0.7, 1.0) * (2.0 * radius).min(2.5);
    let (p, z) = (&strand.points, strand.raised(q, side * height));
    let near = |i: usize| i.abs_diff(q) > 3 && distance(p[i], z) < height;
    let near = (0..p.len()).any(near);
    if near || distance(z, p[s1]) >= distance(z, p[s0]) {
        return None;
    }
    // Another strand may come near on the other side.
    let foot = index(s0 - 20, s1 + 20, random);
    let below = 2.0 * strand.radii[foot][usize::from(side > 0.0)].min(1.0);
    let below = strand.raised(foot, -side * below * random.between(0.6, 1.4));
    let axis = strand.axis(&[z, below]);
    let lfs = |i: usize| axis.iter().map(|m| distance(*m, p[i])).fold(1e9, f64::min);
    let reach = (s0..=s1).map(lfs).fold(1e9, f64::min);
    let away = |i: usize| distance(p[i], p[s0]).min(distance(p[i], p[s1]));
    let midpoint = (s0..=s1).map(away).fold(0.0, f64::max);
    let rho = 1.01 * midpoint / reach;
    if rho > 0.92 {
        return None;
    }
    // lfs(s1) is the unit, z above the curve, the tangent at s1 the x axis.
    let unit = 0.99 * lfs(s1);
    let (sine, cosine) = strand.angles[s1].sin_cos();
    let place = |point: Point| {
        let [x, y] = minus(point, p[s1]);
        [
            (cosine * x + sine * y) / unit,
            side * (cosine * y - sine * x) / unit,
        ]
    };
    let at = place(p[q]);
    let far = dot(at, at).sqrt();
    let half = (side * (strand.angles[q] - strand.angles[s1]) / 2.0).tan();
    let unknowns = [far, -2.0 * at[1] / (far * far), half, height / unit];
    let mut center = || {
        let foot = index(q, s1, random);
        let radius = strand.radii[foot][usize::from(side < 0.0)];
        let radius = radius.min(strand.touching(foot, side, z));
        place(strand.raised(foot, side * radius * random.between(0.7, 1.0)))
    };
    Some(Real {
        centers: (0..16).map(|_| center()).collect(),
        unknowns: unknowns.map(Interval::point),
        rho: Interval::point(rho),
        midpoint: midpoint / unit,
        z: place(z),
    })
}

/// All conditions but that z is nearer than s2, which is no lemma.
fn reasons(real: &Real, random: &mut Random) -> Vec<Reason> {
    let mut all = vec![
        Reason::Nearest,
        Reason::Backwards,
        Reason::Reach,
        Reason::DiscAtS1,
        Reason::DiscAtQ,
        Reason::Sides,
        Reason::Ends,
        Reason::NoMidpoint,
    ];
    let anywhere = (0..8).map(|_| [random.between(-1.5, 0.2), random.between(-0.3, 1.2)]);
    for center in real.centers.iter().copied().chain(anywhere) {
        let radius = distance(center, real.z) * (1.0 + 1e-9);
        all.push(Reason::Ball { center, radius });
    }
    all
}

#[test]
fn no_real_curve_is_refuted() {
    refutes_none(Curves::Smooth);
}

#[test]
fn no_real_arc_is_refuted() {
    refutes_none(Curves::Arcs);
}

fn refutes_none(curves: Curves) {
    let mut random = Random::new(1);
    let (mut tried, mut tight) = (0, 0);
    for _ in 0..100 {
        let strand = Strand::random(curves, &mut random);
        for _ in 0..120 {
            let Some(real) = choose(&strand, &mut random) else {
                continue;
            };
            let leaf = |midpoint, reason| Leaf { midpoint, reason };
            let fails = |leaf: Leaf| {
                let refuted = curves.refutes(&real.unknowns, real.rho, &leaf);
                assert!(
                    !refuted,
                    "{leaf:?} refutes {:?}, {:?}",
                    real.unknowns, real.rho
                );
            };
            for reason in reasons(&real, &mut random) {
                fails(leaf(None, reason.clone()));
                fails(leaf(Some(0.97 * real.midpoint), reason));
            }
            tried += 1;
            tight += usize::from(real.rho.low() > 0.8);
        }
    }
    assert!(
        tried > 300 && tight > 20,
        "{tried} configurations, {tight} of them above 0.8"
    );
}

/// Lemma 2, where the normal runs through discs that are free of the medial axis: about two points
/// of the curve, their radii lfs.
#[test]
fn a_disc_on_a_normal_off_the_axis_is_free() {
    let mut random = Random::new(2);
    let mut passed = 0;
    for _ in 0..100 {
        let strand = Strand::random(Curves::Smooth, &mut random);
        let foot = index(HALF - 100, HALF + 100, &mut random);
        let height = 2.0 * strand.radii[foot][0].min(1.0) * random.between(0.7, 1.2);
        let obstacle = strand.raised(foot, height);
        let axis = strand.axis(&[obstacle]);
        let p = &strand.points;
        let lfs = |i: usize| axis.iter().map(|m| distance(*m, p[i])).fold(1e9, f64::min);
        for _ in 0..20 {
            let near = |random: &mut Random| index(HALF - 100, HALF + 100, random);
            let [from, a, b] = [0; 3].map(|_| near(&mut random));
            let discs = [a, b].map(|i| (p[i], 0.98 * lfs(i)));
            for side in [1.0, -1.0] {
                let is_off = |height: f64| {
                    let at = strand.raised(from, side * height);
                    discs.iter().any(|(c, radius)| distance(*c, at) < *radius)
                };
                let heights = (0..400).map(|i| 0.005 * f64::from(i));
                let Some(height) = heights.take_while(|h| is_off(*h)).last() else {
                    continue;
                };
                let center = strand.raised(from, side * height);
                let mut all = p.iter().chain([&obstacle]);
                assert!(all.all(|other| distance(*other, center) > 0.99 * height - 1e-3));
                // Beyond what lfs there gives.
                passed += usize::from(height > 1.1 * lfs(from));
            }
        }
    }
    assert!(passed > 100, "{passed} longer normals");
}
