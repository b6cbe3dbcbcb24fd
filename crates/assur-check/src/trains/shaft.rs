//! Shafts and sliders are links that bring their pair along: a revolute, a guide. Its place is left open, unless a wheel
//! of the shaft is placed at a point of what carries it.

use crate::expr::context::Context;
use assur_math::math::Vec2;
use assur_model::model::{Bearing, Guide, LinkId, Pair, PairId, PairKind, Pin};
use assur_syntax::document::{Body, Member, Name, Shaft, Slider, Statement};
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::source::Span;

const ORIGIN: Vec2 = Vec2::new(0.0, 0.0);
/// The axis of an open slider: positive where the rope pays out of a wheel turning ccw.
const AXIS: Vec2 = Vec2::new(1.0, 0.0);

/// Enters the pairs of shafts and sliders into the mechanism. Links must have their points.
pub(crate) fn shafts(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        match &statement.node {
            Statement::Shaft(shaft) => {
                if let Some(link) = cx.own_link(&shaft.name) {
                    of_shaft(cx, shaft, link);
                }
            }
            Statement::Slider(slider) => {
                if let Some(link) = cx.own_link(&slider.name) {
                    of_slider(cx, slider, link);
                }
            }
            _ => {}
        }
    }
}

fn of_shaft(cx: &mut Context<'_>, shaft: &Shaft, link: LinkId) {
    members(cx, &shaft.body, "a shaft", true);
    let base = match &shaft.on {
        None => LinkId::GROUND,
        Some(on) => {
            let Some(base) = cx.link(on) else { return };
            if base == link {
                let (name, span) = (shaft.name.node.clone(), on.span);
                cx.error(
                    Diagnosis::error(
                        "mech::geometry::incomplete",
                        format!("shaft `{name}` cannot turn on itself"),
                    )
                    .label(span, "the shaft itself")
                    .help("name the carrier: another shaft or a link"),
                );
                return;
            }
            base
        }
    };
    let Some(place) = place(cx, &shaft.body, base) else { return };
    let (bearing, at) = place.map_or((Bearing::Open, ORIGIN), |(_, at)| (Bearing::Placed, at));
    let point = place.map_or_else(String::new, |(name, _)| name.node.clone());
    let pin = |link, at| Pin { link, name: point.clone(), at };
    let kind = PairKind::Revolute(vec![pin(base, at), pin(link, ORIGIN)]);
    push(cx, &shaft.name, kind, bearing);
}

/// Where the wheels of a shaft are placed, if they are. `None` where this has an error.
fn place<'b>(cx: &mut Context<'_>, body: &'b Body, base: LinkId) -> Option<Option<(&'b Name, Vec2)>> {
    let places = body.iter().filter_map(|m| match &m.node {
        Member::Wheel(wheel) => wheel.at.as_ref(),
        _ => None,
    });
    let places: Vec<&Name> = places.collect();
    let Some(first) = places.first() else { return Some(None) };
    let at = cx.point(base, first)?;
    for other in &places[1..] {
        if cx.point(base, other)? != at {
            cx.error(
                Diagnosis::error(
                    "mech::geometry::incomplete",
                    format!("`{}` and `{}` are two axes of one shaft", first.node, other.node),
                )
                .label(other.span, "another axis")
                .help("use two shafts: all wheels of a shaft are on one axis"),
            );
            return None;
        }
    }
    Some(Some((first, at)))
}

fn of_slider(cx: &mut Context<'_>, slider: &Slider, link: LinkId) {
    members(cx, &slider.body, "a slider", false);
    let guide = Guide {
        slider: link,
        point_name: String::new(),
        point: ORIGIN,
        direction: AXIS,
        own_line: None,
        guide: LinkId::GROUND,
        line_name: String::new(),
        through: ORIGIN,
        along: AXIS,
        contacts: None,
        guide_first: false,
    };
    push(cx, &slider.name, PairKind::Prismatic(guide), Bearing::Open);
}

fn push(cx: &mut Context<'_>, name: &Name, kind: PairKind, bearing: Bearing) {
    let id = PairId::at(cx.builder.mech.pairs.len());
    let (name, span) = (name.node.clone(), name.span);
    cx.names.pairs.entry(name.clone()).or_insert(id);
    cx.builder.hinges.enter_guide(&kind, id);
    cx.builder.mech.pairs.push(Pair { name, span, kind, friction: None, bearing: Some(bearing) });
}

/// Reports what a shaft or a slider cannot have.
fn members(cx: &mut Context<'_>, body: &Body, what: &str, turns: bool) {
    for member in body {
        if let Member::Point(point) = &member.node
            && let Some(word) = did_you_mean(&point.name.node, ["wheel", "mass", "inertia"]).first()
        {
            let (found, span) = (&point.name.node, point.name.span);
            cx.error(
                Diagnosis::error("mech::syntax::misspelt_word", format!("`{found}` is not known here"))
                    .primary(span, format!("did you mean `{word}`?"))
                    .help(Help::write(span, &[(*word).to_owned()])),
            );
            continue;
        }
        let (is, help) = match &member.node {
            Member::Mass(at) | Member::Weight(at) if at.shape.is_some() || at.plane.is_some() => {
                ("a mass with a shape or a plane", "write the mass alone, and `inertia` where it turns")
            }
            Member::Plane(_) => ("a plane", "give the mass and its plane to a `link`"),
            Member::Mass(at) | Member::Weight(at) if at.inertia.is_none() || turns => continue,
            Member::Bad(_) => continue,
            Member::Wheel(_) if turns => continue,
            Member::Inertia(_) if turns => continue,
            Member::Wheel(_) => ("a wheel", "give wheels to shafts and links: `shaft I { wheel w1 … }`"),
            Member::Mass(_) | Member::Weight(_) => {
                ("a moment of inertia", "leave it out: a slider does not turn")
            }
            Member::Inertia(_) => ("a moment of inertia", "give it a `mass`: a slider does not turn"),
            _ => ("a point, line or circle", "give them to a `link` with a pair of its own"),
        };
        misplaced(cx, what, is, help, member.span);
    }
}

fn misplaced(cx: &mut Context<'_>, what: &str, is: &str, help: &str, span: Span) {
    cx.error(
        Diagnosis::error("mech::geometry::incomplete", format!("{what} cannot have {is}"))
            .label(span, "not allowed here")
            .help(help),
    );
}
