//! Masses of links.

use super::mass_sum;
use crate::expr::context::Context;
use crate::expr::positive::{Want, not_negative, positive};
use crate::expr::property::given_twice;
use crate::trains::planet::{Carried, carried};
use crate::values::format_value::{format_value, format_value_like};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, MassPart, MassProperties, PairKind};
use assur_syntax::document::{At, Body, Expr, Member, Name, Statement};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::source::Span;
use assur_text::units::Dimension;

/// An inertia that is too small by less than this part is rounded.
const ROUNDING: f64 = 1e-12;

/// Gives all links their masses. Links, pairs and gravity must be known.
pub(crate) fn masses(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let turning = turning(cx);
    let mut ground = false;
    for statement in &doc.statements {
        let (link, body) = match &statement.node {
            Statement::Ground(g) if !std::mem::replace(&mut ground, true) => (Some(LinkId::GROUND), &g.body),
            Statement::Link(l) => (cx.own_link(&l.name), &l.body),
            // the mass of a shaft lies on its axis
            Statement::Shaft(s) => (cx.own_link(&s.name), &s.body),
            Statement::Slider(s) => (cx.own_link(&s.name), &s.body),
            _ => continue,
        };
        if let Some(link) = link {
            let element = !matches!(statement.node, Statement::Link(_) | Statement::Ground(_));
            let turning = if element { Turning::No } else { turning[link.index()] };
            plane_of_nothing(cx, link, body);
            if let Some((whole, mut parts)) = mass(cx, link, body, turning, !element) {
                planes(cx, body, whole, &mut parts);
                let link = &mut cx.builder.mech.links[link.index()];
                (link.mass, link.mass_parts) = (Some(whole), parts);
            }
        }
    }
    for statement in &doc.statements {
        if let Statement::Shaft(shaft) = &statement.node
            && let Some(link) = cx.own_link(&shaft.name)
        {
            of_planets(cx, link, &shaft.body);
        }
    }
}

/// Reports a plane of masses that are not there.
fn plane_of_nothing(cx: &mut Context<'_>, link: LinkId, body: &Body) {
    let is_mass = |member: &Member| matches!(member, Member::Mass(_) | Member::Weight(_));
    let plane = body.iter().find(|member| matches!(member.node, Member::Plane(_)));
    let Some(plane) = plane.filter(|_| !body.iter().any(|member| is_mass(&member.node))) else { return };
    let name = &cx.builder.mech.link(link).name;
    let message = format!("`{name}` has a plane and no mass: a plane is the place of masses along the axis");
    cx.error(
        Diagnosis::error("mech::geometry::plane_without_mass", message)
            .primary(plane.span, "of no mass")
            .help("add the mass, as in `mass 2 kg at S`, or leave the plane out; a counterweight has a `plane` of its own"),
    );
}

/// Enters the places of the masses along the axis.
fn planes(cx: &mut Context<'_>, body: &Body, whole: MassProperties, parts: &mut Vec<MassPart>) {
    let mut all = None;
    let mut own = Vec::new();
    for member in body {
        match &member.node {
            Member::Mass(at) | Member::Weight(at) => own.push(at.plane.as_ref()),
            Member::Plane(at) => match all {
                None => all = Some(at),
                Some(first) => cx.error(given_twice("the plane of all masses", member.span, first.span)),
            },
            _ => {}
        }
    }
    if all.is_none() && own.iter().all(Option::is_none) {
        return;
    }
    if parts.is_empty() {
        parts.push(MassPart { own: whole, shape: None, plane: 0.0 });
    }
    for (part, own) in parts.iter_mut().zip(own) {
        let Some(at) = own.or(all) else { continue };
        part.plane = cx.scalar_constant(at, &Want::LENGTH, "the plane of a mass").unwrap_or(0.0);
    }
}

/// The mass of planets without a position is that of all of them, evenly spaced about the axis of their carrier: their mass
/// centre lies on it, and they add m a² to the moment of inertia of the carrier.
fn of_planets(cx: &mut Context<'_>, planet: LinkId, body: &Body) {
    let stated = body.iter().find(|m| matches!(m.node, Member::Mass(_) | Member::Weight(_)));
    let (Some(member), Some(Carried { carrier, arm })) = (stated, carried(cx, planet)) else { return };
    let Some(mass) = cx.builder.mech.link(planet).mass.map(|m| m.mass) else { return };
    let Some(arm) = arm else {
        let what = "the mass of a planet whose distance from the axis of its carrier is not known";
        cx.builder.unsupported(what, member.span);
        return;
    };
    let none = MassProperties { mass: 0.0, centre: Vec2::zero(), inertia: 0.0 };
    let own = cx.builder.mech.links[carrier.index()].mass.get_or_insert(none);
    own.inertia += mass * arm * arm;
}

/// Whether a link can turn; unknown where nothing joins it or an error hides what does.
#[derive(Clone, Copy)]
enum Turning {
    No,
    Unknown,
    /// It turns; the first pair on it that lets it.
    Yes(Option<Span>),
}

/// A link that a chain of prismatic pairs joins with the ground keeps its angle; all others turn.
fn turning(cx: &Context<'_>) -> Vec<Turning> {
    let mut held = vec![false; cx.builder.mech.links.len()];
    held[0] = true;
    let slides = cx.builder.mech.pairs.iter().filter(|p| matches!(p.kind, PairKind::Prismatic(_)));
    let slides = slides.map(|p| p.kind.links()).collect::<Vec<_>>();
    loop {
        let before = held.iter().filter(|h| **h).count();
        for links in &slides {
            if links.iter().any(|l| held[l.index()]) {
                links.iter().for_each(|l| held[l.index()] = true);
            }
        }
        if held.iter().filter(|h| **h).count() == before {
            break;
        }
    }
    let mut turning = vec![Turning::Unknown; held.len()];
    if cx.pairs_complete() {
        for pair in &cx.builder.mech.pairs {
            let by = (!matches!(pair.kind, PairKind::Prismatic(_))).then_some(pair.span);
            for link in pair.kind.links() {
                let turns = &mut turning[link.index()];
                let before = if let Turning::Yes(before) = turns { *before } else { None };
                *turns = Turning::Yes(before.or(by));
            }
        }
    }
    let links = turning.into_iter().zip(held);
    links.map(|(turning, held)| if held { Turning::No } else { turning }).collect()
}

/// A mass as stated, or as weight over gravity.
pub(super) struct Stated<'a> {
    pub(super) at: &'a At,
    pub(super) span: Span,
    pub(super) weight: bool,
}

/// A moment of inertia as stated, and the point that it is about.
#[derive(Clone, Copy)]
pub(super) struct StatedInertia<'a> {
    pub(super) value: &'a Expr,
    pub(super) about: Option<&'a Name>,
    pub(super) span: Span,
}

/// The mass of a link from its members; where there are several or one has a shape, also each of them.
fn mass(
    cx: &mut Context<'_>,
    link: LinkId,
    body: &Body,
    turning: Turning,
    placed: bool,
) -> Option<(MassProperties, Vec<MassPart>)> {
    let (stated, inertia) = members(cx, link, body);
    if stated.is_empty() && inertia.is_none() {
        return None;
    }
    if link == LinkId::GROUND {
        on_ground(cx, stated.first().map(|s| s.span), inertia.map(|i| i.span));
    }
    if stated.len() > 1 || (placed && stated.iter().any(|one| one.at.shape.is_some())) {
        return mass_sum::several(cx, link, &stated, inertia, placed);
    }
    let stated = stated.first();
    let (mass, centre) = match stated {
        Some(stated) => {
            let mass = amount_of_mass(cx, link, stated);
            let centre = centre(cx, link, stated, mass, turning);
            (mass?, centre?)
        }
        None => (0.0, Vec2::zero()),
    };
    let of_part = stated.and_then(own_inertia);
    if let (Some(own), Some(whole)) = (of_part, inertia) {
        let name = cx.builder.mech.link(link).name.clone();
        cx.error(given_twice(&format!("the inertia of `{name}`"), whole.span, own.span));
    }
    let inertia = inertia.or(of_part);
    let about_centre = match (inertia, stated) {
        (Some(inertia), stated) => {
            let parts: Vec<_> = stated.map(|stated| (stated.span, mass, centre)).into_iter().collect();
            steiner(cx, link, inertia, &parts, (mass, centre))?
        }
        (None, Some(stated)) => {
            // what cannot be read may be the inertia
            let whole = !body.iter().any(|member| matches!(member.node, Member::Bad(_)));
            if whole && matches!(turning, Turning::Yes(_)) && inertia_counts(cx) {
                let rod = rod_meant(cx, link, stated, mass, centre);
                let link = cx.builder.mech.link(link).name.clone();
                cx.error(
                    Diagnosis::advice(
                        "mech::geometry::point_mass",
                        format!("`{link}` turns and has a mass but no inertia: it is taken as a point mass"),
                    )
                    .label(stated.span, "the whole mass at one point")
                    .help(format!(
                        "add `inertia 0.01 kg*m^2` with its own value, about the mass centre, if it is more \
                         than a point mass{rod}"
                    )),
                );
            }
            0.0
        }
        (None, None) => 0.0,
    };
    if let (None, Some(inertia)) = (stated, inertia) {
        without_mass(cx, link, body, turning, inertia.span);
    }
    Some((MassProperties { mass, centre, inertia: about_centre }, Vec::new()))
}

/// Of a mass in the middle between two points the rod that may be meant.
fn rod_meant(cx: &Context<'_>, link: LinkId, stated: &Stated<'_>, mass: f64, centre: Vec2) -> String {
    let points = &cx.builder.mech.link(link).points;
    let pairs = points.iter().enumerate().flat_map(|(i, b)| points[..i].iter().map(move |a| (a, b)));
    let mut around = pairs.filter(|(a, b)| {
        let length = (b.at - a.at).norm();
        length > 0.0 && ((a.at + b.at) * 0.5 - centre).norm() <= ROUNDING * length
    });
    match around.next() {
        Some((a, b)) => {
            format!("; of a uniform rod write `{} rod {} to {}`", written(cx, stated, mass), a.name, b.name)
        }
        None => String::new(),
    }
}

/// The inertia that stands with a mass: about its point.
pub(super) fn own_inertia<'a>(stated: &Stated<'a>) -> Option<StatedInertia<'a>> {
    stated.at.inertia.as_ref().map(|value| StatedInertia { value, about: None, span: value.span })
}

/// Masses of the ground have no effect.
fn on_ground(cx: &mut Context<'_>, mass: Option<Span>, inertia: Option<Span>) {
    for (what, span) in [("mass", mass), ("inertia", inertia)] {
        if let Some(span) = span {
            cx.error(
                Diagnosis::warning(
                    "mech::geometry::mass_on_ground",
                    format!("the ground is fixed, so its {what} has no effect"),
                )
                .label(span, "on the ground")
                .help("leave it out, or give it to the moving link")
                .left_out(&format!("this {what}"), span),
            );
        }
    }
}

/// Notes an inertia without a mass. Of a link that turns about a hinge of the ground an inertia may be all that is given, but for its weight.
fn without_mass(cx: &mut Context<'_>, link: LinkId, body: &Body, turning: Turning, span: Span) {
    let whole = !body.iter().any(|member| matches!(member.node, Member::Bad(_)));
    let has = |p: &PairKind, link| p.links().contains(&link);
    let about_ground = cx.builder.mech.pairs.iter().map(|p| &p.kind);
    let about_ground = about_ground.filter(|p| matches!(p, PairKind::Revolute(_)));
    let fixed = about_ground.into_iter().any(|p| has(p, link) && has(p, LinkId::GROUND));
    let is_idle = fixed && cx.builder.mech.gravity.is_none();
    if whole && !is_idle && matches!(turning, Turning::Yes(_)) && inertia_counts(cx) {
        let point = cx.point_meant(link).unwrap_or("S").to_owned();
        let link = cx.builder.mech.link(link).name.clone();
        cx.error(
            Diagnosis::advice(
                "mech::geometry::point_mass",
                format!(
                    "`{link}` moves and has an inertia but no mass: its weight and the force of its mass \
                     are left out"
                ),
            )
            .label(span, "without a mass")
            .help(format!("add `mass 1 kg at {point}` with its own value")),
        );
    }
}

/// Whether the machine moves with a speed, so that inertia forces act.
pub(crate) fn inertia_counts(cx: &Context<'_>) -> bool {
    let statements = || cx.doc.statements.iter().map(|s| &s.node);
    let moves = |s: &Statement| match s {
        Statement::Drive(drive) => drive.rate.is_some(),
        Statement::Simulate(_) => true,
        _ => false,
    };
    statements().any(moves) && !statements().any(|s| matches!(s, Statement::Ignore(_)))
}

/// The masses and the inertia stated in a body; reports a second inertia.
fn members<'a>(
    cx: &mut Context<'_>,
    link: LinkId,
    body: &'a Body,
) -> (Vec<Stated<'a>>, Option<StatedInertia<'a>>) {
    let mut masses = Vec::new();
    let mut inertia: Option<StatedInertia<'a>> = None;
    for member in body {
        let span = member.span;
        match &member.node {
            Member::Mass(at) | Member::Weight(at) => {
                masses.push(Stated { at, span, weight: matches!(member.node, Member::Weight(_)) });
            }
            Member::Inertia(about) => {
                let Some(first) = inertia else {
                    inertia = Some(StatedInertia { value: &about.value, about: about.about.as_ref(), span });
                    continue;
                };
                let name = cx.builder.mech.link(link).name.clone();
                // one habit, not a mistake each
                if cx.problems.reported.insert(("inertia", name.clone())) {
                    cx.error(given_twice(&format!("the inertia of `{name}`"), span, first.span));
                }
            }
            _ => {}
        }
    }
    (masses, inertia)
}

pub(super) fn amount_of_mass(cx: &mut Context<'_>, link: LinkId, stated: &Stated<'_>) -> Option<f64> {
    let name = cx.builder.mech.link(link).name.clone();
    if !stated.weight {
        return positive(cx, &stated.at.value, Dimension::MASS, &format!("the mass of `{name}`"));
    }
    let weight = positive(cx, &stated.at.value, Dimension::FORCE, &format!("the weight of `{name}`"))?;
    over_gravity(cx, link, stated, weight, Dimension::FORCE)
}

/// The mass of a weight, or that per length, area or volume.
pub(super) fn over_gravity(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &Stated<'_>,
    weight: f64,
    dimension: Dimension,
) -> Option<f64> {
    let name = cx.builder.mech.link(link).name.clone();
    if let Some(gravity) = cx.builder.mech.gravity {
        let g = gravity.acceleration;
        return Some(weight / libm::hypot(g.x, g.y));
    }
    let declared = cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Gravity(_)));
    let mut first = || cx.problems.reported.insert(("gravity", "of a weight".to_owned()));
    if !declared && !cx.names.bad.contains("gravity") && first() {
        let weight = format_value_like(&cx.names, weight, dimension, &stated.at.value);
        cx.error(
            Diagnosis::error(
                "mech::geometry::weight_without_gravity",
                format!("the weight of `{name}` needs `gravity`, which the file does not declare"),
            )
            .label(stated.span, "a weight is a mass times gravity")
            .help(format!(
                "add `gravity 9.81 m/s^2`; or, if the weight itself must not act, write `given g = 9.81 \
                 m/s^2` and `mass {weight} / g`"
            ))
            .fixes([Fix::line("gravity 9.81 m/s^2")]),
        );
    }
    None
}

/// Where the mass sits; on a link that cannot turn this is of no account.
fn centre(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &Stated<'_>,
    mass: Option<f64>,
    turning: Turning,
) -> Option<Vec2> {
    if let Some(at) = &stated.at.at {
        return cx.point(link, at);
    }
    let pair = match turning {
        Turning::No => return Some(Vec2::zero()),
        Turning::Unknown => return None,
        Turning::Yes(pair) => pair,
    };
    let (member, own) = (written(cx, stated, mass?), written_inertia(cx, stated));
    let point = cx.point_meant(link).map(str::to_owned);
    let link = cx.builder.mech.link(link).name.clone();
    let point = point.unwrap_or_else(|| "S".into());
    let error = Diagnosis::error(
        "mech::geometry::mass_without_place",
        format!("the mass of `{link}` needs a mass centre, because `{link}` turns"),
    )
    .primary(stated.span, "the point is missing")
    .label(pair, format!("`{link}` turns on this pair"))
    .help(format!("give the mass centre: `{member} at {point}{own}`"))
    .fixes(Fix::quoted(&format!("write `{member} at {point}{own}`"), stated.span));
    cx.error(error);
    None
}

/// A mass or weight as its member begins.
pub(super) fn written(cx: &Context<'_>, stated: &Stated<'_>, mass: f64) -> String {
    let value = &stated.at.value;
    match cx.builder.mech.gravity {
        Some(gravity) if stated.weight => {
            let g = gravity.acceleration.norm();
            format!("weight {}", format_value_like(&cx.names, mass * g, Dimension::FORCE, value))
        }
        _ => format!("mass {}", format_value_like(&cx.names, mass, Dimension::MASS, value)),
    }
}

/// The inertia of a part as its member ends.
pub(super) fn written_inertia(cx: &mut Context<'_>, stated: &Stated<'_>) -> String {
    let Some(value) = &stated.at.inertia else { return String::new() };
    match cx.scalar_constant(value, &Want(Dimension::INERTIA), "the inertia") {
        Some(x) => format!(" inertia {}", format_value_like(&cx.names, x, Dimension::INERTIA, value)),
        None => String::new(),
    }
}

/// The moment of inertia about the mass centre: J_S = J_P − m d² (Huygens and Steiner). The masses alone have Σ m_i d_i².
pub(super) fn steiner(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: StatedInertia<'_>,
    parts: &[(Span, f64, Vec2)],
    (mass, centre): (f64, Vec2),
) -> Option<f64> {
    let what = format!("the inertia of `{}`", cx.builder.mech.link(link).name);
    let inertia = not_negative(cx, stated.value, Dimension::INERTIA, &what);
    let about = match stated.about {
        Some(point) => cx.point(link, point).map(Some),
        None => Some(None),
    };
    let (inertia, about) = (inertia?, about?);
    let (Some(point), Some(name), false) = (about, stated.about, parts.is_empty()) else {
        return Some(inertia);
    };
    let arm = point - centre;
    let least: f64 = parts.iter().map(|(_, mass, at)| mass * (point - *at).dot(point - *at)).sum();
    let left = inertia - least;
    if left >= 0.0 || -left <= ROUNDING * least {
        return Some((inertia - mass * arm.dot(arm)).max(0.0));
    }
    let inertia_text = |x| format_value_like(&cx.names, x, Dimension::INERTIA, stated.value);
    let point_name = name.node.clone();
    let inertia = inertia_text(inertia);
    let (is, but, help) = if let [(_, mass, at)] = parts {
        let mass = format_value(*mass, Dimension::MASS);
        let distance = format_value((point - *at).norm(), Dimension::LENGTH);
        (
            format!(
                "less than the {} of the mass of {mass} at a distance of {distance}",
                inertia_text(least)
            ),
            format!("{mass}, {distance} from `{point_name}`"),
            format!(
                "leave out `about {point_name}` if the value is about the mass centre; as written, about the \
                 mass centre it would be negative ({})",
                inertia_text(left)
            ),
        )
    } else {
        (
            format!("less than the {} of the masses at their distances from it", inertia_text(least)),
            "one of the masses".to_owned(),
            "give each mass the inertia about its own point: `mass … at … inertia …`".to_owned(),
        )
    };
    let error = Diagnosis::error(
        "mech::geometry::inertia_too_small",
        format!("the inertia about `{point_name}` is {inertia}, {is}"),
    )
    .primary(stated.value.span, &inertia)
    .label(parts.first().map(|p| p.0), but)
    .help(help);
    cx.error(error);
    None
}
