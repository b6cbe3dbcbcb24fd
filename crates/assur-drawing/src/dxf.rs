//! Drawings as DXF R12: millimetres, y up, one layer per thing, the colours those of the layers.

use crate::drawing::{Group, Sheet};
use crate::label::Role;
use crate::lettering::Lettering;
use crate::mark::{Shape, on_circle};
use crate::text::{Text, greek_name, lowered};
use assur_math::math::Vec2;
use std::f64::consts::TAU;
use std::fmt::Write;

/// What the format allows of the name of a layer, and of a text, letters.
const LONGEST_NAME: usize = 31;
const LONGEST_TEXT: usize = 240;
/// Height of capitals over the size of the letters: the fonts of CAD are wide.
const HEIGHT: f64 = 0.62;
/// Types of line: name, and dashes and gaps, mm.
const LINES: [(&str, &[f64]); 3] =
    [("CONTINUOUS", &[]), ("DASHED", &[1.6, -1.0]), ("CHAIN", &[5.0, -1.0, 1.0, -1.0])];

/// A drawing that is being written.
#[derive(Debug, Default)]
pub struct Dxf {
    layers: Vec<Layer>,
    entities: String,
}

#[derive(Debug)]
struct Layer {
    /// What it is of, as wanted.
    of: String,
    /// What of it the format allows, unlike all others.
    name: String,
    role: Role,
}

/// Where an entity is, and how its line is drawn.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pen {
    layer: usize,
    /// Dashes as in [`Paint`](crate::Paint).
    dashes: &'static str,
}

impl Sheet {
    /// The sheet as DXF.
    #[must_use]
    pub fn dxf(&self) -> String {
        let mut dxf = Dxf::new();
        for mark in self.marks() {
            let of = layer_of(&self.drawing.groups[mark.group]);
            let pen = dxf.pen(&of, mark.style.text_role(), mark.style.paint().dashes);
            dxf.shape(pen, &mark.shape);
        }
        for label in self.labels() {
            let pen = dxf.pen("TEXT", Role::Ink, "");
            label.marks.iter().for_each(|mark| dxf.shape(pen, &mark.shape));
            dxf.text(pen, &label);
        }
        dxf.finish()
    }
}

/// What the layer of a group is called before it is made allowed.
fn layer_of(Group { class, name }: &Group) -> String {
    match *class {
        "" => "0".to_owned(),
        "load" | "weight" | "balance" | "couple" => "LOAD".to_owned(),
        "drive" | "turn" => "DRIVE".to_owned(),
        "dimension" => "DIM".to_owned(),
        "link" if name == "ground" => "GROUND".to_owned(),
        class if name.is_empty() => class.to_owned(),
        class => format!("{class}_{name}"),
    }
}

impl Dxf {
    #[must_use]
    pub fn new() -> Self {
        let mut new = Self::default();
        // the layer that every drawing has
        new.pen("0", Role::Ink, "");
        new
    }

    /// A pen for the layer of a thing; the first that asks for a layer chooses its colour.
    pub fn pen(&mut self, of: &str, role: Role, dashes: &'static str) -> Pen {
        let known = self.layers.iter().position(|layer| layer.of == of);
        let layer = known.unwrap_or_else(|| {
            let name = self.free_name(of);
            self.layers.push(Layer { of: of.to_owned(), name, role });
            self.layers.len() - 1
        });
        Pen { layer, dashes }
    }

    /// The allowed name that is nearest to one and not taken.
    fn free_name(&self, of: &str) -> String {
        let allowed = |c: char| match c {
            c if c.is_ascii_alphanumeric() || c == '-' => c.to_ascii_uppercase().to_string(),
            c => greek_name(c).map_or_else(|| "_".to_owned(), str::to_ascii_uppercase),
        };
        let base: String = if of.is_empty() { "_".to_owned() } else { of.chars().map(allowed).collect() };
        let numbered = |i: usize| {
            let number = if i == 1 { String::new() } else { format!("_{i}") };
            format!("{}{number}", &base[..base.len().min(LONGEST_NAME - number.len())])
        };
        let is_free = |name: &String| self.layers.iter().all(|layer| layer.name != *name);
        // of more names than layers one is free
        (1..=self.layers.len() + 1).map(numbered).find(is_free).unwrap_or(base)
    }

    /// Adds a shape; one that has no place is left out.
    pub fn shape(&mut self, pen: Pen, shape: &Shape) {
        if !shape.is_finite() {
            return;
        }
        match shape {
            Shape::Line(a, b) => self.line(pen, *a, *b),
            Shape::Lines { points, closed } => self.polyline(pen, points, *closed),
            Shape::Strokes(lines) => lines.iter().for_each(|(a, b)| self.line(pen, *a, *b)),
            Shape::Circle { centre, radius } => self.circle(pen, *centre, *radius),
            Shape::Arc { centre, radius, from, sweep } => self.arc(pen, (*centre, *radius), *from, *sweep),
            Shape::Sector { centre, radius, from, sweep } => {
                self.line(pen, *centre, on_circle(*centre, *radius, *from));
                self.arc(pen, (*centre, *radius), *from, *sweep);
                self.line(pen, on_circle(*centre, *radius, from + sweep), *centre);
            }
            Shape::Arrow(a, _) => {
                let [tip, left, right, base] = shape.own_head().unwrap_or([*a; 4]);
                self.line(pen, *a, base);
                self.solid(pen, [tip, left, right]);
            }
            Shape::ArcArrow { centre, radius, from, sweep } => {
                self.arc(pen, (*centre, *radius), *from, Shape::shaft_sweep(*radius, *sweep));
                if let Some([tip, left, right, _]) = shape.own_head() {
                    self.solid(pen, [tip, left, right]);
                }
            }
        }
    }

    fn line(&mut self, pen: Pen, a: Vec2, b: Vec2) {
        self.entity("LINE", pen);
        self.place(0, a);
        self.place(1, b);
    }

    /// Lines from point to point; of one point itself.
    fn polyline(&mut self, pen: Pen, points: &[Vec2], closed: bool) {
        match points {
            [] => return,
            [only] => return self.circle(pen, *only, 0.0),
            _ => self.entity("POLYLINE", pen),
        }
        self.pair(66, "1");
        self.place(0, Vec2::zero());
        self.pair(70, if closed { "1" } else { "0" });
        for point in points {
            self.entity("VERTEX", Pen { dashes: "", ..pen });
            self.place(0, *point);
        }
        self.entity("SEQEND", Pen { dashes: "", ..pen });
    }

    /// A circle; of no radius a point.
    fn circle(&mut self, pen: Pen, centre: Vec2, radius: f64) {
        self.entity(if radius > 0.0 { "CIRCLE" } else { "POINT" }, pen);
        self.place(0, centre);
        if radius > 0.0 {
            self.number(40, radius);
        }
    }

    /// An arc; the format counts angles against the sense of ours, and always forwards.
    fn arc(&mut self, pen: Pen, (centre, radius): (Vec2, f64), from: f64, sweep: f64) {
        if sweep.abs() >= TAU || radius <= 0.0 {
            return self.circle(pen, centre, radius);
        }
        self.entity("ARC", pen);
        self.place(0, centre);
        self.number(40, radius);
        let (first, last) = (-from - sweep.max(0.0), -from - sweep.min(0.0));
        self.number(50, first.to_degrees().rem_euclid(360.0));
        self.number(51, last.to_degrees().rem_euclid(360.0));
    }

    fn solid(&mut self, pen: Pen, [a, b, c]: [Vec2; 3]) {
        self.entity("SOLID", Pen { dashes: "", ..pen });
        [a, b, c, c].into_iter().enumerate().for_each(|(i, at)| self.place(i, at));
    }

    /// Adds a text: a label about the middle of its base line, a line below as wide as it is in other formats.
    fn text(&mut self, pen: Pen, label: &Lettering<'_>) {
        let Lettering { text, at, size, is_caption, .. } = label;
        let letters = letters(text);
        if letters.trim().is_empty() || !(at.x + at.y).is_finite() {
            return;
        }
        let width = Vec2::new(text.bounds(*size).max.x, 0.0);
        self.entity("TEXT", pen);
        self.place(0, *at);
        self.number(40, HEIGHT * size);
        self.pair(1, &letters);
        self.pair(72, if *is_caption { "5" } else { "1" });
        self.place(1, if *is_caption { *at + width } else { *at + width * 0.5 });
    }

    /// The whole document.
    #[must_use]
    pub fn finish(self) -> String {
        let Self { layers, entities } = self;
        let mut out = Self::default();
        out.pairs(&[(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC")]);
        out.pairs(&[(0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LTYPE")]);
        out.pair(70, &LINES.len().to_string());
        for (name, dashes) in LINES {
            out.pairs(&[(0, "LTYPE"), (2, name), (70, "0"), (3, name), (72, "65")]);
            out.pair(73, &dashes.len().to_string());
            out.number(40, dashes.iter().map(|d| d.abs()).sum());
            dashes.iter().for_each(|d| out.number(49, *d));
        }
        out.pairs(&[(0, "ENDTAB"), (0, "TABLE"), (2, "LAYER")]);
        out.pair(70, &layers.len().to_string());
        for layer in &layers {
            out.pairs(&[(0, "LAYER"), (2, &layer.name), (70, "0"), (62, colour(layer.role))]);
            out.pair(6, LINES[0].0);
        }
        out.pairs(&[(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]);
        out.entities += &entities;
        out.pairs(&[(0, "ENDSEC"), (0, "EOF")]);
        out.entities
    }

    fn entity(&mut self, kind: &str, pen: Pen) {
        self.pair(0, kind);
        let _ = write!(self.entities, "  8\r\n{}\r\n", self.layers[pen.layer].name);
        match pen.dashes {
            "" => {}
            chain if chain.starts_with('5') => self.pair(6, LINES[2].0),
            _ => self.pair(6, LINES[1].0),
        }
    }

    fn pairs(&mut self, all: &[(u16, &str)]) {
        all.iter().for_each(|(code, value)| self.pair(*code, value));
    }

    fn pair(&mut self, code: u16, value: &str) {
        let _ = write!(self.entities, "{code:>3}\r\n{value}\r\n");
    }

    /// The n-th point of an entity.
    fn place(&mut self, n: usize, at: Vec2) {
        for (code, x) in [(10, at.x), (20, -at.y), (30, 0.0)] {
            #[allow(clippy::cast_possible_truncation)] // of four
            self.number(code + n as u16, x);
        }
    }

    /// A number of seven decimals without zeros at the end, without a minus before nothing.
    fn number(&mut self, code: u16, x: f64) {
        let text = format!("{x:.7}");
        let text = text.trim_end_matches('0');
        let point = if text.ends_with('.') { "0" } else { "" };
        let text = if text == "-0." { "0." } else { text };
        self.pair(code, &format!("{text}{point}"));
    }
}

/// The number of a colour.
const fn colour(role: Role) -> &'static str {
    match role {
        Role::Ink | Role::Paper => "7",
        Role::Grey | Role::Tint => "8",
        Role::Blue | Role::BlueTint => "5",
        Role::Vermilion | Role::VermilionTint => "1",
        Role::Green => "3",
    }
}

/// A text in letters that every reader has.
fn letters(text: &Text) -> String {
    let mut out = String::new();
    let mut was_raised = false;
    for c in text.plain().chars().filter(|c| !c.is_control()) {
        let digit = lowered(c);
        // a caret with a blank behind it is a caret
        out.push_str(if digit.is_some() && !was_raised { "^ " } else { "" });
        was_raised = digit.is_some();
        match (digit.unwrap_or(c), greek_name(c)) {
            ('^', _) => out.push_str("^ "),
            ('°', _) => out.push_str("%%d"),
            ('⌀' | '∅' | 'Ø', _) => out.push_str("%%c"),
            ('±', _) => out.push_str("%%p"),
            ('−', _) => out.push('-'),
            ('′', _) => out.push('\''),
            ('·', _) => out.push('*'),
            ('×', _) => out.push('x'),
            ('…', _) => out.push_str("..."),
            ('µ', _) => out.push('u'),
            (c, _) if c.is_ascii() => out.push(c),
            (_, Some(name)) => out.push_str(name),
            (c, _) => {
                let _ = write!(out, "\\U+{:04X}", u32::from(c));
            }
        }
        if out.len() > LONGEST_TEXT {
            break;
        }
    }
    out
}
