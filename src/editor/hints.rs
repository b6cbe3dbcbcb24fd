//! What is shown between the words of a text: structure, values, outcomes.

use super::{Analysis, Results};
use crate::report::groups_in_order;
use assur_syntax::document::{ExprKind, Statement};
use assur_text::source::{Span, Spanned};
use indexmap::IndexMap;
use std::sync::Arc;

/// What a hint shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HintKind {
    /// Mobility and groups, at the title.
    Structure,
    /// A value, at a definition or a question.
    Value,
    /// Whether an expectation is met.
    Outcome,
}

/// A text as it was when it had answers.
#[derive(Clone, Debug)]
pub struct Earlier {
    pub analysis: Arc<Analysis>,
    pub results: Arc<Results>,
}

/// A text to show at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The byte behind which it is shown.
    pub at: usize,
    pub text: String,
    /// What it is about.
    pub kind: HintKind,
}

impl Analysis {
    /// The hints of the statements that touch a part of the text; values of answers where it is solved. As long as it is not, a
    /// statement that is written as it was keeps the hints that it had.
    #[must_use]
    pub fn hints(&self, part: Span, results: Option<&Results>, earlier: Option<&Earlier>) -> Vec<Hint> {
        let touched = |span: Span| span.start <= part.end && part.start <= span.end;
        let kept = earlier.filter(|_| results.is_none()).map(Earlier::hints).unwrap_or_default();
        let mut found = Vec::new();
        for statement in self.document.statements.iter().filter(|s| touched(s.span)) {
            let mut own = self.hints_of(statement, results);
            for hint in kept.get(self.written(statement.span)).into_iter().flatten() {
                let at = statement.span.start + hint.at;
                if own.iter().all(|own| own.at != at) {
                    own.push(Hint { at, ..hint.clone() });
                }
            }
            own.sort_by_key(|hint| hint.at);
            found.extend(own);
        }
        found
    }

    fn hints_of(&self, statement: &Spanned<Statement>, results: Option<&Results>) -> Vec<Hint> {
        let mut found = Vec::new();
        let mut hint =
            |kind, at, text: Option<String>| found.extend(text.map(|text| Hint { at, text, kind }));
        match &statement.node {
            Statement::Title(title) => hint(HintKind::Structure, title.span.end, self.structure()),
            Statement::Given(definition) | Statement::Let(definition)
                if !matches!(definition.value.kind, ExprKind::Number(_)) =>
            {
                let value = self.equals(&definition.name.node, results);
                hint(HintKind::Value, definition.value.span.end, value);
            }
            Statement::Find(find) => find.items.iter().for_each(|item| {
                let name = item.name.as_ref().map_or(item.text.as_str(), |name| &name.node);
                hint(HintKind::Value, item.span.end, self.equals(name, results));
            }),
            Statement::Expect(_) => {
                let outcome = results.and_then(|results| results.outcome(statement.span));
                hint(HintKind::Outcome, statement.span.end, outcome);
            }
            _ => {}
        }
        found
    }

    /// ` = 26 N*m`
    fn equals(&self, name: &str, results: Option<&Results>) -> Option<String> {
        Some(format!("= {}", self.quantity(name, results)?))
    }

    /// `F = 1 · crank (I, driven) · rod, piston (II, RRP)`
    fn structure(&self) -> Option<String> {
        let model = self.compiled.as_ref()?.model();
        let groups = groups_in_order(&model).into_iter();
        let groups = groups.map(|(links, kind)| format!(" · {} ({kind})", links.join(", ")));
        Some(format!("F = {}{}", model.structure.count.mobility, groups.collect::<String>()))
    }
}

impl Earlier {
    /// The hints of each statement, by its words, from its first byte.
    fn hints(&self) -> IndexMap<&str, Vec<Hint>> {
        let analysis = &self.analysis;
        let hints = |statement: &Spanned<Statement>| {
            let own = analysis.hints_of(statement, Some(&self.results)).into_iter();
            own.map(|hint| Hint { at: hint.at.saturating_sub(statement.span.start), ..hint }).collect()
        };
        let all = analysis.document.statements.iter();
        all.map(|statement| (analysis.written(statement.span), hints(statement))).collect()
    }
}
