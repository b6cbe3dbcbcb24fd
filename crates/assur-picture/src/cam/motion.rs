//! The motion of a follower over a turn of its cam: lift, its first and second derivative, the pressure angle, stages.

use crate::diagram::{Axis, LETTERS, Line, Panel, printed, scaled, with_unit};
use crate::figures::{cleared, place, value_text};
use crate::scene::Subject;
use assur_drawing::{Drawing, Label, Level, Shape, Style, Text};
use assur_math::element::cam::{CamPoint, Quantity};
use assur_math::math::Vec2;
use assur_model::model::{CamPart, Display, PlateCam};
use std::f64::consts::TAU;

/// Width and height of a panel, from panel to panel, room for the names of the stages, mm.
const PANEL: Vec2 = Vec2::new(150.0, 29.0);
const BETWEEN: f64 = 10.0;
const STAGES: f64 = 7.0;
/// Points of a curve per part of the motion.
const POINTS: u32 = 48;

struct CurveOfLaw {
    quantity: Quantity,
    /// What it is multiplied by: powers of the speed.
    factor: f64,
    title: Text,
    said: &'static str,
    display: Display,
    style: Style,
}

/// The motion of a cam's follower.
pub fn motion(subject: &Subject<'_, '_>, plate: &PlateCam) -> Drawing {
    let title = format!("{}: motion of the follower of the cam {}", subject.title(), plate.name);
    let id = format!("{}-motion-{}", subject.id("cam"), plate.name);
    let mut drawing = Drawing::new(&id, title, String::new());
    let along = Display { unit: "deg".to_owned(), factor: 1f64.to_radians(), ..Display::default() };
    let x = Axis::between(0.0, 360.0, 13.0, true);
    let all = shown(subject, plate);
    let mut top = STAGES;
    let mut first: Option<Panel> = None;
    for (i, shown) in all.iter().enumerate() {
        let line = line(plate, shown);
        let (least, greatest) = [false, true].map(|most| plate.cam.extreme(shown.quantity, most)).into();
        let [low, high] = [least.1, greatest.1].map(|si| printed(&shown.display, si * shown.factor));
        let y = Axis::around(low, high, 4.0);
        let panel = Panel { top, size: PANEL, x, y };
        let below = (i + 1 == all.len()).then(|| with_unit(Text::italic("φ"), "", "deg"));
        let title = with_unit(shown.title.clone(), &y.power_text(), &shown.display.unit);
        panel.draw(&mut drawing, title, below);
        drawing.begin("curve", shown.said);
        panel.curve(&mut drawing, shown.style, &[scaled(&line, &along, &shown.display)]);
        let large = least.1.abs().max(greatest.1.abs()) * shown.factor.abs();
        for ((phi, value), towards) in [(greatest, -1.0), (least, 1.0)] {
            let (phi, si) = (place(phi, TAU), cleared(value * shown.factor, large));
            drawing.description += &format!(
                "{} {} {} at {}. ",
                if towards < 0.0 { "Greatest" } else { "Least" },
                shown.said,
                value_text(&shown.display, si),
                value_text(&along, phi)
            );
            // a dwell at null needs no number
            if si.abs() > 1e-9 * (high - low).abs() * shown.display.factor.max(f64::MIN_POSITIVE) {
                let at = panel.at(printed(&along, phi), printed(&shown.display, si));
                drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: 0.6 });
                let text = Text::upright(&value_text(&shown.display, si));
                let label = Label::at(text, 3.0, at, 0.8).towards(Vec2::new(0.4, towards));
                drawing.label(label.coloured(shown.style.text_role()).ranked(3));
            }
        }
        drawing.end();
        first.get_or_insert(panel);
        top += PANEL.y + BETWEEN;
    }
    if let Some(first) = first {
        stages(&mut drawing, plate, &first, top - BETWEEN);
    }
    drawing
}

/// The numbers shown: by time where the cam has a speed, else by its angle.
fn shown(subject: &Subject<'_, '_>, plate: &PlateCam) -> Vec<CurveOfLaw> {
    let oscillates = plate.cam.follower.oscillates();
    let timed = plate.speed.is_some();
    let letter = if oscillates { "ψ" } else { "s" };
    let display = |part: CamPart| subject.mechanism.display_of(part.dimension(oscillates));
    let by_angle = |order: &str| {
        Text::upright("d")
            .and(order, false, Level::Sup)
            .and(letter, true, Level::Base)
            .and("/d", false, Level::Base)
            .and("φ", true, Level::Base)
            .and(order, false, Level::Sup)
    };
    let of = |n: u8, title: Text, said, style| {
        let part = if n > 0 && timed { CamPart::Rate(n) } else { CamPart::Lift(n) };
        let factor = if timed { plate.rate(n) } else { 1.0 };
        CurveOfLaw { quantity: Quantity::Lift(n), factor, title, said, display: display(part), style }
    };
    let rates = if oscillates { ["ω", "ε"] } else { ["v", "a"] };
    let titles = if timed { rates.map(Text::italic) } else { [by_angle(""), by_angle("2")] };
    let [first, second] = titles;
    let said = if timed { ["velocity", "acceleration"] } else { ["first derivative", "second derivative"] };
    vec![
        of(0, Text::italic(letter), "lift", Style::Curve1),
        of(1, first, said[0], Style::Velocity),
        of(2, second, said[1], Style::Acceleration),
        CurveOfLaw {
            quantity: Quantity::PressureAngle,
            factor: 1.0,
            title: Text::italic("α"),
            said: "pressure angle",
            display: display(CamPart::PressureAngle),
            style: Style::Unknown,
        },
    ]
}

/// The curve of a number, part by part: where it jumps, both values stand at one place.
fn line(plate: &PlateCam, shown: &CurveOfLaw) -> Line {
    let mut line = Line::new();
    for part in plate.cam.program.parts() {
        for i in 0..=POINTS {
            let phi = part.from + (part.to - part.from) * f64::from(i) / f64::from(POINTS);
            let at: CamPoint = plate.cam.on_part(&part, phi);
            line.push((phi.min(TAU), at.value(shown.quantity) * shown.factor));
        }
    }
    line
}

/// Lines between the stages, and their names.
fn stages(drawing: &mut Drawing, plate: &PlateCam, first: &Panel, bottom: f64) {
    let mut all: Vec<(&'static str, f64, f64)> = Vec::new();
    for phase in plate.cam.program.phases() {
        let name = match phase.change {
            change if change > 0.0 => "rise",
            change if change < 0.0 => "fall",
            _ => "dwell",
        };
        let to = phase.start + phase.angle;
        match all.last_mut() {
            Some(last) if last.0 == name => last.2 = to,
            _ => all.push((name, phase.start, to)),
        }
    }
    drawing.begin("stages", "");
    let place = |phi: f64| phi / TAU * PANEL.x;
    for (name, from, to) in &all {
        if *to < TAU - 1e-9 {
            let x = place(*to);
            drawing.line(Style::Dashed, Vec2::new(x, first.top - 3.0), Vec2::new(x, bottom));
        }
        let middle = Vec2::new(place(0.5 * (from + to)), first.top - 4.0);
        drawing.label(
            Label::at(Text::upright(name), LETTERS, middle, 0.0).towards(Vec2::new(0.0, -1.0)).ranked(2),
        );
    }
    drawing.end();
    let named = all.iter().map(|(name, from, to)| {
        format!("{name} from {}° to {}°", round(from.to_degrees()), round(to.to_degrees()))
    });
    drawing.description += &format!("Stages: {}.", named.collect::<Vec<_>>().join(", "));
}

fn round(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}
