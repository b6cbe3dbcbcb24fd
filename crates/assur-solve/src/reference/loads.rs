//! Loads on the bodies, with inertia, in the position found. Values of expressions are those of `f64`.

use super::unit;
use crate::math::{Double, Scalar, V2, Vec2};
use crate::model::{Expr, LoadId, LoadKind, PairId, PairKind, Place, Value};
use crate::plan::{Anchor, LoadStep};
use crate::position::{BodyState, Model, Wrench};
use crate::structure::JointKind;

type D = Double;

/// Sums of loads, each with its moment about the origin of its body.
pub(super) struct Loads<'a> {
    bodies: &'a [BodyState<D>],
    sums: Vec<Wrench<D>>,
}

/// All loads of the plan.
pub(super) fn applied(
    model: &Model<'_>,
    bodies: &[BodyState<D>],
    evaluated: &[(LoadId, Value)],
) -> Vec<Wrench<D>> {
    let mut loads = Loads { bodies, sums: vec![Wrench::default(); bodies.len()] };
    model.plan.loads.iter().for_each(|step| loads.step(step));
    for (load, value) in evaluated {
        loads.evaluated(model, *load, *value);
    }
    // bodies bear the loads of their parts
    for part in &model.plan.parts {
        let Wrench { force, moment } = loads.sums[part.part];
        let r = bodies[part.part].p - bodies[part.body].p;
        let body = &mut loads.sums[part.body];
        body.force += force;
        body.moment = body.moment + moment + r.cross(force);
    }
    loads.sums
}

impl Loads<'_> {
    fn force(&mut self, body: usize, p: V2<D>, force: V2<D>) {
        let sum = &mut self.sums[body];
        sum.force += force;
        sum.moment = sum.moment + (p - self.bodies[body].p).cross(force);
    }

    fn couple(&mut self, body: usize, couple: D) {
        self.sums[body].moment = self.sums[body].moment + couple;
    }

    fn step(&mut self, step: &LoadStep) {
        match step {
            LoadStep::Mass { body, centre, mass, moment_of_inertia, gravity, inertia, .. } => {
                let (b, mass, centre) = (self.bodies[*body], D::of(*mass), centre.unwrap_or(Vec2::zero()));
                let mut force = V2::of(*gravity) * mass;
                if *inertia {
                    force -= b.acceleration(centre) * mass;
                    self.couple(*body, -(D::of(*moment_of_inertia) * b.alpha));
                }
                self.force(*body, b.position(centre), force);
            }
            LoadStep::Force { body, at, force, frame, .. } => {
                let force = frame.map_or(V2::of(*force), |f| V2::of(*force).turned(self.bodies[f].u));
                self.force(*body, self.bodies[*body].position(*at), force);
            }
            LoadStep::Torque { body, torque, .. } => self.couple(*body, D::of(*torque)),
            LoadStep::Spring { ends, stiffness, free_length, damping, .. } => {
                self.spring(ends, [*stiffness, *free_length, damping.unwrap_or(0.0)].map(D::of));
            }
            LoadStep::Evaluated(_) => {}
        }
    }

    /// T = k (l − l₀) + c l̇ along the spring; nothing where its ends coincide.
    fn spring(&mut self, ends: &[Anchor; 2], [stiffness, free_length, damping]: [D; 3]) {
        let p = ends.map(|end| self.bodies[end.body].position(end.at));
        let v = ends.map(|end| self.bodies[end.body].velocity(end.at));
        let length = (p[1] - p[0]).norm();
        if length.high == 0.0 {
            return;
        }
        let along = (p[1] - p[0]) / length;
        let tension = stiffness * (length - free_length) + damping * (v[1] - v[0]).dot(along);
        self.force(ends[0].body, p[0], along * tension);
        self.force(ends[1].body, p[1], -(along * tension));
    }

    fn evaluated(&mut self, model: &Model<'_>, load: LoadId, value: Value) {
        match (&model.mechanism.loads[load.index()].kind, value) {
            (
                LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                Value::Vector(force),
            ) => {
                let p = match at {
                    Place::Local(at) => self.bodies[on.index()].position(*at),
                    Place::Ground(Expr::Constant(Value::Vector(p))) => V2::of(*p),
                    Place::Ground(_) => return,
                };
                self.force(on.index(), p, V2::of(force));
            }
            (LoadKind::Torque { on, .. }, Value::Scalar(torque)) => self.couple(on.index(), D::of(torque)),
            (LoadKind::InPair { pair, .. }, Value::Scalar(effort)) => {
                self.in_pair(model, *pair, D::of(effort))
            }
            _ => {}
        }
    }

    /// An effort between the two links of a pair.
    fn in_pair(&mut self, model: &Model<'_>, pair: PairId, effort: D) {
        if let Some([first, second]) = model.mechanism.pair(pair).kind.slipping() {
            self.couple(second.index(), effort);
            self.couple(first.index(), -effort);
            return;
        }
        if let PairKind::Revolute(pins) = &model.mechanism.pair(pair).kind {
            if let [first, second] = pins.as_slice() {
                self.couple(second.link.index(), effort);
                self.couple(first.link.index(), -effort);
            }
            return;
        }
        let replaced = &model.structure.replaced;
        for joint in replaced.joints_of(pair) {
            if let JointKind::Prismatic { slider, point, direction, guide, .. } = &replaced.joint(joint).kind
            {
                let body = &self.bodies[slider.0];
                let (p, force) = (body.position(*point), unit(*direction).turned(body.u) * effort);
                self.force(slider.0, p, force);
                self.force(guide.0, p, -force);
                return;
            }
        }
    }
}
