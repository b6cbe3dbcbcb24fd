//! Pieces with several mistakes: every repair brings the reader further, and the last one to the end.

use super::case::Case;
use super::{meant, phrase, swap, within};
use assur_text::diagnostic::{Diagnosis, Problem};
use assur_text::source::{Edit, Span};
use miette::{Diagnostic, LabeledSpan};

/// The most mistakes of a piece.
const MOST: usize = 4;

/// One mistake. What leaves words out is not among them: a line of two or three such repairs says something else.
fn one(case: &Case<'_>) -> Option<Diagnosis> {
    phrase::two_words(case)
        .or_else(|| phrase::article(case))
        .or_else(|| swap::of_without_brackets(case))
        .or_else(|| phrase::of_other_languages(case))
        .or_else(|| meant::in_other_places(case))
        .or_else(|| within::explain(case))
        .or_else(|| swap::one_for_another(case))
        .or_else(|| within::missing(case))
}

/// The mistakes of a piece, with the line as it is to be.
pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    let mut now = (case.text.to_owned(), case.slice.to_owned());
    let mut labels = Vec::new();
    // what the repairs so far did to the text, the last one first
    let mut done: Vec<Edit> = Vec::new();
    for count in 1..=MOST {
        let next = Case::new(&now.0, &now.1, case.offset, case.what);
        let last = if count > 1 { one(&next) } else { None };
        let error = last.clone().or_else(|| one(&next.on_the_way()))?;
        labels.push(label(&error, &done)?);
        let [fix] = <[_; 1]>::try_from(Problem::fixes(&error)).ok()?;
        let [edit] = <[Edit; 1]>::try_from(fix.edits.clone()).ok()?;
        let text = fix.apply(&now.0);
        let end = (case.offset + now.1.len() + text.len()).checked_sub(now.0.len())?;
        let slice = text.get(case.offset..end)?.to_owned();
        if last.is_some() {
            let help = case.help(0, case.slice.len(), &slice);
            return Some(
                Diagnosis::error("mech::syntax::several_mistakes", format!("this line has {count} mistakes"))
                    .labels(labels)
                    .help(help),
            );
        }
        done.insert(0, edit);
        now = (text, slice);
    }
    None
}

/// The mark of a mistake, in the text as it was before the repairs.
fn label(error: &Diagnosis, done: &[Edit]) -> Option<LabeledSpan> {
    let label = Diagnostic::labels(error)?.next()?;
    let before = |at: usize| done.iter().fold(at, unedited);
    let span = Span::new(before(label.offset()), before(label.offset() + label.len()));
    let said = label.label().unwrap_or_default().replace("before this", &error.to_string());
    Some(LabeledSpan::at(span.start..span.end, said))
}

/// Where a place of an edited text was.
fn unedited(at: usize, edit: &Edit) -> usize {
    let end = edit.span.start + edit.with.len();
    if at <= edit.span.start {
        at
    } else if at < end {
        edit.span.start
    } else {
        at - end + edit.span.end
    }
}
