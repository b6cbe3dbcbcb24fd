//! Loads whose values depend on the position.

use super::view::View;
use super::whole_cycle::Statics;
use crate::model::{LoadId, Query, Value};
use crate::plan::LoadStep;
use crate::position::{Scene, State};

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

/// Loads and forces of a state whose motion is known; `quantities` where loads may name quantities of the file.
pub(crate) fn balanced(
    scene: &Scene<'_>,
    statics: &Statics,
    state: &mut State,
    angles: &[f64],
    evaluated: &mut Vec<(LoadId, Value)>,
    quantities: bool,
) {
    evaluated.clear();
    if scene.plan.loads.iter().any(|load| matches!(load, LoadStep::Evaluated(_))) {
        let view = View::new(scene, state, angles, statics);
        let motion = if quantities { view.all_quantities() } else { Vec::new() };
        View { quantities: &motion, ..view }.evaluated_loads(evaluated);
    }
    state.run_loads_and_forces(scene, evaluated);
}
