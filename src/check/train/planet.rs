//! Distances of axes: of placed wheels, and of planets that mesh on both sides.

use super::carrier::centre_on;
use crate::check::amount::told;
use crate::check::context::Context;
use crate::check::error::TrainError;
use crate::model::{LinkId, Pair, PairKind, Wheel};
use crate::source::Span;
use crate::units::Dimension;
use indexmap::IndexMap;

/// A distance may differ from what the sizes ask for by this part.
const AGREES: f64 = 1e-6;

/// Arms of planets as their meshes ask for them: by shaft, the arm, the mesh with its place, and the axis meshed with.
pub(super) type Arms = IndexMap<LinkId, Vec<(f64, String, Span)>>;

/// Reports placed wheels whose distance is not that of their sizes.
pub(super) fn distance(
    cx: &mut Context<'_>,
    wheels: [&Wheel; 2],
    carrier: LinkId,
    internal: bool,
    span: Span,
) -> Option<()> {
    let [a, b] = wheels;
    let (Some(p), Some(q)) = (centre_on(cx, a, carrier), centre_on(cx, b, carrier)) else { return Some(()) };
    let assumed =
        |w: &Wheel| cx.mech.scales.iter().any(|s| s.wheel == w.name || s.teeth && w.teeth.is_some());
    if assumed(a) || assumed(b) {
        return Some(());
    }
    let distance = (q - p).norm();
    let due = if internal { (a.radius - b.radius).abs() } else { a.radius + b.radius };
    if (distance - due).abs() <= AGREES * due {
        return Some(());
    }
    let length = |x| told(x, Dimension::LENGTH);
    cx.error(TrainError::CentreDistance {
        first: a.name.clone(),
        second: b.name.clone(),
        distance: length(distance),
        rule: if internal { "the difference of their radii" } else { "the sum of their radii" },
        due: length(due),
        span,
    });
    None
}

/// Notes the arm that a mesh asks of a planet, and warns of one that does not agree with another mesh.
pub(super) fn arm(
    cx: &mut Context<'_>,
    arms: &mut Arms,
    planet: &Wheel,
    other: &Wheel,
    internal: bool,
    (name, span): (&str, Span),
) {
    let scaled = |w: &Wheel| cx.mech.scales.iter().any(|s| s.wheel == w.name && !s.teeth);
    if scaled(planet) || scaled(other) {
        return;
    }
    let arm = if internal { (other.radius - planet.radius).abs() } else { other.radius + planet.radius };
    let before = arms.entry(planet.link).or_default();
    let odd = before.iter().find(|(a, ..)| (a - arm).abs() > AGREES * arm).cloned();
    before.push((arm, name.to_owned(), span));
    let Some((one, first, first_span)) = odd else { return };
    let modules = cx.mech.scales.iter().any(|s| s.teeth);
    // without a module an arm is a sum of teeth
    let text = |arm: f64| match modules {
        true => format!("{} teeth", crate::check::amount::digits(2.0 * arm)),
        false => told(arm, Dimension::LENGTH),
    };
    let error = TrainError::PlanetDistance {
        shaft: cx.mech.link(planet.link).name.clone(),
        first,
        second: name.to_owned(),
        one: text(one),
        two: text(arm),
        first_span,
        second_span: span,
    };
    cx.error(error);
}

/// Whether a wheel turns on a carrier that moves.
pub(super) fn is_planet(cx: &Context<'_>, wheel: &Wheel, carrier: LinkId) -> bool {
    let on = |p: &Pair| match &p.kind {
        // a shaft stands second, what carries it first
        PairKind::Revolute(pins) if p.bearing.is_some() => {
            pins.first().is_some_and(|p| p.link == carrier)
                && pins.last().is_some_and(|p| p.link == wheel.link)
        }
        PairKind::Revolute(pins) => {
            let has = |link| pins.iter().any(|p| p.link == link);
            has(wheel.link) && has(carrier) && !has(LinkId::GROUND)
        }
        _ => false,
    };
    carrier != LinkId::GROUND && wheel.link != LinkId::GROUND && cx.mech.pairs.iter().any(on)
}
