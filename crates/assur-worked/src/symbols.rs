//! The letters under which the steps have what the file asks for.

use crate::course::{Derivation, joined};
use crate::forces::quantity_name;
use assur_formula::{Expr, Name, Node, Unit, letters, name_node};
use assur_math::math::{SAME, Vec2};
use assur_model::model::{
    self, AlongLink, Cut, Function, Internal, InternalPart, LoadId, ModePart, PairId, PairKind, PointRef,
    Query, SubstitutionPart, Value,
};
use assur_text::units::significant;

impl Derivation<'_> {
    /// The letters of a question's answer; none where no step has them.
    pub(crate) fn symbol(&mut self, name: &str, of: &model::Expr, value: Value) -> Option<Node> {
        match value {
            Value::Scalar(x) => {
                let own = self.found.get(&quantity_name(name)).cloned();
                let found = own.filter(|own| is_same(own, x)).or_else(|| self.symbol_of(of))?;
                [found.clone(), -found.clone(), found.abs()]
                    .into_iter()
                    .find(|found| is_same(found, x) && !found.is_constant())
                    .map(|found| letters(&found))
            }
            Value::Vector(v) => match of {
                model::Expr::Query(Query::Position(PointRef::Fixed(link, at))) => {
                    let point = self.point_name(link.index(), *at);
                    let [x, y] = ["x", "y"].map(|axis| name_node(&Name::new(axis, &point)));
                    self.points[0].contains_key(&point).then(|| Node::Row(vec![x, Node::Operator(","), y]))
                }
                _ => self.vector_symbol(of, v).map(|name| name_node(&name.arrow())),
            },
            Value::Bool(_) => None,
        }
    }

    fn symbol_of(&mut self, of: &model::Expr) -> Option<Expr> {
        use model::Expr as E;
        match of {
            E::Quantity(id) => {
                let quantity = self.scene.mechanism().quantities.get(id.index())?;
                self.symbol_of(&quantity.expr)
            }
            E::Negate(inner) => self.symbol_of(inner).map(|found| -found),
            E::Call(Function::Abs, args) => args.first().and_then(|inner| self.symbol_of(inner)),
            E::Call(Function::Mag, args) => match args.as_slice() {
                [inner] => self.magnitude_symbol(inner),
                _ => None,
            },
            E::Query(query) => self.scalar_symbol(query),
            E::Frictionless(inner) => {
                let Value::Scalar(x) = self.scene.view().value(of) else { return None };
                let own = self.symbol_of(inner)?;
                let Expr::Leaf(q) = own else { return None };
                let index = if q.name.sub.is_empty() { "0".to_owned() } else { format!("{},0", q.name.sub) };
                self.with_value([Name::new(&q.name.letter, &index)].into_iter(), x)
            }
            _ => self.result(of),
        }
    }

    /// The letters of a force inside a link, which the table of its pieces gives.
    fn inside(&self, asked: &Internal) -> (Name, Unit) {
        let (label, part) = (self.label(asked.link.index()), asked.part.name());
        let unit = if asked.part == InternalPart::Moment { Unit::Torque } else { Unit::Force };
        match asked.at {
            Cut::At(x) => (Name::new(part, &format!("{label},{}", significant(x, 6))), unit),
            Cut::Extreme(AlongLink { greatest, place }) => {
                let which = if greatest { "max" } else { "min" };
                if place {
                    (Name::new("x", &format!("{part},{which}")), Unit::Length)
                } else {
                    (Name::new(part, &format!("{label},{which}")), unit)
                }
            }
        }
    }

    /// A number that a step has under letters of the question.
    pub(crate) fn scalar_symbol(&mut self, query: &Query) -> Option<Expr> {
        let Value::Scalar(value) = self.scene.view().query(query) else { return None };
        let inertia = self.language.letters().inertia;
        let indexed = |letter: &str, index: String| vec![Name::new(letter, &index)];
        let names = match query {
            Query::InertiaTorque(link) => indexed("M", format!("{inertia}{}", self.label(link.index()))),
            Query::InertiaArm(link) => indexed("h", format!("{inertia}{}", self.label(link.index()))),
            Query::Vibration(which, part) => {
                let number = (which + 1).to_string();
                let (letter, index, unit) = match part {
                    ModePart::Natural => ("ω", format!("0,{number}"), Unit::AngularVelocity),
                    ModePart::Ratio => ("ζ", number, Unit::One),
                    ModePart::Damped => ("ω", format!("d,{number}"), Unit::AngularVelocity),
                };
                return Some(self.stated(Name::new(letter, &index), value, unit));
            }
            Query::Internal(asked) => {
                let (name, unit) = self.inside(asked);
                return Some(self.stated(name, value, unit));
            }
            Query::Axial(link) => indexed("N", self.label(link.index())),
            Query::Normal(pair, _) => {
                let declared = self.scene.mechanism().pair(*pair);
                let parts = matches!(declared.kind, PairKind::Contact { parts: true, .. });
                if parts { indexed("N", declared.name.clone()) } else { self.reactions_of(*pair) }
            }
            Query::Moment(pair, _) if self.scene.mechanism().pair(*pair).kind.slipping().is_some() => {
                let load = self.scene.view().load_of_clutch(*pair)?;
                return self.derived(&Query::Load(LoadId::at(load)));
            }
            Query::Moment(pair, _) => {
                let friction = Name::new("M", &format!("f{}", self.scene.mechanism().pair(*pair).name));
                self.couples_of(*pair).into_iter().chain([friction]).collect()
            }
            Query::LineOffset(pair) => self.lettered("h", *pair),
            Query::Efficiency => vec![Name::new("η", "")],
            Query::DynamicSubstitution(.., part) | Query::StaticSubstitution(.., part) => {
                let letter = match part {
                    SubstitutionPart::M1 | SubstitutionPart::M2 => "m",
                    SubstitutionPart::L2 => "l",
                    SubstitutionPart::DJ => "ΔJ",
                    _ => return None,
                };
                return self.found_with(|name| name.letter.trim_end_matches('′') == letter, value);
            }
            Query::ContactForce(pair, which) => {
                indexed("N", format!("{},{which}", self.scene.mechanism().pair(*pair).name))
            }
            Query::Travel(pair) => {
                let words = self.scene.mechanism().pair(*pair).name.clone();
                let turned = self.found.get(&Name::new("Δφ", &words)).cloned();
                return turned.or_else(|| self.with_value([Name::new("S", &words)].into_iter(), value));
            }
            Query::Displacement(pair) => {
                let pair = *pair;
                return match &self.scene.mechanism().pair(pair).kind {
                    PairKind::Cylinder { from, to, .. } => {
                        let ends = [from, to].map(|pin| self.point_name(pin.link.index(), pin.at));
                        let index = joined(&ends[0], &ends[1]);
                        self.found_with(|name| matches!(&*name.letter, "s" | "l") && name.sub == index, value)
                    }
                    _ => self.on_guide_with(&["s", "x", "y"], pair, value),
                };
            }
            Query::RelativeVelocity(pair) => return self.on_guide_with(&["v"], *pair, value),
            Query::RelativeAcceleration(pair) => return self.on_guide_with(&["a"], *pair, value),
            Query::AngularJerk(link) => {
                let own = Name::new("ζ", &self.label(link.index()));
                return self.found_with(|name| *name == own, value);
            }
            Query::RelativeJerk(pair) => {
                let own = Name::new("j", &self.scene.mechanism().pair(*pair).name);
                return self.found_with(|name| *name == own, value);
            }
            Query::TangentialForce(pair, _) => {
                let name = self.scene.mechanism().pair(*pair).name.clone();
                let is = |own: &Name| own.letter == "F" && own.sub.split(',').next() == Some(name.as_str());
                return self.found_with(is, value);
            }
            Query::Friction(pair, _) => {
                let index = format!("f{}", self.scene.mechanism().pair(*pair).name);
                return self.found_with(|own| own.sub == index && "FM".contains(&*own.letter), value);
            }
            Query::BalancePower(_)
            | Query::EffortPower(_)
            | Query::LoadPower(_)
            | Query::FrictionPower(_) => {
                return self.found_with(|name| name.letter.trim_end_matches('′') == "P", value);
            }
            _ => return self.number_of(query),
        };
        self.with_value(names.into_iter(), value)
    }

    fn magnitude_symbol(&mut self, of: &model::Expr) -> Option<Expr> {
        let model::Expr::Query(query) = of else {
            if let model::Expr::Quantity(id) = of {
                let expr = self.scene.mechanism().quantities.get(id.index())?.expr.clone();
                return self.magnitude_symbol(&expr);
            }
            return None;
        };
        let Value::Vector(v) = self.scene.view().query(query) else { return None };
        let names = match query {
            Query::Reaction(..) | Query::InertiaForce(_) => return self.magnitude_of(query),
            Query::Coriolis(_) => {
                return self.found_with(|name| name.letter == "a" && name.sup == "k", v.norm());
            }
            _ => vec![self.vector_name(query, v)?],
        };
        let one_part = |name: &Name| ["x", "y"].map(|axis| name.and(axis));
        let names = names.iter().cloned().chain(names.iter().flat_map(one_part));
        self.with_value(names.collect::<Vec<_>>().into_iter(), v.norm())
    }

    fn vector_symbol(&mut self, of: &model::Expr, v: Vec2) -> Option<Name> {
        match of {
            model::Expr::Quantity(id) => {
                let expr = self.scene.mechanism().quantities.get(id.index())?.expr.clone();
                self.vector_symbol(&expr, v)
            }
            model::Expr::Query(query) => self.vector_name(query, v),
            _ => None,
        }
    }

    /// The letters of a vector, where one of its parts or its magnitude has been found by them.
    fn vector_name(&mut self, query: &Query, v: Vec2) -> Option<Name> {
        let inertia = self.language.letters().inertia;
        let name = match query {
            Query::Velocity(PointRef::Fixed(link, at)) => Name::new("v", &self.point_name(link.index(), *at)),
            Query::Acceleration(PointRef::Fixed(link, at)) => {
                Name::new("a", &self.point_name(link.index(), *at))
            }
            Query::Jerk(PointRef::Fixed(link, at)) => Name::new("j", &self.point_name(link.index(), *at)),
            Query::InertiaForce(link) => Name::new("F", &format!("{inertia}{}", self.label(link.index()))),
            Query::Coriolis(_) => {
                let is_own = |(name, x): &(&Name, &Expr)| {
                    name.letter == "a" && name.sup == "k" && near(x.value().abs(), v.norm())
                };
                return self.found.iter().find(is_own).map(|(name, _)| name.clone());
            }
            Query::Reaction(pair, _) => {
                let mesh = Name::new("F", &self.scene.mechanism().pair(*pair).name);
                let names = self.reactions_of(*pair).into_iter().chain([mesh]);
                return names.into_iter().find(|name| self.has_parts(name, v));
            }
            Query::DynamicSubstitution(.., part) | Query::StaticSubstitution(.., part) => {
                let letter = match part {
                    SubstitutionPart::A2 => "a",
                    SubstitutionPart::F1 | SubstitutionPart::F2 => "F",
                    _ => return None,
                };
                let found = self.found.iter().find(|(name, x)| {
                    name.letter.trim_end_matches('′') == letter
                        && name.sub.ends_with('x')
                        && near(x.value(), v.x)
                        && self.has_parts(&without_axis(name), v)
                });
                return found.map(|(name, _)| without_axis(name));
            }
            _ => return None,
        };
        self.has_parts(&name, v).then_some(name)
    }

    /// Whether the parts of a vector, or all of it, have been found by these letters.
    fn has_parts(&self, name: &Name, v: Vec2) -> bool {
        let found = |name: &Name, value: f64| {
            self.found.get(name).is_some_and(|x| near(x.value().abs(), value.abs()))
        };
        let part = |axis: &str, x: f64| x.abs() <= SAME * v.norm() || found(&name.and(axis), x);
        let any = found(&name.and("x"), v.x) || found(&name.and("y"), v.y);
        found(name, v.norm()) || any && part("x", v.x) && part("y", v.y)
    }

    /// The letters of the couples in a pair: of guides, and of transmissions on their shafts.
    pub(crate) fn couples_of(&self, pair: PairId) -> Vec<Name> {
        let reactions = self.reactions_of(pair);
        let couples = reactions.iter().map(|name| Name::new("M", &name.sub));
        let own = |name: &&Name| name.letter == "M" && reactions.iter().any(|r| r.sub == name.sub);
        let others = self.found.keys().filter(own).cloned();
        let transmission = self.scene.mechanism().pair(pair).name.clone();
        let of_law = self
            .found
            .keys()
            .filter(|name| name.letter == "M" && name.sub.split(',').next() == Some(transmission.as_str()));
        couples.chain(others).chain(of_law.cloned()).collect()
    }

    /// A letter with the index of the reactions in a pair.
    fn lettered(&self, letter: &str, pair: PairId) -> Vec<Name> {
        self.reactions_of(pair).iter().map(|name| Name::new(letter, &name.sub)).collect()
    }

    /// A coordinate of a slider, or its rate, by these letters: with the index of its pair, or of its point.
    pub(crate) fn on_guide_with(&self, found_by: &[&str], pair: PairId, value: f64) -> Option<Expr> {
        let own = self.scene.mechanism().pair(pair);
        let (PairKind::Prismatic(g) | PairKind::Slot(g)) = &own.kind else { return None };
        let point = self.point_name(g.slider.index(), g.point);
        let is = |name: &Name| {
            let letter = name.letter.trim_end_matches('′');
            let of_point = name.sub.starts_with(&point) || name.sub.ends_with(&point);
            found_by.contains(&letter) && (name.sub == own.name || of_point)
        };
        self.found_with(is, value)
    }

    fn found_with(&self, is: impl Fn(&Name) -> bool, value: f64) -> Option<Expr> {
        let found = self.found.iter().find(|(name, x)| is(name) && near(x.value().abs(), value.abs()));
        found.map(|(_, x)| x.clone())
    }
}

/// A name without the axis at its end.
fn without_axis(name: &Name) -> Name {
    let sub = name.sub.strip_suffix('x').unwrap_or(&name.sub);
    Name { sub: sub.trim_end_matches(',').to_owned(), ..name.clone() }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * b.abs()
}

fn is_same(found: &Expr, value: f64) -> bool {
    let own = found.value();
    near(own, value) || near(own, value.to_degrees()) || value == 0.0 && own.abs() <= SAME * found.scale()
}
