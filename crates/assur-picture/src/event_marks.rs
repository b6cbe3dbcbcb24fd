//! The events of a motion under loads in its diagrams.

use crate::diagram::{Panel, printed};
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::Display;

/// Instants of an event that are marked, and those in the description.
const MOST_MARKED: usize = 40;
const MOST_DESCRIBED: usize = 8;
/// So many instants of one event have its name.
const FIRST: usize = 4;
/// Size of a name; from name to name, mm.
const LETTERS: f64 = 3.0;
const APART: f64 = 1.5;
/// Marks that are nearer have one name together, mm.
const TOGETHER: f64 = 0.3;

/// Lines at the instants of events, with their names above the first panel.
pub fn marked_events(
    scene: &Scene<'_>,
    drawing: &mut Drawing,
    panel: &Panel,
    (along, events): (&Display, &[Vec<f64>]),
    named: bool,
) {
    let named_events = scene.mechanism().events.iter().map(|event| event.name.as_deref().unwrap_or("until"));
    let mut marks: Vec<(f64, Vec<String>)> = Vec::new();
    for (name, times) in named_events.zip(events) {
        let places = times.iter().take(MOST_MARKED).map(|t| panel.at(printed(along, *t), panel.y.to).x);
        // the first have their names, and one name stands for the others
        let rest = times.len().saturating_sub(FIRST);
        let text = |i: usize| match i {
            _ if i < FIRST || rest == 1 => vec![name.to_owned()],
            FIRST => vec![format!("{name} ×{rest}")],
            _ => Vec::new(),
        };
        let names = places.enumerate().map(|(i, x)| (x, text(i)));
        marks.extend(names);
        if named && !times.is_empty() {
            let shown = times.iter().take(MOST_DESCRIBED).map(|t| scene.place_text(along, *t));
            let more = if times.len() > MOST_DESCRIBED { ", …" } else { "" };
            drawing.description += &format!("{name} at {}{more}. ", shown.collect::<Vec<_>>().join(", "));
        }
    }
    marks.sort_by(|a, b| a.0.total_cmp(&b.0));
    marks.dedup_by(|next, before| {
        let same = next.0 - before.0 < TOGETHER;
        if same {
            before.1.append(&mut next.1);
        }
        same
    });
    drawing.begin("events", "");
    for (x, _) in &marks {
        drawing.line(Style::Dashed, Vec2::new(*x, panel.bottom()), Vec2::new(*x, panel.top));
    }
    let (mut right, mut told) = (f64::NEG_INFINITY, Vec::new());
    for (x, names) in marks.iter().filter(|mark| named && !mark.1.is_empty()) {
        let text = Text::upright(&names.join(", "));
        let half = 0.5 * text.bounds(LETTERS).size().x;
        let is_new = names.iter().any(|name| !told.contains(name));
        if x - half < right + APART && !is_new {
            continue;
        }
        told.extend(names.iter().cloned());
        right = x + half;
        let at = Vec2::new(*x, panel.top);
        drawing.label(Label::at(text, LETTERS, at, 0.6).towards(Vec2::new(0.0, -1.0)).ranked(1));
    }
    drawing.end();
}
