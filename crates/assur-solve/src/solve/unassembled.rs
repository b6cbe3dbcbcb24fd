//! Why the mechanism is not assembled: what of its groups is kept for the message.

use super::clause::{apart, clauses, coordinate, distinct, points};
use super::failure::Cause;
use super::gap::{GroupGap, arm_gap, group_gap};
use crate::model::HintKind;
use crate::plan::MotionStep;
use crate::position::{Model, State, is_never_regular};

/// More clauses than this are no help.
pub const MOST_CLAUSES: usize = 8;

/// A group does not close.
pub(super) fn does_not_close(model: &Model<'_>, state: State, group: usize) -> Cause {
    let mut state = state;
    let step = &model.plan.motion[group];
    if let MotionStep::General { problem, .. } = step {
        if let Some(gap @ GroupGap::Reach { gap: Some(_), .. }) = arm_gap(model, &state, group) {
            return Cause::DoesNotClose { group, gap };
        }
        let point = points(model, &model.structure.motion[group]).first().map(|p| p.0);
        let never_regular = is_never_regular(&state, *problem, &model.plan.general[*problem]);
        return Cause::NotFound { group, point, never_regular };
    }
    state.step::<0>(model.plan, step);
    Cause::DoesNotClose { group, gap: group_gap(model, &state, group) }
}

pub(super) fn ambiguous(model: &Model<'_>, states: &[&State]) -> Cause {
    let mut groups = Vec::new();
    // a group whose assembly the groups before it decide leaves nothing to choose
    let mut alike = vec![states.to_vec()];
    for (index, group) in model.structure.motion.iter().enumerate() {
        let next: Vec<_> = alike.iter().flat_map(|states| apart(model, states, group)).collect();
        if next.len() == alike.len() {
            continue;
        }
        alike = next;
        let mut clauses = clauses(model, &distinct(model, states, group), group);
        clauses.truncate(MOST_CLAUSES);
        groups.push((index, clauses));
    }
    Cause::Ambiguous { count: states.len(), groups }
}

/// No candidate fits a hint.
pub(super) fn not_met(model: &Model<'_>, hint: usize, states: &[&State], index: usize) -> Cause {
    let group = &model.structure.motion[index];
    let assemblies = distinct(model, states, group);
    let bounded = match model.mechanism.hints[hint].kind {
        HintKind::Coordinate { pair, .. } => Some(pair),
        _ => None,
    };
    let mut found = clauses(model, &assemblies, group);
    found.truncate(MOST_CLAUSES);
    let each = found.into_iter().zip(&assemblies);
    let assemblies = each.map(|(clause, state)| (clause, bounded.map(|p| coordinate(model, state, p))));
    Cause::HintNotMet { hint, group: index, assemblies: assemblies.collect() }
}
