//! Rotors with masses in several planes: the side view, and the polygons of their moments m r and of the couples m r z.

use crate::diagram::LETTERS;
use crate::scene::Scene;
use crate::{no_diagram, words};
use assur_drawing::{Drawing, Label, Rect, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Link, LinkId, MassPart, PairKind};
use assur_text::diagnostic::Diagnosis;

/// Width of the side view, its half height, and the side of a polygon, mm.
const WIDE: f64 = 120.0;
const HIGH: f64 = 24.0;
const POLYGON: f64 = 46.0;
/// From one rotor to the next, mm.
const NEXT: f64 = 2.0 * HIGH + POLYGON + 40.0;
/// Radius of a mass, mm.
const MASS: f64 = 1.2;
/// Shorter arrows are left out, mm.
const SHORT: f64 = 0.3;

/// A link with its hinge on the ground.
pub struct Rotor<'s> {
    link: &'s Link,
    hinge: Vec2,
}

/// The side views and polygons of all rotors.
///
/// # Errors
/// No link on the ground has masses in several planes.
pub fn planes(scene: &Scene<'_>) -> Result<Vec<Drawing>, Diagnosis> {
    let all: Vec<Rotor<'_>> = rotors(scene).collect();
    if all.is_empty() {
        return Err(no_diagram::no_planes());
    }
    let names: Vec<&str> = all.iter().map(|rotor| rotor.link.name.as_str()).collect();
    let title = format!("{}: planes of {}", words::title(scene), names.join(", "));
    let mut drawing = Drawing::new(&words::id(scene, "planes"), title, String::new());
    for (i, rotor) in all.iter().enumerate() {
        #[allow(clippy::cast_precision_loss)] // a few
        rotor.draw(&mut drawing, i as f64 * NEXT);
    }
    Ok(vec![drawing])
}

pub fn rotors<'s>(scene: &Scene<'s>) -> impl Iterator<Item = Rotor<'s>> {
    let mechanism = scene.mechanism();
    mechanism.pairs.iter().filter_map(move |pair| {
        let PairKind::Revolute(pins) = &pair.kind else { return None };
        pins.iter().find(|pin| pin.link == LinkId::GROUND)?;
        let pin = pins.iter().find(|pin| pin.link != LinkId::GROUND)?;
        let link = mechanism.link(pin.link);
        let several = link.mass_parts.iter().any(|part| part.plane != link.mass_parts[0].plane);
        several.then_some(Rotor { link, hinge: pin.at })
    })
}

impl Rotor<'_> {
    fn arm(&self, part: &MassPart) -> Vec2 {
        part.own.centre - self.hinge
    }

    /// The name of the point where a mass is.
    fn name(&self, part: &MassPart) -> Text {
        let point = self.link.points.iter().find(|point| (point.at - part.own.centre).norm() < 1e-9);
        Text::name(point.map_or("", |point| point.name.as_str()))
    }

    fn draw(&self, drawing: &mut Drawing, top: f64) {
        let parts = &self.link.mass_parts;
        let least = parts.iter().map(|part| part.plane).fold(f64::INFINITY, f64::min);
        let most = parts.iter().map(|part| part.plane).fold(f64::NEG_INFINITY, f64::max);
        let radius = parts.iter().map(|part| self.arm(part).norm()).fold(f64::MIN_POSITIVE, f64::max);
        let axis = top + HIGH;
        drawing.begin("link", &self.link.name);
        drawing.line(Style::Axis, Vec2::new(0.0, axis), Vec2::new(WIDE, axis));
        for part in parts {
            let x = 10.0 + (WIDE - 20.0) * (part.plane - least) / (most - least);
            let up = -self.arm(part).y / radius * (HIGH - 4.0);
            let (foot, centre) = (Vec2::new(x, axis), Vec2::new(x, axis + up));
            if up.abs() > MASS {
                drawing.line(Style::Medium, foot, centre);
            }
            drawing.mark(Style::Solid, Shape::Circle { centre, radius: MASS });
            let away = Vec2::new(0.0, if up > 0.0 { 1.0 } else { -1.0 });
            drawing.label(Label::at(self.name(part), LETTERS, centre, MASS).towards(away).ranked(2));
        }
        drawing.end();
        let moment = |part: &MassPart| self.arm(part) * part.own.mass;
        self.polygon(drawing, Vec2::new(0.0, axis + HIGH + 16.0), "m r", &moment);
        let right = Vec2::new(WIDE - POLYGON, axis + HIGH + 16.0);
        self.polygon(drawing, right, "m r z", &|part| moment(part) * part.plane);
        drawing.description += &format!(
            "Link {} from the side, its masses in their planes from {least} m to {most} m; the polygons of m r and of m r z. ",
            self.link.name
        );
    }

    /// The vectors one after the other, in the axes of the link.
    fn polygon(&self, drawing: &mut Drawing, corner: Vec2, of: &str, vector: &dyn Fn(&MassPart) -> Vec2) {
        let mut tips = vec![Vec2::zero()];
        for part in &self.link.mass_parts {
            let v = vector(part);
            tips.push(tips[tips.len() - 1] + Vec2::new(v.x, -v.y));
        }
        let mut bounds = Rect::NOTHING;
        tips.iter().for_each(|tip| bounds.add(*tip));
        let size = (bounds.max - bounds.min).norm().max(f64::MIN_POSITIVE);
        let paper = |v: Vec2| corner + (v - bounds.min) * (POLYGON / size);
        drawing.begin("polygon", of);
        let title = Label::at(Text::upright(of), LETTERS, corner - Vec2::new(0.0, 6.0), 0.0);
        drawing.label(title.ranked(2));
        for (part, ends) in self.link.mass_parts.iter().zip(tips.windows(2)) {
            let [a, b] = [paper(ends[0]), paper(ends[1])];
            if (b - a).norm() > SHORT {
                drawing.mark(Style::Force, Shape::Arrow(a, b));
                drawing.label(Label::at(self.name(part), LETTERS, (a + b) * 0.5, 0.8).ranked(2));
            }
        }
        drawing.end();
    }
}
