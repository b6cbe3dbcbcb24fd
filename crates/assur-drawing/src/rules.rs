//! Rules of style: concrete colours in plain rules, media rules behind them that only replace colours.

use crate::drawing::Sheet;
use crate::label::{Palette, Role, Theme};
use crate::mark::Shape;
use crate::number::number;
use crate::style::{STYLES, Style};
use std::fmt::Write;

/// Families with the same widths.
pub const FAMILIES: [&str; 5] =
    ["Times New Roman", "Tinos", "Liberation Serif", "Nimbus Roman", "TeX Gyre Termes"];
/// The same as a rule.
const FAMILY: &str = r#""Times New Roman",Tinos,"Liberation Serif","Nimbus Roman","TeX Gyre Termes",serif"#;
/// What begins the rules for readers who prefer dark pages.
pub const DARK: &str = "@media (prefers-color-scheme:dark){";
const COLOURS: [Role; 4] = [Role::Grey, Role::Blue, Role::Vermilion, Role::Green];

/// The kinds of stroke of a sheet, those that have arrows' heads, and the colours of its texts.
pub struct Used {
    styles: [bool; STYLES.len()],
    headed: [bool; STYLES.len()],
    colours: [bool; COLOURS.len()],
}

/// The rules of all kinds of stroke, for a page in which several sheets have none of their own.
#[must_use]
pub fn page_rules(theme: Theme) -> String {
    let mut out = String::new();
    let used =
        Used { styles: [true; STYLES.len()], headed: [true; STYLES.len()], colours: [true; COLOURS.len()] };
    used.rules(&mut out, theme);
    out
}

impl Used {
    pub fn of(sheet: &Sheet) -> Self {
        let none = [false; STYLES.len()];
        let mut used = Self { styles: none, headed: none, colours: [false; COLOURS.len()] };
        for mark in &sheet.drawing.marks {
            used.styles[mark.style as usize] = true;
            used.headed[mark.style as usize] |=
                matches!(mark.shape, Shape::Arrow(..) | Shape::ArcArrow { .. });
        }
        for placed in &sheet.placed {
            used.styles[Style::Number as usize] |= placed.label.ring.is_some();
            used.styles[Style::Thin as usize] |= placed.leader.is_some();
            COLOURS
                .iter()
                .zip(&mut used.colours)
                .for_each(|(role, used)| *used |= placed.label.role == *role);
        }
        used.styles[Style::Medium as usize] |= sheet.drawing.captions.iter().any(|c| c.bar.is_some());
        used
    }

    /// Writes the rules of a theme.
    pub fn rules(&self, out: &mut String, theme: Theme) {
        self.in_palette(out, &Palette::on_screen(theme), true);
        if theme == Theme::Auto {
            out.push_str(DARK);
            self.in_palette(out, &Palette::DARK, false);
            out.push_str("}\n@media print{");
            self.in_palette(out, &Palette::PRINT, false);
            out.push('}');
        }
    }

    /// All that they say, or colours alone.
    fn in_palette(&self, out: &mut String, palette: &Palette, whole: bool) {
        let _ = write!(out, ".fig .bg{{fill:{}}}", palette.of(Role::Paper));
        for style in STYLES.into_iter().filter(|s| self.styles[*s as usize]) {
            let paint = style.paint();
            let _ = write!(out, ".fig .{}{{", paint.class);
            match paint.stroke {
                Some((role, width)) => {
                    let _ = write!(out, "stroke:{};", palette.of(role));
                    if whole {
                        let _ = write!(out, "stroke-width:{};", number(width));
                    }
                }
                None if whole => out.push_str("stroke:none;"),
                None => {}
            }
            match paint.fill {
                Some(role) => {
                    let _ = write!(out, "fill:{};", palette.of(role));
                }
                None if whole => out.push_str("fill:none;"),
                None => {}
            }
            if whole {
                shape_of_strokes(out, style);
            }
            // between what they say, not behind the last
            if out.ends_with(';') {
                out.pop();
            }
            out.push('}');
            if let (Some((role, _)), true) = (paint.stroke, self.headed[style as usize]) {
                let line = if whole { "stroke:none;" } else { "" };
                let _ = write!(out, ".fig .{}.head{{{line}fill:{}}}", paint.class, palette.of(role));
            }
        }
        let family = if whole { format!("font-family:{FAMILY};") } else { String::new() };
        let _ = write!(out, ".fig text{{{family}fill:{}}}", palette.of(Role::Ink));
        if whole {
            out.push_str(".fig .i{font-style:italic}");
        }
        for (role, _) in COLOURS.into_iter().zip(self.colours).filter(|(_, used)| *used) {
            let _ = write!(out, ".fig .{} text{{fill:{}}}", text_class(role), palette.of(role));
        }
        out.push('\n');
    }
}

/// Dashes, opacity, joins and ends.
fn shape_of_strokes(out: &mut String, style: Style) {
    let paint = style.paint();
    if !paint.dashes.is_empty() {
        let _ = write!(out, "stroke-dasharray:{};", paint.dashes);
    }
    if paint.opacity < 1.0 {
        let _ = write!(out, "opacity:{};", number(paint.opacity));
    }
    let Ends { round_joins, round_caps } = ends(style);
    out.push_str(if round_joins { "stroke-linejoin:round;" } else { "" });
    out.push_str(if round_caps { "stroke-linecap:round;" } else { "" });
}

/// How the lines of a stroke meet and end.
pub struct Ends {
    pub round_joins: bool,
    pub round_caps: bool,
}

pub const fn ends(style: Style) -> Ends {
    let round_caps = matches!(style, Style::Link | Style::Pulled | Style::Pushed);
    let round_joins = round_caps || matches!(style, Style::Plate | Style::Block | Style::Medium);
    Ends { round_joins, round_caps }
}

/// The class of texts in a colour.
pub const fn text_class(role: Role) -> &'static str {
    match role {
        Role::Blue => "cv",
        Role::Vermilion => "ca",
        Role::Green => "cr",
        _ => "cs",
    }
}
