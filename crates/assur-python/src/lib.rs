//! The compiled part of the Python package: glue between Python and the library.

mod batches;
mod columns;
mod errors;
mod import;
mod numbers;
mod problem;
mod solving;
mod tools;
mod values;
mod workers;

use pyo3::prelude::*;

/// The compiled part of `assur`.
#[pymodule(gil_used = false)]
fn _assur(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<problem::Problem>()?;
    module.add_class::<columns::Columns>()?;
    module.add_class::<batches::Batch>()?;
    module.add_class::<batches::Batches>()?;
    module.add_class::<numbers::Numbers>()?;
    module.add_function(wrap_pyfunction!(batches::batches, module)?)?;
    module.add_function(wrap_pyfunction!(tools::format, module)?)?;
    module.add_function(wrap_pyfunction!(tools::explain, module)?)?;
    module.add_function(wrap_pyfunction!(tools::grade, module)?)?;
    module.add_function(wrap_pyfunction!(tools::pictures, module)?)?;
    module.add_function(wrap_pyfunction!(tools::program, module)?)?;
    Ok(())
}
