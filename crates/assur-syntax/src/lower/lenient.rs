//! Lenient forms: mistakes that the grammar reads as what they were meant to be, and that are reported nevertheless.

use super::inner;
use super::state::Lower;
use super::walk::{P, span};
use crate::error::SyntaxError;
use crate::grammar::Rule;
use crate::line::{Line, corrected};
use assur_text::source::Span;
use pest::iterators::Pairs;

/// Reports every lenient form in a file, in one pass over all pairs.
pub(super) fn report(lower: &mut Lower<'_>, pairs: Pairs<'_, Rule>) {
    let mut open = Vec::new();
    for pair in pairs.flatten() {
        match pair.as_rule() {
            Rule::p_brace => open.push(span(&pair)),
            Rule::p_end => {
                open.pop();
            }
            Rule::lenient_missing_brace => {
                let at = span(&pair);
                let opened = open.pop().unwrap_or(at);
                let inner = inner::statement_in_braces(lower.text, lower.read, opened, at);
                lower.problems.push(match inner {
                    Some((problem, brace)) => {
                        lower.closing.insert(brace);
                        problem
                    }
                    None => missing_brace(lower.text, opened, at),
                });
            }
            Rule::lenient_late_brace => lower.problems.push(late_brace(lower.text, &pair)),
            Rule::lenient_colon_for_equals => {
                let at = span(&pair);
                let help = format!("write: {}", corrected(lower.text, at, " =").replace("  ", " "));
                let found = pair.as_str().to_owned();
                lower.problems.push(SyntaxError::EqualsExpected { found, at, help });
            }
            Rule::lenient_equals_for_colon => {
                let at = span(&pair);
                let help = format!("write: {}", corrected(lower.text, at, ":").replace(" :", ":"));
                let found = pair.as_str().to_owned();
                lower.problems.push(SyntaxError::ColonExpected { found, at, help });
            }
            Rule::lenient_bare_point => {
                lower.problems.push(bare_point(lower.text, pair.as_str(), span(&pair)))
            }
            _ => {}
        }
    }
}

/// `at` is where the last member ends; what stands next is what the brace is missing before.
fn missing_brace(text: &str, open: Span, at: Span) -> SyntaxError {
    let rest = text.get(at.start..).unwrap_or_default();
    let next = at.start + rest.find(|c: char| !c.is_whitespace() && c != ';').unwrap_or(rest.len());
    let line = text.get(next..Line::around(text, next).end).unwrap_or_default().trim();
    let before = if line.is_empty() { "at the end".to_owned() } else { format!("before: {line}") };
    let word = line.chars().take_while(|c| c.is_alphanumeric());
    let length = word.map(char::len_utf8).sum::<usize>();
    SyntaxError::MissingBrace { open, at: Span::new(next, next + length), before }
}

fn late_brace(text: &str, pair: &P<'_>) -> SyntaxError {
    let whole = pair.as_span();
    let line = Line::around(text, whole.start());
    let written = text.get(line.start..line.end).unwrap_or_default();
    let code = written.split_once("//").map_or(written, |(code, _)| code).trim();
    let start = line.start + (written.len() - written.trim_start().len());
    SyntaxError::BraceOnItsOwnLine {
        brace: Span::new(whole.end(), whole.end() + 1),
        statement: Span::new(start, start + code.len()),
        help: format!("write: {code} {{"),
    }
}

fn bare_point(text: &str, number: &str, at: Span) -> SyntaxError {
    let (side, fixed) = match number.strip_suffix('.') {
        Some(whole) => ("behind", format!("{whole}.0")),
        None => ("before", format!("0{number}")),
    };
    SyntaxError::BareDecimalPoint { at, side, help: format!("write: {}", corrected(text, at, &fixed)) }
}
