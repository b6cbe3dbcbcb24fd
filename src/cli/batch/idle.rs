//! What one thread has found out about the rows of a file serves the next.

use crate::pipeline::VariantSolver;
use std::sync::{Mutex, PoisonError};

/// Solvers that no thread uses at the moment: what one has found out about the rows serves the next.
#[derive(Default)]
pub struct Idle<'r>(Mutex<Vec<VariantSolver<'r>>>);

impl<'r> Idle<'r> {
    pub fn take(&self) -> Option<VariantSolver<'r>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).pop()
    }

    pub fn give(&self, solver: VariantSolver<'r>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(solver);
    }
}
