//! Rules for the whole file: it is not empty, the edition is first, there is one title.

use super::document::{Document, Statement};
use super::error::SyntaxError;
use assur_text::diagnostic::Problems;
use assur_text::source::Span;

/// The edition that this compiler reads.
const EDITION: &str = "1";

pub(super) fn check(document: &Document, problems: &mut Problems) {
    if document.statements.is_empty() && !problems.has_errors() {
        problems.push(SyntaxError::EmptyFile);
    }
    let mut title: Option<Span> = None;
    let mut edition: Option<Span> = None;
    for (index, statement) in document.statements.iter().enumerate() {
        let at = statement.span;
        match &statement.node {
            Statement::Title(_) => match title {
                Some(first) => problems.push(SyntaxError::TitleTwice { at, first }),
                None => title = Some(at),
            },
            Statement::Edition(number) => {
                if number.node != EDITION {
                    let found = number.node.clone();
                    problems.push(SyntaxError::UnknownEdition { found, at: number.span });
                }
                let first = document.statements.first().map_or(at, |s| s.span);
                if let Some(before) = edition {
                    let (other, help) = ("already given here", "remove one of them");
                    problems.push(SyntaxError::EditionNotFirst { at, before, other, help });
                } else if index > 0 {
                    let help = "move it to the first line";
                    let other = "the first statement";
                    problems.push(SyntaxError::EditionNotFirst { at, before: first, other, help });
                }
                edition = Some(edition.unwrap_or(at));
            }
            _ => {}
        }
    }
}
