//! Lengths and offsets that a file gives by name, for the dimension lines of a scheme.

use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, Value};
use assur_picture::{Dimension, Measured};
use assur_syntax::document::{Body, Document, Expr, ExprKind, Member, Name, Statement, UnaryOp, WheelSize};
use std::f64::consts::FRAC_PI_2;

/// The dimensions of a document whose mechanism is known: where a length of a link is a name, that of a `given` or of a `let`.
#[must_use]
pub fn dimensions(document: &Document, mechanism: &Mechanism) -> Vec<Dimension> {
    let mut found = Found { mechanism, all: Vec::new() };
    for statement in &document.statements {
        match &statement.node {
            Statement::Ground(ground) => found.body("ground", &ground.body),
            Statement::Link(link) => {
                if let Some(bar) = &link.bar {
                    found.between(&link.name.node, &bar.from, &bar.to, &bar.length);
                }
                found.body(&link.name.node, &link.body);
            }
            Statement::Shaft(shaft) => found.body(&shaft.name.node, &shaft.body),
            Statement::Slider(slider) => found.body(&slider.name.node, &slider.body),
            _ => {}
        }
    }
    found.all
}

struct Found<'a> {
    mechanism: &'a Mechanism,
    all: Vec<Dimension>,
}

impl Found<'_> {
    fn body(&mut self, link: &str, body: &Body) {
        for member in body {
            match &member.node {
                Member::Point(point) => self.point(link, &point.name, &point.at),
                Member::PointFrom(from) => {
                    self.between(link, &from.first, &from.name, &from.first_distance);
                    self.between(link, &from.second, &from.name, &from.second_distance);
                }
                Member::Circle(circle) => {
                    if let Some(centre) = self.at(link, &circle.centre) {
                        self.radius(link, centre, &circle.radius, false);
                    }
                }
                Member::Wheel(wheel) => {
                    let named = self.mechanism.wheels.iter().find(|w| w.name == wheel.name.node);
                    let Some(centre) = named.and_then(|wheel| wheel.centre) else { continue };
                    match &wheel.size {
                        Some(WheelSize::Radius(radius)) => self.radius(link, centre, radius, false),
                        Some(WheelSize::Diameter(diameter)) => self.radius(link, centre, diameter, true),
                        _ => {}
                    }
                }
                _ => {}
            }
        }
    }

    /// A point by its coordinates, or by a length and a direction.
    fn point(&mut self, link: &str, name: &Name, at: &Expr) {
        let Some(to) = self.at(link, name) else { return };
        match &at.kind {
            ExprKind::Vector(x, y) => {
                for (part, along) in [(x, 0.0), (y, FRAC_PI_2)] {
                    let along = Vec2::direction(along);
                    let from = self.begin(link, name, along);
                    self.length(link, part, Measured::Length { from, to, along });
                }
            }
            ExprKind::Polar(length, _) => self.straight(link, length, Vec2::zero(), to),
            _ => {}
        }
    }

    /// A point of the link from which a coordinate of another is measured: one that has none itself, else the origin.
    fn begin(&self, link: &str, name: &Name, along: Vec2) -> Vec2 {
        let points = self.link(link).map(|id| &self.mechanism.link(id).points);
        let mut others = points.into_iter().flatten().filter(|p| p.name != name.node).map(|p| p.at);
        others.find(|at| at.dot(along).abs() <= 1e-12 * at.norm()).unwrap_or(Vec2::zero())
    }

    fn between(&mut self, link: &str, from: &Name, to: &Name, length: &Expr) {
        if let (Some(from), Some(to)) = (self.at(link, from), self.at(link, to)) {
            self.straight(link, length, from, to);
        }
    }

    fn straight(&mut self, link: &str, length: &Expr, from: Vec2, to: Vec2) {
        if let Some(along) = (to - from).unit() {
            self.length(link, length, Measured::Length { from, to, along });
        }
    }

    fn radius(&mut self, link: &str, centre: Vec2, size: &Expr, is_diameter: bool) {
        let Some(value) = self.value(size).map(f64::abs) else { return };
        let across = Vec2::new(0.5 * value, 0.0);
        let of = if is_diameter {
            Measured::Length { from: centre - across, to: centre + across, along: Vec2::new(1.0, 0.0) }
        } else {
            Measured::Radius { centre, radius: value }
        };
        self.length(link, size, of);
    }

    /// A length whose expression is a name, with a minus or without.
    fn length(&mut self, link: &str, written: &Expr, of: Measured) {
        let (Some(name), Some(link)) = (name(written), self.link(link)) else { return };
        let Some(value) = self.mechanism.values.iter().find(|value| value.name == name) else { return };
        let dimension = Dimension { name: name.to_owned(), link, of, display: value.display.clone() };
        if !self.all.contains(&dimension) {
            self.all.push(dimension);
        }
    }

    /// The value of a name.
    fn value(&self, written: &Expr) -> Option<f64> {
        let name = name(written)?;
        let found = self.mechanism.values.iter().find(|value| value.name == name)?;
        match found.value {
            Value::Scalar(x) => Some(x),
            _ => None,
        }
    }

    fn link(&self, name: &str) -> Option<LinkId> {
        self.mechanism.links.iter().position(|link| link.name == name).map(LinkId::at)
    }

    fn at(&self, link: &str, point: &Name) -> Option<Vec2> {
        let points = &self.mechanism.link(self.link(link)?).points;
        points.iter().find(|p| p.name == point.node).map(|p| p.at)
    }
}

fn name(written: &Expr) -> Option<&str> {
    match &written.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Unary(sign, inner) if sign.node != UnaryOp::Not => name(inner),
        _ => None,
    }
}
