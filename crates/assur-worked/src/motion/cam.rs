//! Followers of designed cams: the law of the cam at its angle, and the rates by the chain rule.

use super::{Stage, of};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::element::cam::Follower;
use assur_position::plan::{CamStep, Slide};

/// The law of a cam at its angle.
pub(super) struct CamLaw {
    /// The letters of the cam's angle and of the lift.
    pub turned: Name,
    /// The lift of the follower.
    pub lift: Name,
    /// The angle of the cam, rad.
    pub angle: f64,
    /// Lift, first and second derivative: m, or rad where the follower turns.
    pub values: [f64; 3],
    pub turns: bool,
}

impl Derivation<'_> {
    /// A follower that its cam moves.
    pub(super) fn cam(&mut self, stage: Stage, step: &CamStep) {
        let contact = &step.contact;
        let law = self.law_of_cam(step, "s");
        match stage {
            Stage::Positions => {
                let cam = self.scene.mechanism().cams[contact.cam].name.clone();
                self.say(Message::CamTurned, &[vec![text(cam)], of(&law.turned), of(&law.lift)]);
                self.angle_of_cam(step, &law);
                if self.dwells(step, &law) {
                    self.say(Message::CamDwells, &[]);
                }
                match self.lift_by_stage(step, &law) {
                    Some([lift, ..]) => {
                        let (value, unit) = law.lifted();
                        self.equate(law.lift.clone(), value, unit, lift);
                    }
                    None => self.lift(&law, step),
                }
                self.bodies_of_cam(step, &law);
                self.block_placed(stage, step, &law);
            }
            Stage::Velocities => {
                let right = self.derivative(&law, step, 1) * self.rate_of_cam(step, 0);
                self.rate_of_follower(0, step, law.turns, right);
                self.block_placed(stage, step, &law);
            }
            Stage::Accelerations => {
                let (first, second) = (self.derivative(&law, step, 1), self.derivative(&law, step, 2));
                let right = second * self.rate_of_cam(step, 0).squared() + first * self.rate_of_cam(step, 1);
                self.rate_of_follower(1, step, law.turns, right);
            }
        }
    }

    /// The angular velocity (0) or acceleration (1) of a cam against its frame, in the sense in which its angle counts.
    fn rate_of_cam(&self, step: &CamStep, order: usize) -> Expr {
        let rate = self.rate_of_body(step.contact.disk.index(), order)
            - self.rate_of_body(step.contact.frame.index(), order);
        if step.cam.ccw { rate } else { -rate }
    }

    /// The angular velocity (0) or acceleration (1) of a body.
    pub(crate) fn rate_of_body(&self, body: usize, order: usize) -> Expr {
        self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone())
    }

    /// The direction in which the frame of a cam looks for its follower.
    pub(super) fn cam_looks(&self, step: &CamStep, of: usize) -> Angle {
        let frame = self.bodies[step.contact.frame.index()].as_ref();
        let own = self.direction_given(step.contact.towards, || Name::new("λ", &self.label(of)));
        frame.map_or(own.clone(), |frame| frame.angle.plus(&own))
    }

    /// The angle by which a cam has turned since its x axis pointed to the follower.
    fn angle_of_cam(&mut self, step: &CamStep, law: &CamLaw) {
        let disk = step.contact.disk.index();
        let own = self.bodies[disk].as_ref().map_or(Angle::ZERO, |b| b.angle.clone());
        let looks = self.cam_looks(step, step.contact.follower.index());
        let right = if step.cam.ccw { own.minus(&looks) } else { looks.minus(&own) };
        let right = right.whole();
        if right.is_zero() {
            self.stated(law.turned.clone(), 0.0, Unit::Angle);
        } else {
            self.angle_sum(law.turned.clone(), right);
        }
    }

    /// The law of a cam where it stands now, with the letter of a lift that is a shift.
    pub(super) fn law_of_cam(&self, step: &CamStep, shift: &'static str) -> CamLaw {
        let contact = &step.contact;
        let sense = if step.cam.ccw { -1.0 } else { 1.0 };
        let towards = contact.towards.turned(self.moved(contact.frame.index()).u);
        let angle = sense * towards.turned_back(self.moved(contact.disk.index()).u).angle();
        let [s, first, second, _] = step.cam.at(angle).lift;
        let turns = matches!(step.cam.follower, Follower::Oscillating { .. });
        let pair = self.scene.mechanism().pair(contact.pair).name.clone();
        let lift = Name::new(if turns { "ψ" } else { shift }, &pair);
        CamLaw { turned: Name::new("θ", &pair), lift, angle, values: [s, first, second], turns }
    }

    /// The lift as the law has it.
    pub(super) fn lift(&mut self, law: &CamLaw, step: &CamStep) {
        let (value, unit) = law.lifted();
        let scale = if law.turns { 180.0 / std::f64::consts::PI } else { 1.0 };
        self.stated_of(law.lift.clone(), value, unit, scale * step.cam.program.greatest_lift());
    }

    /// A derivative of the lift by the angle of the cam.
    pub(super) fn derivative(&mut self, law: &CamLaw, step: &CamStep, order: usize) -> Expr {
        let marks = ["", "′", "″"][order];
        let name = Name { letter: format!("{}{marks}", law.lift.letter), ..law.lift.clone() };
        let unit = if law.turns { Unit::One } else { Unit::Length };
        match self.lift_by_stage(step, law) {
            Some(formulas) => self.equate(name, law.values[order], unit, formulas[order].clone()),
            None => self.stated(name, law.values[order], unit),
        }
    }

    /// Where the follower is.
    fn bodies_of_cam(&mut self, step: &CamStep, law: &CamLaw) {
        let lift = self.found.get(&law.lift).cloned().unwrap_or(Expr::ZERO);
        if law.turns {
            self.lever_of_cam(step, lift);
        } else {
            self.tappet_of_cam(step, law, lift);
        }
    }

    /// The lever: φ = λ + 180° ∓ (ψ₀ + ψ).
    fn lever_of_cam(&mut self, step: &CamStep, lift: Expr) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let begin = self.given(self.start_name(step, "ψ"), step.cam.start().to_degrees(), Unit::Angle);
        let looks = self.cam_looks(step, slot);
        let own = self.direction_given(contact.direction, || Name::new("λ′", &self.label(slot)));
        let base = looks.minus(&own).whole() + Expr::Degrees(180);
        let angle = begin + lift;
        let right = if lifts_clockwise(step) { base - angle } else { base + angle };
        let phi = self.angle_sum(Name::new("φ", &self.label(slot)), right);
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[slot] = Some(Body { reference: contact.point, angle: Angle::of(phi), rates });
    }

    /// The lift of a lever that stands somewhere: ψ = ±(φ − λ − 180°) − ψ₀.
    pub(super) fn lift_of_lever(&mut self, step: &CamStep, law: &CamLaw) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let begin = self.given(self.start_name(step, "ψ"), step.cam.start().to_degrees(), Unit::Angle);
        let own = self.direction_given(contact.direction, || Name::new("λ′", &self.label(slot)));
        let base = self.cam_looks(step, slot).minus(&own).whole() + Expr::Degrees(180);
        let phi = self.bodies[slot].as_ref().map_or(Expr::ZERO, |b| b.angle.whole());
        let right = if lifts_clockwise(step) { base - phi } else { phi - base };
        self.angle_sum(law.lift.clone(), right - begin);
    }

    /// What slides: at the distance d + s from the cam's centre, along the way of the follower.
    fn tappet_of_cam(&mut self, step: &CamStep, law: &CamLaw, lift: Expr) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let looks = self.cam_looks(step, slot);
        let own = self.direction_given(contact.direction, || Name::new("λ′", &self.label(slot)));
        let begin = Name { letter: "d".into(), ..law.lift.clone() };
        // said only where the place of the follower is needed
        self.lines.push((self.blocks.len(), begin.clone()));
        self.optional.insert(self.blocks.len());
        self.say(Message::LiftBegins, &[of(&begin)]);
        let along = self.given(begin, step.cam.start(), Unit::Length) + lift;
        let beside = if contact.beside.abs() <= self.tiny { 0.0 } else { contact.beside };
        let beside = self.given(Name::new("b", &law.lift.sub), beside, Unit::Length);
        let [x, y] = self.position(contact.frame.index(), contact.frame_centre);
        let right = [
            x + along.clone() * looks.cos() - beside.clone() * looks.sin(),
            y + along * looks.sin() + beside * looks.cos(),
        ];
        let value = self.moved(slot).position(contact.point);
        let name = self.point_name(slot, contact.point);
        self.coordinates(&name, value, right);
        let rates = [Expr::ZERO, Expr::ZERO];
        self.bodies[slot] = Some(Body { reference: contact.point, angle: looks.minus(&own), rates });
    }

    /// The letters of where the follower stands at lift zero: those of the section on cams.
    fn start_name(&self, step: &CamStep, letter: &str) -> Name {
        let cams = &self.scene.mechanism().cams;
        let sub = if cams.len() > 1 { format!("0,{}", cams[step.contact.cam].name) } else { "0".to_owned() };
        Name::new(letter, &sub)
    }

    /// The velocity (0) or acceleration (1) of the follower from that of its lift.
    fn rate_of_follower(&mut self, order: usize, step: &CamStep, turns: bool, right: Expr) {
        let contact = &step.contact;
        let slot = contact.follower.index();
        let moved = *self.moved(slot);
        if turns {
            let value = [moved.omega, moved.alpha][order];
            let name = Name::new(["ω", "α"][order], &self.label(slot));
            let unit = [Unit::AngularVelocity, Unit::AngularAcceleration][order];
            let frame = self.rate_of_body(contact.frame.index(), order);
            let right = if lifts_clockwise(step) { frame - right } else { frame + right };
            let found = self.equate(name, value, unit, right);
            self.set_rate(slot, order, found);
        } else if contact.frame.index() != 0 {
            self.slid_on_frame(order, step, right);
        } else {
            let direction = self.direction_given(contact.towards, || Name::new("λ", &self.label(slot)));
            let point = self.point_name(slot, contact.point);
            let value = [moved.velocity(contact.point), moved.acceleration(contact.point)][order];
            let unit = [Unit::Velocity, Unit::Acceleration][order];
            let name = Name::new(["v", "a"][order], &point);
            let found = self.equate(name, value.dot(contact.towards), unit, right);
            let parts = [found.clone() * direction.cos(), found * direction.sin()];
            self.keep(order + 1, &point, parts);
        }
    }

    /// A follower that slides on a frame which moves: relative motion, what is under it, and Coriolis.
    fn slid_on_frame(&mut self, order: usize, step: &CamStep, right: Expr) {
        let contact = &step.contact;
        let (frame, slot) = (contact.frame.index(), contact.follower.index());
        let slide = Slide {
            base: frame,
            origin: contact.frame_centre,
            along: contact.towards,
            body: slot,
            point: contact.point,
            direction: contact.direction,
            turn: contact.towards.turned_back(contact.direction),
            radius: 0.0,
            sense: 1.0,
        };
        let value = self.rpr_sliding(order + 1, &slide, contact.point);
        let name = self.sliding_name(["v", "a"][order], &slide, contact.point);
        let unit = [Unit::Velocity, Unit::Acceleration][order];
        let found = self.equate(name, value, unit, right);
        self.set_slider_rate(&slide, order);
        self.slid(order + 1, &slide, contact.point, &found);
    }
}

impl CamLaw {
    /// The lift in the unit of equations.
    pub(super) fn lifted(&self) -> (f64, Unit) {
        if self.turns { (self.values[0].to_degrees(), Unit::Angle) } else { (self.values[0], Unit::Length) }
    }
}

/// Whether the lift of a lever counts clockwise.
pub(super) fn lifts_clockwise(step: &CamStep) -> bool {
    let with_cam = matches!(step.cam.follower, Follower::Oscillating { with_cam: true, .. });
    with_cam != step.cam.ccw
}
