//! Potential energy of the loads, springs and weights over the coordinate of an equilibrium: where it is least the equilibrium is
//! stable.
//!
//! The effort that holds the mechanism at rest is dV/dq (principle of virtual work), so V is its integral; it counts from the
//! equilibrium that the file chooses.

use crate::diagram::{Axis, LETTERS, Line, Panel, drive_label, printed, with_unit};
use crate::scene::Scene;
use crate::{no_diagram, words};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Display, SoughtWay};
use assur_position::position::turns;
use assur_text::diagnostic::Diagnosis;

/// Width and height of the panel, mm.
const SIZE: Vec2 = Vec2 { x: 120.0, y: 62.0 };
/// Radius of a position of equilibrium, mm.
const MARK: f64 = 1.1;

/// The potential energy over the coordinate, with all positions of equilibrium.
///
/// # Errors
/// The file seeks no equilibrium, or several coordinates.
pub fn equilibrium(scene: &Scene<'_>) -> Result<Drawing, Diagnosis> {
    let mechanism = scene.mechanism();
    let found = mechanism.equilibria.first();
    let Some((found, way)) = found.and_then(|found| Some((found, found.sought.as_ref()?))) else {
        return Err(no_diagram::no_equilibrium(scene));
    };
    let (drive, at) = (&mechanism.drives[way.drive], found.at[way.drive]);
    let mut along = mechanism.drive_display(drive.target);
    if turns(&scene.model, drive) {
        along = Display { unit: "deg".to_owned(), factor: 1.0_f64.to_radians(), ..along };
    }
    let energy = Display { unit: "J".to_owned(), ..Display::default() };
    let course = from_zero(&potential(way, at), at);
    let title = format!("{}: potential energy over {}", words::title(scene), drive.name);
    let mut drawing = Drawing::new(&words::id(scene, "equilibrium"), title, String::new());
    let line: Line = course.iter().map(|(q, v)| (printed(&along, *q), *v)).collect();
    let range = |of: fn(&(f64, f64)) -> f64| {
        let all = line.iter().map(of);
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
    };
    let ((from, to), (least, most)) = (range(|p| p.0), range(|p| p.1));
    let x = Axis::between(from, to, 12.0, along.unit == "deg");
    let panel = Panel { top: 0.0, size: SIZE, x, y: Axis::around(least, most, 6.0) };
    let name = with_unit(Text::italic("V"), &panel.y.power_text(), &energy.unit);
    let below = with_unit(drive_label(scene), &panel.x.power_text(), &along.unit);
    panel.draw(&mut drawing, name, Some(below));
    panel.curve(&mut drawing, Style::Curve1, &[line]);
    let mut said = Vec::new();
    for (q, stable) in &way.equilibria {
        let Some(v) = value(&course, *q) else { continue };
        let style = if *stable { Style::Solid } else { Style::Hinge };
        let text = scene.place_text(&along, *q);
        let mark = panel.at(printed(&along, *q), v);
        drawing.begin("equilibrium", if *stable { "stable" } else { "unstable" });
        drawing.mark(style, Shape::Circle { centre: mark, radius: MARK });
        let label = Label::at(Text::upright(&text), LETTERS, mark, MARK);
        drawing.label(label.towards(Vec2::new(0.0, if *stable { 1.0 } else { -1.0 })).ranked(2));
        drawing.end();
        said.push(format!("{} at {text}", if *stable { "stable" } else { "unstable" }));
    }
    drawing.description = format!("The potential energy over {}: {}.", drive.name, said.join(", "));
    Ok(drawing)
}

/// The integral of the effort over the positions that join the one that is chosen.
fn potential(way: &SoughtWay, at: f64) -> Line {
    let mut line = Line::new();
    let mut last: Option<(f64, f64)> = None;
    for &(q, effort) in &way.efforts {
        let Some(effort) = effort else {
            if line.last().is_some_and(|end| end.0 >= at) {
                break;
            }
            line.clear();
            last = None;
            continue;
        };
        let before = line.last().map_or(0.0, |end| end.1);
        let v = last.map_or(0.0, |(p, known)| before + 0.5 * (known + effort) * (q - p));
        line.push((q, v));
        last = Some((q, effort));
    }
    line
}

/// The same, null where it is chosen.
fn from_zero(line: &Line, at: f64) -> Line {
    let zero = value(line, at).unwrap_or(0.0);
    line.iter().map(|(q, v)| (*q, v - zero)).collect()
}

/// The value between two points of a line.
fn value(line: &Line, at: f64) -> Option<f64> {
    let ends = line.windows(2).find(|ends| ends[0].0 <= at && at <= ends[1].0)?;
    let part = (at - ends[0].0) / (ends[1].0 - ends[0].0);
    Some(ends[0].1 + part * (ends[1].1 - ends[0].1))
}
