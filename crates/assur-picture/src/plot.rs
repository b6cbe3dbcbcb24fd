//! Numbers over the sweep, or over time: a panel per unit, curves told apart by dashes and colour, extremes as the solver finds them.

use crate::diagram::{
    Axis, LETTERS, Line, PARTS, Panel, clipped, drive_axis, drive_label, printed, scaled, with_unit,
};
use crate::figures::{cleared, unit_text};
use crate::scene::{Scene, marked_events};
use crate::{no_diagram, words};
use assur_drawing::{CURVES, Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Axis as Component, Display, Expr, FindKind, LinkId, PairId, Value};
use assur_solve::answer::NoSweep;
use assur_solve::solve::{Cause, Course, CourseSet, Courses, DriveValue, Pose, PoseOrigin, courses};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::{Index, letter_of};

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
/// What curves that are cut go beyond their panel, as a part of it: rounding takes none off its edge.
const EDGE: f64 = 1e-4;
/// Radius of a dot at a position, and how near to one another there are none, mm.
const DOT: f64 = 0.6;
const DOTS: f64 = 2.5;
/// The longest name, letters.
const LONGEST: usize = 44;

/// A number that is plotted.
pub struct Item {
    plain: String,
    name: Text,
    display: Display,
    expr: Expr,
}

/// An item as it runs.
struct Curve<'i> {
    item: &'i Item,
    course: Course,
    lines: Vec<Line>,
    /// What it is at the positions of the sweep.
    dots: Line,
}

/// A panel with what it shows.
struct Group<'i> {
    display: &'i Display,
    curves: Vec<Curve<'i>>,
}

/// The curves of a plot, for what is shown beside it.
pub struct Curves {
    along: Display,
    x: Axis,
    all: Vec<(String, Display, Course)>,
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

    /// The name of one, and its number at a value of the drive.
    #[must_use]
    pub fn of(&self, index: usize, drive: f64) -> (&str, &Display, Option<f64>) {
        let (name, display, course) = &self.all[index];
        (name, display, course.at(drive))
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
    for curve in curves.into_iter().filter(|curve| !(curve.lines.is_empty() && curve.dots.is_empty())) {
        let display = &curve.item.display;
        let fits = |g: &&mut Group<'_>| {
            g.display.unit == display.unit
                && g.display.dimension == display.dimension
                && g.curves.len() < CURVES.len()
        };
        match groups.iter_mut().find(fits) {
            Some(group) => group.curves.push(curve),
            None => groups.push(Group { display, curves: vec![curve] }),
        }
    }
    if groups.is_empty() {
        return Err(no_diagram::no_quantity(scene, "nothing that is asked for has a value over the sweep"));
    }
    let title = format!("{}: {}", words::title(scene), listed(scene, &items));
    let mut drawing = Drawing::new(&words::id(scene, "plot"), title, String::new());
    let (along, x) = panels(scene, &mut drawing, &groups, &events);
    let all = groups.into_iter().flat_map(|group| group.curves);
    let all = all.map(|c| (c.item.plain.clone(), c.item.display.clone(), c.course)).collect();
    Ok((drawing, Curves { along, x, all }))
}

/// The curves of items, with the places of every event.
fn curves<'i>(scene: &Scene<'_>, items: &'i [Item]) -> Result<(Vec<Curve<'i>>, Vec<Vec<f64>>), Diagnosis> {
    let set = |item: &Item| CourseSet {
        exprs: vec![item.expr.clone()],
        rounding: scene.rounding(item.display.dimension),
    };
    let sets: Vec<CourseSet> = items.iter().map(set).collect();
    let is_motion = scene.mechanism().simulation.is_some();
    let Courses { sets, events } = match courses(&scene.model, scene.solution, &sets) {
        Ok(found) => found,
        // as the file itself does not
        Err(_) if is_motion => return Err(no_diagram::no_quantity(scene, "the motion does not begin")),
        // what is no way has its positions
        Err(Cause::NoSweep(NoSweep::Unordered(_))) => {
            Courses { sets: vec![Vec::new(); items.len()], ..Courses::default() }
        }
        Err(cause) => return Err(no_diagram::no_sweep(scene, "plot", &cause)),
    };
    let curve = |(item, found): (&'i Item, Vec<Course>)| {
        let course = found.into_iter().next().unwrap_or_default();
        let dots = if is_motion { Line::new() } else { at_positions(scene, &item.expr) };
        Curve { item, lines: course.lines(PARTS), course, dots }
    };
    Ok((items.iter().zip(sets).map(curve).collect(), events))
}

/// A number at the positions of the sweep.
fn at_positions(scene: &Scene<'_>, expr: &Expr) -> Line {
    let poses = scene.solution.poses.iter().filter(|p| matches!(p.origin, PoseOrigin::Sweep(_)));
    let count = poses.clone().count().max(2) - 1;
    let dot = |(i, pose): (usize, &Pose)| {
        #[allow(clippy::cast_precision_loss)] // positions
        let x = match pose.drives.first() {
            Some(DriveValue::Scalar(x)) => *x,
            _ => i as f64 / count as f64,
        };
        let solved = pose.outcome.as_ref().ok()?;
        match scene.solution.view(&scene.model, solved).value(expr) {
            Value::Scalar(y) if y.is_finite() => Some((x, y)),
            _ => None,
        }
    };
    poses.enumerate().filter_map(dot).collect()
}

impl Curve<'_> {
    /// The least and the greatest number that is shown of it.
    fn range(&self) -> (f64, f64) {
        let of = |all: &mut dyn Iterator<Item = f64>| {
            all.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), y| (least.min(y), most.max(y)))
        };
        if self.lines.is_empty() {
            return of(&mut self.dots.iter().map(|p| p.1));
        }
        if self.course.poles().next().is_some() {
            return self.course.window;
        }
        let own = [self.course.least, self.course.greatest].into_iter().flatten();
        of(&mut self.lines.iter().flatten().copied().chain(own).map(|p| p.1))
    }

    /// Whether it has no bound above (1) or below (−1).
    fn is_cut(&self, side: f64) -> bool {
        self.course.poles().any(|(_, signs)| signs.contains(&side))
    }
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
            items.push(Item { name: name(scene, &plain), plain, display: display.clone(), expr });
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
    // of two that have one letter both are as they are written
    let names: Vec<String> = items.iter().map(|item| item.name.plain()).collect();
    for (i, item) in items.iter_mut().enumerate() {
        if (0..names.len()).any(|j| j != i && names[j] == names[i]) {
            item.name = written(&item.plain);
        }
    }
    items
}

/// A name as a label; what is asked of a part of the mechanism by its letter, another expression as it is written.
fn name(scene: &Scene<'_>, plain: &str) -> Text {
    if plain.chars().all(in_name) {
        return Text::name(plain);
    }
    letter(scene, plain).unwrap_or_else(|| written(plain))
}

fn written(plain: &str) -> Text {
    if plain.chars().count() <= LONGEST {
        return Text::upright(plain);
    }
    let head: String = plain.chars().take(LONGEST - 1).collect();
    Text { full: Some(plain.to_owned()), ..Text::upright(&(head + "…")) }
}

fn in_name(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '\'')
}

/// `omega(rocker)` as ω₃, `velocity(coupler.E).x` as v_Ex.
fn letter(scene: &Scene<'_>, plain: &str) -> Option<Text> {
    let plain = plain.strip_prefix("mag(").and_then(|inner| inner.strip_suffix(')')).unwrap_or(plain);
    let (function, rest) = plain.split_once('(')?;
    let (inner, axis) = rest.rsplit_once(')')?;
    let axis =
        if axis.is_empty() { "" } else { axis.strip_prefix('.').filter(|a| matches!(*a, "x" | "y"))? };
    let arguments: Vec<&str> = inner.split(',').map(str::trim).filter(|one| !one.is_empty()).collect();
    if !arguments.iter().all(|one| one.chars().all(|c| in_name(c) || c == '.')) {
        return None;
    }
    let mechanism = scene.mechanism();
    let link = |name: &str| mechanism.links.iter().position(|link| link.name == name).map(LinkId::at);
    if let ("reaction", [pair, on]) = (function, arguments.as_slice()) {
        let pair = PairId::at(mechanism.pairs.iter().position(|own| own.name == *pair)?);
        let on = link(on)?;
        let from = mechanism.pair(pair).kind.links().into_iter().find(|link| *link != on)?;
        let mut name = scene.reaction_name(pair, from, on);
        name.runs.last_mut()?.letters.push_str(axis);
        return Some(name);
    }
    let (letter, index) = letter_of(function)?;
    // x_B and not r_Bx
    let (letter, axis) = if function == "position" && !axis.is_empty() { (axis, "") } else { (letter, axis) };
    let of = |one: &&str| match link(one) {
        Some(link) => scene.link_label(link).to_owned(),
        None => one.rsplit('.').next().unwrap_or(one).to_owned(),
    };
    let index = match index {
        Index::All => arguments.iter().map(of).collect::<Vec<_>>().join(","),
        Index::Behind(before) => format!("{before}{}", arguments.first().map(of)?),
        Index::Own(own) => own.to_owned(),
    };
    let name = Text::italic(letter);
    Some(if index.is_empty() && axis.is_empty() { name } else { name.lowered(&(index + axis)) })
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
    let along = drive_axis(scene);
    let all = groups.iter().flat_map(|g| &g.curves);
    // over the whole way, whatever has a value there; over a motion as far as it goes
    let is_motion = scene.mechanism().simulation.is_some();
    let places = |curve: &Curve<'_>| {
        let (first, length) = curve.course.interval;
        let points = curve.lines.iter().chain([&curve.dots]).flatten().map(|p| p.0);
        let ends = (!is_motion && !curve.lines.is_empty()).then_some([first, first + length]);
        points.chain(ends.into_iter().flatten()).collect::<Vec<f64>>()
    };
    let (from, to) =
        all.flat_map(places).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let x = Axis::between(printed(&along, from), printed(&along, to), 13.0, along.unit == "deg");
    let mut top = 0.0;
    for (i, group) in groups.iter().enumerate() {
        let is_last = i + 1 == groups.len();
        if group.curves.len() > 1 {
            top = legend(drawing, group, top);
        }
        let range = group.curves.iter().map(Curve::range);
        let (least, most) =
            range.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), (c, d)| (a.min(c), b.max(d)));
        // what hardly changes is a flat line
        let most = if is_flat(least, most) { least } else { most };
        let y = Axis::around(printed(group.display, least), printed(group.display, most), STEPS[of_count]);
        let height = if y.is_of_nothing() { ZERO } else { HEIGHTS[of_count] };
        let panel = Panel { top, size: Vec2::new(WIDTH, height), x, y };
        let below = is_last.then(|| with_unit(drive_label(scene), "", &along.unit));
        panel.draw(drawing, heading(group, &y), below);
        marked_events(scene, drawing, &panel, (&along, events), i == 0);
        poles(drawing, &panel, group, &along);
        for (curve, style) in group.curves.iter().zip(CURVES) {
            drawing.begin("curve", &curve.item.plain);
            let lines: Vec<Line> =
                curve.lines.iter().map(|line| scaled(line, &along, group.display)).collect();
            let edge = EDGE * (y.to - y.from);
            panel.curve(drawing, style, &clipped(&lines, (y.from - edge, y.to + edge)));
            dots(drawing, &panel, scaled(&curve.dots, &along, group.display), lines.is_empty());
            // what is rounding beside the others has no extremes
            let (low, high) = curve.range();
            if low.abs().max(high.abs()) > 1e-9 * least.abs().max(most.abs()) {
                extremes(scene, drawing, &panel, curve, (&along, group.display), style);
            }
            drawing.end();
            drawing.description += &said(scene, curve, &along);
        }
        top += height + BETWEEN;
    }
    (along, x)
}

/// Uprights where a curve has no bound, and marks where the axis is cut for them.
fn poles(drawing: &mut Drawing, panel: &Panel, group: &Group<'_>, along: &Display) {
    let all = group.curves.iter().flat_map(|curve| curve.course.poles());
    let mut all: Vec<(f64, [bool; 2])> = all
        .map(|(at, signs)| {
            let x = panel.at(printed(along, at), panel.y.to).x;
            (x, [1.0, -1.0].map(|side| signs.contains(&side)))
        })
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.dedup_by(|next, before| {
        let same = next.0 - before.0 < 0.5;
        if same {
            before.1 = [0, 1].map(|i| before.1[i] || next.1[i]);
        }
        same
    });
    drawing.begin("poles", "");
    for (x, goes) in all {
        let top = Vec2::new(x, panel.top);
        drawing.line(Style::Dashed, Vec2::new(x, panel.bottom()), top);
        let goes = match goes {
            [true, true] => "→ ±∞",
            [true, false] => "→ ∞",
            _ => "→ −∞",
        };
        let label = Label::at(Text::upright(goes), 3.0, top, 0.6).towards(Vec2::new(0.0, -1.0));
        drawing.label(label.ranked(2));
    }
    for (side, above) in [(1.0, true), (-1.0, false)] {
        if group.curves.iter().any(|curve| curve.is_cut(side)) {
            panel.cut(drawing, above);
        }
    }
    drawing.end();
}

/// Dots at the positions of the sweep; none where neighbours would touch, unless nothing else is drawn.
fn dots(drawing: &mut Drawing, panel: &Panel, dots: Line, alone: bool) {
    #[allow(clippy::cast_precision_loss)] // positions
    let apart = WIDTH / dots.len().max(1) as f64;
    if apart < DOTS && !alone {
        return;
    }
    for (x, y) in dots.into_iter().filter(|(_, y)| (-EDGE..=1.0 + EDGE).contains(&panel.y.share(*y))) {
        drawing.mark(Style::Hinge, Shape::Circle { centre: panel.at(x, y), radius: DOT });
    }
}

/// Whether numbers between these two are one.
fn is_flat(least: f64, most: f64) -> bool {
    most - least <= FLAT * most.abs().max(least.abs())
}

/// The title of the vertical axis: name and unit of one curve, the unit alone of several.
fn heading(group: &Group<'_>, y: &Axis) -> Text {
    let unit = &group.display.unit;
    match group.curves.as_slice() {
        [curve] => with_unit(curve.item.name.clone(), &y.power_text(), unit),
        _ => Text::upright(&y.power_text()).unit(&unit_text(unit)),
    }
}

/// Samples of the curves with their names, line by line; where the panel begins.
fn legend(drawing: &mut Drawing, group: &Group<'_>, top: f64) -> f64 {
    drawing.begin("legend", "");
    let mut at = Vec2::new(22.0, top - 2.5);
    for (Curve { item, .. }, style) in group.curves.iter().zip(CURVES) {
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
    curve: &Curve<'_>,
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
    for (extreme, towards) in [(curve.course.greatest, -1.0), (curve.course.least, 1.0)] {
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
fn largest(curve: &Curve<'_>) -> f64 {
    let (least, greatest) = curve.range();
    least.abs().max(greatest.abs())
}

/// `Mb: least −261.8 N·m at 120°, greatest 61.2 N·m at 301°. `
fn said(scene: &Scene<'_>, curve: &Curve<'_>, along: &Display) -> String {
    let (name, large) = (&curve.item.plain, largest(curve));
    let value = |y: f64| scene.value_text(&curve.item.display, cleared(y, large));
    let place = |x: f64| scene.place_text(along, x);
    let said = match (curve.course.least, curve.course.greatest) {
        (Some((x_1, y_1)), Some((x_2, y_2))) if !is_flat(y_1, y_2) => format!(
            "{name}: least {} at {}, greatest {} at {}. ",
            value(y_1),
            place(x_1),
            value(y_2),
            place(x_2)
        ),
        (Some((_, y)), Some(_)) => format!("{name}: {} everywhere. ", value(y)),
        (Some((x, y)), None) => format!("{name}: least {} at {}. ", value(y), place(x)),
        (None, Some((x, y))) => format!("{name}: greatest {} at {}. ", value(y), place(x)),
        (None, None) => {
            let (least, greatest) = curve.range();
            format!("{name}: from {} to {}. ", value(least), value(greatest))
        }
    };
    let poles: Vec<String> = curve.course.poles().map(|pole| place(pole.0)).collect();
    if poles.is_empty() { said } else { format!("{said}{name}: no bound at {}. ", poles.join(", ")) }
}
