//! Positions of a solution with more digits than they were solved with.

use super::solution::{Solution, Solved};
use crate::position::Model;
use crate::reference::{Exact, Reference, exact, reference};

impl Solution {
    /// One of its positions with twice the digits, see [`exact`].
    #[must_use]
    pub fn exact(&self, model: &Model<'_>, solved: &Solved) -> Option<Exact> {
        let mut evaluated = Vec::new();
        self.view(model, solved).evaluated_loads(&mut evaluated);
        exact(model, &solved.state, &evaluated)
    }

    /// The reference of one of its positions.
    #[must_use]
    pub fn reference(&self, model: &Model<'_>, solved: &Solved) -> Option<Reference> {
        let mut evaluated = Vec::new();
        self.view(model, solved).evaluated_loads(&mut evaluated);
        reference(model, &solved.state, &evaluated)
    }
}
