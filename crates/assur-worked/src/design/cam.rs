//! Plate cams: the law by stages, a check of it inside every stage, the base triangle, pressure angle and curvature where they
//! are extreme.

use super::page::{Page, chosen, given};
use crate::cam_law::{greatest_acceleration, shape};
use crate::document::{Line, text};
use crate::words::Message;
use assur_formula::{Expr, Function, Name, Unit, with_digits};
use assur_math::element::cam::{Cam, Follower, Law, Phase, Quantity, Shape};
use assur_model::model::{Mechanism, PlateCam};

/// The most pieces of a spline that are written one by one.
const PIECES: usize = 12;

impl Page {
    pub(super) fn cams(&mut self, mechanism: &Mechanism) {
        for plate in &mechanism.cams {
            self.heading(Message::CamOf, &[vec![text(plate.name.clone())]]);
            let several = if mechanism.cams.len() > 1 { plate.name.clone() } else { String::new() };
            let cam =
                Letters { name: several, turns: matches!(plate.cam.follower, Follower::Oscillating { .. }) };
            self.stages(plate, &cam);
            self.start(&plate.cam, &cam);
            self.extremes(&plate.cam, &cam);
        }
    }

    fn stages(&mut self, plate: &PlateCam, letters: &Letters) {
        self.say(Message::CamStages, &[]);
        let phases = plate.cam.program.phases();
        let long = phases.iter().filter(|phase| matches!(phase.law, Law::Spline(_))).count() > PIECES;
        for (i, phase) in phases.iter().enumerate() {
            let at = degrees;
            let (from, to) = (at(phase.start), at(phase.start + phase.angle));
            let range: Line = vec![text(format!("{from}° … {to}°"))];
            let Some(law) = law_of(phase.law).filter(|law| !(long && *law == Message::LawSpline)) else {
                let message = if phase.law == Law::Dwell { Message::CamDwell } else { Message::CamOther };
                self.say(message, &[range]);
                continue;
            };
            let message = if phase.change > 0.0 { Message::CamRise } else { Message::CamFall };
            let law = self.words(law);
            self.say(message, &[range, law]);
            let index = (i + 1).to_string();
            for place in places(phase.law) {
                self.lift_at(plate, letters, phase, &index, *place);
            }
        }
    }

    /// The lift and its derivative at a part of a stage.
    fn lift_at(&mut self, plate: &PlateCam, letters: &Letters, phase: &Phase, index: &str, place: f64) {
        let scale = if letters.turns { 180.0 / std::f64::consts::PI } else { 1.0 };
        let angle = given(letters.of("Φ", index), phase.angle.to_degrees(), Unit::Angle);
        let h = given(letters.of("h", index), scale * phase.change, letters.unit());
        let from = given(letters.of("s", &format!("0,{index}")), scale * phase.from, letters.unit());
        let way = place * phase.angle;
        let phi = chosen(
            letters.of("φ", &format!("{index},{}", with_digits(100.0 * place, 2).text())),
            way.to_degrees(),
            Unit::Angle,
        );
        let x = phi / angle.clone();
        let constant = self.constant(phase, letters, index, scale);
        let Some([part, slope, _]) = shape(phase.law, &h, &x, place, &constant) else { return };
        let [s, v, ..] = plate.cam.program.at(phase.start + way);
        let mark = with_digits(100.0 * place, 2).text();
        self.equate(letters.of("s", &format!("{index},{mark}")), scale * s, letters.unit(), from + part);
        let right = if letters.turns { slope / angle } else { Expr::Int(180) * slope / (Expr::Pi * angle) };
        let unit = if letters.turns { Unit::One } else { Unit::Length };
        self.equate(letters.of("s′", &format!("{index},{mark}")), v, unit, right);
    }

    /// What a law has besides the way: the greatest acceleration of modified ones, the terms of a piece of a spline.
    fn constant(&mut self, phase: &Phase, letters: &Letters, index: &str, scale: f64) -> Vec<Expr> {
        let right = match phase.law {
            Law::ModifiedTrapezoid | Law::ModifiedSine => greatest_acceleration(phase.law),
            Law::Spline(terms) => {
                let term =
                    |(letter, x)| self.constant_of(letters.of(letter, index), scale * x, letters.unit());
                return ["a", "b", "c"].into_iter().zip(terms).map(term).collect();
            }
            _ => return Vec::new(),
        };
        let name = letters.of("A", index);
        if let Some((_, known)) = self.equations.iter().find(|(_, e)| e.left.name == name) {
            return vec![known.found()];
        }
        let value = right.value();
        vec![self.equate(name, value, Unit::One, right)]
    }

    /// A number of the law that is stated; nothing where it is null.
    fn constant_of(&mut self, name: Name, value: f64, unit: Unit) -> Expr {
        if value == 0.0 { Expr::ZERO } else { self.stated(name, value, unit) }
    }

    /// Where the follower stands at lift zero.
    fn start(&mut self, cam: &Cam, letters: &Letters) {
        let base = given(letters.of("r", "0"), cam.base_radius, Unit::Length);
        match cam.follower {
            Follower::Translating { shape, offset } if shape != Shape::Flat => {
                let offset = given(letters.of("e", ""), offset, Unit::Length);
                if offset.is_zero() {
                    return;
                }
                self.say(Message::CamStart, &[]);
                let right = (base.squared() - offset.squared()).root();
                self.equate(letters.of("d", "0"), cam.start(), Unit::Length, right);
            }
            Follower::Oscillating { shape, arm, pivot_distance, .. } if shape != Shape::Flat => {
                self.say(Message::CamStart, &[]);
                let [arm, distance] = [("l", arm), ("a", pivot_distance)]
                    .map(|(letter, x)| given(letters.of(letter, ""), x, Unit::Length));
                let top = arm.clone().squared() + distance.clone().squared() - base.squared();
                let right = (top / (Expr::Int(2) * arm * distance)).of(Function::Arccos);
                self.equate(letters.of("ψ", "0"), cam.start().to_degrees(), Unit::Angle, right);
            }
            _ => {}
        }
    }

    /// The greatest pressure angle with its formula, the least radius of curvature.
    fn extremes(&mut self, cam: &Cam, letters: &Letters) {
        let (phi, alpha) = cam.extreme(Quantity::PressureAngle, true);
        if cam.follower.shape() != Shape::Flat && alpha > 0.0 {
            let here = cam.at(phi);
            let place: Line = vec![text(degrees(phi))];
            self.say(Message::CamPressure, &[place]);
            let [s, v, ..] = here.lift;
            let right = self.pressure(cam, letters, s, v);
            if let Some(right) = right {
                self.equate(letters.of("α", "max"), alpha.to_degrees(), Unit::Angle, right);
            } else {
                self.stated(letters.of("α", "max"), alpha.to_degrees(), Unit::Angle);
            }
        }
        let (phi, radius) = cam.extreme(Quantity::CurvatureRadius, false);
        if radius.is_finite() {
            let place: Line = vec![text(degrees(phi))];
            self.say(Message::CamCurvature, &[place]);
            let pitch = self.stated(letters.of("ρ", "min"), radius, Unit::Length);
            if let Shape::Roller(roller) = cam.follower.shape() {
                let roller = given(letters.of("r", "r"), roller, Unit::Length);
                let right = pitch - roller;
                let value = right.value();
                self.equate(letters.of("ρ", "p"), value, Unit::Length, right);
            }
        }
    }

    fn pressure(&mut self, cam: &Cam, letters: &Letters, s: f64, v: f64) -> Option<Expr> {
        match cam.follower {
            Follower::Translating { offset, .. } => {
                let s = self.stated(letters.of("s", "α"), s, Unit::Length);
                let v = self.stated(letters.of("s′", "α"), v, Unit::Length);
                let offset = given(letters.of("e", ""), offset, Unit::Length);
                let start = if offset.is_zero() {
                    given(letters.of("r", "0"), cam.base_radius, Unit::Length)
                } else {
                    self.again(letters.of("d", "0"), cam.start(), Unit::Length)
                };
                Some(((v - offset).abs() / (start + s)).of(Function::Arctan))
            }
            Follower::Oscillating { arm, pivot_distance, with_cam, .. } => {
                let v = self.stated(letters.of("s′", "α"), v, Unit::One);
                let start = self.again(letters.of("ψ", "0"), cam.start().to_degrees(), Unit::Angle);
                let s = self.stated(letters.of("s", "α"), s.to_degrees(), Unit::Angle);
                let right = start + s;
                let value = right.value();
                let psi = self.equate(letters.of("ψ", "α"), value, Unit::Angle, right);
                let [arm, distance] = [("l", arm), ("a", pivot_distance)]
                    .map(|(letter, x)| given(letters.of(letter, ""), x, Unit::Length));
                let turn = if with_cam { Expr::Int(1) - v } else { Expr::Int(1) + v };
                let top = (arm * turn - distance.clone() * psi.clone().cos()).abs();
                Some((top / (distance * psi.sin())).of(Function::Arctan))
            }
        }
    }

    /// A quantity that has been found above.
    fn again(&self, name: Name, value: f64, unit: Unit) -> Expr {
        let found = self.equations.iter().rev().find(|(_, e)| e.left.name == name);
        found.map_or_else(|| given(name, value, unit), |(_, e)| e.found())
    }
}

/// Letters of a cam.
struct Letters {
    name: String,
    turns: bool,
}

impl Letters {
    fn of(&self, letter: &str, sub: &str) -> Name {
        let sub = if self.name.is_empty() { sub.to_owned() } else { format!("{sub},{}", self.name) };
        Name::new(letter, sub.trim_start_matches(','))
    }

    const fn unit(&self) -> Unit {
        if self.turns { Unit::Angle } else { Unit::Length }
    }
}

/// The name of a law with a formula.
const fn law_of(law: Law) -> Option<Message> {
    match law {
        Law::Uniform => Some(Message::LawUniform),
        Law::Parabolic => Some(Message::LawParabolic),
        Law::Harmonic => Some(Message::LawHarmonic),
        Law::Cycloidal => Some(Message::LawCycloidal),
        Law::Poly345 => Some(Message::LawPoly345),
        Law::Poly4567 => Some(Message::LawPoly4567),
        Law::ModifiedTrapezoid => Some(Message::LawModifiedTrapezoid),
        Law::ModifiedSine => Some(Message::LawModifiedSine),
        Law::Spline(_) => Some(Message::LawSpline),
        Law::Dwell => None,
    }
}

/// Where in a stage its formula is filled in, as parts of the stage: in every formula that the law has in its first half.
const fn places(law: Law) -> &'static [f64] {
    match law {
        Law::Parabolic => &[0.25, 0.75],
        Law::ModifiedTrapezoid => &[0.1, 0.25, 0.4],
        Law::ModifiedSine => &[0.1, 0.4],
        _ => &[0.25],
    }
}

/// An angle with the digits that it needs, up to six.
fn degrees(x: f64) -> String {
    let written = with_digits(x.to_degrees(), 6).text();
    if written.contains('.') {
        written.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        written
    }
}
