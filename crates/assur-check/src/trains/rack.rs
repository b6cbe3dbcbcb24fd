//! Racks: a wheel on a toothed line. Seen from a base along whose line the rack or the wheel's axis slides, or both,
//!
//! ```text
//! r (ω_wheel − ω_base) + v_axis − v_rack = 0,
//! ```
//!
//! the wheel to the left of the line.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use crate::pairs::transmission::known;
use crate::trains::{
    carrier::{centre_on, mates, turns_about},
    ends::{Runs, incomplete, two, wheel},
    rack_distance::{Placed, distance},
};
use assur_math::math::{SAME, Vec2};
use assur_model::model::{Bearing, Law, LinkId, PairId, PairKind, Rate, Wheel};
use assur_syntax::document::{Joint, Path};
use assur_text::source::Span;

/// A link that slides along a line of another.
#[derive(Clone, Copy)]
pub(super) struct Sliding {
    pair: PairId,
    link: LinkId,
    base: LinkId,
    /// The direction in which it slides, in its own frame and in that of the base.
    pub own: Vec2,
    pub on_base: Vec2,
    /// A point of a line of that direction, in both frames.
    pub own_point: Vec2,
    pub base_point: Vec2,
    /// Its velocity from the base in that direction is this times the rate of the pair.
    sense: f64,
    /// No direction is given: that of a `slider`.
    pub open: bool,
}

/// How the wheel meets the rack.
struct Meets {
    base: LinkId,
    rack: Option<Sliding>,
    axis: Option<Sliding>,
}

fn slides(cx: &Context<'_>, link: LinkId) -> Vec<Sliding> {
    let pairs = cx.builder.mech.pairs.iter().enumerate();
    let all = pairs.filter_map(|(i, p)| {
        let PairKind::Prismatic(g) = &p.kind else { return None };
        let (pair, open) = (PairId::at(i), p.bearing == Some(Bearing::Open));
        let (slider, guide) = ((g.slider, g.direction, g.point), (g.guide, g.along, g.through));
        let (own, base, sense) = match link {
            _ if g.slider == link => (slider, guide, 1.0),
            _ if g.guide == link => (guide, slider, -1.0),
            _ => return None,
        };
        let ((_, own, own_point), (base, on_base, base_point)) = (own, base);
        Some(Sliding { pair, link, base, own, on_base, own_point, base_point, sense, open })
    });
    all.collect()
}

/// A wheel on a rack.
pub(crate) fn rack(cx: &mut Context<'_>, joint: &Joint, loses: Option<Span>) -> Option<Runs> {
    let [first, second] = two(cx, joint)?;
    let is_wheel = |cx: &Context<'_>, p: &Path| cx.wheel(&p.head.node).is_some();
    let (wheel_path, bar) = if is_wheel(cx, second) { (second, first) } else { (first, second) };
    known(cx, &bar.head, "slider or link", &[ThingKind::Slider, ThingKind::Link]);
    let (wheel, link) = (wheel(cx, wheel_path), cx.find_link(&bar.head.node));
    let (wheel, link) = (wheel?, link?);
    let line = match &bar.tail {
        Some(part) => Some(cx.line(link, part)?),
        None => None,
    };
    let Meets { base, rack, axis } = meets(cx, &wheel, link, bar, wheel_path)?;
    // the direction of the teeth on the rack, and from the base
    let own = line.as_ref().map(|l| l.along);
    let mut turned = 1.0;
    if let (Some(rack), Some(own)) = (rack, own) {
        let name = line.as_ref().map(|l| l.name.as_str()).unwrap_or_default();
        turned = along(rack.own, own, rack.open).or_else(|| {
            let message = format!("the line `{name}` is not parallel to the guide of its link");
            incomplete(
                cx,
                &message,
                "make it parallel to the guide: the teeth of a rack lie along it",
                bar.span(),
            )
        })?;
    }
    let teeth = match (rack, own) {
        (Some(rack), _) => Some(rack.on_base * turned).filter(|_| !rack.open),
        (None, own) => own,
    };
    let mut terms = vec![(Rate::Turn(wheel.link), wheel.radius)];
    if let Some(rack) = rack {
        terms.push((Rate::Slide(rack.pair), -turned * rack.sense));
    }
    if let Some(axis) = axis {
        let sense = match teeth {
            Some(teeth) => along(axis.on_base, teeth, axis.open).or_else(|| {
                let message = format!("the axis of `{}` does not move along the rack", wheel.name);
                let help = "make the guide of its carriage parallel to the teeth";
                incomplete(cx, &message, help, joint.name.span)
            })?,
            None => 1.0,
        };
        terms.push((Rate::Slide(axis.pair), sense * axis.sense));
    }
    if let (Some(line), Some(teeth)) = (&line, teeth)
        && let Some(at) = centre_on(cx, &wheel, axis.map_or(base, |axis| axis.link))
    {
        distance(cx, (&wheel, Placed { at, on: axis }), (line, rack), teeth, joint.name.span)?;
    }
    if base != LinkId::GROUND {
        terms.push((Rate::Turn(base), -wheel.radius));
    }
    if let (Some(span), true) = (loses, axis.is_some() || base != LinkId::GROUND) {
        cx.builder.unsupported("an efficiency of a rack whose wheel's axis moves", span);
    }
    let law = Law { terms, constant: 0.0, force: 1.0, efficiency: None };
    Some(Runs { laws: vec![law], links: vec![wheel.link, link], meeting: None })
}

/// ±1 where two directions are parallel; any are where one is open.
fn along(a: Vec2, b: Vec2, open: bool) -> Option<f64> {
    if open {
        return Some(1.0);
    }
    (a.cross(b).abs() <= SAME).then_some(a.dot(b).signum())
}

/// The base from which wheel and rack slide along each other. Reports a wheel whose distance from the rack nothing keeps.
fn meets(cx: &mut Context<'_>, wheel: &Wheel, rack: LinkId, bar: &Path, at: &Path) -> Option<Meets> {
    let axes = mates(cx, wheel);
    let guided = slides(cx, rack);
    // the wheel turns on what guides the rack
    let turns_on = |base: LinkId| axes.contains(&base) || turns_about(cx, base, wheel, &axes);
    if let Some(&rack) = guided.iter().find(|rack| turns_on(rack.base)) {
        return Some(Meets { base: rack.base, rack: Some(rack), axis: None });
    }
    // on the rack's own link rolls the wheel of a carriage
    for &axis in &axes {
        if let Some(axis) = slides(cx, axis).into_iter().find(|s| s.base == rack) {
            return Some(Meets { base: rack, rack: None, axis: Some(axis) });
        }
    }
    for &rack in &guided {
        for &axis in &axes {
            if let Some(axis) = slides(cx, axis).into_iter().find(|s| s.base == rack.base) {
                return Some(Meets { base: rack.base, rack: Some(rack), axis: Some(axis) });
            }
        }
    }
    if rack != LinkId::GROUND && guided.is_empty() {
        let message = format!("`{}` does not slide along a line", bar.head.node);
        let help = "name a `slider`, or a link with a prismatic pair";
        return incomplete(cx, &message, help, bar.span());
    }
    // the pair that does may be one with an error
    if cx.problems.has_errors() || !cx.pairs_complete() {
        return None;
    }
    let message = format!("nothing keeps the axis of `{}` at its distance from the rack", wheel.name);
    let help = "let the wheel turn on the link that guides the rack, or on one that slides along the rack: `slider cart` and \
                `shaft P on cart { … }`, or `prismatic D: cart.A - ground.teeth` and a revolute pair at the wheel's point";
    incomplete(cx, &message, help, at.span())
}
