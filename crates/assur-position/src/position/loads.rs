//! Adds up the loads on the bodies before forces are solved.

use super::body::BodyState;
use super::free_body::Action;
use super::model::Model;
use super::state::State;
use super::wrench::Wrench;
use crate::force::spring::spring;
use crate::math::{Scalar, V2};
use crate::model::{LoadId, Value};
use crate::plan::step::unit;
use crate::plan::{Arm, LoadStep, Plan};

impl<S: Scalar> State<S> {
    /// Adds a force at a place in ground axes.
    #[inline(always)]
    fn apply(&mut self, body: usize, p: V2<S>, force: V2<S>) {
        let r = p - self.motion.bodies[body].p;
        let w = &mut self.forces.wrenches[body];
        w.force += force;
        w.moment = w.moment + r.cross(force);
    }

    /// The loads that need no evaluation.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn known_loads(&mut self, plan: &Plan) {
        self.unload(plan);
        for step in &plan.loads {
            self.known_load(step);
        }
    }

    /// Bodies without mass start without load, as far as it is asked what they carry.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn unload(&mut self, plan: &Plan) {
        for &body in &plan.massless {
            self.forces.wrenches[body] = Wrench { force: V2::zero(), moment: S::zero() };
        }
    }

    /// Adds a load that needs no evaluation.
    #[cfg_attr(in_one, inline(always))]
    pub(super) fn known_load(&mut self, step: &LoadStep) {
        match step {
            LoadStep::Mass { body, centre, mass, moment_of_inertia, weight, gravity, inertia } => {
                let b = &self.motion.bodies[*body];
                let mass = S::of(*mass);
                let heavy = Heavy {
                    mass,
                    moment_of_inertia: S::of(*moment_of_inertia),
                    weight: if S::EXTENDED { V2::of(*gravity) * mass } else { V2::of(*weight) },
                };
                self.forces.wrenches[*body] =
                    if *inertia { heavy.moving(b, centre) } else { heavy.at_rest(b, centre) };
            }
            LoadStep::Force { body, at, force, frame, .. } => {
                let force = frame.map_or(V2::of(*force), |f| V2::of(*force).turned(self.motion.bodies[f].u));
                let p = self.motion.bodies[*body].position(*at);
                self.apply(*body, p, force);
            }
            LoadStep::Torque { body, torque, .. } => {
                self.forces.wrenches[*body].moment = self.forces.wrenches[*body].moment + S::of(*torque)
            }
            LoadStep::Spring { ends: [one, two], stiffness, free_length, damping, .. } => {
                let (b_1, b_2) = (&self.motion.bodies[one.body], &self.motion.bodies[two.body]);
                let (p_1, p_2) = (b_1.position(one.at), b_2.position(two.at));
                let (v, damping) = damping.map_or((V2::zero(), S::zero()), |damping| {
                    (b_2.velocity(two.at) - b_1.velocity(one.at), S::of(damping))
                });
                let got = spring(p_2 - p_1, v, S::of(*stiffness), S::of(*free_length), damping);
                self.apply(one.body, p_1, got.f_1);
                self.apply(two.body, p_2, -got.f_1);
            }
            LoadStep::Evaluated(_) => {}
        }
    }

    /// Sets the lines of unknown forces.
    #[cfg_attr(in_one, inline(always))]
    pub fn set_lines(&mut self, plan: &Plan) {
        for line in &plan.lines {
            let p = self.motion.bodies[line.body].position(line.at);
            let along = unit(line.along);
            let n = line.frame.map_or(along, |f| along.turned(self.motion.bodies[f].u));
            self.forces.lines[line.effort] = (p, n);
        }
    }
}

impl State {
    /// Sums all loads in `wrenches`: those that are numbers, then the values of those that are evaluated at every position,
    /// in the order of the plan. Allocates nothing.
    pub fn run_loads(&mut self, model: &Model<'_>, evaluated: &[(LoadId, Value)]) {
        self.known_loads(model.plan);
        for (load, value) in evaluated {
            self.apply_evaluated(model, *load, *value);
        }
    }

    /// The values of loads that are evaluated at every position in `wrenches`, and no other load.
    pub(super) fn run_evaluated_loads(&mut self, model: &Model<'_>, evaluated: &[(LoadId, Value)]) {
        self.forces.wrenches.fill(Wrench { force: V2::zero(), moment: 0.0 });
        for (load, value) in evaluated {
            self.apply_evaluated(model, *load, *value);
        }
    }

    fn apply_evaluated(&mut self, model: &Model<'_>, id: LoadId, value: Value) {
        let Some(action) = self.load_act(model, id, value) else { return };
        for Action { on, at, force, couple, .. } in [Some(action), action.opposite()].into_iter().flatten() {
            self.apply(on, at, force);
            self.forces.wrenches[on].moment += couple;
        }
    }
}

/// The mass of a body: what it adds about the body's origin.
struct Heavy<S> {
    mass: S,
    moment_of_inertia: S,
    weight: V2<S>,
}

impl<S: Scalar> Heavy<S> {
    #[inline(always)]
    fn at_rest(&self, body: &BodyState<S>, centre: &Arm) -> Wrench<S> {
        let moment = centre.map_or(S::zero(), |centre| V2::of(centre).turned(body.u).cross(self.weight));
        Wrench { force: self.weight, moment }
    }

    #[inline(always)]
    fn moving(&self, body: &BodyState<S>, centre: &Arm) -> Wrench<S> {
        let couple = self.moment_of_inertia * body.alpha;
        let Some(centre) = centre else {
            return Wrench { force: self.weight - body.a * self.mass, moment: -couple };
        };
        let r = V2::of(*centre).turned(body.u);
        let a_S = body.a + r.perp() * body.alpha - r * (body.omega * body.omega);
        let force = self.weight - a_S * self.mass;
        Wrench { force, moment: r.cross(force) - couple }
    }
}
