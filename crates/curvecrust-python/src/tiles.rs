//! The steps of HNN-Crust and NN-Crust on tiles, for an engine that moves the arrays.
//!
//! Samples are rows of three words: the id, and the bits of x and y; so they are written and read
//! without a look at them. Open samples are rows of ten.

use crate::arrays::{self, Arrays};
use crate::errors::value_error;
use crate::work::Run;
use curvecrust::DVec2;
use curvecrust::geometry::Progress;
use curvecrust::tiles::{
    Area, Atlas, Axis, Claim, Cut, Lack, Method, OpenSample, Partition, Query, Sample, Samples,
    TilesError, joined, resolve, solve_tile,
};
use numpy::{
    IntoPyArray, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Words of a sample, and of an open sample.
const SAMPLE: usize = 3;
const OPEN: usize = 10;

/// No sample has this id.
const NONE: u64 = u64::MAX;

/// Cuts of the plane into about this many cells of equal shares of some points: for each node the
/// axis, 0 or 1, and the coordinate; 2 for a cell.
#[pyfunction]
pub(crate) fn tiles_cut<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    cells: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let points = arrays::points(&points)?;
    let cuts = Run::plain(py).work(move |_| Ok(Partition::of(points, cells).cuts()))?;
    let axis = |cut: &Option<Cut>| match cut.map(|cut| cut.axis) {
        Some(Axis::X) => 0u8,
        Some(Axis::Y) => 1,
        None => 2,
    };
    Arrays::new(py)
        .with("axes", cuts.iter().map(axis).collect())?
        .with(
            "at",
            cuts.iter().map(|cut| cut.map_or(0.0, |c| c.at)).collect(),
        )?
        .with("cells", areas(Partition::from_cuts(&cuts).cells()))
        .map(Arrays::finish)
}

/// Points as samples with ids from `start` on, those of each cell together; the samples of cell i
/// are those from `first[i]` to `first[i + 1]`.
#[pyfunction]
pub(crate) fn tiles_scatter<'py>(
    py: Python<'py>,
    axes: PyReadonlyArray1<'py, u8>,
    at: PyReadonlyArray1<'py, f64>,
    x: PyReadonlyArray1<'py, f64>,
    y: PyReadonlyArray1<'py, f64>,
    start: u64,
) -> PyResult<Bound<'py, PyDict>> {
    let both = axes.as_array().into_iter().zip(at.as_array());
    let cuts = both.map(|(&axis, &at)| match axis {
        0 => Some(Cut { axis: Axis::X, at }),
        1 => Some(Cut { axis: Axis::Y, at }),
        _ => None,
    });
    let partition = Partition::from_cuts(&cuts.collect::<Vec<_>>());
    let (x, y) = (x.as_array(), y.as_array());
    let points: Vec<DVec2> = (x.iter().zip(y)).map(|(&x, &y)| DVec2::new(x, y)).collect();
    let (samples, first) =
        Run::plain(py).work(move |_| Ok(by_cells(&partition, &points, start)))?;
    let count = samples.len() / SAMPLE;
    let samples = samples.into_pyarray(py).reshape([count, SAMPLE])?;
    Arrays::new(py)
        .with_value("samples", samples)?
        .with("first", first)
        .map(Arrays::finish)
}

/// The words of samples, sorted by their cells, and the first sample of each cell.
fn by_cells(partition: &Partition, points: &[DVec2], start: u64) -> (Vec<u64>, Vec<u64>) {
    let cells: Vec<usize> = points.iter().map(|&p| partition.cell_of(p)).collect();
    let mut first = vec![0; partition.cells().len() + 1];
    for &cell in &cells {
        first[cell + 1] += 1;
    }
    for cell in 1..first.len() {
        first[cell] += first[cell - 1];
    }
    let mut next = first.clone();
    let mut samples = vec![[0; SAMPLE]; points.len()];
    for ((id, &point), &cell) in (start..).zip(points).zip(&cells) {
        samples[next[cell]] = words_of(Sample { id, point });
        next[cell] += 1;
    }
    let first = first.into_iter().map(|at| at as u64).collect();
    (samples.into_flattened(), first)
}

/// What one tile decides, and what it leaves open.
#[pyfunction]
pub(crate) fn tiles_solve<'py>(
    py: Python<'py>,
    samples: PyReadonlyArray2<'py, u64>,
    cell: [f64; 4],
    method: &str,
    run_length: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let method = local(method)?;
    let samples = words::<SAMPLE>(&samples)?.map(sample).collect();
    let solve = move |_: &_| {
        let owned = Samples::new(samples).map_err(value_error)?;
        let solved = solve_tile(&owned, &[], area(cell), method).map_err(value_error)?;
        let open: Vec<u64> = solved.open().iter().flat_map(words_of_open).collect();
        let decided = solved.decided();
        let runs = areas(&owned.run_areas(run_length));
        let samples: Vec<u64> = owned.iter().flat_map(words_of).collect();
        Ok((samples, open, decided, runs))
    };
    let (samples, open, decided, runs) = Run::plain(py).work(solve)?;
    Arrays::new(py)
        .with("samples", samples)?
        .with("open", open)?
        .with("runs", runs)?
        .with_rows("edges", decided.edges.into_iter())?
        .with_rows("claims", decided.claims.into_iter().map(|c| [c.from, c.to]))
        .map(Arrays::finish)
}

/// The claims of the open samples of a tile, by asking the runs of all tiles; `read` returns the
/// samples of one by its number.
#[pyfunction]
pub(crate) fn tiles_ask<'py>(
    py: Python<'py>,
    left: PyReadonlyArray2<'py, u64>,
    cell: [f64; 4],
    method: &str,
    runs: PyReadonlyArray2<'py, f64>,
    read: Py<PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let rule = local(method)?.rule;
    let query = |open| Query::new(open, area(cell), rule);
    let queries = words::<OPEN>(&left)?.map(open_sample).map(query).collect();
    let runs = runs.as_array();
    let runs = runs.rows().into_iter().map(|row| {
        let corner = |i: usize| row.get(i).copied().unwrap_or(f64::NAN);
        area([corner(0), corner(1), corner(2), corner(3)])
    });
    let atlas = Atlas::new(runs.collect());
    let claims = Run::plain(py).work(move |_| {
        resolve(queries, &atlas, Progress::default(), |run| {
            Python::attach(|py| {
                let rows = read.bind(py).call1((run,))?;
                let rows: PyReadonlyArray2<'_, u64> = rows.extract()?;
                Ok(words::<SAMPLE>(&rows)?.map(sample).collect())
            })
        })
        .map_err(|error: Stopped| error.0)
    })?;
    Arrays::new(py)
        .with_rows("claims", claims.into_iter().map(|c| [c.from, c.to]))
        .map(Arrays::finish)
}

/// Edges and those that follow from claims, ascending.
#[pyfunction]
pub(crate) fn tiles_join<'py>(
    py: Python<'py>,
    edges: PyReadonlyArray2<'py, u64>,
    claims: PyReadonlyArray2<'py, u64>,
    method: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let keep = local(method)?.keep;
    let mut edges: Vec<[u64; 2]> = words::<2>(&edges)?.collect();
    let claims = words::<2>(&claims)?.map(|[from, to]| Claim { from, to });
    let claims: Vec<Claim> = claims.collect();
    let edges = Run::plain(py).work(move |_| {
        edges.extend(joined(claims, keep));
        // Those of each tile are in order.
        edges.sort();
        Ok(edges)
    })?;
    let columns = [0, 1].map(|column| edges.iter().map(|ends| ends[column]).collect());
    let [a, b]: [Vec<u64>; 2] = columns;
    Arrays::new(py)
        .with("a", a)?
        .with("b", b)
        .map(Arrays::finish)
}

/// Why an answer has to be given up: what Python raised, or the library.
struct Stopped(PyErr);

impl From<PyErr> for Stopped {
    fn from(error: PyErr) -> Self {
        Self(error)
    }
}

impl From<TilesError> for Stopped {
    fn from(error: TilesError) -> Self {
        Self(value_error(error))
    }
}

fn local(name: &str) -> PyResult<Method> {
    Method::of_name(name).ok_or_else(|| {
        let names: Vec<&str> = Method::ALL.iter().map(|(name, _)| *name).collect();
        value_error(format!(
            "'{name}' is no method for tiles: there are {}",
            names.join(", ")
        ))
    })
}

/// The rows of an array of this many columns.
fn words<const WORDS: usize>(
    array: &PyReadonlyArray2<'_, u64>,
) -> PyResult<impl Iterator<Item = [u64; WORDS]>> {
    if array.shape()[1] != WORDS {
        let message = format!("rows must have {WORDS} words, not {}", array.shape()[1]);
        return Err(PyValueError::new_err(message));
    }
    let rows = array.as_array();
    let rows: Vec<[u64; WORDS]> = match rows.as_slice() {
        Some(flat) => flat.as_chunks().0.to_vec(),
        None => rows
            .rows()
            .into_iter()
            .map(|row| std::array::from_fn(|i| row[i]))
            .collect(),
    };
    Ok(rows.into_iter())
}

fn sample([id, x, y]: [u64; SAMPLE]) -> Sample {
    let point = DVec2::new(f64::from_bits(x), f64::from_bits(y));
    Sample { id, point }
}

fn words_of(Sample { id, point }: Sample) -> [u64; SAMPLE] {
    [id, point.x.to_bits(), point.y.to_bits()]
}

fn open_sample([lacks, id, x, y, id0, x0, y0, id1, x1, y1]: [u64; OPEN]) -> OpenSample {
    let other = |words: [u64; SAMPLE]| Some(sample(words)).filter(|other| other.id != NONE);
    OpenSample {
        sample: sample([id, x, y]),
        lacks: if lacks == 0 {
            Lack::Nearest
        } else {
            Lack::Half
        },
        nearest: other([id0, x0, y0]),
        half: other([id1, x1, y1]),
    }
}

fn words_of_open(open: &OpenSample) -> [u64; OPEN] {
    let lacks = u64::from(open.lacks == Lack::Half);
    let other = |other: Option<Sample>| other.map_or([NONE; SAMPLE], words_of);
    let [id, x, y] = words_of(open.sample);
    let [id0, x0, y0] = other(open.nearest);
    let [id1, x1, y1] = other(open.half);
    [lacks, id, x, y, id0, x0, y0, id1, x1, y1]
}

fn area([left, below, right, above]: [f64; 4]) -> Area {
    Area {
        low: DVec2::new(left, below),
        high: DVec2::new(right, above),
    }
}

/// Areas one after the other: the least x and y, then the greatest.
fn areas(areas: &[Area]) -> Vec<f64> {
    let corners = areas.iter().flat_map(|area| [area.low, area.high]);
    corners.flat_map(|corner| corner.to_array()).collect()
}
