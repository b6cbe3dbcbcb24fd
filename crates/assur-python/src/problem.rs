//! A problem: a text with values from outside.

use crate::batches::Batches;
use crate::columns::Columns;
use crate::errors;
use crate::import::{GivenColumn, Reader, of_arrow, of_bytes, of_columns};
use crate::solving::Form;
use crate::workers::Crew;
use arrow_array::RecordBatchReader;
use assur::{Checked, ColumnsError, Diagnostics, DrawError, DrivePositions, Options};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::OnceLock;

/// A text, read once.
#[pyclass(frozen, module = "assur")]
pub struct Problem {
    problem: assur::Problem,
    /// It has values from outside.
    set: bool,
    checked: OnceLock<Result<Checked, Diagnostics>>,
}

/// Positions of a drive: the bytes of numbers and whether they are points, or a list.
#[derive(FromPyObject)]
enum Given<'py> {
    Bytes(Bound<'py, PyBytes>, bool),
    List(Vec<f64>),
}

impl Given<'_> {
    fn positions(self) -> DrivePositions {
        let (bytes, points) = match self {
            Self::List(numbers) => return DrivePositions::Numbers(numbers),
            Self::Bytes(bytes, points) => (bytes, points),
        };
        let numbers = of_bytes(&bytes);
        if points {
            DrivePositions::Points(numbers.as_chunks::<2>().0.to_vec())
        } else {
            DrivePositions::Numbers(numbers)
        }
    }
}

#[pymethods]
impl Problem {
    #[new]
    fn new(
        py: Python<'_>,
        text: &str,
        name: &str,
        set: Vec<(String, String)>,
        within: Option<f64>,
    ) -> PyResult<Self> {
        if let Some(within) = within.filter(|within| !(*within > 0.0 && within.is_finite())) {
            return Err(PyValueError::new_err(format!("`within` must be a number above 0, but is {within}")));
        }
        let is_set = !set.is_empty();
        let options = Options { set, within };
        let problem = py.detach(|| assur::Problem::new(name, text).with(options));
        Ok(Self { problem, set: is_set, checked: OnceLock::new() })
    }

    /// Raises the diagnostics of a text with errors.
    fn compile(&self, py: Python<'_>) -> PyResult<()> {
        self.checked(py).map(drop)
    }

    /// Structure, effects and diagnostics as JSON.
    fn check(&self, py: Python<'_>) -> String {
        py.detach(|| self.problem.check_json())
    }

    /// The program's document as JSON.
    fn document(&self, py: Python<'_>) -> String {
        py.detach(|| self.problem.solve_json())
    }

    /// Drives: name, whether it carries a point, unit of its positions.
    fn drives(&self, py: Python<'_>) -> PyResult<Vec<(String, bool, String)>> {
        let drives = self.checked(py)?.drives();
        Ok(drives.into_iter().map(|drive| (drive.name, drive.is_point, drive.unit)).collect())
    }

    /// Solves the problem at its positions, or at those given.
    fn solve(
        &self,
        py: Python<'_>,
        given: Option<Vec<(Option<String>, Given<'_>)>>,
        threads: Option<usize>,
    ) -> PyResult<Columns> {
        let checked = self.checked(py)?;
        let crew = Crew::of(threads);
        let found = match given {
            None => py.detach(|| checked.columns(&crew)),
            Some(given) => {
                let given = given.into_iter().map(|(name, given)| (name, given.positions())).collect();
                py.detach(|| checked.columns_at(given, &crew))
            }
        };
        found.map(Columns::of).map_err(|error| match (error, crew.error()) {
            (ColumnsError::Stopped, Some(error)) => error,
            (error, _) => errors::of_columns(py, &error),
        })
    }

    /// Compares the answers with the expectations: diagnostics in words and as JSON.
    fn test(&self, py: Python<'_>) -> (String, String) {
        let found = py.detach(|| self.problem.test());
        (found.to_string(), found.to_json())
    }

    /// Solves the rows of a table with the C interface of Arrow.
    fn batch_arrow(
        &self,
        py: Python<'_>,
        table: &Bound<'_, PyAny>,
        form: (bool, bool, Option<usize>),
    ) -> PyResult<Batches> {
        self.batch(py, of_arrow(table)?, form.into())
    }

    /// Solves the rows of a mapping of columns.
    fn batch_columns(
        &self,
        py: Python<'_>,
        columns: Vec<(String, GivenColumn<'_>)>,
        form: (bool, bool, Option<usize>),
    ) -> PyResult<Batches> {
        self.batch(py, of_columns(columns)?, form.into())
    }

    /// Draws pictures of a kind.
    fn draw(&self, py: Python<'_>, kind: &str, pose: Option<&str>) -> PyResult<Vec<String>> {
        py.detach(|| self.problem.draw(kind, pose)).map_err(|error| match error {
            DrawError::Diagnostics(diagnostics) => errors::problem(py, &diagnostics),
            DrawError::Kind(near) => {
                let help = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
                PyValueError::new_err(format!("no kind of picture is called `{kind}`{help}"))
            }
        })
    }
}

impl Problem {
    fn checked(&self, py: Python<'_>) -> PyResult<&Checked> {
        let checked = match self.checked.get() {
            Some(checked) => checked,
            // another thread may find the same meanwhile, and wait for the GIL: it must not wait here
            None => {
                let found = py.detach(|| self.problem.checked());
                self.checked.get_or_init(|| found)
            }
        };
        let raised = if self.set { errors::outside } else { errors::problem };
        checked.as_ref().map_err(|diagnostics| raised(py, diagnostics))
    }

    fn batch(&self, py: Python<'_>, reader: Reader, form: Form) -> PyResult<Batches> {
        let header: Vec<(String, Option<String>)> = reader
            .schema()
            .fields()
            .iter()
            .map(|field| (field.name().clone(), field.metadata().get("unit").cloned()))
            .collect();
        let rows = py.detach(|| self.problem.rows(&header)).map_err(|d| errors::outside(py, &d))?;
        Batches::of(py, rows, reader, form)
    }
}
