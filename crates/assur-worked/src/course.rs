//! The course of a solution: what is known so far, and what has been written.

use crate::angle::Angle;
use crate::document::{Block, Figure, Inline, Line, Reference, Table, Term, text};
use crate::forces::{FreeBodies, Hold};
use crate::words::{Language, Message, Sentence, say};
use assur_formula::{Equation, Expr, Lines, Name, Node, Quantity, Unit, name_node};
use assur_math::math::Vec2;
use assur_model::structure::Structure;
use assur_picture::Scene;
use assur_solve::solve::{BodyState, State};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// An angle below this is rounding, degrees.
const NO_ANGLE: f64 = 1e-10;

/// What is known of a body.
#[derive(Clone, Debug)]
pub struct Body {
    /// A point of it whose motion is known, in its frame, m.
    pub reference: Vec2,
    /// The direction of its frame.
    pub angle: Angle,
    /// Its angular velocity and acceleration.
    pub rates: [Expr; 2],
}

/// The solution of one position, as it is written.
pub struct Derivation<'a> {
    pub scene: Scene<'a>,
    /// The language of its sentences.
    pub language: Language,
    /// What has been written.
    pub blocks: Vec<Block>,
    /// The equations, in order, each with its place among the blocks.
    pub equations: Vec<(usize, Equation)>,
    /// What trees do not agree with the state: nothing of these is printed.
    pub disagreements: Vec<String>,
    /// Values without a formula in the sections on what needs no position.
    pub design_values: Vec<Quantity>,
    pub bodies: Vec<Option<Body>>,
    /// All that has been found, by its letters.
    pub found: BTreeMap<Name, Expr>,
    /// Points: position, velocity, acceleration, by name.
    pub points: [BTreeMap<String, [Expr; 2]>; 3],
    /// Places nearer than this are one, m.
    pub tiny: f64,
    /// Values that no equation gives and none could: the acceleration that a motion has, a speed of which the sense is given.
    pub taken: BTreeSet<Name>,
    /// Lines of stated values, by place.
    pub lines: Vec<(usize, Name)>,
    /// Stated values that are the solution of equations which are written.
    pub solutions: BTreeSet<Name>,
    /// Places of lines that are left out where nothing uses them.
    pub optional: BTreeSet<usize>,
    /// What the file asks for.
    pub asked: BTreeSet<Name>,
    /// The values of the file that have been used.
    pub(crate) given: RefCell<BTreeMap<Name, f64>>,
    /// Places without a name in the file.
    pub unnamed: RefCell<Vec<(usize, Vec2)>>,
    /// What is known to act on the bodies.
    pub free: FreeBodies,
    /// What has been derived, and what has been stated alone.
    pub counts: Counts,
    /// The force polygon of the group whose forces are found: its caption.
    pub polygon: Option<String>,
    /// Friction that is derived: its element, its value, the relative velocity.
    pub rubbing: Vec<(usize, Expr, Expr)>,
    /// What holds free coordinates and is found by the balances of links.
    pub holds: Vec<Hold>,
    /// Places of sentences that end before an equation: where it is nothing they say so.
    pub awaiting: Vec<usize>,
    /// Letters of answers, by the number of the question.
    pub answers: Vec<(usize, Node)>,
    /// Powers that transmissions lose.
    pub lost: Vec<Expr>,
    /// Pairs whose reaction has no place that is known.
    pub unplaced: Vec<bool>,
}

/// What a solution works out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Groups whose motion is derived, and stated alone.
    pub motion: [usize; 2],
    /// Groups whose forces are derived, and stated alone.
    pub forces: [usize; 2],
    /// Groups whose forces depend on how pairs share what friction holds.
    pub held: usize,
    /// Reactions that are derived, and that have no step.
    pub reactions: [usize; 2],
    /// Loads that are listed, and those that are part of a resultant.
    pub loads: [usize; 2],
}

impl<'a> Derivation<'a> {
    /// Nothing is known but the ground.
    pub fn new(scene: Scene<'a>, language: Language) -> Self {
        let count = scene.model.plan.bodies;
        let ground = Body { reference: Vec2::zero(), angle: Angle::ZERO, rates: [Expr::ZERO, Expr::ZERO] };
        let mut bodies = vec![None; count];
        if let Some(first) = bodies.first_mut() {
            *first = Some(ground);
        }
        Self {
            tiny: 1e-9 * assur_solve::solve::extent(&scene.model),
            scene,
            language,
            blocks: Vec::new(),
            equations: Vec::new(),
            disagreements: Vec::new(),
            design_values: Vec::new(),
            bodies,
            found: BTreeMap::new(),
            points: Default::default(),
            taken: BTreeSet::new(),
            lines: Vec::new(),
            solutions: BTreeSet::new(),
            optional: BTreeSet::new(),
            asked: BTreeSet::new(),
            given: RefCell::default(),
            unnamed: RefCell::default(),
            free: FreeBodies::of(count, scene.model.plan.reactions.len()),
            counts: Counts::default(),
            polygon: None,
            rubbing: Vec::new(),
            holds: Vec::new(),
            lost: Vec::new(),
            answers: Vec::new(),
            unplaced: assur_solve::solve::unplaced_reactions(&scene.model),
            awaiting: Vec::new(),
        }
    }

    pub fn structure(&self) -> &'a Structure {
        self.scene.model.structure
    }

    pub fn state(&self) -> &'a State {
        &self.scene.solved.state
    }

    /// How a body moves.
    pub fn moved(&self, body: usize) -> &'a BodyState {
        &self.state().motion.bodies[body]
    }

    pub fn heading(&mut self, level: u8, words: impl Into<String>) {
        self.blocks.push(Block::Heading(level, words.into()));
    }

    pub fn say(&mut self, message: impl Sentence, parts: &[Line]) {
        if message.awaits_an_equation() {
            self.awaiting.push(self.blocks.len());
        }
        let line = say(self.language, message, parts);
        self.blocks.push(Block::Paragraph(line));
    }

    /// A sentence that holds for all groups: it is said with the first.
    pub fn say_once(&mut self, message: impl Sentence) {
        let line = Block::Paragraph(say(self.language, message, &[]));
        if !self.blocks.contains(&line) {
            self.blocks.push(line);
        }
    }

    /// A sentence that names the first of these figures.
    pub fn cite(&mut self, message: Message, figures: &[Figure]) {
        if let Some(first) = figures.first() {
            self.cite_as(message, first.caption.clone());
        }
    }

    /// A sentence that names the figure with a caption; it is left out where there is none.
    pub fn cite_as(&mut self, message: Message, caption: String) {
        let reference = Reference { caption, ..Reference::default() };
        self.say(message, &[vec![Inline::Figure(reference)]]);
    }

    pub fn remark(&mut self, message: impl Sentence, parts: &[Line]) {
        let line = say(self.language, message, parts);
        self.blocks.push(Block::Remark(line));
    }

    /// Puts blocks before one that has been written.
    pub fn insert(&mut self, before: usize, blocks: Vec<Block>) {
        let count = blocks.len();
        self.blocks.splice(before..before, blocks);
        let moved = |place: usize| if place >= before { place + count } else { place };
        self.equations.iter_mut().for_each(|(place, _)| *place = moved(*place));
        self.lines.iter_mut().for_each(|(place, _)| *place = moved(*place));
        self.awaiting.iter_mut().for_each(|place| *place = moved(*place));
        self.optional = self.optional.iter().map(|place| moved(*place)).collect();
    }

    /// Words of a message without parts.
    pub fn words(&self, message: impl Sentence) -> String {
        plain(&say(self.language, message, &[]))
    }

    pub fn table(&mut self, table: Table) {
        if !table.rows.is_empty() {
            self.blocks.push(Block::Table(table));
        }
    }

    pub fn vectors(&mut self, terms: Vec<Term>) {
        self.blocks.push(Block::Vectors(terms));
    }

    /// Figures next to each other.
    pub fn figures(&mut self, figures: Vec<Figure>) {
        if !figures.is_empty() {
            self.blocks.push(Block::Figures(figures));
        }
    }

    /// Writes an equation and keeps what it finds; what is found already is not found again, and what is nothing for all values is
    /// not written. A tree that does not agree with the state is not printed.
    pub fn equate(&mut self, mut name: Name, value: f64, unit: Unit, right: Expr) -> Expr {
        while let Some(found) = self.found.get(&name) {
            if (found.value() - value).abs() <= 1e-9 * found.scale().max(value.abs()) {
                return found.clone();
            }
            // another quantity has these letters
            name.letter.push('′');
        }
        if right.is_zero() {
            if unit == Unit::Length && value.abs() > 10.0 * self.tiny {
                self.disagreements.push(format!("{name:?} is not zero but {value}"));
            }
            return Expr::ZERO;
        }
        let equation = Equation::new(name, value, unit, right);
        self.write(equation)
    }

    /// The same; what is nothing for all values is written as 0.
    pub fn equate_or_nothing(&mut self, name: &Name, value: f64, unit: Unit, right: Expr) -> Expr {
        if !right.is_zero() {
            return self.equate(name.clone(), value, unit, right);
        }
        let zero = Quantity { name: name.clone(), value: 0.0, unit, scale: 0.0, given: true, rounding: 0.0 };
        let lines = stated(&zero);
        self.blocks.push(Block::Equation(lines));
        Expr::ZERO
    }

    fn write(&mut self, equation: Equation) -> Expr {
        let found = equation.found();
        self.found.insert(equation.left.name.clone(), found.clone());
        if let Some(off) = equation.disagrees().or((!equation.right.value().is_finite()).then_some(f64::NAN))
        {
            let letters = assur_formula::text_lines(&equation.lines());
            self.disagreements.push(format!("{letters} (off by {off:e})"));
            let value = Expr::Leaf(Arc::clone(&equation.left));
            let lines = stated(&equation.left);
            self.say(Message::NotAccurateHere, &[]);
            self.blocks.push(Block::Equation(lines));
            return value;
        }
        self.equations.push((self.blocks.len(), equation.clone()));
        let lines = equation.lines();
        self.blocks.push(Block::Equation(lines));
        found
    }

    /// Writes an equation for what is known already: a check.
    pub fn confirm(&mut self, name: Name, value: f64, unit: Unit, right: Expr) {
        let equation = Equation::new(name, value, unit, right);
        if let Some(off) = equation.disagrees() {
            let letters = assur_formula::text_lines(&equation.lines());
            self.disagreements.push(format!("{letters} (off by {off:e})"));
            return;
        }
        self.equations.push((self.blocks.len(), equation.clone()));
        let lines = equation.lines();
        self.blocks.push(Block::Equation(lines));
    }

    /// A value that the solver states, without a derivation.
    pub fn stated(&mut self, name: Name, value: f64, unit: Unit) -> Expr {
        self.stated_of(name, value, unit, 0.0)
    }

    /// The same where the value is large against this, so that less is rounding.
    pub fn stated_of(&mut self, mut name: Name, value: f64, unit: Unit, large: f64) -> Expr {
        let value = if unit == Unit::Angle && value.abs() < NO_ANGLE { 0.0 } else { value };
        while let Some(found) = self.found.get(&name) {
            if (found.value() - value).abs() <= 1e-9 * found.scale().max(value.abs()).max(large) {
                return found.clone();
            }
            // another quantity has these letters
            name.letter.push('′');
        }
        // what is found together with greater values has their rounding
        let (scale, rounding) = (value.abs().max(large), f64::EPSILON * large);
        let q = Quantity { name: name.clone(), value, unit, scale, given: false, rounding };
        self.lines.push((self.blocks.len(), q.name.clone()));
        let lines = stated(&q);
        self.blocks.push(Block::Equation(lines));
        let leaf = Expr::Leaf(Arc::new(q));
        self.found.insert(name, leaf.clone());
        leaf
    }
}

/// Two points as one index.
pub fn joined(from: &str, to: &str) -> String {
    let short = |name: &str| name.chars().filter(|c| c.is_alphabetic()).count() <= 1;
    if short(from) && short(to) { format!("{from}{to}") } else { format!("{from},{to}") }
}

/// A quantity and its value.
fn stated(q: &Quantity) -> Lines {
    let figures = q.figures(5);
    let mut row = vec![Node::Operator("=")];
    if q.unit == Unit::Angle {
        row.push(Node::Degrees(figures));
    } else if q.unit == Unit::One {
        row.push(Node::Number(figures));
    } else {
        row.extend([Node::Number(figures), Node::Unit(q.unit.text().to_owned())]);
    }
    Lines { left: name_node(&q.name), rows: vec![(Node::Row(row), false)] }
}

/// A line without its formulas.
pub fn plain(line: &Line) -> String {
    let words = |part: &Inline| match part {
        Inline::Text(words) | Inline::Strong(words) => words.clone(),
        Inline::Figure(reference) => reference.words.clone(),
        Inline::Math(node) => assur_formula::text(node),
    };
    line.iter().map(words).collect()
}

/// A value as a cell: number and unit.
pub fn cell(expr: &Expr) -> Line {
    match expr {
        Expr::Leaf(q) => {
            let figures = q.figures(5);
            let unit = if q.unit == Unit::Angle { "°".to_owned() } else { format!(" {}", q.unit.text()) };
            vec![text(format!("{}{}", figures.text().trim_start_matches('−'), unit.trim_end()))]
        }
        Expr::Neg(x) => cell(x),
        other => vec![Inline::Math(assur_formula::letters(other))],
    }
}
