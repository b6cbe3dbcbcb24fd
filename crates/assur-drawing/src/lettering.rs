//! What every writer draws: the marks of a sheet, and its texts with the marks that belong to them.

use crate::drawing::{CAPTION, Placed, Sheet};
use crate::label::Role;
use crate::mark::{Mark, Shape};
use crate::style::Style;
use crate::text::Text;
use assur_math::math::Vec2;

/// A text in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Lettering<'a> {
    pub text: &'a Text,
    /// Begin of its base line, mm; y down.
    pub at: Vec2,
    /// Size of its letters, mm.
    pub size: f64,
    pub role: Role,
    /// Whether it is a line below the drawing.
    pub is_caption: bool,
    /// The line to its place, the circle around it, the bar behind it.
    pub marks: Vec<Mark>,
}

impl Sheet {
    /// All marks without those that belong to texts, the first at the back.
    #[must_use]
    pub fn marks(&self) -> &[Mark] {
        &self.drawing.marks
    }

    /// All texts: labels, then the lines below.
    #[must_use]
    pub fn labels(&self) -> Vec<Lettering<'_>> {
        let mut all: Vec<Lettering<'_>> = self.placed.iter().map(placed).collect();
        for (caption, at) in self.drawing.captions.iter().zip(&self.lines) {
            let line = |text, at, marks| {
                let (size, role, is_caption) = (CAPTION, Role::Ink, true);
                Lettering { text, at, size, role, is_caption, marks }
            };
            match &caption.bar {
                None => all.push(line(&caption.text, *at, Vec::new())),
                Some((length, words)) => {
                    let from = *at + Vec2::new(caption.bar_at(), -0.3 * CAPTION);
                    all.push(line(&caption.text, *at, vec![bar(from, *length)]));
                    all.push(line(words, *at + Vec2::new(caption.behind(), 0.0), Vec::new()));
                }
            }
        }
        all
    }
}

fn placed(placed: &Placed) -> Lettering<'_> {
    let Placed { label, bounds, leader } = placed;
    let mark = |style, shape| Mark { shape, style, group: label.group };
    let leader = leader.map(|(from, to)| mark(Style::Thin, Shape::Line(from, to)));
    let ring = label.ring.map(|radius| {
        if label.half().x <= radius {
            return mark(Style::Number, Shape::Circle { centre: bounds.centre(), radius });
        }
        let (a, b) = (bounds.min, bounds.max);
        let corners = vec![a, Vec2::new(b.x, a.y), b, Vec2::new(a.x, b.y)];
        mark(Style::Number, Shape::polygon(corners))
    });
    Lettering {
        text: &label.text,
        at: label.baseline(bounds),
        size: label.size,
        role: label.role,
        is_caption: false,
        marks: leader.into_iter().chain(ring).collect(),
    }
}

/// A bar of a length with its ends.
fn bar(from: Vec2, length: f64) -> Mark {
    let to = from + Vec2::new(length, 0.0);
    let end = |at: Vec2| (at - Vec2::new(0.0, 1.0), at + Vec2::new(0.0, 1.0));
    Mark { shape: Shape::Strokes(vec![(from, to), end(from), end(to)]), style: Style::Medium, group: 0 }
}
