//! Plate cams: the law by stages, a check of it inside every stage, and the base triangle.

use super::page::{Page, chosen, given};
use crate::cam_law::{derived, greatest_acceleration, in_radians};
use crate::document::{Line, text};
use crate::spline::{Spline, Term};
use crate::words::DesignMessage as Message;
use assur_formula::{Expr, Function, Name, Unit, with_digits};
use assur_math::element::cam::{Cam, Follower, Law, Phase, Shape};
use assur_model::model::{Mechanism, PlateCam};

const DEGREES: f64 = 180.0 / std::f64::consts::PI;

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
        self.slopes(phases, letters);
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
            for place in places(phase.law) {
                self.lift_at(plate, letters, i, *place);
            }
        }
    }

    /// The lift and its derivative at a part of a stage.
    fn lift_at(&mut self, plate: &PlateCam, letters: &Letters, at: usize, place: f64) {
        let mark = format!("{},{}", at + 1, with_digits(100.0 * place, 2).text());
        let part = chosen(letters.of("u", &mark), place, Unit::One);
        let phases = plate.cam.program.phases();
        let Some([s, v, _]) = self.formulas(letters, phases, at, (place, part)) else { return };
        let phase = &phases[at];
        let [lift, first, ..] = plate.cam.program.at(phase.start + place * phase.angle);
        let (scale, slope) = if letters.turns { (DEGREES, Unit::One) } else { (1.0, Unit::Length) };
        self.equate(letters.of("s", &mark), scale * lift, letters.unit(), s);
        self.equate(letters.of("s′", &mark), first, slope, v);
    }

    /// The formulas of the lift and its derivatives at a part of a stage; a law of halves has those of the first, mirrored.
    pub(super) fn formulas(
        &mut self,
        letters: &Letters,
        phases: &[Phase],
        at: usize,
        (place, part): (f64, Expr),
    ) -> Option<[Expr; 3]> {
        let (phase, index) = (phases.get(at)?, &(at + 1).to_string());
        let scale = if letters.turns { DEGREES } else { 1.0 };
        let angle = self.in_radians(letters.of("Φ", index), phase.angle);
        let h = given(letters.of("h", index), scale * phase.change, letters.unit());
        let from = given(letters.of("s", &format!("0,{index}")), scale * phase.from, letters.unit());
        let constant = self.constant(phases, letters, at);
        let is_spline = matches!(phase.law, Law::Spline(_));
        let own = if letters.turns && !is_spline {
            self.in_radians(letters.of("h", index), phase.change)
        } else {
            h.clone()
        };
        let [way, first, second] = derived(phase.law, [&h, &own], (place, part), &constant, &angle)?;
        Some([from + way, first, second])
    }

    /// An angle of the file in rad, written once.
    fn in_radians(&mut self, name: Name, angle: f64) -> Expr {
        match self.written(&name) {
            Some(known) => known,
            None => self.equate(name, angle, Unit::Radian, in_radians(angle)),
        }
    }

    /// What a law has besides the way: the greatest acceleration of modified ones, the terms of a piece of a spline.
    fn constant(&mut self, phases: &[Phase], letters: &Letters, at: usize) -> Vec<Expr> {
        let right = match phases[at].law {
            Law::ModifiedTrapezoid | Law::ModifiedSine => greatest_acceleration(phases[at].law),
            Law::Spline(_) => return self.terms_of_spline(phases, letters, at),
            _ => return Vec::new(),
        };
        let name = letters.of("A", &(at + 1).to_string());
        if let Some(known) = self.written(&name) {
            return vec![known];
        }
        vec![self.named(name, Unit::One, right)]
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
            Follower::Oscillating { pivot_distance, offset, .. } => {
                self.say(Message::CamStart, &[]);
                let [distance, offset] = [("a", pivot_distance), ("e", offset)]
                    .map(|(letter, x)| given(letters.of(letter, ""), x, Unit::Length));
                let right = ((base + offset) / distance).of(Function::Arcsin);
                self.equate(letters.of("ψ", "0"), cam.start().to_degrees(), Unit::Angle, right);
            }
            Follower::Translating { .. } => {}
        }
    }

    /// A quantity that has been found above.
    pub(super) fn again(&self, name: Name, value: f64, unit: Unit) -> Expr {
        let found = self.equations.iter().rev().find(|(_, e)| e.left.name == name);
        found.map_or_else(|| given(name, value, unit), |(_, e)| e.found())
    }
}

/// Letters of a cam.
pub(super) struct Letters {
    name: String,
    pub(super) turns: bool,
}

impl Letters {
    pub(super) fn of(&self, letter: &str, sub: &str) -> Name {
        let sub = if self.name.is_empty() { sub.to_owned() } else { format!("{sub},{}", self.name) };
        Name::new(letter, sub.trim_start_matches(','))
    }

    pub(super) const fn unit(&self) -> Unit {
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
pub(super) fn degrees(x: f64) -> String {
    let written = with_digits(x.to_degrees(), 6).text();
    if written.contains('.') {
        written.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        written
    }
}

// Splines through tables of lifts: the slopes at the rows as a table, and the terms of a piece from them.

impl Page {
    /// The rows of the tables: angle, lift, slope.
    pub(super) fn slopes(&mut self, phases: &[Phase], letters: &Letters) {
        let name = |letter: &str, stage: usize| letters.of(letter, &stage.to_string());
        let spline = Spline { phases, turns: letters.turns, name: &name, given: &given };
        let scale = if letters.turns { 1_f64.to_degrees() } else { 1.0 };
        let mut rows = Vec::new();
        for (i, phase) in phases.iter().enumerate().filter(|(_, p)| matches!(p.law, Law::Spline(_))) {
            let figures = [scale * phase.from, spline.slope(i)].map(|x| with_digits(x, 5).text());
            let cells = [(i + 1).to_string(), degrees(phase.start)].into_iter().chain(figures);
            rows.push(cells.map(|cell| vec![text(cell)]).collect());
        }
        if !rows.is_empty() {
            self.say(Message::CamSlopes, &[]);
            let units = if letters.turns { ["ψ, °", "σ"] } else { ["s, m", "σ, m"] };
            let headers = ["i", "θ, °"].into_iter().chain(units).map(|header| vec![text(header)]);
            self.table(headers.collect(), rows);
        }
    }

    /// The terms of a piece, with the slopes at its ends; what is written already is not written again.
    pub(super) fn terms_of_spline(&mut self, phases: &[Phase], letters: &Letters, at: usize) -> Vec<Expr> {
        let name = |letter: &str, stage: usize| letters.of(letter, &stage.to_string());
        let spline = Spline { phases, turns: letters.turns, name: &name, given: &given };
        for term in spline.slopes_of(at) {
            self.once(term);
        }
        spline.terms_of(at).into_iter().map(|term| self.once(term)).collect()
    }

    fn once(&mut self, Term { name, value, unit, right }: Term) -> Expr {
        match self.written(&name) {
            Some(found) => found,
            None => self.equate(name, value, unit, right.unwrap_or(Expr::ZERO)),
        }
    }

    /// What an equation has found.
    pub(super) fn written(&self, name: &Name) -> Option<Expr> {
        self.equations.iter().find(|(_, e)| e.left.name == *name).map(|(_, e)| e.found())
    }
}
