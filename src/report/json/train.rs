//! Shafts, sliders and transmissions in JSON.

use serde::Serialize;

use super::super::answers::Answers;
use super::super::train::pulls;
use super::entries::{Entries, Number};
use assur_model::model::{Mechanism, PairId, PairKind, TransmissionKind};
use assur_position::plan::Level;
use assur_solve::solve::Solved;

#[derive(Serialize)]
pub(super) struct ShaftView {
    #[serde(skip_serializing_if = "Option::is_none")]
    omega: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha: Option<Number>,
}

#[derive(Serialize)]
pub(super) struct SliderView {
    #[serde(skip_serializing_if = "Option::is_none")]
    speed: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    velocity: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    acceleration: Option<Number>,
}

/// One part of a transmission: all but ropes have one.
#[derive(Serialize)]
pub(super) struct PartView {
    #[serde(skip_serializing_if = "Option::is_none")]
    tension: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<Number>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    torques: Entries<Number>,
}

/// Which links are shafts and sliders, by their ids.
pub(super) fn are_elements(mechanism: &Mechanism) -> Vec<bool> {
    let mut elements = vec![false; mechanism.links.len()];
    for pair in mechanism.pairs.iter().filter(|p| p.bearing.is_some()) {
        let slider = match &pair.kind {
            PairKind::Prismatic(g) => Some(g.slider),
            _ => None,
        };
        pair.kind.links().last().copied().into_iter().chain(slider).for_each(|l| elements[l.index()] = true);
    }
    elements
}

type Elements = (Vec<(String, ShaftView)>, Vec<(String, SliderView)>);

/// Rates of shafts and sliders, as far as the plan follows them and they depend on no size that is left open.
pub(super) fn elements(answers: &Answers<'_>, solved: &Solved) -> Elements {
    let (mechanism, level) = (answers.model.mechanism, answers.model.plan.effects.rates());
    let view = answers.solution.view(&answers.model, solved);
    let (mut shafts, mut sliders) = (Vec::new(), Vec::new());
    let at = |least: Level, x: f64| (level >= least).then_some(x).and_then(Number::of);
    for (i, pair) in mechanism.pairs.iter().enumerate().filter(|(_, p)| p.bearing.is_some()) {
        let id = PairId::at(i);
        let name = pair.name.clone();
        match &pair.kind {
            PairKind::Prismatic(g) if !answers.solution.open.links.contains(&g.slider.index()) => {
                let v = view.relative_velocity(id);
                let query = assur_model::model::Query::RelativeAcceleration(id);
                let a = match view.query(&query) {
                    assur_model::model::Value::Scalar(a) => a,
                    _ => f64::NAN,
                };
                sliders.push((
                    name,
                    SliderView {
                        speed: at(Level::Velocities, v.abs()),
                        velocity: at(Level::Velocities, v),
                        acceleration: at(Level::Accelerations, a),
                    },
                ));
            }
            PairKind::Revolute(pins) => {
                let Some(link) = pins.last().map(|p| p.link) else { continue };
                if answers.solution.open.links.contains(&link.index()) {
                    continue;
                }
                let body = view.body(link);
                let (omega, alpha) =
                    (at(Level::Velocities, body.omega), at(Level::Accelerations, body.alpha));
                shafts.push((name, ShaftView { omega, alpha }));
            }
            _ => {}
        }
    }
    (shafts, sliders)
}

/// Forces and torques of transmissions.
pub(super) fn transmissions(answers: &Answers<'_>, solved: &Solved) -> Vec<(String, Vec<PartView>)> {
    let mechanism = answers.model.mechanism;
    let mut all: Vec<(String, Vec<PartView>)> = Vec::new();
    for pull in pulls(answers, solved) {
        let pair = mechanism.pair(pull.pair);
        let rope = matches!(&pair.kind, PairKind::Transmission(t) if t.kind == TransmissionKind::Rope);
        let force = Number::of(pull.force);
        let torques = pull.torques.iter();
        let view = PartView {
            tension: force.filter(|_| rope),
            force: force.filter(|_| !rope),
            torques: Entries(
                torques
                    .filter_map(|(l, x)| Some((mechanism.link(*l).name.clone(), Number::of(*x)?)))
                    .collect(),
            ),
        };
        match all.last_mut() {
            Some((last, parts)) if *last == pair.name => parts.push(view),
            _ => all.push((pair.name.clone(), vec![view])),
        }
    }
    all
}
