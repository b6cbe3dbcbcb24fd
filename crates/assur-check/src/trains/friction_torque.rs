//! The greatest torque of clutches and brakes.

use crate::expr::property::{Read, find};
use crate::expr::{context::Context, positive::Want};
use crate::trains::ends::incomplete;
use assur_syntax::document::{Joint, Name, Property};
use assur_text::units::Dimension;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Given, or from what presses the faces: n f F r of faces at a radius, with r = 2/3 (R² + R r + r²)/(R + r) under even
/// pressure and (R + r)/2 after wear, over sin α of a cone; of a band F (e^(f θ) − 1) r with the pull F on its slack end.
pub(crate) fn friction_torque(cx: &mut Context<'_>, name: &Name, properties: &[Read]) -> Option<f64> {
    let of = |name| find(properties, name);
    if let Some(capacity) = of("capacity") {
        let other = properties.iter().find(|p| !matches!(p.name, "capacity" | "slipping" | "freewheel"));
        return match other {
            None => Some(capacity.number()),
            Some(other) => {
                let message = format!("`capacity` and `{}` both give the torque", other.name);
                incomplete(cx, &message, "keep `capacity`, or leave it out", other.span)
            }
        };
    }
    let (Some(load), Some(friction)) = (of("load"), of("friction")) else {
        let message = format!("the torque of `{}` is not given", name.node);
        let lacks = [("load", "load 2 kN"), ("friction", "friction 0.3")];
        let lacks = lacks.into_iter().filter(|(name, _)| of(name).is_none()).map(|(_, example)| example);
        let lacks = lacks.collect::<Vec<_>>();
        let help = match lacks.as_slice() {
            [only] => format!("add `{only}`, with its own value, to its braces"),
            _ => "write `{ capacity 40 N*m }` or `{ load 2 kN; friction 0.3; radius 150 mm }`".to_owned(),
        };
        return incomplete(cx, &message, &help, name.span);
    };
    let radius = radius(cx, name, properties)?;
    // the list of a clutch has no `wrap`
    let wrap = properties.iter().find(|p| p.name == "wrap");
    let torque = if let Some(wrap) = wrap {
        if let Some(other) = ["faces", "cone", "outer", "inner", "worn"].into_iter().find_map(of) {
            let message = format!("a band has no `{}`", other.name);
            return incomplete(cx, &message, "leave it out, or leave `wrap` out", other.span);
        }
        if wrap.number() > 100.0 * TAU {
            return incomplete(
                cx,
                "a band of more than 100 turns",
                "write for example `wrap 270 deg`",
                wrap.span,
            );
        }
        load.number() * libm::expm1(friction.number() * wrap.number()) * radius
    } else {
        let sine = match of("cone") {
            None => 1.0,
            Some(cone) if cone.number() <= FRAC_PI_2 => libm::sin(cone.number()),
            Some(cone) => {
                let message = "`cone` takes half the angle of the cone, up to 90 deg";
                return incomplete(cx, message, "write for example `cone 12 deg`", cone.span);
            }
        };
        let faces = of("faces").map_or(1.0, Read::number);
        if faces.fract() != 0.0 {
            let span = of("faces")?.span;
            return incomplete(cx, "the number of faces is not a whole number", "write `faces 2`", span);
        }
        faces * friction.number() * load.number() * radius / sine
    };
    if torque.is_finite() {
        return Some(torque);
    }
    incomplete(cx, "the torque is not a finite number", "check the values", name.span)
}

/// The capacity of a clutch, where it is not a constant: one that slips may have one that varies.
pub(crate) fn varying<'j>(cx: &mut Context<'_>, joint: &'j Joint) -> Option<&'j Property> {
    let capacity = joint.properties.iter().find(|property| property.name.node == "capacity")?;
    let [value] = capacity.values.as_slice() else { return None };
    let constant = cx.quietly(|cx| cx.scalar_constant(value, &Want(Dimension::TORQUE), "").is_some());
    (!constant).then_some(capacity)
}

/// The radius at which the friction acts.
fn radius(cx: &mut Context<'_>, name: &Name, properties: &[Read]) -> Option<f64> {
    let of = |name| find(properties, name);
    match (of("radius"), of("outer")) {
        (Some(_), Some(outer)) => incomplete(
            cx,
            "`radius` and `outer` both give where the friction acts",
            "keep one of them",
            outer.span,
        ),
        (None, None) => {
            let message = format!("the torque of `{}` depends on a radius", name.node);
            incomplete(cx, &message, "add `radius 150 mm`, or `outer 120 mm; inner 80 mm`", name.span)
        }
        (Some(radius), None) => match of("inner").or(of("worn")) {
            None => Some(radius.number()),
            Some(other) => {
                let message = format!("`{}` has no effect together with `radius`", other.name);
                incomplete(cx, &message, "write `outer 120 mm; inner 80 mm`, or leave it out", other.span)
            }
        },
        (None, Some(outer)) => {
            let inner = of("inner").map_or(0.0, Read::number);
            let outer_radius = outer.number();
            if inner >= outer_radius {
                let message = "the inner radius is not less than the outer one";
                return incomplete(cx, message, "write `outer 120 mm; inner 80 mm`", outer.span);
            }
            let sum = outer_radius + inner;
            Some(if of("worn").is_some() {
                sum / 2.0
            } else {
                2.0 / 3.0 * (outer_radius * outer_radius + outer_radius * inner + inner * inner) / sum
            })
        }
    }
}
