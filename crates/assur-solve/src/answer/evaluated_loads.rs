//! Loads whose values depend on the position.

use super::pose_answers::PoseAnswers;
use super::whole_cycle::WholeCycle;
use crate::model::{LoadId, Query, Value};
use crate::plan::LoadStep;
use crate::position::{Model, State};

impl PoseAnswers<'_> {
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

/// Loads and forces of a state whose motion is known; `quantities` where loads may name quantities of the file.
pub(crate) fn balanced(
    model: &Model<'_>,
    statics: &WholeCycle,
    state: &mut State,
    angles: &[f64],
    evaluated: &mut Vec<(LoadId, Value)>,
    quantities: bool,
) {
    evaluated.clear();
    if model.plan.loads.iter().any(|load| matches!(load, LoadStep::Evaluated(_))) {
        let view = PoseAnswers::new(model, state, angles, statics);
        let motion = if quantities { view.all_quantities() } else { Vec::new() };
        PoseAnswers { quantities: &motion, ..view }.evaluated_loads(evaluated);
    }
    state.run_loads_and_forces(model, evaluated);
}
