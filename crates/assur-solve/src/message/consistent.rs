//! Positions at which the laws of friction or of losses have several solutions, or none.

use super::format::{and_at, label, place};
use crate::model::PairId;
use crate::position::{Model, PoseRequest};
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

/// Several states of the forces, one of which is reported.
pub(super) fn several(
    model: &Model<'_>,
    (count, followed): (usize, bool),
    (pose, more): (&PoseRequest, usize),
) -> Diagnosis {
    let what = what(model);
    let reported = if followed {
        format!("the reported state is reached continuously from zero {what}")
    } else {
        let taken = if model.plan.effects.friction {
            "the state that loses the least power is"
        } else {
            "the state with the least forces is"
        };
        format!("none is reached continuously from zero {what}; {taken} reported")
    };
    let (pose, more, labels) = (place(model, pose), and_at(more), labels(model, what));
    Diagnosis::warning(
        "mech::solve::several_balances",
        format!(
            "{count} states of the forces are consistent with the {what}{pose}{more}; \
             {reported}"
        ),
    )
    .labels(labels)
    .help(format!(
        "reduce the {what} until only one state is left, or check this one \
         against the real machine"
    ))
}

/// The search was given up.
pub(super) fn undecided(model: &Model<'_>, pose: String) -> Diagnosis {
    let what = what(model);
    Diagnosis::error(
        "mech::solve::undecided",
        format!("the forces{pose} cannot be found: too many combinations of the {what}"),
    )
    .labels(labels(model, what))
    .help(format!("leave out the {what} of some of the marked pairs, or reduce them"))
}

/// No direction of the power is consistent.
pub(super) fn blocked(model: &Model<'_>, pose: String) -> Diagnosis {
    let labels = labels(model, what(model));
    Diagnosis::error(
        "mech::train::blocked",
        format!(
            "the train is self-locking{pose}: no direction of the power flow is \
             consistent with its losses"
        ),
    )
    .labels(labels)
    .help(raise_efficiencies(model))
}

fn what(model: &Model<'_>) -> &'static str {
    if model.plan.effects.friction { "friction" } else { "losses" }
}

/// The pairs concerned, each once.
fn labels(model: &Model<'_>, what: &str) -> Vec<LabeledSpan> {
    let mut pairs: Vec<PairId> = Vec::new();
    let rubs = model.plan.friction.iter().map(|e| e.pair);
    let loses = model.plan.laws.iter().filter(|l| l.efficiency.is_some()).map(|l| l.pair);
    for pair in rubs.chain(loses) {
        if !pairs.contains(&pair) {
            pairs.push(pair);
        }
    }
    pairs.iter().map(|p| label(format!("{what} here"), model.mechanism.pair(*p).span)).collect()
}

/// Transmissions that transmit no power backwards, and the correction.
fn raise_efficiencies(model: &Model<'_>) -> String {
    let one_way = model.plan.laws.iter().filter(|l| l.efficiency.is_some_and(|[_, back]| back <= 0.0));
    let mut names: Vec<String> =
        one_way.map(|l| format!("`{}`", model.mechanism.pair(l.pair).name)).collect();
    names.dedup();
    if names.is_empty() {
        return "raise the efficiencies: with these losses the circulating power cannot be maintained"
            .to_owned();
    }
    format!(
        "raise the efficiency of {} above 0.5, or put the known load on its other side: driven backwards it \
         transmits no power",
        names.join(", ")
    )
}
