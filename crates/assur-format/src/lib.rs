//! The one style of `.mech` files. The formatter moves blanks, never words: it works on the tokens of a text, and the tree says
//! what stands in columns.

mod columns;
mod layout;
mod rows;

use assur_syntax::document::Document;
use assur_syntax::{Token, parse_with_tokens};
use assur_text::diagnostic::Problems;
use assur_text::source::{Edit, Source};
use std::ops::RangeInclusive;

/// The edits that put a text in the one style, in order.
///
/// # Errors
/// What is wrong with a text that does not read; it is left alone.
pub fn edits(source: &Source) -> Result<Vec<Edit>, Problems> {
    let (document, tokens, problems) = parse_with_tokens(source);
    if problems.has_errors() { Err(problems) } else { Ok(edits_of(&source.text, &tokens, &document)) }
}

/// As [`edits`], of a text that is read.
#[must_use]
pub fn edits_of(text: &str, tokens: &[Token], document: &Document) -> Vec<Edit> {
    let mut layout = layout::Layout::of(text, tokens);
    layout::space(&mut layout);
    columns::align(&mut layout, document);
    layout::changes(&layout)
}

/// The edits that touch lines from `lines.start()` to `lines.end()`, counted from 1.
#[must_use]
pub fn touching(text: &str, edits: Vec<Edit>, lines: RangeInclusive<usize>) -> Vec<Edit> {
    let start = |line: usize| match line.checked_sub(2) {
        None => 0,
        Some(ends) => text.match_indices('\n').nth(ends).map_or(text.len(), |(at, _)| at + 1),
    };
    let (from, to) = (start(*lines.start()), start(lines.end().saturating_add(1)));
    edits.into_iter().filter(|edit| edit.span.start < to && edit.span.end >= from).collect()
}
