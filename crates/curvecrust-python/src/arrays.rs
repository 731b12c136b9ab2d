//! Arrays of numpy from and to what the libraries take and return.

use curvecrust::DVec2;
use curvecrust::geometry::{Edge, EdgeSet, PointId};
use numpy::{Element, IntoPyArray, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The rows of an array of two columns, of any strides.
pub(crate) fn points(array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<DVec2>> {
    if array.shape()[1] != 2 {
        let [rows, columns] = [array.shape()[0], array.shape()[1]];
        let message = format!("points must have shape (n, 2), not ({rows}, {columns})");
        return Err(PyValueError::new_err(message));
    }
    let rows = array.as_array();
    Ok(match rows.as_slice() {
        Some(flat) => flat.chunks_exact(2).map(DVec2::from_slice).collect(),
        None => rows
            .rows()
            .into_iter()
            .map(|row| DVec2::new(row[0], row[1]))
            .collect(),
    })
}

/// The edges between points whose indices are the rows of an array of two columns.
pub(crate) fn edges(array: &PyReadonlyArray2<'_, i64>, count: usize) -> PyResult<EdgeSet> {
    let rows = array.as_array();
    let mut edges = Vec::with_capacity(rows.nrows());
    for (number, row) in rows.rows().into_iter().enumerate() {
        let id = |column: usize| {
            let index = row
                .get(column)
                .and_then(|&index| usize::try_from(index).ok());
            index.filter(|&index| index < count).and_then(PointId::new)
        };
        let edge = match (id(0), id(1)) {
            (Some(a), Some(b)) => Edge::new(a, b),
            _ => None,
        };
        edges.push(edge.ok_or_else(|| {
            let message = format!("edge {number} does not join two of the {count} points");
            PyValueError::new_err(message)
        })?);
    }
    Ok(EdgeSet::new(count, edges))
}

/// A result under construction: a dictionary of arrays.
pub(crate) struct Arrays<'py>(Bound<'py, PyDict>);

impl<'py> Arrays<'py> {
    pub(crate) fn new(py: Python<'py>) -> Self {
        Self(PyDict::new(py))
    }

    /// Adds an array of one dimension.
    pub(crate) fn with<T: Element>(self, name: &str, values: Vec<T>) -> PyResult<Self> {
        let array = values.into_pyarray(self.0.py());
        self.0.set_item(name, array)?;
        Ok(self)
    }

    /// Adds an array of rows of two columns.
    pub(crate) fn with_rows<T: Element + Copy>(
        self,
        name: &str,
        rows: impl ExactSizeIterator<Item = [T; 2]>,
    ) -> PyResult<Self> {
        let count = rows.len();
        let mut flat = Vec::with_capacity(2 * count);
        rows.for_each(|row| flat.extend(row));
        let array = flat.into_pyarray(self.0.py()).reshape([count, 2])?;
        self.0.set_item(name, array)?;
        Ok(self)
    }

    /// Adds any other value.
    pub(crate) fn with_value(self, name: &str, value: impl IntoPyObject<'py>) -> PyResult<Self> {
        self.0.set_item(name, value)?;
        Ok(self)
    }

    pub(crate) fn finish(self) -> Bound<'py, PyDict> {
        self.0
    }
}

/// An index as numpy has it.
#[expect(clippy::cast_possible_wrap, reason = "no array has 2^63 rows")]
pub(crate) fn int(index: usize) -> i64 {
    index as i64
}

/// Indices as numpy has them.
pub(crate) fn ints(indices: impl IntoIterator<Item = usize>) -> Vec<i64> {
    indices.into_iter().map(int).collect()
}
