//! Sheets as SVG: concrete colours in plain rules, media rules behind them that only replace colours.

use crate::drawing::{CAPTION, Placed, Sheet};
use crate::mark::{Mark, Shape, on_circle};
use crate::palette::{Palette, Role, Theme};
use crate::style::{STYLES, Style};
use crate::text::Text;
use assur_math::math::Vec2;
use std::fmt::Write;

/// Families with the same widths.
pub const FAMILIES: [&str; 5] =
    ["Times New Roman", "Tinos", "Liberation Serif", "Nimbus Roman", "TeX Gyre Termes"];
/// The same as a rule.
const FAMILY: &str = r#""Times New Roman",Tinos,"Liberation Serif","Nimbus Roman","TeX Gyre Termes",serif"#;

/// A number with two decimals at most, without zeros at its end and without a minus before nothing.
#[must_use]
pub fn number(x: f64) -> String {
    let mut text = format!("{x:.2}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// A text in which no sign is one of the document's.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
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
    out
}

impl Sheet {
    /// The sheet as SVG.
    #[must_use]
    pub fn svg(&self, theme: Theme) -> String {
        let mut out = String::new();
        self.head(&mut out);
        self.style(&mut out, theme);
        let (at, size) = (self.bounds.min, self.bounds.size());
        let _ = writeln!(
            out,
            r#"<rect class="bg" x="{}" y="{}" width="{}" height="{}"/>"#,
            number(at.x),
            number(at.y),
            number(size.x),
            number(size.y)
        );
        self.marks(&mut out);
        for (i, placed) in self.placed.iter().enumerate() {
            within(&mut out, self.moved[1].get(i), |out| self.label(out, placed));
        }
        self.captions(&mut out);
        out.push_str("</svg>\n");
        out
    }

    fn head(&self, out: &mut String) {
        let (at, size) = (self.bounds.min, self.bounds.size());
        let id = &self.drawing.id;
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

    fn style(&self, out: &mut String, theme: Theme) {
        let first = match theme {
            Theme::Auto | Theme::Light => Palette::LIGHT,
            Theme::Dark => Palette::DARK,
            Theme::Mono => Palette::MONO,
        };
        out.push_str("<style>");
        self.rules(out, &first, true);
        if theme == Theme::Auto {
            out.push_str("@media (prefers-color-scheme:dark){");
            self.rules(out, &Palette::DARK, false);
            out.push_str("}\n@media print{");
            self.rules(out, &Palette::PRINT, false);
            out.push('}');
        }
        out.push_str("</style>\n");
    }

    /// Rules for what the sheet has; all that they say, or colours alone.
    fn rules(&self, out: &mut String, palette: &Palette, whole: bool) {
        let _ = write!(out, ".fig .bg{{fill:{}}}", palette.of(Role::Paper));
        for style in STYLES.into_iter().filter(|s| self.has(*s)) {
            let paint = style.paint();
            let _ = write!(out, ".fig .{}{{", paint.class);
            let mut parts = Vec::new();
            match paint.stroke {
                Some((role, width)) => {
                    parts.push(format!("stroke:{}", palette.of(role)));
                    if whole {
                        parts.push(format!("stroke-width:{}", number(width)));
                    }
                }
                None if whole => parts.push("stroke:none".to_owned()),
                None => {}
            }
            match paint.fill {
                Some(role) => parts.push(format!("fill:{}", palette.of(role))),
                None if whole => parts.push("fill:none".to_owned()),
                None => {}
            }
            if whole {
                if !paint.dashes.is_empty() {
                    parts.push(format!("stroke-dasharray:{}", paint.dashes));
                }
                if paint.opacity < 1.0 {
                    parts.push(format!("opacity:{}", number(paint.opacity)));
                }
                if matches!(style, Style::Link | Style::Plate | Style::Block | Style::Medium) {
                    parts.push("stroke-linejoin:round".to_owned());
                }
                if style == Style::Link {
                    parts.push("stroke-linecap:round".to_owned());
                }
            }
            let _ = write!(out, "{}}}", parts.join(";"));
            if let (Some((role, _)), true) = (paint.stroke, self.has_head(style)) {
                let line = if whole { "stroke:none;" } else { "" };
                let _ = write!(out, ".fig .{}.head{{{line}fill:{}}}", paint.class, palette.of(role));
            }
        }
        if whole {
            let _ = write!(out, ".fig text{{font-family:{FAMILY};fill:{}}}", palette.of(Role::Ink));
            out.push_str(".fig .i{font-style:italic}");
        } else {
            let _ = write!(out, ".fig text{{fill:{}}}", palette.of(Role::Ink));
        }
        for role in [Role::Grey, Role::Blue, Role::Vermilion, Role::Green] {
            if self.placed.iter().any(|p| p.label.role == role) {
                let _ = write!(out, ".fig .{} text{{fill:{}}}", text_class(role), palette.of(role));
            }
        }
        out.push('\n');
    }

    fn has(&self, style: Style) -> bool {
        let of_labels = match style {
            Style::Number => self.placed.iter().any(|p| p.label.ring.is_some()),
            Style::Thin => self.placed.iter().any(|p| p.leader.is_some()),
            Style::Medium => self.drawing.captions.iter().any(|c| c.bar.is_some()),
            _ => false,
        };
        of_labels || self.drawing.marks.iter().any(|m| m.style == style)
    }

    fn has_head(&self, style: Style) -> bool {
        let headed = |m: &Mark| m.style == style && m.shape.own_head().is_some();
        self.drawing.marks.iter().any(headed)
    }

    fn marks(&self, out: &mut String) {
        let mut open = 0;
        for (i, mark) in self.drawing.marks.iter().enumerate() {
            if mark.group != open {
                if open != 0 {
                    out.push_str("</g>\n");
                }
                open = mark.group;
                if open != 0 {
                    let group = &self.drawing.groups[open];
                    let name = escaped(&group.name);
                    let _ = writeln!(out, r#"<g class="{}" data-name="{name}">"#, group.class);
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
        let colour = match label.role {
            Role::Ink => String::new(),
            role => format!(" {}", text_class(role)),
        };
        let plain = escaped(&label.text.plain());
        let spoken = if label.text.runs.len() > 1 || label.text.full.is_some() {
            format!(r#" aria-label="{plain}""#)
        } else {
            String::new()
        };
        let name = &self.drawing.groups[label.group].name;
        let owner =
            if name.is_empty() { String::new() } else { format!(r#" data-name="{}""#, escaped(name)) };
        let _ = write!(out, r#"<g class="lab{colour}"{owner}{spoken}>"#);
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
    let _ = write!(out, r#"<g class="{class}">"#);
    write(out);
    out.push_str("</g>\n");
}

/// A mark alone.
#[must_use]
pub fn mark_svg(mark: &Mark) -> String {
    let mut out = String::new();
    shape(&mut out, mark);
    out.trim_end().to_owned()
}

/// The class of texts in a colour.
const fn text_class(role: Role) -> &'static str {
    match role {
        Role::Blue => "cv",
        Role::Vermilion => "ca",
        Role::Green => "cr",
        _ => "cs",
    }
}

fn text(out: &mut String, text: &Text, at: Vec2, size: f64) {
    for set in text.set(size) {
        let place = at + set.at;
        let class = if set.run.italic { "i" } else { "u" };
        let blanks = set.run.letters.starts_with(' ') || set.run.letters.ends_with(' ');
        let space = if blanks { r#" xml:space="preserve""# } else { "" };
        let _ = write!(
            out,
            r#"<text class="{class}" x="{}" y="{}" font-size="{}"{space} textLength="{}" lengthAdjust="spacingAndGlyphs">{}</text>"#,
            number(place.x),
            number(place.y),
            number(set.size),
            number(set.width.max(0.01)),
            escaped(&set.run.letters)
        );
    }
}

fn point(p: Vec2) -> String {
    format!("{} {}", number(p.x), number(p.y))
}

fn line(out: &mut String, class: &str, a: Vec2, b: Vec2) {
    let _ = writeln!(
        out,
        r#"<line class="{class}" x1="{}" y1="{}" x2="{}" y2="{}"/>"#,
        number(a.x),
        number(a.y),
        number(b.x),
        number(b.y)
    );
}

fn circle(out: &mut String, class: &str, centre: Vec2, radius: f64) {
    let (x, y) = (number(centre.x), number(centre.y));
    let _ = writeln!(out, r#"<circle class="{class}" cx="{x}" cy="{y}" r="{}"/>"#, number(radius));
}

fn path(out: &mut String, class: &str, d: &str) {
    let _ = writeln!(out, r#"<path class="{class}" d="{d}"/>"#);
}

fn arc(centre: Vec2, radius: f64, from: f64, sweep: f64) -> String {
    let large = u8::from(sweep.abs() > std::f64::consts::PI);
    let onwards = u8::from(sweep > 0.0);
    let r = number(radius);
    let (start, end) = (on_circle(centre, radius, from), on_circle(centre, radius, from + sweep));
    format!("{}A{r} {r} 0 {large} {onwards} {}", point(start), point(end))
}

fn shape(out: &mut String, mark: &Mark) {
    let class = mark.style.paint().class;
    match &mark.shape {
        Shape::Line(a, b) => line(out, class, *a, *b),
        Shape::Lines { points, closed } => {
            let corners: Vec<String> = points.iter().map(|p| point(*p)).collect();
            path(out, class, &format!("M{}{}", corners.join("L"), if *closed { "Z" } else { "" }));
        }
        Shape::Strokes(lines) => {
            let d: String = lines.iter().map(|(a, b)| format!("M{}L{}", point(*a), point(*b))).collect();
            path(out, class, &d);
        }
        Shape::Circle { centre, radius } => circle(out, class, *centre, *radius),
        Shape::Arc { centre, radius, from, sweep } => {
            path(out, class, &format!("M{}", arc(*centre, *radius, *from, *sweep)));
        }
        Shape::Sector { centre, radius, from, sweep } => {
            path(out, class, &format!("M{}L{}Z", point(*centre), arc(*centre, *radius, *from, *sweep)));
        }
        Shape::Arrow(a, _) => {
            let [tip, left, right, base] = mark.shape.own_head().unwrap_or([*a; 4]);
            line(out, class, *a, base);
            head(out, class, [tip, left, right]);
        }
        Shape::ArcArrow { centre, radius, from, sweep } => {
            let shaft = Shape::shaft_sweep(*radius, *sweep);
            path(out, class, &format!("M{}", arc(*centre, *radius, *from, shaft)));
            if let Some([tip, left, right, _]) = mark.shape.own_head() {
                head(out, class, [tip, left, right]);
            }
        }
    }
}

fn head(out: &mut String, class: &str, [tip, left, right]: [Vec2; 3]) {
    let d = format!("M{}L{}L{}Z", point(tip), point(left), point(right));
    path(out, &format!("{class} head"), &d);
}
