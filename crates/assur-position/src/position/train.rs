//! Runs trains: rates and angles of their members, multipliers of their laws.

use super::body::BodyState;
use super::motion::{Point, line, place, point, under};
use super::state::State;
use super::wrench::LawForce;
use crate::math::Vec2;
use crate::plan::{LawSite, PlannedLaw, Slide, TrainMember, TrainMotion, TrainSource};

/// Position, rate and second derivative of a coordinate.
#[derive(Clone, Copy, Default)]
struct Coordinate {
    value: f64,
    rate: f64,
    second: f64,
}

impl State {
    /// Moves the members of a train.
    pub(super) fn train<const LEVEL: u8>(&mut self, branch: usize, train: &TrainMotion) {
        self.motion.conditions[branch] = if train.regular { 1.0 } else { 0.0 };
        for source in &train.sources {
            if let TrainSource::Turn { body, followed: true } = source {
                self.follow_turns(*body);
            }
        }
        for (i, member) in train.members.iter().enumerate() {
            let row = &train.coefficients[i * train.sources.len()..][..train.sources.len()];
            let mut sum = Coordinate::default();
            for (source, c) in train.sources.iter().zip(row) {
                let known = self.coordinate(source);
                sum.value += c * known.value;
                sum.rate += c * known.rate;
                sum.second += c * known.second;
            }
            match member {
                TrainMember::Turn { body, base, pin } => {
                    let hinge = point::<f64, LEVEL>(&self.motion.bodies, base);
                    let u = Vec2::direction(sum.value);
                    place::<f64, LEVEL>(&mut self.motion.bodies[*body], pin, hinge, u, sum.rate, sum.second);
                    self.motion.bodies[*body].turned = sum.value;
                }
                TrainMember::Shift(slide) => {
                    let guide = line(&self.motion.bodies, slide);
                    let p = guide.origin + guide.along * (slide.sense * sum.value);
                    let (rate, second) = (slide.sense * sum.rate, slide.sense * sum.second);
                    self.place_slider::<LEVEL>(slide, guide.along, &Some(slide.point), p, rate, second);
                }
            }
        }
    }

    /// Brings the angle of a body up to its direction: less than half a turn since it was known.
    pub(super) fn follow_turns(&mut self, body: usize) {
        let body = &mut self.motion.bodies[body];
        let principal = body.u.angle();
        let turns = ((body.turned - principal) / std::f64::consts::TAU).round();
        body.turned = principal + std::f64::consts::TAU * turns;
    }

    fn coordinate(&self, source: &TrainSource) -> Coordinate {
        match source {
            TrainSource::Turn { body, .. } => {
                let body = &self.motion.bodies[*body];
                Coordinate { value: body.turned, rate: body.omega, second: body.alpha }
            }
            TrainSource::Drive(drive) => {
                let input = &self.motion.inputs[*drive];
                Coordinate { value: input.value, rate: input.rate, second: input.acceleration }
            }
            TrainSource::Slide(slide) => self.slide_coordinate(slide),
            TrainSource::Constant => Coordinate { value: 1.0, ..Coordinate::default() },
        }
    }

    fn slide_coordinate(&self, slide: &Slide) -> Coordinate {
        let body = &self.motion.bodies[slide.body];
        let guide = line(&self.motion.bodies, slide);
        let p = body.position(slide.point);
        let beneath: Point<f64> = under::<f64, 2>(&self.motion.bodies, slide.base, p);
        let along = |v: Vec2| v.dot(guide.along) * slide.sense;
        Coordinate {
            value: along(p - guide.origin),
            rate: along(body.velocity(slide.point) - beneath.v),
            second: along(body.acceleration(slide.point) - beneath.a),
        }
    }

    /// The rate that a law speaks of at one of its sites.
    pub(super) fn site_rate(&self, site: &LawSite) -> f64 {
        match site {
            LawSite::Turn(body) => self.motion.bodies[*body].omega,
            LawSite::Slide(guide) => {
                let (slider, base) = if guide.slider == guide.body {
                    (guide.body, guide.base)
                } else {
                    (guide.base, guide.body)
                };
                let body: &BodyState = &self.motion.bodies[slider];
                let p = body.position(guide.point);
                let beneath: Point<f64> = under::<f64, 1>(&self.motion.bodies, base, p);
                (body.velocity(guide.point) - beneath.v).dot(self.direction(guide))
            }
        }
    }

    pub(super) fn site_acceleration(&self, site: &LawSite) -> f64 {
        match site {
            LawSite::Turn(body) => self.motion.bodies[*body].alpha,
            LawSite::Slide(guide) => {
                let base = if guide.slider == guide.body { guide.base } else { guide.body };
                let body = &self.motion.bodies[guide.slider];
                let beneath: Point<f64> =
                    under::<f64, 2>(&self.motion.bodies, base, body.position(guide.point));
                (body.acceleration(guide.point) - beneath.a).dot(self.direction(guide))
            }
        }
    }

    /// The generalized force of a law at one of its sites.
    pub fn law_force(&self, law: &PlannedLaw, slot: usize, term: usize) -> f64 {
        let force = &self.forces.law_forces[slot];
        match law.efficiency {
            Some(_) => law.with_losses(term, force.sides.map(|side| force.multiplier * side)),
            None => force.multiplier * law.terms[term].1,
        }
    }

    /// Calls `act` with every force of a law: body, place, force, couple.
    pub(super) fn forces_of_law(
        &self,
        law: &PlannedLaw,
        slot: usize,
        act: &mut dyn FnMut(usize, Vec2, Vec2, f64),
    ) {
        if let Some(meeting) = &law.meeting {
            self.forces_of_meeting(law, slot, meeting, act);
            return;
        }
        for (term, (site, _)) in law.terms.iter().enumerate() {
            let value = self.law_force(law, slot, term);
            match site {
                LawSite::Turn(body) => act(*body, self.motion.bodies[*body].p, Vec2::zero(), value),
                LawSite::Slide(guide) => {
                    let p = self.motion.bodies[guide.slider].position(guide.point);
                    let force = self.direction(guide) * value;
                    let other = if guide.slider == guide.body { guide.base } else { guide.body };
                    act(guide.slider, p, force, 0.0);
                    act(other, p, -force, 0.0);
                }
            }
        }
    }

    /// The pitch point and the force on the first wheel.
    pub fn meeting_force(
        &self,
        law: &PlannedLaw,
        slot: usize,
        meeting: &crate::model::Meeting,
    ) -> (Vec2, Vec2) {
        let centre = |i: usize| self.motion.bodies[meeting.links[i].index()].position(meeting.centres[i]);
        let between = centre(1) - centre(0);
        let apart = between * (1.0 / between.norm());
        let [r_1, r_2] = meeting.radii;
        let towards = if meeting.internal && r_1 < r_2 { -apart } else { apart };
        // what is lost is lost in the bearings of the side that drives: the teeth carry what the other side gets
        let sides = self.forces.law_forces[slot].sides;
        let through = sides[0].abs().min(sides[1].abs());
        let LawForce { multiplier, sense, .. } = self.forces.law_forces[slot];
        let tangential = multiplier * through * law.force;
        // with a given sense the force is linear in the multiplier
        let pressing = if sense == 0.0 { tangential.abs() } else { tangential * sense * law.force.signum() };
        // the first wheel is pressed inwards by an outer one, outwards as a ring
        let inwards = if meeting.internal && r_1 > r_2 { 1.0 } else { -1.0 };
        let radial = towards * (inwards * pressing * meeting.tangent);
        (centre(0) + towards * r_1, towards.perp() * tangential + radial)
    }

    fn forces_of_meeting(
        &self,
        law: &PlannedLaw,
        slot: usize,
        meeting: &crate::model::Meeting,
        act: &mut dyn FnMut(usize, Vec2, Vec2, f64),
    ) {
        let (p, force) = self.meeting_force(law, slot, meeting);
        let slots = meeting.links.map(|l| l.index());
        let mut rest = [0.0; 2];
        for (i, sign) in [(0, 1.0), (1, -1.0)] {
            let centre = self.motion.bodies[slots[i]].position(meeting.centres[i]);
            rest[i] = -(p - centre).cross(force * sign);
        }
        for (term, (site, _)) in law.terms.iter().enumerate() {
            let LawSite::Turn(body) = site else { continue };
            if let Some(side) = slots.iter().position(|s| s == body) {
                rest[side] += self.law_force(law, slot, term);
            }
        }
        act(slots[0], p, force, rest[0]);
        act(slots[1], p, -force, rest[1]);
        // friction of a bearing acts back on what carries it
        if let Some((LawSite::Turn(carrier), _)) = law.terms.get(2) {
            act(*carrier, p, Vec2::zero(), -(rest[0] + rest[1]));
        }
    }

    /// Power that a law takes from what it acts on, W: nothing without losses.
    pub(super) fn law_power(&self, law: &PlannedLaw, slot: usize) -> f64 {
        let terms = law.terms.iter().enumerate();
        terms.map(|(i, (site, _))| self.law_force(law, slot, i) * self.site_rate(site)).sum()
    }
}
