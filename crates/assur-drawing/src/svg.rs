//! Sheets as SVG.

use crate::drawing::{CAPTION, Placed, Sheet};
use crate::label::{Role, Theme};
use crate::mark::{Mark, Shape, on_circle};
use crate::number::number;
use crate::rules::{DARK, Used, text_class};
use crate::style::Style;
use crate::text::Text;
use assur_math::math::Vec2;
use std::fmt::Write;

/// What a mark or a label takes, and rules and description, bytes.
const ABOUT: usize = 150;
const RULES: usize = 4000;

/// A text in which no sign is one of the document's.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    escape(&mut out, text);
    out
}

/// A picture of [`Theme::Auto`] in its light colours alone, for a page that is never dark.
#[must_use]
pub fn in_light(svg: &str) -> String {
    let parts =
        svg.split_once(DARK).and_then(|(before, after)| Some((before, after.split_once("</style>")?.1)));
    parts.map_or_else(|| svg.to_owned(), |(before, after)| format!("{before}</style>{after}"))
}

/// A name as an id of a document: names of files and links may have any signs.
fn identifier(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '-' }).collect()
}

fn escape(out: &mut String, text: &str) {
    let is_plain = |b: u8| b.is_ascii_graphic() && !b"&<>\"".contains(&b) || b == b' ';
    if text.bytes().all(is_plain) {
        return out.push_str(text);
    }
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => out.push(' '),
            c if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') => {}
            c => out.push(c),
        }
    }
}

impl Sheet {
    /// The sheet as SVG.
    #[must_use]
    pub fn svg(&self, theme: Theme) -> String {
        self.with_rules(Some(theme))
    }

    /// The same without rules of its own, for a page that has those of [`page_rules`](crate::page_rules).
    #[must_use]
    pub fn svg_in_page(&self) -> String {
        self.with_rules(None)
    }

    fn with_rules(&self, theme: Option<Theme>) -> String {
        let size = ABOUT * (self.drawing.marks.len() + self.placed.len()) + RULES;
        let mut out = String::with_capacity(size);
        self.head(&mut out);
        if let Some(theme) = theme {
            out.push_str("<style>");
            Used::of(self).rules(&mut out, theme);
            out.push_str("</style>\n");
        }
        let (at, size) = (self.bounds.min, self.bounds.size());
        let _ = writeln!(
            out,
            r#"<rect class="bg" x="{}" y="{}" width="{}" height="{}"/>"#,
            number(at.x),
            number(at.y),
            number(size.x),
            number(size.y)
        );
        self.groups(&mut out);
        for (i, placed) in self.placed.iter().enumerate() {
            within(&mut out, self.moved[1].get(i), |out| self.label(out, placed));
        }
        self.captions(&mut out);
        out.push_str("</svg>\n");
        out
    }

    fn head(&self, out: &mut String) {
        let (at, size) = (self.bounds.min, self.bounds.size());
        let id = identifier(&self.drawing.id);
        let _ = writeln!(
            out,
            r#"<svg xmlns="http://www.w3.org/2000/svg" class="fig" width="{w}mm" height="{h}mm" viewBox="{x} {y} {w} {h}" role="img" aria-labelledby="{id}-t {id}-d">
<title id="{id}-t">{title}</title>
<desc id="{id}-d">{description}</desc>"#,
            w = number(size.x),
            h = number(size.y),
            x = number(at.x),
            y = number(at.y),
            title = escaped(&self.drawing.title),
            description = escaped(&self.drawing.description)
        );
    }

    fn groups(&self, out: &mut String) {
        let mut open = 0;
        for (i, mark) in self.drawing.marks.iter().enumerate() {
            if mark.group != open {
                if open != 0 {
                    out.push_str("</g>\n");
                }
                open = mark.group;
                if open != 0 {
                    let group = &self.drawing.groups[open];
                    begin(out, "<g", group.class);
                    named(out, " data-name=\"", &group.name);
                    out.push_str(">\n");
                }
            }
            within(out, self.moved[0].get(i), |out| shape(out, mark));
        }
        if open != 0 {
            out.push_str("</g>\n");
        }
    }

    fn label(&self, out: &mut String, placed: &Placed) {
        let label = &placed.label;
        if let Some((from, to)) = placed.leader {
            line(out, Style::Thin.paint().class, from, to);
        }
        if let Some(radius) = label.ring {
            let at = placed.bounds.centre();
            let class = Style::Number.paint().class;
            if label.half().x > radius {
                let (at, size) = (placed.bounds.min, placed.bounds.size());
                let _ = writeln!(
                    out,
                    r#"<rect class="{class}" x="{}" y="{}" width="{}" height="{}" rx="{}"/>"#,
                    number(at.x),
                    number(at.y),
                    number(size.x),
                    number(size.y),
                    number(radius)
                );
            } else {
                circle(out, class, at, radius);
            }
        }
        out.push_str("<g class=\"lab");
        if label.role != Role::Ink {
            out.push(' ');
            out.push_str(text_class(label.role));
        }
        out.push('"');
        let name = &self.drawing.groups[label.group].name;
        if !name.is_empty() {
            named(out, " data-name=\"", name);
        }
        if label.text.runs.len() > 1 || label.text.full.is_some() {
            named(out, " aria-label=\"", &label.text.plain());
        }
        out.push('>');
        text(out, &label.text, label.baseline(&placed.bounds), label.size);
        out.push_str("</g>\n");
    }

    fn captions(&self, out: &mut String) {
        for (caption, at) in self.drawing.captions.iter().zip(&self.lines) {
            out.push_str("<g class=\"caption\">");
            text(out, &caption.text, *at, CAPTION);
            if let Some((length, words)) = &caption.bar {
                let (x, y) = (at.x + caption.bar_at(), at.y - 0.3 * CAPTION);
                let class = Style::Medium.paint().class;
                let (a, b) = (number(x), number(x + length));
                let (above, below, y) = (number(y - 1.0), number(y + 1.0), number(y));
                let _ = write!(
                    out,
                    r#"<path class="{class}" d="M{a} {y}L{b} {y}M{a} {above}L{a} {below}M{b} {above}L{b} {below}"/>"#
                );
                text(out, words, *at + Vec2::new(caption.behind(), 0.0), CAPTION);
            }
            out.push_str("</g>\n");
        }
    }
}

/// Writes something, in a group of its own where it has a class.
fn within(out: &mut String, class: Option<&Option<String>>, write: impl FnOnce(&mut String)) {
    let Some(class) = class.and_then(Option::as_ref) else { return write(out) };
    let mut groups = 0;
    for class in class.split(' ') {
        let _ = write!(out, r#"<g class="{class}">"#);
        groups += 1;
    }
    write(out);
    (0..groups).for_each(|_| out.push_str("</g>"));
    out.push('\n');
}

#[must_use]
pub fn mark_svg(mark: &Mark) -> String {
    let mut out = String::new();
    shape(&mut out, mark);
    out.trim_end().to_owned()
}

fn text(out: &mut String, text: &Text, at: Vec2, size: f64) {
    for set in text.set(size) {
        let place = at + set.at;
        let blanks = set.run.letters.starts_with(' ') || set.run.letters.ends_with(' ');
        out.push_str(if set.run.italic { "<text class=\"i\"" } else { "<text class=\"u\"" });
        attribute(out, " x=\"", place.x);
        attribute(out, " y=\"", place.y);
        attribute(out, " font-size=\"", set.size);
        out.push_str(if blanks { " xml:space=\"preserve\"" } else { "" });
        attribute(out, " textLength=\"", set.width.max(0.01));
        out.push_str(" lengthAdjust=\"spacingAndGlyphs\">");
        escape(out, &set.run.letters);
        out.push_str("</text>");
    }
}

/// An attribute with words, from its begin.
fn named(out: &mut String, begin: &str, words: &str) {
    out.push_str(begin);
    escape(out, words);
    out.push('"');
}

/// An attribute with a number, from its begin.
fn attribute(out: &mut String, begin: &str, x: f64) {
    out.push_str(begin);
    number(x).push_to(out);
    out.push('"');
}

/// The begin of an element with a class.
fn begin(out: &mut String, element: &str, class: &str) {
    out.push_str(element);
    out.push_str(" class=\"");
    out.push_str(class);
    out.push('"');
}

fn line(out: &mut String, class: &str, a: Vec2, b: Vec2) {
    begin(out, "<line", class);
    for (name, x) in [(" x1=\"", a.x), (" y1=\"", a.y), (" x2=\"", b.x), (" y2=\"", b.y)] {
        attribute(out, name, x);
    }
    out.push_str("/>\n");
}

fn circle(out: &mut String, class: &str, centre: Vec2, radius: f64) {
    begin(out, "<circle", class);
    for (name, x) in [(" cx=\"", centre.x), (" cy=\"", centre.y), (" r=\"", radius)] {
        attribute(out, name, x);
    }
    out.push_str("/>\n");
}

/// A path along which `draw` goes.
fn path(out: &mut String, class: &str, draw: impl FnOnce(&mut String)) {
    begin(out, "<path", class);
    out.push_str(" d=\"");
    draw(out);
    out.push_str("\"/>\n");
}

/// A step of a path to a point.
fn to(out: &mut String, step: &str, p: Vec2) {
    out.push_str(step);
    number(p.x).push_to(out);
    out.push(' ');
    number(p.y).push_to(out);
}

/// An arc of a path, with the step to its begin.
fn arc(out: &mut String, step: &str, (centre, radius): (Vec2, f64), (from, sweep): (f64, f64)) {
    let (large, onwards) = (sweep.abs() > std::f64::consts::PI, sweep > 0.0);
    to(out, step, on_circle(centre, radius, from));
    to(out, "A", Vec2::new(radius, radius));
    out.push_str(match (large, onwards) {
        (true, true) => " 0 1 1 ",
        (true, false) => " 0 1 0 ",
        (false, true) => " 0 0 1 ",
        (false, false) => " 0 0 0 ",
    });
    to(out, "", on_circle(centre, radius, from + sweep));
}

fn shape(out: &mut String, mark: &Mark) {
    let class = mark.style.paint().class;
    match &mark.shape {
        Shape::Line(a, b) => line(out, class, *a, *b),
        Shape::Lines { points, closed } => path(out, class, |out| {
            out.push('M');
            let steps = std::iter::once("").chain(std::iter::repeat("L"));
            points.iter().zip(steps).for_each(|(p, step)| to(out, step, *p));
            out.push_str(if *closed { "Z" } else { "" });
        }),
        Shape::Strokes(lines) => path(out, class, |out| {
            for (a, b) in lines {
                to(out, "M", *a);
                to(out, "L", *b);
            }
        }),
        Shape::Circle { centre, radius } => circle(out, class, *centre, *radius),
        Shape::Arc { centre, radius, from, sweep } => {
            path(out, class, |out| arc(out, "M", (*centre, *radius), (*from, *sweep)));
        }
        Shape::Sector { centre, radius, from, sweep } => path(out, class, |out| {
            to(out, "M", *centre);
            arc(out, "L", (*centre, *radius), (*from, *sweep));
            out.push('Z');
        }),
        Shape::Arrow(a, _) => {
            let [tip, left, right, base] = mark.shape.own_head().unwrap_or([*a; 4]);
            line(out, class, *a, base);
            head(out, class, [tip, left, right]);
        }
        Shape::ArcArrow { centre, radius, from, sweep } => {
            let shaft = Shape::shaft_sweep(*radius, *sweep);
            path(out, class, |out| arc(out, "M", (*centre, *radius), (*from, shaft)));
            if let Some([tip, left, right, _]) = mark.shape.own_head() {
                head(out, class, [tip, left, right]);
            }
        }
    }
}

fn head(out: &mut String, class: &str, [tip, left, right]: [Vec2; 3]) {
    let _ = write!(out, r#"<path class="{class} head" d=""#);
    to(out, "M", tip);
    to(out, "L", left);
    to(out, "L", right);
    out.push_str("Z\"/>\n");
}
