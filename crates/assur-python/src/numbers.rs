//! A column of numbers that NumPy sees without a copy.

use arrow_buffer::ScalarBuffer;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Numbers in memory that are not changed any more: `numpy.asarray` makes a view of them.
#[pyclass(frozen, module = "assur")]
pub struct Numbers {
    values: ScalarBuffer<f64>,
}

impl Numbers {
    /// In this memory.
    pub const fn of(values: ScalarBuffer<f64>) -> Self {
        Self { values }
    }
}

#[pymethods]
impl Numbers {
    #[getter(__array_interface__)]
    fn array_interface<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let interface = PyDict::new(py);
        let read_only = true;
        interface.set_item("version", 3)?;
        interface.set_item("shape", (self.values.len(),))?;
        interface.set_item("typestr", if cfg!(target_endian = "big") { ">f8" } else { "<f8" })?;
        interface.set_item("data", (self.values.as_ptr().addr(), read_only))?;
        Ok(interface)
    }

    fn __len__(&self) -> usize {
        self.values.len()
    }

    fn __getitem__(&self, index: isize) -> PyResult<f64> {
        let count = isize::try_from(self.values.len()).unwrap_or(isize::MAX);
        let index = usize::try_from(if index < 0 { index + count } else { index });
        let found = index.ok().and_then(|index| self.values.get(index));
        found.copied().ok_or_else(|| pyo3::exceptions::PyIndexError::new_err("there is no such position"))
    }

    /// The address of the first number.
    #[getter]
    fn address(&self) -> usize {
        self.values.as_ptr().addr()
    }
}
