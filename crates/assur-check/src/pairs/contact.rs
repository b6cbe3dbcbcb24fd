//! Contacts of circles, lines and points.

use crate::expr::context::Context;
use crate::expr::property::{Read, find};
use crate::pairs::pair::{Joined, nothing_to_join};
use assur_model::model::{PairKind, Profile, ProfileShape};
use assur_syntax::document::Joint;
use assur_text::diagnostic::Diagnosis;

/// A contact of two profiles. `properties` is absent where one of them has an error.
pub(crate) fn contact(
    cx: &mut Context<'_>,
    joint: &Joint,
    ends: &[Joined],
    properties: Option<&[Read]>,
) -> Option<PairKind> {
    let [first, second] = ends else { return None };
    let profiles = (profile(cx, joint, first), profile(cx, joint, second));
    let (a, b) = (profiles.0?, profiles.1?);
    let internal = find(properties.unwrap_or_default(), "internal");
    use ProfileShape::{Circle, Line, Point, Rim};
    let problem = match (a.shape, b.shape) {
        (Line(..), Line(..)) => Some((
            "two lines",
            format!("write `prismatic {}` for two lines that slide on each other", joint.name.node),
        )),
        (Rim(_), Rim(_)) => Some(("two cams", "name the cam and its follower".to_owned())),
        (Point(_), Point(_)) => Some((
            "two points",
            format!("write `revolute {}` for two points that stay together", joint.name.node),
        )),
        (Circle(_, p), Circle(_, q)) if internal.is_some() && p == q => Some((
            "two equal circles inside each other",
            format!("write `revolute {}` between the centres, which coincide", joint.name.node),
        )),
        _ => None,
    };
    if let Some((profiles, help)) = problem {
        cx.error(
            Diagnosis::error("mech::geometry::no_contact", format!("{profiles} cannot form a contact"))
                .label(
                    first.span.to(second.span),
                    "a contact is a circle on a circle, a line or a point, or a point on a line",
                )
                .help(help),
        );
        return None;
    }
    let circles = matches!((a.shape, b.shape), (Circle(..), Circle(..)));
    if let Some(internal) = internal
        && !circles
    {
        cx.error(
            Diagnosis::error("mech::geometry::incomplete", "`internal` needs two circles")
                .label(internal.span, "these profiles are not two circles")
                .help("leave `internal` out, or name two circles"),
        );
        return None;
    }
    let parts = parts(cx, joint, (&a, &b), properties.unwrap_or_default())?;
    Some(PairKind::Contact { first: a, second: b, internal: internal.is_some(), parts })
}

/// Whether the contact parts: in a motion, from profiles whose distance is known.
fn parts(
    cx: &mut Context<'_>,
    joint: &Joint,
    (first, second): (&Profile, &Profile),
    properties: &[Read],
) -> Option<bool> {
    let name = &joint.name.node;
    let Some(parts) = find(properties, "parts") else {
        let Some(restitution) = find(properties, "restitution") else { return Some(false) };
        cx.error(
            Diagnosis::error("mech::geometry::incomplete", "`restitution` has no effect without `parts`")
                .label(restitution.span, "a contact that does not part is never hit")
                .help(format!("add `parts`, as in `contact {name}: … {{ parts; restitution 0.6 }}`")),
        );
        return None;
    };
    let rim = [first, second].iter().any(|profile| matches!(profile.shape, ProfileShape::Rim(_)));
    if let Some(friction) = find(properties, "friction").filter(|_| rim) {
        cx.error(
            Diagnosis::error(
                "mech::geometry::no_contact",
                "a contact with a designed cam that parts has no friction yet",
            )
            .primary(friction.span, "here")
            .label(parts.span, "it parts")
            .help("leave out `friction`, or leave out `parts`: the motion then ends where the contact opens"),
        );
        return None;
    }
    Some(true)
}

fn profile(cx: &mut Context<'_>, joint: &Joint, end: &Joined) -> Option<Profile> {
    cx.names.note_inside(end.link, &end.part);
    let rim =
        cx.builder.mech.link(end.link).cam_profiles.iter().find(|r| r.name == end.part.node).map(|r| r.cam);
    let shape = match cx.kind_inside(end.link, &end.part.node) {
        _ if rim.is_some() => rim.map(ProfileShape::Rim),
        Some("line") => cx.line(end.link, &end.part).map(|l| ProfileShape::Line(l.through, l.along)),
        Some("circle") => cx.circle(end.link, &end.part).map(|c| ProfileShape::Circle(c.centre, c.radius)),
        None if end.implied => {
            nothing_to_join(cx, joint, end, "profile");
            None
        }
        None if !cx.names.inside[end.link.index()].circles.is_empty() => {
            cx.circle(end.link, &end.part);
            None
        }
        _ => cx.point(end.link, &end.part).map(ProfileShape::Point),
    };
    Some(Profile { link: end.link, name: end.part.node.clone(), shape: shape? })
}
