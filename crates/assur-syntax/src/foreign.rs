//! What is reported of characters and comments of other kinds.

use super::change::{Change, Kind};
use super::character_error::CharacterError;
use super::error::SyntaxError;
use super::line::Line;
use assur_text::diagnostic::{Help, Problems};
use assur_text::source::{Edit, Span};

/// One diagnostic for all comments of other languages: they are one habit.
pub(super) fn comments(text: &str, comments: &[Span]) -> Option<SyntaxError> {
    let first = *comments.first()?;
    let sign = if text[first.start..].starts_with('#') { "#" } else { "/*" };
    let line = Line::around(text, first.start);
    let written = |from: usize, to: usize| text.get(from..to).unwrap_or_default();
    let before = written(line.start, first.start).trim();
    let closed = first.end > first.start + 1;
    let (comment, behind) = if closed {
        (written(first.start + 2, first.end - 2), written(first.end, Line::around(text, first.end).end))
    } else {
        (written(first.start + sign.len(), line.end), "")
    };
    let lines = comment.contains('\n');
    let code = [before, behind.trim()].join(" ").trim().to_owned();
    let mut help = match (lines, code.is_empty()) {
        (true, _) => "begin each line of this comment with `//`".to_owned(),
        (false, true) => format!("write: // {}", comment.trim()),
        (false, false) => format!("write: {code}  // {}", comment.trim()),
    };
    if let more @ 1.. = comments.len() - 1 {
        let plural = if more == 1 { "comment" } else { "comments" };
        help = format!("{help}\nand so for {more} more {plural}");
    }
    let at = Span::new(first.start, first.start + sign.len());
    // a sign for a whole comment is one at each of its lines
    let signs = comments.iter().map(|comment| Edit::new(Span::new(comment.start, comment.start + 1), "//"));
    let all_plain = comments.iter().all(|comment| text[comment.start..].starts_with('#'));
    let help = if all_plain { Help::lines(text, at, signs.collect()).in_words(help) } else { help.into() };
    Some(SyntaxError::CommentSign { at, found: sign.to_owned(), help })
}

/// One diagnostic for each kind on a line.
pub(super) fn report(text: &str, changes: &[Change], problems: &mut Problems) {
    let mut rest = changes;
    while let Some(first) = rest.first() {
        let line = Line::around(text, first.span.start);
        let count = rest.iter().take_while(|c| c.span.start < line.end.max(first.span.end)).count();
        let (here, later) = rest.split_at(count);
        let edits = here.iter().map(|change| Edit::new(change.span, change.with)).collect();
        let help = Help::lines(text, Span::new(line.start, line.end), edits);
        for kind in [Kind::FullWidth, Kind::Quote, Kind::Sign, Kind::Invisible] {
            if let Some(problem) = describe(text, here, kind, &help) {
                problems.push(problem);
            }
        }
        rest = later;
    }
}

fn describe(text: &str, changes: &[Change], kind: Kind, help: &Help) -> Option<CharacterError> {
    let first = changes.iter().find(|c| c.kind == kind)?;
    let found = text[first.span.start..].chars().next()?;
    let help = help.clone();
    // The first run of neighbours.
    let mut at = first.span;
    for change in changes.iter().filter(|c| c.kind == kind && c.with != "\"") {
        if change.span.start == at.end {
            at.end = change.span.end;
        }
    }
    Some(match kind {
        Kind::FullWidth => CharacterError::FullWidth { at, help },
        Kind::Quote => CharacterError::CurlyQuotes { at: first.span, help },
        Kind::Sign => CharacterError::ForeignSign { found, at: first.span, wanted: first.with, help },
        Kind::Invisible => {
            CharacterError::InvisibleCharacter { found: u32::from(found), at: first.span, help }
        }
    })
}
