//! What acts on bodies, one by one: the list with which the balance of bodies is computed, and which pictures draw.

use super::model::Model;
use super::state::State;
use crate::force::spring::spring;
use crate::math::{Scalar, V2, Vec2};
use crate::model::{LoadId, LoadKind, PairId, PairKind, Place, SpringId, Value};
use crate::plan::{Checks, EffortCheck, LoadStep, Plan};
use crate::structure::JointKind;

/// What something that acts comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// A load of the file.
    Load(LoadId),
    /// The weight of the body.
    Weight,
    /// The inertia force and couple of the body.
    Inertia,
    /// A spring with its damper.
    Spring(SpringId),
    /// The reaction of this slot.
    Reaction(usize),
    /// The law of a transmission of this slot, with its losses.
    Law(usize),
    /// The element of friction of this number.
    Friction(usize),
    /// The unknown effort of this slot.
    Effort(usize),
}

/// A force at a place and a couple on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Act<S = f64> {
    /// Where it comes from.
    pub cause: Cause,
    /// Slot of the body it acts on.
    pub on: usize,
    /// Slot of the body that does it, on which the opposite acts.
    pub from: Option<usize>,
    /// The place in ground axes, m.
    pub place: V2<S>,
    /// The force, N.
    pub force: V2<S>,
    /// The couple, N m.
    pub couple: S,
}

impl<S: Scalar> Act<S> {
    #[inline(always)]
    fn turning(cause: Cause, [on, from]: [usize; 2], place: V2<S>, couple: S) -> Self {
        Self { cause, on, from: Some(from), place, force: V2::zero(), couple }
    }

    #[inline(always)]
    fn pushing(cause: Cause, [on, from]: [usize; 2], place: V2<S>, force: V2<S>) -> Self {
        Self { cause, on, from: Some(from), place, force, couple: S::zero() }
    }
}

impl<S: Scalar> State<S> {
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn reactions_act(&self, checks: &Checks, mut act: impl FnMut(Act<S>)) {
        for (slot, reaction) in checks.reactions.iter().enumerate() {
            let Some(at) = reaction else { continue };
            let place = self.motion.bodies[at.at.0].position(at.at.1);
            let got = self.forces.reactions[slot];
            let (cause, from) = (Cause::Reaction(slot), Some(at.base));
            act(Act { cause, on: at.body, from, place, force: got.force, couple: got.couple });
        }
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn efforts_act(&self, checks: &Checks, mut act: impl FnMut(Act<S>)) {
        for (slot, effort) in &checks.efforts {
            let (cause, value) = (Cause::Effort(*slot), self.forces.efforts[*slot]);
            let centre = |body: usize| self.motion.bodies[body].p;
            act(match effort {
                EffortCheck::Torque(on) => {
                    Act { from: None, ..Act::turning(cause, [*on, 0], centre(*on), value) }
                }
                EffortCheck::Between(first, second) => {
                    Act::turning(cause, [*second, *first], centre(*second), value)
                }
                EffortCheck::Line(on) => {
                    let (place, n) = self.forces.lines[*slot];
                    Act { from: None, ..Act::pushing(cause, [*on, 0], place, n * value) }
                }
                EffortCheck::Along { slider, direction, guide, .. } => {
                    let s = &self.motion.bodies[slider.0];
                    let force = V2::of(*direction).turned(s.u) * value;
                    Act::pushing(cause, [slider.0, *guide], s.position(slider.1), force)
                }
            });
        }
    }
}

impl State {
    /// All that acts between bodies and in unknown efforts: with the loads every body is in equilibrium.
    pub fn acts(&self, plan: &Plan, act: &mut dyn FnMut(Act)) {
        self.reactions_act(&plan.checks, &mut *act);
        for (slot, law) in plan.laws.iter().enumerate() {
            let mut on_one = |on, place, force, couple| {
                act(Act { cause: Cause::Law(slot), on, from: None, place, force, couple });
            };
            self.forces_of_law(law, slot, &mut on_one);
            self.grip_of_law(law, &mut on_one);
        }
        for (i, (element, &value)) in plan.friction.iter().zip(&self.forces.frictions).enumerate() {
            let (cause, bodies) = (Cause::Friction(i), [element.through, element.base]);
            act(match self.friction_line(element) {
                None => Act::turning(cause, bodies, self.motion.bodies[element.through].p, value),
                Some((place, along)) => Act::pushing(cause, bodies, place, along * value),
            });
        }
        self.efforts_act(&plan.checks, act);
    }

    /// All loads, with `value` of those of the file: their sums are what `Forces::applied` has.
    pub fn loads_act(&self, model: &Model<'_>, value: &dyn Fn(LoadId) -> Value, act: &mut dyn FnMut(Act)) {
        for step in &model.plan.loads {
            match step {
                LoadStep::Force { load, .. } | LoadStep::Torque { load, .. } | LoadStep::Evaluated(load) => {
                    self.load_act(model, *load, value(*load)).into_iter().for_each(&mut *act);
                }
                LoadStep::Mass { body: on, centre, mass, moment_of_inertia, weight, inertia, .. } => {
                    let (body, centre) = (&self.motion.bodies[*on], centre.unwrap_or_default());
                    let one = |cause, force, couple| {
                        let place = body.position(centre);
                        Act { cause, on: *on, from: None, place, force, couple }
                    };
                    act(one(Cause::Weight, *weight, 0.0));
                    if *inertia {
                        let force = body.acceleration(centre) * -mass;
                        act(one(Cause::Inertia, force, -moment_of_inertia * body.alpha));
                    }
                }
                LoadStep::Spring { spring: id, ends, stiffness, free_length, damping } => {
                    let [one, two] = ends.map(|end| {
                        let body = &self.motion.bodies[end.body];
                        (end.body, body.position(end.at), body.velocity(end.at))
                    });
                    let (r, v) = (two.1 - one.1, two.2 - one.2);
                    let got = spring(r, v, *stiffness, *free_length, damping.unwrap_or(0.0));
                    for ((on, place, _), force) in [(one, got.f_1), (two, -got.f_1)] {
                        act(Act { cause: Cause::Spring(*id), on, from: None, place, force, couple: 0.0 });
                    }
                }
            }
        }
    }

    /// What a load of the file does that has this value.
    pub(super) fn load_act(&self, model: &Model<'_>, id: LoadId, value: Value) -> Option<Act> {
        let cause = Cause::Load(id);
        match (&model.mechanism.loads[id.index()].kind, value) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => {
                let place = match at {
                    Place::Local(at) => self.motion.bodies[on.index()].position(*at),
                    Place::Ground(expr) => constant_vector(expr),
                };
                Some(Act { from: None, ..Act::pushing(cause, [on.index(), 0], place, force) })
            }
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => {
                let place = self.motion.bodies[on.index()].p;
                Some(Act { from: None, ..Act::turning(cause, [on.index(), 0], place, torque) })
            }
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => {
                self.act_in_pair(model, *pair, cause, effort)
            }
            _ => None,
        }
    }

    /// An effort between the two links of a pair, positive along its coordinate.
    fn act_in_pair(&self, model: &Model<'_>, pair: PairId, cause: Cause, effort: f64) -> Option<Act> {
        let replaced = &model.structure.replaced;
        let is_revolute = matches!(model.mechanism.pair(pair).kind, PairKind::Revolute(_));
        replaced.joints_of(pair).find_map(|joint| match &replaced.joint(joint).kind {
            JointKind::Prismatic { slider, point, direction, guide, .. } => {
                let body = &self.motion.bodies[slider.0];
                let force = direction.turned(body.u) * effort;
                Some(Act::pushing(cause, [slider.0, guide.0], body.position(*point), force))
            }
            JointKind::Revolute(members) if is_revolute => match members.as_slice() {
                [first, second] => {
                    let bodies = [second.0.0, first.0.0];
                    Some(Act::turning(
                        cause,
                        bodies,
                        self.motion.bodies[second.0.0].position(second.1),
                        effort,
                    ))
                }
                _ => None,
            },
            JointKind::Revolute(_) | JointKind::Law(_) => None,
        })
    }
}

/// A place of the ground: `check` folds it to numbers.
fn constant_vector(expr: &crate::model::Expr) -> Vec2 {
    match expr {
        crate::model::Expr::Constant(Value::Vector(v)) => *v,
        _ => Vec2::new(f64::NAN, f64::NAN),
    }
}
