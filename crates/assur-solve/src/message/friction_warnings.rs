//! What is said of the friction of all positions: of each kind the first place, and how many more there are.

use super::error::label;
use super::format::place;
use super::friction_error::FrictionError;
use crate::answer::{Locked, PoseAnswers};
use crate::model::{FindKind, Friction, Mechanism, PairId, Value};
use crate::position::{Model, PoseOrigin, Wanted};
use crate::units::{Dimension, significant};
use miette::LabeledSpan;

/// A pair that loses less than this part of the greatest loss is not what locks.
const SLIGHT: f64 = 0.05;
/// Digits in messages.
const DIGITS: usize = 4;

/// What was found so far.
#[derive(Debug, Default)]
pub(crate) struct FrictionNotes {
    locked: Option<(FrictionError, usize)>,
    without_effort: Option<(FrictionError, usize)>,
    still: Vec<(PairId, String, usize)>,
}

impl FrictionNotes {
    /// Looks at the friction of a position.
    pub(crate) fn look(&mut self, model: &Model<'_>, view: &PoseAnswers<'_>, pose: &Wanted) {
        if !model.plan.effects.friction || matches!(pose.origin, PoseOrigin::Expected(_)) {
            return;
        }
        let place = place(model, pose);
        for (i, pair) in model.mechanism.pairs.iter().enumerate() {
            let (id, mut elements) =
                (PairId::at(i), model.plan.friction.iter().zip(&view.state.forces.senses));
            let rubs = pair.friction.is_some_and(|f| f.is_some());
            if rubs && elements.all(|(e, sense)| e.pair != id || *sense == 0.0) {
                match self.still.iter_mut().find(|s| s.0 == id) {
                    Some((_, _, more)) => *more += 1,
                    None => self.still.push((id, place.clone(), 0)),
                }
            }
        }
        if view.efficiency() > 0.0 || view.efficiency().is_nan() || view.overcomes_friction_alone() {
            return;
        }
        match &mut self.locked {
            Some((_, more)) => *more += 1,
            None => self.locked = Some((locked(view, &place), 0)),
        }
        if !view.state.forces.locked {
            return;
        }
        match &mut self.without_effort {
            Some((_, more)) => *more += 1,
            None => self.without_effort = without_effort(view, &place).map(|e| (e, 0)),
        }
    }

    /// All that is to be said of friction.
    pub(crate) fn problems(self, mechanism: &Mechanism) -> Vec<FrictionError> {
        let mut all = Vec::new();
        for (id, pose, more) in self.still {
            let pair = mechanism.pair(id);
            let (pair, span) = (pair.name.clone(), pair.span.into());
            all.push(FrictionError::NoSliding { pair, pose, more: and_more(more), span });
        }
        for (mut error, count) in self.locked.into_iter().chain(self.without_effort) {
            if let FrictionError::Locked { more, .. } | FrictionError::NoEffort { more, .. } = &mut error {
                *more = and_more(count);
            }
            all.push(error);
        }
        all
    }
}

fn and_more(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => " and at 1 more pose".to_owned(),
        n => format!(" and at {n} more poses"),
    }
}

fn locked(view: &PoseAnswers<'_>, place: &str) -> FrictionError {
    let model = Model { mechanism: view.mechanism, structure: view.structure, plan: view.plan };
    let mechanism = view.mechanism;
    let ideal = view.without_friction().power_of_efforts();
    let position = Locked { model: &model, state: view.state, ideal };
    let part = position.limit(None).unwrap_or(0.0);
    let mut losses = position.losses(part);
    let least = losses.first().map_or(0.0, |l| SLIGHT * l.1);
    losses.retain(|l| l.1 >= least && l.1 > 0.0);
    let names: Vec<String> = losses.iter().map(|(p, _)| format!("`{}`", mechanism.pair(*p).name)).collect();
    let labels = losses.iter().map(|(p, _)| label("locks", mechanism.pair(*p).span)).collect();
    let verdict = if view.state.forces.locked {
        "no effort moves it".to_owned()
    } else {
        format!("its efficiency is {}", significant(view.efficiency(), DIGITS))
    };
    let mut help =
        losses.iter().filter_map(|(p, _)| limit_of_pair(mechanism, &position, *p)).collect::<Vec<_>>();
    if help.is_empty() {
        help.push("without the friction of one of them it would still be locked".to_owned());
    }
    if losses.len() > 1 {
        help.push(format!(
            "with less than {} of the friction in all pairs it moves",
            significant(part, DIGITS)
        ));
    }
    for (name, critical) in mechanism.criticals.iter().zip(&view.statics.criticals) {
        help.extend(limit_of_given(mechanism, name, *critical));
    }
    FrictionError::Locked {
        pairs: format!("friction in {}", names.join(", ")),
        pose: place.to_owned(),
        more: String::new(),
        verdict,
        help: help.join("\n"),
        labels,
    }
}

/// How much friction one pair may have, all others as they are.
fn limit_of_pair(mechanism: &Mechanism, position: &Locked<'_>, id: PairId) -> Option<String> {
    let pair = mechanism.pair(id);
    let name = &pair.name;
    let (law, part) = (pair.friction?, position.limit(Some(id))?);
    Some(match law {
        Friction::Circle(rho) => {
            let length = mechanism.display_of(Dimension::LENGTH);
            let text = |x: f64| length.text(Value::Scalar(x), DIGITS);
            let (limit, excess) = (text(part * rho), text(rho - part * rho));
            format!(
                "it moves with a friction circle below {limit} in `{name}`: {} is {excess} too much",
                text(rho)
            )
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

/// What the file asks for that does not exist at a locked position.
fn without_effort(view: &PoseAnswers<'_>, place: &str) -> Option<FrictionError> {
    let missing = |kind: &FindKind| match kind {
        FindKind::Reactions => true,
        FindKind::Table(_) => false,
        FindKind::Value { expr, poseless, .. } => !poseless && !view.value(expr).is_defined(),
    };
    let finds: Vec<_> = view.mechanism.finds.iter().filter(|f| missing(&f.kind)).collect();
    let first = match finds.iter().find(|f| !matches!(f.kind, FindKind::Reactions)) {
        Some(find) => find.name.clone(),
        // all reactions are no expression: one of them
        None => {
            finds.first()?;
            let pair = view.mechanism.pairs.first()?;
            let on = pair.kind.links().last().copied()?;
            format!("reaction({}, {})", pair.name, view.mechanism.link(on).name)
        }
    };
    let names: Vec<String> = finds.iter().map(|f| format!("`{}`", f.name)).collect();
    let labels: Vec<LabeledSpan> = finds.iter().map(|f| label("asked here", f.span)).collect();
    let one = names.len() == 1 && !matches!(finds[0].kind, FindKind::Reactions);
    let asked = format!("{} {}", names.join(", "), if one { "has" } else { "have" });
    Some(FrictionError::NoEffort { asked, first, pose: place.to_owned(), more: String::new(), labels })
}
