//! Values as the file writes them: its figures and units, and letters for its names.

use super::Data;
use super::numbers::{figures, raised, right_angle, spaced};
use crate::asked_formula::{letters_in_formula, words_in_formula};
use crate::document::{Inline, Line, text};
use crate::forces::quantity_name;
use crate::sheet::printed_unit;
use crate::words::{Language, QuestionMessage, say, word};
use assur_formula::{Name, name_node};
use assur_model::model::Value;
use assur_syntax::document::{Arg, BinaryOp, CompareOp, Definition, Expr, ExprKind, Number, UnaryOp};
use assur_text::language::Function;
use assur_text::units::significant;
use std::collections::{BTreeMap, BTreeSet};

/// Digits of a value from outside: all that its author writes.
const DIGITS: usize = 12;
/// Functions that have a letter; others have words.
const LETTERED: [&str; 17] = [
    "omega",
    "alpha",
    "angle",
    "velocity",
    "acceleration",
    "jerk",
    "angular_jerk",
    "position",
    "relative_velocity",
    "relative_acceleration",
    "displacement",
    "axial",
    "reaction",
    "normal",
    "moment",
    "power",
    "radius",
];
/// Functions of numbers, which stand for no letter.
const PLAIN: [&str; 15] = [
    "sin", "cos", "tan", "sqrt", "asin", "acos", "atan", "atan2", "exp", "ln", "log", "min", "max", "abs",
    "mag",
];

pub(super) struct Values<'a> {
    data: Data<'a>,
    language: Language,
    definitions: BTreeMap<&'a str, &'a Definition>,
    /// The definitions that are shown with their values.
    pub seen: BTreeSet<&'a str>,
    /// The letters that are shown with their values.
    pub named: BTreeSet<Name>,
    /// A direction is an angle, not a side of the page.
    pub is_free: bool,
}

impl<'a> Values<'a> {
    pub fn of(data: Data<'a>, language: Language, definitions: BTreeMap<&'a str, &'a Definition>) -> Self {
        let (seen, named) = Default::default();
        Self { data, language, definitions, seen, named, is_free: true }
    }

    /// A value after its letter. A value that is a `given` has its letter, and once its value too; where the letter is the author's,
    /// both are shown.
    pub fn with_letter(&mut self, letter: Option<Name>, is_own: bool, value: &'a Expr) -> Line {
        if let ExprKind::Polar(size, direction) = &value.kind
            && matches!(size.kind, ExprKind::Name(_))
        {
            let size = self.with_letter(letter, is_own, size);
            return [size, self.direction(direction)].concat();
        }
        let equals = || text("\u{a0}=\u{a0}");
        let set = |name: &Name| Inline::Math(name_node(name));
        let ExprKind::Name(name) = &value.kind else {
            let words = self.line(value);
            let Some(letter) = letter else { return words };
            let line = [vec![set(&letter), equals()], words].concat();
            self.named.insert(letter);
            return line;
        };
        let given = quantity_name(name);
        let mut line = match letter {
            Some(letter) if is_own && letter != given => {
                let line = vec![set(&letter), equals(), set(&given)];
                self.named.insert(letter);
                line
            }
            _ => vec![set(&given)],
        };
        if let Some((name, definition)) = self.definitions.get_key_value(name.as_str())
            && !(self.data.in_table)(name)
            && self.seen.insert(name)
        {
            line.push(equals());
            line.extend(self.of_definition(name, &definition.value));
        }
        self.named.insert(given);
        line
    }

    /// The value of a definition: of one from outside its figures.
    pub fn of_definition(&self, name: &str, value: &'a Expr) -> Line {
        let outside =
            self.data.mechanism.values.iter().find(|v| v.name == name && (self.data.replaced)(name));
        match outside.map(|own| (&own.value, &own.display)) {
            Some((Value::Scalar(x), display)) => {
                let figures = significant(display.of_si(*x), DIGITS).replace('-', "−");
                vec![text(spaced(&format!("{figures}{}", printed_unit(&display.unit))))]
            }
            _ => self.line(value),
        }
    }

    /// An expression in letters, figures and units.
    pub fn line(&self, expr: &Expr) -> Line {
        match &expr.kind {
            ExprKind::Number(number) => vec![text(figures(number))],
            ExprKind::Name(name) if name == "pi" => vec![text("π")],
            ExprKind::Name(name) if name == "time" => vec![Inline::Math(name_node(&Name::new("t", "")))],
            ExprKind::Name(name) => vec![Inline::Math(name_node(&quantity_name(name)))],
            ExprKind::Member(of, part) => letters_in_formula(self.data.mechanism, expr, self.language)
                .unwrap_or_else(|| [self.line(of), vec![text(format!(".{}", part.node))]].concat()),
            ExprKind::Call { function, args } => {
                let is_builtin = Function::named(&function.node).is_some();
                let is_plain = PLAIN.contains(&&*function.node);
                let (mechanism, language) = (self.data.mechanism, self.language);
                if let Some(words) = self.of_stroke(&function.node, args) {
                    return words;
                }
                let own = || match LETTERED.contains(&&*function.node) {
                    true => letters_in_formula(mechanism, expr, language),
                    false => words_in_formula(mechanism, expr, language),
                };
                if let Some(words) = own().filter(|_| is_builtin && !is_plain) {
                    return words;
                }
                let name = match &*function.node {
                    "sqrt" => text("√"),
                    word if is_builtin => text(word.replace('_', "\u{a0}")),
                    word => Inline::Math(name_node(&quantity_name(word))),
                };
                let args: Vec<Line> = args.iter().map(|arg| self.line(&arg.value)).collect();
                if matches!(&*function.node, "abs" | "mag") {
                    return [vec![text("|")], args.join(&text("; ")), vec![text("|")]].concat();
                }
                [vec![name, text("(")], args.join(&text("; ")), vec![text(")")]].concat()
            }
            ExprKind::Vector(x, y) => {
                [vec![text("(")], self.line(x), vec![text("; ")], self.line(y), vec![text(")")]].concat()
            }
            ExprKind::Polar(size, direction) => self.polar(size, direction),
            ExprKind::Unary(op, of) => {
                let sign = match op.node {
                    UnaryOp::Minus => text("−"),
                    UnaryOp::Plus => text("+"),
                    UnaryOp::Not => text(format!("{} ", word(self.language, "given words", "not"))),
                };
                [vec![sign], self.within(of, 7)].concat()
            }
            ExprKind::Power(of, power) => {
                let raised = match &power.kind {
                    ExprKind::Number(Number { text, unit: None, .. }) => raised(text),
                    _ => None,
                };
                let power = match raised {
                    Some(raised) => vec![text(raised)],
                    None => [vec![text("^")], self.within(power, 9)].concat(),
                };
                [self.within(of, 9), power].concat()
            }
            ExprKind::Chain(first, rest) => self.chain(first, rest),
            ExprKind::Compare(first, rest) => {
                let mut line = self.within(first, 5);
                for (op, next) in rest {
                    line.push(text(match op.node {
                        CompareOp::Less => " < ",
                        CompareOp::LessOrEqual => " ≤ ",
                        CompareOp::Greater => " > ",
                        CompareOp::GreaterOrEqual => " ≥ ",
                    }));
                    line.extend(self.within(next, 5));
                }
                line
            }
        }
    }

    /// What is known of a pair's stroke, in words.
    fn of_stroke(&self, function: &str, args: &[Arg]) -> Option<Line> {
        let (words, rest) = match (function, args) {
            ("travel", [_]) => (QuestionMessage::Travel, None),
            ("stroke", [_]) => (QuestionMessage::Stroke, None),
            ("dead", [_, which]) => (QuestionMessage::DeadPosition, Some(which)),
            _ => return None,
        };
        let pair = match &args.first()?.value.kind {
            ExprKind::Name(name) => vec![text(name.clone())],
            _ => return None,
        };
        let mut line = say(self.language, words, &[pair]);
        if let Some(which) = rest {
            line.extend([vec![text(" (")], self.line(&which.value), vec![text(")")]].concat());
        }
        Some(line)
    }

    fn chain(&self, first: &Expr, rest: &[(assur_text::source::Spanned<BinaryOp>, Expr)]) -> Line {
        let own = rest.first().map_or(9, |(op, _)| strength(op.node));
        let mut line = self.within(first, own);
        for (op, next) in rest {
            let sign = match op.node {
                BinaryOp::Add => " + ".to_owned(),
                BinaryOp::Subtract => " − ".to_owned(),
                BinaryOp::Multiply => "·".to_owned(),
                BinaryOp::Divide => "/".to_owned(),
                BinaryOp::And => format!(" {} ", word(self.language, "given words", "and")),
                BinaryOp::Or => format!(" {} ", word(self.language, "given words", "or")),
            };
            line.push(text(sign));
            line.extend(self.within(next, own + 1));
        }
        line
    }

    /// A size and its direction: a side of the page where that is one.
    fn polar(&self, size: &Expr, direction: &Expr) -> Line {
        [self.within(size, 6), self.direction(direction)].concat()
    }

    fn direction(&self, direction: &Expr) -> Line {
        if let Some(side) = right_angle(direction).filter(|_| !self.is_free) {
            return vec![text(format!(" {}", word(self.language, "given words", side)))];
        }
        [vec![text("\u{a0}∠\u{a0}")], self.within(direction, 7)].concat()
    }

    /// An expression, in brackets where it binds less than this.
    fn within(&self, expr: &Expr, least: u8) -> Line {
        let own = match &expr.kind {
            ExprKind::Chain(_, rest) => rest.first().map_or(9, |(op, _)| strength(op.node)),
            ExprKind::Compare(..) => 4,
            ExprKind::Polar(..) => 6,
            ExprKind::Unary(..) => 7,
            ExprKind::Power(..) => 8,
            ExprKind::Number(Number { unit: Some(_), .. }) if least == 9 => 8,
            _ => 9,
        };
        let line = self.line(expr);
        if own < least { [vec![text("(")], line, vec![text(")")]].concat() } else { line }
    }
}

const fn strength(op: BinaryOp) -> u8 {
    match op {
        BinaryOp::Or => 1,
        BinaryOp::And => 2,
        BinaryOp::Add | BinaryOp::Subtract => 5,
        BinaryOp::Multiply | BinaryOp::Divide => 6,
    }
}
