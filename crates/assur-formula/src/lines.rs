//! Equations over several lines: broken at "=", then at + and −.

use crate::expr::Expr;
use crate::lay::{letters, name_node};
use crate::node::Node;
use crate::quantity::Name;

/// An equation as lines: what is found, then the lines of its sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    pub left: Node,
    /// Lines, each a side or a part of one. The second says that a line goes on with a side.
    pub rows: Vec<(Node, bool)>,
}

/// The widest line, in figures.
const WIDEST: f64 = 76.0;
/// How far a line is indented that goes on with a side.
const INDENT: f64 = 3.0;
/// The room for brackets that end with a line.
const CLOSING: f64 = 2.5;

impl Lines {
    /// Which part of its size it may keep on paper, so that a side that cannot be broken is not wider than a line.
    #[must_use]
    pub fn fit(&self) -> f64 {
        let width = |(row, goes_on): &(Node, bool)| row.width() + if *goes_on { INDENT } else { 0.0 };
        let widest = self.rows.iter().map(width).fold(0.0, f64::max) + self.left.width();
        (WIDEST / widest.max(WIDEST)).max(0.5)
    }

    /// With decimals behind a comma.
    #[must_use]
    pub fn with_commas(self) -> Self {
        let rows = self.rows.into_iter().map(|(row, goes_on)| (row.with_commas(), goes_on)).collect();
        Self { left: self.left.with_commas(), rows }
    }

    /// A sum that is zero, in letters alone.
    #[must_use]
    pub fn zero(name: &Name, sum: &Expr) -> Self {
        let side = |of: &Expr| Node::Row(vec![Node::Operator("="), letters(of)]);
        Self::broken(name_node(name), vec![side(sum), side(&Expr::ZERO)])
    }

    /// One line where it fits, else one per side, else broken before + and −.
    pub(crate) fn broken(left: Node, sides: Vec<Node>) -> Self {
        let whole: f64 = left.width() + sides.iter().map(Node::width).sum::<f64>();
        if whole <= WIDEST {
            return Self { left, rows: vec![(Node::Row(sides), false)] };
        }
        let room = WIDEST - left.width();
        let mut rows: Vec<(Node, bool)> = Vec::new();
        let (mut line, mut taken) = (Vec::new(), 0.0);
        for side in sides {
            let width = side.width();
            if taken > 0.0 && taken + width > room {
                rows.push((Node::Row(std::mem::take(&mut line)), false));
                taken = 0.0;
            }
            if width > room {
                rows.extend(parts(side, room));
                // a short side may go on behind the last part
                continue;
            }
            line.push(side);
            taken += width;
        }
        if !line.is_empty() {
            rows.push((Node::Row(line), false));
        }
        Self { left, rows }
    }
}

/// A side broken before + and −; a part that is too wide for a line opens its brackets and its fractions, and breaks before its points.
fn parts(side: Node, room: f64) -> Vec<(Node, bool)> {
    let mut row = Vec::new();
    open(side, room - INDENT - CLOSING, false, &mut row);
    let (mut rows, mut line, mut taken) = (Vec::new(), Vec::new(), 0.0);
    for piece in pieces(row) {
        let width: f64 = piece.iter().map(Node::width).sum();
        if taken + width > room && !line.is_empty() {
            rows.push((Node::Row(std::mem::take(&mut line)), !rows.is_empty()));
            taken = INDENT;
        }
        taken += width;
        line.extend(piece);
    }
    rows.push((Node::Row(line), !rows.is_empty()));
    rows
}

/// What stays on one line: from a place where a line may break up to the next one.
fn pieces(row: Vec<Node>) -> Vec<Vec<Node>> {
    let mut pieces: Vec<Vec<Node>> = Vec::new();
    let mut row = row.into_iter().peekable();
    while let Some(node) = row.next() {
        let before_sum = matches!(row.peek(), Some(Node::Brackets(_) | Node::Fence("(")));
        let breaks = match node {
            Node::Operator("+" | "−") | Node::Dot | Node::Fence("/") => true,
            Node::Times => before_sum,
            _ => false,
        };
        match pieces.last_mut() {
            Some(piece) if !breaks => piece.push(node),
            _ => pieces.push(vec![node]),
        }
    }
    // the sign that a side begins with does not stay alone
    if pieces.len() > 1 && matches!(pieces[0].as_slice(), [Node::Operator(_) | Node::Minus]) {
        let second = pieces.remove(1);
        pieces[0].extend(second);
    }
    pieces
}

/// A part, and of what is wider than a line its parts; `goes_on` where a factor follows.
fn open(node: Node, room: f64, goes_on: bool, out: &mut Vec<Node>) {
    match node {
        Node::Row(parts) => {
            let factor: Vec<bool> =
                (1..=parts.len()).map(|i| matches!(parts.get(i), Some(Node::Times | Node::Dot))).collect();
            let begins = out.is_empty();
            for (i, part) in parts.into_iter().enumerate() {
                // the sides of an equation are one row
                let inner = matches!(part, Node::Row(_)) && !(begins && i == 1);
                if inner && part.width() <= room { out.push(part) } else { open(part, room, factor[i], out) }
            }
        }
        Node::Brackets(inner) if inner.width() > room => within("(", *inner, ")", room, out),
        Node::Fraction(above, below) if above.width().max(below.width()) > room => {
            if goes_on {
                out.push(Node::Fence("("));
            }
            within("(", *above, ")", room, out);
            out.push(Node::Fence("/"));
            match *below {
                Node::Row(parts) if parts.len() > 1 => {
                    let whole = Node::Brackets(Box::new(Node::Row(parts)));
                    open(whole, room, false, out);
                }
                one => open(one, room, false, out),
            }
            if goes_on {
                out.push(Node::Fence(")"));
            }
        }
        other => out.push(other),
    }
}

fn within(begin: &'static str, inner: Node, end: &'static str, room: f64, out: &mut Vec<Node>) {
    if inner.width() <= room {
        // what is one factor needs no brackets
        let is_one = !matches!(inner, Node::Row(_) | Node::Fraction(..));
        out.push(if is_one { inner } else { Node::Brackets(Box::new(inner)) });
        return;
    }
    out.push(Node::Fence(begin));
    open(inner, room, false, out);
    out.push(Node::Fence(end));
}
