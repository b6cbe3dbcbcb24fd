//! Applies fixes about which there is no doubt.

use super::check_source;
use assur_check::Overrides;
use assur_text::diagnostic::Problems;
use assur_text::source::{Edit, Source, edited};

/// How often a text is looked at again: a fix can reveal what it hid.
const ROUNDS: usize = 20;

/// A text with all certain fixes, and how many were applied.
#[must_use]
pub fn fixed(source: &Source, overrides: &Overrides) -> (Source, usize) {
    let mut source = source.clone();
    let mut count = 0;
    for _ in 0..ROUNDS {
        let (edits, fixes) = certain_edits(&check_source(&source, overrides).1);
        if fixes == 0 {
            break;
        }
        source.text = edited(&source.text, &edits);
        count += fixes;
    }
    (source, count)
}

/// The edits of the certain fixes that do not touch each other, in order, and how many fixes they are.
#[must_use]
pub fn certain_edits(problems: &Problems) -> (Vec<Edit>, usize) {
    let mut fixes = problems.fixes();
    fixes.retain(|fix| fix.certain && !fix.edits.is_empty());
    fixes.sort_by(|a, b| a.edits.cmp(&b.edits));
    let (mut edits, mut count, mut end) = (Vec::<Edit>::new(), 0, None);
    for fix in fixes {
        let start = fix.edits[0].span.start;
        if end.is_none_or(|end| start > end) {
            end = fix.edits.last().map(|edit| edit.span.end);
            edits.extend(fix.edits);
            count += 1;
        }
    }
    (edits, count)
}
