//! Drawings as TikZ: one picture in millimetres, y up, a style per style of ours, labels as maths, no letter outside ASCII.

use crate::drawing::Sheet;
use crate::label::{Palette, Role, Theme};
use crate::lettering::Lettering;
use crate::mark::{Mark, Shape, on_circle};
use crate::rules::{Ends, ends};
use crate::style::{STYLES, Style};
use crate::tex::{LETTER, letters};
use assur_math::math::Vec2;
use std::f64::consts::{PI, TAU};
use std::fmt::{Display, Formatter, Result, Write};

/// The longest part of an arc that is one curve, and the largest circle of four curves: both are off by less than 0.01 mm.
const PART: f64 = PI / 4.0;
const LARGEST: f64 = 20.0;
/// Letters from this size on are the size of the document's text, mm.
const USUAL: f64 = 3.75;
/// Points on a line of the file.
const POINTS: usize = 8;
/// All colours, with their names.
const COLOURS: [(Role, &str); 9] = [
    (Role::Ink, "Ink"),
    (Role::Paper, "Paper"),
    (Role::Grey, "Grey"),
    (Role::Blue, "Blue"),
    (Role::Vermilion, "Vermilion"),
    (Role::Green, "Green"),
    (Role::Tint, "Tint"),
    (Role::BlueTint, "BlueTint"),
    (Role::VermilionTint, "VermilionTint"),
];

impl Sheet {
    /// The sheet as a picture to be read by a document with `\usepackage{tikz}`.
    #[must_use]
    pub fn tikz(&self, theme: Theme) -> String {
        let mut body = String::new();
        let labels = self.labels();
        let (least, greatest) = (Point(self.bounds.min), Point(self.bounds.max));
        let _ = writeln!(body, "\\useasboundingbox {least} rectangle {greatest};");
        if theme == Theme::Dark {
            let _ = writeln!(body, "\\fill[assurPaper] {least} rectangle {greatest};");
        }
        let mut group = 0;
        for mark in self.marks() {
            if mark.group != group {
                group = mark.group;
                let of = &self.drawing.groups[group];
                let _ = writeln!(body, "% {} {}", of.class, escaped(&of.name));
            }
            drawn(&mut body, mark);
        }
        for label in &labels {
            label.marks.iter().for_each(|mark| drawn(&mut body, mark));
            lettered(&mut body, label);
        }
        let mut out = format!("% {}\n", escaped(&self.drawing.title));
        out.push_str(if body.contains("\\assurletter") { LETTER } else { "" });
        out.push_str("\\begin{tikzpicture}[x=1mm, y=1mm,\n");
        let own = labels.iter().flat_map(|label| &label.marks);
        styles(&mut out, &self.marks().iter().chain(own).collect::<Vec<_>>());
        colours(&mut out, theme);
        out + &body + "\\end{tikzpicture}%\n"
    }

    /// The same as a whole document, as large as the sheet.
    #[must_use]
    pub fn tex(&self, theme: Theme) -> String {
        let size = self.bounds.size();
        format!(
            "\\documentclass{{article}}\n\\usepackage[paperwidth={}mm, paperheight={}mm, margin=0mm]{{geometry}}\n\
             \\usepackage{{tikz}}\n\\pagestyle{{empty}}\n\\begin{{document}}\n\\noindent\\vbox to\\textheight{{\\hbox to\\textwidth{{%\n{}\
             \\hss}}\\vss}}\n\\end{{document}}\n",
            Decimal(size.x),
            Decimal(size.y),
            self.tikz(theme)
        )
    }
}

/// `link`, `velocity part`
fn name(style: Style) -> String {
    let mut name = String::from("assur");
    for c in format!("{style:?}").chars() {
        name.push_str(if c.is_uppercase() || c.is_ascii_digit() { " " } else { "" });
        name.push(c.to_ascii_lowercase());
    }
    name
}

/// What the styles of some marks come to; behind them a paper has the last word.
fn styles(out: &mut String, marks: &[&Mark]) {
    for style in STYLES {
        let mut own = marks.iter().filter(|mark| mark.style == style).peekable();
        if own.peek().is_none() {
            continue;
        }
        let paint = style.paint();
        let mut keys = Vec::new();
        if let Some((role, width)) = paint.stroke {
            keys.push(format!("draw={}, line width={}mm", colour(role), Decimal(width)));
        }
        keys.extend(paint.fill.map(|role| format!("fill={}", colour(role))));
        let dashes: Vec<&str> = paint.dashes.split_whitespace().collect();
        let dash =
            |(i, length): (usize, &&str)| format!("{} {length}mm", if i % 2 == 0 { "on" } else { "off" });
        if !dashes.is_empty() {
            let pattern: Vec<String> = dashes.iter().enumerate().map(dash).collect();
            keys.push(format!("dash pattern={}", pattern.join(" ")));
        }
        if paint.opacity < 1.0 {
            keys.push(format!("opacity={}", Decimal(paint.opacity)));
        }
        let Ends { round_joins, round_caps } = ends(style);
        keys.extend(round_joins.then(|| "line join=round".to_owned()));
        keys.extend(round_caps.then(|| "line cap=round".to_owned()));
        let _ = writeln!(out, "  {}/.style={{{}}},", name(style), keys.join(", "));
        if own.any(|mark| mark.shape.own_head().is_some()) {
            let role = style.text_role();
            let _ = writeln!(out, "  {} head/.style={{fill={}}},", name(style), colour(role));
        }
    }
    for (name, anchor, font) in [
        ("label", "base", "normalsize"),
        ("small label", "base", "footnotesize"),
        ("caption", "base west", "normalsize"),
    ] {
        let _ = writeln!(
            out,
            "  assur {name}/.style={{anchor={anchor}, inner sep=0pt, outer sep=0pt, font=\\{font}}},"
        );
    }
    out.push_str("  assur/.try]\n");
}

fn colours(out: &mut String, theme: Theme) {
    let palette = match theme {
        Theme::Auto => Palette::PRINT,
        Theme::Light => Palette::LIGHT,
        Theme::Dark => Palette::DARK,
        Theme::Mono => Palette::MONO,
    };
    for (role, _) in COLOURS {
        let digits = palette.of(role).trim_start_matches('#').to_uppercase();
        let twice = if digits.len() == 3 { 2 } else { 1 };
        let hex: String = digits.chars().flat_map(|c| std::iter::repeat_n(c, twice)).collect();
        let _ = writeln!(out, "\\definecolor{{{}}}{{HTML}}{{{hex}}}", colour(role));
    }
}

fn colour(role: Role) -> String {
    let name = COLOURS.iter().find(|(own, _)| *own == role).map_or("Ink", |(_, name)| name);
    format!("assur{name}")
}

/// Three decimals.
struct Decimal(f64);

impl Display for Decimal {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let text = format!("{:.3}", self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

/// A point of the drawing, y up.
struct Point(Vec2);

impl Display for Point {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "({},{})", Decimal(self.0.x), Decimal(-self.0.y))
    }
}

/// Adds a mark; one that has no place is left out.
fn drawn(out: &mut String, mark: &Mark) {
    if !mark.shape.is_finite() {
        return;
    }
    let style = name(mark.style);
    let mut path = |style: &str, way: &str| {
        let _ = writeln!(out, "\\path[{style}] {way};");
    };
    match &mark.shape {
        Shape::Line(a, b) => path(&style, &lines(&[*a, *b])),
        Shape::Lines { points, closed } if !points.is_empty() => {
            path(&style, &(lines(points) + if *closed { " -- cycle" } else { "" }));
        }
        Shape::Lines { .. } => {}
        Shape::Strokes(strokes) => {
            let strokes: Vec<String> = strokes.iter().map(|(a, b)| lines(&[*a, *b])).collect();
            path(&style, &strokes.join(" "));
        }
        Shape::Circle { centre, radius } if *radius <= LARGEST => {
            path(&style, &format!("{} circle[radius={}]", Point(*centre), Decimal(*radius)));
        }
        Shape::Circle { centre, radius } => {
            path(&style, &(arc((*centre, *radius), 0.0, TAU) + " -- cycle"));
        }
        Shape::Arc { centre, radius, from, sweep } => path(&style, &arc((*centre, *radius), *from, *sweep)),
        Shape::Sector { centre, radius, from, sweep } => {
            let around = arc((*centre, *radius), *from, *sweep);
            path(&style, &format!("{} -- {around} -- cycle", Point(*centre)));
        }
        Shape::Arrow(a, _) => {
            let [tip, left, right, base] = mark.shape.own_head().unwrap_or([*a; 4]);
            path(&style, &lines(&[*a, base]));
            path(&format!("{style} head"), &(lines(&[tip, left, right]) + " -- cycle"));
        }
        Shape::ArcArrow { centre, radius, from, sweep } => {
            path(&style, &arc((*centre, *radius), *from, Shape::shaft_sweep(*radius, *sweep)));
            if let Some([tip, left, right, _]) = mark.shape.own_head() {
                path(&format!("{style} head"), &(lines(&[tip, left, right]) + " -- cycle"));
            }
        }
    }
}

fn lines(points: &[Vec2]) -> String {
    let mut way = String::new();
    for (i, point) in points.iter().enumerate() {
        way.push_str(match i {
            0 => "",
            i if i % POINTS == 0 => "\n  -- ",
            _ => " -- ",
        });
        let _ = write!(way, "{}", Point(*point));
    }
    way
}

/// An arc in curves.
fn arc((centre, radius): (Vec2, f64), from: f64, sweep: f64) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // some turns at most
    let parts = (sweep.abs() / PART).ceil().clamp(1.0, 100.0) as usize;
    let part = sweep / parts as f64;
    let reach = radius * 4.0 / 3.0 * libm::tan(part / 4.0);
    let mut way = Point(on_circle(centre, radius, from)).to_string();
    for i in 0..parts {
        let [a, b] = [i, i + 1].map(|i| from + part * i as f64);
        let ahead = |angle: f64| Vec2::direction(angle).perp() * reach;
        let [first, last] = [a, b].map(|angle| on_circle(centre, radius, angle));
        let (leaves, arrives) = (Point(first + ahead(a)), Point(last - ahead(b)));
        let _ = write!(way, "\n  .. controls {leaves} and {arrives} .. {}", Point(last));
    }
    way
}

/// Adds a text: a label about the middle of its base line, a line below from its begin.
fn lettered(out: &mut String, label: &Lettering<'_>) {
    let letters = letters(label.text);
    if letters.is_empty() || !(label.at.x + label.at.y).is_finite() {
        return;
    }
    let style = match (label.is_caption, label.size >= USUAL) {
        (true, _) => "assur caption",
        (false, true) => "assur label",
        (false, false) => "assur small label",
    };
    let middle = label.text.bounds(label.size).centre().x;
    let at = label.at + Vec2::new(if label.is_caption { 0.0 } else { middle }, 0.0);
    let role = if label.role == Role::Ink { String::new() } else { format!(", text={}", colour(label.role)) };
    let _ = writeln!(out, "\\node[{style}{role}] at {} {{{letters}}};", Point(at));
}

/// Words of a comment.
fn escaped(words: &str) -> String {
    words.chars().map(|c| if c.is_ascii_graphic() || c == ' ' { c } else { '?' }).collect()
}
