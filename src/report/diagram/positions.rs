//! What a position takes: each effect on top of those before it, and digits.

use super::{LEFT, NUMBERS, RIGHT, WORDS, head, paragraph, written};
use crate::report::cost::{digits, part, time};
use crate::report::tradeoff::{in_short, most_saved, prices};
use assur_drawing::{Drawing, Role, Shape, Style, Theme};
use assur_math::math::Vec2;
use assur_position::plan::Precision;
use assur_solve::measure::accuracy::{AccuracyStudy, PositionChoice};

/// What is left of the bars, for their names, and the longest bar, mm.
const NAMES: f64 = 43.0;
const LONGEST: f64 = 45.0;
/// From bar to bar, and their height.
const STEP: f64 = 6.6;
const THICK: f64 = 4.4;
/// The longest bar of digits is that of the file; a bar that would be longer than this multiple of it is an arrow.
const FILE: f64 = 20.0;
const FAR: f64 = 2.5;

fn bar(drawing: &mut Drawing, style: Style, (from, to): (f64, f64), y: f64) {
    let corners = [(from, y), (to, y), (to, y + THICK), (from, y + THICK)];
    drawing.mark(style, Shape::polygon(corners.map(|(x, y)| Vec2::new(x, y)).to_vec()));
}

/// A bar without scale: it goes on.
fn arrow(drawing: &mut Drawing, style: Style, y: f64) {
    let (long, tip, half) = (LONGEST - 3.0, LONGEST, 0.5 * THICK);
    let corners = [(0.0, y), (long, y), (tip, y + half), (long, y + THICK), (0.0, y + THICK)];
    drawing.mark(style, Shape::polygon(corners.map(|(x, y)| Vec2::new(x, y)).to_vec()));
}

/// Name before a bar and words after it.
fn around(drawing: &mut Drawing, name: &str, words: &str, end: f64, y: f64) {
    let middle = y + 0.5 * THICK;
    written(drawing, name, (WORDS, Role::Ink), Vec2::new(-1.2, middle), LEFT);
    written(drawing, words, (NUMBERS, Role::Ink), Vec2::new(end + 1.0, middle), RIGHT);
}

fn style_of(effect: &str) -> Style {
    match effect {
        "positions" | "velocities" | "accelerations" => Style::BlueDot,
        "loads" | "reactions" => Style::GreenDot,
        _ => Style::VermilionDot,
    }
}

/// The picture of a study of positions; `None` where nothing is computed.
#[must_use]
pub fn svg(title: &str, study: &AccuracyStudy) -> Option<String> {
    let own = study.choices.first()?;
    let title = format!("What accuracy and effects cost: {title}");
    let finding = sentence(study, own);
    let mut drawing = Drawing::new("accuracy", title.clone(), finding.clone());
    head(&mut drawing, &title, &finding, -NAMES, 0.0);
    let mut y = 4.0;
    effects(&mut drawing, study, own, &mut y);
    y += 3.0;
    accuracies(&mut drawing, study, own, &mut y);
    if own.cycle.is_some() {
        y += 3.0;
        functions(&mut drawing, study, &mut y);
    }
    Some(drawing.placed().svg(Theme::Auto))
}

/// What the picture shows, in one sentence.
fn sentence(study: &AccuracyStudy, own: &PositionChoice) -> String {
    let fewer = most_saved(study).map_or_else(
        || "fewer would save nothing".to_owned(),
        |saved| format!("fewer save {} of the work at most", part(saved)),
    );
    let twice = study.choices.iter().find(|choice| choice.settings.scalar == Precision::DoubleDouble);
    let twice = twice.map_or_else(String::new, |twice| {
        format!(", double-double takes {} as long", part(twice.micros / own.micros))
    });
    format!("{} digits take {} a position; {fewer}{twice}.", digits(own.error), time(own.micros))
}

/// Each effect after those before it.
fn effects(drawing: &mut Drawing, study: &AccuracyStudy, own: &PositionChoice, y: &mut f64) {
    let top = *y;
    let mut before = 0.0;
    for (i, (name, micros)) in prices(study).into_iter().enumerate() {
        let [from, to] = [before, before + micros].map(|time| LONGEST * time / own.micros);
        if i > 0 {
            bar(drawing, Style::Want, (0.0, from), *y);
        }
        bar(drawing, style_of(name), (from, to), *y);
        before += micros;
        let (name, words) = match i {
            0 => (name.to_owned(), time(before)),
            _ => (format!("+ {name}"), format!("{} (+{})", time(before), time(micros))),
        };
        around(drawing, &name, &words, to, *y);
        *y += STEP;
    }
    drawing.line(Style::Medium, Vec2::new(0.0, top - 1.0), Vec2::new(0.0, *y - STEP + THICK + 1.0));
    *y += 2.5;
    let note = "Time of one position; pale: the effects above. What is not asked for is not computed.";
    paragraph(drawing, note, (NUMBERS, Role::Grey), -NAMES, y);
}

/// What fewer and more digits take.
fn accuracies(drawing: &mut Drawing, study: &AccuracyStudy, own: &PositionChoice, y: &mut f64) {
    for i in in_short(study) {
        let choice = &study.choices[i];
        let ratio = choice.micros / own.micros;
        // samples alone make the difference
        if i > 0 && ratio > 0.995 && ratio < 1.005 {
            continue;
        }
        let numbers = match (choice.within, choice.settings.scalar) {
            (_, Precision::DoubleDouble) => "double-double",
            (None, _) => "f64",
            _ => "looser",
        };
        let name = format!("{numbers}, {} digits", digits(choice.error));
        let style = if i == 0 { Style::Solid } else { Style::Block };
        let end = if ratio > FAR {
            arrow(drawing, style, *y);
            LONGEST
        } else {
            bar(drawing, style, (0.0, FILE * ratio), *y);
            FILE * ratio
        };
        let words = match i {
            0 => format!("{}, this file", time(choice.micros)),
            _ if ratio > FAR => format!("{} as long", part(ratio)),
            _ => format!("{}, {}", time(choice.micros), part(ratio)),
        };
        around(drawing, &name, &words, end, *y);
        *y += STEP;
    }
}

/// What functions over the sweep take.
fn functions(drawing: &mut Drawing, study: &AccuracyStudy, y: &mut f64) {
    let all: Vec<&PositionChoice> = in_short(study).into_iter().map(|i| &study.choices[i]).collect();
    let times = || all.iter().filter_map(|choice| choice.cycle);
    let longest = times().map(|cycle| cycle.1).fold(0.0, f64::max);
    for choice in &all {
        let Some((samples, micros)) = choice.cycle else { continue };
        let end = LONGEST * micros / longest;
        bar(drawing, if choice.within.is_none() { Style::Solid } else { Style::Block }, (0.0, end), *y);
        around(
            drawing,
            &format!("{samples} samples"),
            &format!("{}, {} digits", time(micros), digits(choice.error)),
            end,
            *y,
        );
        *y += STEP;
    }
    *y += 2.5;
    paragraph(
        drawing,
        "Functions over the sweep: mean, integral, flywheel.",
        (NUMBERS, Role::Grey),
        -NAMES,
        y,
    );
}
