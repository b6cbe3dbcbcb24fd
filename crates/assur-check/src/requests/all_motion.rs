//! `find positions`, `find velocities`, `find accelerations`: one answer for every named point,
//! every slider on a rope and every link that turns.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use crate::output::hinges::place_key;
use assur_model::model::{Expr, Find, FindKind, LinkId, PairId, PairKind, PointRef, Query};
use assur_syntax::document::FindItem;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::Dimension;
use indexmap::IndexSet;

/// What a function of a point asks, and in which dimension.
type OfPoint = (fn(PointRef) -> Query, OfSlider, Dimension);
/// The same of a slider on a rope.
type OfSlider = fn(PairId) -> Query;
/// What a function of a link asks, and in which dimension.
type OfLink = (fn(LinkId) -> Query, Dimension);

const fn of_point(function: Function) -> Option<OfPoint> {
    match function {
        Function::Position => Some((Query::Position, Query::Displacement, Dimension::LENGTH)),
        Function::Velocity => Some((Query::Velocity, Query::RelativeVelocity, Dimension::VELOCITY)),
        Function::Acceleration => {
            Some((Query::Acceleration, Query::RelativeAcceleration, Dimension::ACCELERATION))
        }
        _ => None,
    }
}

const fn of_link(function: Function) -> Option<OfLink> {
    match function {
        Function::Angle => Some((Query::Angle, Dimension::ANGLE)),
        Function::Omega => Some((Query::Omega, Dimension::ANGULAR_VELOCITY)),
        Function::Alpha => Some((Query::Alpha, Dimension::ANGULAR_ACCELERATION)),
        _ => None,
    }
}

/// The answers that one of these words asks for; `None` for anything else, and where the file has such a name.
pub(crate) fn asked(cx: &Context<'_>, item: &FindItem) -> Option<Vec<Find>> {
    let (function, turning) = super::find::collection(cx, item)?.of?;
    let mut all = Vec::new();
    let (query, of_slider, dimension) = of_point(function)?;
    for (name, point) in points(cx) {
        all.push(find(cx, (function, &name), query(point), dimension, item.span));
    }
    for (i, pair) in cx.builder.mech.pairs.iter().enumerate() {
        if cx.names.things.get(&pair.name).is_some_and(|d| d.what == ThingKind::Slider) {
            all.push(find(cx, (function, &pair.name), of_slider(PairId::at(i)), dimension, item.span));
        }
    }
    let (query, dimension) = of_link(turning)?;
    let guided = guided(cx);
    for (i, link) in cx.builder.mech.links.iter().enumerate().skip(1) {
        if !guided.contains(&LinkId::at(i)) {
            all.push(find(cx, (turning, &link.name), query(LinkId::at(i)), dimension, item.span));
        }
    }
    Some(all)
}

fn find(
    cx: &Context<'_>,
    (function, of): (Function, &str),
    query: Query,
    dimension: Dimension,
    span: Span,
) -> Find {
    let display = cx.values.display(dimension);
    let kind = FindKind::Value { expr: Expr::Query(query), display, poseless: false };
    Find { name: format!("{}({of})", function.name()), span, kind }
}

/// The points of moving links, each once: a pin by its name alone, points of one name on several links with their link.
fn points(cx: &Context<'_>) -> Vec<(String, PointRef)> {
    let mut seen = IndexSet::new();
    let mut all = Vec::new();
    let links = &cx.builder.mech.links;
    for (i, link) in links.iter().enumerate().skip(1) {
        for point in &link.points {
            let here = (LinkId::at(i), point.at);
            if seen.contains(&place_key(here)) {
                continue;
            }
            let joined = cx.builder.joined_with(here);
            let grounded = joined.iter().any(|(link, _)| *link == LinkId::GROUND);
            let alone = cx.bearers_as_declared(&point.name).all(|other| joined.contains(&other));
            seen.extend(joined.into_iter().map(place_key));
            if grounded {
                continue;
            }
            let name = if alone { point.name.clone() } else { format!("{}.{}", link.name, point.name) };
            all.push((name, PointRef::Fixed(here.0, here.1)));
        }
    }
    all
}

/// Links that do not turn: the ground guides them at a constant angle.
fn guided(cx: &Context<'_>) -> IndexSet<LinkId> {
    let ends = cx.builder.mech.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Prismatic(guide) => Some([guide.slider, guide.guide]),
        _ => None,
    });
    ends.filter(|ends| ends.contains(&LinkId::GROUND)).flatten().collect()
}
