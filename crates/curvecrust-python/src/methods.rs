//! The algorithms by their names.

use crate::errors::value_error;
use curvecrust::reconstruct::{ALGORITHMS, Basis, Guarantee, Reconstructor};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The algorithm of this name.
pub(crate) fn method(name: &str) -> PyResult<&'static dyn Reconstructor> {
    let mut all = ALGORITHMS.iter().copied();
    all.find(|algorithm| algorithm.info().name == name)
        .ok_or_else(|| {
            let names: Vec<_> = ALGORITHMS
                .iter()
                .map(|algorithm| algorithm.info().name)
                .collect();
            value_error(format!(
                "no method is called '{name}': there are {}",
                names.join(", ")
            ))
        })
}

/// What is known of every algorithm.
#[pyfunction]
pub(crate) fn methods(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let list = PyList::empty(py);
    for algorithm in ALGORITHMS {
        let info = algorithm.info();
        let entry = PyDict::new(py);
        entry.set_item("name", info.name)?;
        entry.set_item("citation", info.citation)?;
        let guarantees: Vec<_> = info.guarantees.iter().map(Guarantee::to_string).collect();
        entry.set_item("guarantees", guarantees)?;
        entry.set_item("cost", info.cost)?;
        entry.set_item("takes_termini", info.honours_termini)?;
        entry.set_item("takes_shape", info.honours_known)?;
        entry.set_item("made_for", info.scope.to_string())?;
        entry.set_item("argued", info.basis == Basis::Argued)?;
        list.append(entry)?;
    }
    Ok(list)
}
