//! Formulas in MathML Core.

use super::is_single;
use crate::lines::Lines;
use crate::node::Node;
use crate::number::Figures;

/// A part of a line, in a line of text.
#[must_use]
pub fn mathml(node: &Node) -> String {
    let mut out = "<math>".to_owned();
    row(node, &mut out);
    out + "</math>"
}

/// An equation: a formula for each side, so that a narrow screen may break before one; several lines stand in a grid of two
/// columns, `rows`, of which `on` goes on with a side.
#[must_use]
pub fn mathml_lines(lines: &Lines) -> String {
    let mut out = String::new();
    if let [(only, _)] = lines.rows.as_slice() {
        sides(Some(&lines.left), only, &mut out);
        return out;
    }
    out += "<div class=\"rows\">";
    for (i, (line, goes_on)) in lines.rows.iter().enumerate() {
        out += "<span>";
        if i == 0 {
            sides(None, &lines.left, &mut out);
        }
        out += if *goes_on { "</span><span class=\"on\">" } else { "</span><span>" };
        sides(None, line, &mut out);
        out += "</span>";
    }
    out + "</div>"
}

/// A line as formulas that begin with its sides.
fn sides(left: Option<&Node>, line: &Node, out: &mut String) {
    let sides = match line {
        Node::Row(sides) if sides.iter().all(is_side) => sides.as_slice(),
        whole => std::slice::from_ref(whole),
    };
    for (i, side) in sides.iter().enumerate() {
        *out += if i > 0 { "<wbr/>" } else { "" };
        *out += "<math displaystyle=\"true\"><mrow>";
        if let Some(left) = left.filter(|_| i == 0) {
            write(left, out);
        }
        write(side, out);
        *out += "</mrow></math>";
    }
}

/// What begins with a sign of equality.
fn is_side(node: &Node) -> bool {
    matches!(node, Node::Row(parts) if matches!(parts.first(), Some(Node::Operator("=" | "≈"))))
}

fn row(node: &Node, out: &mut String) {
    *out += "<mrow>";
    write(node, out);
    *out += "</mrow>";
}

/// The space before and after the name of a function.
const THIN: &str = "<mspace width=\"0.17em\"/>";

fn write(node: &Node, out: &mut String) {
    match node {
        Node::Row(parts) => {
            for (i, part) in parts.iter().enumerate() {
                let is_function = |at: Option<usize>| {
                    at.and_then(|at| parts.get(at)).is_some_and(|part| matches!(part, Node::Function(..)))
                };
                write(part, out);
                if matches!(part, Node::Times) && (is_function(i.checked_sub(1)) || is_function(Some(i + 1)))
                {
                    *out += THIN;
                }
            }
        }
        Node::Letter { letter, sub, sup, arrow, power } => {
            let number = power.to_string();
            letters(letter, sub, if *power > 1 { &number } else { sup }, *arrow, out);
        }
        Node::Number(figures) => number(figures, out),
        Node::Degrees(figures) => {
            *out += "<mrow>";
            number(figures, out);
            *out += "<mo>°</mo></mrow>";
        }
        Node::Pi => *out += "<mi mathvariant=\"normal\">π</mi>",
        Node::Operator(sign) => *out += &format!("<mo>{sign}</mo>"),
        Node::Minus => *out += "<mo form=\"prefix\">−</mo>",
        Node::Times => *out += "<mo>\u{2062}</mo>",
        Node::Dot => *out += "<mo>·</mo>",
        Node::Fence(sign) => *out += &format!("<mo stretchy=\"false\">{sign}</mo>"),
        Node::Fraction(a, b) => {
            *out += "<mfrac>";
            row(a, out);
            row(b, out);
            *out += "</mfrac>";
        }
        Node::Power(x, n) => {
            *out += "<msup>";
            row(x, out);
            *out += &format!("<mn>{n}</mn></msup>");
        }
        Node::Root(x) => {
            *out += "<msqrt>";
            row(x, out);
            *out += "</msqrt>";
        }
        Node::Bars(x) => fenced('|', x, '|', out),
        Node::Brackets(x) => fenced('(', x, ')', out),
        Node::Function(name, x) => {
            *out += &format!("<mrow><mi mathvariant=\"normal\">{name}</mi><mo>\u{2061}</mo>");
            if !matches!(**x, Node::Brackets(_)) {
                *out += THIN;
            }
            row(x, out);
            *out += "</mrow>";
        }
        Node::Unit(unit) => *out += &format!("<mtext>\u{a0}{unit}</mtext>"),
        Node::Words(words) => *out += &format!("<mtext>{}</mtext>", escaped(words)),
    }
}

/// What is between signs that are as tall as it; the page stretches them, whatever fonts there are.
fn fenced(open: char, x: &Node, close: char, out: &mut String) {
    let tall = 1.9 * x.reach().into_iter().fold(0.0, f64::max);
    let own = if tall > 1.3 { format!(" class=\"tall\" style=\"--tall:{tall:.1}\"") } else { String::new() };
    *out += &format!("<mrow><mo{own}>{open}</mo>");
    row(x, out);
    *out += &format!("<mo{own}>{close}</mo></mrow>");
}

fn number(figures: &Figures, out: &mut String) {
    if figures.negative {
        *out += "<mo form=\"prefix\">−</mo>";
    }
    *out += &format!("<mn>{}</mn>", figures.digits);
    if figures.exponent != 0 {
        let sign = if figures.exponent < 0 { "<mo form=\"prefix\">−</mo>" } else { "" };
        let power = figures.exponent.abs();
        *out += &format!("<mo>·</mo><msup><mn>10</mn><mrow>{sign}<mn>{power}</mn></mrow></msup>");
    }
}

fn letters(letter: &str, sub: &str, sup: &str, arrow: bool, out: &mut String) {
    let tag = match (sub.is_empty(), sup.is_empty()) {
        (true, true) => "",
        (false, true) => "msub",
        (true, false) => "msup",
        (false, false) => "msubsup",
    };
    if !tag.is_empty() {
        *out += &format!("<{tag}>");
    }
    if arrow {
        *out += "<mover>";
    }
    let slanted = match letter.starts_with(|c: char| c.is_ascii_digit() || c == '−') {
        // a number with its unit
        true => " mathvariant=\"normal\"",
        false if is_single(letter) => "",
        false => " mathvariant=\"italic\"",
    };
    *out += &format!("<mi{slanted}>{}</mi>", escaped(letter));
    if arrow {
        *out += "<mo stretchy=\"false\">→</mo></mover>";
    }
    if !sub.is_empty() {
        *out += &index(sub);
    }
    if sup.parse::<u8>().is_ok() {
        *out += &format!("<mn>{sup}</mn>");
    } else if !sup.is_empty() {
        *out += &index(sup);
    }
    if !tag.is_empty() {
        *out += &format!("</{tag}>");
    }
}

/// An index: upright letters and figures.
fn index(text: &str) -> String {
    if text.chars().all(|c| c.is_ascii_digit()) {
        format!("<mn>{text}</mn>")
    } else {
        format!("<mi mathvariant=\"normal\">{}</mi>", escaped(text))
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
