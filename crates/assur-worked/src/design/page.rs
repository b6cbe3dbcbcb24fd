//! What is written of things without a position: equations from given and found values.

use crate::course::plain;
use crate::document::{Block, Line, Table, text};
use crate::words::{DesignMessage as Message, Language, say};
use assur_formula::{Equation, Expr, Lines, Name, Node, Quantity, Unit, name_node};
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
            unit => row.extend([Node::Number(figures), Node::Unit(unit.text())]),
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
