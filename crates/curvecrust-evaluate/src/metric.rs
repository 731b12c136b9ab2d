//! The numbers by which reconstructions are compared, in one list.

use crate::bounds::Bounds;
use crate::evaluation::Evaluation;

/// A number that says how good a reconstruction is.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Metric {
    /// The name in tables: lower case, with underscores.
    pub name: &'static str,
    /// What it is, in a line.
    pub about: &'static str,
    /// What it counts or measures; `share` is between 0 and 1, and lengths are in extents of the
    /// curve: the larger side of its bounding box.
    pub unit: &'static str,
    /// Which values are better.
    pub better: Better,
    /// How well the number is known.
    pub precision: Precision,
    value: fn(&Evaluation) -> Option<Bounds>,
}

/// Which values of a metric are better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Better {
    /// Larger ones.
    Higher,
    /// Smaller ones.
    Lower,
    /// It describes the output and does not judge it.
    Neither,
}

/// How well the value of a metric is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Up to rounding.
    Exact,
    /// It lies between a lower and an upper bound.
    Bounded,
    /// By a clock: it differs from run to run.
    Timed,
}

impl Metric {
    /// The value; equal bounds unless it is [bounded](Precision::Bounded). `None` if it does not
    /// apply, such as edge counts to an output with other vertices.
    #[must_use]
    pub fn of(&self, evaluation: &Evaluation) -> Option<Bounds> {
        (self.value)(evaluation)
    }
}

/// Every metric, the most telling first.
///
/// Tables, plots and tests iterate this list, so that none of them forgets one.
pub const METRICS: &[Metric] = &[
    Metric {
        name: "exact",
        about: "1 if exactly the edges of the manifold boundary were found, else 0",
        unit: "share",
        better: Better::Higher,
        precision: Precision::Exact,
        value: |e| Some(flag(e.comparison.as_ref()?.is_exact())),
    },
    Metric {
        name: "edge_precision",
        about: "how many of the edges found are true; 1 if none was found",
        unit: "share",
        better: Better::Higher,
        precision: Precision::Exact,
        value: |e| {
            let c = e.comparison.as_ref()?;
            Some(share(c.correct.len(), c.correct.len() + c.wrong.len()))
        },
    },
    Metric {
        name: "edge_recall",
        about: "how many of the true edges were found; 1 if there is none",
        unit: "share",
        better: Better::Higher,
        precision: Precision::Exact,
        value: |e| {
            let c = e.comparison.as_ref()?;
            Some(share(c.correct.len(), c.correct.len() + c.missing.len()))
        },
    },
    Metric {
        name: "topology",
        about: "1 if there are as many closed, open and branching components as there should be, else 0",
        unit: "share",
        better: Better::Higher,
        precision: Precision::Exact,
        value: |e| Some(flag(e.topology.agrees_with(&e.true_topology))),
    },
    Metric {
        name: "closed_off",
        about: "closed components too many or too few",
        unit: "components",
        better: Better::Lower,
        precision: Precision::Exact,
        value: |e| Some(apart(e.topology.closed, e.true_topology.closed)),
    },
    Metric {
        name: "open_off",
        about: "open components too many or too few",
        unit: "components",
        better: Better::Lower,
        precision: Precision::Exact,
        value: |e| Some(apart(e.topology.open, e.true_topology.open)),
    },
    Metric {
        name: "degree_0",
        about: "vertices without an edge",
        unit: "vertices",
        better: Better::Neither,
        precision: Precision::Exact,
        value: |e| Some(count(e.topology.degrees[0])),
    },
    Metric {
        name: "degree_1",
        about: "vertices with one edge: ends",
        unit: "vertices",
        better: Better::Neither,
        precision: Precision::Exact,
        value: |e| Some(count(e.topology.degrees[1])),
    },
    Metric {
        name: "degree_2",
        about: "vertices with two edges",
        unit: "vertices",
        better: Better::Neither,
        precision: Precision::Exact,
        value: |e| Some(count(e.topology.degrees[2])),
    },
    Metric {
        name: "degree_3",
        about: "vertices with three edges or more: junctions",
        unit: "vertices",
        better: Better::Neither,
        precision: Precision::Exact,
        value: |e| Some(count(e.topology.degrees[3])),
    },
    Metric {
        name: "hausdorff",
        about: "the larger of the next two",
        unit: "extents",
        better: Better::Lower,
        precision: Precision::Bounded,
        value: |e| Some(e.distances.hausdorff.distance().over(e.extent)),
    },
    Metric {
        name: "hausdorff_curve",
        about: "the largest distance of a point of the curve to the output: what was missed",
        unit: "extents",
        better: Better::Lower,
        precision: Precision::Bounded,
        value: |e| Some(e.distances.hausdorff.curve_to_polygon.over(e.extent)),
    },
    Metric {
        name: "hausdorff_output",
        about: "the largest distance of a point of the output to the curve: what was made up",
        unit: "extents",
        better: Better::Lower,
        precision: Precision::Bounded,
        value: |e| Some(e.distances.hausdorff.polygon_to_curve.over(e.extent)),
    },
    Metric {
        name: "rms_curve",
        about: "the root mean square distance of the curve to the output",
        unit: "extents",
        better: Better::Lower,
        precision: Precision::Bounded,
        value: |e| Some(e.distances.rms.curve_to_polygon.over(e.extent)),
    },
    Metric {
        name: "rms_output",
        about: "the root mean square distance of the output to the curve",
        unit: "extents",
        better: Better::Lower,
        precision: Precision::Bounded,
        value: |e| Some(e.distances.rms.polygon_to_curve.over(e.extent)),
    },
    Metric {
        name: "min_angle",
        about: "the least angle between two edges at a vertex",
        unit: "degrees",
        better: Better::Neither,
        precision: Precision::Exact,
        value: |e| e.least_angle.map(Bounds::exactly),
    },
    Metric {
        name: "run_time",
        about: "the time that the reconstruction took",
        unit: "s",
        better: Better::Lower,
        precision: Precision::Timed,
        value: |e| e.seconds.map(Bounds::exactly),
    },
];

fn flag(holds: bool) -> Bounds {
    Bounds::exactly(f64::from(u8::from(holds)))
}

fn count(n: usize) -> Bounds {
    Bounds::exactly(n as f64)
}

fn apart(found: usize, wanted: usize) -> Bounds {
    count(found.abs_diff(wanted))
}

fn share(part: usize, whole: usize) -> Bounds {
    Bounds::exactly(if whole == 0 {
        1.0
    } else {
        part as f64 / whole as f64
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_crate_doc_lists_every_metric() {
        let row = |m: &Metric| {
            let better = match m.better {
                Better::Higher => "higher",
                Better::Lower => "lower",
                Better::Neither => "",
            };
            let precision = match m.precision {
                Precision::Exact => "exact",
                Precision::Bounded => "between bounds",
                Precision::Timed => "by a clock",
            };
            format!(
                "//! | `{}` | {} | {} | {better} | {precision} |\n",
                m.name, m.about, m.unit
            )
        };
        let rows: String = METRICS.iter().map(row).collect();
        let doc = include_str!("lib.rs");
        let (_, after) = doc.split_once("//! |---|---|---|---|---|\n").unwrap();
        let table = after.split_once("//!\n").unwrap().0;
        assert_eq!(table, rows, "paste into lib.rs:\n{rows}");
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = METRICS.iter().map(|m| m.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), METRICS.len());
    }
}
