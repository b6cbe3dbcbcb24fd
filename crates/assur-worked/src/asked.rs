//! What the file asks for of guides, drives and transmissions, where no step has it yet.

use crate::angle::Angle;
use crate::course::Derivation;
use crate::document::Block;
use crate::motion::Stage;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::SAME;
use assur_model::model::{self, FindKind, Guide, PairId, PairKind, Query, Value};
use assur_model::structure::EffortSource;

impl Derivation<'_> {
    /// The questions of the file.
    pub(crate) fn questions(&self) -> Vec<Query> {
        let mechanism = self.scene.mechanism();
        let mut all = Vec::new();
        for find in &mechanism.finds {
            let FindKind::Value { expr, poseless: false, .. } = &find.kind else { continue };
            mechanism.each_query(expr, &mut |query| all.push(*query));
        }
        all
    }

    /// Coordinates of sliders and their rates: of the slider's point, from where the line of the guide begins.
    pub(crate) fn asked_of_guides(&mut self, stage: Stage) {
        let before = self.blocks.len();
        for query in self.questions() {
            let pair = match (stage, &query) {
                (Stage::Positions, Query::Displacement(pair) | Query::Travel(pair))
                | (Stage::Velocities, Query::RelativeVelocity(pair))
                | (Stage::Accelerations, Query::RelativeAcceleration(pair)) => *pair,
                _ => continue,
            };
            let query = if stage == Stage::Positions { Query::Displacement(pair) } else { query };
            if let Value::Scalar(value) = self.scene.view().query(&query) {
                self.along_its_guide(stage, pair, value);
            }
        }
        self.introduce(before, Message::AskedOfGuides);
    }

    /// A sentence before what has been written since.
    fn introduce(&mut self, before: usize, message: Message) {
        if self.blocks.len() > before {
            let words = say(self.language, message, &[]);
            self.insert(before, vec![Block::Paragraph(words)]);
        }
    }

    fn along_its_guide(&mut self, stage: Stage, pair: PairId, value: f64) -> Option<()> {
        let (letters, unit): (&[&str], Unit) = match stage {
            Stage::Positions => (&["s", "x", "y"], Unit::Length),
            Stage::Velocities => (&["v"], Unit::Velocity),
            Stage::Accelerations => (&["a"], Unit::Acceleration),
        };
        let own = self.scene.mechanism().pair(pair);
        let (PairKind::Prismatic(g) | PairKind::Slot(g)) = &own.kind else { return None };
        if own.bearing.is_some() || value == 0.0 || self.on_guide_with(letters, pair, value).is_some() {
            return None;
        }
        let right = self.part_along(stage, g)?;
        if (right.value() - value).abs() <= SAME * right.scale() {
            let name = Name::new(letters[0], &own.name);
            self.asked.insert(name.clone());
            self.equate(name, value, unit, right);
        }
        Some(())
    }

    /// The part along a guide of where the slider is, how fast it moves or how it accelerates against the guide.
    fn part_along(&mut self, stage: Stage, g: &Guide) -> Option<Expr> {
        let (slider, carrier) = (g.slider.index(), g.guide.index());
        let own = self.direction_given(g.along, || Name::new("λ", &self.label(carrier)));
        let angle: Angle = self.bodies[carrier].as_ref()?.angle.plus(&own);
        self.bodies[slider].as_ref()?;
        let here = self.position(slider, g.point);
        let point = self.point_name(slider, g.point);
        let (of, against) = match stage {
            Stage::Positions => (here, self.position(carrier, g.through)),
            Stage::Velocities => (self.velocity(slider, g.point), self.under(1, carrier, &point, &here)),
            Stage::Accelerations => {
                (self.acceleration(slider, g.point), self.under(2, carrier, &point, &here))
            }
        };
        let ([x, y], [u, w]) = (of, against);
        Some(angle.along(&[x - u, y - w]))
    }

    /// Powers of drives and couples of transmissions on their shafts.
    pub(crate) fn asked_of_forces(&mut self) {
        let before = self.blocks.len();
        for query in self.questions() {
            let Value::Scalar(value) = self.scene.view().query(&query) else { continue };
            let found = match &query {
                Query::EffortPower(id) => self.power_asked_for(EffortSource::Drive(*id)),
                Query::BalancePower(id) => self.power_asked_for(EffortSource::Balance(*id)),
                Query::Moment(pair, link) => self.couple_asked_for(*pair, link.index()),
                Query::ContactForce(pair, which) => self.contact_asked_for(*pair, *which, value),
                _ => None,
            };
            self.answered(found, value);
        }
        self.introduce(before, Message::AskedOfForces);
    }

    /// How far sliders have come from the end of their stroke, where this is found.
    pub(crate) fn asked_of_strokes(&mut self) {
        let before = self.blocks.len();
        for query in self.questions() {
            let (Query::Travel(pair), Value::Scalar(value)) = (&query, self.scene.view().query(&query))
            else {
                continue;
            };
            let found = self.travel_asked_for(*pair, value);
            let turns = matches!(found, Some((_, Unit::Angle, _)));
            self.answered(found, if turns { value.to_degrees() } else { value });
        }
        self.introduce(before, Message::AskedOfGuides);
    }

    fn answered(&mut self, found: Option<(Name, Unit, Expr)>, value: f64) {
        let Some((name, unit, right)) = found else { return };
        if value != 0.0 && (right.value() - value).abs() <= SAME * right.scale() {
            self.asked.insert(name.clone());
            self.equate(name, value, unit, right);
        }
    }

    fn travel_asked_for(&mut self, pair: PairId, value: f64) -> Option<(Name, Unit, Expr)> {
        let question = model::Expr::Query(Query::Displacement(pair));
        let turns = matches!(self.scene.mechanism().pair(pair).kind, PairKind::Revolute(_));
        let (here, letter, unit) = if turns {
            (self.degrees_in_letters(&question)?, "φ", Unit::Angle)
        } else {
            (self.in_letters(&question)?, "s", Unit::Length)
        };
        let value = if turns { value.to_degrees() } else { value };
        let pair = &self.scene.mechanism().pair(pair).name;
        let ends = ["min", "max"].map(|end| Name::new(letter, &format!("{end},{pair}")));
        let mut right = None;
        for (_, equation) in &self.equations {
            equation.right.visit(&mut |q| {
                if ends.contains(&q.name) {
                    let end = Expr::Leaf(std::sync::Arc::clone(q));
                    let turn = || Expr::Degrees(360);
                    let (on, back) = (here.clone() - end.clone(), end - here.clone());
                    let both = [on.clone(), back, on.clone() + turn(), on - turn()];
                    let near = |x: &Expr| (x.value() - value).abs() <= SAME * x.scale();
                    right = right.take().or_else(|| both.into_iter().find(near));
                }
            });
        }
        Some((Name::new(if turns { "Δφ" } else { "S" }, pair), unit, right?))
    }

    /// The force at one of two points where a slider touches its guide, from the normal force and the couple about the slider's point.
    fn contact_asked_for(&mut self, pair: PairId, which: u8, value: f64) -> Option<(Name, Unit, Expr)> {
        let named = self.scene.mechanism().pair(pair);
        let PairKind::Prismatic(g) = &named.kind else { return None };
        let [first, second] = g.contacts?;
        let (own, other) = if which == 1 { (first, second) } else { (second, first) };
        let place =
            |x: f64, i: u8| self.given(Name::new("c", &format!("{},{i}", named.name)), x, Unit::Length);
        let (own, other) = (place(own, which), place(other, 3 - which));
        let scalar = |query: Query| match self.scene.view().query(&query) {
            Value::Scalar(x) => x,
            _ => f64::NAN,
        };
        let normal = scalar(Query::Normal(pair, g.slider));
        let couple = scalar(Query::Moment(pair, g.slider));
        let normal = self.with_value(self.reactions_of(pair).into_iter(), normal)?;
        let couple = match self.with_value(self.couples_of(pair).into_iter(), couple) {
            Some(couple) => couple,
            None if couple.abs() <= SAME * normal.scale() * own.scale() => Expr::ZERO,
            None => return None,
        };
        let of = |m: Expr, r: Expr| (m - r * other.clone()) / (own.clone() - other.clone());
        let all = [
            of(couple.clone(), normal.clone()),
            of(-couple.clone(), normal.clone()),
            of(couple.clone(), -normal.clone()),
            of(-couple, -normal),
        ];
        let right = all.into_iter().find(|x| (x.value() - value).abs() <= SAME * x.scale())?;
        Some((Name::new("N", &format!("{},{which}", named.name)), Unit::Force, right))
    }

    fn power_asked_for(&mut self, source: EffortSource) -> Option<(Name, Unit, Expr)> {
        let slot = self.structure().efforts.iter().position(|effort| effort.source == source)?;
        let name = self.effort_name(slot, self.is_force(slot));
        let effort = self.found.get(&name).cloned()?;
        let right = self.power_of(slot, effort)?;
        Some((Name::new("P", &name.sub_or_letter()), Unit::Power, right))
    }

    fn couple_asked_for(&mut self, pair: PairId, body: usize) -> Option<(Name, Unit, Expr)> {
        let slot = self.scene.model.plan.laws.iter().position(|law| law.pair == pair)?;
        let right = self.couple_of_law(slot, body)?;
        let index = format!("{},{}", self.scene.mechanism().pair(pair).name, self.label(body));
        Some((Name::new("M", &index), Unit::Torque, right))
    }
}
