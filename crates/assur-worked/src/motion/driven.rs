//! Links that a drive moves.

use super::{Stage, pin};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::Value;
use assur_position::plan::{Anchor, Arm, Slide};

/// Where the rates of a drive come from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Origin {
    /// The file gives them.
    File,
    /// The motion under the loads has them.
    Motion,
    /// The file gives the sense alone: the rate is one unit.
    Sense,
}

impl Derivation<'_> {
    /// A link on a hinge at a driven angle.
    pub(super) fn turn(
        &mut self,
        stage: Stage,
        body: usize,
        base: &Anchor,
        arm: Arm,
        drive: usize,
        relative: Option<f64>,
    ) {
        let input = self.state().motion.inputs[drive];
        let label = self.label(body);
        match stage {
            Stage::Positions => {
                let angle = match relative {
                    None => {
                        let value = input.value.to_degrees();
                        Angle::of(self.given(Name::new("φ", &label), value, Unit::Angle))
                    }
                    Some(sign) => self.relative_angle(body, base.body, sign * input.value.to_degrees()),
                };
                self.bodies[body] =
                    Some(Body { reference: pin(&arm), angle, rates: [Expr::ZERO, Expr::ZERO] });
                let sought = self.scene.mechanism().drives[drive].sought.is_some();
                let message = match (sought, self.is_free(drive)) {
                    (true, _) => Message::EquilibriumAngle,
                    (false, true) => Message::FreeCoordinate,
                    (false, false) => Message::DrivenAngle,
                };
                self.say(message, &[super::of(&Name::new("φ", &label))]);
            }
            Stage::Velocities => {
                let letters = super::of(&Name::new("ω", &label));
                let origin = self.origin(drive);
                let rate =
                    self.rate((Name::new("ω", &label), 0, drive), base.body, relative, input.rate, body);
                match origin {
                    Origin::File => self.say(Message::DrivenRate, &[letters]),
                    Origin::Motion => self.say(Message::FreeCoordinate, &[letters]),
                    Origin::Sense => {}
                }
                self.set_rate(body, 0, rate);
            }
            Stage::Accelerations => {
                let rate = self.rate(
                    (Name::new("α", &label), 1, drive),
                    base.body,
                    relative,
                    input.acceleration,
                    body,
                );
                if rate.is_zero() {
                    self.say(Message::Uniform, &[super::of(&Name::new("α", &label))]);
                }
                self.set_rate(body, 1, rate);
            }
        }
    }

    /// A link that stands freely: a point of it and its angle.
    pub(super) fn free(
        &mut self,
        stage: Stage,
        (body, at): (usize, Vec2),
        place: [usize; 2],
        turn: Option<usize>,
    ) {
        let (label, point) = (self.label(body), self.point_name(body, at));
        let inputs = place.map(|drive| self.state().motion.inputs[drive]);
        let input = turn.map(|drive| self.state().motion.inputs[drive]);
        let order = stage as usize;
        if stage == Stage::Positions {
            let names = ["x", "y"].map(|letter| Name::new(letter, &point));
            let [x, y] = [0, 1].map(|i| self.given(names[i].clone(), inputs[i].value, Unit::Length));
            self.points[0].insert(point, [x, y]);
            let angle = input.map_or(Angle::ZERO, |input| {
                Angle::of(self.given(Name::new("φ", &label), input.value.to_degrees(), Unit::Angle))
            });
            self.bodies[body] = Some(Body { reference: at, angle, rates: [Expr::ZERO, Expr::ZERO] });
            let message = if self.is_free(place[0]) { Message::FreeCoordinate } else { Message::DrivenAngle };
            let mut letters: Vec<Name> = names.to_vec();
            letters.extend(turn.map(|_| Name::new("φ", &label)));
            letters.iter().for_each(|name| self.say(message, &[super::of(name)]));
            return;
        }
        let (letter, unit) = [("v", Unit::Velocity), ("a", Unit::Acceleration)][order - 1];
        let rates = inputs.map(|input| [input.rate, input.acceleration][order - 1]);
        let parts = ["x", "y"].map(|axis| Name::new(letter, &point).and(axis));
        let found = [0, 1].map(|i| self.given_or_stated(parts[i].clone(), rates[i], unit, place[i]));
        self.keep(order, &point, found);
        if let (Some(drive), Some(input)) = (turn, input) {
            let (name, unit) = [("ω", Unit::AngularVelocity), ("α", Unit::AngularAcceleration)][order - 1];
            let value = [input.rate, input.acceleration][order - 1];
            let rate = self.given_or_stated(Name::new(name, &label), value, unit, drive);
            self.set_rate(body, order - 1, rate);
        }
    }

    /// Where the rates of a drive come from.
    fn origin(&self, drive: usize) -> Origin {
        let file = self.scene.mechanism().drives.get(drive);
        if self.is_free(drive) {
            Origin::Motion
        } else if file.is_some_and(|d| d.sense.is_some() && d.speed.is_none()) {
            Origin::Sense
        } else {
            Origin::File
        }
    }

    /// A rate: of the file where it gives it; else that of the motion at this instant, or a unit where the file gives the sense alone.
    pub(super) fn given_or_stated(&mut self, name: Name, value: f64, unit: Unit, drive: usize) -> Expr {
        let is_result = matches!(unit, Unit::AngularAcceleration | Unit::Acceleration);
        match self.origin(drive) {
            Origin::File => self.given(name, value, unit),
            Origin::Motion if !is_result => self.given(name, value, unit),
            _ if value.abs() == 0.0 => Expr::ZERO,
            _ => {
                let motion = self.origin(drive) == Origin::Motion;
                let message = if motion { Message::FreeCoordinate } else { Message::SenseOnly };
                self.say(message, &[super::of(&name)]);
                self.taken.insert(name.clone());
                self.stated(name, value, unit)
            }
        }
    }

    /// Whether a coordinate is not driven and follows from the loads.
    pub fn is_free(&self, drive: usize) -> bool {
        let run = self.scene.solution.simulation.as_ref();
        run.is_some_and(|run| run.coordinates.contains(&drive))
    }

    fn relative_angle(&mut self, body: usize, base: usize, degrees: f64) -> Angle {
        let label = self.label(body);
        let part = self.relative_part(body, base, degrees);
        let from = self.bodies[base].as_ref().map_or(Angle::ZERO, |b| b.angle.clone());
        Angle::of(self.angle_sum(Name::new("φ", &label), from.whole() + part))
    }

    /// The angle of a driven link against its base.
    pub(super) fn relative_part(&self, body: usize, base: usize, degrees: f64) -> Expr {
        let (label, other) = (self.label(body), self.label(base));
        self.given(Name::new("φ", &format!("{label},{other}")), degrees, Unit::Angle)
    }

    /// The coordinate along a driven guide.
    pub(super) fn driven_way(&self, slide: &Slide, drive: usize) -> Expr {
        let value = self.state().motion.inputs[drive].value * slide.sense;
        self.given(self.sliding_name("s", slide, slide.point), value, Unit::Length)
    }

    /// The rate of a driven link: given, or that of its base and the one against it.
    fn rate(
        &mut self,
        (name, order, drive): (Name, usize, usize),
        base: usize,
        relative: Option<f64>,
        value: f64,
        body: usize,
    ) -> Expr {
        let unit = [Unit::AngularVelocity, Unit::AngularAcceleration][order];
        let Some(sign) = relative else { return self.given_rate(name, value, unit, drive) };
        let (own, other) = (name.sub.clone(), self.label(base));
        let part = Name::new(&name.letter, &format!("{own},{other}"));
        let part = self.given_or_stated(part, sign * value, unit, drive);
        let from = self.bodies[base].as_ref().map_or(Expr::ZERO, |b| b.rates[order].clone());
        let moved = self.moved(body);
        let whole = if order == 0 { moved.omega } else { moved.alpha };
        self.equate(name, whole, unit, from + part)
    }

    /// A rate that the file states, from a speed of rotation where it gives that.
    fn given_rate(&mut self, name: Name, value: f64, unit: Unit, drive: usize) -> Expr {
        if self.origin(drive) != Origin::File {
            return self.given_or_stated(name, value, unit, drive);
        }
        let mechanism = self.scene.mechanism();
        let speed = mechanism.values.iter().find(|v| {
            v.display.unit == "rpm"
                && matches!(v.value, Value::Scalar(x) if (x.abs() - value.abs()).abs() <= 1e-12 * value.abs())
        });
        let Some(speed) = speed.filter(|_| unit == Unit::AngularVelocity && value != 0.0) else {
            return self.given(name, value, unit);
        };
        let Value::Scalar(si) = speed.value else { return self.given(name, value, unit) };
        let letters = crate::forces::quantity_name(&speed.name);
        let turns = self.given(letters, speed.display.of_si(si), Unit::Speed);
        let right = Expr::Pi * turns / Expr::Int(30);
        self.equate(name, value, unit, if si * value < 0.0 { -right } else { right })
    }

    /// Keeps the angular velocity (0) or acceleration (1) of a body.
    pub fn set_rate(&mut self, body: usize, order: usize, rate: Expr) {
        if let Some(known) = &mut self.bodies[body] {
            known.rates[order] = rate;
        }
    }

    /// A body on a guide at a driven coordinate.
    pub(super) fn shift(&mut self, stage: Stage, slide: &Slide, drive: usize) {
        let input = self.state().motion.inputs[drive];
        let point = self.point_name(slide.body, slide.point);
        let (value, letter, unit) = match stage {
            Stage::Positions => (input.value, "s", Unit::Length),
            Stage::Velocities => (input.rate, "v", Unit::Velocity),
            Stage::Accelerations => (input.acceleration, "a", Unit::Acceleration),
        };
        let index =
            if slide.base == 0 { point.clone() } else { format!("{point},{}", self.label(slide.base)) };
        let name = Name::new(letter, &index);
        let rests = stage == Stage::Positions && value.abs() <= self.tiny;
        let value = if rests { 0.0 } else { value * slide.sense };
        let along = if stage == Stage::Positions {
            self.given(name.clone(), value, unit)
        } else {
            self.given_or_stated(name.clone(), value, unit, drive)
        };
        self.found.insert(name, along.clone());
        match stage {
            Stage::Positions => {
                let guide = self.guide(slide);
                let from = self.position(slide.base, slide.origin);
                let value = self.moved(slide.body).position(slide.point);
                let [x, y] = from;
                let right = [x + along.clone() * guide.cos(), y + along * guide.sin()];
                self.coordinates(&point, value, right);
                self.slider(slide, slide.point);
            }
            Stage::Velocities => {
                self.set_slider_rate(slide, 0);
                self.slid(1, slide, slide.point, &along);
            }
            Stage::Accelerations => {
                self.set_slider_rate(slide, 1);
                self.slid(2, slide, slide.point, &along);
            }
        }
    }

    /// The speed along a guide in a sentence's letters.
    pub(super) fn sliding_name(&self, letter: &str, slide: &Slide, at: Vec2) -> Name {
        let point = self.point_name(slide.body, at);
        if slide.base == 0 {
            Name::new(letter, &point)
        } else {
            Name::new(letter, &format!("{point},{}", self.label(slide.base)))
        }
    }
}
