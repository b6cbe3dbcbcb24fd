//! Blanks between two tokens of a line.

use crate::layout::Layout;
use assur_syntax::TokenKind as Kind;

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
