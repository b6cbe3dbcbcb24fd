//! Weights and inertia forces of the links.

use crate::course::{Derivation, cell};
use crate::document::{against, text};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, MassProperties};
use assur_position::plan::LoadStep;
use assur_position::position::{Action, Origin};

impl Derivation<'_> {
    /// The links with mass: weight, inertia force and couple.
    pub fn masses(&mut self) {
        let mechanism = self.scene.mechanism();
        for (i, link) in mechanism.links.iter().enumerate().skip(1) {
            if let Some(mass) = link.mass {
                self.sum_of_masses(LinkId::at(i).index(), mass, &link.mass_parts);
                self.mass(LinkId::at(i).index(), mass);
            }
        }
    }

    fn mass(&mut self, body: usize, mass: MassProperties) {
        let effects = self.scene.model.plan.effects;
        // a slider of a train has its weight along its own line
        let gravity = self.scene.model.plan.loads.iter().find_map(|step| match step {
            LoadStep::Mass { body: own, gravity, .. } if *own == body && mass.mass > 0.0 => Some(*gravity),
            _ => None,
        });
        let gravity = gravity.filter(|g| effects.gravity && g.norm() > 0.0);
        let label = self.label(body);
        let own = self.own_mass(body, mass.mass, gravity.map(Vec2::norm));
        if let Some(gravity) = gravity {
            self.weight(body, mass, gravity, &own);
        }
        if !effects.inertia {
            return;
        }
        if mass.mass > 0.0 {
            let a = self.acceleration(body, mass.centre);
            let name = Name::new("F", &format!("{}{label}", self.language.letters().inertia));
            let value = self.moved(body).acceleration(mass.centre) * -mass.mass;
            let parts = [
                self.equate(name.and("x"), value.x, Unit::Force, -(own.clone() * a[0].clone())),
                self.equate(name.and("y"), value.y, Unit::Force, -(own * a[1].clone())),
            ];
            if parts.iter().any(|p| !p.is_zero()) {
                let size = self.magnitude(name.clone(), &parts);
                let known = [cell(&size), against("a", &self.point_of(&a, body, mass.centre))];
                if let Some(action) = self.of_mass(body, Origin::Inertia) {
                    self.put_force(&action, &name, &parts, &known);
                }
                self.counts.loads[0] += 1;
            }
        }
        let alpha = self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[1].clone());
        if mass.inertia > 0.0 && !alpha.is_zero() {
            let point = self.point_name(body, mass.centre);
            let j = match self.with_planets(body, mass.inertia) {
                Some(both) => both,
                None => self.given(Name::new("J", &point), mass.inertia, Unit::Inertia),
            };
            let value = -mass.inertia * self.moved(body).alpha;
            let name = Name::new("M", &format!("{}{label}", self.language.letters().inertia));
            let couple = self.equate(name.clone(), value, Unit::Torque, -(j * alpha));
            if let Some(action) = self.of_mass(body, Origin::Inertia) {
                self.put_couple(&action, &couple);
            }
            self.counts.loads[0] += 1;
            self.arm_of_inertia(body, mass);
        }
    }

    /// The weight of a body, or its inertia force and couple.
    fn of_mass(&self, body: usize, from: Origin) -> Option<Action> {
        self.scene.view().actions_from(from).into_iter().find(|action| action.on == body)
    }

    /// The point whose acceleration this is: of a link that does not turn that which was found.
    fn point_of(&self, parts: &[Expr; 2], body: usize, at: Vec2) -> String {
        let other = parts.iter().any(Expr::is_zero).then(|| {
            parts.iter().find_map(|part| match part {
                Expr::Leaf(q) => Some(q.name.clone()),
                Expr::Neg(x) => {
                    if let Expr::Leaf(q) = &**x {
                        Some(q.name.clone())
                    } else {
                        None
                    }
                }
                _ => None,
            })
        });
        let whole =
            |name: &Name| name.letter == "a" && name.sup.is_empty() && !name.sub.ends_with(['x', 'y']);
        match other.flatten().filter(whole) {
            Some(name) => name.sub,
            None => self.point_name(body, at),
        }
    }

    /// Force and couple as one force at a distance.
    fn arm_of_inertia(&mut self, body: usize, mass: MassProperties) {
        let label = self.label(body);
        let find = |letter: &str| {
            self.found
                .get(&Name::new(letter, &format!("{}{label}", self.language.letters().inertia)))
                .cloned()
        };
        let (Some(force), Some(couple)) = (find("F"), find("M")) else { return };
        if force.value().abs() <= 1e-12 * force.scale() {
            return;
        }
        let point = self.point_name(body, mass.centre);
        self.say(
            Message::InertiaArm,
            &[
                crate::motion::of(&Name::new("F", &format!("{}{label}", self.language.letters().inertia))),
                vec![text(point)],
            ],
        );
        let right = couple.abs() / force;
        let value = right.value();
        self.equate(
            Name::new("h", &format!("{}{label}", self.language.letters().inertia)),
            value,
            Unit::Length,
            right,
        );
    }

    /// Whether the mass is a sum of several.
    fn has_several_masses(&self, body: usize) -> bool {
        self.scene.mechanism().links.get(body).is_some_and(|link| !link.mass_parts.is_empty())
    }

    /// The mass: as the file gives it, or from the weight that it gives.
    fn own_mass(&mut self, body: usize, mass: f64, gravity: Option<f64>) -> Expr {
        if mass <= 0.0 {
            return Expr::ZERO;
        }
        let label = self.label(body);
        if self.has_several_masses(body) {
            return self.given(Name::new("m", &label), mass, Unit::Mass);
        }
        let given = self.given(Name::new("m", &label), mass, Unit::Mass);
        let Some(g) = gravity else { return given };
        if figures(mass) <= figures(mass * g) || !self.scene.model.plan.effects.inertia {
            return given;
        }
        let weight = self.given(Name::new("G", &label), mass * g, Unit::Force);
        let g = self.given(Name::new("g", ""), g, Unit::Acceleration);
        self.equate(Name::new("m", &label), mass, Unit::Mass, weight / g)
    }

    fn weight(&mut self, body: usize, mass: MassProperties, g: Vec2, own: &Expr) {
        let label = self.label(body);
        let name = Name::new("G", &label);
        let size = g.norm();
        let from_mass = self.has_several_masses(body) || figures(mass.mass) <= figures(mass.mass * size);
        let weight = if from_mass {
            let g = self.given(Name::new("g", ""), size, Unit::Acceleration);
            self.equate(name.clone(), mass.mass * size, Unit::Force, own.clone() * g)
        } else {
            self.given(name.clone(), mass.mass * size, Unit::Force)
        };
        let down = self.direction_given(g, || Name::new("γ", "g"));
        let parts = [weight.clone() * down.cos(), weight.clone() * down.sin()];
        let arrow = if g.x == 0.0 && g.y < 0.0 { "↓" } else { "∥ g" };
        let known = [cell(&weight), vec![text(arrow)]];
        if let Some(action) = self.of_mass(body, Origin::Weight) {
            self.put_force(&action, &name, &parts, &known);
        }
        self.counts.loads[0] += 1;
    }
}

/// How many digits a number needs.
fn figures(x: f64) -> usize {
    let text = format!("{x:.11e}");
    let digits = text.split('e').next().unwrap_or_default().trim_end_matches('0');
    digits.chars().filter(char::is_ascii_digit).count()
}
