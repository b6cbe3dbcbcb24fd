//! Where the mechanism itself is not smooth: where a designed cam goes over to the next part of its law.
//!
//! A step takes cams as it takes loads: on the sides where it begins, also beyond. A cam has two numbers, which say how far
//! both ends of its part are.

use super::equations::Equations;

/// Ends of the part of a cam's law.
const ENDS: usize = 2;
impl Equations<'_, '_> {
    /// The numbers of all cams.
    pub fn seams(&self) -> usize {
        ENDS * (self.model.plan.cams.len() + self.model.plan.parting_cams.len())
    }

    /// Takes cams as they are, wherever that is.
    pub fn release_seams(&mut self) {
        self.trial.motion.laws.clear();
    }

    /// Takes all on the sides where they are in the state that is observed; where two parts meet, on the side to which the cam
    /// turns.
    pub fn take_seams(&mut self) {
        let plan = self.model.plan;
        if plan.cams.is_empty() && plan.parting_cams.is_empty() {
            return;
        }
        self.trial.motion.laws.resize(plan.cam_contacts, None);
        for step in plan.all_cams() {
            let (phi, rate) = self.trial.cam_angle(step);
            let sense = if rate == 0.0 { self.trial.cam_acceleration(step) } else { rate };
            self.trial.motion.laws[step.index] = step.cam.program.part_towards(phi, sense < 0.0);
        }
    }

    /// A number that falls through zero where the side of a cam ends.
    pub fn seam_room(&self, index: usize) -> f64 {
        let Some(step) = self.model.plan.all_cams().nth(index / ENDS) else { return 1.0 };
        let Some(Some(part)) = self.trial.motion.laws.get(step.index) else { return 1.0 };
        let phi = part.near(self.trial.cam_angle(step).0);
        if index.is_multiple_of(ENDS) { phi - part.from } else { part.to - phi }
    }

    /// Whether some side may end in the last step, at the end of which the last evaluation was.
    pub fn may_pass_seams(&self) -> bool {
        let (_, before, _) = self.here();
        self.model.plan.all_cams().enumerate().any(|(index, step)| {
            let [rate_0, rate_1] = [before, &self.trial].map(|state| state.cam_angle(step).1);
            let beyond = |end| self.seam_room(ENDS * index + end) <= 0.0;
            rate_0 * rate_1 <= 0.0 || beyond(0) || beyond(1)
        })
    }

    /// Goes over to the other side, or takes what turns too often as it is.
    pub fn turn_seam(&mut self, index: usize, releases: bool) {
        let Some(step) = self.model.plan.all_cams().nth(index / ENDS) else { return };
        let law = &mut self.trial.motion.laws[step.index];
        let beside = |part| step.cam.program.beside(part, !index.is_multiple_of(ENDS));
        *law = if releases { None } else { law.as_ref().and_then(beside) };
    }
}
