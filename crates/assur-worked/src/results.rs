//! The table of results: the questions of the file and all reactions, as the solver answers them.

use crate::course::Derivation;
use crate::document::{Inline, Line, Table, text};
use crate::questions::{question, question_of_couple, question_of_reaction};
use crate::words::{Message, RunMessage, phrase};
use assur_formula::{Expr, Node, Quantity, Unit, letters, name_node, unit_words};
use assur_math::math::{SAME, Vec2};
use assur_model::model::{Display, FindKind, LinkId, PairId, PairKind, Value};
use assur_text::units::{Dimension, significant};

const DIGITS: usize = 5;

impl Derivation<'_> {
    /// The table of results.
    pub fn results(&mut self) {
        if self.scene.mechanism().simulation.is_some() {
            let instant = self.instant(self.state().motion.time);
            self.say(RunMessage::ResultsAt, &[instant]);
        }
        let headers = [Message::Quantity, Message::Letters, Message::Value, Message::Unit];
        let headers = headers.map(|m| vec![text(self.words(m))]);
        let mut table = Table { headers: headers.into(), numbers: vec![2], ..Table::default() };
        let view = self.scene.view();
        let mechanism = self.scene.mechanism();
        let mut reactions = false;
        for (i, find) in mechanism.finds.iter().enumerate() {
            match &find.kind {
                FindKind::Value { display, expr, poseless } => {
                    if let Some(value) = view.found(i) {
                        let answered = self.answers.iter().find(|(own, _)| *own == i).map(|(_, n)| n.clone());
                        let own = self.symbol(&find.name, expr, value).or(answered);
                        let letters = own.or_else(|| self.of_design(value, display).filter(|_| *poseless));
                        let letters = letters.map(Inline::Math);
                        let asked = question(mechanism, self.scene.text, find, self.language);
                        self.row(&mut table, asked, letters.into_iter().collect(), value, display);
                    }
                }
                FindKind::Reactions => reactions = true,
                FindKind::Table(_) => {}
            }
        }
        if reactions && !self.state().forces.locked {
            let display = mechanism.display_of(Dimension::FORCE);
            for (i, pair) in mechanism.pairs.iter().enumerate() {
                if matches!(pair.kind, PairKind::Transmission(_)) || self.unplaced[i] {
                    continue;
                }
                let links = pair.kind.links();
                let Some((from, others)) = links.split_first() else { continue };
                for on in others {
                    let force = view.reaction(PairId::at(i), *on);
                    if force.x.is_nan() && view.shares_friction(PairId::at(i)) {
                        continue;
                    }
                    let letters = name_node(&self.reaction_name(from.index(), on.index()).arrow());
                    let letters = vec![Inline::Math(letters)];
                    let asked = question_of_reaction(mechanism, PairId::at(i), *on, self.language);
                    self.row(&mut table, asked, letters, Value::Vector(force), &display);
                    self.couple(&mut table, PairId::at(i), *on);
                }
            }
        }
        if table.rows.iter().all(|row| row[1].is_empty()) {
            table.headers.remove(1);
            table.rows.iter_mut().for_each(|row| drop(row.remove(1)));
            table.numbers = vec![1];
        }
        self.table(table);
    }

    /// The couple of a guide or a weld on a link, where it is determined.
    fn couple(&self, table: &mut Table, pair: PairId, on: LinkId) {
        let (view, mechanism) = (self.scene.view(), self.scene.mechanism());
        let value = view.moment(pair, on);
        let kind = &mechanism.pair(pair).kind;
        if !matches!(kind, PairKind::Prismatic(_) | PairKind::Weld { .. }) || !value.is_finite() {
            return;
        }
        let is_it = |x: &Expr| (x.value().abs() - value.abs()).abs() <= SAME * value.abs();
        let names = self.couples_of(pair).into_iter();
        let found = names.filter_map(|name| self.found.get(&name).cloned()).find(is_it);
        // the step may have that on the other link
        let signed = |found: Expr| if found.value() * value < 0.0 { -found } else { found };
        let letters = found.map(|found| Inline::Math(letters(&signed(found)))).into_iter().collect();
        let asked = question_of_couple(mechanism, pair, on, self.language);
        self.row(table, asked, letters, Value::Scalar(value), &mechanism.display_of(Dimension::TORQUE));
    }

    /// The letters of a number that needs no position, as the sections on cycles, cams, flywheels and gears have it.
    fn of_design(&self, value: Value, display: &Display) -> Option<Node> {
        let (Value::Scalar(x), Some(unit)) = (value, unit_of(display.dimension)) else { return None };
        let x = if unit == Unit::Angle { x.to_degrees() } else { x };
        let alike = |own: Unit| own == unit || own == Unit::Work && unit == Unit::Torque;
        let is_it = |q: &Quantity| alike(q.unit) && (q.value - x).abs() <= SAME * x.abs();
        let derived = self.equations.iter().map(|(_, e)| &*e.left);
        derived.chain(&self.design_values).find(|q| is_it(q)).map(|found| name_node(&found.name))
    }

    fn row(&self, table: &mut Table, asked: Line, letters: Line, value: Value, display: &Display) {
        let large = self.scene.greatest.in_unit(display);
        let clear = |x: f64| if x.abs() <= 1e-11 * large { 0.0 } else { x };
        let figure = |x: f64| significant(clear(x), DIGITS).replace('-', "−");
        let written = match value {
            Value::Scalar(x) => figure(display.of_si(x)),
            Value::Vector(v) => {
                let v: Vec2 = display.of_si_vector(v);
                format!("({}, {}), |…| = {}", figure(v.x), figure(v.y), figure(v.norm()))
            }
            Value::Bool(truth) => phrase(self.language, &truth.to_string()),
        };
        table.rows.push(vec![
            asked,
            letters,
            vec![text(written)],
            vec![text(self.language.unit(&unit_words(&display.unit)))],
        ]);
    }
}

// The units of equations.

/// The unit of equations of a dimension.
#[must_use]
pub const fn unit_of(dimension: [i8; 4]) -> Option<Unit> {
    Some(match dimension {
        [0, 0, 0, 0] => Unit::One,
        [0, 0, 0, _] => Unit::Angle,
        [1, 0, 0, _] => Unit::Length,
        [2, 0, 0, _] => Unit::Area,
        [1, 0, -1, _] => Unit::Velocity,
        [1, 0, -2, _] => Unit::Acceleration,
        [1, 0, -3, _] => Unit::Jerk,
        [0, 0, -3, 1] => Unit::AngularJerk,
        [0, 0, -1, 1] => Unit::AngularVelocity,
        [0, 0, -2, 1] => Unit::AngularAcceleration,
        [0, 1, 0, _] => Unit::Mass,
        [2, 1, 0, _] => Unit::Inertia,
        [1, 1, -2, _] => Unit::Force,
        [2, 1, -2, _] => Unit::Torque,
        [2, 1, -3, _] => Unit::Power,
        [0, 1, -2, _] => Unit::Stiffness,
        _ => return None,
    })
}
