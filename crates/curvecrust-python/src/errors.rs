//! What Python raises.

use pyo3::PyErr;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use std::any::Any;
use std::fmt::Display;

/// A `ValueError` that says what the library says.
pub(crate) fn value_error(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A `RuntimeError` for a panic, which no input should cause.
pub(crate) fn defect(payload: &(dyn Any + Send)) -> PyErr {
    let message = payload.downcast_ref::<&str>().copied();
    let message = message.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    PyRuntimeError::new_err(format!(
        "this is a defect of curvecrust, please report it: {}",
        message.unwrap_or("no message")
    ))
}
