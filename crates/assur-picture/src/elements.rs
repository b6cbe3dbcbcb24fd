//! Machine elements that a file asks a formula of: the friction of a journal and of a thrust bearing, a belt that is about to slip,
//! a screw that raises or lowers a load. Each is a sketch on which the letters of its formula are seen.

use crate::figures::plain;
use crate::scene::Subject;
use crate::symbol::{arrow, hinge};
use assur_drawing::{Drawing, Label, Level, Role, Shape, Style, Text, on_circle};
use assur_math::math::Vec2;
use assur_model::model::{FormulaCall, FormulaFunction as Function};
use assur_text::diagnostic::Diagnosis;
use std::f64::consts::{FRAC_PI_2, PI};

/// Radius of the circle of a journal, a ring or a pulley, mm.
const RADIUS: f64 = 24.0;
/// Length of an arrow of a force, and of the base of an unrolled thread, mm.
const ARROW: f64 = 17.0;
const BASE: f64 = 90.0;
const NAMES: f64 = 4.2;

/// A picture per formula.
///
/// # Errors
/// The file asks for none.
pub fn elements(subject: &Subject<'_, '_>) -> Result<Vec<Drawing>, Diagnosis> {
    let all = &subject.mechanism.formulas;
    if all.is_empty() {
        let why =
            "there is no machine element to draw: the file has no formula of a bearing, a belt or a screw";
        return Err(Diagnosis::error("mech::picture::no_elements", why)
            .help("ask for one: `find journal_torque(load = 5 kN, radius = 40 mm, friction = 0.1)`"));
    }
    Ok(all.iter().enumerate().map(|(i, call)| picture(subject, i, call)).collect())
}

fn picture(subject: &Subject<'_, '_>, index: usize, call: &FormulaCall) -> Drawing {
    let (words, draw): (&str, fn(&mut Drawing, &FormulaCall)) = match call.function {
        Function::JournalTorque => ("journal", journal),
        Function::ThrustTorque => ("thrust bearing", thrust),
        Function::BeltRatio => ("belt about to slip", belt),
        _ => ("thread of a screw, unrolled", screw),
    };
    let title = format!("{}: {words}", subject.title());
    let id = subject.id(&format!("elements-{}", index + 1));
    let mut drawing = Drawing::new(&id, title, String::new());
    draw(&mut drawing, call);
    let numbers = numbers(call);
    drawing.description = format!("{}.", numbers.plain());
    drawing.caption(numbers);
    drawing
}

/// `F = 5000 N,  r = 20 mm,  f = 0.12,  M = 12 N·m`
fn numbers(call: &FormulaCall) -> Text {
    let (degree, one) = (1_f64.to_radians(), 1.0);
    let letters = [
        ("load", "F", one, " N"),
        ("radius", "r", 1e-3, " mm"),
        ("outer", "R", 1e-3, " mm"),
        ("inner", "r", 1e-3, " mm"),
        ("diameter", "d", 1e-3, " mm"),
        ("lead", "h", 1e-3, " mm"),
        ("friction", "f", one, ""),
        ("wrap", "θ", degree, "°"),
        ("groove", "γ", degree, "°"),
        ("flank", "β", degree, "°"),
    ];
    let shown = letters
        .iter()
        .filter_map(|(name, letter, unit, text)| Some((*letter, call.value(name)? / unit, *text)));
    let is_ratio = call.function == Function::BeltRatio;
    let (letter, unit) = if is_ratio { ("F", "") } else { ("M", " N·m") };
    let mut text = Text::default();
    for (i, (letter, value, unit)) in shown.chain([(letter, call.result, unit)]).enumerate() {
        text = text.and(if i > 0 { ",  " } else { "" }, false, Level::Base).and(letter, true, Level::Base);
        if is_ratio && letter == "F" {
            text = text.lowered("1").and("/", false, Level::Base).and("F", true, Level::Base).lowered("2");
        }
        text = text.and(&format!(" = {}{unit}", plain(value)), false, Level::Base);
    }
    text
}

/// A force with its letter at its tail or its head.
fn force(drawing: &mut Drawing, style: Style, [from, to]: [Vec2; 2], name: Text, at_head: bool) {
    drawing.begin("vector", &name.plain());
    drawing.mark(style, Shape::Arrow(from, to));
    let (at, away) = if at_head { (to, to - from) } else { (from, from - to) };
    drawing.label(Label::at(name, NAMES, at, 0.8).towards(away).coloured(style.text_role()).ranked(1));
    drawing.end();
}

/// A radius with its letter, at an angle of paper.
fn radius(drawing: &mut Drawing, centre: Vec2, length: f64, angle: f64, name: Text) {
    let end = on_circle(centre, length, angle);
    drawing.line(Style::Thin, centre, end);
    drawing.label(Label::along(name, NAMES, centre, end).ranked(2));
}

fn turning(drawing: &mut Drawing, centre: Vec2, radius: f64) {
    arrow::turn(drawing, Style::Drive, centre, radius, (PI, 1.0), true);
    let at = on_circle(centre, radius, PI);
    drawing.label(
        Label::at(Text::italic("ω"), NAMES, at, 1.0)
            .towards(Vec2::new(-1.0, 0.0))
            .coloured(Role::Blue)
            .ranked(2),
    );
}

/// The load at the centre, the reaction on the circle of friction.
fn journal(drawing: &mut Drawing, call: &FormulaCall) {
    let centre = Vec2::zero();
    let rho = RADIUS * call.result / (call.must("load") * call.must("radius"));
    for (style, radius) in
        [(Style::Medium, RADIUS), (Style::Medium, RADIUS + 1.2), (Style::FrictionCircle, rho)]
    {
        drawing.mark(style, Shape::Circle { centre, radius });
    }
    let hatch = (0..36).map(|i| {
        let angle = f64::from(i) * PI / 18.0;
        (on_circle(centre, RADIUS + 1.2, angle), on_circle(centre, RADIUS + 3.2, angle + 0.06))
    });
    drawing.mark(Style::Thin, Shape::Strokes(hatch.collect()));
    turning(drawing, centre, 0.72 * RADIUS);
    let (down, left) = (Vec2::new(0.0, ARROW), Vec2::new(-rho, 0.0));
    force(drawing, Style::Force, [centre, down], Text::italic("F"), true);
    // its moment about the centre is against the turn
    force(drawing, Style::Unknown, [left + down * 1.2, left + down * 0.2], Text::italic("R"), false);
    radius(drawing, centre, RADIUS, -FRAC_PI_2 + 0.9, Text::italic("r"));
    let at = on_circle(centre, rho, -FRAC_PI_2 - 0.7);
    drawing.label(Label::at(Text::italic("ρ"), NAMES, at, 0.6).towards(at).coloured(Role::Blue).ranked(2));
}

/// The shaft on its ring from the side, and the ring from above.
fn thrust(drawing: &mut Drawing, call: &FormulaCall) {
    let share = call.value("inner").unwrap_or(0.0) / call.must("outer");
    let inner = RADIUS * share;
    let corner = |x: f64, y: f64| Vec2::new(x, y);
    drawing.mark(
        Style::Block,
        Shape::polygon(vec![
            corner(-RADIUS, 0.0),
            corner(RADIUS, 0.0),
            corner(RADIUS, -7.0),
            corner(-RADIUS, -7.0),
        ]),
    );
    let neck = (0.5 * RADIUS).max(inner.min(0.9 * RADIUS));
    for x in [-neck, neck] {
        drawing.line(Style::Medium, corner(x, -7.0), corner(x, -20.0));
    }
    hinge::hatch(drawing, corner(-RADIUS - 4.0, 0.0), corner(RADIUS + 4.0, 0.0), Vec2::new(0.0, 1.0));
    drawing.line(Style::Medium, corner(-RADIUS - 4.0, 0.0), corner(RADIUS + 4.0, 0.0));
    drawing.line(Style::Axis, corner(0.0, -26.0), corner(0.0, 5.0));
    force(drawing, Style::Force, [corner(0.0, -24.0 - ARROW), corner(0.0, -22.0)], Text::italic("F"), false);
    let centre = Vec2::new(0.0, RADIUS + 12.0);
    for radius in [RADIUS, inner] {
        if radius > 0.0 {
            drawing.mark(Style::Medium, Shape::Circle { centre, radius });
        }
    }
    radius(drawing, centre, RADIUS, -0.5, Text::italic("R"));
    if inner > 0.0 {
        radius(drawing, centre, inner, 0.8, Text::italic("r"));
    }
    turning(drawing, centre, 0.5 * (RADIUS + inner));
}

/// The pulley with the arc on which the belt lies, and the pulls.
fn belt(drawing: &mut Drawing, call: &FormulaCall) {
    let (centre, half) = (Vec2::zero(), 0.5 * call.must("wrap").min(2.0 * PI));
    drawing.mark(Style::Medium, Shape::Circle { centre, radius: RADIUS });
    hinge::support(drawing, centre);
    hinge::moving(drawing, centre);
    let belt = RADIUS + 0.9;
    drawing
        .mark(Style::Link, Shape::Arc { centre, radius: belt, from: -FRAC_PI_2 - half, sweep: 2.0 * half });
    let ratio = call.result.clamp(1.0, 3.0);
    for (side, length, index) in [(-1.0, ARROW, "1"), (1.0, ARROW / ratio, "2")] {
        let angle = -FRAC_PI_2 + side * half;
        let (from, along) = (on_circle(centre, belt, angle), Vec2::direction(angle + side * FRAC_PI_2));
        let end = from + along * 12.0;
        drawing.line(Style::Link, from, end);
        force(drawing, Style::Force, [end, end + along * length], Text::italic("F").lowered(index), true);
        drawing.line(Style::Thin, centre, from);
    }
    let from = -FRAC_PI_2 - half;
    drawing.mark(Style::Thin, Shape::Arc { centre, radius: 11.0, from, sweep: 2.0 * half });
    let top = Vec2::new(0.0, -11.0);
    drawing.label(Label::at(Text::italic("θ"), NAMES, top, 0.6).towards(top).ranked(2));
    turning(drawing, centre, 0.75 * RADIUS);
}

/// The turn of a thread as an inclined plane, with the load, the force along the circumference and the reaction.
fn screw(drawing: &mut Drawing, call: &FormulaCall) {
    let lead = libm::atan(call.must("lead") / (PI * call.must("diameter")));
    let friction = libm::atan(call.must("friction") / libm::cos(call.value("flank").unwrap_or(0.0)));
    let raises = call.function == Function::RaisingTorque;
    let (foot, top) = (Vec2::new(BASE, 0.0), Vec2::new(BASE, -BASE * libm::tan(lead)));
    drawing.mark(Style::Plate, Shape::polygon(vec![Vec2::zero(), foot, top]));
    let name = |text: Text, from, to| Label::along(text, NAMES, from, to).ranked(2);
    drawing.label(name(Text::upright("π").and("d", true, Level::Base), Vec2::zero(), foot));
    drawing.label(name(Text::italic("h"), foot, top));
    let arc = 26.0;
    drawing.mark(Style::Thin, Shape::Arc { centre: Vec2::zero(), radius: arc, from: 0.0, sweep: -lead });
    let at = on_circle(Vec2::zero(), arc, -0.5 * lead);
    drawing.label(Label::at(Text::italic("λ"), NAMES, at, 0.8).towards(Vec2::new(1.0, 0.0)).ranked(2));
    let (along, normal) = (Vec2::direction(-lead), Vec2::direction(-lead - FRAC_PI_2));
    let on = along * (0.5 * BASE / libm::cos(lead));
    let block = [(-7.0, 0.0), (7.0, 0.0), (7.0, 9.0), (-7.0, 9.0)];
    drawing.mark(Style::Block, Shape::polygon(block.map(|(x, y)| on + along * x + normal * y).to_vec()));
    let middle = on + normal * 4.5;
    force(
        drawing,
        Style::Force,
        [middle - Vec2::new(0.0, ARROW + 9.0), middle - Vec2::new(0.0, 6.5)],
        Text::italic("F"),
        false,
    );
    let push = if raises { 1.0 } else { -call.result.signum() };
    let tail = middle - Vec2::new(push * 9.0, 0.0);
    force(
        drawing,
        Style::Drive,
        [tail - Vec2::new(push * ARROW, 0.0), tail],
        Text::italic("F").lowered("t"),
        false,
    );
    drawing.line(Style::Axis, on - normal * 24.0, on + normal * 24.0);
    // friction is against the way along the plane
    let leaning = if raises { -friction } else { friction };
    let reaction = Vec2::direction(-lead - FRAC_PI_2 + leaning);
    force(drawing, Style::Unknown, [on - reaction * 22.0, on], Text::italic("R"), false);
    let from = FRAC_PI_2 - lead;
    drawing.mark(Style::Thin, Shape::Arc { centre: on, radius: 14.0, from, sweep: leaning });
    let at = on_circle(on, 14.0, from + 0.5 * leaning);
    drawing.label(Label::at(Text::italic("ρ"), NAMES, at, 0.6).towards(at - on).ranked(2));
}
