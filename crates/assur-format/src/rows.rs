//! Tables within a file: numbers end below each other, names begin so.

use crate::layout::{Layout, Line};
use assur_syntax::document::{Cell, Row, Statement};
use assur_text::source::Spanned;
use std::ops::Range;

/// A row on a line of its own.
struct RowLine {
    line: usize,
    cells: Vec<CellPieces>,
}

struct CellPieces {
    pieces: Range<usize>,
    is_name: bool,
    width: usize,
}

/// Puts the cells of neighbouring rows below each other.
pub(crate) fn align(layout: &mut Layout<'_>, statements: &[Spanned<Statement>]) {
    let tables = statements.iter().filter_map(|s| match &s.node {
        Statement::Variants(table) => Some(&table.rows),
        Statement::Curve(curve) => Some(&curve.table.rows),
        _ => None,
    });
    for rows in tables {
        let found = rows.iter().filter_map(|row| row_line(layout, row)).collect::<Vec<_>>();
        let neighbours =
            |a: &RowLine, b: &RowLine| b.line == a.line + 1 && !layout.lines[b.line].is_after_empty;
        let runs = found.chunk_by(neighbours).collect::<Vec<_>>();
        for run in runs {
            let wanted = blanks(run);
            for (piece, before) in wanted {
                layout.pieces[piece].before += before;
            }
        }
    }
}

/// Where a row stands, if it has a line for itself.
fn row_line(layout: &Layout<'_>, row: &Row) -> Option<RowLine> {
    let starts = |line: &Line| layout.span(line).start;
    let line = layout.lines.binary_search_by_key(&row.span.start, starts).ok()?;
    if !layout.lines[line].is_whole {
        return None;
    }
    let mut piece = layout.lines[line].pieces.start;
    let end = layout.lines[line].pieces.end;
    let mut cells = Vec::with_capacity(row.cells.len());
    for cell in &row.cells {
        let at = |i: &usize| layout.pieces[*i].token.span;
        let first = (piece..end).find(|i| at(i).start >= cell.span.start)?;
        let last = (first..end).take_while(|i| at(i).end <= cell.span.end).last()?;
        let pieces = first..last + 1;
        let width = pieces.clone().map(|i| layout.pieces[i].width).sum::<usize>();
        let within = pieces.clone().skip(1).map(|i| layout.pieces[i].before).sum::<usize>();
        cells.push(CellPieces { pieces, is_name: matches!(cell.node, Cell::Name(_)), width: width + within });
        piece = last + 1;
    }
    Some(RowLine { line, cells })
}

/// The blanks to be added before pieces.
fn blanks(rows: &[RowLine]) -> Vec<(usize, usize)> {
    let columns = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
    let mut widths = vec![0; columns];
    for row in rows {
        for (width, cell) in widths.iter_mut().zip(&row.cells) {
            *width = cell.width.max(*width);
        }
    }
    let mut found = Vec::new();
    for row in rows {
        let mut owed = 0;
        for (cell, width) in row.cells.iter().zip(&widths) {
            let missing = width - cell.width;
            found.push((cell.pieces.start, if cell.is_name { owed } else { owed + missing }));
            owed = if cell.is_name { missing } else { 0 };
        }
    }
    found
}
