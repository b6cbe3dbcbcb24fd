//! By how much a group does not close, in words.

use super::format::{body, hinge, length, short, with_unit};
use crate::group::Gap;
use crate::group::triad::Miss;
use crate::model::PairKind;
use crate::plan::{DrivenJoint, DrivenLeg, MotionStep};
use crate::position::Model;
use crate::solve::GroupGap;
use crate::structure::{BodyId, EffortSource, Group, GroupJoint};
use crate::units::Dimension;

/// The point that drives move.
fn tip(model: &Model<'_>, group: &Group) -> String {
    let drives = group.efforts.iter().map(|&effort| model.structure.drives[effort].source);
    let names = drives.filter_map(|source| match source {
        EffortSource::Drive(id) => Some(format!("`{}`", model.mechanism.drives[id.index()].written_name())),
        EffortSource::Balance(_) => None,
    });
    names.take(1).collect()
}

/// The gap with its numbers and points, and what would close it.
pub(super) fn gap_text(model: &Model<'_>, group: usize, gap: &GroupGap) -> (String, String) {
    let step = &model.plan.motion[group];
    let group = &model.structure.motion[group];
    // an arm has its driven tip in place of the third hinge
    let name = |i: usize| match group.joints.get(i) {
        Some(joint) => hinge(model, model.structure.replaced.joint(joint.joint)),
        None => tip(model, group),
    };
    let mm = &|x: f64| length(model, x);
    let link = |i: usize| body(model, group.bodies[i]);
    match gap {
        GroupGap::Reach { distance, lengths, gap } => {
            let (links, names) = ([link(0), link(1)], [name(0), name(1), name(2)]);
            let (text, help) = reach(mm, *distance, *lengths, *gap, &links, &names);
            let MotionStep::DrivenRrr { legs, .. } = step else { return (text, help) };
            let driven = [0, 1].map(|i| is_cylinder(model, &legs[i], group.joints[2 * i]));
            let other = match driven {
                [true, false] => 1,
                [false, true] => 0,
                _ => return (text, help),
            };
            // the third side of a triangle
            let [least, most] = [(distance - lengths[other]).abs(), distance + lengths[other]].map(mm);
            (text, format!("drive {} between {least} and {most}", link(1 - other)))
        }
        GroupGap::Path { length, short: Some(far) } => (
            format!(
                "{} is {} from the path of {}, but {} is {} long: {} short",
                name(0),
                mm(length + far),
                name(1),
                link(0),
                mm(*length),
                mm(*far)
            ),
            format!(
                "make {} longer by {}, or bring {} nearer to the guide of {}{}",
                link(0),
                mm(*far),
                name(0),
                name(2),
                slip(length + far, *length)
            ),
        ),
        GroupGap::Guide { distance, offset, near: Some(near) } => (
            format!(
                "{} and {} are {} apart, but the guide passes one of them at a distance of {}: {} too close",
                name(0),
                name(2),
                mm(*distance),
                mm(*offset),
                mm(*near)
            ),
            format!("make the offset less by {}, or bring {} and {} apart", mm(*near), name(0), name(2)),
        ),
        GroupGap::Path { .. } | GroupGap::Guide { .. } => unknown(&name(1)),
        GroupGap::Driven => (
            format!("the links about {} do not meet at these values of the drives", name(1)),
            "check the values of the drives inside the links".to_owned(),
        ),
        GroupGap::Legs(miss) => {
            let leg = |i: usize| body(model, group.joints[i].body);
            let plate = match step {
                MotionStep::Triad { triad, .. } => body(model, BodyId(triad.body)),
                _ => String::new(),
            };
            let links = [leg(0), leg(1), leg(2), plate];
            triad_text(mm, *miss, &links, &[0, 1, 2, 3, 4, 5].map(name))
        }
        GroupGap::Lift { pair, lift, range, oscillates, dwell } => {
            let dimension = if *oscillates { Dimension::ANGLE } else { Dimension::LENGTH };
            let size = |x: f64| with_unit(model, x, dimension);
            lift_text(&model.mechanism.pair(*pair).name, &size, *lift, *range, *dwell)
        }
        GroupGap::Parallel => (
            "the guides are parallel".to_owned(),
            format!("turn the guide of {} or {}, so that they cross", name(0), name(group.joints.len() - 1)),
        ),
    }
}

/// Lengths in the author's unit.
type Lengths<'a> = &'a dyn Fn(f64) -> String;

/// The follower of a designed cam stands where the cam has no angle, or no certain one.
fn lift_text(
    contact: &str,
    size: &dyn Fn(f64) -> String,
    lift: f64,
    [least, most]: [f64; 2],
    dwell: Option<[f64; 2]>,
) -> (String, String) {
    if let Some([from, to]) = dwell.map(|angles| angles.map(|x| short(x.to_degrees()))) {
        return (
            format!(
                "at `{contact}` the follower is at lift {}, where the cam dwells from {from} deg to {to} deg: any of these \
                 cam angles fits",
                size(lift)
            ),
            "drive the cam instead of the follower, or choose a position of the follower on a rise or a fall"
                .to_owned(),
        );
    }
    let (far, how) = if lift > most { (lift - most, "too high") } else { (least - lift, "too low") };
    let way = if lift > most { "lower" } else { "raise" };
    (
        format!(
            "at `{contact}` the follower is at lift {}, but the cam lifts it from {} to {}: {} {how}",
            size(lift),
            size(least),
            size(most),
            size(far)
        ),
        format!("{way} the follower by at least {}, or change the lift of the cam", size(far)),
    )
}

/// Two links of these lengths from hinge to hinge that do not meet.
fn reach(
    mm: Lengths<'_>,
    distance: f64,
    [l_1, l_2]: [f64; 2],
    gap: Option<Gap>,
    links: &[String; 2],
    names: &[String; 3],
) -> (String, String) {
    let (link, name) = (|i: usize| &links[i], |i: usize| &names[i]);
    match gap {
        Some(Gap::TooFar(far)) => (
            format!(
                "{} and {} are {} apart, but {} and {} reach {} + {} = {}: {} short",
                name(0),
                name(2),
                mm(distance),
                link(0),
                link(1),
                mm(l_1),
                mm(l_2),
                mm(l_1 + l_2),
                mm(far)
            ),
            format!(
                "make {} or {} longer by {}, or bring {} and {} nearer{}",
                link(0),
                link(1),
                mm(far),
                name(0),
                name(2),
                slip(distance, l_1 + l_2)
            ),
        ),
        Some(Gap::TooNear(near)) => (
            format!(
                "{} and {} are {} apart, but {} and {} fold to at least |{} − {}| = {}: {} too close",
                name(0),
                name(2),
                mm(distance),
                link(0),
                link(1),
                mm(l_1),
                mm(l_2),
                mm((l_1 - l_2).abs()),
                mm(near)
            ),
            format!(
                "make {} shorter or {} longer by {}, or bring {} and {} apart{}",
                link(if l_1 > l_2 { 0 } else { 1 }),
                link(if l_1 > l_2 { 1 } else { 0 }),
                mm(near),
                name(0),
                name(2),
                slip((l_1 - l_2).abs(), distance)
            ),
        ),
        None => unknown(name(1)),
    }
}

/// A link on three legs: the links, the plate last; the outer pairs, then the inner ones.
fn triad_text(
    mm: Lengths<'_>,
    miss: Option<Miss>,
    links: &[String; 4],
    names: &[String; 6],
) -> (String, String) {
    match miss {
        Some(Miss::Pair { legs: [i, j], lengths, longest, gap }) => {
            let sides = [
                format!("{} to {}", names[i], names[j]),
                format!("{} from {} to {}", links[i], names[i], names[3 + i]),
                format!("{} from {} to {}", links[3], names[3 + i], names[3 + j]),
                format!("{} from {} to {}", links[j], names[j], names[3 + j]),
            ];
            let others = (0..4).filter(|k| *k != longest);
            let shorter: Vec<String> = others.map(|k| format!("{} ({})", sides[k], mm(lengths[k]))).collect();
            let long = format!("{} ({})", sides[longest], mm(lengths[longest]));
            let help = if longest == 0 {
                format!(
                    "make {}, {} or {} longer by {}, or bring {} and {} nearer",
                    links[i],
                    links[3],
                    links[j],
                    mm(gap),
                    names[i],
                    names[j]
                )
            } else {
                let long = [&links[i], &links[3], &links[j]][longest - 1];
                format!("make {long} shorter by {}", mm(gap))
            };
            let sum = lengths.iter().sum::<f64>() - lengths[longest];
            let help = help + slip(lengths[longest], sum);
            (format!("{long} is {} longer than {} together", mm(gap), shorter.join(", ")), help)
        }
        Some(Miss::Third { leg, reached, gap }) => {
            let others: Vec<&String> = (0..3).filter(|i| *i != leg).map(|i| &links[i]).collect();
            let on = format!("on {} and {} {}", others[0], others[1], links[3]);
            let way = if gap > 0.0 { "no nearer to" } else { "no farther from" };
            let (pin, hinge) = (&names[3 + leg], &names[leg]);
            let own = (reached - gap).abs();
            if own <= 1e-9 * reached {
                let text = format!("{on} moves {pin} no nearer to the guide of {hinge} than {}", mm(reached));
                return (text, format!("move the guide of {hinge} by {}", mm(reached)));
            }
            let (how, change) = if gap > 0.0 { ("short", "longer") } else { ("too long", "shorter") };
            (
                format!(
                    "{on} moves {pin} {way} {hinge} than {}, but {} is {} long: {} {how}",
                    mm(reached),
                    links[leg],
                    mm(own),
                    mm(gap.abs())
                ),
                format!("make {} {change} by {}, or move {hinge}", links[leg], mm(gap.abs())),
            )
        }
        None => unknown(&names[3]),
    }
}

fn unknown(pair: &str) -> (String, String) {
    (format!("the group about {pair} cannot be solved"), "check the lengths".to_owned())
}

/// Whether the leg is a driven cylinder, hinged with this joint.
fn is_cylinder(model: &Model<'_>, leg: &DrivenLeg, outer: GroupJoint) -> bool {
    let pair = model.structure.replaced.joint(outer.joint).pair;
    let cylinder = matches!(model.mechanism.pair(pair).kind, PairKind::Cylinder { .. });
    cylinder && matches!(leg.joint, Some(DrivenJoint::Shift { .. }))
}

/// Lengths of different orders are most often a slip in a unit.
fn slip(long: f64, short: f64) -> &'static str {
    if long > 30.0 * short { "; check the units" } else { "" }
}
