//! Links: their points, lines and circles, in the frame of the link.

use crate::expr::{
    context::Context,
    positive::{Want, positive},
    property::given_twice,
};
use crate::links::point::{points, same_place};
use assur_math::math::Vec2;
use assur_model::model::{CamProfile, Circle, Line, LinkId};
use assur_syntax::document::{Bar, Body, CircleMember, LineDirection, LineMember, Member, Name, Statement};
use assur_text::source::Span;
use assur_text::units::Dimension;
use indexmap::IndexMap;

/// The points of a link by name; `None` where a point has an error.
pub(crate) type Points<'a> = IndexMap<&'a str, Option<Vec2>>;

/// Gives all links their points, lines and circles.
pub(crate) fn shapes(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let mut ground: Option<Span> = None;
    for statement in &doc.statements {
        match &statement.node {
            Statement::Ground(g) => {
                if let Some(first) = ground {
                    cx.error(given_twice("the ground", statement.span, first));
                } else {
                    ground = Some(statement.span);
                    shape(cx, LinkId::GROUND, None, &g.body);
                }
            }
            Statement::Link(l) => {
                if let Some(id) = cx.own_link(&l.name) {
                    shape(cx, id, l.bar.as_ref(), &l.body);
                }
            }
            _ => {}
        }
    }
}

fn shape(cx: &mut Context<'_>, link: LinkId, bar: Option<&Bar>, body: &Body) {
    let points = points(cx, link, bar, body);
    for member in body {
        match &member.node {
            Member::Line(line) => {
                if let Some(line) = line_of(cx, link, &points, line) {
                    cx.builder.mech.links[link.index()].lines.push(line);
                }
            }
            Member::Circle(circle) => {
                if let Some(circle) = circle_of(cx, link, &points, circle) {
                    cx.builder.mech.links[link.index()].circles.push(circle);
                }
            }
            Member::Profile(profile) => {
                let centre = known(cx, link, &points, &profile.centre);
                let cam = cx.builder.mech.cams.iter().position(|c| c.name == profile.of.node);
                if let (Some(centre), Some(cam)) = (centre, cam) {
                    let name = profile.name.node.clone();
                    cx.builder.mech.links[link.index()].cam_profiles.push(CamProfile { name, cam, centre });
                }
            }
            _ => {}
        }
    }
}

/// A point that another member of the link refers to. Reports an unknown one, silent on one that has an error.
pub(crate) fn known(cx: &mut Context<'_>, link: LinkId, points: &Points<'_>, name: &Name) -> Option<Vec2> {
    match points.get(name.node.as_str()) {
        Some(point) => {
            cx.names.note_inside(link, name);
            *point
        }
        None => cx.point(link, name),
    }
}

fn line_of(cx: &mut Context<'_>, link: LinkId, points: &Points<'_>, line: &LineMember) -> Option<Line> {
    let through = known(cx, link, points, &line.through);
    let along = match &line.direction {
        LineDirection::Along(angle) => {
            let what = format!("the direction of line `{}`", line.name.node);
            cx.scalar_constant(angle, &Want::ANGLE, &what).map(Vec2::direction)
        }
        LineDirection::To(to) => {
            let towards = known(cx, link, points, to);
            let (from, to_point) = (through?, towards?);
            let along = (to_point - from).unit();
            if along.is_none() {
                cx.error(same_place(
                    &format!("line `{}`", line.name.node),
                    &line.through.node,
                    &to.node,
                    &place(from),
                    line.through.span,
                    to.span,
                ));
            }
            along
        }
    };
    let (name, span) = (line.name.node.clone(), line.name.span);
    Some(Line { name, span, through: through?, along: along? })
}

fn circle_of(
    cx: &mut Context<'_>,
    link: LinkId,
    points: &Points<'_>,
    circle: &CircleMember,
) -> Option<Circle> {
    let centre = known(cx, link, points, &circle.centre);
    let what = format!("the radius of circle `{}`", circle.name.node);
    let radius = positive(cx, &circle.radius, Dimension::LENGTH, &what);
    let (name, span) = (circle.name.node.clone(), circle.name.span);
    Some(Circle { name, span, centre: centre?, radius: radius? })
}

/// A point for a message.
pub(crate) fn place(at: Vec2) -> String {
    let mm = |x| crate::values::format_value::format_value(x, Dimension::LENGTH);
    format!("({}, {})", mm(at.x), mm(at.y))
}
