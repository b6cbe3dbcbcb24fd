//! What accuracy costs, as a picture: error against time of a motion under loads, prices of effects and digits of positions.

mod positions;
mod runs;

pub use positions::svg;
pub use runs::of_runs;

use assur_drawing::{Drawing, Label, Role, Text};
use assur_math::math::Vec2;

/// The width of all of it, mm: that of a small page, and on a telephone letters that can be read.
const PAGE: f64 = 118.0;
const TITLE: f64 = 4.6;
const WORDS: f64 = 3.8;
const NUMBERS: f64 = 3.4;
/// From line to line, in sizes of letters.
const LINE: f64 = 1.35;

const RIGHT: Vec2 = Vec2 { x: 1.0, y: 0.0 };
const LEFT: Vec2 = Vec2 { x: -1.0, y: 0.0 };
const DOWN: Vec2 = Vec2 { x: 0.0, y: 1.0 };

/// A text that begins, ends or is centred at a point, as it lies in a direction from it.
fn written(drawing: &mut Drawing, words: &str, (size, role): (f64, Role), at: Vec2, towards: Vec2) {
    let label = Label::at(Text::upright(words), size, at, 0.3).towards(towards).ranked(0);
    drawing.label(label.coloured(role));
}

/// The lines of a text that is filled to a width.
fn filled(words: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        let longer = |line: &String| format!("{line} {word}");
        let fits = |line: &String| Text::upright(line).bounds(size).max.x <= width;
        match lines.last_mut().map(|line| (longer(line), line)) {
            Some((longer, line)) if fits(&longer) => *line = longer,
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Texts one below the other, each filled to the page from `left` on; `y` is that of the first line, and then of the next.
fn paragraph(drawing: &mut Drawing, words: &str, style: (f64, Role), left: f64, y: &mut f64) {
    for line in filled(words, style.0, PAGE) {
        written(drawing, &line, style, Vec2::new(left, *y), RIGHT);
        *y += LINE * style.0;
    }
}

/// Title and finding above a picture that begins at `top`.
fn head(drawing: &mut Drawing, title: &str, finding: &str, left: f64, top: f64) {
    let height = |words: &str, size: f64| LINE * size * filled(words, size, PAGE).len() as f64;
    let mut y = top - height(title, TITLE) - height(finding, WORDS) - 1.0;
    paragraph(drawing, title, (TITLE, Role::Ink), left, &mut y);
    y += 0.5;
    paragraph(drawing, finding, (WORDS, Role::Ink), left, &mut y);
}
