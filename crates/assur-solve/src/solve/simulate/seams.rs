//! Where the mechanism itself is not smooth: where a designed cam goes over to the next part of its law, and where the length of a
//! spring passes zero, so that its force turns round.
//!
//! A step takes cams and springs as it takes loads: on the sides where it begins, also beyond. A cam has two numbers, which say how far
//! both ends of its part are; a spring one, which falls through zero where it turns by a right angle: there its length is zero, or it
//! is taken anew.

use super::equations::Equations;
use crate::math::Vec2;
use crate::model::Spring;
use crate::position::State;

/// Ends of the part of a cam's law.
const ENDS: usize = 2;
/// A spring is no longer than this part of the mechanism where its length passes zero.
const NOTHING: f64 = 1e-9;
/// What moves may come further in a step than by its velocities at both ends, so many times.
const FURTHER: f64 = 2.0;

/// From one end of a spring to the other: the way and the velocity.
fn between(spring: &Spring, state: &State) -> (Vec2, Vec2) {
    let [one, two] = [spring.from, spring.to].map(|(link, at)| {
        let body = &state.motion.bodies[link.index()];
        (body.position(at), body.velocity(at))
    });
    (two.0 - one.0, two.1 - one.1)
}

/// Whether the force of a spring has a value at length zero.
fn turns_round(spring: &Spring) -> bool {
    spring.free_length > 0.0 && spring.stiffness > 0.0
}

impl Equations<'_, '_> {
    /// The numbers of all cams and springs.
    pub fn seams(&self) -> usize {
        let springs = &self.model.mechanism.springs;
        let springs = if springs.iter().any(turns_round) { springs.len() } else { 0 };
        ENDS * self.model.plan.cams.len() + springs
    }

    /// Takes cams and springs as they are, wherever that is.
    pub fn release_seams(&mut self) {
        self.trial.motion.laws.clear();
        self.trial.motion.towards.clear();
    }

    /// Takes all on the sides where they are in the state that is observed.
    pub fn take_seams(&mut self) {
        if self.seams() == 0 {
            return;
        }
        let plan = self.model.plan;
        self.trial.motion.laws.resize(if plan.cams.is_empty() { 0 } else { plan.cam_contacts }, None);
        for step in &plan.cams {
            let (phi, _) = self.trial.cam_angle(step);
            self.trial.motion.laws[step.index] = step.cam.program.part_at(phi);
        }
        for spring in &self.model.mechanism.springs {
            let (r, v) = between(spring, &self.trial);
            let towards = if r.norm() > NOTHING * self.extent() { r } else { v };
            let towards = if turns_round(spring) { towards } else { Vec2::zero() };
            self.trial.motion.towards.push(towards);
        }
    }

    /// A number that falls through zero where the side of a cam or a spring ends.
    pub fn seam_room(&self, index: usize) -> f64 {
        let cams = &self.model.plan.cams;
        if let Some(spring) = index.checked_sub(ENDS * cams.len()) {
            let towards = self.trial.motion.towards.get(spring).filter(|towards| **towards != Vec2::zero());
            let spring = &self.model.mechanism.springs[spring];
            return towards.map_or(1.0, |towards| towards.dot(between(spring, &self.trial).0));
        }
        let step = &cams[index / ENDS];
        let Some(Some(part)) = self.trial.motion.laws.get(step.index) else { return 1.0 };
        let phi = part.near(self.trial.cam_angle(step).0);
        if index.is_multiple_of(ENDS) { phi - part.from } else { part.to - phi }
    }

    /// Whether some side may end in the last step, of this length, at the end of which the last evaluation was.
    pub fn may_pass_seams(&self, length: f64) -> bool {
        let (_, before, _) = self.here();
        let cams = self.model.plan.cams.iter().enumerate().any(|(index, step)| {
            let [rate_0, rate_1] = [before, &self.trial].map(|state| state.cam_angle(step).1);
            let beyond = |end| self.seam_room(ENDS * index + end) <= 0.0;
            rate_0 * rate_1 <= 0.0 || beyond(0) || beyond(1)
        });
        let springs = self.model.mechanism.springs.iter().filter(|spring| turns_round(spring));
        cams || springs.into_iter().any(|spring| {
            let ((r_0, v_0), (r_1, v_1)) = (between(spring, before), between(spring, &self.trial));
            r_0.norm() + r_1.norm() <= FURTHER * length * v_0.norm().max(v_1.norm())
        })
    }

    /// Goes over to the other side, or takes what turns too often as it is.
    pub fn turn_seam(&mut self, index: usize, releases: bool) {
        let cams = &self.model.plan.cams;
        let Some(place) = index.checked_sub(ENDS * cams.len()) else {
            let step = &cams[index / ENDS];
            let law = &mut self.trial.motion.laws[step.index];
            let beside = |part| step.cam.program.beside(part, !index.is_multiple_of(ENDS));
            *law = if releases { None } else { law.as_ref().and_then(beside) };
            return;
        };
        let (r, v) = between(&self.model.mechanism.springs[place], &self.trial);
        let passes = r.norm() <= NOTHING * self.extent();
        let towards = &mut self.trial.motion.towards[place];
        *towards = match (releases, passes) {
            (true, _) => Vec2::zero(),
            (_, true) if v != Vec2::zero() => v,
            (_, true) => -*towards,
            (_, false) => r,
        };
    }
}
