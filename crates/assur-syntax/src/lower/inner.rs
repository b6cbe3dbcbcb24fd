//! Statements within the braces of another one.

use crate::error::SyntaxError;
use crate::line::Line;
use crate::words::is_name_char;
use assur_text::diagnostic::Help;
use assur_text::source::{Edit, Span};

/// `{ S (150 mm, 0); force on crank at B = 10 N @ 0 deg }`: the braces, open at `open`, end after one statement that
/// follows `members`. The place of the closing brace comes with it.
pub(super) fn statement_in_braces(
    text: &str,
    read: &str,
    open: Span,
    members: Span,
) -> Option<(SyntaxError, usize)> {
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
    Some((SyntaxError::StatementInBraces { word: word.to_owned(), open, at, help }, brace))
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
