//! What is shown between the words of a text: structure, values, outcomes.

use super::{Analysis, Results};
use crate::report::groups_in_order;
use assur_syntax::document::{ExprKind, Statement};
use assur_text::source::Span;

/// A text to show at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The byte behind which it is shown.
    pub at: usize,
    /// What is shown.
    pub text: String,
}

impl Analysis {
    /// The hints of the statements that touch a part of the text; values of answers where it is solved.
    #[must_use]
    pub fn hints(&self, part: Span, results: Option<&Results>) -> Vec<Hint> {
        let touched = |span: Span| span.start <= part.end && part.start <= span.end;
        let mut found = Vec::new();
        for statement in self.document.statements.iter().filter(|s| touched(s.span)) {
            let mut hint = |at, text: Option<String>| found.extend(text.map(|text| Hint { at, text }));
            match &statement.node {
                Statement::Title(title) => hint(title.span.end, self.structure()),
                Statement::Given(definition) | Statement::Let(definition)
                    if !matches!(definition.value.kind, ExprKind::Number(_)) =>
                {
                    hint(definition.value.span.end, self.equals(&definition.name.node, results));
                }
                Statement::Find(find) => find.items.iter().for_each(|item| {
                    let name = item.name.as_ref().map_or(item.text.as_str(), |name| &name.node);
                    hint(item.span.end, self.equals(name, results));
                }),
                Statement::Expect(_) => {
                    hint(statement.span.end, results.and_then(|results| results.outcome(statement.span)));
                }
                _ => {}
            }
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
