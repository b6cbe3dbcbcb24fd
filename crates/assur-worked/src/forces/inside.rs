//! Springs and dampers, and loads between the two links of a pair.

use super::quantity_name;
use crate::angle::Angle;
use crate::course::{Derivation, cell};
use crate::document::text;
use assur_formula::{Expr, Name, Unit};
use assur_model::model::{self, BinaryOp, Load, LoadKind, PairId, PairKind, Query, Spring, SpringId, Value};
use assur_position::position::{Action, Origin};

impl Derivation<'_> {
    /// A spring with a damper: its length and how fast it grows, its force, and the components of this.
    pub(super) fn spring(&mut self, id: SpringId, spring: &Spring) {
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
        let ends = self.scene.view().actions_from(Origin::Spring(id));
        for (action, parts) in ends.iter().zip([parts.clone(), parts.map(|p| -p)]) {
            self.put_force(action, &Name::new("F", name), &parts, &known);
        }
        self.counts.loads[0] += 1;
    }

    /// A load along the guide of a pair.
    pub(super) fn along_guide(&mut self, action: &Action, effort: f64, name: &Name, value: &Expr) {
        let slider = action.on;
        let direction = (action.force * (1.0 / effort)).turned_back(self.moved(slider).u);
        let own = self.direction_given(direction, || Name::new("λ′", &self.label(slider)));
        let angle = self.bodies[slider].as_ref().map_or(own.clone(), |b| b.angle.plus(&own));
        let parts = [value.clone() * angle.cos(), value.clone() * angle.sin()];
        let size = if let Expr::Neg(size) = value { size } else { value };
        let name = if let Expr::Leaf(q) = size { &q.name } else { name };
        self.put_force(action, name, &parts, &[cell(size), vec![text("–")]]);
    }

    /// A torsion spring with a damper, from its angle and its rate; none for another load of a hinge.
    pub(super) fn torsion(&mut self, load: &Load, pair: PairId, effort: f64) -> Option<Expr> {
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
