//! A comma within a number of a table.

use assur_syntax::document::{Cell, Row};
use assur_text::diagnostic::Help;
use assur_text::source::Spanned;

/// The row with a decimal point for a comma between digits, where one too many is written so: `313,7`.
pub(crate) fn decimal_comma(columns: usize, row: &Row) -> Option<Help> {
    let next = |pair: &[Spanned<Cell>]| match pair {
        [a, b] => {
            let digits =
                |cell: &Cell| !cell.text().is_empty() && cell.text().bytes().all(|c| c.is_ascii_digit());
            digits(&a.node) && digits(&b.node) && b.span.start == a.span.end + 1
        }
        _ => false,
    };
    let places =
        row.cells.windows(2).enumerate().filter(|(_, pair)| next(pair)).map(|(i, _)| i).collect::<Vec<_>>();
    let [at] = places[..] else { return None };
    if row.cells.len() != columns + 1 {
        return None;
    }
    let (whole, part) = (row.cells[at].node.text(), row.cells[at + 1].node.text());
    let span = row.cells[at].span.to(row.cells[at + 1].span);
    Some(Help::write(span, &[format!("{whole}.{part}")]))
}
