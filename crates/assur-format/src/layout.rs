//! Lines of tokens, with the blanks before each.

use assur_syntax::{Token, TokenKind, TokenKind as Kind};
use assur_text::source::{Edit, Span};
use std::ops::Range;
use unicode_width::UnicodeWidthStr;

/// Blanks for every open brace.
const INDENT: usize = 2;
/// Blanks more where a line goes on with the statement of the line before.
const GOES_ON: usize = 4;

/// A token that is written.
pub(crate) struct Piece {
    pub(crate) token: Token,
    /// The blanks before it.
    pub(crate) before: usize,
    /// The columns that it takes.
    pub(crate) width: usize,
    /// Whether there is something before it in the author's text: blanks, or the end of a line.
    pub(crate) is_apart: bool,
}

pub(crate) struct Line {
    pub(crate) pieces: Range<usize>,
    /// Whether an empty line is before it.
    pub(crate) is_after_empty: bool,
    /// The braces that are open before it.
    pub(crate) depth: usize,
    /// Whether it has one whole statement, member or row, and nothing else but a comment behind it.
    pub(crate) is_whole: bool,
}

/// A text as it will be written.
pub(crate) struct Layout<'t> {
    pub(crate) text: &'t str,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) lines: Vec<Line>,
}

impl<'t> Layout<'t> {
    /// The lines of the author; every line is indented, nothing within a line has blanks.
    pub(crate) fn of(text: &'t str, tokens: &[Token]) -> Self {
        let mut layout = Self { text, pieces: Vec::with_capacity(tokens.len()), lines: Vec::new() };
        let mut open = Open::default();
        let mut newlines = 0;
        for line in tokens.split_inclusive(|t| t.kind == TokenKind::Newline) {
            let kept = layout.add_pieces(line);
            if !kept.is_empty() {
                layout.add_line(kept, newlines > 1, &mut open);
                newlines = 0;
            }
            newlines += 1;
        }
        layout
    }

    /// Adds the tokens of a line without its end; a semicolon before the end goes too.
    fn add_pieces(&mut self, line: &[Token]) -> Range<usize> {
        let first = self.pieces.len();
        let is_end =
            |t: &Token| matches!(t.kind, TokenKind::Newline | TokenKind::Comment | TokenKind::Semicolon);
        let kept = line.iter().rposition(|t| !is_end(t)).map_or_else(
            // a comment by itself could become a part of the problem's text
            || line.iter().position(|t| t.kind == TokenKind::Comment).unwrap_or(0),
            |last| last + 1,
        );
        for (i, &token) in line.iter().enumerate() {
            if i >= kept && token.kind != TokenKind::Comment {
                continue;
            }
            let before = self.pieces.last().map_or(0, |p| p.token.span.end);
            let width = token.text(self.text).width() + usize::from(is_stuck(token, self.text));
            self.pieces.push(Piece { token, before: 0, width, is_apart: before < token.span.start });
        }
        first..self.pieces.len()
    }

    fn add_line(&mut self, pieces: Range<usize>, is_after_empty: bool, open: &mut Open) {
        let goes_on = open.goes_on(self, &pieces);
        if goes_on && let Some(before) = self.lines.last_mut() {
            before.is_whole = false;
        }
        let closed = self.pieces[pieces.clone()].iter().take_while(|p| p.token.kind == TokenKind::BraceEnd);
        let depth = open.braces.saturating_sub(closed.count());
        let indent = INDENT * depth + if goes_on { GOES_ON } else { 0 };
        self.pieces[pieces.start].before = indent;
        let is_body = self.lines.last().is_some_and(|line| self.ends_with_brace(line));
        let is_end = self.pieces[pieces.start].token.kind == TokenKind::BraceEnd;
        let is_first = self.lines.is_empty();
        let is_whole = open.read(self, &pieces) && !goes_on;
        self.lines.push(Line {
            pieces,
            is_after_empty: is_after_empty && !is_body && !is_end && !is_first,
            depth,
            is_whole,
        });
    }

    /// Whether a body begins after a line.
    fn ends_with_brace(&self, line: &Line) -> bool {
        let code = self.pieces[line.pieces.clone()].iter().rev().find(|p| p.token.kind != TokenKind::Comment);
        code.is_some_and(|p| p.token.kind == TokenKind::Brace)
    }

    /// Where a piece of a line is, in columns.
    pub(crate) fn column(&self, line: &Line, piece: usize) -> usize {
        let before = &self.pieces[line.pieces.start..piece];
        before.iter().map(|p| p.before + p.width).sum::<usize>() + self.pieces[piece].before
    }

    /// The place that a line takes, without the blanks before it.
    pub(crate) fn span(&self, line: &Line) -> Span {
        let of = |i: usize| self.pieces[i].token.span;
        of(line.pieces.start).to(of(line.pieces.end - 1))
    }
}

/// Whether a comment has its first letter directly at the slashes.
pub(crate) fn is_stuck(token: Token, text: &str) -> bool {
    let first = || token.text(text).strip_prefix("//").and_then(|words| words.chars().next());
    token.kind == TokenKind::Comment && first().is_some_and(char::is_alphabetic)
}

/// What is open where a line begins.
#[derive(Default)]
struct Open {
    braces: usize,
    brackets: usize,
    /// The last token that is no comment.
    last: Option<Token>,
}

impl Open {
    /// Whether a line goes on with the statement of the line before.
    fn goes_on(&self, layout: &Layout<'_>, pieces: &Range<usize>) -> bool {
        let Some(last) = self.last else { return false };
        let first = layout.pieces[pieces.start].token.kind;
        self.brackets > 0
            || first == TokenKind::Close
            || match last.kind {
                TokenKind::Comma
                | TokenKind::Colon
                | TokenKind::Infix
                | TokenKind::Hyphen
                | TokenKind::Joining
                | TokenKind::Product
                | TokenKind::Power => true,
                // the one word with a list on the next line
                TokenKind::Word => last.text(layout.text) == "find",
                _ => false,
            }
    }

    /// Reads a line; whether all that it opens is closed on it, and it has no second statement.
    fn read(&mut self, layout: &Layout<'_>, pieces: &Range<usize>) -> bool {
        let braces = self.braces;
        let mut is_one = true;
        for piece in &layout.pieces[pieces.clone()] {
            match piece.token.kind {
                TokenKind::Comment => continue,
                TokenKind::Open | TokenKind::Call => self.brackets += 1,
                TokenKind::Close => self.brackets = self.brackets.saturating_sub(1),
                TokenKind::Brace => self.braces += 1,
                TokenKind::BraceEnd => self.braces = self.braces.saturating_sub(1),
                TokenKind::Semicolon => is_one &= self.braces > braces,
                _ => {}
            }
            is_one &= self.braces >= braces;
            self.last = Some(piece.token);
        }
        is_one && self.braces == braces && self.brackets == 0
    }
}

// The least edits from a text to its layout.

/// What of a text is not as it is laid out.
pub(crate) fn changes(layout: &Layout<'_>) -> Vec<Edit> {
    let text = layout.text;
    let newline = if ends_with_return(text) { "\r\n" } else { "\n" };
    let mut edits = Vec::new();
    // a mark of the encoding stays
    let mut from = if text.starts_with('\u{FEFF}') { '\u{FEFF}'.len_utf8() } else { 0 };
    for (number, line) in layout.lines.iter().enumerate() {
        for i in line.pieces.clone() {
            let piece = &layout.pieces[i];
            let at = piece.token.span;
            let newlines = match (i == line.pieces.start, number) {
                (false, _) | (true, 0) => 0,
                (true, _) => 1 + usize::from(line.is_after_empty),
            };
            put(&mut edits, text, Span::new(from, at.start), newline, (newlines, piece.before));
            if is_stuck(piece.token, text) {
                let after = at.start + "//".len();
                edits.push(Edit::new(Span::new(after, after), " "));
            }
            from = at.end;
        }
    }
    if !layout.lines.is_empty() {
        put(&mut edits, text, Span::new(from, text.len()), newline, (1, 0));
    }
    edits
}

/// Whether the first line of a text ends by carriage return and line feed.
fn ends_with_return(text: &str) -> bool {
    text.find('\n').is_some_and(|at| text[..at].ends_with('\r'))
}

/// An edit where there is something else between two tokens than newlines and blanks in the numbers wanted.
fn put(edits: &mut Vec<Edit>, text: &str, at: Span, newline: &str, (newlines, blanks): (usize, usize)) {
    let there = &text.as_bytes()[at.start..at.end];
    let wanted = newlines * newline.len() + blanks;
    let is_so = there.len() == wanted
        && there[..wanted - blanks] == *newline.repeat(newlines).as_bytes()
        && there[wanted - blanks..].iter().all(|&b| b == b' ');
    if !is_so {
        edits.push(Edit::new(at, newline.repeat(newlines) + &" ".repeat(blanks)));
    }
}

// Blanks between two tokens of a line.

/// Blanks before a comment behind something.
const BEFORE_COMMENT: usize = 2;

/// Puts blanks between the tokens of every line.
pub(crate) fn space(layout: &mut Layout<'_>) {
    for line in 0..layout.lines.len() {
        let pieces = layout.lines[line].pieces.clone();
        for i in pieces.clone().skip(1) {
            layout.pieces[i].before = blanks(layout, i, pieces.end);
        }
    }
}

/// Whether a piece follows a unit as a part of it would: `s` in `2 m/s`.
fn is_after_unit(layout: &Layout<'_>, mut i: usize) -> bool {
    let kind = |i: usize| layout.pieces[i].token.kind;
    let joined = |i: usize| !layout.pieces[i].is_apart;
    while i >= 2 && kind(i) == Kind::Word && kind(i - 1) == Kind::Product && joined(i) && joined(i - 1) {
        if kind(i - 2) == Kind::Unit {
            return true;
        }
        i -= 2;
    }
    false
}

/// The blanks before a piece that is not the first of its line, which ends at `end`.
fn blanks(layout: &Layout<'_>, i: usize, end: usize) -> usize {
    let kind = |i: usize| layout.pieces[i].token.kind;
    let is_apart = |i: usize| i < end && kind(i) != Kind::Comment && layout.pieces[i].is_apart;
    match (kind(i - 1), kind(i)) {
        (_, Kind::Comment) => BEFORE_COMMENT,
        (_, Kind::Product) => usize::from(is_apart(i) || is_apart(i + 1)),
        (Kind::Product, _) => usize::from(is_apart(i - 1) || is_apart(i)),
        // `+ -5` is not `+-5`
        (Kind::Prefix, Kind::Prefix) => usize::from(is_apart(i)),
        // `5 m ^ 2` is not `5 m^2`: what follows a unit or a number is not joined to it
        (Kind::Unit, Kind::Power | Kind::Dot) | (Kind::Number, Kind::Dot) => usize::from(is_apart(i)),
        (Kind::Power, _) => usize::from(match kind(i - 2) {
            Kind::Unit => is_apart(i - 1) || is_apart(i),
            // `m/s ^2` has the unit m, and `m/s^2` another
            _ => is_apart(i) && is_after_unit(layout, i - 2),
        }),
        (_, Kind::Comma | Kind::Semicolon | Kind::Colon | Kind::Close | Kind::SquareEnd | Kind::Call)
        | (Kind::Open | Kind::Call | Kind::Square | Kind::Prefix | Kind::Dot | Kind::Hyphen, _)
        | (_, Kind::Power | Kind::Dot | Kind::Hyphen) => 0,
        (Kind::Number, Kind::Unit) => usize::from(!layout.pieces[i].token.text(layout.text).starts_with('°')),
        (Kind::Other, _) | (_, Kind::Other) => usize::from(is_apart(i)),
        _ => 1,
    }
}
