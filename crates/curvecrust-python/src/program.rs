//! `python -m curvecrust` is the program.

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the program on arguments, the first of which is its name, and returns its exit code.
/// `again` are the words of a command that starts it again.
#[pyfunction]
pub(crate) fn run(py: Python<'_>, args: Vec<OsString>, again: Vec<OsString>) -> u8 {
    py.detach(|| curvecrust_cli::run_on(args, again))
}
