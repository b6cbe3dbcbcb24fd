//! Formulas in plain text.

use crate::lines::Lines;
use crate::node::Node;
use crate::number::raised;

/// A part of a line.
#[must_use]
pub fn text(node: &Node) -> String {
    let mut out = String::new();
    write(node, &mut out);
    out
}

/// An equation: sides below each other start at the same place.
#[must_use]
pub fn text_lines(lines: &Lines) -> String {
    let left = text(&lines.left);
    let indent = " ".repeat(left.chars().count());
    let mut out = left;
    for (i, (row, goes_on)) in lines.rows.iter().enumerate() {
        if i > 0 {
            out += "\n";
            out += &indent;
            if *goes_on {
                out += "   ";
            }
        }
        out += &text(row);
    }
    out
}

/// Parts one after another; a fraction before another factor has brackets.
fn row(parts: &[Node], out: &mut String) {
    for (i, part) in parts.iter().enumerate() {
        let goes_on = matches!(parts.get(i + 1), Some(Node::Times | Node::Dot));
        if goes_on && matches!(part, Node::Fraction(..)) {
            out.push('(');
            write(part, out);
            out.push(')');
        } else {
            write(part, out);
        }
    }
}

fn write(node: &Node, out: &mut String) {
    match node {
        Node::Row(parts) => row(parts, out),
        Node::Letter { letter, sub, sup, arrow, power } => {
            out.push_str(letter);
            if *arrow {
                out.push('\u{20d7}');
            }
            if !sub.is_empty() {
                out.push('_');
                out.push_str(sub);
            }
            if !sup.is_empty() {
                out.push('^');
                out.push_str(sup);
            }
            if *power > 1 {
                out.push_str(&raised(i32::from(*power)));
            }
        }
        Node::Number(figures) => out.push_str(&figures.text()),
        Node::Degrees(figures) => {
            out.push_str(&figures.text());
            out.push('°');
        }
        Node::Pi => out.push('π'),
        Node::Fence("/") if !out.is_empty() => out.push_str(" / "),
        Node::Fence("/") => out.push_str("/ "),
        Node::Fence(sign) => out.push_str(sign),
        Node::Operator(sign) => {
            out.push(' ');
            out.push_str(sign);
            out.push(' ');
        }
        Node::Minus => out.push('−'),
        Node::Times => out.push(' '),
        Node::Dot => out.push('·'),
        Node::Fraction(a, b) => {
            side(a, out);
            out.push_str(" / ");
            side(b, out);
        }
        Node::Power(x, n) => {
            write(x, out);
            out.push_str(&raised(i32::from(*n)));
        }
        Node::Root(x) => {
            out.push_str("√(");
            write(x, out);
            out.push(')');
        }
        Node::Bars(x) => {
            out.push('|');
            write(x, out);
            out.push('|');
        }
        Node::Brackets(x) => {
            out.push('(');
            write(x, out);
            out.push(')');
        }
        Node::Function(name, x) => {
            out.push_str(name);
            if !matches!(**x, Node::Brackets(_)) {
                out.push(' ');
            }
            write(x, out);
        }
        Node::Unit(unit) => {
            out.push(' ');
            out.push_str(unit);
        }
        Node::Words(words) => out.push_str(words),
    }
}

/// A side of a fraction, in brackets where it has operators.
fn side(node: &Node, out: &mut String) {
    if is_compound(node) || matches!(node, Node::Number(figures) | Node::Degrees(figures) if figures.negative)
    {
        out.push('(');
        write(node, out);
        out.push(')');
    } else {
        write(node, out);
    }
}

fn is_compound(node: &Node) -> bool {
    match node {
        Node::Row(parts) => parts.len() > 1 || parts.iter().any(is_compound),
        Node::Fraction(..) => true,
        _ => false,
    }
}
