//! Solves one assembled position: motion, loads, forces, friction, residuals, and what deserves a warning.

use super::assemble::{group_labels, group_name};
use super::error::{SolveError, label};
use super::positions::Wanted;
use super::residual::residuals;
use super::solution::{Residuals, Solved};
use super::state::State;
use super::sweep::Run;
use super::track::Tracker;
use super::view::View;
use crate::model::{PairId, PairKind, Query, Value};
use crate::plan::Level;

/// Below this condition a warning tells how many digits are left.
const WARN: f64 = 1e-3;

/// At and below this condition velocities and forces do not exist.
const DEAD: f64 = 1e-12;

impl Run<'_, '_> {
    /// Motion, loads, forces and residuals at an assembled position.
    pub(super) fn solved(&mut self, tracker: &Tracker, pose: &Wanted) -> Result<Solved, SolveError> {
        let scene = self.scene;
        let mut state = tracker.state.clone();
        self.rates.at(&pose.drives, &mut state.inputs);
        match scene.plan.effects.level {
            Level::Positions => state.run_motion::<0>(scene.plan),
            Level::Velocities => state.run_motion::<1>(scene.plan),
            Level::Accelerations => state.run_motion::<2>(scene.plan),
        }
        let moves = scene.plan.effects.level > Level::Positions;
        let mut condition = self.motion_condition(&state, pose, moves)?;
        if scene.plan.effects.forces {
            condition = condition.min(self.forces(&mut state, &tracker.angles, pose)?);
        }
        let frictionless = scene.plan.effects.friction.then(|| {
            let mut state = state.clone();
            state.wrenches.clone_from(&state.applied);
            state.frictions.fill(0.0);
            state.locked = false;
            state.run_forces_without_friction(scene.plan);
            let values = View::new(scene, &state, &tracker.angles, &self.statics).all_quantities();
            Box::new((state, values))
        });
        if state.locked {
            state.forget_forces();
        } else if !is_finite(&state) {
            return Err(self.not_finite(pose));
        }
        let mut residuals = residuals(scene, &state);
        if state.locked {
            residuals = Residuals { equilibrium: None, power: None, ..residuals };
        }
        let angles = tracker.angles.clone();
        let mut solved = Solved { state, frictionless, quantities: Vec::new(), angles, residuals, condition };
        let ideal = solved.frictionless.as_deref().map(|(state, values)| (state, values.as_slice()));
        let view = View::new(scene, &solved.state, &solved.angles, &self.statics);
        solved.quantities = View { frictionless: ideal, ..view }.all_quantities();
        self.warn_contacts(&solved, pose);
        self.note_friction(&solved, pose);
        Ok(solved)
    }

    fn motion_condition(&mut self, state: &State, pose: &Wanted, moves: bool) -> Result<f64, SolveError> {
        let mut least = 1.0_f64;
        for (group, sine) in state.sines.iter().enumerate() {
            let condition = sine.abs();
            least = least.min(condition);
            if moves && is_dead(condition) {
                return Err(SolveError::DeadPosition {
                    pose: self.place(pose),
                    group: group_name(self.scene, group),
                    condition,
                    labels: group_labels(self.scene, group),
                });
            }
            if condition < WARN && self.worst.as_ref().is_none_or(|w| condition < w.0) {
                let warning = SolveError::IllConditioned {
                    pose: self.place(pose),
                    group: group_name(self.scene, group),
                    condition,
                    digits: digits_left(condition),
                    labels: group_labels(self.scene, group),
                };
                self.worst = Some((condition, warning));
            }
        }
        Ok(least)
    }

    fn forces(&mut self, state: &mut State, angles: &[f64], pose: &Wanted) -> Result<f64, SolveError> {
        let scene = self.scene;
        let view = View::new(scene, state, angles, &self.statics);
        let motion = view.all_quantities();
        View { quantities: &motion, ..view }.evaluated_loads(&mut self.evaluated);
        state.run_loads(scene, &self.evaluated);
        state.applied.clone_from(&state.wrenches);
        state.set_lines(scene);
        state.locked = false;
        if scene.plan.effects.friction {
            state.set_senses(scene.plan);
        }
        state.run_forces(scene.plan);
        let mut least = 1.0_f64;
        for (index, sine) in state.force_sines.iter().enumerate() {
            least = least.min(sine.abs());
            if is_dead(sine.abs()) {
                let pairs = scene.structure.forces[index].joints.iter();
                let labels = pairs
                    .map(|j| scene.mechanism.pair(scene.structure.replaced.joint(j.joint).pair))
                    .map(|p| label("in this group", p.span))
                    .collect();
                let (pose, condition) = (self.place(pose), sine.abs());
                return Err(SolveError::EffortCannotHold { pose, condition, labels });
            }
        }
        Ok(least)
    }

    fn warn_contacts(&mut self, solved: &Solved, pose: &Wanted) {
        if !self.scene.plan.effects.forces {
            return;
        }
        let place = self.place(pose);
        for (i, pair) in self.scene.mechanism.pairs.iter().enumerate() {
            let PairKind::Contact { first, .. } = &pair.kind else { continue };
            let view = View::new(self.scene, &solved.state, &solved.angles, &self.statics);
            let Value::Scalar(normal) = view.query(&Query::Normal(PairId::at(i), first.link)) else {
                continue;
            };
            let force = view.reaction(PairId::at(i), first.link).norm();
            if normal < -1e-9 * force.max(f64::MIN_POSITIVE) && normal < -1e-9 {
                self.warnings.push(SolveError::ContactPulls {
                    name: pair.name.clone(),
                    pose: place.clone(),
                    normal,
                    span: pair.span.into(),
                });
            }
        }
    }
}

fn is_dead(condition: f64) -> bool {
    condition <= DEAD || condition.is_nan()
}

/// Digits left in accelerations and forces: the error grows as ε/σ³.
fn digits_left(condition: f64) -> u32 {
    let digits = -(f64::EPSILON.log10()) + 3.0 * condition.max(f64::MIN_POSITIVE).log10();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    {
        digits.clamp(0.0, 16.0) as u32
    }
}

fn is_finite(state: &State) -> bool {
    let body = |b: &super::state::BodyState| {
        [b.p.x, b.p.y, b.u.x, b.u.y, b.v.x, b.v.y, b.omega, b.a.x, b.a.y, b.alpha]
            .iter()
            .all(|x| x.is_finite())
    };
    state.bodies.iter().all(body)
        && state.reactions.iter().all(|r| (r.force.x + r.force.y + r.couple).is_finite())
        && state.efforts.iter().all(|e| e.is_finite())
}
