//! The same in other words: a number with a name or in another unit, a pair with its points, an answer as an `expect`.

use super::super::{Analysis, Results, units_alike};
use super::{Change, ChangeKind};
use assur_syntax::TokenKind;
use assur_syntax::document::{End, Statement};
use assur_text::language::JointKind;
use assur_text::source::{Edit, Span};
use assur_text::units::lookup;

/// The most units that are offered for another.
const UNITS: usize = 6;
/// What a number in another unit may differ by.
const ROUNDING: f64 = 4e-16;

impl Analysis {
    /// The number at a byte with a name of its own.
    pub(super) fn number_as_given(&self, byte: usize) -> Option<Change> {
        let (number, unit) = self.number_at(byte)?;
        let whole = unit.map_or(number, |unit| number.to(unit));
        let touches = |span: Span| span.start <= byte && byte <= span.end;
        let statement = self.document.statements.iter().find(|s| touches(s.span))?;
        if matches!(statement.node, Statement::Given(_)) {
            return None;
        }
        let is_free = |name: &String| self.names.declared().all(|declared| declared.name != *name);
        let name =
            (1..).map(|n| if n == 1 { "value".to_owned() } else { format!("value_{n}") }).find(is_free)?;
        let line = format!("given {name} = {}", self.written(whole));
        let before = self.line_start(statement.span.start);
        let edits = vec![Edit::new(Span::new(before, before), format!("{line}\n")), Edit::new(whole, name)];
        let change =
            Change { title: format!("declare `{line}` and use it"), edits, kind: ChangeKind::Extract };
        (self.errors_with(&change.edits) <= self.errors()).then_some(change)
    }

    /// The answers that a place asks for, as the expectations of the text.
    pub(super) fn answers_as_keys(&self, at: Span, results: &Results) -> Vec<Change> {
        let touches = |span: Span| span.start <= at.end && at.start <= span.end;
        let mut found = Vec::new();
        for statement in self.document.statements.iter().filter(|s| touches(s.span)) {
            let Statement::Find(find) = &statement.node else { continue };
            for item in find.items.iter().filter(|item| touches(item.span)) {
                let name = item.name.as_ref().map_or(item.text.as_str(), |name| &name.node);
                let Some(value) = results.value(name).filter(|value| !value.contains('…')) else {
                    continue;
                };
                let line = format!("expect {name} = {value}");
                let end = Span::new(statement.span.end, statement.span.end);
                let edits = vec![Edit::new(end, format!("\n{line}"))];
                let change = Change { title: format!("add `{line}`"), edits, kind: ChangeKind::Rewrite };
                found.extend((self.errors_with(&change.edits) <= self.errors()).then_some(change));
            }
        }
        found
    }

    /// The number at a byte, with its unit.
    fn number_at(&self, byte: usize) -> Option<(Span, Option<Span>)> {
        let touches = |span: Span| span.start <= byte && byte <= span.end;
        let index = self.tokens.iter().position(|t| t.kind == TokenKind::Number && touches(t.span))?;
        let unit = self.tokens.get(index + 1).filter(|next| next.kind == TokenKind::Unit);
        Some((self.tokens[index].span, unit.map(|unit| unit.span)))
    }

    /// The number at a byte in other units of its dimension.
    pub(super) fn other_units(&self, byte: usize) -> Vec<Change> {
        let Some((number, Some(unit))) = self.number_at(byte) else { return Vec::new() };
        let Ok(own) = lookup(self.written(unit)) else { return Vec::new() };
        let Ok(value) = self.written(number).parse::<f64>() else { return Vec::new() };
        let change = |(text, factor): (&str, f64)| {
            let with = format!("{} {text}", number_of(value * own.factor, factor));
            let edits = vec![Edit::new(number.to(unit), with.as_str())];
            Change { title: format!("write `{with}`"), edits, kind: ChangeKind::Rewrite }
        };
        units_alike(&own).into_iter().take(UNITS).map(change).collect()
    }

    /// The pairs at a place with the points that they find by their names.
    pub(super) fn points_written_out(&self, at: Span) -> Vec<Change> {
        let touches = |span: Span| span.start <= at.end && at.start <= span.end;
        let mut found = Vec::new();
        for statement in self.document.statements.iter().filter(|s| touches(s.span)) {
            let Statement::Joint(joint) = &statement.node else { continue };
            if joint.kind.node != JointKind::Revolute {
                continue;
            }
            let ends = joint.ends.iter().filter_map(|end| match end {
                End::At(path) if path.tail.is_none() => Some(path.head.span.end),
                _ => None,
            });
            let point = format!(".{}", joint.name.node);
            let edits = ends.map(|end| Edit::new(Span::new(end, end), point.as_str())).collect::<Vec<_>>();
            if edits.is_empty() || self.errors_with(&edits) > self.errors() {
                continue;
            }
            let title = format!("write the points of `{}`", joint.name.node);
            found.push(Change { title, edits, kind: ChangeKind::Rewrite });
        }
        found
    }
}

/// A value in SI units in a unit, with the fewest digits that say the same.
fn number_of(value: f64, factor: f64) -> String {
    let wanted = value / factor;
    let rounded = (0..17).filter_map(|digits| format!("{wanted:.digits$e}").parse::<f64>().ok());
    let fewest = { rounded }.find(|x| (x * factor - value).abs() <= ROUNDING * value.abs());
    fewest.unwrap_or(wanted).to_string()
}
