//! The lift of a cam at a position: the formula of the stage in which the cam stands, and its cam angle at a lift.

use super::cam::CamLaw;
use crate::cam_law::{derived, greatest_acceleration, in_radians, inverse, is_of_half};
use crate::course::Derivation;
use crate::spline::{Spline, Term};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::element::cam::{Law, Phase};
use assur_position::plan::CamStep;
use std::f64::consts::{PI, TAU};

/// Angles nearer than this are one, rad.
const NEAR: f64 = 1e-12;

impl Derivation<'_> {
    /// The lift and its derivatives by the cam's angle, as formulas.
    pub(super) fn lift_by_stage(&mut self, step: &CamStep, law: &CamLaw) -> Option<[Expr; 3]> {
        let (around, turns) = around(law);
        let (index, phase) = stage_at(step, around)?;
        let stage = self.stage_index(step, index);
        let (scale, unit) = if law.turns { (180.0 / PI, Unit::Angle) } else { (1.0, Unit::Length) };
        if phase.law == Law::Dwell {
            let held = self.given(Name::new("s", &format!("0,{stage}")), scale * phase.from, unit);
            return Some([held, Expr::ZERO, Expr::ZERO]);
        }
        let turned = self.found.get(&law.turned).cloned().unwrap_or(Expr::ZERO);
        let begin = self.given(Name::new("θ", &format!("0,{stage}")), phase.start.to_degrees(), Unit::Angle);
        let angle = self.given(Name::new("Φ", &stage), phase.angle.to_degrees(), Unit::Angle);
        let x = ((around - phase.start) / phase.angle).clamp(0.0, 1.0);
        let right = (turned + Expr::Degrees(360 * turns) - begin) / angle;
        let part = self.equate(Name::new("u", &law.lift.sub), x, Unit::One, right);
        let h = self.given(Name::new("h", &stage), scale * phase.change, unit);
        let from = self.given(Name::new("s", &format!("0,{stage}")), scale * phase.from, unit);
        let constants = self.constants_of(step, (index, phase), law.turns);
        let angle = self.in_radians(Name::new("Φ", &stage), phase.angle);
        let is_spline = matches!(phase.law, Law::Spline(_));
        let own = if law.turns && !is_spline {
            self.in_radians(Name::new("h", &stage), phase.change)
        } else {
            h.clone()
        };
        let [way, first, second] = derived(phase.law, [&h, &own], (x, part), &constants, &angle)?;
        Some([from + way, first, second])
    }

    /// An angle of the file in rad; it is left out where nothing uses it.
    fn in_radians(&mut self, name: Name, angle: f64) -> Expr {
        self.optional.insert(self.blocks.len());
        self.equate(name, angle, Unit::Radian, in_radians(angle))
    }

    /// The cam's angle at the lift, as a formula, where the law of the stage has an inverse; the part of the stage goes before it.
    pub(super) fn angle_by_stage(&mut self, step: &CamStep, law: &CamLaw) -> Option<Expr> {
        let (around, turns) = around(law);
        let (index, phase) = stage_at(step, around)?;
        let stage = self.stage_index(step, index);
        let (scale, unit) = if law.turns { (180.0 / PI, Unit::Angle) } else { (1.0, Unit::Length) };
        let x = ((around - phase.start) / phase.angle).clamp(0.0, 1.0);
        let lift = self.found.get(&law.lift).cloned().unwrap_or(Expr::ZERO);
        let h = self.given(Name::new("h", &stage), scale * phase.change, unit);
        let from = self.given(Name::new("s", &format!("0,{stage}")), scale * phase.from, unit);
        let right = inverse(phase.law, &h, lift - from, x)?;
        let part = self.equate(Name::new("u", &law.lift.sub), x, Unit::One, right);
        let begin = self.given(Name::new("θ", &format!("0,{stage}")), phase.start.to_degrees(), Unit::Angle);
        let angle = self.given(Name::new("Φ", &stage), phase.angle.to_degrees(), Unit::Angle);
        Some(begin + angle * part - Expr::Degrees(360 * turns))
    }

    /// Whether a cam is where its follower does not move.
    pub(super) fn dwells(&self, step: &CamStep, law: &CamLaw) -> bool {
        stage_at(step, around(law).0).is_some_and(|(_, phase)| phase.law == Law::Dwell)
    }

    /// The number of a stage, with the cam's name where there are several: the letters of the section on cams.
    fn stage_index(&self, step: &CamStep, index: usize) -> String {
        let cams = &self.scene.mechanism().cams;
        let number = index + 1;
        if cams.len() > 1 { format!("{number},{}", cams[step.contact.cam].name) } else { number.to_string() }
    }

    /// What a law has besides the way: the greatest acceleration of modified ones, the terms of a piece of a spline.
    fn constants_of(&mut self, step: &CamStep, (index, phase): (usize, &Phase), turns: bool) -> Vec<Expr> {
        match phase.law {
            Law::Spline(_) => self.terms_of_spline(step, index, turns),
            law if is_of_half(law) => {
                let right = greatest_acceleration(law);
                let value = right.value();
                vec![self.equate(Name::new("A", &self.stage_index(step, index)), value, Unit::One, right)]
            }
            _ => Vec::new(),
        }
    }

    /// The terms of a piece of a spline, from the slopes at its ends, which follow from their neighbours.
    fn terms_of_spline(&mut self, step: &CamStep, index: usize, turns: bool) -> Vec<Expr> {
        let [around, slopes, terms] = {
            let name = |letter: &str, stage: usize| Name::new(letter, &self.stage_index(step, stage - 1));
            let given = |name: Name, value: f64, unit: Unit| self.given(name, value, unit);
            let phases = step.cam.program.phases();
            let spline = Spline { phases, turns, name: &name, given: &given };
            [spline.slopes_around(index), spline.slopes_of(index), spline.terms_of(index)]
        };
        if terms.iter().any(|term| !self.found.contains_key(&term.name)) {
            self.say(Message::SplineSlopes, &[]);
            for term in around {
                self.solutions.insert(term.name.clone());
                self.stated(term.name, term.value, term.unit);
            }
        }
        let mut found = Vec::new();
        for Term { name, value, unit, right } in slopes.into_iter().chain(terms) {
            found.push(self.equate(name, value, unit, right.unwrap_or(Expr::ZERO)));
        }
        found.split_off(found.len() - 3)
    }
}

/// The angle of a cam within its turn, rad, and the turns that this adds.
fn around(law: &CamLaw) -> (f64, i64) {
    let around = law.angle.rem_euclid(TAU);
    let around = if TAU - around < NEAR { 0.0 } else { around };
    (around, ((around - law.angle) / TAU).round() as i64)
}

/// The stage in which a cam stands.
fn stage_at(step: &CamStep, around: f64) -> Option<(usize, &Phase)> {
    let phases = step.cam.program.phases();
    let index = phases.partition_point(|phase| phase.start <= around + NEAR).saturating_sub(1);
    Some((index, phases.get(index)?))
}
