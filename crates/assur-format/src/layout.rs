//! Lines of tokens, with the blanks before each.

use assur_syntax::{Token, TokenKind};
use assur_text::source::Span;
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
