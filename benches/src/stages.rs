//! What is compared with what, and on which input.

use curvecrust_geometry::{EdgeSet, PointSet, PointSetError};
use curvecrust_reconstruct::neighbours::{HalfRule, neighbours};
use curvecrust_reconstruct::{crust, hnn_crust, nn_crust};
use curvecrust_voronoi::Delaunay;
use glam::DVec2;

use crate::comparison::{Goal, Row, Task, medians, per_element};
use crate::peers::{self, anew};
use curvecrust_testing::planted::{many_curves, mixed_scale, one_curve, uniform};

/// The numbers of points, and of rounds of which the median is taken.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// Few points.
    pub small: usize,
    /// The size of the Delaunay comparisons on one curve.
    pub medium: usize,
    /// Many points: the size of most comparisons.
    pub large: usize,
    /// As many as the growth is measured to.
    pub huge: usize,
    /// Rounds.
    pub rounds: usize,
}

impl Sizes {
    /// 10^4 to 10^7 points.
    pub const FULL: Self = Self {
        small: 10_000,
        medium: 100_000,
        large: 1_000_000,
        huge: 10_000_000,
        rounds: 9,
    };
    /// A tenth of that, to see that all runs.
    pub const QUICK: Self = Self {
        small: 1_000,
        medium: 10_000,
        large: 100_000,
        huge: 1_000_000,
        rounds: 3,
    };
}

/// Whether the kernel chooses its instructions at run time.
const DISPATCH: &str = if cfg!(feature = "portable") {
    ", dispatch off"
} else {
    ""
};

/// HNN-Crust against kiddo, on one thread.
///
/// # Errors
/// Too many points for a [`PointSet`]: not for the sizes given here.
///
/// # Panics
/// If the edges are not those of the same algorithm on kiddo, on planted curves those planted.
pub fn against_kiddo(sizes: Sizes) -> Result<Vec<Row>, PointSetError> {
    // With dispatch switched off only the first of them has a goal, and another one.
    let portable = cfg!(feature = "portable");
    let goal = |bound| {
        if portable {
            Goal::None
        } else {
            Goal::AtMost(bound)
        }
    };
    let first = Goal::AtMost(if portable { 0.40 } else { 0.25 });
    let many = many_curves(sizes.large, 1)?;
    let few = many_curves(sizes.small, 1)?;
    let mixed = mixed_scale(sizes.large, 1)?;
    let one = one_curve(sizes.large)?;
    let inputs: [(&str, PointSet, Option<EdgeSet>, Goal); 5] = [
        ("many-curves", many.points, Some(many.edges), first),
        ("many-curves", few.points, Some(few.edges), goal(0.55)),
        ("mixed-scale", mixed.points, Some(mixed.edges), goal(0.30)),
        ("uniform", uniform(sizes.large, 1)?, None, goal(0.50)),
        ("one-curve", one.points, Some(one.edges), Goal::None),
    ];
    let mut rows = Vec::new();
    for (name, points, planted, goal) in inputs {
        let edges = hnn_crust(&points);
        assert_eq!(edges, peers::kiddo_hnn_crust(&points), "{name}");
        assert!(planted.is_none_or(|planted| planted == edges), "{name}");
        rows.push(one_against_kiddo(name, &points, goal, sizes.rounds));
    }
    Ok(rows)
}

fn one_against_kiddo(name: &str, points: &PointSet, goal: Goal, rounds: usize) -> Row {
    let arrays = peers::arrays(points);
    let tasks = vec![
        Task::new("hnn-crust", || hnn_crust(&anew(points))),
        Task::new("kiddo", || peers::kiddo_nearest_three(&arrays)),
        Task::new("kiddo's hnn-crust", || peers::kiddo_hnn_crust(points)),
    ];
    let times = medians(tasks, rounds);
    let [ours, three, theirs] = [0, 1, 2].map(|i| per_element(times[i], points.len()));
    Row {
        what: format!(
            "HNN-Crust / kiddo's build + nearest 3, {name} {}{DISPATCH}",
            points.len()
        ),
        measured: format!("{ours} / {three} a point (its full HNN-Crust: {theirs})"),
        figure: times[0] / times[1],
        goal,
    }
}

/// HNN-Crust against sorting, NN-Crust and rstar; one thread.
///
/// # Errors
/// Too many points for a [`PointSet`]: not for the sizes given here.
pub fn alone(sizes: Sizes) -> Result<Vec<Row>, PointSetError> {
    let points = many_curves(sizes.large, 1)?.points;
    let few = many_curves(sizes.medium, 1)?.points;
    let outlying = with_outlier(&points)?;
    let keys = peers::keys(sizes.large);
    let tasks = vec![
        Task::new("hnn-crust", || hnn_crust(&anew(&points))),
        Task::new("sort", || peers::sorted(&keys)),
        Task::new("nn-crust", || nn_crust(&anew(&points))),
        Task::new("neighbours", || {
            neighbours(&anew(&points), HalfRule::Bisector)
        }),
        Task::new("hnn-crust of few", || hnn_crust(&anew(&few))),
        Task::new("rstar of few", || peers::rstar_hnn_crust(&few)),
        Task::new("with an outlier", || hnn_crust(&anew(&outlying))),
    ];
    let times = medians(tasks, sizes.rounds);
    let [ours, sort, nn, list] = [0, 1, 2, 3].map(|i| per_element(times[i], points.len()));
    let outlier = per_element(times[6], points.len());
    let [of_few, rstar] = [4, 5].map(|i| per_element(times[i], few.len()));
    let count = points.len();
    let row = |what: String, measured, figure, goal| Row {
        what: what + DISPATCH,
        measured,
        figure,
        goal,
    };
    let on_dispatch = |goal| {
        if cfg!(feature = "portable") {
            Goal::None
        } else {
            goal
        }
    };
    Ok(vec![
        row(
            format!("HNN-Crust / sort_unstable of as many u64, many-curves {count}"),
            format!("{ours} / {sort} a point"),
            times[0] / times[1],
            on_dispatch(Goal::AtMost(6.0)),
        ),
        row(
            format!("NN-Crust / HNN-Crust, many-curves {count}"),
            format!("{nn} / {ours} a point (neighbours alone: {list})"),
            times[2] / times[0],
            Goal::AtMost(1.15),
        ),
        row(
            format!("HNN-Crust / the same on rstar, many-curves {}", few.len()),
            format!("{of_few} / {rstar} a point"),
            times[4] / times[5],
            Goal::None,
        ),
        row(
            format!("HNN-Crust, an outlier 1000 diameters away / without, many-curves {count}"),
            format!("{outlier} / {ours} a point"),
            times[6] / times[0],
            Goal::None,
        ),
    ])
}

/// The points and one more, a thousand times their extent away.
fn with_outlier(points: &PointSet) -> Result<PointSet, PointSetError> {
    let mut points = points.points().to_vec();
    let extent = points
        .iter()
        .fold(0.0, |e: f64, p| e.max(p.abs().max_element()));
    points.push(DVec2::new(-1000.0 * extent, 0.0));
    PointSet::new(points)
}

/// The growth of HNN-Crust in time, as an exponent; one thread.
///
/// # Errors
/// Too many points for a [`PointSet`]: not for the sizes given here.
pub fn growth(sizes: Sizes) -> Result<Vec<Row>, PointSetError> {
    let [few, most] = [sizes.medium, sizes.huge];
    let inputs = [many_curves(few, 1)?.points, many_curves(most, 1)?.points];
    let tasks = inputs
        .iter()
        .map(|p| Task::new("hnn-crust", || hnn_crust(&anew(p))));
    let times = medians(tasks.collect(), sizes.rounds.div_ceil(2));
    let [first, last] = [per_element(times[0], few), per_element(times[1], most)];
    Ok(vec![Row {
        what: format!("growth of HNN-Crust, many-curves {few} to {most}, exponent{DISPATCH}"),
        measured: format!("{first}, {last} a point"),
        figure: (times[1] / times[0]).ln() / (most as f64 / few as f64).ln(),
        goal: Goal::AtMost(1.10),
    }])
}

/// HNN-Crust on a pool of one thread against one of two; to be called outside of any pool.
///
/// # Errors
/// Too many points for a [`PointSet`]: not for the sizes given here.
pub fn two_threads(
    sizes: Sizes,
    pools: &[rayon::ThreadPool; 2],
) -> Result<Vec<Row>, PointSetError> {
    let points = many_curves(sizes.large, 1)?.points;
    let task = |pool: &'_ rayon::ThreadPool| pool.install(|| hnn_crust(&anew(&points)));
    let [one, two] = pools;
    let tasks = vec![
        Task::new("one thread", || task(one)),
        Task::new("two threads", || task(two)),
    ];
    let times = medians(tasks, sizes.rounds);
    let [first, second] = [0, 1].map(|i| per_element(times[i], points.len()));
    Ok(vec![Row {
        what: format!(
            "two threads, HNN-Crust, many-curves {}, faster",
            points.len()
        ),
        measured: format!("{first} / {second} a point"),
        figure: times[0] / times[1],
        goal: Goal::AtLeast(1.6),
    }])
}

/// The Delaunay triangulation against delaunator and across inputs, and Crust against it.
///
/// # Errors
/// Too many points for a [`PointSet`]: not for the sizes given here.
///
/// # Panics
/// If the numbers of triangles differ, or Crust does not return the planted edges.
pub fn delaunay(sizes: Sizes) -> Result<Vec<Row>, PointSetError> {
    let planted = many_curves(sizes.medium, 1)?;
    let many = planted.points;
    let one = one_curve(sizes.medium)?.points;
    let large = many_curves(sizes.large, 1)?.points;
    let theirs = peers::delaunator_points(&large);
    assert_eq!(crust(&many), planted.edges);
    let tasks = vec![
        Task::new("many curves", || Delaunay::new(&many)),
        Task::new("one curve", || Delaunay::new(&one)),
    ];
    let inputs = medians(tasks, sizes.rounds);
    let crusts = medians(
        vec![
            Task::new("crust", || crust(&many)),
            Task::new("delaunay", || Delaunay::new(&many)),
        ],
        sizes.rounds,
    );
    let peers = medians(
        vec![
            Task::new("delaunay", || Delaunay::new(&large)),
            Task::new("delaunator", || peers::delaunator_triangles(&theirs)),
        ],
        sizes.rounds.div_ceil(3),
    );
    let row = |what: String, [a, b]: [f64; 2], count: usize, goal| Row {
        what,
        measured: format!(
            "{} / {} a point",
            per_element(a, count),
            per_element(b, count)
        ),
        figure: a / b,
        goal: Goal::AtMost(goal),
    };
    let [medium, many] = [sizes.medium, sizes.large];
    Ok(vec![
        row(
            format!("Delaunay of one-curve / of many-curves, {medium}"),
            [inputs[1], inputs[0]],
            medium,
            1.5,
        ),
        row(
            format!("Crust / Delaunay, many-curves {medium}"),
            [crusts[0], crusts[1]],
            medium,
            1.8,
        ),
        row(
            format!("Delaunay / delaunator, many-curves {many}"),
            [peers[0], peers[1]],
            many,
            0.40,
        ),
    ])
}
