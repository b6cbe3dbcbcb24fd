//! What is written of things without a position: equations from given and found values.

use crate::course::plain;
use crate::document::{Block, Line, Table, text};
use crate::words::{DesignMessage as Message, Language, say};
use assur_formula::{Equation, Expr, Lines, Name, Node, Quantity, Unit, name_node};
use assur_model::model::{FindKind, PairId, PairKind, Query};
use assur_solve::solve::{Model, Solution};
use std::sync::Arc;

/// Steps as they are written.
#[derive(Clone, Debug)]
pub struct Page {
    /// The language of its sentences.
    pub language: Language,
    /// What has been written.
    pub blocks: Vec<Block>,
    /// The equations, each with its place among the blocks.
    pub equations: Vec<(usize, Equation)>,
    /// Before which blocks the reduced torques of flywheels at one position go, by the number of the flywheel.
    pub reduced: Vec<(usize, usize)>,
    /// Values of the solver without a formula.
    pub values: Vec<Quantity>,
    /// Formulas that do not agree with the solver: they are not written.
    pub disagreements: Vec<String>,
}

impl Page {
    pub(super) const fn new(language: Language) -> Self {
        Self {
            language,
            blocks: Vec::new(),
            equations: Vec::new(),
            reduced: Vec::new(),
            values: Vec::new(),
            disagreements: Vec::new(),
        }
    }

    pub(super) fn heading(&mut self, message: Message, parts: &[Line]) {
        let words = plain(&say(self.language, message, parts));
        self.blocks.push(Block::Heading(2, words));
    }

    pub(super) fn say(&mut self, message: Message, parts: &[Line]) {
        self.blocks.push(Block::Paragraph(say(self.language, message, parts)));
    }

    pub(super) fn words(&self, message: Message) -> Line {
        vec![text(plain(&say(self.language, message, &[])))]
    }

    pub(super) fn table(&mut self, headers: Vec<Line>, rows: Vec<Vec<Line>>) {
        if !rows.is_empty() {
            let numbers = (1..headers.len()).collect();
            self.blocks.push(Block::Table(Table { headers, rows, numbers }));
        }
    }

    /// Writes an equation for a value of the solver; a formula that does not agree is not printed.
    pub(super) fn equate(&mut self, name: Name, value: f64, unit: Unit, right: Expr) -> Expr {
        if right.is_zero() {
            return Expr::ZERO;
        }
        let equation = Equation::new(name, value, unit, right);
        if equation.disagrees().is_some() || !equation.right.value().is_finite() {
            let letters = assur_formula::text_lines(&equation.lines());
            self.disagreements.push(letters);
            return self.stated(equation.left.name.clone(), value, unit);
        }
        self.equations.push((self.blocks.len(), equation.clone()));
        self.blocks.push(Block::Equation(equation.lines()));
        equation.found()
    }

    /// An intermediate quantity: its value is that of its formula.
    pub(super) fn named(&mut self, name: Name, unit: Unit, right: Expr) -> Expr {
        let value = right.value();
        self.equate(name, value, unit, right)
    }

    /// A value of the solver without a formula.
    pub(super) fn stated(&mut self, name: Name, value: f64, unit: Unit) -> Expr {
        let q = Quantity { name, value, unit, scale: value.abs(), given: false, rounding: 0.0 };
        self.values.push(q.clone());
        let figures = q.figures(5);
        let mut row = vec![Node::Operator("=")];
        match unit {
            Unit::Angle => row.push(Node::Degrees(figures)),
            Unit::One => row.push(Node::Number(figures)),
            unit => row.extend([Node::Number(figures), Node::Unit(unit.text().to_owned())]),
        }
        self.blocks
            .push(Block::Equation(Lines { left: name_node(&q.name), rows: vec![(Node::Row(row), false)] }));
        Expr::Leaf(Arc::new(q))
    }
}

/// A value of the file.
pub(super) fn given(name: Name, value: f64, unit: Unit) -> Expr {
    if value == 0.0 {
        return Expr::ZERO;
    }
    Expr::Leaf(Arc::new(Quantity { name, value, unit, scale: value.abs(), given: true, rounding: 0.0 }))
}

/// A value that is chosen to show a formula.
pub(super) fn chosen(name: Name, value: f64, unit: Unit) -> Expr {
    Expr::Leaf(Arc::new(Quantity { name, value, unit, scale: value.abs(), given: false, rounding: 0.0 }))
}

// Quantities of the cycle: extreme positions, stroke, the ratio of the times out and back.

impl Page {
    /// The pairs whose stroke, extreme positions or ratio of times the file asks for.
    pub(super) fn cycle(&mut self, model: &Model<'_>, solution: &Solution) {
        let mechanism = model.mechanism;
        let mut pairs: Vec<PairId> = Vec::new();
        for find in &mechanism.finds {
            let FindKind::Value { expr, .. } = &find.kind else { continue };
            mechanism.each_query(expr, &mut |query| {
                if let Query::Stroke(pair)
                | Query::TimeRatio(pair)
                | Query::Dead(pair, _)
                | Query::Travel(pair) = query
                    && !pairs.contains(pair)
                {
                    pairs.push(*pair);
                }
            });
        }
        let statics = &solution.statics;
        let known =
            |pair: &PairId| statics.stroke(*pair).is_finite() && statics.time_ratio(*pair).is_finite();
        pairs.retain(known);
        for pair in pairs {
            let named = mechanism.pair(pair);
            let turns = matches!(named.kind, PairKind::Revolute(_));
            self.heading(Message::CycleOf, &[vec![text(named.name.clone())]]);
            self.say(Message::ExtremesOf, &[vec![text(named.name.clone())]]);
            let letter = |letter: &str, more: &str| Name::new(letter, &format!("{more},{}", named.name));
            let angle = |which: u8| statics.dead(pair, which).to_degrees();
            let one = self.stated(letter("φ", "1"), angle(1), Unit::Angle);
            let two = self.stated(letter("φ", "2"), angle(2), Unit::Angle);
            let (unit, scale) =
                if turns { (Unit::Angle, 180.0 / std::f64::consts::PI) } else { (Unit::Length, 1.0) };
            let sort = if turns { "φ" } else { "s" };
            let least = self.stated(letter(sort, "min"), scale * statics.least(pair), unit);
            let most = scale * (statics.least(pair) + statics.stroke(pair));
            let most = self.stated(letter(sort, "max"), most, unit);
            let stroke = letter(if turns { "ψ" } else { "H" }, "");
            let stroke = Name::new(&stroke.letter, stroke.sub.trim_start_matches(','));
            self.equate(stroke, scale * statics.stroke(pair), unit, most - least);
            // the way from the least to the greatest, and what is left of the turn
            let right = if angle(2) >= angle(1) { two - one } else { one - two };
            let way = self.named(letter("Δφ", "1"), Unit::Angle, right);
            let right = Expr::Degrees(360) - way.clone();
            let other = self.named(letter("Δφ", "2"), Unit::Angle, right);
            self.say(Message::TimesOf, &[]);
            let (long, short) = if way.value() >= other.value() { (way, other) } else { (other, way) };
            let ratio = Name::new("K", &named.name);
            let k = self.equate(ratio, statics.time_ratio(pair), Unit::One, long / short);
            let right = Expr::Degrees(180) * (k.clone() - Expr::Int(1)) / (k + Expr::Int(1));
            self.named(Name::new("θ", &named.name), Unit::Angle, right);
        }
    }
}
