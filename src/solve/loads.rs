//! Adds up the loads on the bodies before forces are solved.

use super::solution::Scene;
use super::state::{State, Wrench};
use super::view::View;
use crate::force::spring::spring;
use crate::math::Vec2;
use crate::model::{LoadId, LoadKind, Query, SpringId, Value};
use crate::plan::LoadStep;
use crate::structure::{EffortKind, JointKind};

impl State {
    /// Adds a force at a place in ground axes.
    #[inline(always)]
    fn apply(&mut self, body: usize, p: Vec2, force: Vec2) {
        let r = p - self.bodies[body].p;
        let w = &mut self.wrenches[body];
        w.force += force;
        w.moment += r.cross(force);
    }

    /// Sums all loads in `wrenches`. Loads that are numbers allocate nothing and look up nothing; the rest is evaluated through `view`,
    /// which is made of the state where there is any.
    pub fn run_loads(&mut self, scene: &Scene<'_>, evaluated: &[(LoadId, Value)]) {
        self.wrenches.fill(Wrench::default());
        for step in &scene.plan.loads {
            match step {
                LoadStep::Mass { body, centre, mass, moment_of_inertia, gravity, inertia } => {
                    let b = &self.bodies[*body];
                    let r = centre.turned(b.u);
                    let mut force = *gravity * *mass;
                    let mut couple = 0.0;
                    if *inertia {
                        let a_S = b.a + r.perp() * b.alpha - r * (b.omega * b.omega);
                        force -= a_S * *mass;
                        couple = -moment_of_inertia * b.alpha;
                    }
                    let w = &mut self.wrenches[*body];
                    w.force += force;
                    w.moment += r.cross(force) + couple;
                }
                LoadStep::Force { body, at, force, frame, .. } => {
                    let force = frame.map_or(*force, |f| force.turned(self.bodies[f].u));
                    let p = self.bodies[*body].position(*at);
                    self.apply(*body, p, force);
                }
                LoadStep::Torque { body, torque, .. } => self.wrenches[*body].moment += torque,
                LoadStep::Spring(id) => self.apply_spring(scene, *id),
                LoadStep::Evaluated(_) => {}
            }
        }
        for (load, value) in evaluated {
            self.apply_evaluated(scene, *load, *value);
        }
    }

    fn apply_spring(&mut self, scene: &Scene<'_>, id: SpringId) {
        let s = &scene.mechanism.springs[id.index()];
        let (one, two) = (self.bodies[s.from.0.index()], self.bodies[s.to.0.index()]);
        let (p_1, p_2) = (one.position(s.from.1), two.position(s.to.1));
        let v = two.velocity(s.to.1) - one.velocity(s.from.1);
        let got = spring(p_2 - p_1, v, s.stiffness, s.free_length, s.damping);
        self.apply(s.from.0.index(), p_1, got.f_1);
        self.apply(s.to.0.index(), p_2, -got.f_1);
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
                JointKind::Revolute(_) | JointKind::Law(_) => {}
            }
        }
    }

    /// Sets the lines of unknown forces.
    pub fn set_lines(&mut self, scene: &Scene<'_>) {
        for (slot, effort) in scene.structure.efforts.iter().enumerate() {
            let EffortKind::Line(_) = effort.kind else { continue };
            let crate::structure::EffortSource::Balance(id) = effort.source else { continue };
            let crate::model::BalanceKind::Force { on, at, along, frame } =
                &scene.mechanism.balances[id.index()].kind
            else {
                continue;
            };
            let p = match at {
                crate::model::Place::Local(at) => self.bodies[on.index()].position(*at),
                crate::model::Place::Ground(expr) => constant_vector(expr),
            };
            let n = frame.map_or(*along, |f| along.turned(self.bodies[f.index()].u));
            self.lines[slot] = (p, n);
        }
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
