//! Runs a mechanism through structure, plan and solve.

use assur::internals::math::Vec2;
use assur::internals::model::{Mechanism, Query, Value};
use assur::internals::plan::Plan;
use assur::internals::solve::{Failure, Model, PoseAnswers, Solution, Solved, solve};
use assur::internals::structure::Structure;

/// A mechanism with everything that comes of it.
pub struct Run {
    pub mechanism: Mechanism,
    pub structure: Structure,
    pub plan: Plan,
    pub solution: Result<Solution, Vec<Failure>>,
}

impl Run {
    /// Errors of structure are returned in words.
    pub fn new(mechanism: &Mechanism) -> Result<Self, String> {
        let mechanism = mechanism.clone();
        let (structure, _) =
            assur::internals::structure::structure(&mechanism).map_err(|e| format!("{e:?}"))?;
        let plan = assur::internals::plan::plan(&mechanism, &structure);
        let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
        let solution = solve(&model);
        Ok(Self { mechanism, structure, plan, solution })
    }

    pub fn model(&self) -> Model<'_> {
        Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan }
    }

    /// The state at a position, counted from 0; why there is none in words.
    pub fn solved(&self, pose: usize) -> Result<&Solved, String> {
        let solution = self.solution.as_ref().map_err(|e| format!("{e:?}"))?;
        let pose = solution.poses.get(pose).ok_or("no such pose")?;
        pose.outcome.as_ref().map_err(|e| format!("{e:?}"))
    }

    pub fn view(&self, pose: usize) -> Result<PoseAnswers<'_>, String> {
        let solved = self.solved(pose)?;
        let solution = self.solution.as_ref().map_err(|e| format!("{e:?}"))?;
        Ok(solution.view(&self.model(), solved))
    }
}

/// A number asked of a position.
pub fn scalar(view: &PoseAnswers<'_>, query: &Query) -> f64 {
    match view.query(query) {
        Value::Scalar(x) => x,
        _ => f64::NAN,
    }
}

/// A vector asked of a position.
pub fn vector(view: &PoseAnswers<'_>, query: &Query) -> Vec2 {
    match view.query(query) {
        Value::Vector(v) => v,
        _ => Vec2::new(f64::NAN, f64::NAN),
    }
}
