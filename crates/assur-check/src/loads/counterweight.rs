//! `counterweight X on rotor { radius 100 mm; plane 100 mm }`: one balances a link about its hinge, Σ m r = 0; two in different planes
//! balance the couple too, Σ m r z = 0.

use crate::expr::context::Context;
use crate::expr::property::{Read, find, given_twice, read};
use assur_math::math::Vec2;
use assur_model::model::{self, LinkId, MassPart, MassProperties, PairKind, Point};
use assur_syntax::document::{Counterweight, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::COUNTERWEIGHT;
use assur_text::source::Span;

/// A moment of less than this part of those that it balances is rounding.
const ROUNDING: f64 = 1e-13;

/// A counterweight as written.
struct Wanted<'a> {
    stated: &'a Counterweight,
    /// Its radius or its mass, whichever is given.
    radius: Option<f64>,
    mass: f64,
    plane: f64,
}

/// Finds all counterweights and gives them to their links. Links, pairs and masses must be known.
pub(crate) fn counterweights(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let mut of_links: Vec<(LinkId, Vec<Option<Wanted<'_>>>)> = Vec::new();
    for statement in &doc.statements {
        let Statement::Counterweight(stated) = &statement.node else { continue };
        let wanted = wanted(cx, stated);
        let Some(link) = cx.link(&stated.on) else { continue };
        match of_links.iter_mut().find(|(of, _)| *of == link) {
            Some((_, all)) if all.len() == 2 => {
                let what = format!("`{}` has three counterweights", stated.on.node);
                let help = "leave one out: one balances the forces, two in different planes the couple too";
                wrong::<()>(cx, stated.name.span, what, "one too many", help);
            }
            Some((_, all)) => all.push(wanted),
            None => of_links.push((link, vec![wanted])),
        }
    }
    for (link, all) in of_links {
        if let Some(all) = all.into_iter().collect::<Option<Vec<_>>>() {
            balance(cx, link, &all);
        }
    }
}

fn wanted<'a>(cx: &mut Context<'_>, stated: &'a Counterweight) -> Option<Wanted<'a>> {
    let properties = read(cx, "a counterweight", &stated.properties, COUNTERWEIGHT)?;
    let number = |name| find(&properties, name).map(Read::number);
    match (find(&properties, "radius"), find(&properties, "mass")) {
        (Some(radius), Some(mass)) => {
            let what = format!("the moment of `{}`", stated.name.node);
            cx.error(
                given_twice(&what, mass.span, radius.span).help("leave out the one that is to be found"),
            );
            return None;
        }
        (None, None) => {
            let what = format!("neither the radius nor the mass of `{}` is given", stated.name.node);
            let help = "add `radius 100 mm` to find its mass, or `mass 2 kg` to find its radius";
            return wrong(cx, stated.name.span, what, "not known", help);
        }
        _ => {}
    }
    let (radius, mass) = (number("radius"), number("mass").unwrap_or(0.0));
    Some(Wanted { stated, radius, mass, plane: number("plane").unwrap_or(0.0) })
}

/// The place in a link of its hinge on the ground.
fn hinge(cx: &Context<'_>, link: LinkId) -> Option<Vec2> {
    cx.builder.mech.pairs.iter().find_map(|pair| match &pair.kind {
        PairKind::Revolute(pins) if pins.iter().any(|pin| pin.link == LinkId::GROUND) => {
            pins.iter().find(|pin| pin.link == link).map(|pin| pin.at)
        }
        _ => None,
    })
}

fn balance(cx: &mut Context<'_>, link: LinkId, all: &[Wanted<'_>]) -> Option<()> {
    let first = all.first()?;
    let name = first.stated.on.node.clone();
    let Some(hinge) = hinge(cx, link).filter(|_| link != LinkId::GROUND) else {
        if !cx.pairs_complete() {
            return None;
        }
        let what = format!("`{name}` has no hinge on the ground, about which it could be balanced");
        let help = format!("balance a link that turns about the ground: `revolute O: ground - {name}`");
        return wrong(cx, first.stated.on.span, what, "to be balanced", &help);
    };
    if let [one, other] = all
        && one.plane == other.plane
    {
        let what = format!("both counterweights of `{name}` are in the same plane");
        let help = "give them different planes, as `plane 100 mm` and `plane 500 mm`; or leave one out";
        return wrong(cx, other.stated.name.span, what, "in the plane of the first", help);
    }
    let mut parts = cx.builder.mech.link(link).mass_parts.clone();
    let whole = cx.builder.mech.link(link).mass;
    if let (true, Some(own)) = (parts.is_empty(), whole) {
        parts.push(MassPart { own, shape: None, plane: 0.0 });
    }
    let own = parts.clone();
    for one in all {
        // the share of the moment of each mass that falls to this one
        let share = |part: &MassPart| match all.iter().find(|other| other.plane != one.plane) {
            Some(other) => (other.plane - part.plane) / (other.plane - one.plane),
            None => 1.0,
        };
        let moment = |part: &MassPart| (part.own.centre - hinge) * (part.own.mass * share(part));
        let sum = own.iter().fold(Vec2::zero(), |sum, part| sum - moment(part));
        let most = own.iter().map(|part| moment(part).norm()).sum::<f64>();
        let found = found(cx, one, if sum.norm() <= ROUNDING * most { Vec2::zero() } else { sum });
        let centre = hinge + Vec2::new(libm::cos(found.angle), libm::sin(found.angle)) * found.radius;
        if found.mass > 0.0 {
            let own = MassProperties { mass: found.mass, centre, inertia: 0.0 };
            parts.push(MassPart { own, shape: None, plane: one.plane });
            let (name, span) = (found.name.clone(), one.stated.name.span);
            cx.builder.mech.links[link.index()].points.push(Point { name, span, at: centre });
        }
        cx.builder.mech.counterweights.push(found);
    }
    // without the rounding of the sums
    let whole = MassProperties { centre: hinge, ..MassProperties::of_parts(&parts) };
    let link = &mut cx.builder.mech.links[link.index()];
    (link.mass, link.mass_parts) = ((whole.mass > 0.0).then_some(whole), parts);
    Some(())
}

/// Mass or radius, and the direction, of a moment m r.
fn found(cx: &mut Context<'_>, wanted: &Wanted<'_>, moment: Vec2) -> model::Counterweight {
    let Wanted { stated, .. } = wanted;
    let (name, size) = (stated.name.node.clone(), moment.norm());
    let (mass, radius) = match wanted.radius {
        Some(radius) => (size / radius, radius),
        None => (wanted.mass, size / wanted.mass),
    };
    if size == 0.0 {
        cx.error(
            Diagnosis::advice(
                "mech::geometry::counterweight",
                format!("`{}` is already balanced: `{name}` has no moment", stated.on.node),
            )
            .label(stated.name.span, "nothing to balance")
            .help("leave it out, or add the masses that it balances to the link"),
        );
    }
    let angle = if size == 0.0 { 0.0 } else { libm::atan2(moment.y, moment.x) };
    model::Counterweight { name, mass, radius, angle }
}

fn wrong<T>(cx: &mut Context<'_>, at: Span, what: String, label: &str, help: &str) -> Option<T> {
    cx.error(Diagnosis::error("mech::geometry::counterweight", what).label(at, label).help(help));
    None
}
