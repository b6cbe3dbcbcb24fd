//! Bevel wheels: their axes meet, so that a planet turns about its own axis, which its carrier carries round.

use crate::expr::{
    context::Context,
    property::{Read, Value, find},
};
use crate::statements::written::{braces, end_text};
use crate::trains::planet::is_planet;
use assur_model::model::{Bevel, LinkId, PairId, PairKind, Rate, TransmissionKind, Wheel};
use assur_syntax::document::{Joint, JointKind, Member, Statement};
use assur_text::diagnostic::{Diagnosis, Fix, Help};
use assur_text::source::{Edit, Span};

/// Properties of teeth in a plane.
const OF_A_PLANE: [&str; 6] = ["internal", "pressure_angle", "addendum", "clearance", "shift", "phase"];

/// The side of the planet on which a mesh of bevel wheels is; none of other wheels.
pub(crate) fn side(properties: &[Read]) -> Option<Bevel> {
    let property = find(properties, "bevel")?;
    Some(if property.value == Value::Flag { Bevel::Near } else { Bevel::Far })
}

/// Reports what bevel wheels cannot have.
pub(crate) fn fits(cx: &mut Context<'_>, properties: &[Read]) -> Option<()> {
    if let Some(other) = OF_A_PLANE.iter().find_map(|name| find(properties, name)) {
        let message = format!("`{}` is for wheels in one plane", other.name);
        let help = match other.name {
            "internal" => "leave it out: `bevel far` is a wheel on the other side of the planet",
            _ => "leave it out: the speeds and torques of bevel wheels need the teeth alone",
        };
        return no_place(cx, &message, help.into(), other.span);
    }
    Some(())
}

fn no_place<T>(cx: &mut Context<'_>, message: &str, help: Help, span: Span) -> Option<T> {
    let message = format!("{message}: bevel wheels have no place in the plane");
    cx.error(Diagnosis::error("mech::train::bevel", message).primary(span, "with bevel wheels").help(help));
    None
}

/// The terms of a mesh of bevel wheels, a planet second: it turns relative to the carrier already.
pub(crate) fn terms(
    cx: &mut Context<'_>,
    wheels: [(&Wheel, f64); 2],
    carrier: LinkId,
    span: Span,
) -> Option<Vec<(Rate, f64)>> {
    let planets = wheels.map(|(wheel, _)| is_planet(cx, wheel, carrier));
    let mut terms = wheels.map(|(wheel, c)| (Rate::Turn(wheel.link), c)).to_vec();
    if planets == [true, true] {
        let help = "let the planet mesh with a wheel that turns about the axis of the carrier".into();
        return no_place(cx, "both wheels are on the same carrier", help, span);
    }
    if planets[0] {
        terms.reverse();
    }
    if planets != [false, false] {
        terms.push((Rate::Turn(carrier), -terms[0].1));
    }
    Some(terms)
}

/// The planets of bevel wheels with their carriers, and the places of their meshes.
fn all(cx: &Context<'_>) -> Vec<(LinkId, LinkId, Span)> {
    let pairs = cx.builder.mech.pairs.iter();
    let planets = pairs.filter_map(|pair| match &pair.kind {
        PairKind::Transmission(t) => t.bevel_planet().map(|(planet, carrier)| (planet, carrier, pair.span)),
        _ => None,
    });
    planets.collect()
}

/// Whether a pair is the bearing of a bevel planet, which turns about an axis of its own.
pub(crate) fn carries(cx: &Context<'_>, pair: PairId) -> bool {
    let own = cx.builder.mech.pair(pair);
    let last = own.kind.links().last().copied();
    own.bearing.is_some() && all(cx).iter().any(|planet| Some(planet.0) == last)
}

/// Bevel planets turn relative to their carriers. Reports other transmissions that count them from elsewhere.
pub(crate) fn planets(cx: &mut Context<'_>) {
    let planets = all(cx);
    let of = |link: &LinkId| planets.iter().find(|planet| planet.0 == *link).copied();
    let mut mixed = Vec::new();
    for pair in &mut cx.builder.mech.pairs {
        let PairKind::Transmission(t) = &mut pair.kind else { continue };
        let Some(planet) = t.links.iter().find_map(of).filter(|_| t.bevel.is_none()) else { continue };
        let on = |link| of(link).is_some_and(|other| other.1 == planet.1);
        let wheels =
            matches!(t.kind, TransmissionKind::Mesh | TransmissionKind::Belt | TransmissionKind::Chain);
        if wheels && t.links.iter().all(on) {
            // both turn relative to the carrier
            t.laws.iter_mut().for_each(|law| law.terms.truncate(2));
        } else {
            mixed.push((pair.name.clone(), pair.span, planet));
        }
    }
    for (name, span, (planet, carrier, with)) in mixed {
        let [planet, carrier] = [planet, carrier].map(|link| cx.builder.mech.link(link).name.clone());
        let meshes = cx.doc.statements.iter().filter_map(|statement| match &statement.node {
            Statement::Joint(joint) if joint.name.node == name => Some(joint),
            _ => None,
        });
        let mesh = meshes.into_iter().find(|joint| joint.kind.node == JointKind::Mesh);
        let both = mesh.map(|joint| ["bevel", "bevel far"].map(|word| as_bevel(joint, word)));
        let (help, fixes) = match both {
            Some([(near, a), (far, b)]) => {
                let fix = |line: &str, edit| Fix {
                    title: format!("write `{line}`"),
                    edits: vec![edit],
                    certain: false,
                };
                (format!("write `{near}` or `{far}`"), vec![fix(&near, a), fix(&far, b)])
            }
            None => (format!("let `{name}` join shafts that turn about the axis of `{carrier}`"), Vec::new()),
        };
        let across = format!("`{planet}` turns about an axis across that of `{carrier}`");
        cx.error(
            Diagnosis::error(
                "mech::train::bevel",
                format!("{across}, and `{name}` is no mesh of bevel wheels"),
            )
            .primary(span, format!("joins `{planet}`"))
            .label(with, "of bevel wheels")
            .help(help)
            .fixes(fixes),
        );
    }
    heavy(cx, &planets);
}

/// Reports masses of bevel planets: how far from the carrier's axis they are is not known.
fn heavy(cx: &mut Context<'_>, planets: &[(LinkId, LinkId, Span)]) {
    for statement in &cx.doc.statements {
        let Statement::Shaft(shaft) = &statement.node else { continue };
        let Some((_, carrier, _)) = planets.iter().find(|p| cx.find_link(&shaft.name.node) == Some(p.0))
        else {
            continue;
        };
        let mass = shaft.body.iter().find(|m| matches!(m.node, Member::Mass(_) | Member::Weight(_)));
        if let Some(mass) = mass {
            let carrier = &cx.builder.mech.link(*carrier).name;
            let help =
                format!("give `{carrier}` its `inertia` with the planets, m a² each, and leave the mass out");
            let message =
                format!("the mass of `{}` has no distance from the axis of `{carrier}`", shaft.name.node);
            no_place::<()>(cx, &message, help.into(), mass.span);
        }
    }
}

/// The line of a mesh with a word of bevel wheels in its braces, and what writes it.
pub(crate) fn as_bevel(joint: &Joint, word: &str) -> (String, Edit) {
    let ends = joint.ends.iter().map(end_text).collect::<Vec<_>>().join(" - ");
    let line = format!("mesh {}: {ends}{}", joint.name.node, braces(&joint.properties, &[word]));
    let edit = match (joint.properties.first(), joint.ends.last()) {
        (Some(first), _) => Edit::new(Span::new(first.span.start, first.span.start), format!("{word}; ")),
        (None, Some(end)) => Edit::new(Span::new(end.span().end, end.span().end), format!(" {{ {word} }}")),
        (None, None) => Edit::new(joint.name.span, joint.name.node.clone()),
    };
    (line, edit)
}
