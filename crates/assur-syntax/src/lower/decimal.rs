//! Lists that are numbers with decimal commas.

use super::state::Lower;
use crate::comma;
use crate::document::{Expr, ExprKind, Number};
use crate::error::SyntaxError;
use crate::line::corrected;
use assur_text::source::Span;

impl Lower<'_> {
    /// `0,5 m` reads as the list `0` and `5 m`, which nobody means: it is reported, and read as one number. Says whether
    /// that was so.
    pub(super) fn decimal_comma(&mut self, left: &mut Expr, right: &Expr, alone: bool) -> bool {
        let at = Span::new(left.span.end, right.span.start);
        let whole_at = left.span.to(right.span);
        let (Some(whole), ExprKind::Number(tenths)) = (unsigned(left), &right.kind) else { return false };
        let plain = |n: &Number| n.text.bytes().all(|b| b.is_ascii_digit());
        let glued = self.read.get(at.start..at.end) == Some(",");
        let alone = alone || tenths.unit.is_some();
        if !(glued && whole.unit.is_none() && plain(whole) && plain(tenths) && alone) {
            return false;
        }
        whole.text = format!("{}.{}", whole.text, tenths.text);
        whole.value = whole.text.parse().unwrap_or(whole.value);
        whole.unit.clone_from(&tenths.unit);
        left.span = whole_at;
        let number = self.text.get(whole_at.start..whole_at.end).unwrap_or_default();
        let lines = comma::readings(number, &comma::between_digits(number));
        let lines = lines.iter().map(|new| corrected(self.text, whole_at, new));
        self.problems.push(SyntaxError::comma_in_number(at, lines.collect()));
        true
    }

    /// As [`Self::decimal_comma`], for every two neighbours of a list.
    pub(super) fn decimal_commas(&mut self, values: Vec<Expr>) -> Vec<Expr> {
        let alone = values.len() == 2;
        let mut kept = Vec::<Expr>::with_capacity(values.len());
        for value in values {
            let merged = kept.last_mut().is_some_and(|last| self.decimal_comma(last, &value, alone));
            if !merged {
                kept.push(value);
            }
        }
        kept
    }
}

/// A number after its sign.
fn unsigned(value: &mut Expr) -> Option<&mut Number> {
    match &mut value.kind {
        ExprKind::Unary(_, inner) => unsigned(inner),
        ExprKind::Number(number) => Some(number),
        _ => None,
    }
}
