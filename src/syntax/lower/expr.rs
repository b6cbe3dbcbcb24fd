//! Expressions.

use super::Lower;
use super::walk::{P, Parts, name, span};
use crate::source::{Span, Spanned};
use crate::syntax::Rule;
use crate::syntax::document::{
    Arg, BinaryOp, CompareOp, Expr, ExprKind, Number, Path, Sensed, Turn, UnaryOp,
};
use crate::syntax::error::SyntaxError;
use crate::units;
use unicode_normalization::UnicodeNormalization;

/// How many signs, powers or parts may follow each other: each is a level of the tree.
const CHAIN: usize = 16;

/// An operator and what stands behind it.
type Link = (Spanned<BinaryOp>, Expr);

impl Lower<'_> {
    /// An `expr` pair, or a `paren` standing for one.
    pub(super) fn expr(&mut self, pair: P<'_>) -> Option<Expr> {
        match pair.as_rule() {
            Rule::expr | Rule::conjunct => self.logic(pair),
            Rule::paren => self.paren(pair),
            _ => None,
        }
    }

    /// Chains of `or` and `and`.
    fn logic(&mut self, pair: P<'_>) -> Option<Expr> {
        let mut parts = Parts::of(pair);
        let first = self.truth_or_conjunct(parts.any()?)?;
        let mut rest = Vec::new();
        while let Some(word) = parts.any() {
            let op = if word.as_rule() == Rule::w_or { BinaryOp::Or } else { BinaryOp::And };
            rest.push((Spanned::new(op, span(&word)), self.truth_or_conjunct(parts.any()?)?));
        }
        Some(chain(first, rest))
    }

    fn truth_or_conjunct(&mut self, pair: P<'_>) -> Option<Expr> {
        if pair.as_rule() == Rule::conjunct { self.logic(pair) } else { self.truth(pair) }
    }

    fn truth(&mut self, pair: P<'_>) -> Option<Expr> {
        let mut parts = Parts::of(pair);
        let mut signs = Vec::new();
        while let Some(word) = parts.take(Rule::w_not) {
            signs.push(Spanned::new(UnaryOp::Not, span(&word)));
        }
        let inner = self.comparison(parts.any()?)?;
        self.signed_by(signs, inner)
    }

    fn comparison(&mut self, pair: P<'_>) -> Option<Expr> {
        let mut parts = Parts::of(pair);
        let first = self.sum(parts.any()?)?;
        let mut rest = Vec::new();
        while let Some(op) = parts.any() {
            rest.push((compare(&op), self.sum(parts.any()?)?));
        }
        let Some((_, last)) = rest.last() else { return Some(first) };
        let at = first.span.to(last.span);
        Some(Expr { kind: ExprKind::Compare(Box::new(first), rest), span: at })
    }

    fn sum(&mut self, pair: P<'_>) -> Option<Expr> {
        let mut parts = Parts::of(pair);
        let first = self.polar(parts.any()?)?;
        let mut rest = Vec::new();
        while let Some(op) = parts.any() {
            let kind = if op.as_str() == "+" { BinaryOp::Add } else { BinaryOp::Subtract };
            rest.push((Spanned::new(kind, span(&op)), self.polar(parts.any()?)?));
        }
        Some(chain(first, rest))
    }

    fn polar(&mut self, pair: P<'_>) -> Option<Expr> {
        let mut parts = Parts::of(pair);
        let length = self.product(parts.any()?)?;
        let Some(angle) = parts.any() else { return Some(length) };
        let angle = self.product(angle)?;
        let at = length.span.to(angle.span);
        Some(Expr { kind: ExprKind::Polar(Box::new(length), Box::new(angle)), span: at })
    }

    /// A product; factors that a unit gave back are factors of it.
    fn product(&mut self, pair: P<'_>) -> Option<Expr> {
        let mut parts = Parts::of(pair);
        let (first, mut rest) = self.signed(parts.any()?)?;
        while let Some(op) = parts.any() {
            let kind = if op.as_str() == "/" { BinaryOp::Divide } else { BinaryOp::Multiply };
            let (factor, given_back) = self.signed(parts.any()?)?;
            rest.push((Spanned::new(kind, span(&op)), factor));
            rest.extend(given_back);
        }
        Some(chain(first, rest))
    }

    fn signed(&mut self, pair: P<'_>) -> Option<(Expr, Vec<Link>)> {
        let mut parts = Parts::of(pair);
        let signs = signs(&mut parts);
        let (power, rest) = self.power(parts.any()?)?;
        Some((self.signed_by(signs, power)?, rest))
    }

    /// `a ^ b ^ c` is `a ^ (b ^ c)`.
    fn power(&mut self, pair: P<'_>) -> Option<(Expr, Vec<Link>)> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        let (base, mut rest) = self.post(parts.any()?)?;
        let mut levels = vec![(Vec::new(), base)];
        while let Some(exponent) = parts.any() {
            let mut inner = Parts::of(exponent);
            let signs = signs(&mut inner);
            let (value, given_back) = self.post(inner.any()?)?;
            levels.push((signs, value));
            rest.extend(given_back);
        }
        if levels.len() > CHAIN {
            return self.too_deep(at);
        }
        let (signs, last) = levels.pop()?;
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
        let at = span(&pair);
        let kind = match pair.as_rule() {
            Rule::quantity => return self.quantity(pair),
            Rule::paren => return Some((self.paren(pair)?, Vec::new())),
            Rule::name => ExprKind::Name(Parts::of(pair).name()?.node),
            Rule::call => {
                let mut parts = Parts::of(pair);
                let function = parts.name()?;
                let mut args = Vec::new();
                while let Some(arg) = parts.any() {
                    let mut arg = Parts::of(arg);
                    args.push(Arg { name: arg.name(), value: self.expr(arg.any()?)? });
                }
                ExprKind::Call { function, args }
            }
            _ => return None,
        };
        Some((Expr { kind, span: at }, Vec::new()))
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

    /// A number with its unit, and the factors behind it that looked like a part of the unit.
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
            let factors = units::factors(word);
            // The first factor is a unit, known or not; the first later one that is none ends it.
            let own = factors.iter().skip(1).position(|f| !units::is_unit(f.symbol));
            let own = own.map_or(factors.len(), |i| i + 1);
            let end = factors.get(own.checked_sub(1)?).map_or(word.len(), |f| f.end);
            let unit_at = if end == word.len() { whole } else { Span::new(start, start + end) };
            value.unit = Some(Spanned::new(word.get(..end)?.nfc().collect(), unit_at));
            at = at.to(unit_at);
            for factor in factors.into_iter().skip(own) {
                rest.push(given_back(word, &factor, start)?);
            }
        }
        Some((Expr { kind: ExprKind::Number(value), span: at }, rest))
    }

    /// The digits alone.
    pub(super) fn number(&mut self, pair: &P<'_>) -> Number {
        let text = pair.as_str().replace('−', "-");
        let value = text.parse::<f64>().unwrap_or(f64::NAN);
        if !value.is_finite() {
            let at = span(pair);
            self.problems.push(SyntaxError::NumberTooLarge { text: shortened(&text), at });
            return Number { value: f64::MAX, text, unit: None };
        }
        Number { value, text, unit: None }
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
        self.problems.push(SyntaxError::TooDeep { limit: CHAIN, at });
        None
    }

    pub(super) fn path(&mut self, pair: P<'_>) -> Option<Path> {
        let mut parts = Parts::of(pair);
        Some(Path { head: parts.name()?, tail: parts.name() })
    }

    /// A value with `cw` or `ccw` behind it.
    pub(super) fn sensed(&mut self, pair: P<'_>) -> Option<Sensed> {
        let mut parts = Parts::of(pair);
        Some(Sensed { value: self.expr(parts.any()?)?, sense: parts.any().map(|p| turn(&p)) })
    }

    /// Values separated by commas.
    pub(super) fn list(&mut self, pair: P<'_>) -> Option<Vec<Expr>> {
        let values = pair.into_inner().filter(|p| p.as_rule() == Rule::expr);
        let values = values.map(|p| self.expr(p)).collect::<Option<Vec<_>>>()?;
        self.decimal_commas(&values);
        Some(values)
    }

    /// `0,5 m` reads as the list `0` and `5 m`, which nobody means.
    pub(super) fn decimal_commas(&mut self, values: &[Expr]) {
        for pair in values.windows(2) {
            let [left, right] = pair else { continue };
            let (ExprKind::Number(whole), ExprKind::Number(tenths)) = (&unsigned(left).kind, &right.kind)
            else {
                continue;
            };
            let plain = |n: &Number| n.text.bytes().all(|b| b.is_ascii_digit());
            let glued = self.read.get(left.span.end..right.span.start) == Some(",");
            let alone = tenths.unit.is_some() || values.len() == 2;
            if glued && whole.unit.is_none() && plain(whole) && plain(tenths) && alone {
                let at = Span::new(left.span.end, right.span.start);
                let help = format!(
                    "write: {} (a blank behind the comma makes it a list)",
                    crate::syntax::line::mended(self.text, at, ".")
                );
                self.problems.push(SyntaxError::DecimalComma { at, help });
            }
        }
    }
}

/// A number behind its sign.
fn unsigned(value: &Expr) -> &Expr {
    match &value.kind {
        ExprKind::Unary(_, inner) => inner,
        _ => value,
    }
}

fn chain(first: Expr, rest: Vec<Link>) -> Expr {
    let Some((_, last)) = rest.last() else { return first };
    let at = first.span.to(last.span);
    Expr { kind: ExprKind::Chain(Box::new(first), rest), span: at }
}

fn signs(parts: &mut Parts<'_>) -> Vec<Spanned<UnaryOp>> {
    let mut found = Vec::new();
    while let Some(sign) = parts.take(Rule::sign) {
        let op = if sign.as_str() == "+" { UnaryOp::Plus } else { UnaryOp::Minus };
        found.push(Spanned::new(op, span(&sign)));
    }
    found
}

/// `*r` or `/r^2` of `6 mm*r^2`, where r is no unit.
fn given_back(word: &str, factor: &units::Factor<'_>, start: usize) -> Option<Link> {
    let op = if factor.divided { BinaryOp::Divide } else { BinaryOp::Multiply };
    let before = word.get(..factor.start)?.chars().next_back()?;
    let op_at = Span::new(start + factor.start - before.len_utf8(), start + factor.start);
    let base_at = Span::new(start + factor.start, start + factor.start + factor.symbol.len());
    let base = Expr { kind: ExprKind::Name(factor.symbol.nfc().collect()), span: base_at };
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

/// A comparison sign.
pub(super) fn compare(pair: &P<'_>) -> Spanned<CompareOp> {
    let op = match pair.as_str().trim() {
        "<" => CompareOp::Less,
        "<=" => CompareOp::LessOrEqual,
        ">" => CompareOp::Greater,
        _ => CompareOp::GreaterOrEqual,
    };
    Spanned::new(op, span(pair))
}

/// `cw` or `ccw`
pub(super) fn turn(pair: &P<'_>) -> Spanned<Turn> {
    let turn = if pair.as_str().starts_with("ccw") { Turn::Ccw } else { Turn::Cw };
    Spanned::new(turn, span(pair))
}

/// A name that may stand for a pose, which may begin with a digit.
pub(super) fn pose_name(pair: &P<'_>) -> crate::syntax::document::Name {
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
