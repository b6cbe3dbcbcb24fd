//! A drive by a length of what turns, by an angle of what slides, or by a speed in place of a position.

use crate::expr::context::Context;
use crate::expr::fit::unit_mismatch;
use crate::motion::drive::{Moves, has_wheels, zero};
use crate::statements::written::written;
use crate::values::typed::phrase;
use assur_model::model::{DriveTarget, LinkId, PairKind};
use assur_syntax::document::{Direction, Drive, DrivePosition, Expr, Sensed, Steps, Turn, Way};
use assur_text::units::Dimension;

/// Whether the positions are of the other kind; reported once, for position, speed and acceleration.
pub(crate) fn is_other(
    cx: &mut Context<'_>,
    drive: &Drive,
    (target, moves): (Option<DriveTarget>, Moves),
    name: &str,
) -> bool {
    let Some(first) = first(drive) else { return false };
    let Some(found) = cx.quietly(|cx| cx.read(first)).map(|t| t.ty.dimension()) else { return false };
    let want = moves.dimension(0);
    let help = match moves {
        Moves::Turning if found == Dimension::LENGTH => by_pair(cx, drive, target)
            .or_else(|| cx.same_number(want, first).map(|text| format!("write `{text}`"))),
        Moves::Sliding if found == Dimension::ANGLE => {
            let (unit, rate) =
                (cx.values.usual_unit(Dimension::LENGTH), cx.values.usual_unit(Dimension::VELOCITY));
            Some(format!("`{name}` slides: write its position in {unit}, and its speed in {rate}"))
        }
        Moves::Turning | Moves::Sliding if found == moves.dimension(1) && drive.rate.is_none() => {
            written(first).map(|speed| by_rate(cx, moves, name, &speed))
        }
        _ => return false,
    };
    let what = format!("the position of `{name}`");
    let (want, found, span) = (phrase(want), phrase(found), first.span);
    cx.error(unit_mismatch(&what, &want, &found, span, help));
    true
}

/// A speed after `at`; a train needs no position.
fn by_rate(cx: &Context<'_>, moves: Moves, name: &str, speed: &str) -> String {
    let position = if has_wheels(cx) { String::new() } else { format!(" = {}", zero(moves, 0)) };
    format!("write a speed after `at`: `drive {name}{position} at {speed}`")
}

fn first(drive: &Drive) -> Option<&Expr> {
    match drive.position.as_ref()? {
        DrivePosition::Values(values) => values.first().map(|v| &v.value),
        DrivePosition::Range(course) => Some(&course.from),
    }
}

/// The same drive of a pair in which the link slides.
fn by_pair(cx: &Context<'_>, drive: &Drive, target: Option<DriveTarget>) -> Option<String> {
    let Some(DriveTarget::Link(link)) = target else { return None };
    let slides = |kind: &PairKind, link: LinkId| match kind {
        PairKind::Prismatic(g) | PairKind::Slot(g) => g.slider == link || g.guide == link,
        PairKind::Cylinder { from, to, .. } => from.link == link || to.link == link,
        _ => false,
    };
    let pairs = cx.builder.mech.pairs.iter().filter(|p| slides(&p.kind, link));
    let lines = pairs.filter_map(|p| Some(format!("`{}`", retargeted(drive, &p.name)?))).collect::<Vec<_>>();
    (!lines.is_empty()).then(|| format!("drive the pair: {}", lines.join(" or ")))
}

/// The drive's statement with another target.
fn retargeted(drive: &Drive, name: &str) -> Option<String> {
    with_rates(drive, format!("drive {name} = {}", written_position(drive)?))
}

/// The drive's statement with one position alone; `…` for what cannot be written again.
pub(crate) fn at_one_position(drive: &Drive, at: &Expr, name: &str) -> String {
    let position = format!("drive {name} = {}", written(at).unwrap_or_else(|| "…".into()));
    let sense = match drive.direction.as_ref().map(|direction| direction.node) {
        Some(Direction::Turning(Turn::Ccw)) => " turning ccw",
        Some(Direction::Turning(Turn::Cw)) => " turning cw",
        Some(Direction::Moving(Way::Forward)) => " moving forward",
        Some(Direction::Moving(Way::Back)) => " moving back",
        None => "",
    };
    with_rates(drive, position.clone()).map_or_else(|| format!("{position} …"), |line| line + sense)
}

/// With speed and acceleration behind it.
fn with_rates(drive: &Drive, mut line: String) -> Option<String> {
    for (word, rate) in [("at", &drive.rate), ("accelerating", &drive.acceleration)] {
        if let Some(rate) = rate {
            let sense = match rate.sense.as_ref().map(|sense| sense.node) {
                Some(Turn::Ccw) => " ccw",
                Some(Turn::Cw) => " cw",
                None => "",
            };
            line.push_str(&format!(" {word} {}{sense}", written(&rate.value)?));
        }
    }
    Some(line)
}

/// The positions as written: `0 deg .. 360 deg in 12 steps`.
pub(crate) fn written_position(drive: &Drive) -> Option<String> {
    match drive.position.as_ref()? {
        DrivePosition::Values(values) => {
            Some(values.iter().map(value).collect::<Option<Vec<_>>>()?.join(", "))
        }
        DrivePosition::Range(course) => {
            let [from, to, steps] = [&course.from, &course.to, course.steps.expr()].map(written);
            Some(match &course.steps {
                Steps::In(_) => format!("{} .. {} in {} steps", from?, to?, steps?),
                Steps::Of(_) => format!("{} .. {} step {}", from?, to?, steps?),
            })
        }
    }
}

/// A value without a sense.
fn value(v: &Sensed) -> Option<String> {
    if v.sense.is_some() { None } else { written(&v.value) }
}
