//! What can be changed in the text of a position without solution.

use super::error::SolveError;
use crate::source::{Edit, Span};
use assur_text::diagnostic::{Fix, Problem};
use miette::LabeledSpan;

impl Problem for SolveError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::Ambiguous { help, .. } => Fix::added(help),
            // the first label is the clause
            Self::HintNotMet { help, labels, .. } => {
                labels.first().map(|at| clauses(help, at)).unwrap_or_default()
            }
            Self::EmptyRange { help, span, .. } => {
                Fix::quoted(help, Span::new(span.offset(), span.offset() + span.len()))
            }
            _ => Vec::new(),
        }
    }
}

/// The clauses that a help lists, each in place of one that is not met.
fn clauses(help: &str, at: &LabeledSpan) -> Vec<Fix> {
    let clause =
        |line: &str| Some(line.strip_prefix("  assemble ")?.split("  //").next()?.trim_end().to_owned());
    let span = Span::new(at.offset(), at.offset() + at.len());
    let fix = |clause: String| {
        let edits = vec![Edit::new(span, clause.as_str())];
        Fix { title: format!("write `assemble {clause}`"), edits, certain: false }
    };
    help.lines().filter_map(clause).map(fix).collect()
}
