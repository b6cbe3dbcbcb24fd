//! Amplitudes of the terms of Fourier series that the file asks for: a panel of bars per series.

use crate::diagram::{Axis, LETTERS, Panel, printed, with_unit};
use crate::scene::Scene;
use crate::{no_diagram, words};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Cycle, Display, Expr, FindKind, Function, Query, Value};
use assur_text::diagnostic::Diagnosis;

/// Width and height of a panel, mm, and from one to the next.
const SIZE: Vec2 = Vec2 { x: 120.0, y: 52.0 };
const BETWEEN: f64 = 22.0;
/// Width of a bar, of the step from order to order.
const WIDE: f64 = 0.5;
/// An amplitude below this part of the greatest has no number.
const SMALL: f64 = 1e-6;

/// The terms of one series that are asked for.
pub struct Series<'s> {
    /// Of what, as it is written, and as an expression.
    name: &'s str,
    of: &'s Expr,
    display: &'s Display,
    /// Orders and amplitudes, SI.
    bars: Vec<(f64, f64)>,
}

/// The amplitudes of all series of a file.
///
/// # Errors
/// The file asks for none.
pub fn fourier(scene: &Scene<'_>) -> Result<Vec<Drawing>, Diagnosis> {
    let all = all_series(scene);
    if all.is_empty() {
        return Err(no_diagram::no_term(scene));
    }
    let names: Vec<&str> = all.iter().map(|series| series.name).collect();
    let title = format!("{}: Fourier series of {}", words::title(scene), names.join(", "));
    let mut drawing = Drawing::new(&words::id(scene, "fourier"), title, String::new());
    for (i, series) in all.iter().enumerate() {
        #[allow(clippy::cast_precision_loss)] // a few
        series.draw(scene, &mut drawing, i as f64 * (SIZE.y + BETWEEN));
    }
    Ok(vec![drawing])
}

/// The amplitudes among the items of `find`, by what they are of.
pub fn all_series<'s>(scene: &Scene<'s>) -> Vec<Series<'s>> {
    let (mechanism, view) = (scene.mechanism(), scene.view());
    let mut all: Vec<Series<'s>> = Vec::new();
    let mut take = |amplitude: &'s Expr, display: &'s Display| {
        let Some(cycle) = term(scene, amplitude) else { return };
        let (Value::Scalar(value), Some(harmonic)) = (view.value(amplitude), cycle.how.harmonic()) else {
            return;
        };
        let bar = (0.5 * f64::from(harmonic.halves), value);
        match all.iter_mut().find(|series| *series.of == cycle.expr) {
            Some(series) if series.bars.iter().any(|known| known.0 == bar.0) => {}
            Some(series) => series.bars.push(bar),
            None => {
                let name = scene.text.get(cycle.span.start..cycle.span.end).unwrap_or_default();
                all.push(Series { name, of: &cycle.expr, display, bars: vec![bar] });
            }
        }
    };
    for find in &mechanism.finds {
        match &find.kind {
            FindKind::Value { expr, display, .. } => take(expr, display),
            FindKind::Table(table) => {
                for entry in &table.entries {
                    entry.found.iter().for_each(|expr| take(expr, &entry.display));
                }
            }
            FindKind::Reactions => {}
        }
    }
    all
}

/// The first coefficient of an amplitude; of other expressions nothing.
fn term<'s>(scene: &Scene<'s>, expr: &'s Expr) -> Option<&'s Cycle> {
    let mechanism = scene.mechanism();
    match expr {
        Expr::Quantity(id) => term(scene, &mechanism.quantities.get(id.index())?.expr),
        Expr::Call(Function::Mag, both) => match both.as_slice() {
            [Expr::Vector(first, _)] => match &**first {
                Expr::Query(Query::Cycle(index)) => mechanism.cycles.get(*index),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}

impl Series<'_> {
    fn draw(&self, scene: &Scene<'_>, drawing: &mut Drawing, top: f64) {
        let greatest = self.bars.iter().map(|bar| bar.1).fold(0.0, f64::max);
        let last = self.bars.iter().map(|bar| bar.0).fold(0.0, f64::max);
        let step = if self.bars.iter().any(|bar| bar.0.fract() != 0.0) { 0.5 } else { 1.0 };
        let x = Axis::between(0.0, last + 1.0, ((last + 1.0) / step).min(13.0), false);
        let y = Axis::around(0.0, printed(self.display, greatest), 6.0);
        let panel = Panel { top, size: SIZE, x, y };
        let name = Text::upright(&format!("amplitude of {}", self.name));
        let below = Text::upright("order");
        panel.draw(drawing, with_unit(name, &panel.y.power_text(), &self.display.unit), Some(below));
        for (order, amplitude) in &self.bars {
            let (left, right) = (order - 0.5 * WIDE * step, order + 0.5 * WIDE * step);
            let high = printed(self.display, *amplitude);
            let corners = [(left, 0.0), (left, high), (right, high), (right, 0.0)];
            let corners = corners.map(|(x, y)| panel.at(x, y)).to_vec();
            drawing.begin("bar", &order.to_string());
            drawing.mark(Style::Surplus, Shape::polygon(corners.clone()));
            drawing.mark(Style::Medium, Shape::Lines { points: corners, closed: true });
            if *amplitude > SMALL * greatest {
                let text = Text::upright(&scene.value_text(self.display, *amplitude));
                let label = Label::at(text, LETTERS, panel.at(*order, high), 0.8);
                drawing.label(label.towards(Vec2::new(0.0, -1.0)).ranked(2));
            }
            drawing.end();
        }
        let said = |bar: &(f64, f64)| format!("{} of order {}", scene.value_text(self.display, bar.1), bar.0);
        let all: Vec<String> = self.bars.iter().map(said).collect();
        drawing.description += &format!("Amplitudes of {}: {}. ", self.name, all.join(", "));
    }
}
