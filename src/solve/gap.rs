//! By how much a group does not close, in words.

use super::solution::Scene;
use super::state::State;
use crate::group::{Gap, rpr, rrp, rrr};
use crate::plan::{Anchor, MotionStep};
use crate::structure::GroupJoint;

/// The gap with its numbers and points, and what would close it.
pub(super) fn gap_text(scene: &Scene<'_>, state: &State, index: usize) -> (String, String) {
    let group = &scene.structure.motion[index];
    let name = |i: usize| pair_name(scene, group.joints[i]);
    let at = |a: &Anchor| state.bodies[a.body].position(a.at);
    match &scene.plan.motion[index] {
        MotionStep::Rrr { legs, .. } => {
            let (p_A, p_B) = (at(&legs[0].base), at(&legs[1].base));
            let (l_1, l_2) = (legs[0].length, legs[1].length);
            let distance = (p_B - p_A).norm();
            match rrr::gap(p_A, p_B, l_1, l_2) {
                Some(Gap::TooFar(far)) => (
                    format!(
                        "{} and {} are {} apart, but the links reach {} + {} = {}: {} short",
                        name(0),
                        name(2),
                        mm(distance),
                        mm(l_1),
                        mm(l_2),
                        mm(l_1 + l_2),
                        mm(far)
                    ),
                    format!("make a link longer by {}, or bring {} and {} nearer", mm(far), name(0), name(2)),
                ),
                Some(Gap::TooNear(near)) => (
                    format!(
                        "{} and {} are {} apart, but the links fold to |{} − {}| = {} at the least: {} too near",
                        name(0),
                        name(2),
                        mm(distance),
                        mm(l_1),
                        mm(l_2),
                        mm((l_1 - l_2).abs()),
                        mm(near)
                    ),
                    format!(
                        "make the links more alike by {}, or bring {} and {} apart",
                        mm(near),
                        name(0),
                        name(2)
                    ),
                ),
                None => unknown(&name(1)),
            }
        }
        MotionStep::Rrp { branch, leg, slide, from_point, .. } => {
            let base = &state.bodies[slide.base];
            let (q, d) = (base.position(slide.origin), slide.along.turned(base.u));
            let h = from_point.y + state.branches[*branch].sides[0] * slide.radius;
            let p_A = at(&leg.base);
            match rrp::gap(p_A, leg.length, q, d, h) {
                Some(Gap::TooFar(far) | Gap::TooNear(far)) => (
                    format!(
                        "{} is {} from the path of {}, but the link is {} long: {} short",
                        name(0),
                        mm(leg.length + far),
                        name(1),
                        mm(leg.length),
                        mm(far)
                    ),
                    format!("make the link longer by {}, or bring {} nearer to the guide", mm(far), name(0)),
                ),
                None => unknown(&name(1)),
            }
        }
        MotionStep::Rpr { branch, bases, slide, from_origin, from_point, .. } => {
            let (p_A, p_B) = (at(&bases[0]), at(&bases[1]));
            let h = from_point.y + state.branches[*branch].sides[0] * slide.radius - from_origin.y;
            match rpr::gap(p_A, p_B, h) {
                Some(Gap::TooFar(gap) | Gap::TooNear(gap)) => (
                    format!(
                        "{} and {} are {} apart, but the guide passes {} beside: {} too near",
                        name(0),
                        name(2),
                        mm((p_B - p_A).norm()),
                        mm(h.abs()),
                        mm(gap)
                    ),
                    format!(
                        "make the offset less by {}, or bring {} and {} apart",
                        mm(gap),
                        name(0),
                        name(2)
                    ),
                ),
                None => unknown(&name(1)),
            }
        }
        MotionStep::DrivenRrr { .. } | MotionStep::DrivenRrp { .. } => (
            format!("the links about {} do not meet at these values of the drives", name(1)),
            "check the values of the drives inside the links".to_owned(),
        ),
        _ => ("the guides are parallel".to_owned(), "turn one of the guides".to_owned()),
    }
}

fn unknown(pair: &str) -> (String, String) {
    (format!("the group about {pair} cannot be solved"), "check the lengths".to_owned())
}

fn pair_name(scene: &Scene<'_>, joint: GroupJoint) -> String {
    scene.mechanism.pair(scene.structure.replaced.joint(joint.joint).pair).name.clone()
}

/// A length in millimetres, to four significant digits.
pub(super) fn mm(length: f64) -> String {
    let value = length * 1e3;
    if value == 0.0 || !value.is_finite() {
        return format!("{value} mm");
    }
    #[allow(clippy::cast_possible_truncation)] // a power of ten of an f64 fits
    let digits = (3 - value.abs().log10().floor() as i32).clamp(0, 12);
    let text = format!("{value:.*}", usize::try_from(digits).unwrap_or(0));
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{text} mm")
}
