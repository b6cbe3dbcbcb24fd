//! Questions that the file writes as a formula: functions in words, all else in letters.

use crate::document::{Inline, Line, text};
use crate::forces::quantity_name;
use crate::sheet::printed_unit;
use crate::words::{FunctionWords, Language, QuestionMessage, RunMessage, say};
use assur_formula::{Expr as Formula, Function, Name, Node, Quantity, Sign, Unit, name_node};
use assur_math::math::SAME;
use assur_model::model::{DriveTarget, Mechanism, PairKind, Pin};
use assur_syntax::document::{
    Arg, BinaryOp, CompareOp, Expr, ExprKind, Number, Passing, PassingSense, Statement, UnaryOp,
};
use assur_text::language::{Function as Builtin, Index, letter_of};
use assur_text::source::Source;
use std::sync::Arc;

/// Signs of a letter; more are a word.
const LETTER: usize = 2;

/// A question of a file in words and letters; none where it is neither.
pub fn asked(mechanism: &Mechanism, written: &str, language: Language) -> Option<Line> {
    let item = parsed(written)?;
    Writer { mechanism, language }.words(&item)
}

/// Whether a question of a file is one function that has words.
pub fn has_words(written: &str) -> bool {
    let function = parsed(written).and_then(|item| match item.kind {
        ExprKind::Call { function, args } => Some((function.node, args.len())),
        ExprKind::Member(of, part) => match of.kind {
            ExprKind::Call { function, args } => {
                Some((format!("{}.{}", function.node, part.node), args.len()))
            }
            _ => None,
        },
        _ => None,
    });
    function.is_some_and(|(name, count)| {
        matches!(name.as_str(), "abs" | "mag" | "dir") || FunctionWords::of(&name, count).is_some()
    })
}

/// The letters of one quantity, or of its size: what a column of answers is headed with.
pub fn letters(mechanism: &Mechanism, written: &str, language: Language) -> Option<Node> {
    let (item, writer) = (parsed(written)?, Writer { mechanism, language });
    let formula = match &item.kind {
        ExprKind::Name(name) if !writer.is_value(name) => return None,
        _ => writer.formula(&item)?,
    };
    let is_name = |formula: &Formula| match formula {
        Formula::Leaf(own) => own.name.letter.chars().count() <= LETTER,
        _ => false,
    };
    let short = match &formula {
        Formula::Abs(of) => is_name(of),
        formula => is_name(formula),
    };
    short.then(|| assur_formula::letters(&formula))
}

/// What the file writes, in letters; none where it has words.
pub fn written_in_letters(mechanism: &Mechanism, written: &str, language: Language) -> Option<Line> {
    let item = parsed(written)?;
    Writer { mechanism, language }.in_letters(&item)
}

fn parsed(written: &str) -> Option<Expr> {
    let (document, _) = assur_syntax::parse(&Source::new("", format!("mech 1\nfind {written}\n")));
    let items = document.statements.into_iter().find_map(|statement| match statement.node {
        Statement::Find(find) => Some(find.items),
        _ => None,
    })?;
    let [item] = <[_; 1]>::try_from(items).ok()?;
    Some(item.value)
}

/// What an event is: a number that passes a value, or a condition that becomes true; none where it has words of its own.
pub fn passing_in_letters(mechanism: &Mechanism, statement: &str, language: Language) -> Option<Line> {
    let (document, _) = assur_syntax::parse(&Source::new("", format!("mech 1\n{statement}\n")));
    let passing = document.statements.into_iter().find_map(|statement| match statement.node {
        Statement::Event(event) => Some(event.passing),
        Statement::Until(until) => Some(until.passing),
        _ => None,
    })?;
    let writer = Writer { mechanism, language };
    if passing.value.is_none() {
        return Some(say(language, RunMessage::Becomes, &[writer.condition(&passing.what)?]));
    }
    let mut found = true;
    let line = passing_in_words(language, &passing, &mut |expr| {
        let line = writer.in_letters(expr);
        found &= line.is_some();
        line.unwrap_or_default()
    });
    found.then_some(line)
}

/// The words of an event, with its expressions as they are set; a condition is that alone.
pub(crate) fn passing_in_words(
    language: Language,
    passing: &Passing,
    set: &mut dyn FnMut(&Expr) -> Line,
) -> Line {
    let Some(value) = &passing.value else { return set(&passing.what) };
    let line = [set(&passing.what), vec![text(" = ")], set(value)].concat();
    match passing.way.as_ref().map(|way| way.node) {
        Some(PassingSense::Rising) => say(language, RunMessage::Rises, &[line]),
        Some(PassingSense::Falling) => say(language, RunMessage::Falls, &[line]),
        None => line,
    }
}

/// The letters of what is asked of a part of the mechanism, as in a formula; none where it has only words.
pub(crate) fn letters_in_formula(mechanism: &Mechanism, expr: &Expr, language: Language) -> Option<Line> {
    Writer { mechanism, language }.letters(expr)
}

/// The same in words; none where it has neither.
pub(crate) fn words_in_formula(mechanism: &Mechanism, expr: &Expr, language: Language) -> Option<Line> {
    Writer { mechanism, language }.words(expr)
}

struct Writer<'a> {
    mechanism: &'a Mechanism,
    language: Language,
}

impl Writer<'_> {
    /// What an expression is.
    fn words(&self, expr: &Expr) -> Option<Line> {
        match &expr.kind {
            ExprKind::Call { function, args } => self.function(&function.node, args),
            ExprKind::Member(of, part) => match &of.kind {
                ExprKind::Call { function, args } => {
                    let words = FunctionWords::of(&format!("{}.{}", function.node, part.node), args.len());
                    let words = words.and_then(|words| self.say(words, args));
                    words.or_else(|| self.letters(expr))
                }
                _ => self.letters(expr),
            },
            ExprKind::Name(name) if self.is_thing(name) => {
                Some(vec![text(self.number(name).unwrap_or(name))])
            }
            _ => self.letters(expr),
        }
    }

    /// A function in words, else its letter with its arguments.
    fn function(&self, name: &str, args: &[Arg]) -> Option<Line> {
        let first = || args.first().map_or(Some(Vec::new()), |arg| self.words(&arg.value));
        match name {
            "abs" | "mag" => return Some(say(self.language, QuestionMessage::Magnitude, &[first()?])),
            "dir" => return Some(say(self.language, QuestionMessage::Direction, &[first()?])),
            _ => {}
        }
        let words = along_link(name, args).or_else(|| FunctionWords::of(name, args.len()));
        if let Some(words) = words {
            return self.say(words, args);
        }
        let formula = self.call(name, args)?;
        match (&formula, args) {
            // a curve of the file at a place
            (Formula::Leaf(_), [at]) if Builtin::named(name).is_none() => {
                let mut line = vec![Inline::Math(name_node(&quantity_name(name))), text("(")];
                line.extend(self.words(&at.value)?);
                line.push(text(")"));
                Some(line)
            }
            _ => Some(vec![Inline::Math(dotted(assur_formula::letters(&formula)))]),
        }
    }

    /// Words with arguments in their places, and those with names after them.
    fn say(&self, words: FunctionWords, args: &[Arg]) -> Option<Line> {
        let (named, plain): (Vec<&Arg>, Vec<&Arg>) = args.iter().partition(|arg| arg.name.is_some());
        let parts: Option<Vec<Line>> = plain.iter().map(|arg| self.words(&arg.value)).collect();
        let mut line = say(self.language, words, &parts?);
        for (i, arg) in named.iter().enumerate() {
            line.push(text(if i == 0 { ": " } else { ", " }));
            line.extend(self.named(arg)?);
        }
        Some(line)
    }

    /// An argument with its name, in words.
    fn named(&self, arg: &Arg) -> Option<Line> {
        let name = &arg.name.as_ref()?.node;
        if let ExprKind::Name(value) = &arg.value.kind
            && let Some(words) = FunctionWords::of(&format!("{name}={value}"), 0)
        {
            return Some(say(self.language, words, &[]));
        }
        Some(say(self.language, FunctionWords::of(&format!("={name}"), 1)?, &[self.letters(&arg.value)?]))
    }

    /// Numbers that are compared.
    fn condition(&self, expr: &Expr) -> Option<Line> {
        let ExprKind::Compare(first, rest) = &expr.kind else { return self.words(expr) };
        let mut line = self.in_letters(first)?;
        for (op, next) in rest {
            let sign = match op.node {
                CompareOp::Less => " < ",
                CompareOp::LessOrEqual => " ≤ ",
                CompareOp::Greater => " > ",
                CompareOp::GreaterOrEqual => " ≥ ",
            };
            line.push(text(sign));
            line.extend(self.in_letters(next)?);
        }
        Some(line)
    }

    /// Letters alone; a curve of the file with its argument after it.
    fn in_letters(&self, expr: &Expr) -> Option<Line> {
        let ExprKind::Call { function, args } = &expr.kind else { return self.letters(expr) };
        match args.as_slice() {
            [at] if Builtin::named(&function.node).is_none() => {
                let curve = vec![Inline::Math(name_node(&quantity_name(&function.node))), text("(")];
                Some([curve, self.in_letters(&at.value)?, vec![text(")")]].concat())
            }
            _ => self.letters(expr),
        }
    }

    fn letters(&self, expr: &Expr) -> Option<Line> {
        Some(vec![Inline::Math(dotted(assur_formula::letters(&self.formula(expr)?)))])
    }

    /// Whether a name is one of a link, a pair, a point or another part, which is set as it is.
    fn is_thing(&self, name: &str) -> bool {
        let m = self.mechanism;
        let links =
            m.links.iter().any(|link| link.name == name || link.points.iter().any(|p| p.name == name));
        links || m.pairs.iter().any(|pair| pair.name == name) || !self.is_value(name)
    }

    fn is_value(&self, name: &str) -> bool {
        let m = self.mechanism;
        m.values.iter().any(|value| value.name == name)
            || m.finds.iter().any(|find| find.name == name)
            || m.balances.iter().any(|balance| balance.name == name)
            || m.loads.iter().any(|load| load.name.as_deref() == Some(name))
            || m.quantities.iter().any(|quantity| quantity.name == name)
    }

    fn formula(&self, expr: &Expr) -> Option<Formula> {
        Some(match &expr.kind {
            ExprKind::Number(number) => of_number(number),
            ExprKind::Name(name) if name == "pi" => Formula::Pi,
            ExprKind::Name(name) => leaf(quantity_name(name)),
            ExprKind::Member(of, part) => match (self.formula(of)?, &of.kind) {
                (Formula::Leaf(own), ExprKind::Call { .. }) if part.node.len() > 1 => {
                    leaf(Name::new(&part.node.replacen("dJ", "ΔJ", 1), &own.name.sub))
                }
                (Formula::Leaf(own), _) => leaf(own.name.and(&part.node)),
                _ => return None,
            },
            ExprKind::Call { function, args } => self.call(&function.node, args)?,
            ExprKind::Unary(op, of) => match op.node {
                UnaryOp::Minus => Formula::Neg(Box::new(self.formula(of)?)),
                UnaryOp::Plus => self.formula(of)?,
                UnaryOp::Not => return None,
            },
            ExprKind::Chain(first, rest) => self.chain(first, rest)?,
            ExprKind::Power(of, power) => {
                let ExprKind::Number(Number { text, unit: None, .. }) = &power.kind else { return None };
                Formula::Power(Box::new(self.formula(of)?), text.parse().ok().filter(|power| *power > 1)?)
            }
            ExprKind::Vector(..) | ExprKind::Polar(..) | ExprKind::Compare(..) => return None,
        })
    }

    /// A sum or a product.
    fn chain(&self, first: &Expr, rest: &[(assur_text::source::Spanned<BinaryOp>, Expr)]) -> Option<Formula> {
        let mut so_far = self.formula(first)?;
        for (op, next) in rest {
            let next = self.formula(next)?;
            so_far = match (op.node, so_far) {
                (BinaryOp::Add | BinaryOp::Subtract, so_far) => {
                    let sign = if op.node == BinaryOp::Add { Sign::Plus } else { Sign::Minus };
                    let mut terms = match so_far {
                        Formula::Sum(terms) => terms,
                        one => vec![(Sign::Plus, one)],
                    };
                    terms.push((sign, next));
                    Formula::Sum(terms)
                }
                (BinaryOp::Multiply, Formula::Product(mut factors)) => {
                    factors.push(next);
                    Formula::Product(factors)
                }
                (BinaryOp::Multiply, one) => Formula::Product(vec![one, next]),
                (BinaryOp::Divide, one) => Formula::Ratio(Box::new(one), Box::new(next)),
                (BinaryOp::And | BinaryOp::Or, _) => return None,
            };
        }
        Some(so_far)
    }

    /// A function of numbers, or the letter of what is asked of a part of the mechanism.
    fn call(&self, function: &str, args: &[Arg]) -> Option<Formula> {
        let of = |function: Function| {
            let [arg] = args else { return None };
            Some(Formula::Of(function, Box::new(self.formula(&arg.value)?)))
        };
        match function {
            "sin" => return of(Function::Sin),
            "cos" => return of(Function::Cos),
            "tan" => return of(Function::Tan),
            "sqrt" => return Some(Formula::Root(Box::new(self.formula(&args.first()?.value)?))),
            "abs" | "mag" => return Some(Formula::Abs(Box::new(self.formula(&args.first()?.value)?))),
            "max" | "min" | "mean" => {
                let [Arg { name: None, value }] = args else { return None };
                let of = match self.formula(value)? {
                    Formula::Abs(inner) => *inner,
                    other => other,
                };
                let Formula::Leaf(own) = of else { return None };
                let which = if function == "mean" { "m" } else { function };
                let index =
                    if own.name.sub.is_empty() { String::new() } else { format!("{},", own.name.sub) };
                return Some(leaf(Name { sub: index + which, ..own.name.clone() }));
            }
            _ => {}
        }
        let parts = || args.iter().map(|arg| self.index(&arg.value)).collect::<Option<Vec<_>>>();
        let first = || args.first().map_or_else(|| Some(String::new()), |arg| self.index(&arg.value));
        Some(leaf(match (function, letter_of(function)) {
            ("effort", _) => {
                let drive = first()?;
                Name::new(if self.turns(&drive) { "M" } else { "F" }, &drive)
            }
            ("displacement" | "relative_velocity" | "relative_acceleration", Some((letter, _)))
                if let Some(ends) = self.cylinder(args) =>
            {
                Name::new(if letter == "s" { "l" } else { letter }, &ends)
            }
            ("drive", _) => {
                let turns = self.mechanism.drives.first().is_some_and(|drive| self.turns(&drive.name));
                Name::new(if turns { "φ" } else { "s" }, &parts()?.join(","))
            }
            (_, Some((letter, Index::All))) => Name::new(letter, &parts()?.join(",")),
            (_, Some((letter, Index::Behind(before)))) => Name::new(letter, &format!("{before}{}", first()?)),
            (_, Some((letter, Index::Own(index)))) => Name::new(letter, index),
            (other, None) => Name::new(&other.replace('_', " "), &parts()?.join(",")),
        }))
    }

    /// The points between which a cylinder is: `GK`.
    fn cylinder(&self, args: &[Arg]) -> Option<String> {
        let [Arg { name: None, value }] = args else { return None };
        let ExprKind::Name(name) = &value.kind else { return None };
        let pair = self.mechanism.pairs.iter().find(|pair| pair.name == *name)?;
        let PairKind::Cylinder { from, to, .. } = &pair.kind else { return None };
        let point = |pin: &Pin| {
            let points = &self.mechanism.link(pin.link).points;
            points.iter().find(|point| (point.at - pin.at).norm() <= SAME).map(|point| point.name.as_str())
        };
        Some([point(from)?, point(to)?].concat())
    }

    /// Whether a drive turns what it drives.
    fn turns(&self, name: &str) -> bool {
        let drive = self.mechanism.drives.iter().find(|drive| drive.name == name);
        drive.is_some_and(|drive| match drive.target {
            DriveTarget::Link(_) => true,
            DriveTarget::Pair(pair) => matches!(self.mechanism.pair(pair).kind, PairKind::Revolute(_)),
            DriveTarget::Point(..) | DriveTarget::Place(..) => false,
        })
    }

    /// The number of a link.
    fn number(&self, name: &str) -> Option<&str> {
        let number = self.mechanism.links.iter().find(|link| link.name == name)?.number.as_deref();
        number.or((name == "ground").then_some("0"))
    }

    /// An argument as an index: of a link its number.
    fn index(&self, expr: &Expr) -> Option<String> {
        match &expr.kind {
            ExprKind::Name(name) => Some(self.number(name).unwrap_or(name).to_owned()),
            ExprKind::Member(_, point) => Some(point.node.clone()),
            _ => match self.formula(expr)? {
                Formula::Leaf(own) => Some(format!("{}{}", own.name.letter, own.name.sub)),
                Formula::Int(n) => Some(n.to_string()),
                _ => None,
            },
        }
    }
}

fn of_number(number: &Number) -> Formula {
    match (&number.unit, number.text.parse()) {
        (None, Ok(whole)) => Formula::Int(whole),
        (None, Err(_)) => Formula::Number(number.value),
        (Some(unit), _) => {
            let figures = format!("{}{}", number.text, printed_unit(&unit.node));
            leaf(Name::new(&figures.replace('-', "−"), ""))
        }
    }
}

/// With a point in every product: next to words and units nothing else shows that it is one.
fn dotted(node: Node) -> Node {
    let boxed = |node: Box<Node>| Box::new(dotted(*node));
    match node {
        Node::Times => Node::Dot,
        Node::Row(parts) => Node::Row(parts.into_iter().map(dotted).collect()),
        Node::Fraction(above, below) => Node::Fraction(boxed(above), boxed(below)),
        Node::Power(of, power) => Node::Power(boxed(of), power),
        Node::Root(of) => Node::Root(boxed(of)),
        Node::Bars(of) => Node::Bars(boxed(of)),
        Node::Brackets(of) => Node::Brackets(boxed(of)),
        other => other,
    }
}

fn leaf(name: Name) -> Formula {
    Formula::Leaf(Arc::new(Quantity {
        name,
        value: 1.0,
        unit: Unit::One,
        scale: 1.0,
        given: true,
        rounding: 0.0,
    }))
}

/// The words of `argmax(internal(beam).M)`, which is a place on a link.
fn along_link(name: &str, args: &[Arg]) -> Option<FunctionWords> {
    let [Arg { name: None, value }] = args else { return None };
    let ExprKind::Member(of, _) = &value.kind else { return None };
    let inside = matches!(&of.kind, ExprKind::Call { function, .. } if function.node == "internal");
    if inside { FunctionWords::of(&format!("{name} internal"), 1) } else { None }
}
