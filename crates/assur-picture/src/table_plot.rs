//! The plot of a table of the file: its curve, and its points as dots.

use crate::diagram::{Axis, Panel, with_unit};
use assur_drawing::{Drawing, Style, Text};
use assur_math::math::{TableFunction, Vec2};
use assur_text::units::Unit;

/// Width and height, mm.
const SIZE: Vec2 = Vec2 { x: 60.0, y: 28.0 };
/// Points of the curve.
const POINTS: u32 = 240;

/// What an axis shows: a name and its unit.
pub struct TableAxis<'a> {
    pub name: &'a str,
    pub unit: Option<Unit>,
}

impl TableAxis<'_> {
    fn printed(&self, si: f64) -> f64 {
        self.unit.as_ref().map_or(si, |unit| unit.from_si(si))
    }

    fn title(&self, power: &str) -> Text {
        with_unit(Text::name(self.name), power, self.unit.as_ref().map_or("", |unit| unit.text.as_str()))
    }
}

/// The plot of a table over its arguments.
#[must_use]
pub fn table_plot(name: &str, table: &TableFunction, [along, value]: [TableAxis<'_>; 2]) -> Drawing {
    let (from, to) = table.range();
    let places = (0..=POINTS).map(|i| from + (to - from) * f64::from(i) / f64::from(POINTS));
    let mut places: Vec<f64> = places.chain(table.arguments().iter().copied()).collect();
    places.sort_by(f64::total_cmp);
    let at = |x: f64| (along.printed(x), value.printed(table.value(x)));
    let line: Vec<(f64, f64)> = places.into_iter().map(at).collect();
    let least = line.iter().map(|(_, y)| *y).fold(f64::INFINITY, f64::min);
    let greatest = line.iter().map(|(_, y)| *y).fold(f64::NEG_INFINITY, f64::max);
    let is_angle = along.unit.as_ref().is_some_and(|unit| unit.text == "deg");
    let x = Axis::between(along.printed(from), along.printed(to), 6.0, is_angle);
    let panel = Panel { top: 0.0, size: SIZE, x, y: Axis::around(least, greatest, 4.0) };
    let mut drawing = Drawing::new(&format!("table-{name}"), name.to_owned(), name.to_owned());
    panel.draw(&mut drawing, value.title(&panel.y.power_text()), Some(along.title("")));
    drawing.begin("curve", name);
    panel.curve(&mut drawing, Style::Curve1, &[line]);
    for x in table.arguments() {
        let (x, y) = at(*x);
        panel.dot(&mut drawing, x, y);
    }
    drawing.end();
    drawing
}
