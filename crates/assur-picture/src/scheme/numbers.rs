//! Loads and efforts with their numbers: arrows of forces are as long as these are large.

use super::{Scheme, Sketch};
use crate::paper::Scaled;
use crate::scene::Scene;
use assur_drawing::{Caption, Level, Scale, Text};
use assur_model::model::{BalanceId, BalanceKind, LoadId, LoadKind, PairId, PairKind, Query, Value};
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// The longest arrow, mm.
const LONGEST: f64 = 32.0;

/// The scale of the arrows of forces, N/mm; none where no force has a number.
///
/// # Errors
/// A scale is wanted that does not fit.
pub fn scale(scene: &Scene<'_>, wanted: &Scheme) -> Result<Option<Scale>, Diagnosis> {
    let mechanism = scene.mechanism();
    let gravity = mechanism.gravity.map_or(0.0, |g| g.acceleration.norm());
    let weights = mechanism.links.iter().filter_map(|link| Some(link.mass?.mass * gravity));
    let loads = (0..mechanism.loads.len()).map(|i| match scene.view().query(&Query::Load(LoadId::at(i))) {
        Value::Vector(force) => force.norm(),
        Value::Scalar(effort) if is_force(scene, i) => effort.abs(),
        _ => 0.0,
    });
    let efforts = (0..mechanism.balances.len()).filter_map(|i| {
        let balance = &mechanism.balances[i];
        let are_forces = balance.kind.places().iter().all(|place| is_pushing(scene, place));
        are_forces.then(|| effort(scene, i)).flatten().map(f64::abs)
    });
    let all = weights.chain(loads).chain(efforts).filter(|force| force.is_finite());
    let greatest = all.fold(0.0, f64::max);
    wanted.scales.chosen(Scaled::Force, Scale::fitting(greatest, LONGEST))
}

/// The value of an unknown effort, where it is found.
fn effort(scene: &Scene<'_>, index: usize) -> Option<f64> {
    if !scene.model.plan.effects.forces || scene.solved.state.forces.locked {
        return None;
    }
    match scene.view().query(&Query::Balance(BalanceId::at(index))) {
        Value::Scalar(x) if x.is_finite() => Some(x),
        _ => None,
    }
}

fn is_force(scene: &Scene<'_>, load: usize) -> bool {
    matches!(scene.mechanism().loads[load].kind, LoadKind::InPair { pair, .. } if shifts(scene, pair))
}

fn is_pushing(scene: &Scene<'_>, place: &BalanceKind) -> bool {
    match place {
        BalanceKind::Force { .. } => true,
        BalanceKind::InPair(pair) => shifts(scene, *pair),
        BalanceKind::Torque(_) | BalanceKind::Several(_) => false,
    }
}

/// Whether an effort inside a pair is a force.
fn shifts(scene: &Scene<'_>, pair: PairId) -> bool {
    !matches!(scene.mechanism().pair(pair).kind, PairKind::Revolute(_))
}

/// The line below a picture with forces.
pub fn caption(scale: &Scale) -> Caption {
    let text = Text::italic("μ").lowered("F").and(&format!(" = {} N/mm", scale.text()), false, Level::Base);
    Caption { text, bar: None }
}

impl Sketch<'_, '_> {
    /// The length of the arrow of a force, N; the usual one where there are no numbers.
    pub(super) fn arrow(&self, force: f64, usual: f64) -> f64 {
        match (self.forces, self.numbers) {
            (Some(scale), true) => force.abs() / scale.factor(),
            _ => usual,
        }
    }

    /// The length of the arrow of an unknown effort.
    pub(super) fn arrow_of(&self, balance: usize, usual: f64) -> f64 {
        effort(self.scene, balance).map_or(usual, |force| self.arrow(force, usual))
    }

    /// The name of a force with its number.
    pub(super) fn with_force(&self, name: Text, force: f64) -> Text {
        self.with_number(name, force, Dimension::FORCE)
    }

    /// The name of a couple with its number.
    pub(super) fn with_couple(&self, name: Text, couple: f64) -> Text {
        self.with_number(name, couple, Dimension::TORQUE)
    }

    /// The name of an unknown effort with its number, where it is found.
    pub(super) fn with_effort(&self, name: Text, balance: usize, place: &BalanceKind) -> Text {
        match effort(self.scene, balance) {
            Some(x) if is_pushing(self.scene, place) => self.with_force(name, x),
            Some(x) => self.with_couple(name, x),
            None => name,
        }
    }

    fn with_number(&self, name: Text, si: f64, dimension: Dimension) -> Text {
        if !self.numbers {
            return name;
        }
        let display = self.scene.mechanism().display_of(dimension);
        let number = format!(" = {}", self.scene.value_text(&display, si));
        let full = name.full.as_ref().map(|full| full.clone() + &number);
        Text { full, ..name.and(&number, false, Level::Base) }
    }
}
