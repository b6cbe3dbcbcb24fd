//! What stands below each other in neighbouring lines of one kind.

use crate::layout::{Layout, Line};
use crate::rows;
use assur_syntax::TokenKind;
use assur_syntax::document::{Document, Statement};
use assur_text::source::Spanned;
use std::mem::{Discriminant, discriminant};
use std::ops::Range;

/// What the lines of a run have in common.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// The kind of statement.
    Statement(Discriminant<Statement>),
    /// A part of a body, below so many braces.
    Member(usize),
}

/// What a line is to a run.
struct InRun {
    kind: Kind,
    /// The piece that stands in the column of its kind.
    piece: Option<usize>,
}

/// Puts what belongs below each other there.
pub(crate) fn align(layout: &mut Layout<'_>, document: &Document) {
    let lines = lines(layout, &document.statements);
    let runs = runs(layout, &lines);
    for run in &runs {
        let pieces = run.clone().filter_map(|line| Some((line, lines[line].as_ref()?.piece?)));
        below_each_other(layout, &pieces.collect::<Vec<_>>());
    }
    rows::align(layout, &document.statements);
    for run in &runs {
        let comments = run.clone().filter_map(|line| Some((line, comment(layout, &layout.lines[line])?)));
        below_each_other(layout, &comments.collect::<Vec<_>>());
    }
}

/// What each line is to a run; nothing where it has more or less than one statement or member.
fn lines(layout: &Layout<'_>, statements: &[Spanned<Statement>]) -> Vec<Option<InRun>> {
    let mut rest = statements;
    let mut in_run = |line: &Line| {
        let start = layout.span(line).start;
        let before = rest.iter().take_while(|s| s.span.start < start).count();
        rest = &rest[before..];
        if !line.is_whole || layout.pieces[line.pieces.start].token.kind == TokenKind::Comment {
            return None;
        }
        match rest.first().filter(|s| s.span.start == start) {
            Some(statement) => {
                let piece = column(&statement.node).and_then(|from| piece_from(layout, line, from));
                Some(InRun { kind: Kind::Statement(discriminant(&statement.node)), piece })
            }
            None => Some(InRun { kind: Kind::Member(line.depth), piece: None }),
        }
    };
    layout.lines.iter().map(&mut in_run).collect()
}

/// The place from which on a statement stands in a column.
fn column(statement: &Statement) -> Option<usize> {
    Some(match statement {
        Statement::Joint(joint) => joint.name.span.start,
        Statement::Link(link) => link.name.span.end,
        Statement::Shaft(shaft) => shaft.name.span.end,
        Statement::Given(definition) | Statement::Let(definition) => definition.name.span.end,
        _ => return None,
    })
}

/// The first piece of a line that is not before a place.
fn piece_from(layout: &Layout<'_>, line: &Line, from: usize) -> Option<usize> {
    let piece = line.pieces.clone().find(|&i| layout.pieces[i].token.span.start >= from)?;
    (layout.pieces[piece].token.kind != TokenKind::Comment).then_some(piece)
}

/// The comment behind a line.
fn comment(layout: &Layout<'_>, line: &Line) -> Option<usize> {
    let last = line.pieces.end - 1;
    (layout.pieces[last].token.kind == TokenKind::Comment).then_some(last)
}

/// Neighbouring lines of one kind.
fn runs(layout: &Layout<'_>, lines: &[Option<InRun>]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let Some(line) = line else { continue };
        match runs.last_mut() {
            Some(run)
                if run.end == i
                    && !layout.lines[i].is_after_empty
                    && lines[run.start].as_ref().is_some_and(|first| first.kind == line.kind) =>
            {
                run.end = i + 1;
            }
            _ => runs.push(i..i + 1),
        }
    }
    runs
}

/// Moves pieces, each of a line of its own, to the column of the one furthest to the right.
fn below_each_other(layout: &mut Layout<'_>, pieces: &[(usize, usize)]) {
    let columns = pieces.iter().map(|&(line, piece)| layout.column(&layout.lines[line], piece));
    let columns = columns.collect::<Vec<_>>();
    let furthest = columns.iter().copied().max().unwrap_or(0);
    for (&(_, piece), column) in pieces.iter().zip(columns) {
        layout.pieces[piece].before += furthest - column;
    }
}
