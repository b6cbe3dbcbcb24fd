//! What the friction of a belt can transmit.

use crate::expr::context::Context;
use crate::expr::property::{Read, find};
use crate::trains::ends::incomplete;
use assur_model::model::FrictionLimit;
use assur_syntax::document::{End, Joint};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The part of the speed that a belt loses; zero where none is given.
pub(crate) fn slip(properties: &[Read]) -> f64 {
    find(properties, "slip").map_or(0.0, Read::number)
}

/// The ratio of its pulls at which a belt slips, e^(μ θ / sin γ) after Euler and Eytelwein. `Some(None)` where no friction is
/// given.
pub(crate) fn belt_grip(
    cx: &mut Context<'_>,
    joint: &Joint,
    properties: &[Read],
) -> Option<Option<FrictionLimit>> {
    let of = |name| find(properties, name);
    if let Some(slip) = of("slip")
        && slip.number() >= 1.0
    {
        let help = "write the part of the speed that is lost: `slip 0.02`, or `slip 2 %`";
        return incomplete(cx, "the slip of a belt must be less than 1", help, slip.span);
    }
    let Some(friction) = of("friction") else {
        let alone = ["wrap", "centre_distance", "groove", "pretension"].into_iter().find_map(of);
        return match alone {
            None => Some(None),
            Some(alone) => {
                let message = format!("`{}` has no effect without `friction`", alone.name);
                incomplete(cx, &message, "add `friction 0.3`, with its own value", alone.span)
            }
        };
    };
    let sine = match of("groove") {
        None => 1.0,
        Some(groove) if groove.number() <= FRAC_PI_2 => libm::sin(groove.number()),
        Some(groove) => {
            let message = "`groove` takes half the angle between the faces, up to 90 deg";
            return incomplete(cx, message, "write for example `groove 19 deg`", groove.span);
        }
    };
    let wrap = wrap(cx, joint, properties, friction)?;
    let ratio = libm::exp(friction.number() * wrap / sine);
    if !ratio.is_finite() {
        let message = "the ratio of the pulls at which the belt slips is not a finite number";
        return incomplete(cx, message, "check friction, wrap and groove", friction.span);
    }
    Some(Some(FrictionLimit::Belt {
        wrap,
        ratio,
        groove: of("groove").map(Read::number),
        pretension: of("pretension").map(Read::number),
    }))
}

/// The angle of contact on the smaller pulley: π − 2 asin((R − r)/a) of an open belt, π + 2 asin((R + r)/a) of a crossed one.
fn wrap(cx: &mut Context<'_>, joint: &Joint, properties: &[Read], friction: &Read) -> Option<f64> {
    let of = |name| find(properties, name);
    match (of("wrap"), of("centre_distance")) {
        (Some(_), Some(distance)) => {
            let message = "`wrap` and `centre_distance` both give the angle of contact";
            incomplete(cx, message, "keep one of them", distance.span)
        }
        (Some(wrap), None) if wrap.number() < TAU => Some(wrap.number()),
        (Some(wrap), None) => {
            let message = "a belt touches a pulley along less than a turn";
            incomplete(cx, message, "write for example `wrap 165 deg`", wrap.span)
        }
        (None, None) => {
            let message = "the grip of a belt depends on its angle of contact";
            incomplete(cx, message, "add `wrap 165 deg` or `centre_distance 600 mm`", friction.span)
        }
        (None, Some(distance)) => {
            let radii = joint.ends.iter().filter_map(|end| match end {
                End::At(path) => cx.wheel(&path.head.node).map(|w| (w.radius, w.name)),
                End::Over(_) | End::Under(_) => None,
            });
            let radii: Vec<(f64, String)> = radii.collect();
            let [(r_1, first), (r_2, second)] = radii.as_slice() else { return Some(PI) };
            let open = cx.builder.mech.open_sizes.iter().find(|s| s.wheel == *first || s.wheel == *second);
            if let Some(open) = open {
                let message = format!(
                    "the angle of contact depends on the radius of `{}`, which is not given",
                    open.wheel
                );
                return incomplete(cx, &message, "give the radius, or write `wrap 165 deg`", distance.span);
            }
            let crossed = of("crossed").is_some();
            let across = if crossed { r_1 + r_2 } else { (r_1 - r_2).abs() };
            let sine = across / distance.number();
            if r_1 + r_2 >= distance.number() {
                let message =
                    "the pulleys overlap: the centre distance is not greater than the sum of the radii";
                return incomplete(cx, message, "write a greater `centre_distance`", distance.span);
            }
            let turned = 2.0 * libm::asin(sine);
            Some(if crossed { PI + turned } else { PI - turned })
        }
    }
}
