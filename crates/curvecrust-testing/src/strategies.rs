//! Nearly degenerate and other points for proptest: collinear, cocircular, on a grid, equal but for
//! an ulp, over many scales. All are multiples of 2^-100, so that integers can check what is
//! computed from them.

use curvecrust_geometry::{DVec2, PointSet};
use proptest::collection::vec;
use proptest::prelude::*;

/// Anything from no point to 60.
pub fn any_points() -> impl Strategy<Value = PointSet> {
    let kinds = prop_oneof![
        4 => uniform(60),
        2 => circles(),
        1 => collinear(),
        2 => cocircular(),
        2 => grid(DVec2::X),
        1 => grid(DVec2::new(3.0, 4.0)),
        2 => almost_grid(),
        2 => equal_by_ulps(),
        2 => clusters(),
        1 => scales(),
        1 => uniform(3),
    ];
    kinds.prop_map(point_set)
}

/// The set of some points, each of them once.
#[must_use]
pub fn point_set(points: Vec<DVec2>) -> PointSet {
    PointSet::merging_duplicates(points).unwrap().points
}

/// Up to `max` points in [-1, 1]^2, multiples of 2^-30.
pub fn uniform(max: usize) -> impl Strategy<Value = Vec<DVec2>> {
    let unit = || (-(1i32 << 30)..=1 << 30).prop_map(|i| f64::from(i) / f64::from(1 << 30));
    vec((unit(), unit()).prop_map(DVec2::from), 0..=max)
}

/// Samples of a few circles, which may cross, at even steps.
fn circles() -> impl Strategy<Value = Vec<DVec2>> {
    let circle = (-3.0..3.0, -3.0..3.0, 0.2..3.0, 3..20i32).prop_map(|(x, y, radius, n)| {
        (0..n)
            .map(|i| {
                let angle = f64::from(i) * std::f64::consts::TAU / f64::from(n);
                rounded(DVec2::new(x, y) + radius * DVec2::from_angle(angle), 50)
            })
            .collect::<Vec<_>>()
    });
    vec(circle, 1..=3).prop_map(|circles| circles.concat())
}

/// One to four rows of points with the same turn from step to step, which end in the open; and up
/// to three points beside them. Of some rows all steps are equal, of others they are shorter by up
/// to 60 %.
pub fn even_runs() -> impl Strategy<Value = Vec<DVec2>> {
    let shortening = prop::sample::select(vec![0.0, 0.05, 0.3, 0.6]);
    let row = (
        (-4.0..4.0, -4.0..4.0, 0.0..std::f64::consts::TAU, -0.4..0.4),
        0.3..0.8,
        shortening,
        vec(0.0..1.0, 5..14),
    );
    let rows = row.prop_map(|((x, y, mut angle, turn), step, shortening, steps)| {
        let mut at = DVec2::new(x, y);
        let mut points = vec![at];
        for share in steps {
            at += DVec2::from_angle(angle) * step * (1.0 - shortening * share);
            angle += turn;
            points.push(at);
        }
        points
    });
    let beside = (-5.0..5.0, -5.0..5.0).prop_map(DVec2::from);
    (vec(rows, 1..=4), vec(beside, 0..=3)).prop_map(|(rows, beside)| {
        let all = rows.concat().into_iter().chain(beside);
        all.map(|p| rounded(p, 50)).collect()
    })
}

/// Points at whole numbers of steps on a line.
fn collinear() -> impl Strategy<Value = Vec<DVec2>> {
    let small = || (-9..=9i32).prop_map(f64::from);
    (small(), small(), small(), small(), vec(0..200i32, 0..40)).prop_map(|(x, y, dx, dy, steps)| {
        let along = DVec2::new(dx, dy);
        let at = |i| DVec2::new(x, y) + f64::from(i) * along;
        steps.into_iter().map(at).collect()
    })
}

/// Lattice points on one circle, and perhaps its centre and a few others.
fn cocircular() -> impl Strategy<Value = Vec<DVec2>> {
    let on_circle: Vec<DVec2> = (-65i32..=65)
        .flat_map(|x| (-65i32..=65).map(move |y| (x, y)))
        .filter(|(x, y)| x * x + y * y == 65 * 65)
        .map(|(x, y)| DVec2::new(x.into(), y.into()))
        .collect();
    let inside = (-20..=20i32, -20..=20i32).prop_map(|(x, y)| DVec2::new(x.into(), y.into()));
    (
        prop::sample::subsequence(on_circle, 0..=36),
        vec(inside, 0..4),
    )
        .prop_map(|(circle, inside)| [circle, inside].concat())
}

/// Part of a square grid with the side `u`.
fn grid(u: DVec2) -> impl Strategy<Value = Vec<DVec2>> {
    vec((0..9i32, 0..9i32), 0..=60).prop_map(move |cells| {
        let at = |(i, j)| f64::from(i) * u + f64::from(j) * u.perp();
        cells.into_iter().map(at).collect()
    })
}

/// Part of a square grid in which every point may be off by an ulp or so: almost all ties broken.
fn almost_grid() -> impl Strategy<Value = Vec<DVec2>> {
    let off = || (-2..=2i32).prop_map(|ulps| f64::from(ulps) * 2f64.powi(-48));
    let point = (0..6i32, 0..6i32, off(), off())
        .prop_map(|(i, j, dx, dy)| DVec2::new(f64::from(i) + dx, f64::from(j) + dy));
    vec(point, 0..40)
}

/// Points a few ulps apart, beside some at the distance of 1.
fn equal_by_ulps() -> impl Strategy<Value = Vec<DVec2>> {
    let near = (0..7i32, 0..7i32)
        .prop_map(|(i, j)| DVec2::ONE + DVec2::new(f64::from(i), f64::from(j)) * f64::EPSILON);
    let wide = (0..3i32, 0..3i32).prop_map(|(i, j)| DVec2::new(f64::from(i), f64::from(j)));
    vec(prop_oneof![4 => near, 1 => wide], 0..40)
}

/// Clusters 1e-12 wide beside coordinates of 1e6.
fn clusters() -> impl Strategy<Value = Vec<DVec2>> {
    let unit = || (-1.0..1.0, -1.0..1.0).prop_map(DVec2::from);
    let near = unit().prop_map(|p| rounded(p * 1e-12, 90));
    let far = unit().prop_map(|p| rounded(p * 1e6, 60));
    vec(prop_oneof![2 => near, 1 => far], 0..50)
}

/// Points at distances over 30 powers of ten.
fn scales() -> impl Strategy<Value = Vec<DVec2>> {
    let point = (-1.0..1.0, -1.0..1.0, -49..50i32)
        .prop_map(|(x, y, exponent)| rounded(DVec2::new(x, y) * 2f64.powi(exponent), 100));
    vec(point, 0..40)
}

/// To multiples of 2^-digits.
#[must_use]
pub fn rounded(p: DVec2, digits: i32) -> DVec2 {
    let scale = 2f64.powi(digits);
    (p * scale).round() / scale
}
