//! `docs/results/claims.md`: what the paper says of other algorithms, measured on running ones:
//! the density at which each first fails (Table 1), the smallest corner that it returns (Figure 3)
//! and the edges that it makes where samples are too sparse (Figure 11).

use crate::compare::true_curves::arc;
use crate::paper::figures::PointSets;
use crate::paper::published::{Bound, TABLE_1};
use crate::table::{Field, Table, rounded};
use curvecrust::DVec2;
use curvecrust::geometry::{Component, EdgeSet, PointId, PointSet};
use curvecrust::reconstruct::{ALGORITHMS, HnnCrust, Reconstructor};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// The page.
pub(crate) const NAME: &str = "docs/results/claims.md";

/// Samples on a circle: from three up to this number.
const MOST_ON_CIRCLE: u32 = 40;
/// Steps of the spacing on parallel lines, and the last of them, in distances of the lines.
const STEP: f64 = 0.02;
const STEPS: u32 = 150;
/// Samples on each of the parallel lines, and on each leg of a corner.
const ON_LINE: u32 = 31;
const ON_LEG: u32 = 8;
/// By what parts of the spacing samples of the second line are ahead.
const SHIFTS: [f64; 3] = [0.0, 0.25, 0.5];

const OPENING: &str = "\
<!-- Made by `cargo xtask docs`. -->

# What the paper says of others, measured

The paper compares bounds that others have proven for their algorithms.
Here the algorithms of this project run on what these bounds are about, in even steps.
An algorithm fails where it does not return exactly the edges between neighbours.

- *Printed*: the bound of epsilon in Table 1 of the paper, and the samples on a circle that follow
  from it there. `-like` is a sketch of its original.
- *Circle*: the fewest samples such that this number and all larger ones, up to 40, are returned,
  and the epsilon of one sample less.
- *Parallel lines*: samples on two lines; those of the second are shifted by nothing, a quarter or
  half a step. The first epsilon, in steps of 0.02, at which one of the three fails; only edges in
  the middle of the lines count. 3 means that none failed.
- *Zigzag*: even steps that turn at every sample, to the left and to the right in turn.
  The smallest angle such that it and all larger ones, in whole degrees, are returned in the middle.
- *Corner*: the same of two straight strokes of even steps with a sample at their corner.

A dash stands where no number of samples, or no angle, is such, where three samples of a circle are
enough, and where Table 1 prints nothing.
Some algorithms are made for closed curves alone, and have no good answer to strokes.

";

const BELOW: &str = "
Figure 3 of the paper says that Crust needs angles above 90 degrees and HNN-Crust above 60: the
zigzag shows just that.
At one corner between straight strokes Crust goes as far as HNN-Crust.
GathanG-like needs the 12 samples on a circle that Table 1 prints; the others go farther on circles
than their bounds, and all do on parallel lines.
On both, lfs is the same everywhere, so rho is epsilon: HNN-Crust fails at 1, and 0.9 is printed.

## Where samples are too sparse

Figure 11 of the paper shows that GathanG joins some samples arbitrarily where HNN-Crust leaves an
end.
The table counts edges on the points of this project's Figure 11.
An edge is *chosen* if one of its ends is the nearest or the half neighbour of the other.

";

/// The page as Markdown.
pub(crate) fn page() -> anyhow::Result<String> {
    let rows: Vec<Vec<Field>> = ALGORITHMS.par_iter().map(|&a| row(a)).collect();
    let mut table = Table::new([
        "algorithm",
        "printed",
        "circle: printed",
        "circle: samples",
        "circle: fails at",
        "parallel lines: fail at",
        "zigzag",
        "corner",
    ]);
    table.rows = rows;
    let sparse = sparse(&PointSets::redrawn()?.violated).to_markdown();
    Ok(format!("{OPENING}{}{BELOW}{sparse}", table.to_markdown()))
}

fn row(algorithm: &dyn Reconstructor) -> Vec<Field> {
    let name = algorithm.info().name;
    let printed = printed(name);
    let of_paper = |value: Option<f64>| value.map_or(Field::Missing, |v| rounded(v, 3).into());
    let circle = circle(algorithm);
    let fails = |count: u32| 2.0 * (PI / f64::from(2 * count)).sin();
    let circle_fails = match circle {
        Some(count) if count > 3 => rounded(fails(count - 1), 3).into(),
        _ => Field::Missing,
    };
    vec![
        Field::from(name),
        of_paper(printed.map(|row| row.bound)),
        of_paper(printed.map(|row| row.circle)),
        circle.map_or(Field::Missing, |count| Field::from(count as usize)),
        circle_fails,
        rounded(parallel_lines(algorithm), 3).into(),
        angle(zigzag(algorithm)),
        angle(corner(algorithm)),
    ]
}

/// In degrees.
fn angle(degrees: Option<u32>) -> Field {
    degrees.map_or(Field::Missing, |degrees| {
        Field::Written(format!("{degrees}°"))
    })
}

/// The row of Table 1 of an algorithm, for epsilon.
fn printed(name: &str) -> Option<Bound> {
    let paper = match name {
        "gathan-g-like" => "GathanG",
        "crust" => "Crust",
        "nn-crust" => "NN-Crust",
        "lenz-like" => "Lenz 2006 (not proven)",
        "hnn-crust" => "HNN-Crust",
        _ => return None,
    };
    let mut bounds = TABLE_1.iter();
    bounds
        .find(|row| row.algorithm == paper && row.condition == "epsilon")
        .copied()
}

/// The fewest samples of a circle from which on it is returned; `None` if 40 are not enough.
fn circle(algorithm: &dyn Reconstructor) -> Option<u32> {
    let is_returned = |&count: &u32| {
        let ring = Component {
            range: 0..count as usize,
            closed: true,
        };
        let points = arc(DVec2::ZERO, 1.0, 0.3, 0.3 + TAU, count);
        is_returned(algorithm, points, &[ring], |_| true)
    };
    (3..=MOST_ON_CIRCLE).rev().take_while(is_returned).last()
}

/// The first epsilon at which the middle of two parallel lines is not returned. The lines are at
/// distance 1, lfs is half of that, and no point is farther than half a step from a sample.
fn parallel_lines(algorithm: &dyn Reconstructor) -> f64 {
    let steps = (1..=STEPS).map(|step| STEP * f64::from(step));
    let mut fails = steps.filter(|&spacing| {
        let line = |y: f64, shift: f64| {
            (0..ON_LINE).map(move |i| DVec2::new((f64::from(i) + shift) * spacing, y))
        };
        let count = ON_LINE as usize;
        let lines = [0..count, count..2 * count];
        let lines = lines.map(|range| Component {
            range,
            closed: false,
        });
        let middle = |i: usize| (count / 3..2 * count / 3).contains(&(i % count));
        let returns = |&shift: &f64| {
            let points = line(0.0, 0.0).chain(line(1.0, shift)).collect();
            is_returned(algorithm, points, &lines, middle)
        };
        !SHIFTS.iter().all(returns)
    });
    fails.next().unwrap_or(STEP * f64::from(STEPS))
}

/// The smallest angle, in degrees, from which on the corner of two strokes is returned.
fn corner(algorithm: &dyn Reconstructor) -> Option<u32> {
    let is_returned = |&degrees: &u32| {
        let half = f64::from(degrees).to_radians() / 2.0;
        let leg = |angle: f64| (1..=ON_LEG).map(move |i| f64::from(i) * DVec2::from_angle(angle));
        let points: Vec<DVec2> = leg(half)
            .rev()
            .chain([DVec2::ZERO])
            .chain(leg(-half))
            .collect();
        let stroke = Component {
            range: 0..points.len(),
            closed: false,
        };
        let near: Range<usize> = 5..12;
        is_returned(algorithm, points, &[stroke], |i| near.contains(&i))
    };
    (1..180).rev().take_while(is_returned).last()
}

/// The smallest angle, in degrees, from which on the middle of a zigzag is returned.
fn zigzag(algorithm: &dyn Reconstructor) -> Option<u32> {
    let is_returned = |&degrees: &u32| {
        let step = DVec2::from_angle(PI / 2.0 - f64::from(degrees).to_radians() / 2.0);
        let at = |i: u32| DVec2::new(f64::from(i) * step.x, f64::from(i % 2) * step.y);
        let stroke = Component {
            range: 0..ON_LINE as usize,
            closed: false,
        };
        let middle = |i: usize| (10..21).contains(&i);
        is_returned(algorithm, (0..ON_LINE).map(at).collect(), &[stroke], middle)
    };
    (1..180).rev().take_while(is_returned).last()
}

/// Whether an algorithm returns exactly the edges of polygons at the samples that count.
fn is_returned(
    algorithm: &dyn Reconstructor,
    points: Vec<DVec2>,
    polygons: &[Component],
    counts: impl Fn(usize) -> bool,
) -> bool {
    let truth = EdgeSet::new(points.len(), polygons.iter().flat_map(Component::edges));
    let Ok(points) = PointSet::new(points) else {
        return false;
    };
    let found = algorithm.reconstruct(&points);
    let mut wrong = truth.difference(&found).chain(found.difference(&truth));
    wrong.all(|edge| !edge.ends().into_iter().map(PointId::index).any(&counts))
}

/// What three algorithms make of points that are too sparse.
fn sparse(sets: &[PointSet]) -> Table {
    let mut table = Table::new(["algorithm", "edges", "chosen", "not chosen", "leaves"]);
    for &algorithm in ALGORITHMS {
        let name = algorithm.info().name;
        if !["hnn-crust", "crust", "gathan-like", "gathan-g-like"].contains(&name) {
            continue;
        }
        let mut counts = [0; 4];
        for points in sets {
            let found = algorithm.reconstruct(points);
            let chosen = HnnCrust::UNION.reconstruct(points);
            let arbitrary = found.difference(&chosen).count();
            let here = [
                found.len(),
                found.len() - arbitrary,
                arbitrary,
                found.leaves().len(),
            ];
            for (sum, count) in counts.iter_mut().zip(here) {
                *sum += count;
            }
        }
        let fields = counts.map(Field::from).into_iter();
        table
            .rows
            .push([Field::from(name)].into_iter().chain(fields).collect());
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust::reconstruct::Crust;

    /// Figure 3 of the paper.
    #[test]
    fn crust_fails_at_90_degrees_and_hnn_crust_at_60() {
        let degrees = |algorithm: &dyn Reconstructor| zigzag(algorithm).unwrap();
        assert!((90..=91).contains(&degrees(&Crust)), "{}", degrees(&Crust));
        let hnn = degrees(&HnnCrust::MUTUAL);
        assert!((60..=61).contains(&hnn), "{hnn}");
    }

    /// What is proven holds on what is measured.
    #[test]
    fn no_proven_bound_is_broken() {
        for &algorithm in ALGORITHMS {
            let name = algorithm.info().name;
            if !["crust", "nn-crust", "hnn-crust"].contains(&name) {
                continue;
            }
            let bound = printed(name).unwrap().bound;
            assert!(parallel_lines(algorithm) >= bound, "{name}");
            let count = circle(algorithm).unwrap() - 1;
            let fails = 2.0 * (PI / f64::from(2 * count)).sin();
            assert!(fails >= bound, "{name}");
        }
    }
}
