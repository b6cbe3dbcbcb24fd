//! The link that holds the axes of two wheels at a distance: rates of the wheels are counted from it.

use crate::expr::context::Context;
use assur_math::math::SAME;
use assur_model::model::{Bearing, LinkId, Pair, PairKind, Pin, Wheel};
use assur_syntax::document::Statement;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// The carrier of two wheels. Reports two wheels that none holds.
pub(crate) fn carrier(cx: &mut Context<'_>, first: &Wheel, second: &Wheel, span: Span) -> Option<LinkId> {
    let (a, b) = (mates(cx, first), mates(cx, second));
    // the ground before any other
    let mut common: Vec<LinkId> = a.iter().copied().filter(|l| b.contains(l)).collect();
    common.sort_unstable();
    let found = common
        .first()
        .copied()
        .or_else(|| b.iter().copied().find(|&h| turns_about(cx, h, first, &a)))
        .or_else(|| a.iter().copied().find(|&h| turns_about(cx, h, second, &b)));
    if found.is_none() {
        none(cx, first, second, (&a, &b), span);
    }
    found
}

/// The links on which a wheel turns about its axis; the ground of a wheel of the ground.
pub(crate) fn mates(cx: &Context<'_>, wheel: &Wheel) -> Vec<LinkId> {
    if wheel.link == LinkId::GROUND {
        return vec![LinkId::GROUND];
    }
    let mut found: Vec<LinkId> = Vec::new();
    for pins in hinges(cx) {
        let here = |p: &&Pin| p.link == wheel.link && wheel.centre.is_none_or(|c| near(p.at, c));
        if pins.iter().any(|p| here(&p)) {
            found.extend(pins.iter().map(|p| p.link).filter(|l| *l != wheel.link));
        }
    }
    found.dedup();
    found
}

fn hinges<'c>(cx: &'c Context<'_>) -> impl Iterator<Item = &'c [Pin]> {
    cx.builder.mech.pairs.iter().filter_map(|p| match &p.kind {
        PairKind::Revolute(pins) => Some(pins.as_slice()),
        _ => None,
    })
}

fn near(a: assur_math::math::Vec2, b: assur_math::math::Vec2) -> bool {
    (a - b).norm() <= SAME * (a.norm() + b.norm())
}

/// Whether a link turns about the axis of a wheel: on one of those that the wheel turns on, at the same place.
pub(super) fn turns_about(cx: &Context<'_>, link: LinkId, wheel: &Wheel, mates: &[LinkId]) -> bool {
    if link == LinkId::GROUND {
        return false;
    }
    hinges(cx).any(|pins| {
        let on = pins.iter().find(|p| mates.contains(&p.link));
        let own = pins.iter().any(|p| p.link == link);
        own && on.is_some_and(|on| match centre_on(cx, wheel, on.link) {
            Some(centre) => is_open(cx, pins) || near(centre, on.at),
            None => true,
        })
    })
}

fn is_open(cx: &Context<'_>, pins: &[Pin]) -> bool {
    let of = |p: &&Pair| matches!(&p.kind, PairKind::Revolute(q) if std::ptr::eq(q.as_slice(), pins));
    cx.builder.mech.pairs.iter().find(of).is_some_and(|p| p.bearing == Some(Bearing::Open))
}

/// The axis of a wheel in the frame of a link that it turns on, where that is known.
pub(crate) fn centre_on(cx: &Context<'_>, wheel: &Wheel, link: LinkId) -> Option<assur_math::math::Vec2> {
    let centre = wheel.centre?;
    if wheel.link == link {
        return Some(centre);
    }
    hinges(cx).find_map(|pins| {
        let own = pins.iter().any(|p| p.link == wheel.link && near(p.at, centre));
        pins.iter().find(|p| own && p.link == link).map(|p| p.at)
    })
}

fn none(cx: &mut Context<'_>, first: &Wheel, second: &Wheel, on: (&[LinkId], &[LinkId]), span: Span) {
    let turns = |wheel: &Wheel, on: &[LinkId]| {
        let names: Vec<String> = on.iter().map(|l| format!("`{}`", cx.builder.mech.link(*l).name)).collect();
        match names.as_slice() {
            [] => format!("`{}` has no axis", wheel.name),
            names => format!("`{}` turns on {}", wheel.name, names.join(" and ")),
        }
    };
    let why = format!("{}, {}", turns(first, on.0), turns(second, on.1));
    let help = "let both turn on the ground, or on one carrier: `shaft P on H { … }`; a wheel on a link turns on the link \
                that a revolute pair joins to the wheel's point"
        .to_owned();
    cx.error(
        Diagnosis::error(
            "mech::train::no_carrier",
            format!(
                "no link holds the axes of `{}` and `{}` at a fixed distance: {why}",
                first.name, second.name
            ),
        )
        .primary(span, "joins them")
        .help(help),
    );
}

/// Reports a shaft of the ground that meshes with a wheel of the ground: it cannot turn. Where the
/// file has a bare shaft that is its carrier.
pub(crate) fn turns_at_all(cx: &mut Context<'_>, fixed: &Wheel, planet: &Wheel, span: Span) -> Option<()> {
    let shafts = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Shaft(shaft) => Some(shaft),
        _ => None,
    });
    let shafts: Vec<_> = shafts.collect();
    let own = shafts.iter().find(|s| cx.find_link(&s.name.node) == Some(planet.link) && s.on.is_none());
    let (LinkId::GROUND, Some(own)) = (fixed.link, own) else { return Some(()) };
    let name = &own.name.node;
    let bare = shafts.iter().filter(|s| s.body.is_empty() && s.name.node != *name);
    let bare = bare.map(|s| format!("`shaft {name} on {} {{`", s.name.node)).collect::<Vec<_>>();
    if bare.is_empty() {
        return Some(()); // a gear pair whose geometry is asked
    }
    let help = format!("let it turn on its carrier: write {}", bare.join(" or "));
    cx.error(
        Diagnosis::error(
            "mech::train::no_carrier",
            format!(
                "`{name}` cannot turn: its axis is on the ground and it meshes with the \
                 fixed wheel `{}`",
                fixed.name
            ),
        )
        .primary(span, "with a fixed wheel")
        .label(own.name.span, "on the ground")
        .help(help),
    );
    None
}
