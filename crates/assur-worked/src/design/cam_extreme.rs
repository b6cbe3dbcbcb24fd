//! Plate cams where they are extreme: the greatest pressure angle and the least radius of curvature.

use super::cam::{Letters, degrees};
use super::page::{Page, chosen, given};
use crate::document::text;
use crate::words::DesignMessage as Message;
use assur_formula::{Expr, Function, Unit};
use assur_math::element::cam::{Cam, Follower, Law, Part, Quantity, Shape};
use assur_math::math::SAME;

const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// Where something is extreme: the cam angle, the part of the motion whose formulas hold there, the index of its letters.
struct Place<'a> {
    phi: f64,
    part: Part,
    mark: &'a str,
}

impl<'a> Place<'a> {
    /// At a corner of the law a quantity has two values: the part is that of the value found.
    fn of(cam: &Cam, quantity: Quantity, (phi, value): (f64, f64), mark: &'a str) -> Option<Self> {
        let holds = |part: &Part| {
            let within = part.from - SAME <= phi && phi <= part.to + SAME;
            within && (cam.on_part(part, phi).value(quantity) - value).abs() <= SAME * value.abs()
        };
        let part = cam.program.parts().find(holds)?;
        Some(Self { phi, part, mark })
    }
}

impl Page {
    /// The greatest pressure angle and the least radius of curvature with their formulas.
    pub(super) fn extremes(&mut self, cam: &Cam, letters: &Letters) {
        let is_flat = cam.follower.shape() == Shape::Flat;
        let (phi, alpha) = cam.extreme(Quantity::PressureAngle, true);
        let place = Place::of(cam, Quantity::PressureAngle, (phi, alpha), "α");
        if let Some(place) = place.filter(|_| alpha > 0.0) {
            self.say(Message::CamPressure, &[vec![text(degrees(phi))]]);
            let right = self.pressure(cam, letters, &place);
            self.equate(letters.of("α", "max"), alpha.to_degrees(), Unit::Angle, right);
        }
        let (phi, radius) = cam.extreme(Quantity::CurvatureRadius, false);
        let place = Place::of(cam, Quantity::CurvatureRadius, (phi, radius), "ρ");
        if let Some(place) = place.filter(|_| radius.is_finite()) {
            let words = if is_flat { Message::FaceCurvature } else { Message::CamCurvature };
            self.say(words, &[vec![text(degrees(phi))]]);
            let right = self.curvature(cam, letters, &place);
            let pitch = self.equate(letters.of("ρ", "min"), radius, Unit::Length, right);
            if let Shape::Roller(roller) = cam.follower.shape() {
                let roller = given(letters.of("r", "r"), roller, Unit::Length);
                self.named(letters.of("ρ", "p"), Unit::Length, pitch - roller);
            }
        }
    }

    /// The lift and its first derivatives, as many as are asked for, at a place.
    fn lift_marked<const N: usize>(&mut self, cam: &Cam, letters: &Letters, place: &Place<'_>) -> [Expr; N] {
        let Place { phi, part, mark } = *place;
        let [s, v, a, ..] = cam.on_part(&part, phi).lift;
        let (scale, slope) = if letters.turns { (DEGREES, Unit::One) } else { (1.0, Unit::Length) };
        let values = [("s", scale * s, letters.unit()), ("s′", v, slope), ("s″", a, slope)];
        let phases = cam.program.phases();
        let middle = 0.5 * (part.from + part.to);
        let index = phases.partition_point(|phase| phase.start <= middle).saturating_sub(1);
        let mut right = None;
        if let Some(phase) = phases.get(index).filter(|phase| phase.law != Law::Dwell) {
            let number = (index + 1).to_string();
            let theta = chosen(letters.of("θ", mark), phi.to_degrees(), Unit::Angle);
            let begin = given(letters.of("θ", &format!("0,{number}")), phase.start.to_degrees(), Unit::Angle);
            let angle = given(letters.of("Φ", &number), phase.angle.to_degrees(), Unit::Angle);
            let passed = self.named(letters.of("u", mark), Unit::One, (theta - begin) / angle);
            // the formula is that of the middle of the part: an end belongs to two
            right = self.formulas(letters, phases, index, ((middle - phase.start) / phase.angle, passed));
        }
        let mut right = right.into_iter().flatten();
        std::array::from_fn(|order| {
            let (letter, value, unit) = values[order];
            match right.next() {
                Some(right) => self.equate(letters.of(letter, mark), value, unit, right),
                None if value == 0.0 => Expr::ZERO,
                None => self.stated(letters.of(letter, mark), value, unit),
            }
        })
    }

    fn pressure(&mut self, cam: &Cam, letters: &Letters, place: &Place<'_>) -> Expr {
        match cam.follower {
            Follower::Translating { offset, .. } => {
                let [s, v] = self.lift_marked(cam, letters, place);
                let offset = given(letters.of("e", ""), offset, Unit::Length);
                ((v - offset).abs() / (self.lift_zero(cam, letters) + s)).of(Function::Arctan)
            }
            Follower::Oscillating { shape: Shape::Flat, pivot_distance, offset, with_cam, .. } => {
                let [s, v] = self.lift_marked(cam, letters, place);
                let [slope, turn, _, cosine] =
                    self.face(cam, letters, place.mark, (pivot_distance, with_cam), [s, v]);
                let foot = if with_cam { cosine } else { -cosine };
                let offset = given(letters.of("e", ""), offset.abs(), Unit::Length);
                (offset / (slope / turn + foot).abs()).of(Function::Arctan)
            }
            Follower::Oscillating { arm, pivot_distance, with_cam, .. } => {
                let [s, v] = self.lift_marked(cam, letters, place);
                let psi = self.swing(cam, letters, s, "α");
                let [arm, distance] = [("l", arm), ("a", pivot_distance)]
                    .map(|(letter, x)| given(letters.of(letter, ""), x, Unit::Length));
                let turn = if with_cam { Expr::Int(1) - v } else { Expr::Int(1) + v };
                let top = (arm * turn - distance.clone() * psi.clone().cos()).abs();
                (top / (distance * psi.sin())).of(Function::Arctan)
            }
        }
    }

    /// The radius of curvature of the path of the follower's point in the cam: w³ over a determinant, where w is the path per rad;
    /// of the profile under a flat face: h + d²h/dχ² for the distance h of the face from the centre and its turn χ in the cam.
    fn curvature(&mut self, cam: &Cam, letters: &Letters, place: &Place<'_>) -> Expr {
        match cam.follower {
            Follower::Translating { offset, .. } => {
                let [s, v, a] = self.lift_marked(cam, letters, place);
                let reach = self.lift_zero(cam, letters) + s;
                if cam.follower.shape() == Shape::Flat {
                    return reach + a;
                }
                let offset = given(letters.of("e", ""), offset, Unit::Length);
                let reach = self.named(letters.of("d", "ρ"), Unit::Length, reach);
                let slip = v.clone() - offset;
                let w = (reach.clone().squared() + slip.clone().squared()).root();
                let w = self.named(letters.of("w", "ρ"), Unit::Length, w);
                let bottom = reach.clone().squared() + slip.clone() * (slip + v) - reach * a;
                w.cubed() / bottom
            }
            Follower::Oscillating { shape: Shape::Flat, pivot_distance, offset, with_cam, .. } => {
                let [s, v, a] = self.lift_marked(cam, letters, place);
                let [slope, turn, sine, cosine] =
                    self.face(cam, letters, place.mark, (pivot_distance, with_cam), [s, v.clone()]);
                let offset = given(letters.of("e", ""), offset, Unit::Length);
                let h = self.named(letters.of("h", "ρ"), Unit::Length, sine.clone() - offset);
                let bend = cosine * a.clone() - sine * v.squared();
                let bend = self.named(letters.of("h″", "ρ"), Unit::Length, bend);
                let crossed = slope * a;
                let top = bend * turn.clone() + if with_cam { crossed } else { -crossed };
                h + top / turn.cubed()
            }
            Follower::Oscillating { arm, pivot_distance, with_cam, .. } => {
                let [s, v, a] = self.lift_marked(cam, letters, place);
                let psi = self.swing(cam, letters, s, "ρ");
                let [arm, distance] = [("l", arm), ("a", pivot_distance)]
                    .map(|(letter, x)| given(letters.of(letter, ""), x, Unit::Length));
                let right = if with_cam { Expr::Int(1) - v } else { Expr::Int(1) + v };
                let k = self.named(letters.of("k", "ρ"), Unit::One, right);
                let (kl, cos) = (k.clone() * arm.clone(), psi.clone().cos());
                let square = distance.clone().squared();
                let w = (square.clone() + kl.clone().squared()
                    - Expr::Int(2) * distance.clone() * kl.clone() * cos.clone())
                .root();
                let w = self.named(letters.of("w", "ρ"), Unit::Length, w);
                let bottom = square + k.clone() * kl.clone().squared()
                    - distance.clone() * kl * (k + Expr::Int(1)) * cos
                    - distance * arm * a * psi.sin();
                w.cubed() / bottom
            }
        }
    }

    /// Of a swinging face: the derivative of its distance h from the cam's centre by the cam angle, how far it turns in the cam per
    /// rad, and the pivot across it and along it.
    fn face(
        &mut self,
        cam: &Cam,
        letters: &Letters,
        mark: &str,
        (pivot_distance, with_cam): (f64, bool),
        [s, v]: [Expr; 2],
    ) -> [Expr; 4] {
        self.say(Message::FaceLetters, &[]);
        let psi = self.swing(cam, letters, s, mark);
        let pivot = given(letters.of("a", ""), pivot_distance, Unit::Length);
        let [sine, cosine] = [psi.clone().sin(), psi.cos()].map(|part| pivot.clone() * part);
        let slope = self.named(letters.of("h′", mark), Unit::Length, cosine.clone() * v.clone());
        let turn = if with_cam { Expr::Int(1) - v } else { Expr::Int(1) + v };
        let turn = self.named(letters.of("k", mark), Unit::One, turn);
        [slope, turn, sine, cosine]
    }

    /// How far the follower is from the cam's centre at lift zero, along its guide.
    fn lift_zero(&self, cam: &Cam, letters: &Letters) -> Expr {
        match cam.follower {
            Follower::Translating { shape, offset } if shape != Shape::Flat && offset != 0.0 => {
                self.again(letters.of("d", "0"), cam.start(), Unit::Length)
            }
            _ => given(letters.of("r", "0"), cam.base_radius, Unit::Length),
        }
    }

    /// The angle of an arm, or of a face, from the line of centres.
    fn swing(&mut self, cam: &Cam, letters: &Letters, s: Expr, mark: &str) -> Expr {
        let right = self.again(letters.of("ψ", "0"), cam.start().to_degrees(), Unit::Angle) + s;
        self.named(letters.of("ψ", mark), Unit::Angle, right)
    }
}
