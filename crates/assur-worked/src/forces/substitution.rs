//! Two point masses in place of a link, where the file asks for them: m₁ l₁ = m₂ l₂ and m₁ + m₂ = m; dynamic with l₁ l₂ = J / m too.

use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{FindKind, Level, LinkId, MassProperties, Query, SubstitutionPart, Value};

/// A substitution that is asked for, by its first question, and its second point where the file chooses that.
#[derive(Clone, Copy, PartialEq)]
struct SubstitutionRequest {
    link: LinkId,
    first: Vec2,
    second: Option<Vec2>,
}

impl SubstitutionRequest {
    const fn query(&self, part: SubstitutionPart) -> Query {
        match self.second {
            None => Query::DynamicSubstitution(self.link, self.first, part),
            Some(second) => Query::StaticSubstitution(self.link, self.first, second, part),
        }
    }
}

impl Derivation<'_> {
    /// All substitutions that the file asks for.
    pub fn substitutions(&mut self) {
        let mechanism = self.scene.mechanism();
        let mut wanted: Vec<SubstitutionRequest> = Vec::new();
        for find in &mechanism.finds {
            let FindKind::Value { expr, .. } = &find.kind else { continue };
            mechanism.each_query(expr, &mut |query| {
                let one = match *query {
                    Query::DynamicSubstitution(link, first, _) => {
                        SubstitutionRequest { link, first, second: None }
                    }
                    Query::StaticSubstitution(link, first, second, _) => {
                        SubstitutionRequest { link, first, second: Some(second) }
                    }
                    _ => return,
                };
                if !wanted.contains(&one) {
                    wanted.push(one);
                }
            });
        }
        for one in wanted {
            if let Some(mass) = mechanism.link(one.link).mass {
                self.substitution(one, mass);
            }
        }
    }

    fn substitution(&mut self, one: SubstitutionRequest, mass: MassProperties) {
        let body = one.link.index();
        let centre = self.point_name(body, mass.centre);
        let Some(other) = one.second.or_else(|| self.vector_of(&one.query(SubstitutionPart::P2))) else {
            return;
        };
        let names = [one.first, other].map(|at| self.point_name(body, at));
        let message = if one.second.is_some() { Message::StaticMasses } else { Message::DynamicMasses };
        let parts = [self.label(body), names[0].clone(), names[1].clone()];
        self.say(message, &parts.map(|words| vec![text(words)]));
        let m = Name::new("m", &self.label(body));
        let m = self.found.get(&m).cloned().unwrap_or_else(|| self.given(m, mass.mass, Unit::Mass));
        let j = self.given(Name::new("J", &centre), mass.inertia, Unit::Inertia);
        let towards = (other - one.first) / (other - one.first).norm();
        let l_1 = self.length_along(&centre, &names[0], (mass.centre - one.first).dot(towards));
        let l_2 = match one.second {
            Some(second) => self.length_along(&centre, &names[1], (second - mass.centre).dot(towards)),
            None => {
                let name = Name::new("l", &crate::course::joined(&centre, &names[1]));
                let value = (other - mass.centre).norm();
                self.equate(name, value, Unit::Length, j.clone() / (m.clone() * l_1.clone()))
            }
        };
        let shares = [l_2.clone(), l_1.clone()];
        let asked = [SubstitutionPart::M1, SubstitutionPart::M2];
        let mut masses = Vec::new();
        for ((name, share), part) in names.iter().zip(shares).zip(asked) {
            let Some(value) = self.scalar_of(&one.query(part)) else { return };
            let right = m.clone() * share / (l_1.clone() + l_2.clone());
            masses.push(self.equate(Name::new("m", name), value, Unit::Mass, right));
        }
        if one.second.is_some()
            && let Some(value) = self.scalar_of(&one.query(SubstitutionPart::DJ))
        {
            let right = j - masses[0].clone() * l_1.squared() - masses[1].clone() * l_2.squared();
            self.equate(Name::new("ΔJ", ""), value, Unit::Inertia, right);
        }
        if self.scene.model.plan.effects.level >= Level::Accelerations {
            for ((at, name), own) in [one.first, other].into_iter().zip(&names).zip(masses) {
                self.inertia_of_mass((body, at), name, &own);
            }
        }
    }

    /// A distance along the line of the two masses; negative where the mass centre is not between them.
    fn length_along(&self, from: &str, to: &str, value: f64) -> Expr {
        self.given(Name::new("l", &crate::course::joined(from, to)), value, Unit::Length)
    }

    fn inertia_of_mass(&mut self, (body, at): (usize, Vec2), point: &str, own: &Expr) {
        let a = self.acceleration(body, at);
        let value = self.moved(body).acceleration(at) * -own.value();
        let name = Name::new("F", &format!("{}{point}", self.language.letters().inertia));
        let [x, y] = a;
        let parts = [
            self.equate(name.and("x"), value.x, Unit::Force, -(own.clone() * x)),
            self.equate(name.and("y"), value.y, Unit::Force, -(own.clone() * y)),
        ];
        if parts.iter().any(|part| !part.is_zero()) {
            self.magnitude(name, &parts);
        }
    }

    fn scalar_of(&self, query: &Query) -> Option<f64> {
        match self.scene.view().query(query) {
            Value::Scalar(x) if x.is_finite() => Some(x),
            _ => None,
        }
    }

    fn vector_of(&self, query: &Query) -> Option<Vec2> {
        match self.scene.view().query(query) {
            Value::Vector(v) if v.x.is_finite() => Some(v),
            _ => None,
        }
    }
}
