//! Friction that locks, or does not act.

use super::format::{label, place};
use crate::model::{FindKind, Friction, Mechanism, PairId, PairKind, Value};
use crate::position::{Model, PoseRequest};
use crate::solve::Locking;
use crate::units::{Dimension, significant};
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

const DIGITS: usize = 4;

/// Nothing slides in a pair with friction.
pub(super) fn no_sliding(
    model: &Model<'_>,
    pair_id: PairId,
    (pose, more): (&PoseRequest, usize),
) -> Diagnosis {
    let pair = model.mechanism.pair(pair_id);
    let (name, span) = (pair.name.clone(), pair.span);
    if matches!(model.mechanism.pair(pair_id).kind, PairKind::Transmission(_)) {
        return Diagnosis::warning(
            "mech::friction::no_sliding",
            format!(
                "nothing moves in `{name}`{}{}: the power has no direction, and its \
                 losses are taken as zero",
                place(model, pose),
                and_more(more)
            ),
        )
        .label(span, "no motion")
        .help(
            "for the beginning of a motion give the drive a small speed in its sense, \
             as `at 1e-6 m/s`",
        );
    }
    Diagnosis::advice(
        "mech::friction::no_sliding",
        format!("no sliding in `{name}`{}{}: friction is taken as zero", place(model, pose), and_more(more)),
    )
    .label(span, "no relative motion")
}

/// Friction locks the mechanism.
pub(super) fn locked(model: &Model<'_>, locking: &Locking) -> Diagnosis {
    let mechanism = model.mechanism;
    let pairs = || locking.pairs.iter().map(|(id, _)| mechanism.pair(*id));
    let names: Vec<String> = pairs().map(|p| format!("`{}`", p.name)).collect();
    let labels = pairs().map(|p| label("locks", p.span));
    let verdict = match locking.efficiency {
        None => "no effort moves it".to_owned(),
        Some(efficiency) => format!("its efficiency is {}", significant(efficiency, DIGITS)),
    };
    let limits = locking.pairs.iter().filter_map(|(id, part)| limit_of_pair(mechanism, *id, (*part)?));
    let mut help = limits.collect::<Vec<_>>();
    if help.is_empty() {
        help.push(
            "reduce the friction in several of them: without the friction of one it would still be locked"
                .to_owned(),
        );
    }
    if locking.pairs.len() > 1 {
        let part = significant(locking.part, DIGITS);
        help.push(format!("it moves with less than {part} of the friction in all pairs"));
    }
    for (name, critical) in mechanism.criticals.iter().zip(&locking.criticals) {
        help.extend(limit_of_given(mechanism, name, *critical));
    }
    Diagnosis::warning(
        "mech::friction::locked",
        format!(
            "friction in {}: the mechanism is locked{}{}; {verdict}",
            names.join(", "),
            place(model, &locking.pose),
            and_more(locking.more)
        ),
    )
    .labels(labels)
    .help(help.join("\n"))
}

/// What the file asks for does not exist where no effort moves the mechanism.
pub(super) fn no_effort(
    model: &Model<'_>,
    finds: &[usize],
    (pose, more): (&PoseRequest, usize),
) -> Diagnosis {
    let mechanism = model.mechanism;
    let finds: Vec<_> = finds.iter().map(|i| &mechanism.finds[*i]).collect();
    let first = match finds.iter().find(|f| !matches!(f.kind, FindKind::Reactions)) {
        Some(find) => find.name.clone(),
        // all reactions are no expression: one of them
        None => mechanism.pairs.first().map_or_else(String::new, |pair| {
            let on = pair.kind.links().last().map_or("", |on| mechanism.link(*on).name.as_str());
            format!("reaction({}, {on})", pair.name)
        }),
    };
    let names: Vec<String> = finds.iter().map(|f| format!("`{}`", f.name)).collect();
    let labels: Vec<LabeledSpan> = finds.iter().map(|f| label("this question", f.span)).collect();
    let one = names.len() == 1 && !matches!(finds[0].kind, FindKind::Reactions);
    let asked = format!("{} {}", names.join(", "), if one { "has" } else { "have" });
    let (pose, more) = (place(model, pose), and_more(more));
    Diagnosis::error(
        "mech::friction::no_effort",
        format!(
            "{asked} no value{pose}{more}: friction locks the mechanism, so no effort \
             moves it"
        ),
    )
    .labels(labels)
    .help(format!(
        "ask for `efficiency()`, `locked()` or `frictionless({first})`, which are \
         defined there"
    ))
}

fn and_more(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => " and at 1 more pose".to_owned(),
        n => format!(" and at {n} more poses"),
    }
}

/// How much friction one pair may have, all others as they are.
fn limit_of_pair(mechanism: &Mechanism, id: PairId, part: f64) -> Option<String> {
    let pair = mechanism.pair(id);
    let name = &pair.name;
    Some(match pair.friction? {
        Friction::Circle(rho) => {
            let length = mechanism.display_of(Dimension::LENGTH);
            let text = |x: f64| length.text(Value::Scalar(x), DIGITS);
            let (limit, excess) = (text(part * rho), text(rho - part * rho));
            format!(
                "it moves with a friction circle below {limit} in `{name}`: {} is {excess} too much",
                text(rho)
            )
        }
        Friction::Rolling { coefficient, arm } => {
            let length = mechanism.display_of(Dimension::LENGTH);
            let text = |x: f64| length.text(Value::Scalar(x), DIGITS);
            let rolling = format!("an arm of rolling resistance below {}", text(part * arm));
            match coefficient {
                0.0 => format!("it moves with {rolling} in `{name}`: {} is too much", text(arm)),
                f => format!(
                    "it moves with a coefficient below {} and {rolling} in `{name}`",
                    significant(part * f, DIGITS)
                ),
            }
        }
        Friction::Coefficient(f) | Friction::BothEnds(f) => {
            let text = |f: f64| {
                let angle = significant(libm::atan(f).to_degrees(), DIGITS);
                format!("{} (friction angle {angle} deg)", significant(f, DIGITS))
            };
            let excess = significant(f - part * f, DIGITS);
            format!(
                "it moves with a coefficient below {} in `{name}`: {} is {excess} too much",
                text(part * f),
                text(f)
            )
        }
    })
}

/// How far a given is from its critical value.
fn limit_of_given(mechanism: &Mechanism, name: &str, critical: f64) -> Option<String> {
    let given = mechanism.values.iter().find(|v| v.name == name)?;
    let Value::Scalar(here) = given.value else { return None };
    let text = |x: f64| given.display.text(Value::Scalar(x), DIGITS);
    critical.is_finite().then(|| {
        let (limit, here, away) = (text(critical), text(here), text((critical - here).abs()));
        format!("locking begins at {name} = {limit}: {here} is {away} away from it")
    })
}
