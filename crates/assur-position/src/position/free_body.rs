//! What acts on bodies, one by one: the list with which the balance of bodies is computed, and which numbers, pictures and worked
//! solutions read.

use super::gap::PartingContact;
use super::model::Model;
use super::state::State;
use crate::force::spring::spring;
use crate::math::{Scalar, V2, Vec2};
use crate::model::{LoadId, LoadKind, PairId, PairKind, Place, SpringId, Value};
use crate::plan::{Checks, EffortCheck, LoadStep, Plan};
use crate::structure::{BodyId, JointKind};

/// What something that acts comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
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
pub struct Action<S = f64> {
    /// What it comes from.
    pub from: Origin,
    /// Slot of the body it acts on.
    pub on: usize,
    /// Slot of the body that does it, on which the opposite acts.
    pub by: Option<usize>,
    /// Where it acts, in ground axes, m.
    pub at: V2<S>,
    /// The force, N.
    pub force: V2<S>,
    /// The couple, N m.
    pub couple: S,
}

impl<S: Scalar> Action<S> {
    #[inline(always)]
    fn turning(from: Origin, [on, by]: [usize; 2], at: V2<S>, couple: S) -> Self {
        Self { from, on, by: Some(by), at, force: V2::zero(), couple }
    }

    #[inline(always)]
    fn pushing(from: Origin, [on, by]: [usize; 2], at: V2<S>, force: V2<S>) -> Self {
        Self { from, on, by: Some(by), at, force, couple: S::zero() }
    }

    /// What acts on the body that does it.
    #[must_use]
    pub fn opposite(self) -> Option<Self> {
        self.by.map(|on| Self { on, by: Some(self.on), force: -self.force, couple: -self.couple, ..self })
    }
}

impl<S: Scalar> State<S> {
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn reactions_act(&self, checks: &Checks, mut act: impl FnMut(Action<S>)) {
        for (slot, reaction) in checks.reactions.iter().enumerate() {
            let Some(at) = reaction else { continue };
            let place = self.motion.bodies[at.at.0].position(at.at.1);
            let got = self.forces.reactions[slot];
            let (from, by) = (Origin::Reaction(slot), Some(at.base));
            act(Action { from, on: at.body, by, at: place, force: got.force, couple: got.couple });
        }
    }

    #[cfg_attr(in_one, inline(always))]
    pub(super) fn efforts_act(&self, checks: &Checks, mut act: impl FnMut(Action<S>)) {
        for (slot, effort) in &checks.efforts {
            let (from, value) = (Origin::Effort(*slot), self.forces.efforts[*slot]);
            let centre = |body: usize| self.motion.bodies[body].p;
            act(match effort {
                EffortCheck::Torque(on) => {
                    Action { by: None, ..Action::turning(from, [*on, 0], centre(*on), value) }
                }
                EffortCheck::Between(first, second) => {
                    Action::turning(from, [*second, *first], centre(*second), value)
                }
                EffortCheck::Line(on) => {
                    let (place, n) = self.forces.lines[*slot];
                    Action { by: None, ..Action::pushing(from, [*on, 0], place, n * value) }
                }
                EffortCheck::Along { held, slider, direction, .. } => {
                    let s = &self.motion.bodies[slider.0];
                    let force = V2::of(*direction).turned(s.u) * value;
                    Action::pushing(from, *held, s.position(slider.1), force)
                }
            });
        }
    }
}

impl State {
    /// All that acts between bodies and in unknown efforts: with the loads every body is in equilibrium.
    pub fn acts(&self, plan: &Plan, act: &mut dyn FnMut(Action)) {
        self.reactions_act(&plan.checks, &mut *act);
        for (slot, law) in plan.laws.iter().enumerate() {
            let mut on_one = |on, at, force, couple| {
                act(Action { from: Origin::Law(slot), on, by: None, at, force, couple });
            };
            self.forces_of_law(law, slot, &mut on_one);
            self.grip_of_law(law, &mut on_one);
        }
        let rubbing = plan.friction.iter().zip(&plan.checks.rubbing).zip(&self.forces.frictions);
        for (i, ((element, &bodies), &value)) in rubbing.enumerate() {
            let from = Origin::Friction(i);
            act(match self.friction_line(element) {
                None => Action::turning(from, bodies, self.motion.bodies[element.through].p, value),
                Some((place, along)) => Action::pushing(from, bodies, place, along * value),
            });
        }
        self.efforts_act(&plan.checks, act);
    }

    /// All loads, with `value` of those of the file: their sums are what `Forces::applied` has.
    pub fn loads_act(&self, model: &Model<'_>, value: &dyn Fn(LoadId) -> Value, act: &mut dyn FnMut(Action)) {
        for step in &model.plan.loads {
            match step {
                LoadStep::Force { load, .. } | LoadStep::Torque { load, .. } | LoadStep::Evaluated(load) => {
                    self.load_act(model, *load, value(*load)).into_iter().for_each(&mut *act);
                }
                LoadStep::Mass { body: on, centre, mass, moment_of_inertia, weight, inertia, .. } => {
                    let (body, centre) = (&self.motion.bodies[*on], centre.unwrap_or_default());
                    let one = |from, force, couple| {
                        let at = body.position(centre);
                        Action { from, on: *on, by: None, at, force, couple }
                    };
                    act(one(Origin::Weight, *weight, 0.0));
                    if *inertia {
                        let force = body.acceleration(centre) * -mass;
                        act(one(Origin::Inertia, force, -moment_of_inertia * body.alpha));
                    }
                }
                LoadStep::Spring { spring: id, ends, stiffness, free_length, damping } => {
                    let [one, two] = ends.map(|end| {
                        let body = &self.motion.bodies[end.body];
                        (end.body, body.position(end.at), body.velocity(end.at))
                    });
                    let (r, v) = (two.1 - one.1, two.2 - one.2);
                    let got = spring(r, v, *stiffness, *free_length, damping.unwrap_or(0.0));
                    for ((on, at, _), force) in [(one, got.f_1), (two, -got.f_1)] {
                        act(Action { from: Origin::Spring(*id), on, by: None, at, force, couple: 0.0 });
                    }
                }
            }
        }
    }

    /// What a load of the file does that has this value.
    pub fn load_act(&self, model: &Model<'_>, id: LoadId, value: Value) -> Option<Action> {
        let from = Origin::Load(id);
        match (&model.mechanism.loads[id.index()].kind, value) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => {
                let place = match at {
                    Place::Local(at) => self.motion.bodies[on.index()].position(*at),
                    Place::Ground(expr) => constant_vector(expr),
                };
                Some(Action { by: None, ..Action::pushing(from, [on.index(), 0], place, force) })
            }
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => {
                let place = self.motion.bodies[on.index()].p;
                Some(Action { by: None, ..Action::turning(from, [on.index(), 0], place, torque) })
            }
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => {
                self.act_in_pair(model, *pair, from, effort)
            }
            _ => None,
        }
    }

    /// An effort between the two links of a pair, positive along its coordinate.
    fn act_in_pair(&self, model: &Model<'_>, pair: PairId, from: Origin, effort: f64) -> Option<Action> {
        if let Some([first, second]) = model.mechanism.pair(pair).kind.slipping() {
            let bodies = [second.index(), first.index()];
            return Some(Action::turning(from, bodies, self.motion.bodies[second.index()].p, effort));
        }
        if let Some(contact) = PartingContact::of_pair(model, pair) {
            let (place, normal) = self.parting_touch(&contact)?;
            let force = normal * (effort * self.pressed_by_effort(&contact));
            return Some(Action::pushing(from, contact.bodies(), place, force));
        }
        let replaced = &model.structure.replaced;
        let held = |bodies: [BodyId; 2]| bodies.map(|body| replaced.held_by(model.mechanism, pair, body).0);
        let is_revolute = matches!(model.mechanism.pair(pair).kind, PairKind::Revolute(_));
        replaced.joints_of(pair).find_map(|joint| match &replaced.joint(joint).kind {
            JointKind::Prismatic { slider, point, direction, guide, .. } => {
                let body = &self.motion.bodies[slider.0];
                let force = direction.turned(body.u) * effort;
                Some(Action::pushing(from, held([*slider, *guide]), body.position(*point), force))
            }
            JointKind::Revolute(members) if is_revolute => match members.as_slice() {
                [first, second] => {
                    let bodies = held([second.0, first.0]);
                    Some(Action::turning(
                        from,
                        bodies,
                        self.motion.bodies[second.0.0].position(second.1),
                        effort,
                    ))
                }
                _ => None,
            },
            JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => None,
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
