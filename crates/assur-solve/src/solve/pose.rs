//! Solves one assembled position: motion, loads, forces, friction, residuals, and what deserves a note.

use crate::answer::{LeftCurve, PoseAnswers, balanced};
use crate::position::{Model, PoseRequest, Residuals, State, residuals_in};
use crate::reference::exact;

use super::failure::{Cause, Failure, GroupId};
use super::lost::{not_finite, out_of_scale};
use super::note::Loss;
use super::regular;
use super::run::Run;
use super::simulate::Given;
use super::solution::Solved;
use super::track::Tracker;
use crate::model::{PairId, PairKind, Query, TransmissionKind, Value};
use crate::plan::{ForceStep, Precision};

/// Forces without friction over those with it, below which the mechanism is near self-locking.
const NEAR_LOCKING: f64 = 1e-3;

/// Refuses power that runs backwards through a belt whose slip is given: its speeds are those of the other direction.
fn slip_backwards(model: &Model<'_>, state: &State) -> Result<(), Cause> {
    for (law, force) in model.plan.laws.iter().zip(&state.forces.law_forces) {
        let PairKind::Transmission(t) = &model.mechanism.pair(law.pair).kind else { continue };
        if t.slip > 0.0 && force.multiplier != 0.0 && force.sides[0].abs() < force.sides[1].abs() {
            return Err(Cause::SlipBackwards(law.pair));
        }
    }
    Ok(())
}

impl Run<'_, '_> {
    /// Motion, loads, forces and residuals at an assembled position.
    pub(super) fn solved(&mut self, tracker: &Tracker, pose: &PoseRequest) -> Result<Solved, Failure> {
        self.solved_from(&tracker.state, &tracker.angles, pose, None)
    }

    /// As [`Run::solved`], from an assembled state with the angles of its bodies.
    pub(super) fn solved_from(
        &mut self,
        from: &State,
        angles: &[f64],
        pose: &PoseRequest,
        given: Option<&Given>,
    ) -> Result<Solved, Failure> {
        let mut solved = Solved::default();
        self.solve_into(from, (angles, pose), given, &mut solved)
            .map_err(|cause| Failure::at(pose, cause))?;
        Ok(solved)
    }

    /// As [`Run::solved_from`], in the memory of another position; where there is no solution it holds none.
    pub(super) fn solve_into(
        &mut self,
        from: &State,
        (angles, pose): (&[f64], &PoseRequest),
        given: Option<&Given>,
        solved: &mut Solved,
    ) -> Result<(), Cause> {
        let model = self.model;
        let mut state = self.memory.take().unwrap_or_else(|| Box::new(State::new(model.plan)));
        state.start_from(from);
        state.forces.clear();
        self.rates.at(&pose.drives, &mut state.motion.inputs);
        if let Some(instant) = &self.instant {
            instant.set(&mut state.motion);
        }
        state.run_planned_motion(model.plan);
        let put = given.map(|given| (given, given.put(&mut state)));
        let mut condition = match put {
            Some((given, _)) => given.condition,
            None => regular::of_motion(model, &state, &mut self.carried, &mut self.notes, pose)?,
        };
        if model.plan.effects.forces && put.is_none_or(|(_, forces)| !forces) {
            condition = condition.min(self.forces(&mut state, angles, pose)?);
        }
        if model.plan.settings.scalar == Precision::DoubleDouble && put.is_none() {
            self.with_twice_the_digits(&mut state);
        }
        let frictionless = model.plan.effects.loses().then(|| {
            let mut state = State::clone(&state);
            match given.and_then(|given| given.ideal.as_ref()) {
                Some(ideal) => state.forces.clone_from(ideal),
                None => state.run_again_without_friction(model.plan),
            }
            let values = PoseAnswers::new(model, &state, angles, &self.statics).all_quantities();
            Box::new((state.answer(), values))
        });
        if let (Some(free), false) = (&frictionless, state.forces.locked) {
            condition = condition.min(self.near_locking(&state, &free.0, pose));
        }
        if model.plan.effects.forces
            && let Some(spring) = state.first_spring_at_zero(model.mechanism)
        {
            return Err(Cause::SpringAtZero { spring });
        }
        if state.forces.locked {
            state.forget_forces();
        } else if let Some(lost) = not_finite(model, &state) {
            return Err(Cause::Lost(lost));
        }
        let mut residuals = residuals_in(model, &state, &mut self.totals);
        if state.forces.locked {
            residuals = Residuals { equilibrium: None, power: None, ..residuals };
        }
        if let Some(lost) = out_of_scale(&residuals) {
            return Err(Cause::Lost(lost));
        }
        state.answer_in(&mut solved.state);
        solved.state.other = self.instant.as_ref().and_then(|instant| instant.other(&state));
        self.memory = Some(state);
        solved.angles.clear();
        solved.angles.extend_from_slice(angles);
        (solved.frictionless, solved.residuals, solved.condition) = (frictionless, residuals, condition);
        let quantities = std::mem::take(&mut solved.quantities);
        let ideal = solved.frictionless.as_deref().map(|(state, values)| (state, values.as_slice()));
        let view = PoseAnswers::new(model, &solved.state, &solved.angles, &self.statics);
        solved.quantities = PoseAnswers { frictionless: ideal, ..view }.all_quantities_in(quantities);
        self.note_contacts(solved, pose);
        self.note_trains(solved, pose);
        let view = solved.view(model, &self.statics);
        if let Some(left) = self.left(&view) {
            return Err(Cause::CurveLeft(left));
        }
        self.friction.update(model, &view, pose);
        self.centres.update(&view, pose);
        Ok(())
    }

    /// A curve that an answer needs beyond its table.
    fn left(&self, view: &PoseAnswers<'_>) -> Option<LeftCurve> {
        if self.model.mechanism.has_curves { view.left_by_answers() } else { None }
    }

    /// The position once more with twice the digits, rounded; the loads follow from its motion.
    fn with_twice_the_digits(&self, state: &mut State) {
        let model = self.model;
        let Some(exact) = exact(model, state, &self.evaluated) else { return };
        exact.round_motion(state);
        if model.plan.effects.forces {
            state.run_loads(model, &self.evaluated);
            state.forces.applied.clone_from(&state.forces.wrenches);
            state.set_lines(model.plan);
            exact.round_forces(model, state);
            state.find_weld_reactions(model.plan);
        }
    }

    /// 1 unless friction multiplies the forces a thousandfold: near self-locking they go as 1/(1 − f/f_locking), and what
    /// rounding makes of the coefficient goes with them.
    fn near_locking(&mut self, state: &State, free: &State, pose: &PoseRequest) -> f64 {
        let reactions = |s: &State| s.forces.reactions.iter().map(|r| r.force.norm()).fold(0.0, f64::max);
        let applied = state.forces.applied.iter().map(|w| w.force.norm()).fold(0.0, f64::max);
        let share = reactions(free).max(applied) / reactions(state);
        if share.is_nan() || share >= NEAR_LOCKING {
            return 1.0;
        }
        let model = self.model;
        if let Some(group) = model.plan.forces.iter().position(|s| matches!(s, ForceStep::Friction { .. })) {
            self.notes.condition(model, GroupId::Forces(group), (share, Loss::ForcesNearLocking), pose);
        }
        share
    }

    fn forces(&mut self, state: &mut State, angles: &[f64], pose: &PoseRequest) -> Result<f64, Cause> {
        let model = self.model;
        if model.mechanism.has_curves {
            let view = PoseAnswers::new(model, state, angles, &self.statics);
            let motion = view.all_quantities();
            if let Some(left) = (PoseAnswers { quantities: &motion, ..view }).left_by_loads() {
                return Err(Cause::CurveLeft(left));
            }
        }
        let quantities = self.loads_name_quantities;
        state.scratch.searched = self.consistent_searched;
        balanced(model, &self.statics, state, angles, &mut self.evaluated, quantities);
        self.consistent_searched = state.scratch.searched;
        self.notes.consistent(model, state.forces.consistent, pose)?;
        slip_backwards(model, state)?;
        regular::of_forces(model, state, &mut self.notes, pose)
    }

    /// Ropes that push, and trains that the load cannot drive.
    fn note_trains(&mut self, solved: &Solved, pose: &PoseRequest) {
        if !self.model.plan.effects.forces || solved.state.forces.locked {
            return;
        }
        let ideal = solved.frictionless.as_deref().map(|(state, values)| (state, values.as_slice()));
        let view = PoseAnswers::new(self.model, &solved.state, &solved.angles, &self.statics);
        let view = PoseAnswers { frictionless: ideal, ..view };
        let mut ropes: Vec<(PairId, f64)> = Vec::new();
        let greatest = solved.state.forces.law_forces.iter().map(|f| f.multiplier.abs()).fold(0.0, f64::max);
        for law in &self.model.plan.laws {
            let rope = matches!(&self.model.mechanism.pair(law.pair).kind,
                PairKind::Transmission(t) if t.kind == TransmissionKind::Rope);
            let tension = view.tension(law.pair, law.index, None);
            if rope && tension < -1e-9 * greatest {
                ropes.push((law.pair, tension));
            }
        }
        let ideal = view.without_friction().power_of_efforts();
        let simulated = self.model.mechanism.simulation.is_some();
        let locking =
            self.model.plan.effects.losses && !simulated && ideal < 0.0 && view.power_of_efforts() > 0.0;
        for law in &self.model.plan.laws {
            if view.slips(law.pair) {
                self.notes.slips(law.pair, view.tangential_force(law.pair), pose);
            }
        }
        ropes.into_iter().for_each(|(pair, tension)| self.notes.pushes(pair, tension, pose));
        if locking {
            self.notes.self_locking(pose);
        }
    }

    fn note_contacts(&mut self, solved: &Solved, pose: &PoseRequest) {
        if !self.model.plan.effects.forces {
            return;
        }
        for (i, pair) in self.model.mechanism.pairs.iter().enumerate() {
            let PairKind::Contact { first, .. } = &pair.kind else { continue };
            let view = PoseAnswers::new(self.model, &solved.state, &solved.angles, &self.statics);
            let Value::Scalar(normal) = view.query(&Query::Normal(PairId::at(i), first.link)) else {
                continue;
            };
            let force = view.reaction(PairId::at(i), first.link).norm();
            if normal < -1e-9 * force.max(f64::MIN_POSITIVE) && normal < -1e-9 {
                self.notes.pulls(PairId::at(i), normal, pose);
            }
        }
    }
}
