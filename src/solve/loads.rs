//! Adds up the loads on the bodies before forces are solved.

use super::solution::Scene;
use super::state::{BodyState, State, Wrench};
use super::view::View;
use crate::force::spring::spring;
use crate::math::Vec2;
use crate::model::{LoadId, LoadKind, Query, Value};
use crate::plan::{Arm, LoadStep, Plan};
use crate::structure::JointKind;

impl State {
    /// Adds a force at a place in ground axes.
    #[inline(always)]
    fn apply(&mut self, body: usize, p: Vec2, force: Vec2) {
        let r = p - self.bodies[body].p;
        let w = &mut self.wrenches[body];
        w.force += force;
        w.moment += r.cross(force);
    }

    /// Sums all loads in `wrenches`: those that are numbers, then the values of those that are evaluated at every position,
    /// as [`View::evaluated_loads`] lists them. Allocates nothing.
    pub fn run_loads(&mut self, scene: &Scene<'_>, evaluated: &[(LoadId, Value)]) {
        self.known_loads(scene.plan);
        for (load, value) in evaluated {
            self.apply_evaluated(scene, *load, *value);
        }
    }

    /// The loads that need no evaluation.
    fn known_loads(&mut self, plan: &Plan) {
        for &body in &plan.massless {
            self.wrenches[body] = Wrench::default();
        }
        for step in &plan.loads {
            match step {
                LoadStep::Mass { body, centre, mass, moment_of_inertia, weight, inertia } => {
                    let b = &self.bodies[*body];
                    let heavy = Heavy { mass: *mass, moment_of_inertia: *moment_of_inertia, weight: *weight };
                    self.wrenches[*body] =
                        if *inertia { heavy.moving(b, centre) } else { heavy.at_rest(b, centre) };
                }
                LoadStep::Force { body, at, force, frame, .. } => {
                    let force = frame.map_or(*force, |f| force.turned(self.bodies[f].u));
                    let p = self.bodies[*body].position(*at);
                    self.apply(*body, p, force);
                }
                LoadStep::Torque { body, torque, .. } => self.wrenches[*body].moment += torque,
                LoadStep::Spring { ends: [one, two], stiffness, free_length, damping, .. } => {
                    let (b_1, b_2) = (&self.bodies[one.body], &self.bodies[two.body]);
                    let (p_1, p_2) = (b_1.position(one.at), b_2.position(two.at));
                    let v = b_2.velocity(two.at) - b_1.velocity(one.at);
                    let got = spring(p_2 - p_1, v, *stiffness, *free_length, *damping);
                    self.apply(one.body, p_1, got.f_1);
                    self.apply(two.body, p_2, -got.f_1);
                }
                LoadStep::Evaluated(_) => {}
            }
        }
    }

    fn apply_evaluated(&mut self, scene: &Scene<'_>, id: LoadId, value: Value) {
        match (&scene.mechanism.loads[id.index()].kind, value) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => {
                let p = match at {
                    crate::model::Place::Local(at) => self.bodies[on.index()].position(*at),
                    crate::model::Place::Ground(expr) => constant_vector(expr),
                };
                self.apply(on.index(), p, force);
            }
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => {
                self.wrenches[on.index()].moment += torque;
            }
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => {
                self.apply_in_pair(scene, *pair, effort);
            }
            _ => {}
        }
    }

    /// An effort between the two links of a pair, positive along its coordinate.
    fn apply_in_pair(&mut self, scene: &Scene<'_>, pair: crate::model::PairId, effort: f64) {
        for joint in scene.structure.replaced.joints_of(pair) {
            match &scene.structure.replaced.joint(joint).kind {
                JointKind::Prismatic { slider, point, direction, guide, .. } => {
                    let b = &self.bodies[slider.0];
                    let (p, force) = (b.position(*point), direction.turned(b.u) * effort);
                    self.apply(slider.0, p, force);
                    self.apply(guide.0, p, -force);
                    return;
                }
                JointKind::Revolute(members)
                    if matches!(scene.mechanism.pair(pair).kind, crate::model::PairKind::Revolute(_)) =>
                {
                    if let [first, second] = members.as_slice() {
                        self.wrenches[second.0.0].moment += effort;
                        self.wrenches[first.0.0].moment -= effort;
                    }
                    return;
                }
                JointKind::Revolute(_) => {}
            }
        }
    }

    /// Sets the lines of unknown forces.
    pub fn set_lines(&mut self, plan: &Plan) {
        for line in &plan.lines {
            let p = self.bodies[line.body].position(line.at);
            let n = line.frame.map_or(line.along, |f| line.along.turned(self.bodies[f].u));
            self.lines[line.effort] = (p, n);
        }
    }
}

/// The mass of a body: what it adds about the body's origin.
struct Heavy {
    mass: f64,
    moment_of_inertia: f64,
    weight: Vec2,
}

impl Heavy {
    #[inline(always)]
    fn at_rest(&self, body: &BodyState, centre: &Arm) -> Wrench {
        let moment = centre.map_or(0.0, |centre| centre.turned(body.u).cross(self.weight));
        Wrench { force: self.weight, moment }
    }

    #[inline(always)]
    fn moving(&self, body: &BodyState, centre: &Arm) -> Wrench {
        let couple = self.moment_of_inertia * body.alpha;
        let Some(centre) = centre else {
            return Wrench { force: self.weight - body.a * self.mass, moment: -couple };
        };
        let r = centre.turned(body.u);
        let a_S = body.a + r.perp() * body.alpha - r * (body.omega * body.omega);
        let force = self.weight - a_S * self.mass;
        Wrench { force, moment: r.cross(force) - couple }
    }
}

/// A place of the ground: `check` folds it to numbers.
fn constant_vector(expr: &crate::model::Expr) -> Vec2 {
    match expr {
        crate::model::Expr::Constant(Value::Vector(v)) => *v,
        _ => Vec2::new(f64::NAN, f64::NAN),
    }
}

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
