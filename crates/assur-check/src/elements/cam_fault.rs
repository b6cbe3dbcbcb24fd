//! What is said of a cam that its follower cannot follow, or cannot stand on.

use crate::expr::context::Context;
use crate::expr::property::Read;
use crate::values::format_value::format_value;
use assur_math::element::cam::{Cam, Fault, Follower, Misfit, Shape};
use assur_model::model::PlateCam;
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::Span;
use assur_text::units::Dimension;

fn mm(x: f64) -> String {
    format_value(x, Dimension::LENGTH)
}

fn deg(x: f64) -> String {
    format_value(x, Dimension::ANGLE)
}

/// Reports a follower that does not stand on the base circle.
pub(crate) fn misfit(cx: &mut Context<'_>, name: &str, base: &Read, follower: Follower, misfit: Misfit) {
    let radius = mm(base.number());
    let (message, help) = match (misfit, follower) {
        (Misfit::Offset, Follower::Translating { offset, .. }) => (
            format!(
                "the follower of cam `{name}` passes the base circle of {radius} at a \
                 distance of {}",
                mm(offset)
            ),
            format!("write a base radius greater than {}, or a smaller offset", mm(offset.abs())),
        ),
        (Misfit::Triangle { least, most }, Follower::Oscillating { arm, pivot_distance, .. }) => (
            format!(
                "an arm of {} on a pivot {} from the centre of cam `{name}` does not \
                 reach a base circle of {radius}",
                mm(arm),
                mm(pivot_distance)
            ),
            format!("write a base radius between {} and {}", mm(least), mm(most)),
        ),
        (Misfit::Face { most }, _) => (
            format!(
                "the face of the follower of cam `{name}` does not reach a base circle of \
                 {radius}"
            ),
            format!("write a base radius less than {}, or a greater pivot distance", mm(most)),
        ),
        (Misfit::TooHigh { start, top, limit }, _) => (
            format!(
                "the follower of cam `{name}` starts at {} from the line to the cam's \
                 centre and rises to {}, past {}",
                deg(start),
                deg(top),
                deg(limit)
            ),
            "write a smaller base radius or lift, or a longer arm".to_owned(),
        ),
        _ => return,
    };
    cx.error(
        Diagnosis::error("mech::cam::base_radius", message)
            .label(base.span, "does not fit the follower")
            .help(help),
    );
}

/// Reports a profile that the follower cannot follow, and jumps of its velocity.
pub(crate) fn follows(cx: &mut Context<'_>, plate: &PlateCam) {
    let (name, span, cam) = (&plate.name, plate.span, &plate.cam);
    for (phi, before, behind) in cam.program.shocks() {
        let way = if cam.follower.oscillates() { Dimension::NUMBER } else { Dimension::LENGTH };
        let rate = |x: f64| {
            let per = if cam.follower.oscillates() { " rad/rad" } else { "/rad" };
            format!("{}{per}", format_value(x, way))
        };
        let (at, before, behind) = (deg(phi), rate(before), rate(behind));
        cx.error(
            Diagnosis::warning(
                "mech::cam::shock",
                format!(
                    "at {at} the follower of cam `{name}` jumps from a velocity of {before} \
                     to {behind}"
                ),
            )
            .label(span, format!("the velocity jumps at {at}"))
            .help(
                "use a law that starts and ends at rest, such as `cycloidal`: the \
                 acceleration is unbounded there",
            ),
        );
    }
    let shape = cam.follower.shape();
    let enough = || match rounded_up(cam) {
        Some(r) => format!("write `base_radius {}`, which is enough", mm(r)),
        None => "spread the motion over more of the turn, or use a smoother law".to_owned(),
    };
    let smaller = |radius: f64| match shape {
        Shape::Roller(_) => format!("; or a roller smaller than {}", mm(radius)),
        Shape::Knife | Shape::Flat => String::new(),
    };
    let bend = |radius: f64| match shape {
        Shape::Roller(r) => {
            format!(
                "the pitch curve has a radius of curvature of {}, the roller a radius of {}",
                mm(radius),
                mm(r)
            )
        }
        Shape::Knife | Shape::Flat => {
            format!("under the flat face the profile would need a radius of {}", mm(radius))
        }
    };
    match cam.fault() {
        None => {}
        Some(Fault::Undercut { phi, radius }) => {
            cx.error(undercut(name, &deg(phi), &bend(radius), enough() + &smaller(radius), span))
        }
        Some(Fault::Loop { phi }) => cx.error(undercut(
            name,
            &deg(phi),
            "the follower runs ahead of the cam, and the curve turns back",
            enough(),
            span,
        )),
        Some(Fault::Pointed { phi, radius }) => cx.error(
            Diagnosis::warning(
                "mech::cam::pointed",
                format!("the profile of cam `{name}` comes to a point at {}: {}", deg(phi), bend(radius)),
            )
            .label(span, "pointed")
            .help("use a greater base radius: a sharp edge wears off".to_owned() + &smaller(radius)),
        ),
    }
}

/// The next greater base radius with a profile that the follower can follow, rounded up to four digits, m.
fn rounded_up(cam: &Cam) -> Option<f64> {
    let enough = cam.enough_base_radius()?;
    let step = libm::pow(10.0, libm::floor(libm::log10(enough)) - 3.0);
    let up = |more: f64| (libm::ceil(enough / step) + more) * step;
    let sound = |r: &f64| cam.on_base(*r).is_ok_and(|cam| cam.fault().is_none());
    [0.0, 1.0, 2.0].map(up).into_iter().find(sound)
}

/// The profile cuts itself.
fn undercut(name: &str, at: &str, bend: &str, help: impl Into<Help>, span: Span) -> Diagnosis {
    Diagnosis::error(
        "mech::cam::undercut",
        format!("the profile of cam `{name}` is undercut at {at}: {bend}"),
    )
    .label(span, "the follower cannot follow this law")
    .help(help)
}
