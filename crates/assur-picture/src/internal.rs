//! Forces inside the links that the file asks for: each link with its normal force, shear force and bending moment below it.

use crate::diagram::{Axis, LETTERS, Line, Panel, printed, with_unit};
use crate::scene::Scene;
use crate::{no_diagram, words};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{AlongLink, Cut, Internal, InternalPart, LinkId, Query, Value};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// Width and height of a panel, mm, from one to the next, and the height of the link above them.
const SIZE: Vec2 = Vec2 { x: 130.0, y: 30.0 };
const BETWEEN: f64 = 12.0;
/// Height of a panel in which all is zero, mm.
const ZERO: f64 = 8.0;
const LINK: f64 = 16.0;
/// Parts into which a piece of a curve is divided.
const PARTS: u16 = 24;

/// The internal forces of all links that are asked for.
///
/// # Errors
/// The file asks for none.
pub fn internal(scene: &Scene<'_>) -> Result<Vec<Drawing>, Diagnosis> {
    let links = scene.mechanism().asked_inside();
    if links.is_empty() {
        return Err(no_diagram::no_internal(scene));
    }
    Ok(links.into_iter().map(|link| of_link(scene, link)).collect())
}

fn of_link(scene: &Scene<'_>, link: LinkId) -> Drawing {
    let name = &scene.mechanism().link(link).name;
    let title = format!("{}: forces inside {name}", words::title(scene));
    let mut drawing = Drawing::new(&words::id(scene, &format!("internal-{name}")), title, String::new());
    let along = scene.mechanism().display_of(Dimension::LENGTH);
    let [begin, end] = scene.view().reach(link);
    let x = Axis::between(printed(&along, begin), printed(&along, end), 13.0, false);
    let mut top = LINK;
    for part in InternalPart::ALL {
        let below = (part == InternalPart::Moment).then(|| with_unit(Text::italic("x"), "", &along.unit));
        top += curve(scene, &mut drawing, (link, part), (top, x, below)) + BETWEEN;
    }
    points(scene, &mut drawing, link, x);
    drawing
}

/// The link as a line with its points, above the panels.
fn points(scene: &Scene<'_>, drawing: &mut Drawing, link: LinkId, x: Axis) {
    let along = scene.mechanism().display_of(Dimension::LENGTH);
    let place = |at: f64| Vec2::new(x.share(printed(&along, at)) * SIZE.x, 0.4 * LINK);
    let link = scene.mechanism().link(link);
    drawing.begin("link", &link.name);
    let [begin, end] = link.extent();
    drawing.line(Style::Medium, place(begin), place(end));
    for point in &link.points {
        let at = place(link.on_axis(point.at).x);
        drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: 0.7 });
        let label = Label::at(Text::name(&point.name), LETTERS, at, 0.8);
        drawing.label(label.towards(Vec2::new(0.0, -1.0)).ranked(2));
    }
    drawing.end();
}

/// One of the forces along a link, with its extremes; the height of its panel.
fn curve(
    scene: &Scene<'_>,
    drawing: &mut Drawing,
    (link, part): (LinkId, InternalPart),
    (top, x, below): (f64, Axis, Option<Text>),
) -> f64 {
    let (mechanism, view) = (scene.mechanism(), scene.view());
    let along = mechanism.display_of(Dimension::LENGTH);
    let dimension = if part == InternalPart::Moment { Dimension::TORQUE } else { Dimension::FORCE };
    let display = mechanism.display_of(dimension);
    let answer = |greatest: bool, place: bool| {
        let at = Cut::Extreme(AlongLink { greatest, place });
        match view.query(&Query::Internal(Internal { link, part, at })) {
            Value::Scalar(x) => x,
            _ => f64::NAN,
        }
    };
    let extremes = [false, true].map(|greatest| (answer(greatest, true), answer(greatest, false)));
    let [least, greatest] = extremes.map(|(_, value)| printed(&display, value));
    let y = Axis::around(least.min(0.0), greatest.max(0.0), 4.0);
    let height = if y.is_of_nothing() { ZERO } else { SIZE.y };
    let panel = Panel { top, size: Vec2::new(SIZE.x, height), x, y };
    panel.draw(drawing, with_unit(Text::italic(part.name()), &panel.y.power_text(), &display.unit), below);
    drawing.begin("curve", part.name());
    let points = curve_points(scene, link, part).into_iter();
    let line: Line = points.map(|(x, y)| (printed(&along, x), printed(&display, y))).collect();
    panel.curve(drawing, Style::Medium, &[line]);
    for (i, (place, value)) in extremes.into_iter().enumerate() {
        if value.abs() > 0.0 {
            let at = panel.dot(drawing, printed(&along, place), printed(&display, value));
            let label = Label::at(Text::upright(&scene.value_text(&display, value)), LETTERS, at, 0.8);
            drawing.label(label.towards(Vec2::new(0.0, if i == 0 { 1.0 } else { -1.0 })).ranked(2));
        }
    }
    drawing.end();
    let said = extremes.map(|(place, value)| {
        format!("{} at {}", scene.value_text(&display, value), scene.value_text(&along, place))
    });
    drawing.description += &format!("{}: least {}, greatest {}. ", part.name(), said[0], said[1]);
    height
}

/// Places and values, piece by piece; where something acts at a place both sides of it.
fn curve_points(scene: &Scene<'_>, link: LinkId, part: InternalPart) -> Vec<(f64, f64)> {
    let view = scene.view();
    let [begin, end] = view.reach(link);
    let mut points = vec![(begin, 0.0)];
    let mut from = begin;
    while from < end {
        let to = view.next_place(link, from);
        let [first, .., last] = view.piece(link, [from, to]);
        points.push((from, first.part(part)));
        for i in 1..PARTS {
            let x = from + (to - from) * f64::from(i) / f64::from(PARTS);
            points.push((x, view.section(link, x).part(part)));
        }
        points.push((to, last.part(part)));
        from = to;
    }
    points.push((end, 0.0));
    points
}
