//! Numbers over the sweep, or over time: a panel per unit, curves told apart by dashes and colour, extremes as the solver finds them.

use crate::diagram::{
    Axis, Curve, LETTERS, Line, Panel, drive_axis, drive_label, over_poses, printed, scaled, with_unit,
};
use crate::figures::{cleared, unit_text};
use crate::scene::{Scene, marked_events};
use crate::{no_diagram, words};
use assur_drawing::{CURVES, Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Axis as Component, Display, Expr, FindKind, Value};
use assur_solve::solve::{CourseSet, OverTime, courses, over_time};
use assur_text::diagnostic::Diagnosis;

/// Width of a panel, mm, and the height of one, two and more.
const WIDTH: f64 = 150.0;
const HEIGHTS: [f64; 3] = [75.0, 50.0, 36.0];
/// Height of a panel in which all is zero, mm.
const ZERO: f64 = 12.0;
/// A curve that changes by less than this part of its value is flat.
const FLAT: f64 = 1e-4;
/// From panel to panel, and for a line of names above one.
const BETWEEN: f64 = 11.0;
const LEGEND: f64 = 5.5;
/// Steps of the axes, about.
const STEPS: [f64; 3] = [8.0, 6.0, 4.0];
/// Sample of a curve before its name, mm, and from name to name.
const SAMPLE: f64 = 11.0;
const APART: f64 = 6.0;
/// The longest name, letters.
const LONGEST: usize = 44;

/// A number that is plotted.
pub struct Item {
    plain: String,
    name: Text,
    display: Display,
    expr: Expr,
}

/// A panel with what it shows.
struct Group<'i> {
    display: &'i Display,
    shown: Vec<(&'i Item, Curve)>,
}

/// The curves of a plot, for what is shown beside it.
pub struct Curves {
    along: Display,
    x: Axis,
    all: Vec<(String, Display, Curve)>,
}

impl Curves {
    /// Where a value of the drive is, from the left edge, mm.
    #[must_use]
    pub fn place(&self, drive: f64) -> f64 {
        self.x.share(printed(&self.along, drive)) * WIDTH
    }

    /// How many there are.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.all.len()
    }

    /// The name of one, and its number at a value of the drive: between the points of its curve.
    #[must_use]
    pub fn of(&self, index: usize, drive: f64) -> (&str, &Display, Option<f64>) {
        let (name, display, curve) = &self.all[index];
        (name, display, curve.at(drive))
    }
}

/// The plot of items of `find`, by their indices; of all that change where none is named.
///
/// # Errors
/// There is neither a sweep nor a motion, or nothing to plot.
pub fn plot(scene: &Scene<'_>, which: &[usize]) -> Result<(Drawing, Curves), Diagnosis> {
    let items = items(scene, which);
    if items.is_empty() {
        return Err(no_diagram::no_quantity(
            scene,
            "the file asks for no number that has a value at every position",
        ));
    }
    let (curves, events) = curves(scene, &items)?;
    let mut groups: Vec<Group<'_>> = Vec::new();
    for (item, curve) in items.iter().zip(curves).filter(|(_, curve)| !curve.lines.is_empty()) {
        let fits = |g: &&mut Group<'_>| {
            g.display.unit == item.display.unit
                && g.display.dimension == item.display.dimension
                && g.shown.len() < CURVES.len()
        };
        match groups.iter_mut().find(fits) {
            Some(group) => group.shown.push((item, curve)),
            None => groups.push(Group { display: &item.display, shown: vec![(item, curve)] }),
        }
    }
    if groups.is_empty() {
        return Err(no_diagram::no_quantity(scene, "nothing that is asked for has a value over the sweep"));
    }
    let title = format!("{}: {}", words::title(scene), listed(scene, &items));
    let mut drawing = Drawing::new(&words::id(scene, "plot"), title, String::new());
    let (along, x) = panels(scene, &mut drawing, &groups, &events);
    let all = groups.into_iter().flat_map(|group| group.shown);
    let all = all.map(|(item, curve)| (item.plain.clone(), item.display.clone(), curve)).collect();
    Ok((drawing, Curves { along, x, all }))
}

/// The curves of items, with the places of every event.
fn curves(scene: &Scene<'_>, items: &[Item]) -> Result<(Vec<Curve>, Vec<Vec<f64>>), Diagnosis> {
    let small = |item: &Item| scene.rounding(item.display.dimension);
    let exprs: Vec<(Expr, f64)> = items.iter().map(|item| (item.expr.clone(), small(item))).collect();
    match over_time(&scene.model, scene.solution, &exprs) {
        Ok(None) => {}
        Ok(Some(OverTime { courses, events })) => {
            return Ok((courses.into_iter().map(Curve::in_time).collect(), events));
        }
        // as the file itself does not
        Err(_) => return Err(no_diagram::no_quantity(scene, "the motion does not begin")),
    }
    let set = |(expr, rounding)| CourseSet { exprs: vec![expr], rounding };
    let sets: Vec<CourseSet> = exprs.into_iter().map(set).collect();
    let found = courses(&scene.model, &scene.solution.statics, &sets)
        .map_err(|cause| no_diagram::no_sweep(scene, "plot", &cause))?;
    let curves = items.iter().zip(found).map(|(item, found)| match found.as_deref() {
        Ok([course]) => Curve::of(course),
        _ => over_poses(scene, &item.expr),
    });
    // the curves run over the first drive
    let statics = &scene.solution.statics;
    let events = statics.swept.as_ref().filter(|swept| swept.drive == 0).map(|_| statics.events.clone());
    Ok((curves.collect(), events.unwrap_or_default()))
}

/// The numbers among the items of `find`; of a vector both components.
pub fn items(scene: &Scene<'_>, which: &[usize]) -> Vec<Item> {
    let view = scene.view();
    let mut items = Vec::new();
    for (i, find) in scene.mechanism().finds.iter().enumerate() {
        let FindKind::Value { expr, display, poseless } = &find.kind else { continue };
        if if which.is_empty() { *poseless } else { !which.contains(&i) } {
            continue;
        }
        let mut item = |plain: String, expr: Expr| {
            items.push(Item { name: name(&plain), plain, display: display.clone(), expr });
        };
        match view.value(expr) {
            Value::Scalar(_) => item(find.name.clone(), expr.clone()),
            Value::Vector(_) => {
                for (axis, letter) in [(Component::X, 'x'), (Component::Y, 'y')] {
                    item(format!("{}.{letter}", find.name), Expr::Component(Box::new(expr.clone()), axis));
                }
            }
            Value::Bool(_) => {}
        }
    }
    items
}

/// A name as a label; an expression as it is written.
fn name(plain: &str) -> Text {
    if plain.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '\'')) {
        return Text::name(plain);
    }
    if plain.chars().count() <= LONGEST {
        return Text::upright(plain);
    }
    let head: String = plain.chars().take(LONGEST - 1).collect();
    Text { full: Some(plain.to_owned()), ..Text::upright(&(head + "…")) }
}

fn listed(scene: &Scene<'_>, items: &[Item]) -> String {
    let names: Vec<&str> = items.iter().map(|item| item.plain.as_str()).collect();
    let over = if scene.mechanism().simulation.is_some() { "time" } else { "the sweep" };
    format!("{} over {over}", names.join(", "))
}

fn panels(
    scene: &Scene<'_>,
    drawing: &mut Drawing,
    groups: &[Group<'_>],
    events: &[Vec<f64>],
) -> (Display, Axis) {
    let of_count = (groups.len() - 1).min(2);
    let height = HEIGHTS[of_count];
    let along = drive_axis(scene);
    let all = groups.iter().flat_map(|g| &g.shown).flat_map(|(_, c)| c.lines.iter().flatten());
    let (from, to) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.0), b.max(p.0)));
    let x = Axis::between(printed(&along, from), printed(&along, to), 13.0, along.unit == "deg");
    let mut top = 0.0;
    for (i, group) in groups.iter().enumerate() {
        let is_last = i + 1 == groups.len();
        if group.shown.len() > 1 {
            top = legend(drawing, group, top);
        }
        let range = group.shown.iter().map(|(_, c)| c.range());
        let (least, most) =
            range.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), (c, d)| (a.min(c), b.max(d)));
        // what hardly changes is a flat line
        let most = if is_flat(least, most) { least } else { most };
        let y = Axis::around(printed(group.display, least), printed(group.display, most), STEPS[of_count]);
        let height = if y.is_of_nothing() { ZERO } else { height };
        let panel = Panel { top, size: Vec2::new(WIDTH, height), x, y };
        let below = is_last.then(|| with_unit(drive_label(scene), "", &along.unit));
        panel.draw(drawing, heading(group, &y), below);
        marked_events(scene, drawing, &panel, (&along, events), i == 0);
        for ((item, curve), style) in group.shown.iter().zip(CURVES) {
            drawing.begin("curve", &item.plain);
            let lines: Vec<Line> =
                curve.lines.iter().map(|line| scaled(line, &along, group.display)).collect();
            panel.curve(drawing, style, &lines);
            // what is rounding beside the others has no extremes
            let (low, high) = curve.range();
            if low.abs().max(high.abs()) > 1e-9 * least.abs().max(most.abs()) {
                extremes(scene, drawing, &panel, curve, (&along, group.display), style);
            }
            drawing.end();
            drawing.description += &said(scene, item, curve, &along);
        }
        top += height + BETWEEN;
    }
    (along, x)
}

/// Whether numbers between these two are one.
fn is_flat(least: f64, most: f64) -> bool {
    most - least <= FLAT * most.abs().max(least.abs())
}

/// The title of the vertical axis: name and unit of one curve, the unit alone of several.
fn heading(group: &Group<'_>, y: &Axis) -> Text {
    let unit = &group.display.unit;
    match group.shown.as_slice() {
        [(item, _)] => with_unit(item.name.clone(), &y.power_text(), unit),
        _ => Text::upright(&y.power_text()).unit(&unit_text(unit)),
    }
}

/// Samples of the curves with their names, line by line; where the panel begins.
fn legend(drawing: &mut Drawing, group: &Group<'_>, top: f64) -> f64 {
    drawing.begin("legend", "");
    let mut at = Vec2::new(22.0, top - 2.5);
    for ((item, _), style) in group.shown.iter().zip(CURVES) {
        let wide = item.name.bounds(LETTERS).size().x;
        if at.x > 22.0 && at.x + SAMPLE + wide > WIDTH {
            at = Vec2::new(22.0, at.y + LEGEND);
        }
        let end = at + Vec2::new(SAMPLE, 0.0);
        drawing.line(style, at, end);
        let label = Label::at(item.name.clone(), LETTERS, end, 1.0).towards(Vec2::new(1.0, 0.0)).ranked(0);
        drawing.label(label.coloured(style.text_role()));
        at.x = end.x + 2.0 + wide + APART;
    }
    drawing.end();
    at.y + LEGEND + 2.5
}

/// Dots at the least and the greatest value, with value and place.
fn extremes(
    scene: &Scene<'_>,
    drawing: &mut Drawing,
    panel: &Panel,
    curve: &Curve,
    (along, display): (&Display, &Display),
    style: Style,
) {
    let (low, high) = curve.range();
    if is_flat(low, high) {
        // its value, over its middle
        let line = curve.lines.iter().max_by_key(|line| line.len());
        if let Some((x, y)) = line.and_then(|line| line.get(line.len() / 2)) {
            let at = panel.at(printed(along, *x), printed(display, *y));
            let text = Text::upright(&scene.value_text(display, *y));
            drawing.label(
                Label::at(text, 3.0, at, 0.5)
                    .towards(Vec2::new(0.0, -1.0))
                    .coloured(style.text_role())
                    .ranked(3),
            );
        }
        return;
    }
    let large = largest(curve);
    for (extreme, towards) in [(curve.greatest, -1.0), (curve.least, 1.0)] {
        let Some((x, y)) = extreme else { continue };
        let y = cleared(y, large);
        let at = panel.at(printed(along, x), printed(display, y));
        drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: 0.7 });
        let text = format!("{} at {}", scene.value_text(display, y), scene.place_text(along, x));
        let label = Label::at(Text::upright(&text), 3.0, at, 0.9).towards(Vec2::new(0.3, towards));
        drawing.label(label.coloured(style.text_role()).ranked(3));
    }
}

/// The greatest magnitude on a curve: what is rounding beside it is 0.
fn largest(curve: &Curve) -> f64 {
    let (least, greatest) = curve.range();
    least.abs().max(greatest.abs())
}

/// `Mb: least −261.8 N·m at 120°, greatest 61.2 N·m at 301°. `
fn said(scene: &Scene<'_>, item: &Item, curve: &Curve, along: &Display) -> String {
    let large = largest(curve);
    let value = |y: f64| scene.value_text(&item.display, cleared(y, large));
    match (curve.least, curve.greatest) {
        (Some((x_1, y_1)), Some((x_2, y_2))) if !is_flat(y_1, y_2) => format!(
            "{}: least {} at {}, greatest {} at {}. ",
            item.plain,
            value(y_1),
            scene.place_text(along, x_1),
            value(y_2),
            scene.place_text(along, x_2)
        ),
        (Some((_, y)), _) => format!("{}: {} everywhere. ", item.plain, value(y)),
        _ => {
            let (least, greatest) = curve.range();
            format!("{}: from {} to {}. ", item.plain, value(least), value(greatest))
        }
    }
}
