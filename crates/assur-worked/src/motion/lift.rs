//! The lift of a cam at a position: the formula of the stage in which the cam stands.

use super::cam::CamLaw;
use crate::cam_law::{derivatives, greatest_acceleration, is_of_half, shape};
use crate::course::Course;
use assur_formula::{Expr, Name, Unit};
use assur_math::element::cam::{Law, Phase};
use assur_position::plan::CamStep;
use std::f64::consts::{PI, TAU};

/// Angles nearer than this are one, rad.
const NEAR: f64 = 1e-12;

impl Course<'_> {
    /// The lift and its derivatives by the cam's angle, as formulas; none in a dwell.
    pub(super) fn lift_by_stage(&mut self, step: &CamStep, law: &CamLaw) -> Option<[Expr; 3]> {
        let around = law.angle.rem_euclid(TAU);
        let around = if TAU - around < NEAR { 0.0 } else { around };
        let phases = step.cam.program.phases();
        let index = phases.partition_point(|phase| phase.start <= around + NEAR).saturating_sub(1);
        let phase = phases.get(index).filter(|phase| phase.law != Law::Dwell)?;
        let stage = self.stage_index(step, index);
        let (scale, unit) = if law.turns { (180.0 / PI, Unit::Angle) } else { (1.0, Unit::Length) };
        let turned = self.found.get(&law.turned).cloned().unwrap_or(Expr::ZERO);
        let turns = ((around - law.angle) / TAU).round() as i64;
        let begin = self.given(Name::new("θ", &format!("0,{stage}")), phase.start.to_degrees(), Unit::Angle);
        let angle = self.given(Name::new("Φ", &stage), phase.angle.to_degrees(), Unit::Angle);
        let x = ((around - phase.start) / phase.angle).clamp(0.0, 1.0);
        let right = (turned + Expr::Degrees(360 * turns) - begin) / angle.clone();
        let part = self.equate(Name::new("u", &law.lift.sub), x, Unit::One, right);
        let h = self.given(Name::new("h", &stage), scale * phase.change, unit);
        let from = self.given(Name::new("s", &format!("0,{stage}")), scale * phase.from, unit);
        let constants = self.constants_of(phase, &stage, scale, unit);
        let mirrored = is_of_half(phase.law) && x > 0.5;
        let (place, of) = if mirrored { (1.0 - x, Expr::Int(1) - part) } else { (x, part) };
        let [way, slope, bend] = shape(phase.law, &h, &of, place, &constants)?;
        let [way, bend] = if mirrored { [h - way, -bend] } else { [way, bend] };
        let [first, second] = derivatives(law.turns, slope, bend, angle);
        Some([from + way, first, second])
    }

    /// The number of a stage, with the cam's name where there are several: the letters of the section on cams.
    fn stage_index(&self, step: &CamStep, index: usize) -> String {
        let cams = &self.scene.mechanism().cams;
        let number = index + 1;
        if cams.len() > 1 { format!("{number},{}", cams[step.contact.cam].name) } else { number.to_string() }
    }

    /// What a law has besides the way: the greatest acceleration of modified ones, the terms of a piece of a spline.
    fn constants_of(&mut self, phase: &Phase, stage: &str, scale: f64, unit: Unit) -> Vec<Expr> {
        match phase.law {
            Law::Spline(terms) => {
                let term = |(letter, x): (&str, f64)| {
                    let name = Name::new(letter, stage);
                    if x == 0.0 { Expr::ZERO } else { self.stated(name, scale * x, unit) }
                };
                ["a", "b", "c"].into_iter().zip(terms).map(term).collect()
            }
            law if is_of_half(law) => {
                let right = greatest_acceleration(law);
                let value = right.value();
                vec![self.equate(Name::new("A", stage), value, Unit::One, right)]
            }
            _ => Vec::new(),
        }
    }
}
