//! Osculating circles of the paths of points.

use super::{Scheme, Shows, Sketch, scheme};
use crate::no_diagram::no_curvature;
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Level, Rect, Role, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Expr, FindKind, PointRef, Query, Value};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;
use std::f64::consts::TAU;

/// A circle is drawn as far as this part of the mechanism; half of it is the longest line to its centre.
const LONG: f64 = 6.0;
/// Half the number of its parts.
const PARTS: i32 = 60;
/// Size of the radii.
const NUMBER: f64 = 3.6;

/// A circle that touches a path, m.
pub struct Circle {
    name: String,
    radius: f64,
    line: Vec<Vec2>,
    /// From the point towards the centre.
    arm: [Vec2; 2],
}

/// The circles of the points whose curvature is asked for, as far as they have one, about a mechanism of that size.
pub fn circles(scene: &Scene<'_>, size: f64) -> Vec<Circle> {
    let (mechanism, view) = (scene.mechanism(), scene.view());
    let mut all: Vec<Circle> = Vec::new();
    let mut add = |query: &Query| {
        let (Query::CurvatureRadius(of) | Query::CurvatureCentre(of)) = query else { return };
        let PointRef::Fixed(link, at) = *of else { return };
        let named = mechanism.link(link).points.iter().find(|p| p.at == at);
        let (Some(named), Value::Scalar(radius)) = (named, view.query(&Query::CurvatureRadius(*of))) else {
            return;
        };
        let name = format!("{}.{}", mechanism.link(link).name, named.name);
        let Value::Vector(centre) = view.query(&Query::CurvatureCentre(*of)) else { return };
        if !radius.is_finite() || all.iter().any(|circle| circle.name == name) {
            return;
        }
        let from = scene.at(link, at) - centre;
        let sweep = TAU.min(LONG * size / radius.abs());
        let turned = |i: i32| from.turned(Vec2::direction(sweep * f64::from(i) / f64::from(2 * PARTS)));
        let line = (-PARTS..=PARTS).map(|i| centre + turned(i)).collect();
        let inner = if sweep < TAU { centre + from * (1.0 - sweep / (2.0 * TAU)) } else { centre };
        all.push(Circle { name, radius, line, arm: [centre + from, inner] });
    };
    let finds = mechanism.finds.iter().filter_map(|find| match &find.kind {
        FindKind::Value { expr, .. } => Some(expr),
        _ => None,
    });
    finds.chain(mechanism.quantities.iter().map(|q| &q.expr)).for_each(|e: &Expr| e.queries(&mut add));
    all
}

/// The scheme with the osculating circles of paths.
///
/// # Errors
/// No curvature of a path is asked for.
pub fn curvature(scene: &Scene<'_>, wanted: &Scheme) -> Result<Drawing, Diagnosis> {
    if circles(scene, 0.0).is_empty() {
        return Err(no_curvature(scene));
    }
    scheme(scene, &Scheme { shows: Shows::Curvature, ..wanted.clone() })
}

/// The circles that are shown, within the bounds.
pub(super) fn shown(scene: &Scene<'_>, wanted: &Scheme, bounds: &mut Rect) -> Vec<Circle> {
    if wanted.shows != Shows::Curvature {
        return Vec::new();
    }
    let all = circles(scene, bounds.size().norm());
    all.iter().flat_map(|circle| &circle.line).for_each(|at| bounds.add(*at));
    all
}

impl Sketch<'_, '_> {
    /// Circles, dashed, with their radii to the points.
    pub(super) fn circles(&mut self, drawing: &mut Drawing, all: &[Circle]) {
        let display = self.scene.mechanism().display_of(Dimension::LENGTH);
        for circle in all {
            drawing.begin("curvature", &circle.name);
            let points = circle.line.iter().map(|at| self.frame.point(*at)).collect();
            drawing.mark(Style::Way, Shape::Lines { points, closed: false });
            let [point, inner] = circle.arm.map(|at| self.frame.point(at));
            drawing.line(Style::Thin, point, inner);
            let size = self.scene.value_text(&display, circle.radius);
            let text = Text::italic("ρ").and(&format!(" = {size}"), false, Level::Base);
            drawing.label(Label::along(text, NUMBER, point, inner).coloured(Role::Grey).ranked(2));
            drawing.end();
            self.say(&format!("Radius of curvature of the path of {}: {size}", circle.name));
        }
    }
}
