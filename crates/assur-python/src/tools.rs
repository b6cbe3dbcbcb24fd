//! What needs no problem.

use crate::errors;
use assur::{GradeError, Marking};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use std::ffi::OsString;

/// A text in the one style.
#[pyfunction]
pub fn format(py: Python<'_>, text: &str) -> PyResult<String> {
    py.detach(|| assur::format(text)).map_err(|diagnostics| errors::problem(py, &diagnostics))
}

/// The page of a code, in Markdown.
#[pyfunction]
pub fn explain(code: &str) -> PyResult<&'static str> {
    assur::explain(code).map_err(|near| {
        let help = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
        PyKeyError::new_err(format!("no diagnostic has the code `{code}`{help}"))
    })
}

/// Answers marked by a key, both as comma-separated values: JSON.
#[pyfunction]
pub fn grade(
    py: Python<'_>,
    key: &str,
    answers: &str,
    within: Option<f64>,
    only_answered: bool,
    points: Option<String>,
    credit: Option<String>,
) -> PyResult<String> {
    let marking = Marking { within, only_answered, points, credit };
    py.detach(|| assur::grade(key, answers, &marking)).map_err(|error| match error {
        GradeError::Diagnostics(diagnostics) => errors::problem(py, &diagnostics),
        GradeError::Rules(why) => PyValueError::new_err(why),
    })
}

/// The names of the kinds of pictures.
#[pyfunction]
pub fn pictures() -> Vec<&'static str> {
    assur::Problem::pictures().collect()
}

/// Runs the program with its arguments; its exit status.
#[pyfunction]
pub fn program(py: Python<'_>, args: Vec<OsString>) -> u8 {
    py.detach(|| assur::internals::cli::status(args))
}
