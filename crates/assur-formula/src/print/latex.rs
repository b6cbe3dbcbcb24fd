//! Formulas in LaTeX.

use super::is_single;
use crate::lines::Lines;
use crate::node::Node;
use crate::number::Figures;

/// A part of a line.
#[must_use]
pub fn latex(node: &Node) -> String {
    let mut out = String::new();
    write(node, &mut out);
    out
}

#[must_use]
pub fn latex_lines(lines: &Lines) -> String {
    if let [(row, _)] = lines.rows.as_slice() {
        return latex(&lines.left) + &latex(row);
    }
    let mut out = format!("\\begin{{aligned}} {}", latex(&lines.left));
    for (i, (row, goes_on)) in lines.rows.iter().enumerate() {
        out += if i > 0 { " \\\\ &" } else { " &" };
        if *goes_on {
            out += "\\qquad ";
        }
        out += &latex(row);
    }
    out + " \\end{aligned}"
}

fn write(node: &Node, out: &mut String) {
    match node {
        Node::Row(parts) => parts.iter().for_each(|part| write(part, out)),
        Node::Letter { letter, sub, sup, arrow, power } => {
            // a prime is a raised sign already
            let braced = letter.contains(['′', '″']) && (*power > 1 || !sup.is_empty());
            let base = if braced { format!("{{{}}}", letters(letter)) } else { letters(letter) };
            *out += &if *arrow { format!("\\vec{{{base}}}") } else { base };
            if !sub.is_empty() {
                *out += &format!("_{{\\mathrm{{{}}}}}", plain(sub));
            }
            match (sup.as_str(), power) {
                ("", 1) => {}
                ("", n) => *out += &format!("^{{{n}}}"),
                (sup, _) => *out += &format!("^{{\\mathrm{{{}}}}}", plain(sup)),
            }
        }
        Node::Number(figures) => number(figures, out),
        Node::Degrees(figures) => {
            number(figures, out);
            *out += "^{\\circ}";
        }
        Node::Pi => *out += "\\pi ",
        Node::Fence(sign) => *out += sign,
        Node::Operator(sign) => {
            *out += match *sign {
                "−" => " - ",
                "≈" => " \\approx ",
                "+" => " + ",
                _ => " = ",
            };
        }
        Node::Minus => *out += "-",
        Node::Times => *out += "\\,",
        Node::Dot => *out += " \\cdot ",
        Node::Fraction(a, b) => *out += &format!("\\frac{{{}}}{{{}}}", latex(a), latex(b)),
        Node::Power(x, n) => *out += &format!("{{{}}}^{{{n}}}", latex(x)),
        Node::Root(x) => *out += &format!("\\sqrt{{{}}}", latex(x)),
        Node::Bars(x) => *out += &format!("\\left|{}\\right|", latex(x)),
        Node::Brackets(x) => *out += &format!("\\left({}\\right)", latex(x)),
        Node::Function(name, x) => *out += &format!("\\{name} {}", latex(x)),
        Node::Unit(unit) => *out += &format!("\\,{}", unit_latex(unit)),
        Node::Words(words) => *out += &format!("\\text{{{}}}", plain(words)),
    }
}

fn number(figures: &Figures, out: &mut String) {
    if figures.negative {
        out.push('-');
    }
    // a comma between figures takes no room after it
    *out += &figures.digits.replace(',', "{,}");
    if figures.exponent != 0 {
        // in braces of its own: a degree sign may follow
        *out += &format!(" \\cdot {{10^{{{}}}}}", figures.exponent);
    }
}

#[must_use]
pub fn unit_latex(unit: &str) -> String {
    let body = unit.replace('·', "\\cdot ").replace('²', "^2").replace('³', "^3").replace('°', "^{\\circ}");
    // letters outside of Latin are no letters of formulas
    if unit.chars().any(|c| c.is_alphabetic() && !c.is_ascii()) {
        return format!("\\text{{{unit}}}");
    }
    format!("\\mathrm{{{body}}}")
}

fn letters(letter: &str) -> String {
    let greek = |c: char| {
        Some(match c {
            'α' => "\\alpha ",
            'β' => "\\beta ",
            'γ' => "\\gamma ",
            'δ' => "\\delta ",
            'ε' => "\\varepsilon ",
            'η' => "\\eta ",
            'ξ' => "\\xi ",
            'θ' => "\\theta ",
            'λ' => "\\lambda ",
            'μ' => "\\mu ",
            'ρ' => "\\rho ",
            'φ' => "\\varphi ",
            'ψ' => "\\psi ",
            'ω' => "\\omega ",
            'Σ' => "\\Sigma ",
            'Δ' => "\\Delta ",
            'τ' => "\\tau ",
            'Φ' => "\\Phi ",
            '′' => "'",
            '″' => "''",
            _ => return None,
        })
    };
    let body: String =
        letter.chars().map(|c| greek(c).map_or_else(|| plain(&c.to_string()), str::to_owned)).collect();
    if is_single(letter) || letter.chars().any(|c| greek(c).is_some()) {
        body.trim_end().to_owned()
    } else {
        format!("\\mathit{{{body}}}")
    }
}

/// Text with the signs escaped that mean something.
fn plain(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '_' | '#' | '$' | '%' | '&' | '{' | '}' => {
                out.push('\\');
                out.push(c);
            }
            '\\' | '^' | '~' => out.push(' '),
            '′' => out.push('\''),
            c => out.push(c),
        }
    }
    out
}
