//! What the file asks for and no step has: it is found from what the steps have, by the letters of the question.

use crate::course::Derivation;
use crate::document::Block;
use crate::forces::quantity_name;
use crate::results::unit_of;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Node, Unit, letters, name_node};
use assur_math::math::SAME;
use assur_model::model::{self, FindKind, Function, PairId, PointRef, Query, SpringId, Value};
use assur_position::position::Origin;

impl Derivation<'_> {
    /// Questions without an answer in the steps.
    pub(crate) fn asked_besides(&mut self) {
        let before = self.blocks.len();
        let mechanism = self.scene.mechanism();
        for (i, find) in mechanism.finds.iter().enumerate() {
            let FindKind::Value { expr, display, .. } = &find.kind else { continue };
            let Some(value) = self.scene.view().found(i) else { continue };
            if value.magnitude() == 0.0 || self.symbol(&find.name, expr, value).is_some() {
                continue;
            }
            let expr = match expr {
                model::Expr::Quantity(id) => mechanism.quantities.get(id.index()).map_or(expr, |q| &q.expr),
                other => other,
            };
            let node = match value {
                Value::Scalar(x) => self.number_asked(&find.name, expr, x, unit_of(display.dimension)),
                Value::Vector(_) => self.vector_asked(&find.name, expr, unit_of(display.dimension)),
                Value::Bool(_) => None,
            };
            self.answers.extend(node.map(|node| (i, node)));
        }
        self.optional.extend(before..self.blocks.len());
        if self.equations.iter().any(|(place, e)| *place >= before && self.asked.contains(&e.left.name)) {
            let words = say(self.language, Message::AskedBesides, &[]);
            self.insert(before, vec![Block::Paragraph(words)]);
        }
    }

    fn number_asked(
        &mut self,
        words: &str,
        of: &model::Expr,
        value: f64,
        unit: Option<Unit>,
    ) -> Option<Node> {
        let (value, right) = match of {
            model::Expr::Query(Query::PressureAngle(pair)) => {
                (value.to_degrees(), self.pressure_angle(*pair)?)
            }
            model::Expr::Query(Query::TransmissionAngle(group)) => {
                (value.to_degrees(), self.transmission_angle(*group)?)
            }
            _ if unit == Some(Unit::Angle) => (value.to_degrees(), self.degrees_in_letters(of)?),
            _ => (value, self.power_by_words(words).or_else(|| self.in_letters(of))?),
        };
        if (right.value() - value).abs() > SAME * right.scale().max(value.abs()) {
            return None;
        }
        if right.is_constant() {
            return None;
        }
        if is_plain(&right) {
            return Some(letters(&right));
        }
        let (name, unit) = (self.letters_of(words, of)?, unit?);
        self.asked.insert(name.clone());
        let found = self.equate(name, value, unit, right);
        Some(letters(&found))
    }

    fn vector_asked(&mut self, words: &str, of: &model::Expr, unit: Option<Unit>) -> Option<Node> {
        let (unit, parts) = (unit?, self.vector_in_letters(of)?);
        let Value::Vector(v) = self.scene.view().value(of) else { return None };
        let near = |part: &Expr, x: f64| (part.value() - x).abs() <= SAME * part.scale().max(v.norm());
        if !(near(&parts[0], v.x) && near(&parts[1], v.y)) {
            return None;
        }
        if parts.iter().all(is_plain) {
            return Some(Node::Row(vec![letters(&parts[0]), Node::Operator(","), letters(&parts[1])]));
        }
        let name = self.letters_of(words, of)?;
        let names = if unit == Unit::Length {
            ["x", "y"].map(|axis| Name::new(axis, &name.sub_or_letter()))
        } else {
            ["x", "y"].map(|axis| name.and(axis))
        };
        let [x, y] = parts;
        for ((own, value), right) in names.iter().zip([v.x, v.y]).zip([x, y]) {
            self.asked.insert(own.clone());
            self.equate_or_nothing(own, value, unit, right);
        }
        Some(match unit {
            Unit::Length => Node::Row(vec![name_node(&names[0]), Node::Operator(","), name_node(&names[1])]),
            _ => name_node(&name.arrow()),
        })
    }

    /// The power of a weight or of a spring, by the words of its column.
    fn power_by_words(&mut self, words: &str) -> Option<Expr> {
        let mechanism = self.scene.mechanism();
        let powers = match (words.strip_prefix("weight of "), words.strip_prefix("spring ")) {
            (Some(link), _) => {
                let body = mechanism.links.iter().position(|own| own.name == link)?;
                self.powers_on(&[body], |from| from == Some(Origin::Weight))
            }
            (_, Some(spring)) => {
                let id = SpringId::at(mechanism.springs.iter().position(|own| own.name == spring)?);
                vec![self.power_from(Origin::Spring(id))]
            }
            _ => return None,
        };
        Some(Expr::sum(powers)).filter(|power| !power.is_zero())
    }

    /// The letters of a question: its own name, else by what it asks for.
    fn letters_of(&self, words: &str, of: &model::Expr) -> Option<Name> {
        let is_name = words.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'');
        if is_name {
            return Some(quantity_name(words));
        }
        let pair = |pair: &PairId| self.scene.mechanism().pair(*pair).name.clone();
        let of_pair =
            |letter: &str, begin: &str, own: &PairId| Name::new(letter, &format!("{begin}{}", pair(own)));
        let with_link = |letter: &str, begin: &str, own: &PairId, on: &Option<model::LinkId>| {
            let link = on.map(|link| format!(",{}", self.label(link.index()))).unwrap_or_default();
            Name::new(letter, &format!("{begin}{}{link}", pair(own)))
        };
        Some(match of {
            model::Expr::Query(query) => match query {
                Query::KineticEnergy => Name::new("T", ""),
                Query::Flywheel(..) => Name::new("J", "r"),
                Query::PotentialEnergy | Query::TorsionEnergy(..) => Name::new("V", ""),
                Query::CurvatureRadius(PointRef::Fixed(link, at)) => {
                    Name::new("ρ", &self.point_name(link.index(), *at))
                }
                Query::CurvatureCentre(PointRef::Fixed(link, at)) => {
                    Name::new("K", &format!("K{}", self.point_name(link.index(), *at)))
                }
                Query::Sliding(own) => of_pair("v", "s,", own),
                Query::PressureAngle(own) => of_pair("α", "", own),
                Query::TransmissionAngle(group) => {
                    Name::new("μ", &self.scene.mechanism().groups.get(*group)?.name)
                }
                Query::TangentialForce(own, on) => with_link("F", "t,", own, on),
                Query::ToothForce(own, on) => with_link("F", "n,", own, on),
                Query::Tension(own, _, end) => {
                    let ends = &self.transmission(*own)?.ends;
                    let end = if *end == Some(0) { ends.first() } else { ends.last() };
                    Name::new("F", &format!("{},{}", pair(own), end?))
                }
                Query::TightSide(own) => of_pair("F", "1,", own),
                Query::SlackSide(own) => of_pair("F", "2,", own),
                Query::Capacity(own) => of_pair("F", "max,", own),
                Query::LoadPower(id) => {
                    let load = self.scene.mechanism().loads.get(id.index())?;
                    let name = self.load_letters(id.index(), load);
                    Name::new("P", &format!("{}{}", name.letter, name.sub))
                }
                Query::SpringPower(i) => Name::new("P", &self.scene.mechanism().springs.get(*i)?.name),
                Query::Reaction(own, on) => with_link("R", "", own, &Some(*on)),
                Query::LineOffset(own) => of_pair("s", "R,", own),
                _ => return None,
            },
            model::Expr::Call(Function::Abs, inner) => self.letters_of(words, inner.first()?)?,
            model::Expr::Binary(..) if words.starts_with("energy(") => Name::new("E", ""),
            model::Expr::Binary(..) if words.starts_with("potential_energy(") => Name::new("V", ""),
            _ => self.by_words(words)?,
        })
    }

    /// Letters by the function that is called: its arguments are the index.
    fn by_words(&self, words: &str) -> Option<Name> {
        if let Some(link) = words.strip_prefix("weight of ") {
            return Some(Name::new("P", &format!("G{}", self.label_of(link)?)));
        }
        if let Some(spring) = words.strip_prefix("spring ") {
            return Some(Name::new("P", &format!("F{spring}")));
        }
        if let Some(link) = words.strip_prefix("inertia of ") {
            let inertia = self.language.letters().inertia;
            return Some(Name::new("P", &format!("{inertia}{}", self.label_of(link)?)));
        }
        let (function, arguments) = words.strip_suffix(')')?.split_once('(')?;
        let index: Vec<&str> = arguments.split(',').map(str::trim).collect();
        let letter = match function {
            "distance" => "d",
            "instant_centre" => return Some(Name::new("P", &format!("P{}", self.labels(&index)?))),
            "dir" => {
                let (of, what) = arguments.trim_end_matches(')').split_once('(')?;
                let letter = match of {
                    "velocity" => "v",
                    "acceleration" => "a",
                    "reaction" => "R",
                    _ => return None,
                };
                return Some(Name::new("δ", &format!("{letter}{}", what.split(',').next()?)));
            }
            "mag" => match arguments.split_once('(')? {
                ("reaction", pair) => {
                    let pair = pair.trim_end_matches(')').split(',').next()?;
                    return Some(Name::new("R", pair));
                }
                _ => return None,
            },
            _ => return None,
        };
        Some(Name::new(letter, &index.join(",")))
    }

    fn label_of(&self, link: &str) -> Option<String> {
        let links = &self.scene.mechanism().links;
        links.iter().position(|own| own.name == link).map(|i| self.label(i))
    }

    /// The numbers of links next to each other; names apart. Of one link the ground is the other.
    fn labels(&self, links: &[&str]) -> Option<String> {
        let labels: Option<Vec<String>> = links.iter().map(|link| self.label_of(link)).collect();
        let labels = labels?;
        let short = labels.iter().all(|label| label.chars().count() == 1);
        Some(labels.join(if short { "" } else { "," }))
    }
}

/// Whether letters are of one quantity as it is, of its opposite or its magnitude, or with whole turns.
fn is_plain(right: &Expr) -> bool {
    match right {
        Expr::Leaf(_) => true,
        Expr::Neg(x) | Expr::Abs(x) => matches!(**x, Expr::Leaf(_)),
        Expr::Sum(terms) => {
            matches!(terms.as_slice(), [(_, Expr::Leaf(_)), (_, Expr::Degrees(_))])
        }
        _ => right.is_zero(),
    }
}
