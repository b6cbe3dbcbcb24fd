//! Lenient forms: mistakes that the grammar reads as what they were meant to be, and that are reported nevertheless.

use super::simulation::Lower;
use super::walk::{P, span};
use crate::trivia::{Line, corrected};
use crate::words::{Rule, is_name_char};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::{Edit, Span};
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
                let inner = statement_in_braces(lower.text, lower.read, opened, at);
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
                let help = corrected(lower.text, with_blanks(lower.text, at), " = ");
                let found = pair.as_str().to_owned();
                lower.problems.push(
                    Diagnosis::error("mech::syntax::equals_expected", "use `=` to assign a value")
                        .label(at, format!("`{found}` instead of `=`"))
                        .help(help.certain()),
                );
            }
            Rule::lenient_equals_for_colon => {
                let at = span(&pair);
                let before = Span::new(with_blanks(lower.text, at).start, at.end);
                let help = corrected(lower.text, before, ":");
                let found = pair.as_str().to_owned();
                lower.problems.push(
                    Diagnosis::error(
                        "mech::syntax::colon_expected",
                        "use `:` between a name and what it joins",
                    )
                    .label(at, format!("`{found}` instead of `:`"))
                    .help(help.certain()),
                );
            }
            Rule::lenient_bare_point => {
                lower.problems.push(bare_point(lower.text, pair.as_str(), span(&pair)))
            }
            _ => {}
        }
    }
}

/// `at` is where the last member ends; what stands next is what the brace is missing before.
fn missing_brace(text: &str, open: Span, at: Span) -> Diagnosis {
    let rest = text.get(at.start..).unwrap_or_default();
    let next = at.start + rest.find(|c: char| !c.is_whitespace() && c != ';').unwrap_or(rest.len());
    let line = text.get(next..Line::around(text, next).end).unwrap_or_default().trim();
    let before = if line.is_empty() { "at the end".to_owned() } else { format!("before: {line}") };
    let word = line.chars().take_while(|c| c.is_alphanumeric());
    let length = word.map(char::len_utf8).sum::<usize>();
    let words = format!("write `}}` on a line of its own {before}");
    // before the line, unless the brace is opened on it
    let start = if line.is_empty() { text.len() } else { Line::around(text, next).start };
    let newline = if start > 0 && !text[..start].ends_with('\n') { "\n" } else { "" };
    let edit = Edit::new(Span::new(start, start), format!("{newline}}}\n"));
    let help = if start > open.end {
        Help::lines(text, edit.span, vec![edit]).in_words(words)
    } else {
        words.into()
    };
    Diagnosis::error("mech::syntax::missing_brace", "a brace is not closed")
        .label(open, "opened here")
        .label(Span::new(next, next + length), "still open here")
        .help(help)
}

/// A place with the blanks around it.
pub(super) fn with_blanks(text: &str, at: Span) -> Span {
    let (before, behind) = (&text[..at.start], &text[at.end..]);
    let blank = [' ', '\t'];
    let start = before.trim_end_matches(blank).len();
    Span::new(start, text.len() - behind.trim_start_matches(blank).len())
}

fn late_brace(text: &str, pair: &P<'_>) -> Diagnosis {
    let whole = pair.as_span();
    let line = Line::around(text, whole.start());
    let written = text.get(line.start..line.end).unwrap_or_default();
    let code = written.split_once("//").map_or(written, |(code, _)| code).trim();
    let start = line.start + (written.len() - written.trim_start().len());
    let end = start + code.len();
    let brace = Span::new(whole.end(), whole.end() + 1);
    let edits = vec![Edit::new(Span::new(end, end), " {"), Edit::new(brace, "")];
    Diagnosis::error("mech::syntax::brace_on_its_own_line", "put `{` on the same line as its statement")
        .label(brace, "this brace")
        .label(Span::new(start, end), "after this")
        .help(
            Help::lines(text, Span::new(start, start), edits).in_words(format!("write: {code} {{")).certain(),
        )
}

fn bare_point(text: &str, number: &str, at: Span) -> Diagnosis {
    let (side, fixed) = match number.strip_suffix('.') {
        Some(whole) => ("behind", format!("{whole}.0")),
        None => ("before", format!("0{number}")),
    };
    Diagnosis::error("mech::syntax::bare_decimal_point", "a decimal point needs digits on both sides")
        .label(at, format!("no digits {side} the point"))
        .help(corrected(text, at, &fixed).certain())
}

// Statements within the braces of another one.

/// `{ S (150 mm, 0); force on crank at B = 10 N @ 0 deg }`: the braces, open at `open`, end after one statement that
/// follows `members`. The place of the closing brace comes with it.
pub(super) fn statement_in_braces(
    text: &str,
    read: &str,
    open: Span,
    members: Span,
) -> Option<(Diagnosis, usize)> {
    let blank = |c: char| c.is_whitespace() || c == ';';
    let rest = read.get(members.start..)?;
    let start = members.start + (rest.len() - rest.trim_start_matches(blank).len());
    let brace = start + closing(read.get(start..)?)?;
    let statement = text.get(start..brace)?.trim_end();
    let word = statement.split(|c| !is_name_char(c)).next()?;
    let line = Line::around(text, open.start);
    let help = if brace < line.end {
        let members = line.start + text.get(line.start..start)?.trim_end_matches(blank).len();
        let end = start + statement.len();
        let edits =
            vec![Edit::new(Span::new(members, start), " }; "), Edit::new(Span::new(end, brace + 1), "")];
        Help::lines(text, Span::new(members, brace), edits)
    } else {
        "move it after the brace that closes these".into()
    };
    let at = Span::new(start, start + word.len());
    Some((
        Diagnosis::error("mech::syntax::statement_in_braces", format!("`{word}` is a statement of its own"))
            .label(open, "within these braces")
            .primary(at, "this belongs after them")
            .help(help),
        brace,
    ))
}

/// Where a brace closes that is not open, if nothing but one statement stands before it.
fn closing(statement: &str) -> Option<usize> {
    let mut depth = 0_usize;
    let mut quoted = false;
    for (at, c) in statement.char_indices() {
        match c {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' | '[' | '{' => depth += 1,
            '}' if depth == 0 => return Some(at),
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ';' | '\n' if depth == 0 => {
                let behind = statement.get(at..)?;
                let end = behind.trim_start_matches([';', '\n', ' ', '\r', '\t']);
                return end.starts_with('}').then(|| at + behind.len() - end.len());
            }
            _ => {}
        }
    }
    None
}
