//! Least detour: beside Crust, its growth, and inputs on which nothing is certified.

use curvecrust_geometry::{DVec2, PointSet, PointSetError};
use curvecrust_reconstruct::{crust, least_detour};

use crate::comparison::{Goal, Row, Task, medians, per_element};
use crate::stages::Sizes;
use curvecrust_testing::planted::{many_curves, uniform};

/// All rows; on one thread.
///
/// # Errors
/// Too many points for a [`PointSet`]: not for the sizes given here.
///
/// # Panics
/// If the planted edges are not found.
pub fn rows(sizes: Sizes) -> Result<Vec<Row>, PointSetError> {
    let rounds = sizes.rounds.div_ceil(3);
    let [few, most] = [many_curves(sizes.small, 1)?, many_curves(sizes.large, 1)?];
    assert_eq!(least_detour(&few.points), few.edges);
    assert_eq!(least_detour(&most.points), most.edges);
    let times = medians(
        vec![
            Task::new("few", || least_detour(&few.points)),
            Task::new("most", || least_detour(&most.points)),
            Task::new("crust", || crust(&most.points)),
        ],
        rounds,
    );
    let (small, large) = (sizes.small, sizes.large);
    let each = |at: usize, count| per_element(times[at], count);
    let mut rows = vec![
        Row {
            what: format!("least detour / Crust, many-curves {large}"),
            measured: format!("{} / {} a point", each(1, large), each(2, large)),
            figure: times[1] / times[2],
            goal: Goal::AtMost(4.0),
        },
        Row {
            what: format!("growth of least detour, many-curves {small} to {large}, exponent"),
            measured: format!("{}, {} a point", each(0, small), each(1, large)),
            figure: (times[1] / times[0]).ln() / (large as f64 / small as f64).ln(),
            goal: Goal::AtMost(1.15),
        },
    ];
    let medium = sizes.medium;
    for (name, points) in [("uniform", uniform(medium, 1)?), ("grid", grid(medium)?)] {
        let time = medians(vec![Task::new(name, || least_detour(&points))], rounds);
        rows.push(Row {
            what: format!("least detour, {name} {}, seconds", points.len()),
            measured: format!("{} a point", per_element(time[0], points.len())),
            figure: time[0],
            goal: Goal::AtMost(30.0),
        });
    }
    Ok(rows)
}

/// The largest square grid of integers with at most `count` points.
fn grid(count: usize) -> Result<PointSet, PointSetError> {
    let fits = |n: u32| (n as usize).pow(2) <= count;
    let side = (1u32..).take_while(|&n| fits(n)).last().unwrap_or(0);
    let row = |y: u32| (0..side).map(move |x| DVec2::new(x.into(), y.into()));
    PointSet::new((0..side).flat_map(row).collect())
}
