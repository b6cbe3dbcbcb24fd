//! Points of a link: by coordinates, on a bar, by two distances.

use crate::expr::{
    context::Context,
    positive::{Want, positive},
};
use crate::links::link::{Points, known, place};
use crate::values::format_value::format_value_like;
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Point};
use assur_syntax::document::{Bar, Body, Expr, ExprKind, Member, Name, PointFrom, Side};
use assur_text::diagnostic::{Diagnosis, did_you_mean};
use assur_text::language::{Place, words_of};
use assur_text::source::Span;
use assur_text::units::Dimension;

/// A gap below this part of the longest side is rounding: the triangle is flat.
const FLAT: f64 = 1e-12;

/// Finds all points of a link, enters them into it in the order written, and returns them by name.
pub(crate) fn points<'a>(
    cx: &mut Context<'_>,
    link: LinkId,
    bar: Option<&'a Bar>,
    body: &'a Body,
) -> Points<'a> {
    let mut found = Points::new();
    let mut open = Vec::new();
    if let Some(bar) = bar {
        let what = format!("the length {}-{}", bar.from.node, bar.to.node);
        let length = positive(cx, &bar.length, Dimension::LENGTH, &what);
        found.insert(&bar.from.node, Some(Vec2::zero()));
        found.entry(&bar.to.node).or_insert(length.map(|x| Vec2::new(x, 0.0)));
    }
    for member in body {
        match &member.node {
            Member::Point(p) if !found.contains_key(p.name.node.as_str()) => {
                let what = format!("the position of point `{}`", p.name.node);
                // A number behind a name is reported where it is read: `wieght 21 N`.
                let is_word = || !did_you_mean(&p.name.node, words_of(Place::Member)).is_empty();
                let number = matches!(&p.at.kind, ExprKind::Number(n) if n.value != 0.0 || n.unit.is_some() && is_word());
                let at = if number { None } else { cx.vector_constant(&p.at, &Want::LENGTH, &what) };
                found.insert(&p.name.node, at);
            }
            // A second point of that name is reported with the names.
            Member::PointFrom(p) if !open.iter().any(|o: &&PointFrom| o.name.node == p.name.node) => {
                open.push(p);
            }
            _ => {}
        }
    }
    open.retain(|p| !found.contains_key(p.name.node.as_str()));
    close_triangles(cx, link, &mut found, open);
    enter(cx, link, bar, body, &found);
    found
}

/// Points by two distances, each as soon as the points it is measured from are known.
fn close_triangles<'a>(
    cx: &mut Context<'_>,
    link: LinkId,
    found: &mut Points<'a>,
    mut open: Vec<&'a PointFrom>,
) {
    loop {
        let waits = |name: &Name| open.iter().any(|o| o.name.node == name.node);
        let (waiting, ready) =
            open.iter().copied().partition::<Vec<_>, _>(|p| waits(&p.first) || waits(&p.second));
        if ready.is_empty() {
            break;
        }
        for point in ready {
            let at = triangle(cx, link, found, point);
            found.insert(&point.name.node, at);
        }
        open = waiting;
    }
    if let Some(circle) = circle(&open) {
        let names = circle.iter().map(|p| format!("`{}`", p.name.node)).collect::<Vec<_>>();
        cx.error(
            Diagnosis::error(
                "mech::geometry::circular_points",
                format!("the points {} are defined by each other", names.join(" and ")),
            )
            .each(circle.iter().map(|p| p.name.span), "depends on the next one")
            .help(format!("give one of them by its coordinates: `{} (60 mm, 20 mm)`", circle[0].name.node)),
        );
    }
    found.extend(open.iter().map(|p| (p.name.node.as_str(), None)));
}

/// Points that are defined by each other, in order: each is measured from the next, the last from the first.
fn circle<'a>(open: &[&'a PointFrom]) -> Option<Vec<&'a PointFrom>> {
    let find = |name: &Name| open.iter().copied().find(|o| o.name.node == name.node);
    let mut path = vec![*open.first()?];
    loop {
        let last = path[path.len() - 1];
        let next = find(&last.first).or_else(|| find(&last.second))?;
        if let Some(start) = path.iter().position(|p| p.name.node == next.name.node) {
            return Some(path.split_off(start));
        }
        path.push(next);
    }
}

fn triangle(cx: &mut Context<'_>, link: LinkId, found: &Points<'_>, point: &PointFrom) -> Option<Vec2> {
    let distance = |cx: &mut Context<'_>, expr: &Expr, from: &Name| {
        let what = format!("the distance of `{}` from `{}`", point.name.node, from.node);
        positive(cx, expr, Dimension::LENGTH, &what)
    };
    let r1 = distance(cx, &point.first_distance, &point.first);
    let r2 = distance(cx, &point.second_distance, &point.second);
    let p1 = known(cx, link, found, &point.first);
    let p2 = known(cx, link, found, &point.second);
    let (r1, r2, p1, p2) = (r1?, r2?, p1?, p2?);
    let base = p2 - p1;
    let Some(along) = base.unit() else {
        cx.error(same_place(
            &format!("point `{}`", point.name.node),
            &point.first.node,
            &point.second.node,
            &place(p1),
            point.first.span,
            point.second.span,
        ));
        return None;
    };
    let l = libm::hypot(base.x, base.y);
    let gap = (l - (r1 + r2)).max((r1 - r2).abs() - l);
    if gap > FLAT * l.max(r1).max(r2) {
        does_not_close(cx, point, l, r1, r2);
        return None;
    }
    // Along the base, and across it.
    let x = 0.5 * (l + (r1 - r2) * (r1 + r2) / l);
    let y = height(l, r1, r2);
    let left = match point.side.node {
        Side::Left => y,
        Side::Right => -y,
    };
    Some(p1 + along * x + along.perp() * left)
}

/// The height of a triangle over its side `l`: W. Kahan's area formula with the sides in descending order.
fn height(l: f64, r1: f64, r2: f64) -> f64 {
    let mut sides = [l, r1, r2];
    sides.sort_by(|a, b| b.total_cmp(a));
    let [a, b, c] = sides;
    let sixteen_squared = (a + (b + c)) * (c - (a - b)).max(0.0) * (c + (a - b)) * (a + (b - c));
    0.5 * sixteen_squared.sqrt() / l
}

fn does_not_close(cx: &mut Context<'_>, point: &PointFrom, l: f64, r1: f64, r2: f64) {
    let length = |x: f64| format_value_like(&cx.names, x, Dimension::LENGTH, &point.first_distance);
    let (p, first, second) = (&point.name.node, &point.first.node, &point.second.node);
    let (reason, by, too, correction) = if l > r1 + r2 {
        let reason =
            format!("{first}{second} is {} but {first}{p} + {p}{second} = {}", length(l), length(r1 + r2));
        let correction = format!("the two distances must add up to at least {}", length(l));
        (reason, l - (r1 + r2), "short", correction)
    } else {
        let (long, short, far, near) =
            if r1 > r2 { (r1, r2, first, second) } else { (r2, r1, second, first) };
        let reason =
            format!("{far}{p} is {} but {first}{second} + {p}{near} = {}", length(long), length(l + short));
        let correction = format!("{far}{p} can be at most {}", length(l + short));
        (reason, long - (l + short), "long", correction)
    };
    let error = Diagnosis::error(
        "mech::geometry::point_does_not_close",
        format!("the triangle of point `{p}` does not close: {reason}, {} too {too}", length(by)),
    )
    .primary(point.name.span, "no such point")
    .label(point.first_distance.span, format!("from {first}: {}", length(r1)))
    .label(point.second_distance.span, format!("from {second}: {}", length(r2)))
    .help(format!(
        "change a side of the triangle {}, {} and {}: {correction}",
        length(l),
        length(r1),
        length(r2)
    ));
    cx.error(error);
}

/// Enters the points that are known into the link, in the order written.
fn enter(cx: &mut Context<'_>, link: LinkId, bar: Option<&Bar>, body: &Body, found: &Points<'_>) {
    let of_bar = bar.into_iter().flat_map(|b| [&b.from, &b.to]);
    let of_body = body.iter().filter_map(|m| match &m.node {
        Member::Point(p) => Some(&p.name),
        Member::PointFrom(p) => Some(&p.name),
        _ => None,
    });
    let mut entered = vec![false; found.len()];
    let points = &mut cx.builder.mech.links[link.index()].points;
    for name in of_bar.chain(of_body) {
        if let Some((index, _, Some(at))) = found.get_full(name.node.as_str())
            && !std::mem::replace(&mut entered[index], true)
        {
            points.push(Point { name: name.node.clone(), span: name.span, at: *at });
        }
    }
}

/// A direction or a triangle needs two points, but they coincide.
pub fn same_place(
    what: &str,
    first_name: &str,
    second_name: &str,
    place: &str,
    first: Span,
    second: Span,
) -> Diagnosis {
    Diagnosis::error(
        "mech::geometry::same_place",
        format!("{what} needs two different points, but `{first_name}` and `{second_name}` coincide"),
    )
    .label(first, format!("`{first_name}`"))
    .primary(second, format!("at the same position as `{first_name}`"))
    .help(format!("move one of them, or name another point: both are at {place} in the link's frame"))
}
