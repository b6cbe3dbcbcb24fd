//! Loads whose values depend on the position.

use super::view::View;
use crate::model::{LoadId, Query, Value};
use crate::plan::LoadStep;

impl View<'_> {
    /// Values of the loads that are evaluated at every position, in the order of the plan.
    pub fn evaluated_loads(&self, out: &mut Vec<(LoadId, Value)>) {
        out.clear();
        for step in &self.plan.loads {
            if let LoadStep::Evaluated(id) = step {
                out.push((*id, self.query(&Query::Load(*id))));
            }
        }
    }
}
