//! Equations over several lines: broken at "=", then at + and −.

use crate::node::Node;

/// An equation as lines: what is found, then the lines of its sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    pub left: Node,
    /// Lines, each a side or a part of one. The second says that a line goes on with a side.
    pub rows: Vec<(Node, bool)>,
}

/// The widest line, in figures.
const WIDEST: f64 = 76.0;

impl Lines {
    /// Which part of its size it may keep on paper, so that a side that cannot be broken is not wider than a line.
    #[must_use]
    pub fn fit(&self) -> f64 {
        const GOES_ON: f64 = 3.0;
        let width = |(row, goes_on): &(Node, bool)| row.width() + if *goes_on { GOES_ON } else { 0.0 };
        let widest = self.rows.iter().map(width).fold(0.0, f64::max) + self.left.width();
        (WIDEST / widest.max(WIDEST)).max(0.5)
    }

    /// With decimals behind a comma.
    #[must_use]
    pub fn with_commas(self) -> Self {
        let rows = self.rows.into_iter().map(|(row, goes_on)| (row.with_commas(), goes_on)).collect();
        Self { left: self.left.with_commas(), rows }
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

/// A side broken before + and −.
fn parts(side: Node, room: f64) -> Vec<(Node, bool)> {
    let Node::Row(mut row) = side else { return vec![(side, false)] };
    if let [_, Node::Row(_)] = row.as_slice()
        && let Some(Node::Row(inner)) = row.pop()
    {
        row.extend(inner);
    }
    let (mut rows, mut line, mut taken) = (Vec::new(), Vec::new(), 0.0);
    let mut pending = row.into_iter().peekable();
    while let Some(node) = pending.next() {
        let breaks = matches!(node, Node::Operator("+" | "−"));
        let ahead = node.width() + if breaks { pending.peek().map_or(0.0, Node::width) } else { 0.0 };
        if breaks && taken + ahead > room && !line.is_empty() {
            rows.push((Node::Row(std::mem::take(&mut line)), !rows.is_empty()));
            taken = 0.0;
        }
        taken += node.width();
        line.push(node);
    }
    rows.push((Node::Row(line), !rows.is_empty()));
    rows
}
