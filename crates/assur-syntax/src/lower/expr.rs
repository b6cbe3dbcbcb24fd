//! Expressions.

use super::simulation::Lower;
use super::walk::{P, Parts, name, nfc, span};
use crate::document::{Arg, BinaryOp, CompareOp, Expr, ExprKind, Number, Path, Sensed, Turn, UnaryOp};
use crate::prepare::too_deep;
use crate::recover::{broken_unit, needless_word, tolerance};
use crate::trivia::corrected;
use crate::words::Rule;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::{Span, Spanned};
use assur_text::units;
use std::borrow::Cow;

/// How many signs, powers or parts may follow each other: each is a level of the tree.
const CHAIN: usize = 16;

/// The signs of a tolerance, as the grammar has them.
pub(super) const PLUS_MINUS: [&str; 6] = ["±", "+-", "+−", "+–", "+/-", "+/−"];

/// An operator and what stands after it.
type Link = (Spanned<BinaryOp>, Expr);

impl Lower<'_> {
    /// An `expr` pair, or a `paren` standing for one.
    pub(super) fn expr(&mut self, pair: P<'_>) -> Option<Expr> {
        match pair.as_rule() {
            Rule::expr => self.disjunction(&mut Parts::of(pair)),
            Rule::paren => self.paren(pair),
            _ => None,
        }
    }

    fn disjunction(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let first = self.conjunction(parts)?;
        let mut rest = Vec::new();
        while let Some(op) = parts.take_as(Rule::joining, |op| (op == "or").then_some(BinaryOp::Or)) {
            rest.push((op, self.conjunction(parts)?));
        }
        Some(chain(first, rest))
    }

    fn conjunction(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let first = self.condition(parts)?;
        let mut rest = Vec::new();
        while let Some(op) = parts.take_as(Rule::joining, |op| (op == "and").then_some(BinaryOp::And)) {
            rest.push((op, self.condition(parts)?));
        }
        Some(chain(first, rest))
    }

    fn condition(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let mut signs = Vec::new();
        while let Some(word) = parts.take(Rule::w_not) {
            signs.push(Spanned::new(UnaryOp::Not, span(&word)));
        }
        let inner = self.comparison(parts)?;
        self.signed_by(signs, inner)
    }

    fn comparison(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let first = self.sum(parts)?;
        let mut rest = Vec::new();
        while let Some(op) = parts.take_as(Rule::loose, comparing) {
            rest.push((op, self.sum(parts)?));
        }
        let Some((_, last)) = rest.last() else { return Some(first) };
        let at = first.span.to(last.span);
        Some(Expr { kind: ExprKind::Compare(Box::new(first), rest), span: at })
    }

    fn sum(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let first = self.polar(parts)?;
        let mut rest = Vec::new();
        while let Some(op) = parts.take_as(Rule::loose, adding) {
            rest.push((op, self.polar(parts)?));
        }
        Some(chain(first, rest))
    }

    fn polar(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let length = self.nominal(parts)?;
        if !parts.word(Rule::p_polar) {
            return Some(length);
        }
        let angle = self.nominal(parts)?;
        let at = length.span.to(angle.span);
        Some(Expr { kind: ExprKind::Polar(Box::new(length), Box::new(angle)), span: at })
    }

    /// A product; of `100 mm +- 0.05 mm` the first alone, with the unit of both where it is written once.
    fn nominal(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let mut value = self.product(parts)?;
        while let Some(sign) = parts.take_as(Rule::loose, |op| is_plus_minus(op).then_some(())) {
            let size = self.product(parts)?;
            let (start, at) = (value.span, value.span.to(size.span));
            let mut alone = self.text.get(start.start..start.end)?.to_owned();
            if let (ExprKind::Number(value), ExprKind::Number(Number { unit: Some(unit), .. })) =
                (&mut value.kind, size.kind)
                && value.unit.is_none()
                && unit.node != "%"
            {
                alone = format!("{alone} {}", unit.node);
                value.unit = Some(unit);
            }
            self.problems.push(tolerance(self.text, sign.span, at, &alone));
        }
        Some(value)
    }

    /// A product; factors that a unit gave back are factors of it.
    fn product(&mut self, parts: &mut Parts<'_>) -> Option<Expr> {
        let (first, mut rest) = self.signed(parts)?;
        while let Some(op) = parts.take_as(Rule::tight, multiplying) {
            let (factor, given_back) = self.signed(parts)?;
            rest.push((op, factor));
            rest.extend(given_back);
        }
        Some(chain(first, rest))
    }

    fn signed(&mut self, parts: &mut Parts<'_>) -> Option<(Expr, Vec<Link>)> {
        let signs = self.signs(parts);
        let (power, rest) = self.power(parts)?;
        Some((self.signed_by(signs, power)?, rest))
    }

    /// `a ^ b ^ c` is `a ^ (b ^ c)`.
    fn power(&mut self, parts: &mut Parts<'_>) -> Option<(Expr, Vec<Link>)> {
        let (base, mut rest) = self.post(parts.any()?)?;
        if !parts.is(Rule::tight, "^") {
            return Some((base, rest));
        }
        let start = base.span;
        let mut levels = vec![(Vec::new(), base)];
        while parts.take_as(Rule::tight, |op| (op == "^").then_some(())).is_some() {
            let signs = self.signs(parts);
            let (value, given_back) = self.post(parts.any()?)?;
            levels.push((signs, value));
            rest.extend(given_back);
        }
        let (signs, last) = levels.pop()?;
        if levels.len() >= CHAIN {
            return self.too_deep(start.to(last.span));
        }
        let mut value = self.signed_by(signs, last)?;
        while let Some((signs, base)) = levels.pop() {
            let whole = base.span.to(value.span);
            let raised = Expr { kind: ExprKind::Power(Box::new(base), Box::new(value)), span: whole };
            value = self.signed_by(signs, raised)?;
        }
        Some((value, rest))
    }

    fn post(&mut self, pair: P<'_>) -> Option<(Expr, Vec<Link>)> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        let (mut value, rest) = self.atom(parts.any()?)?;
        let mut levels = 0;
        while let Some(part) = parts.name() {
            levels += 1;
            if levels > CHAIN {
                return self.too_deep(at);
            }
            let whole = value.span.to(part.span);
            value = Expr { kind: ExprKind::Member(Box::new(value), part), span: whole };
        }
        Some((value, rest))
    }

    fn atom(&mut self, pair: P<'_>) -> Option<(Expr, Vec<Link>)> {
        let value = match pair.as_rule() {
            Rule::quantity => return self.quantity(pair),
            Rule::paren => self.paren(pair)?,
            Rule::name => self.name_or_call(pair)?,
            _ => return None,
        };
        Some((value, Vec::new()))
    }

    fn name_or_call(&mut self, pair: P<'_>) -> Option<Expr> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        let name = parts.name()?;
        let Some(arguments) = parts.take(Rule::arguments) else {
            return Some(Expr { kind: ExprKind::Name(name.node), span: at });
        };
        let mut parts = Parts::of(arguments);
        let mut args = Vec::new();
        while let Some(arg) = parts.any() {
            let mut arg = Parts::of(arg);
            args.push(Arg { name: arg.name(), value: self.expr(arg.any()?)? });
        }
        Some(Expr { kind: ExprKind::Call { function: name, args }, span: at })
    }

    fn paren(&mut self, pair: P<'_>) -> Option<Expr> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        let first = self.expr(parts.any()?)?;
        Some(match parts.any() {
            Some(second) => {
                let second = self.expr(second)?;
                Expr { kind: ExprKind::Vector(Box::new(first), Box::new(second)), span: at }
            }
            None => Expr { span: at, ..first },
        })
    }

    /// A number with its unit, and the factors after it that looked like a part of the unit.
    fn quantity(&mut self, pair: P<'_>) -> Option<(Expr, Vec<Link>)> {
        let mut parts = Parts::of(pair);
        let number = parts.any()?;
        let mut at = span(&number);
        let mut value = self.number(&number);
        let mut rest = Vec::new();
        if let Some(unit) = parts.any() {
            let whole = span(&unit);
            let start = whole.start;
            let word = unit.as_str();
            if word.bytes().all(|b| b.is_ascii_alphabetic()) {
                value.unit = Some(Spanned::new(word.to_owned(), whole));
                at = at.to(whole);
                return Some((Expr { kind: ExprKind::Number(value), span: at }, rest));
            }
            let word = &*self.once(word, start);
            let factors = units::factors(word);
            // The first factor is a unit, known or not; the first later one that is none ends it.
            let own = factors.iter().skip(1).position(|f| !units::is_unit(f.symbol));
            let own = own.map_or(factors.len(), |i| i + 1);
            // `об/мин` is a unit of another language as a whole
            let foreign = factors.first().is_some_and(|f| !units::is_unit(f.symbol))
                && !units::suggestions(word).is_empty();
            let own = if foreign { factors.len() } else { own };
            let end = factors.get(own.checked_sub(1)?).map_or(word.len(), |f| f.end);
            let unit_at = if end == unit.as_str().len() { whole } else { Span::new(start, start + end) };
            value.unit = Some(Spanned::new(nfc(word.get(..end)?), unit_at));
            at = at.to(unit_at);
            for factor in factors.into_iter().skip(own) {
                rest.push(given_back(word, &factor, start)?);
            }
        }
        Some((Expr { kind: ExprKind::Number(value), span: at }, rest))
    }

    /// A blank makes a product of different units alone, and only where no unit is broken by it: `m m` may be `mm` or `m`. That is
    /// reported, and so is the second of `190 mm mm`.
    fn once<'w>(&mut self, word: &'w str, start: usize) -> Cow<'w, str> {
        let factors = units::factors(word);
        let both =
            |a: &units::Factor<'_>, b: &units::Factor<'_>| units::is_unit(&[a.symbol, b.symbol].concat());
        let found = factors.windows(2).find_map(|pair| {
            let [a, b] = pair else { return None };
            let is_blank = word.get(a.end..b.start) == Some(" ");
            (is_blank && (a.symbol == b.symbol || both(a, b))).then_some((a, b))
        });
        let Some((first, second)) = found else { return word.into() };
        let behind = Span::new(start + first.end, start + second.start);
        let at = Span::new(start + second.start, start + second.start + second.symbol.len());
        let alone = corrected(self.text, Span::new(behind.start, at.end), "");
        if !both(first, second) {
            self.problems.push(needless_word(second.symbol, at, alone));
            return word[..first.end].into();
        }
        let other = match first.symbol {
            symbol if symbol == second.symbol => Some(alone),
            symbol => units::is_unit(symbol).then(|| corrected(self.text, behind, "*")),
        };
        let helps = std::iter::once(corrected(self.text, behind, "")).chain(other).collect();
        self.problems.push(broken_unit(Span::new(start + first.start, at.end), helps));
        [&word[..first.end], &word[second.start..]].concat().into()
    }

    pub(super) fn number(&mut self, pair: &P<'_>) -> Number {
        let text = pair.as_str().replace('−', "-");
        let value = text.parse::<f64>().unwrap_or(f64::NAN);
        if !value.is_finite() {
            let at = span(pair);
            self.problems.push(
                Diagnosis::error(
                    "mech::syntax::number_too_large",
                    format!("the number {} is too large", shortened(&text)),
                )
                .label(at, "too large")
                .help("check the exponent: the largest number is 1.7e308"),
            );
            return Number { value: f64::MAX, text, unit: None };
        }
        Number { value, text, unit: None }
    }

    fn signs(&mut self, parts: &mut Parts<'_>) -> Vec<Spanned<UnaryOp>> {
        let mut found = Vec::new();
        while let Some(sign) = parts.take(Rule::sign) {
            let at = span(&sign);
            if is_plus_minus(sign.as_str()) {
                self.problems.push(tolerance(self.text, at, at, ""));
            }
            let op = if sign.as_str().starts_with(['+', '±']) { UnaryOp::Plus } else { UnaryOp::Minus };
            found.push(Spanned::new(op, at));
        }
        found
    }

    fn signed_by(&mut self, signs: Vec<Spanned<UnaryOp>>, value: Expr) -> Option<Expr> {
        if signs.len() > CHAIN {
            return self.too_deep(value.span);
        }
        Some(signs.into_iter().rev().fold(value, |value, sign| {
            let at = sign.span.to(value.span);
            Expr { kind: ExprKind::Unary(sign, Box::new(value)), span: at }
        }))
    }

    fn too_deep<T>(&mut self, at: Span) -> Option<T> {
        self.problems.push(too_deep(CHAIN, at));
        None
    }

    pub(super) fn path(&mut self, pair: P<'_>) -> Option<Path> {
        let mut parts = Parts::of(pair);
        Some(Path { head: parts.name()?, tail: parts.name() })
    }

    /// A value with `cw` or `ccw` after it.
    pub(super) fn sensed(&mut self, pair: P<'_>) -> Option<Sensed> {
        let mut parts = Parts::of(pair);
        Some(Sensed { value: self.expr(parts.any()?)?, sense: parts.any().map(|p| turn(&p)) })
    }

    /// Values separated by commas.
    pub(super) fn list(&mut self, pair: P<'_>) -> Option<Vec<Expr>> {
        let values = pair.into_inner().filter(|p| p.as_rule() == Rule::expr);
        let values = values.map(|p| self.expr(p)).collect::<Option<Vec<_>>>()?;
        Some(self.decimal_commas(values))
    }
}

fn chain(first: Expr, rest: Vec<Link>) -> Expr {
    let Some((_, last)) = rest.last() else { return first };
    let at = first.span.to(last.span);
    Expr { kind: ExprKind::Chain(Box::new(first), rest), span: at }
}

/// `*r` or `/r^2` of `6 mm*r^2`, where r is no unit.
fn given_back(word: &str, factor: &units::Factor<'_>, start: usize) -> Option<Link> {
    let op = if factor.divided { BinaryOp::Divide } else { BinaryOp::Multiply };
    let before = word.get(..factor.start)?.chars().next_back()?;
    let op_at = Span::new(start + factor.start - before.len_utf8(), start + factor.start);
    let base_at = Span::new(start + factor.start, start + factor.start + factor.symbol.len());
    let base = Expr { kind: ExprKind::Name(nfc(factor.symbol)), span: base_at };
    if base_at.end == start + factor.end {
        return Some((Spanned::new(op, op_at), base));
    }
    let power = i32::from(factor.power?) * if factor.divided { -1 } else { 1 };
    let at = Span::new(base_at.end, start + factor.end);
    let number = Number { value: f64::from(power.abs()), text: power.abs().to_string(), unit: None };
    let number = Expr { kind: ExprKind::Number(number), span: at };
    let exponent = if power < 0 {
        Expr { kind: ExprKind::Unary(Spanned::new(UnaryOp::Minus, at), Box::new(number)), span: at }
    } else {
        number
    };
    let raised = ExprKind::Power(Box::new(base), Box::new(exponent));
    Some((Spanned::new(op, op_at), Expr { kind: raised, span: base_at.to(at) }))
}

/// The sign of a tolerance.
fn is_plus_minus(op: &str) -> bool {
    PLUS_MINUS.contains(&op)
}

/// `+` and what looks like `-`
fn adding(op: &str) -> Option<BinaryOp> {
    match op {
        "+" => Some(BinaryOp::Add),
        op if comparing(op).is_some() || is_plus_minus(op) => None,
        _ => Some(BinaryOp::Subtract),
    }
}

fn multiplying(op: &str) -> Option<BinaryOp> {
    match op {
        "^" => None,
        "/" => Some(BinaryOp::Divide),
        _ => Some(BinaryOp::Multiply),
    }
}

fn comparing(op: &str) -> Option<CompareOp> {
    match op {
        "<" => Some(CompareOp::Less),
        "<=" => Some(CompareOp::LessOrEqual),
        ">" => Some(CompareOp::Greater),
        ">=" => Some(CompareOp::GreaterOrEqual),
        _ => None,
    }
}

pub(super) fn compare(pair: &P<'_>) -> Option<Spanned<CompareOp>> {
    Some(Spanned::new(comparing(pair.as_str())?, span(pair)))
}

/// `cw` or `ccw`
pub(super) fn turn(pair: &P<'_>) -> Spanned<Turn> {
    let turn = if pair.as_str().starts_with("ccw") { Turn::Ccw } else { Turn::Cw };
    Spanned::new(turn, span(pair))
}

/// A name that may stand for a pose, which may begin with a digit.
pub(super) fn pose_name(pair: &P<'_>) -> crate::document::Name {
    name(pair)
}

/// The beginning of a long number.
fn shortened(text: &str) -> String {
    if text.chars().count() <= 24 {
        text.to_owned()
    } else {
        text.chars().take(20).collect::<String>() + "…"
    }
}
