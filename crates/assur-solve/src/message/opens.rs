//! Sentences about a motion that ends since a pair does not take the forces there.

use super::format::{four, short};
use super::slip::capacity;
use crate::model::{
    FrictionLimit, PairId, PairKind, Profile, ProfileShape, Transmission, UnilateralCondition,
};
use crate::position::Model;
use assur_text::diagnostic::Diagnosis;

/// From an instant on a pair does no more what it has done.
pub(super) fn opens(
    model: &Model<'_>,
    (pair, bond): (PairId, UnilateralCondition),
    (time, at_start): (String, bool),
) -> Diagnosis {
    let pair = model.mechanism.pair(pair);
    let name = &pair.name;
    let (what, text, help) = match (&pair.kind, bond) {
        (PairKind::Contact { first, second, internal, .. }, _) if at_start => (
            format!("contact `{name}` would have to transmit tension from {time} on"),
            "opens here",
            on_other_side(model, (first, second), *internal),
        ),
        (PairKind::Contact { second, .. }, _) => {
            let link = &model.mechanism.link(second.link).name;
            (
                format!("contact `{name}` would have to transmit tension from {time} on"),
                "opens here",
                format!(
                    "add `{{ parts }}` to `{name}`: it opens there, and closes again with an impact; or end the motion with `until normal({name}, {link}) < 0 N`, or press the profiles together by a spring or a load"
                ),
            )
        }
        (PairKind::Transmission(t), UnilateralCondition::Drives) => driven_backwards(t, name, &time),
        (PairKind::Transmission(t @ Transmission { grip: Some(grip), .. }), UnilateralCondition::Grips) => {
            grips_no_more(model, (t, *grip), name, &time)
        }
        _ => (
            format!("rope `{name}` would have to push from {time} on"),
            "slack here",
            format!(
                "end the motion there with `until tension({name}) < 0 N`, or let a load keep the rope tight"
            ),
        ),
    };
    Diagnosis::error("mech::simulate::opens", what).label(pair.span, text).help(help)
}

/// A contact that never presses: the profiles are likely on the wrong sides of each other, or no load presses them together.
fn on_other_side(model: &Model<'_>, (first, second): (&Profile, &Profile), internal: bool) -> String {
    use ProfileShape::{Circle, Line, Point, Rim};
    let link = |profile: &Profile| &model.mechanism.link(profile.link).name;
    let press = "or press the profiles together by a spring or a load";
    let other = match (first.shape, second.shape) {
        (Circle(..), Circle(..)) if internal => {
            "if no circle lies inside the other, leave out `internal`".to_owned()
        }
        (Circle(..), Circle(..)) => "if one circle lies inside the other, add `{ internal }`".to_owned(),
        (Point(at), Line(_, along)) | (Line(_, along), Point(at)) if at.norm() == 0.0 => {
            let line = if matches!(first.shape, Line(..)) { first } else { second };
            let back = if along.angle() > 0.0 { -180.0 } else { 180.0 } + along.angle().to_degrees();
            format!(
                "the free side of `{}.{}` is its left: if it should be the other one, turn the line round, `along {} deg`",
                link(line),
                line.name,
                short(back)
            )
        }
        (Circle(..), Line(..)) | (Line(..), Circle(..)) => {
            "if the circle should be on the other side of the line, choose that assembly with `assemble`"
                .to_owned()
        }
        (Rim(_), _) | (_, Rim(_)) => return "press the profiles together by a spring or a load".to_owned(),
        _ => {
            "if the profiles should touch on the other side, choose that assembly with `assemble`".to_owned()
        }
    };
    format!("{other}; {press}")
}

fn driven_backwards(t: &Transmission, name: &str, time: &str) -> (String, &'static str, String) {
    let kept = t.laws.iter().filter_map(|law| law.efficiency).map(|[there, _]| there);
    let kept = four(kept.fold(1.0, f64::min));
    let first = t.ends.first().map_or("", String::as_str);
    (
        format!(
            "power would run backwards through belt `{name}` from {time} on: its slip is of the speed that `{first}` gives"
        ),
        "the first wheel must drive",
        format!(
            "write `efficiency {kept}` in place of `slip`: then power may run either way; or end the motion before"
        ),
    )
}

fn grips_no_more(
    model: &Model<'_>,
    (t, grip): (&Transmission, FrictionLimit),
    name: &str,
    time: &str,
) -> (String, &'static str, String) {
    let transmitted = match (grip, t.links.first()) {
        (FrictionLimit::Clutch(_), Some(shaft)) => {
            format!("abs(moment({name}, {}))", model.mechanism.link(*shaft).name)
        }
        _ => format!("tangential_force({name})"),
    };
    let (capacity, firmer) = capacity(model, grip);
    let slipping = match grip {
        FrictionLimit::Clutch(_) => "; let it slip: add `slipping` to it and a `start` of its other shaft;",
        FrictionLimit::Belt { .. } => ",",
    };
    (
        format!(
            "{} `{name}` would slip from {time} on: its friction can transmit {capacity} at most",
            t.kind.word()
        ),
        "slips here",
        format!("{firmer}{slipping} or end the motion there with `until {transmitted} > capacity({name})`"),
    )
}
