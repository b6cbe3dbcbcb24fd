//! Positions, lengths and links in words.

use crate::plan::{contact_in, is_turned};
use crate::position::{DriveValue, Model, PoseOrigin, PoseRequest, turns};
use miette::LabeledSpan;

use crate::model::{LinkId, PairKind};
use crate::source::Span;
use crate::structure::{BodyId, BodyOrigin, Dyad, Group, GroupKind, Joint, JointKind};
use crate::units::Dimension;

/// ` at pose 3 (crank = 60 deg)`; empty where nothing is driven.
#[must_use]
pub fn place(model: &Model<'_>, pose: &PoseRequest) -> String {
    let drives = drive_text(model, &pose.drives);
    match pose.origin {
        _ if model.mechanism.simulation.is_some() => {
            format!(" at {} {}", pose.name, model.mechanism.display_of(Dimension::TIME).unit)
        }
        _ if drives.is_empty() => String::new(),
        PoseOrigin::Expected(_) => format!(" at {drives}"),
        _ => format!(" at pose {} ({drives})", pose.name),
    }
}

/// `crank = 60 deg, c1 = 250 mm`
#[must_use]
pub fn drive_text(model: &Model<'_>, values: &[DriveValue]) -> String {
    let drives = model.mechanism.drives.iter().zip(values);
    let texts = drives.filter_map(|(drive, value)| match value {
        DriveValue::Scalar(x) if turns(model, drive) => {
            Some(format!("{} = {} deg", drive.name, short(x.to_degrees())))
        }
        DriveValue::Scalar(x) => Some(format!("{} = {}", drive.name, length(model, *x))),
        DriveValue::Point(p) => {
            Some(format!("{} = ({}, {})", drive.name, length(model, p.x), length(model, p.y)))
        }
        DriveValue::None => None,
    });
    texts.collect::<Vec<_>>().join(", ")
}

/// Angles rounded to a part of a degree.
pub(super) fn rounded(model: &Model<'_>, values: &[DriveValue], per_degree: f64) -> Vec<DriveValue> {
    let drives = model.mechanism.drives.iter().zip(values);
    drives
        .map(|(drive, value)| match value {
            DriveValue::Scalar(x) if turns(model, drive) => {
                DriveValue::Scalar(((x.to_degrees() * per_degree).round() / per_degree).to_radians())
            }
            other => *other,
        })
        .collect()
}

/// Up to six decimals, without trailing zeros.
pub(super) fn short(x: f64) -> String {
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A length in the author's unit, to four significant digits.
pub(super) fn length(model: &Model<'_>, length: f64) -> String {
    with_unit(model, length, Dimension::LENGTH)
}

/// A value in the author's unit, to four significant digits.
pub(super) fn with_unit(model: &Model<'_>, si: f64, dimension: Dimension) -> String {
    let display = model.mechanism.display_of(dimension);
    format!("{} {}", four(display.of_si(si)), display.unit)
}

/// The hinge of a pair: its name, or of a cylinder the point of the link there.
pub(super) fn hinge(model: &Model<'_>, joint: &Joint) -> String {
    let pair = model.mechanism.pair(joint.pair);
    let point = match (&pair.kind, &joint.kind) {
        (PairKind::Cylinder { from, to, .. }, JointKind::Revolute(members)) => {
            let is_of = |link: LinkId| {
                let of = |b: &BodyId| model.structure.replaced.bodies[b.0].origin == BodyOrigin::Link(link);
                members.iter().find(|(b, _)| of(b)).map(|(_, at)| *at)
            };
            [from.link, to.link].into_iter().find_map(|link| {
                let at = is_of(link)?;
                let points = &model.mechanism.link(link).points;
                points.iter().find(|p| p.at == at).map(|p| &p.name)
            })
        }
        _ => None,
    };
    format!("`{}`", point.unwrap_or(&pair.name))
}

/// Four significant digits, without trailing zeros behind the point; very large and very small numbers with a power of
/// ten.
pub(super) fn four(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    if !(1e-6..1e9).contains(&x.abs()) {
        return format!("{x:.3e}");
    }
    #[allow(clippy::cast_possible_truncation)] // between −6 and 9
    let digits = (3 - libm::log10(x.abs()).floor() as i32).max(0);
    let text = format!("{x:.*}", usize::try_from(digits).unwrap_or(0));
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A body as the author knows it; barrel and rod by the name of their cylinder.
pub(super) fn body(model: &Model<'_>, body: BodyId) -> String {
    match model.structure.replaced.bodies[body.0].origin {
        BodyOrigin::Link(id) => {
            let name = &model.mechanism.link(id).name;
            format!("`{}`", name.split_once('.').map_or(name.as_str(), |(cylinder, _)| cylinder))
        }
        BodyOrigin::Imaginary(pair) => {
            let pair = model.mechanism.pair(pair);
            let what = if matches!(pair.kind, PairKind::Slot(_)) { "the pin" } else { "the radii" };
            format!("{what} of `{}`", pair.name)
        }
    }
}

/// The links of a group: `` `rod` and `piston` ``.
pub(super) fn links(model: &Model<'_>, group: &Group) -> String {
    let mut names: Vec<String> = group
        .bodies
        .iter()
        .filter(|b| matches!(model.structure.replaced.bodies[b.0].origin, BodyOrigin::Link(_)))
        .map(|&b| body(model, b))
        .collect();
    names.dedup();
    match names.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        names => names.concat(),
    }
}

pub(super) fn label(text: impl Into<String>, span: Span) -> LabeledSpan {
    LabeledSpan::new_with_span(Some(text.into()), span)
}

/// `, and at 3 other poses`
pub(super) fn and_at(more: usize) -> String {
    match more {
        0 => String::new(),
        1 => ", and at 1 other pose".to_owned(),
        n => format!(", and at {n} other poses"),
    }
}

/// Marks the pairs of a group, with the text at its inner one.
pub(super) fn labels(model: &Model<'_>, group: &Group, text: &str) -> Vec<LabeledSpan> {
    let pair = |j: &crate::structure::GroupJoint| model.structure.replaced.joint(j.joint).pair;
    let main = group.joints.iter().find(|j| j.inner).or(group.joints.first()).map(pair);
    let mut pairs: Vec<_> = group.joints.iter().map(pair).collect();
    pairs.sort();
    pairs.dedup();
    let spans = pairs.into_iter().map(|p| {
        let text = (Some(p) == main).then(|| text.to_owned());
        LabeledSpan::new_with_span(text, model.mechanism.pair(p).span)
    });
    spans.collect()
}

/// How a group stands whose determinant vanishes.
pub(super) fn dead_position(model: &Model<'_>, group: &Group, condition: f64) -> String {
    let links = links(model, group);
    let first = group.bodies.first().map(|&b| body(model, b));
    let turned = contact_in(model.mechanism, model.structure, group)
        .filter(|(block, _, contact)| is_turned(group, *block, contact))
        .map(|(.., contact)| (model.mechanism.pair(contact.pair), model.mechanism.link(contact.disk)));
    let how = match (group.kind, first) {
        _ if turned.is_some() => turned.map_or_else(String::new, |(contact, disk)| {
            format!("the normal at `{}` passes through the centre of `{}`", contact.name, disk.name)
        }),
        (GroupKind::Dyad(Dyad::Rrr), _) => format!("{links} are in line"),
        (GroupKind::Dyad(Dyad::Rrp), Some(leg)) => format!("{leg} is perpendicular to its guide"),
        (GroupKind::Dyad(Dyad::Prp | Dyad::Rpp) | GroupKind::Translation, _) => {
            format!("the guides of {links} are parallel")
        }
        (GroupKind::Triad, _) => {
            format!("the lines of force of the legs in {links} meet in one point or are parallel")
        }
        _ => format!("{links} could move a little while all others are at rest"),
    };
    if condition > 0.0 { format!("{how} (condition figure σ = {condition:.1e})") } else { how }
}
