//! Points to curves.

use crate::arrays::{self, Arrays, int};
use crate::errors::value_error;
use crate::methods::method;
use crate::work::Run;
use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet};
use curvecrust::reconstruct::{Known, Reconstruction, Shape, ViolationReport};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::num::{NonZeroU32, NonZeroUsize};

/// The arguments beside the points.
#[derive(FromPyObject)]
pub(crate) struct Arguments {
    #[pyo3(item)]
    method: String,
    #[pyo3(item)]
    closed: Option<bool>,
    #[pyo3(item)]
    curves: Option<NonZeroU32>,
    #[pyo3(item)]
    termini: Vec<usize>,
    #[pyo3(item)]
    merge_within: Option<f64>,
    #[pyo3(item)]
    threads: Option<NonZeroUsize>,
}

/// The points that are reconstructed, and where they stand in what was given.
pub(crate) struct Input {
    pub(crate) points: PointSet,
    /// The row of every point; empty where nothing was merged.
    rows: Vec<usize>,
    /// The point of every row; empty where nothing was merged.
    ids: Vec<PointId>,
}

impl Input {
    pub(crate) fn new(points: Vec<DVec2>, merge_within: Option<f64>) -> PyResult<Self> {
        let Some(distance) = merge_within else {
            return Ok(Self {
                points: PointSet::new(points).map_err(value_error)?,
                rows: Vec::new(),
                ids: Vec::new(),
            });
        };
        let merged = PointSet::merging_within(points, distance).map_err(value_error)?;
        Ok(Self {
            points: merged.points,
            rows: merged.origin,
            ids: merged.representative,
        })
    }

    /// The point of a row, of which there are as many as points were given.
    pub(crate) fn id(&self, row: usize) -> PointId {
        let id = self.ids.get(row).copied().or(PointId::new(row));
        // Points that are more than such ids hold are refused before.
        id.unwrap_or(PointId::from(u32::MAX))
    }

    pub(crate) fn row(&self, id: PointId) -> i64 {
        int(self.rows.get(id.index()).copied().unwrap_or(id.index()))
    }

    fn rows(&self, ids: &[PointId]) -> Vec<i64> {
        ids.iter().map(|&id| self.row(id)).collect()
    }

    fn known(&self, arguments: &Arguments) -> PyResult<Known> {
        let count = self.points.len().max(self.ids.len());
        let id = |&row: &usize| {
            let id = self.ids.get(row).copied().or(PointId::new(row));
            id.filter(|_| row < count).ok_or_else(|| {
                value_error(format!("terminus {row} names no point: there are {count}"))
            })
        };
        Ok(Known {
            shape: shape(arguments.closed),
            curves: arguments.curves,
            termini: arguments.termini.iter().map(id).collect::<PyResult<_>>()?,
        })
    }

    /// The rows of points that others stand for, and of those others.
    fn duplicates(&self) -> Vec<[i64; 2]> {
        let rows = self.ids.iter().enumerate();
        let pairs = rows.map(|(row, &id)| [int(row), self.row(id)]);
        pairs.filter(|[row, first]| row != first).collect()
    }
}

/// The shape that all curves have, if the caller knows it.
pub(crate) fn shape(closed: Option<bool>) -> Option<Shape> {
    closed.map(|closed| if closed { Shape::Closed } else { Shape::Open })
}

/// Curves through points, as arrays of rows.
#[pyfunction]
pub(crate) fn reconstruct<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    arguments: Arguments,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let algorithm = method(&arguments.method)?;
    let points = arrays::points(&points)?;
    let run = Run {
        py,
        threads: arguments.threads,
        progress: progress.as_ref(),
    };
    let (input, found) = run.work(move |_| {
        let input = Input::new(points, arguments.merge_within)?;
        let known = input.known(&arguments)?;
        let found = Reconstruction::by_known(algorithm, &input.points, &known);
        Ok((input, found.map_err(value_error)?))
    })?;
    curves(py, &input, &found)
}

fn curves<'py>(
    py: Python<'py>,
    input: &Input,
    found: &Reconstruction,
) -> PyResult<Bound<'py, PyDict>> {
    let chains = found.chains();
    let mut indices = Vec::with_capacity(input.points.len());
    let mut offsets = Vec::with_capacity(chains.len() + 1);
    offsets.push(0);
    for nested in chains {
        indices.extend(nested.chain.vertices().iter().map(|&v| input.row(v)));
        offsets.push(int(indices.len()));
    }
    let edges = found.edges().edges().iter();
    Arrays::new(py)
        .with("indices", indices)?
        .with("offsets", offsets)?
        .with(
            "closed",
            chains.iter().map(|c| c.chain.is_closed()).collect(),
        )?
        .with(
            "nesting",
            chains
                .iter()
                .map(|c| c.nesting.map_or(-1, i64::from))
                .collect(),
        )?
        .with(
            "parents",
            chains.iter().map(|c| c.parent.map_or(-1, int)).collect(),
        )?
        .with_rows("edges", edges.map(|edge| edge.ends().map(|v| input.row(v))))?
        .with("leaves", input.rows(&found.leaves()))?
        .with("isolated", input.rows(&found.isolated()))?
        .with("junctions", input.rows(&found.junctions()))?
        .with_rows("duplicates", input.duplicates().into_iter())
        .map(Arrays::finish)
}

/// Why every edge is there, and what else an open end could have been joined to; `None` for an
/// algorithm that does not say.
#[pyfunction]
pub(crate) fn explain<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    arguments: Arguments,
) -> PyResult<Option<Bound<'py, PyDict>>> {
    let algorithm = method(&arguments.method)?;
    let points = arrays::points(&points)?;
    let run = Run {
        py,
        threads: arguments.threads,
        progress: None,
    };
    let (input, why) = run.work(move |_| {
        let input = Input::new(points, arguments.merge_within)?;
        let known = input.known(&arguments)?;
        let why = algorithm.explain_known(&input.points, &known);
        Ok((input, why.map_err(value_error)?))
    })?;
    let Some(why) = why else {
        return Ok(None);
    };
    let rejected = |end: &curvecrust::reconstruct::FreeEnd| {
        end.rejected
            .map_or((-1, f64::NAN), |r| (input.row(r.partner), r.cost_at_most))
    };
    let edges = why.edges.iter();
    Arrays::new(py)
        .with_rows(
            "edges",
            edges.clone().map(|e| e.edge.ends().map(|v| input.row(v))),
        )?
        .with_value(
            "reasons",
            edges.clone().map(|e| e.reason.name()).collect::<Vec<_>>(),
        )?
        .with(
            "margins_at_most",
            edges
                .map(|e| e.margin_at_most.unwrap_or(f64::NAN))
                .collect(),
        )?
        .with(
            "ends",
            why.free_ends
                .iter()
                .map(|end| input.row(end.point))
                .collect(),
        )?
        .with(
            "penalties",
            why.free_ends.iter().map(|end| end.penalty).collect(),
        )?
        .with(
            "rejected",
            why.free_ends.iter().map(|end| rejected(end).0).collect(),
        )?
        .with(
            "costs_at_most",
            why.free_ends.iter().map(|end| rejected(end).1).collect(),
        )
        .map(|arrays| Some(arrays.finish()))
}

/// Where edges show that points are too sparse.
#[pyfunction]
pub(crate) fn violations<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    edges: PyReadonlyArray2<'py, i64>,
) -> PyResult<Bound<'py, PyDict>> {
    let points = arrays::points(&points)?;
    let edges = arrays::edges(&edges, points.len())?;
    let report = Run::plain(py).work(move |_| {
        // Rows that were merged into others have no edge here.
        let merged = PointSet::merging_duplicates(points).map_err(value_error)?;
        let ends = edges.edges().iter().map(|edge| {
            let ends = edge.ends().map(|v| merged.representative[v.index()]);
            curvecrust::geometry::Edge::new(ends[0], ends[1])
        });
        let set = curvecrust::geometry::EdgeSet::new(merged.points.len(), ends.flatten());
        let report = ViolationReport::new(&merged.points, &set).map_err(value_error)?;
        let row = |id: PointId| int(merged.origin.get(id.index()).copied().unwrap_or(id.index()));
        let joints = report.joints.iter();
        Ok((
            joints
                .clone()
                .map(|joint| row(joint.vertex))
                .collect::<Vec<_>>(),
            joints
                .clone()
                .map(|joint| joint.neighbours.map(row))
                .collect::<Vec<_>>(),
            joints
                .clone()
                .map(|joint| joint.degrees)
                .collect::<Vec<_>>(),
            joints.map(|joint| joint.length_ratio).collect::<Vec<_>>(),
        ))
    })?;
    let (vertices, neighbours, degrees, ratios) = report;
    Arrays::new(py)
        .with("points", vertices)?
        .with_rows("neighbours", neighbours.into_iter())?
        .with("degrees", degrees)?
        .with("length_ratios", ratios)
        .map(Arrays::finish)
}
