//! Errors of the library as exceptions.

use assur::{ColumnsError, Diagnostics, PositionsError};
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;

/// Codes of values from outside whose unit or kind does not fit.
const OUTSIDE: &str = "mech::request::set_value";
const UNITS: &str = "mech::unit::";

/// The exception of diagnostics: `assur.ProblemError`.
pub fn problem(py: Python<'_>, diagnostics: &Diagnostics) -> PyErr {
    raised(py, "ProblemError", diagnostics)
}

/// The same of values from outside: `assur.UnitError` where a unit does not fit.
pub fn outside(py: Python<'_>, diagnostics: &Diagnostics) -> PyErr {
    let of_unit = |code: &str| code == OUTSIDE || code.starts_with(UNITS);
    let first = diagnostics.iter().find(|d| d.severity == "error");
    let is_unit = first.and_then(|d| d.code.as_deref()).is_some_and(of_unit);
    raised(py, if is_unit { "UnitError" } else { "ProblemError" }, diagnostics)
}

fn raised(py: Python<'_>, name: &str, diagnostics: &Diagnostics) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let class = py.import("assur._errors")?.getattr(name)?;
        let exception = class.call1((diagnostics.to_string(), diagnostics.to_json()))?;
        Ok(PyErr::from_value(exception))
    };
    made().unwrap_or_else(|error| error)
}

/// The exception of a text that is solved in columns.
pub fn of_columns(py: Python<'_>, error: &ColumnsError) -> PyErr {
    match error {
        ColumnsError::Diagnostics(diagnostics) => problem(py, diagnostics),
        ColumnsError::Positions(error) => positions(error),
        ColumnsError::Stopped => PyKeyboardInterrupt::new_err(()),
    }
}

fn positions(error: &PositionsError) -> PyErr {
    PyValueError::new_err(error.to_string())
}
