//! Friction where the quick iteration finds no motion: the laws of all pairs of the mechanism at once. First the solution
//! without friction is followed while all coefficients grow; where it ends, all signs of normal forces and all directions of
//! hinge forces are searched. The mechanism is locked only where none is consistent.

use super::consistent::Consistent;
use super::state::State;
use super::wrench::Wrench;
use crate::math::{AbsLinearSystem, Part, Vec2};
use crate::plan::{FrictionLaw, Plan};

impl State {
    /// Finds forces that satisfy all laws from the loads as they were before any reaction, or leaves the state locked.
    #[cold]
    #[inline(never)]
    pub(super) fn search_friction(&mut self, plan: &Plan) {
        let loads = std::mem::take(&mut self.scratch.loads_before);
        let moving: Vec<usize> = (0..plan.friction.len()).filter(|e| self.forces.senses[*e] != 0.0).collect();
        let sensed = self.sensed(plan);
        let (taken, consistent) = if sensed.is_empty() {
            let laws = self.friction_laws(plan, &moving, &loads);
            match AbsLinearSystem::follow(|part| Some(laws.scaled(part))) {
                Some(efforts) => (Some(efforts), Consistent::One),
                None => self.least_loss(plan, &moving, &laws),
            }
        } else {
            self.search_beside_wheels(plan, &sensed, &moving, &loads)
        };
        self.forces.consistent = consistent;
        self.forces.locked = taken.is_none();
        self.rub_all(plan, &moving, taken.as_deref().unwrap_or_default(), &loads);
        self.scratch.in_senses = false;
        self.scratch.loads_before = loads;
    }

    /// The forces with these efforts of friction.
    pub(super) fn rub_all(&mut self, plan: &Plan, moving: &[usize], efforts: &[f64], loads: &[Wrench]) {
        self.forces.frictions.fill(0.0);
        self.forces.wrenches.copy_from_slice(loads);
        for (&element, &effort) in moving.iter().zip(efforts) {
            self.forces.frictions[element] = effort;
            self.apply_rub(&plan.friction[element], effort);
        }
        self.run_forces_without_friction(plan);
    }

    /// Of all solutions the one that loses the least power.
    fn least_loss(
        &mut self,
        plan: &Plan,
        moving: &[usize],
        laws: &AbsLinearSystem,
    ) -> (Option<Vec<f64>>, Consistent) {
        let all = laws.solutions(self.scratch.searched.left());
        self.scratch.searched.add(all.work);
        let consistent = match all.found.len() {
            0 if all.complete => Consistent::None,
            0 => Consistent::Undecided,
            1 => Consistent::One,
            count => Consistent::Several { count, followed: false },
        };
        let loss = |efforts: &Vec<f64>| -> f64 {
            let powers = moving.iter().zip(efforts);
            powers.map(|(e, x)| (x * self.sliding_speed(&plan.friction[*e])).abs()).sum()
        };
        let least = all.found.into_iter().min_by(|a, b| loss(a).total_cmp(&loss(b)));
        (least, consistent)
    }

    /// The laws of the elements that slide or turn: what presses, from the loads and from a unit of each friction.
    pub(super) fn friction_laws(
        &mut self,
        plan: &Plan,
        moving: &[usize],
        loads: &[Wrench],
    ) -> AbsLinearSystem {
        let mut measured = vec![vec![Vec2::zero(); moving.len() + 1]; moving.len()];
        for column in 0..=moving.len() {
            if column == 0 {
                self.forces.wrenches.copy_from_slice(loads);
            } else {
                self.forces.wrenches.fill(Wrench::default());
                self.apply_rub(&plan.friction[moving[column - 1]], 1.0);
            }
            self.run_forces_without_friction(plan);
            for (row, &element) in measured.iter_mut().zip(moving) {
                row[column] = self.measured(plan, &plan.friction[element]);
            }
        }
        let mut laws = AbsLinearSystem { orientation: 1.0, weights: Vec::new(), parts: Vec::new() };
        for (row, (&index, measured)) in moving.iter().zip(&measured).enumerate() {
            let element = &plan.friction[index];
            laws.weights.push(self.forces.senses[index] * element.kind.factor());
            let mut part = |plane: bool, of: &dyn Fn(Vec2) -> Vec2| {
                let slopes = measured[1..].iter().map(|v| of(*v)).collect();
                laws.parts.push(Part { row, plane, constant: of(measured[0]), slopes });
            };
            let number = |x: f64| Vec2::new(x, 0.0);
            match &element.kind {
                FrictionLaw::Circle { .. } | FrictionLaw::Rolling { .. } => part(true, &|v| v),
                FrictionLaw::Guide { .. } => part(false, &|v| number(v.x)),
                FrictionLaw::BothEnds { .. } => {
                    part(false, &|v| number(v.x));
                    part(false, &|v| number(v.y));
                }
                FrictionLaw::Contact { .. } => {
                    let along = self.friction_line(element).map_or(Vec2::new(1.0, 0.0), |line| line.1);
                    part(false, &|v| number(along.cross(v)));
                }
            }
        }
        laws
    }
}
