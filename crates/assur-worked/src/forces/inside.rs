//! Springs and dampers, and loads between the two links of a pair.

use super::acting::{Couple, Force};
use super::holding::stop_of;
use super::quantity_name;
use crate::angle::Angle;
use crate::course::{Course, cell};
use crate::document::text;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{self, BinaryOp, Load, LoadKind, PairId, PairKind, Query, Spring, Value};
use assur_model::structure::JointKind;

impl Course<'_> {
    /// A spring with a damper: its length and how fast it grows, its force, and the components of this.
    pub(super) fn spring(&mut self, spring: &Spring) {
        if !self.scene.model.plan.effects.springs {
            return;
        }
        let ends = [spring.from, spring.to].map(|(link, at)| (link.index(), at));
        let [one, two] = ends.map(|(body, at)| self.position(body, at));
        let name = &spring.name;
        let d = [two[0].clone() - one[0].clone(), two[1].clone() - one[1].clone()];
        let length = self.distance(Name::new("l", name), &d);
        let mut right = Expr::ZERO;
        if spring.stiffness != 0.0 {
            let stiffness = self.given(Name::new("c", name), spring.stiffness, Unit::Stiffness);
            let free = self.given(Name::new("l", &format!("0,{name}")), spring.free_length, Unit::Length);
            right = stiffness * (length.clone() - free);
        }
        if spring.damping != 0.0 {
            let [v, w] = ends.map(|(body, at)| self.velocity(body, at));
            let dv = [w[0].clone() - v[0].clone(), w[1].clone() - v[1].clone()];
            let rate = (dv[0].clone() * d[0].clone() + dv[1].clone() * d[1].clone()) / length.clone();
            let value = rate.value();
            let rate = self.component(Name::new("v", name), value, Unit::Velocity, rate);
            right = right + self.given(Name::new("k", name), spring.damping, Unit::Damping) * rate;
        }
        let value = right.value();
        let pull = self.equate(Name::new("F", name), value, Unit::Force, right);
        if pull.is_zero() {
            return;
        }
        let parts = [0, 1].map(|i| {
            let right = pull.clone() * d[i].clone() / length.clone();
            let value = right.value();
            self.component(Name::new("F", name).and(["x", "y"][i]), value, Unit::Force, right)
        });
        let known = [cell(&pull), vec![text("–")]];
        for (i, (body, at)) in ends.into_iter().enumerate() {
            let parts = parts.clone().map(|p| if i == 0 { p } else { -p });
            self.known_force(
                body,
                Force {
                    name: Name::new("F", name),
                    at,
                    parts,
                    known: known.clone(),
                    load: true,
                    rubs: false,
                },
            );
        }
        self.counts.loads[0] += 1;
    }

    fn known_force(&mut self, body: usize, force: Force) {
        if body != 0 {
            self.acting.forces[body].push(force);
        }
    }

    /// A load between the links of a pair: a force along the guide, a couple in a hinge.
    pub(super) fn in_pair(&mut self, load: &Load, pair: PairId, name: Name, effort: f64) {
        let turns = matches!(self.scene.mechanism().pair(pair).kind, PairKind::Revolute(_));
        let joints: Vec<_> = self.structure().replaced.joints_of(pair).collect();
        for joint in joints {
            match self.structure().replaced.joint(joint).kind.clone() {
                JointKind::Prismatic { slider, point, direction, guide, .. } => {
                    let (size, value) = if stop_of(load).is_some() {
                        let value = self.stop_effort(pair, slider.0, effort, Unit::Force);
                        (value.clone(), value)
                    } else {
                        let size = self.size_of(load, name.clone(), effort.abs(), Unit::Force);
                        (size.clone(), if effort < 0.0 { -size } else { size })
                    };
                    let name = if let Expr::Leaf(q) = &size { q.name.clone() } else { name };
                    self.along_guide((slider.0, point, direction), guide.0, &name, &size, &value);
                    self.counts.loads[0] += 1;
                    return;
                }
                JointKind::Revolute(members) if turns => {
                    let [first, second] = members.as_slice() else { return };
                    let value = match self.torsion(load, pair, effort) {
                        Some(value) => value,
                        None if stop_of(load).is_some() => {
                            self.stop_effort(pair, second.0.0, effort, Unit::Torque)
                        }
                        None => {
                            let size = self.size_of(load, name.clone(), effort.abs(), Unit::Torque);
                            if effort < 0.0 { -size } else { size }
                        }
                    };
                    for (body, value) in [(second.0.0, value.clone()), (first.0.0, -value)] {
                        self.acting.couples[body].push(Couple { value, load: true, rubs: false });
                    }
                    self.counts.loads[0] += 1;
                    return;
                }
                JointKind::Revolute(_) | JointKind::Law(_) => {}
            }
        }
    }

    fn along_guide(
        &mut self,
        (slider, point, direction): (usize, Vec2, Vec2),
        guide: usize,
        name: &Name,
        size: &Expr,
        value: &Expr,
    ) {
        let own = self.direction_given(direction, || Name::new("λ′", &self.label(slider)));
        let angle = self.bodies[slider].as_ref().map_or(own.clone(), |b| b.angle.plus(&own));
        let parts = [value.clone() * angle.cos(), value.clone() * angle.sin()];
        let place = self.moved(slider).position(point);
        for (body, parts) in [(slider, parts.clone()), (guide, parts.map(|p| -p))] {
            let moved = self.moved(body);
            let at = (place - moved.p).turned_back(moved.u);
            let known = [cell(size), vec![text("–")]];
            let force = Force { name: name.clone(), at, parts, known, load: true, rubs: false };
            self.known_force(body, force);
        }
    }

    /// A torsion spring with a damper, from its angle and its rate; none for another load of a hinge.
    fn torsion(&mut self, load: &Load, pair: PairId, effort: f64) -> Option<Expr> {
        let LoadKind::InPair { value, .. } = &load.kind else { return None };
        let words = load.name.clone()?;
        let spring = Torsion::of(value, pair)?;
        let mut right = Expr::ZERO;
        if let Some((stiffness, free)) = spring.elastic {
            let c = self.given(Name::new("c", &words), stiffness, Unit::TorsionStiffness);
            let free = self.given(Name::new("φ", &format!("0,{words}")), free.to_degrees(), Unit::Angle);
            let angle = self.scalar(&Query::Displacement(pair)).to_degrees();
            let angle = self.angle_of_hinge(Name::new("φ", &words), pair, angle);
            right = c * (free - angle) * Expr::Pi / Expr::Int(180);
        }
        if let Some(damping) = spring.viscous {
            let k = self.given(Name::new("k", &words), damping, Unit::TorsionDamping);
            let rate = self.scalar(&Query::RelativeVelocity(pair));
            right = right - k * self.rate_of_hinge(Name::new("ω", &words), pair, rate);
        }
        let name = Name { letter: "M".to_owned(), ..quantity_name(&format!("M_{words}")) };
        Some(self.equate(name, effort, Unit::Torque, right))
    }

    /// The angle of a hinge from those of its links, with its whole turns.
    fn angle_of_hinge(&mut self, name: Name, pair: PairId, degrees: f64) -> Expr {
        let PairKind::Revolute(pins) = &self.scene.mechanism().pair(pair).kind else { return Expr::ZERO };
        let angles: Vec<Angle> = pins
            .iter()
            .filter_map(|pin| self.bodies[pin.link.index()].as_ref().map(|body| body.angle.clone()))
            .collect();
        if let [one, two] = angles.as_slice() {
            for right in [two.minus(one).whole(), one.minus(two).whole()] {
                let turns = ((degrees - right.value()) / 360.0).round();
                let right = right + Expr::Degrees(360 * turns as i64);
                if (right.value() - degrees).abs() <= 1e-9 * right.scale().max(360.0) {
                    return self.component(name, degrees, Unit::Angle, right);
                }
            }
        }
        self.stated(name, degrees, Unit::Angle)
    }

    /// The rate of a hinge from those of its links.
    fn rate_of_hinge(&mut self, name: Name, pair: PairId, rate: f64) -> Expr {
        let PairKind::Revolute(pins) = &self.scene.mechanism().pair(pair).kind else { return Expr::ZERO };
        let rates: Vec<Expr> = pins
            .iter()
            .filter_map(|pin| self.bodies[pin.link.index()].as_ref().map(|body| body.rates[0].clone()))
            .collect();
        if let [one, two] = rates.as_slice() {
            for right in [two.clone() - one.clone(), one.clone() - two.clone()] {
                if (right.value() - rate).abs() <= 1e-9 * right.scale() {
                    return self.component(name, rate, Unit::AngularVelocity, right);
                }
            }
        }
        self.stated(name, rate, Unit::AngularVelocity)
    }

    fn scalar(&self, query: &Query) -> f64 {
        match self.scene.view().query(query) {
            Value::Scalar(x) => x,
            _ => f64::NAN,
        }
    }
}

/// The torque k (φ₀ − φ) − c ω of a hinge.
#[derive(Default)]
struct Torsion {
    elastic: Option<(f64, f64)>,
    viscous: Option<f64>,
}

impl Torsion {
    fn of(value: &model::Expr, pair: PairId) -> Option<Self> {
        use model::Expr as E;
        let mut found = Self::default();
        let terms: Vec<&E> = match value {
            E::Binary(BinaryOp::Add, a, b) => vec![a, b],
            one => vec![one],
        };
        for term in terms {
            let E::Binary(BinaryOp::Mul, factor, of) = term else { return None };
            let E::Constant(Value::Scalar(factor)) = **factor else { return None };
            match &**of {
                E::Binary(BinaryOp::Sub, free, angle) => {
                    let (E::Constant(Value::Scalar(free)), E::Query(Query::Displacement(own))) =
                        (&**free, &**angle)
                    else {
                        return None;
                    };
                    found.elastic = Some((factor, *free)).filter(|_| *own == pair);
                }
                E::Query(Query::RelativeVelocity(own)) if *own == pair => found.viscous = Some(-factor),
                _ => return None,
            }
        }
        Some(found)
    }
}
