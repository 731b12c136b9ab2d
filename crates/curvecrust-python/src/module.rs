//! What Python sees of this crate.

/// Arrays in, arrays out; call the package `curvecrust` instead.
#[pyo3::pymodule]
mod _curvecrust {
    #[pymodule_export]
    use crate::curve::Curve;
    #[pymodule_export]
    use crate::evaluate::evaluate;
    #[pymodule_export]
    use crate::fit::{fit, polyline};
    #[pymodule_export]
    use crate::lfs::{check, lfs, medial_axis};
    #[pymodule_export]
    use crate::methods::methods;
    #[pymodule_export]
    use crate::program::run;
    #[pymodule_export]
    use crate::reconstruct::{explain, reconstruct, violations};
    #[pymodule_export]
    use crate::sample::sample;
    #[pymodule_export]
    use crate::tiles::{tiles_ask, tiles_cut, tiles_join, tiles_scatter, tiles_solve};

    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
