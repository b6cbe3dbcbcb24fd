//! Prismatic pairs and pins in slots: a point on a line, or a line on a line.

use crate::expr::context::Context;
use crate::expr::property::{Read, Value, find};
use crate::names::suggestion::{not_declared, suggestion};
use crate::pairs::pair::{Joined, nothing_to_join};
use crate::pairs::property::phrase;
use crate::statements::written::{end_text, line_of};
use assur_math::math::Vec2;
use assur_model::model::{Guide, Line, LinkId, PairKind};
use assur_syntax::document::{End, Joint, JointKind, Member, Statement};
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::source::Spanned;
use assur_text::units::Dimension;

/// What an end of the pair is.
enum Part {
    Point(Vec2),
    Line(Line),
}

/// A prismatic pair or a slot. `properties` is absent where one of them has an error.
pub(crate) fn guide(
    cx: &mut Context<'_>,
    joint: &Joint,
    ends: &[Joined],
    properties: Option<&[Read]>,
) -> Option<PairKind> {
    let [first, second] = ends else { return None };
    let parts = (part(cx, joint, first), part(cx, joint, second));
    let properties = properties.unwrap_or_default();
    let angle = find(properties, "angle");
    let parts = (parts.0?, parts.1?);
    let mut guide = match parts {
        (Part::Point(point), Part::Line(line)) => {
            point_on_line(first, point, second.link, line, angle, false)
        }
        (Part::Line(line), Part::Point(point)) => point_on_line(second, point, first.link, line, angle, true),
        (Part::Line(own), Part::Line(line)) if joint.kind.node == JointKind::Prismatic => {
            no_angle(cx, angle)?;
            line_on_line(cx, first.link, own, second.link, line)
        }
        (Part::Line(_), Part::Line(_)) => return wrong_ends(cx, joint, first, second, "two lines"),
        (Part::Point(_), Part::Point(_)) => return wrong_ends(cx, joint, first, second, "two points"),
    };
    guide.contacts = contacts(cx, properties)?;
    if joint.kind.node == JointKind::Slot {
        return Some(PairKind::Slot(guide));
    }
    Some(PairKind::Prismatic(guide))
}

fn part(cx: &mut Context<'_>, joint: &Joint, end: &Joined) -> Option<Part> {
    match cx.kind_inside(end.link, &end.part.node) {
        Some("point") => cx.point(end.link, &end.part).map(Part::Point),
        Some("line") => cx.line(end.link, &end.part).map(Part::Line),
        Some(_) => {
            let got = format!("the circle `{}`", end.part.node);
            cx.error(
                Diagnosis::error(
                    "mech::geometry::wrong_ends",
                    format!("{} joins a point and a line, not {got}", phrase(joint.kind.node)),
                )
                .label(end.span, &got)
                .help("for a roller on a line write `contact`"),
            );
            None
        }
        None => {
            if end.implied {
                nothing_to_join(cx, joint, end, "point");
            } else {
                unknown(cx, joint, end);
            }
            None
        }
    }
}

/// Reports a name that is neither a point nor a line of the link.
fn unknown(cx: &mut Context<'_>, joint: &Joint, end: &Joined) {
    let inside = &cx.names.inside[end.link.index()];
    let name = &end.part.node;
    if inside.bad.contains(name) || cx.names.bad.contains(name) {
        return;
    }
    // said of another pair
    if cx.problems.reported.contains(&("point", format!("{}.{name}", cx.builder.mech.link(end.link).name))) {
        return;
    }
    let all = inside.points.keys().chain(inside.lines.keys()).map(String::as_str).collect::<Vec<_>>();
    let owner = &cx.builder.mech.link(end.link).name;
    let near = !did_you_mean(name, all.iter().copied()).is_empty();
    let line =
        if near { None } else { line_elsewhere(cx, joint, end).or_else(|| missing_line(cx, joint, end)) };
    let listed = || suggestion(name, end.part.span, &all, &format!("points and lines of {owner}"));
    let help = line.map(Help::from).or_else(listed);
    let (name, span, owner) = (name.clone(), end.part.span, Some(owner.clone()));
    cx.error(not_declared("point or line", &name, owner, span, help));
}

/// The pair with a line that another link has.
fn line_elsewhere(cx: &Context<'_>, joint: &Joint, end: &Joined) -> Option<String> {
    let name = &end.part.node;
    let links = cx.names.inside.iter().zip(&cx.builder.mech.links);
    let mut owners = links.filter(|(inside, _)| inside.lines.contains_key(name)).map(|(_, link)| &link.name);
    let owner = owners.next()?;
    let among = |e: &End| matches!(e, End::At(path) if path.head.node == *owner);
    if owners.next().is_some() || joint.ends.iter().any(among) {
        return None;
    }
    let line = line_of(joint, |e| match e.span() == end.span {
        true => format!("{owner}.{name}"),
        false => end_text(e),
    });
    Some(format!("`{name}` is a line of `{owner}`: write `{line}`"))
}

/// The member that gives the link the line, where it has none and the other end is a point.
fn missing_line(cx: &Context<'_>, joint: &Joint, end: &Joined) -> Option<String> {
    let other = joint.ends.iter().find_map(|e| match e {
        End::At(path) if e.span() != end.span => Some(path),
        _ => None,
    })?;
    let part = other.tail.as_ref().unwrap_or(&joint.name);
    let inside = &cx.names.inside[end.link.index()];
    let point = cx.kind_inside(cx.find_link(&other.head.node)?, &part.node) == Some("point");
    if !point || !inside.lines.is_empty() {
        return None;
    }
    let (name, owner) = (&end.part.node, &cx.builder.mech.link(end.link).name);
    let bar = cx.doc.statements.iter().find_map(|s| match &s.node {
        Statement::Link(l) if l.name.node == *owner => l.bar.as_ref(),
        _ => None,
    });
    let first = inside.points.keys().next()?;
    let line = bar.map_or_else(
        || format!("line {name} through {first} along 0 deg"),
        |bar| format!("line {name} through {} to {}", bar.from.node, bar.to.node),
    );
    Some(format!("give `{owner}` the line in its braces: `{line}`"))
}

/// The point's x axis makes `angle` with the line, so that the line lies at minus that angle in the slider's frame.
fn point_on_line(
    slider: &Joined,
    point: Vec2,
    guide: LinkId,
    line: Line,
    angle: Option<&Read>,
    guide_first: bool,
) -> Guide {
    let angle = angle.map_or(0.0, Read::number);
    Guide {
        slider: slider.link,
        point_name: slider.part.node.clone(),
        point,
        direction: Vec2::direction(-angle),
        own_line: None,
        guide,
        line_name: line.name,
        through: line.through,
        along: line.along,
        contacts: None,
        guide_first,
    }
}

/// The lines coincide, their senses alike; the first slides on the second.
fn line_on_line(cx: &Context<'_>, slider: LinkId, own: Line, guide: LinkId, line: Line) -> Guide {
    Guide {
        slider,
        point_name: origin(cx, &own),
        point: own.through,
        direction: own.along,
        own_line: Some(own.name),
        guide,
        line_name: line.name,
        through: line.through,
        along: line.along,
        contacts: None,
        guide_first: false,
    }
}

/// The name of the point that a line runs through.
fn origin(cx: &Context<'_>, line: &Line) -> String {
    let bodies = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Ground(ground) => Some(&ground.body),
        Statement::Link(link) => Some(&link.body),
        _ => None,
    });
    let lines = bodies.flatten().filter_map(|m| match &m.node {
        Member::Line(l) => Some(l),
        _ => None,
    });
    lines.into_iter().find(|l| l.name.span == line.span).map(|l| l.through.node.clone()).unwrap_or_default()
}

fn wrong_ends<T>(
    cx: &mut Context<'_>,
    joint: &Joint,
    first: &Joined,
    second: &Joined,
    got: &str,
) -> Option<T> {
    let slot = joint.kind.node == JointKind::Slot;
    let name = &joint.name.node;
    let meant = cx.lines_meant(joint, joint.kind.node);
    let meant = meant.iter().map(|l| format!("`{l}`")).collect::<Vec<_>>();
    let help = match (slot, got) {
        (true, "two lines") => format!("write `prismatic {name}` for two lines that slide on each other"),
        (_, "two points") if first.implied && second.implied => {
            let line = line_of(
                &Joint { kind: Spanned::new(JointKind::Revolute, joint.kind.span), ..joint.clone() },
                end_text,
            );
            format!("both links have the point `{name}`: write `{line}`")
        }
        (_, "two points") if !meant.is_empty() => format!("name the line: {}", meant.join(" or ")),
        (_, "two points") => {
            "give one of the two links a line to slide along: `line guide through A along 0 deg`".into()
        }
        _ => "name a point of one link and a line of the other".into(),
    };
    cx.error(
        Diagnosis::error(
            "mech::geometry::wrong_ends",
            format!(
                "{} joins {}, not {got}",
                phrase(joint.kind.node),
                if slot { "a point and a line" } else { "a point and a line, or two lines" }
            ),
        )
        .label(first.span.to(second.span), got)
        .help(help),
    );
    None
}

fn no_angle(cx: &mut Context<'_>, angle: Option<&Read>) -> Option<()> {
    let Some(angle) = angle else { return Some(()) };
    cx.error(
        Diagnosis::error("mech::geometry::incomplete", "two lines on each other have no `angle`")
            .label(angle.span, "the pair joins two lines")
            .help("leave `angle` out, or name a point instead of the first line"),
    );
    None
}

fn contacts(cx: &mut Context<'_>, properties: &[Read]) -> Option<Option<[f64; 2]>> {
    let Some(property) = find(properties, "contacts") else { return Some(None) };
    let Value::Two([a, b]) = property.value else { return Some(None) };
    if a == b {
        let at = crate::values::format_value::format_value(a, Dimension::LENGTH);
        cx.error(
            Diagnosis::error(
                "mech::geometry::contacts_coincide",
                format!("the two contacts are both at {at}"),
            )
            .label(property.span, format!("{at} and {at}"))
            .help("give the two ends of the sliding surface along the line, as in `contacts -20 mm, 25 mm`"),
        );
        return None;
    }
    Some(Some([a, b]))
}
