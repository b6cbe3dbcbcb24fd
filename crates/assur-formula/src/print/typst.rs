//! Formulas in Typst.

use super::is_single;
use crate::lines::Lines;
use crate::node::Node;
use crate::number::Figures;

/// A part of a line, without its `$`.
#[must_use]
pub fn typst(node: &Node) -> String {
    let mut out = String::new();
    write(node, &mut out);
    out
}

/// An equation, without its `$`.
#[must_use]
pub fn typst_lines(lines: &Lines) -> String {
    let mut out = typst(&lines.left);
    for (i, (row, goes_on)) in lines.rows.iter().enumerate() {
        out += if i > 0 { " \\\n  & " } else { " & " };
        if *goes_on {
            out += "quad ";
        }
        out += &typst(row);
    }
    out
}

fn write(node: &Node, out: &mut String) {
    match node {
        Node::Row(parts) => parts.iter().for_each(|part| write(part, out)),
        Node::Letter { letter, sub, sup, arrow, power } => {
            let base = if is_single(letter) {
                format!("{letter} ")
            } else {
                format!("italic(\"{}\") ", plain(letter))
            };
            *out += &if *arrow { format!("arrow({}) ", base.trim_end()) } else { base };
            if !sub.is_empty() {
                *out = out.trim_end().to_owned() + &format!("_\"{}\" ", plain(sub));
            }
            match (sup.as_str(), power) {
                ("", 1) => {}
                ("", n) => *out = out.trim_end().to_owned() + &format!("^{n} "),
                (sup, _) => *out = out.trim_end().to_owned() + &format!("^\"{}\" ", plain(sup)),
            }
        }
        Node::Number(figures) => number(figures, out),
        Node::Degrees(figures) => {
            number(figures, out);
            *out = out.trim_end().to_owned() + " degree ";
        }
        Node::Pi => *out += "pi ",
        // not as a pair that grows
        Node::Fence(sign) => *out += &format!("\\{sign} "),
        Node::Operator(sign) => {
            *out += match *sign {
                "−" => "- ",
                "≈" => "approx ",
                "+" => "+ ",
                _ => "= ",
            };
        }
        Node::Minus => *out += "-",
        Node::Times => *out += "thin ",
        Node::Dot => *out += "dot ",
        Node::Fraction(a, b) => *out += &format!("frac({}, {}) ", typst(a).trim_end(), typst(b).trim_end()),
        Node::Power(x, n) => *out += &format!("{}^{n} ", typst(x).trim_end()),
        Node::Root(x) => *out += &format!("sqrt({}) ", typst(x).trim_end()),
        Node::Bars(x) => *out += &format!("abs({}) ", typst(x).trim_end()),
        Node::Brackets(x) => *out += &format!("({}) ", typst(x).trim_end()),
        Node::Function(name, x) => *out += &format!("{name} {}", typst(x)),
        Node::Unit(unit) => *out += &format!("thin upright(\"{unit}\") "),
        Node::Words(words) => *out += &format!("\"{}\" ", plain(words)),
    }
}

fn number(figures: &Figures, out: &mut String) {
    if figures.negative {
        out.push('-');
    }
    if figures.digits.contains(',') {
        // a comma would end an argument
        *out += &format!("\"{}\"", figures.digits);
    } else {
        *out += &figures.digits;
    }
    out.push(' ');
    if figures.exponent != 0 {
        *out += &format!("dot 10^({}) ", figures.exponent);
    }
}

fn plain(text: &str) -> String {
    text.replace('\\', "").replace('"', "'")
}
