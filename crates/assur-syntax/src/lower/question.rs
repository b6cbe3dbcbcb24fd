//! Find, expect, variants.

use super::expr::{PLUS_MINUS, pose_name};
use super::label::label;
use super::lenient::with_blanks;
use super::simulation::Lower;
use super::walk::{P, Parts, nfc, span, text};
use crate::document::{
    Cell, Column, Curve, CurveBetween, CurveBeyond, Expect, ExpectAt, Expr, Find, FindItem, Row, Variants,
};
use crate::recover::{What, instead};
use crate::trivia::corrected;
use crate::words::Rule;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::{Span, Spanned};
use pest::iterators::Pair;

impl Lower<'_> {
    pub(super) fn find(&mut self, pair: P<'_>) -> Option<Find> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let mut items = Vec::new();
        while let Some(item) = parts.any() {
            items.push(self.find_item(item)?);
        }
        Some(Find { items })
    }

    fn find_item(&mut self, pair: P<'_>) -> Option<FindItem> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        let name = parts.name();
        let value = self.expr(parts.any()?)?;
        let steps = if parts.word(Rule::w_in) { Some(self.expr(parts.any()?)?) } else { None };
        parts.word(Rule::w_steps);
        let unit = if parts.word(Rule::w_as) { parts.any().map(|p| text(&p)) } else { None };
        let text = label(&value, self.read);
        Some(FindItem { name, value, text, steps, unit, span: at })
    }

    pub(super) fn expect(&mut self, pair: P<'_>) -> Option<Expect> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let what = self.expr(parts.any()?)?;
        let text = label(&what, self.read);
        let values = match parts.take(Rule::list) {
            Some(list) => {
                if self.plus_minus(span(&list)) {
                    return None;
                }
                self.list(list)?
            }
            None => Vec::new(),
        };
        let within = self.within(&mut parts)?;
        parts.word(Rule::w_at);
        let at = match parts.any() {
            None => None,
            Some(pair) if pair.as_rule() == Rule::expect_pose => {
                let mut inner = Parts::of(pair);
                inner.any()?;
                Some(ExpectAt::Pose(pose_name(&inner.any()?)))
            }
            Some(pair) if pair.as_rule() == Rule::expect_event => {
                let mut inner = Parts::of(pair);
                inner.any()?;
                let name = inner.name()?;
                // a number of more digits than a machine counts to names no event
                let count = |p: &P<'_>| Spanned::new(p.as_str().parse().unwrap_or(usize::MAX), span(p));
                Some(ExpectAt::Event(name, inner.any().as_ref().map(count)))
            }
            Some(pair) => Some(ExpectAt::Settings(self.settings(&mut Parts::of(pair))?)),
        };
        Some(Expect { what, text, values, within, at })
    }

    /// `5 mm +- 1 %` reads as a sum: a tolerance is meant.
    fn plus_minus(&mut self, values: Span) -> bool {
        let written = self.read.get(values.start..values.end).unwrap_or_default();
        let found = PLUS_MINUS.iter().filter_map(|sign| Some((written.find(sign)?, *sign))).min();
        let Some((start, sign)) = found else { return false };
        let at = Span::new(values.start + start, values.start + start + sign.len());
        let help = corrected(self.text, with_blanks(self.text, at), " within ");
        self.problems.push(instead(sign, "within", at, help));
        true
    }

    pub(super) fn within(&mut self, parts: &mut Parts<'_>) -> Option<Option<Expr>> {
        let Some(pair) = parts.take(Rule::within) else { return Some(None) };
        let mut inner = Parts::of(pair);
        inner.any()?;
        Some(Some(self.expr(inner.any()?)?))
    }

    pub(super) fn curve(&mut self, pair: P<'_>) -> Option<Curve> {
        let mut parts = Parts::of(pair);
        parts.any()?;
        let name = parts.name()?;
        let linear = parts.word(Rule::w_linear).then_some(CurveBetween::Linear);
        let between = linear.or_else(|| parts.word(Rule::w_smooth).then_some(CurveBetween::Smooth));
        let periodic = parts.word(Rule::w_periodic).then_some(CurveBeyond::Periodic);
        let beyond = periodic.or_else(|| parts.word(Rule::w_held).then_some(CurveBeyond::Held));
        let table = self.rows(std::iter::from_fn(|| parts.any()));
        Some(Curve { name, between, beyond, table })
    }

    /// The header and the rows of `variants` or of a curve.
    pub(super) fn rows<'i>(&mut self, pairs: impl Iterator<Item = Pair<'i, Rule>>) -> Variants {
        let mut variants = Variants::default();
        let pairs = pairs.collect::<Vec<_>>();
        if super::table::units_in_rows(self, &pairs) {
            let header = pairs.iter().find(|p| matches!(p.as_rule(), Rule::header | Rule::bad_header));
            variants.bad.extend(header.into_iter().flat_map(|p| crate::recover::names(p.as_str())));
            return variants;
        }
        for pair in pairs {
            let at = span(&pair);
            match pair.as_rule() {
                Rule::header => variants.columns = pair.into_inner().filter_map(column).collect(),
                Rule::row => {
                    let cells = pair.into_inner().filter(|p| p.as_rule() == Rule::cell);
                    let cells = cells.filter_map(|p| self.cell(p)).collect();
                    variants.rows.push(Row { cells, span: at });
                }
                Rule::bad_header => variants.bad.extend(self.bad(&pair, What::Header).names),
                Rule::bad_row => {
                    self.bad(&pair, What::Row);
                }
                _ => {}
            }
        }
        variants
    }

    fn cell(&mut self, pair: P<'_>) -> Option<Spanned<Cell>> {
        let at = span(&pair);
        let mut parts = Parts::of(pair);
        if let Some(name) = parts.take(Rule::row_name) {
            return Some(Spanned::new(Cell::Name(nfc(name.as_str().trim_matches('"'))), at));
        }
        let negative = parts.take(Rule::sign).is_some_and(|s| s.as_str() != "+");
        let mut quantity = Parts::of(parts.any()?);
        let mut number = self.number(&quantity.any()?);
        if let Some(unit) = quantity.any() {
            let unit = span(&unit);
            let help = corrected(self.text, unit, "");
            let row = help.to_string().replacen("write", "the header names the unit, the row is", 1);
            let help = help.in_words(row);
            self.problems.push(
                Diagnosis::error(
                    "mech::syntax::unit_in_row",
                    "table rows take plain numbers; the unit goes in the header",
                )
                .label(unit, "a unit")
                .help(help),
            );
        }
        if negative {
            number.value = -number.value;
            number.text.insert(0, '-');
        }
        Some(Spanned::new(Cell::Number(number), at))
    }
}

fn column(pair: P<'_>) -> Option<Column> {
    if pair.as_rule() != Rule::column {
        return None;
    }
    let mut parts = Parts::of(pair);
    Some(Column { name: parts.name()?, unit: parts.any().map(|p| text(&p)) })
}
