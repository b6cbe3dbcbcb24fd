//! Plans: ends of absolute vectors, directions of relative ones.

use super::Judged;
use assur::internals::drawing::{Shape, Style};
use assur::internals::math::Vec2;
use assur::internals::model::{LinkId, PairKind};
use assur::internals::picture::Kind;
use std::collections::BTreeMap;

/// How far an end may be off, mm.
const OFF: f64 = 0.01;
/// The sine of the angle that a part may be off: 0.1°.
const TURNED: f64 = 1.745e-3;

/// Ends of absolute vectors are velocities and accelerations of the hinges over the scale factor. How many there are.
pub fn ends(judged: &Judged<'_>, wrong: &mut Vec<String>) -> usize {
    let Some(factor) = judged.factor("Scale ") else { return 0 };
    let letter = if judged.kind == Kind::Velocities { "v" } else { "a" };
    let mut count = 0;
    for pair in &judged.shown.model.mechanism.pairs {
        let PairKind::Revolute(pins) = &pair.kind else { continue };
        let Some(pin) = pins.iter().find(|p| p.link != LinkId::GROUND) else { continue };
        let name = format!("{letter}_{}", index(&pair.name));
        let drawn = judged.sheet.drawing.marks.iter().find_map(|mark| match mark.shape {
            Shape::Arrow(from, to) if from == Vec2::zero() && judged.group(mark).1 == name => Some(to),
            _ => None,
        });
        let Some(end) = drawn else { continue };
        let body = &judged.state.motion.bodies[pin.link.index()];
        let at =
            if judged.kind == Kind::Velocities { body.velocity(pin.at) } else { body.acceleration(pin.at) };
        count += 1;
        let away = (end - Vec2::new(at.x, -at.y) / factor).norm();
        if away > OFF {
            wrong.push(format!("{name} is {away} mm off"));
        }
    }
    count
}

/// As in the index of a vector.
fn index(name: &str) -> String {
    name.replace('\'', "′").replace('_', "")
}

/// What a relative vector is parallel to, by its name; nothing where two vectors have the same name.
#[derive(Default)]
struct Lines(BTreeMap<String, Option<Vec2>>);

impl Lines {
    fn add(&mut self, name: String, along: Vec2) {
        let known = self.0.entry(name).or_insert(Some(along));
        if known.is_some_and(|k| k != along) {
            *known = None;
        }
    }
}

/// Relative parts are parallel or normal to their links and guides. How many there are.
pub fn parts(judged: &Judged<'_>, wrong: &mut Vec<String>) -> usize {
    let lines = lines(judged);
    let mut count = 0;
    for mark in &judged.sheet.drawing.marks {
        let Shape::Arrow(a, b) = mark.shape else { continue };
        let is_part =
            matches!(mark.style, Style::VelocityPart | Style::AccelerationPart | Style::AccelerationTangent);
        let (_, name) = judged.group(mark);
        let (true, Some(Some(along))) = (is_part, lines.0.get(name)) else { continue };
        count += 1;
        let turned = (b - a).cross(*along).abs() / ((b - a).norm() * along.norm());
        if turned > TURNED {
            wrong.push(format!("{name} is turned by {turned} rad"));
        }
    }
    count
}

fn lines(judged: &Judged<'_>) -> Lines {
    let mechanism = judged.shown.model.mechanism;
    let bodies = &judged.state.motion.bodies;
    let mut lines = Lines::default();
    for (link, body) in bodies.iter().enumerate().take(mechanism.links.len()).skip(1) {
        let pins = mechanism.pairs.iter().filter_map(|pair| {
            let PairKind::Revolute(pins) = &pair.kind else { return None };
            let pin = pins.iter().find(|p| p.link == LinkId::at(link))?;
            let fixed = pins.iter().any(|p| p.link == LinkId::GROUND);
            Some((index(&pair.name), body.position(pin.at), fixed))
        });
        let pins: Vec<(String, Vec2, bool)> = pins.collect();
        for (base, from, fixed) in &pins {
            for (other, to, _) in pins.iter().filter(|p| p.0 != *base) {
                let along = Vec2::new(to.x - from.x, from.y - to.y);
                let names = if *fixed { other.clone() } else { format!("{other}{base}") };
                if !fixed {
                    lines.add(format!("v_{names}"), along.perp());
                }
                lines.add(format!("an_{names}"), along);
                lines.add(format!("at_{names}"), along.perp());
            }
        }
    }
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let (PairKind::Prismatic(g) | PairKind::Slot(g)) = &pair.kind else { continue };
        if g.guide == LinkId::GROUND || g.slider == LinkId::GROUND {
            continue;
        }
        // any slot of a Geneva wheel goes through its centre
        let along = match mechanism.genevas.iter().find(|w| w.pair.index() == i) {
            Some(w) => bodies[w.crank.index()].position(w.pin) - bodies[w.wheel.index()].position(w.hub),
            None => g.along.turned(bodies[g.guide.index()].u),
        };
        let along = Vec2::new(along.x, -along.y);
        let number = |link: LinkId| {
            let link = mechanism.link(link);
            link.number.clone().unwrap_or_else(|| link.name.clone())
        };
        let on = |link: LinkId| {
            let here = mechanism.pairs.iter().filter_map(|p| match &p.kind {
                PairKind::Revolute(pins) if pins.iter().any(|q| q.link == link) => Some(index(&p.name)),
                _ => None,
            });
            here.chain([index(&g.point_name), index(&pair.name)]).collect::<Vec<_>>()
        };
        for name in on(g.slider) {
            let (s, c) = (format!("{name}{}", number(g.slider)), format!("{name}{}", number(g.guide)));
            for [a, b] in [[&s, &c], [&c, &s]] {
                lines.add(format!("v_{a}{b}"), along);
                lines.add(format!("ar_{a}{b}"), along);
                lines.add(format!("ak_{a}{b}"), along.perp());
            }
        }
    }
    lines
}
