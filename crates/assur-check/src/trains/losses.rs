//! The part of the power that a transmission passes on, in each direction.

use crate::expr::{
    context::Context,
    property::{Read, find},
};
use crate::names::suggestion::wrong_kind;
use crate::statements::written::{end_text, line_of};
use crate::trains::{ends::incomplete, grip::slip};
use crate::values::format_value::digits;
use assur_model::model::TransmissionKind;
use assur_syntax::document::{End, Expr, ExprKind, Joint, Path};
use assur_text::diagnostic::Diagnosis;
use std::f64::consts::{FRAC_PI_2, PI};

/// From the first side to the second, and back. `Some(None)` where nothing is lost.
pub(crate) fn losses(
    cx: &mut Context<'_>,
    joint: &Joint,
    kind: TransmissionKind,
    properties: &[Read],
) -> Option<Option<[f64; 2]>> {
    let given = efficiency(cx, joint, properties)?;
    match kind {
        TransmissionKind::Screw => match (given, thread(cx, joint, properties)?) {
            (Some(there), None) => Some(Some([there, backwards(there)])),
            (None, thread) => Some(thread),
            (Some(_), Some(_)) => {
                let span = find(properties, "efficiency")?.span;
                let message = "the efficiency and the friction of the thread both give the losses";
                incomplete(cx, message, "keep one of them", span)
            }
        },
        TransmissionKind::Worm => Some(given.map(|there| [there, backwards(there)])),
        TransmissionKind::Belt => {
            let kept = 1.0 - slip(properties);
            // the belt pulls both wheels alike, so that the speed that is lost is power that is lost
            let both = given.unwrap_or(1.0) * kept;
            Some((given.is_some() || kept < 1.0).then_some([both, both]))
        }
        _ => Some(given.map(|there| [there, there])),
    }
}

/// A worm or a screw that is driven backwards loses as much again, relative to what it gets.
fn backwards(there: f64) -> f64 {
    2.0 - 1.0 / there
}

/// `Some(None)` where none is written.
fn efficiency(cx: &mut Context<'_>, joint: &Joint, properties: &[Read]) -> Option<Option<f64>> {
    let Some(property) = find(properties, "efficiency") else { return Some(None) };
    let value = property.number();
    if value <= 1.0 {
        return Some(Some(value));
    }
    let help = percent(cx, joint, value).unwrap_or_else(|| {
        "write the part of the power that is passed on: `efficiency 0.98`, or \
         `efficiency 98 %`"
            .into()
    });
    cx.error(
        Diagnosis::error(
            "mech::train::efficiency",
            format!("the efficiency must be between 0 and 1; got {}", digits(value)),
        )
        .primary(property.span, "out of range")
        .help(help)
        .quoted(property.span),
    );
    None
}

/// What the friction of a thread leaves: tan λ/tan(λ + ρ) if the spindle drives, tan(λ − ρ)/tan λ if the nut does, with
/// tan λ = h/(π d) and tan ρ = μ/cos β. `Some(None)` where no friction is given.
fn thread(cx: &mut Context<'_>, joint: &Joint, properties: &[Read]) -> Option<Option<[f64; 2]>> {
    let of = |name| find(properties, name);
    let friction = match (of("friction"), of("friction_angle")) {
        (None, None) => {
            return match of("diameter").or(of("flank")) {
                None => Some(None),
                Some(alone) => {
                    let message = format!("`{}` has no effect without `friction`", alone.name);
                    incomplete(cx, &message, "add `friction 0.1` or `friction_angle 6 deg`", alone.span)
                }
            };
        }
        (Some(_), Some(angle)) => {
            let message = "`friction` and `friction_angle` both give the friction of the thread";
            return incomplete(cx, message, "keep one of them", angle.span);
        }
        (Some(coefficient), None) => coefficient.number() / cosine_of_flank(cx, properties)?,
        (None, Some(angle)) if angle.number() >= FRAC_PI_2 => {
            let message = "an angle of friction must be less than 90 deg";
            return incomplete(cx, message, "write for example `friction_angle 6 deg`", angle.span);
        }
        (None, Some(angle)) => libm::tan(angle.number()) / cosine_of_flank(cx, properties)?,
    };
    let (Some(diameter), Some(lead)) = (of("diameter"), of("lead")) else {
        let message = "the friction of a thread depends on its mean diameter and its lead";
        let missing = if of("diameter").is_none() { "diameter 22 mm" } else { "lead 5 mm" };
        return incomplete(cx, message, &format!("add `{missing}`, with its own value"), joint.name.span);
    };
    let lead = lead.number().abs() / (PI * diameter.number());
    let product = lead * friction;
    if product >= 1.0 {
        let message = format!(
            "the angles of lead and friction add up to 90 deg or more: {} and {}",
            degrees(lead),
            degrees(friction)
        );
        return incomplete(
            cx,
            &message,
            "no torque raises a load: check lead, diameter and friction",
            joint.name.span,
        );
    }
    let there = lead * (1.0 - product) / (lead + friction);
    let back = (lead - friction) / (lead * (1.0 + product));
    Some(Some([there, back]))
}

fn degrees(tangent: f64) -> String {
    format!("{:.4} deg", libm::atan(tangent).to_degrees())
}

fn cosine_of_flank(cx: &mut Context<'_>, properties: &[Read]) -> Option<f64> {
    let Some(flank) = find(properties, "flank") else { return Some(1.0) };
    if flank.number() < FRAC_PI_2 {
        return Some(libm::cos(flank.number()));
    }
    incomplete(
        cx,
        "the angle of a flank must be less than 90 deg",
        "write for example `flank 15 deg`",
        flank.span,
    )
}

// What may be meant by a transmission that cannot be as it is written.

/// The line with `%` after an efficiency that is written as a number up to 100.
pub(crate) fn percent(cx: &Context<'_>, joint: &Joint, value: f64) -> Option<String> {
    let property = joint.properties.iter().find(|p| p.name.node == "efficiency")?;
    let bare = |e: &Expr| matches!(&e.kind, ExprKind::Number(n) if n.unit.is_none());
    let written = property.values.first()?;
    let line = match &written.kind {
        ExprKind::Name(name) if bare(cx.given_as_written(name)?) => format!("given {name} = {value} %"),
        _ if bare(written) => format!("efficiency {value} %"),
        _ => return None,
    };
    (value <= 100.0).then(|| format!("write `{line}`"))
}

/// Reports a shaft or a link in place of the one wheel on it.
pub(crate) fn only_wheels(cx: &mut Context<'_>, joint: &Joint, paths: [&Path; 2]) -> Option<()> {
    let only = |path: &Path| {
        let link = cx.find_link(&path.head.node)?;
        let mut on = cx.builder.mech.wheels.iter().filter(|w| w.link == link);
        let first = on.next()?;
        on.next().is_none().then(|| first.name.clone())
    };
    let is_wheel = |p: &&Path| p.tail.is_some() || cx.wheel(&p.head.node).is_some();
    let Some(odd) = paths.into_iter().find(|p| !is_wheel(p)) else { return Some(()) };
    if !paths.iter().all(|p| is_wheel(p) || only(p).is_some()) {
        return Some(());
    }
    let line = line_of(joint, |end| match end {
        End::At(path) if !is_wheel(&path) => only(path).unwrap_or_default(),
        end => end_text(end),
    });
    let declared = cx.names.things.get(&odd.head.node);
    let error = wrong_kind(
        &odd.head.node,
        &declared.map_or_else(|| "a link".into(), |d| d.what.phrase()),
        "a wheel",
        odd.span(),
        declared.map(|d| d.span),
        Some(format!("name the wheels: `{line}`")),
    );
    cx.error(error);
    None
}
