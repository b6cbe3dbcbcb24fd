//! Forces of trains: multipliers of their laws, efforts, reactions of their members.

use super::consistent::Consistent;
use super::losses::Losses;
use super::state::State;
use super::train_work::TrainWork;
use super::wrench::LawForce;
use crate::math::Vec2;
use crate::plan::{Plan, TrainEffort, TrainForces, TrainSupport};

impl State {
    /// Finds the multipliers and efforts of a train from the loads on its members, and the reactions of their pairs.
    pub(super) fn force_train(&mut self, plan: &Plan, index: usize, losses: Losses) -> f64 {
        let train = &plan.train_forces[index];
        if train.inverse.is_empty() {
            return 0.0;
        }
        let Some(mut work) = self.scratch.train_work.get_mut(index).and_then(Option::take) else {
            return 0.0;
        };
        self.train_loads(train, &mut work);
        let n = train.members.len();
        for i in 0..n {
            let row = &train.inverse[i * n..][..n];
            work.found[i] = -row.iter().zip(&work.loads).map(|(a, q)| a * q).sum::<f64>();
        }
        if losses != Losses::InSenses {
            for &law in &train.laws {
                self.forces.law_forces[law] = LawForce { sides: [1.0, 1.0], ..LawForce::default() };
            }
        }
        let consistent = match losses {
            Losses::None => Consistent::One,
            Losses::Found => self.with_losses(plan, train, &mut work),
            Losses::InSenses => self.in_senses(plan, train, &mut work),
        };
        for (unknown, &law) in work.found.iter().zip(&train.laws) {
            self.forces.law_forces[law].multiplier = *unknown;
        }
        self.train_reactions(plan, train, &work);
        self.scratch.train_work[index] = Some(work);
        if consistent != Consistent::One {
            self.forces.consistent = consistent;
        }
        if matches!(consistent, Consistent::None | Consistent::Undecided) { 0.0 } else { 1.0 }
    }

    /// Loads on the members' coordinates: moments about their hinges, forces along their guides.
    fn train_loads(&self, train: &TrainForces, work: &mut TrainWork) {
        work.carried.fill((Vec2::zero(), 0.0));
        for (i, member) in train.members.iter().enumerate().rev() {
            let (more, moment) = work.carried[i];
            match member {
                TrainSupport::Turn(hinge, carrier) => {
                    let body = &self.motion.bodies[hinge.body];
                    let (p, force, about) = self.load_at(hinge.body, &hinge.pin);
                    let lever = (body.p - p).cross(more);
                    work.loads[i] = about + moment + lever;
                    if let Some(carrier) = *carrier {
                        work.carried[carrier].0 += force + more;
                        if let TrainSupport::Turn(base, _) = &train.members[carrier] {
                            // reduced to the origin of the carrier
                            let r = p - self.motion.bodies[base.body].p;
                            work.carried[carrier].1 += r.cross(force + more);
                        }
                    }
                }
                TrainSupport::Shift(guide, sign) => {
                    let force = self.forces.wrenches[guide.body].force + more;
                    work.loads[i] = sign * force.dot(self.direction(guide));
                }
            }
        }
    }

    /// Solves the system with the sides as they are set.
    pub(super) fn unknowns(&self, plan: &Plan, train: &TrainForces, work: &mut TrainWork) -> bool {
        let n = train.members.len();
        for (i, row) in train.matrix.chunks_exact(n).enumerate() {
            work.system.set_row(i, row.iter().copied());
        }
        for (column, &slot) in train.laws.iter().enumerate() {
            let law = &plan.laws[slot];
            if law.efficiency.is_none() {
                continue;
            }
            let sides = self.forces.law_forces[slot].sides;
            for (i, member) in train.members.iter().enumerate() {
                if let Some(value) = member.coefficient(law, sides) {
                    *work.system.at_mut(i, column) = value;
                }
            }
        }
        let regular = work.system.factor();
        if regular {
            work.trial.iter_mut().zip(&work.loads).for_each(|(x, load)| *x = -load);
            work.system.solve(&mut work.trial);
        }
        regular
    }

    /// Puts multipliers and efforts on the bodies, and finds what holds the members.
    fn train_reactions(&mut self, plan: &Plan, train: &TrainForces, work: &TrainWork) {
        for &slot in &train.laws {
            let law = &plan.laws[slot];
            let mut wrenches = std::mem::take(&mut self.forces.wrenches);
            self.forces_of_law(law, slot, &mut |body, p, force, couple| {
                let r = p - self.motion.bodies[body].p;
                wrenches[body].force += force;
                wrenches[body].moment += r.cross(force) + couple;
            });
            self.forces.wrenches = wrenches;
        }
        for (effort, value) in train.efforts.iter().zip(&work.found[train.laws.len()..]) {
            match effort {
                TrainEffort::Torque(slot, body, base) => {
                    self.forces.efforts[*slot] = *value;
                    self.forces.wrenches[*body].moment += value;
                    self.forces.wrenches[*base].moment -= value;
                }
                TrainEffort::Along(slot, guide) => {
                    self.forces.efforts[*slot] = *value;
                    let (p, force) = (
                        self.motion.bodies[guide.slider].position(guide.point),
                        self.direction(guide) * *value,
                    );
                    let other = if guide.slider == guide.body { guide.base } else { guide.body };
                    self.carry(other, p, force);
                    self.carry(guide.slider, p, -force);
                }
            }
        }
        for member in train.members.iter().rev() {
            match member {
                TrainSupport::Turn(hinge, _) => {
                    let (p, force, _) = self.load_at(hinge.body, &hinge.pin);
                    self.hinge_reaction(hinge, p, -force);
                }
                TrainSupport::Shift(guide, _) => {
                    let p = self.motion.bodies[guide.slider].position(guide.point);
                    let d = self.direction(guide);
                    let (force, moment) = self.load_about(guide.body, p);
                    self.carried_way(guide, p, d.perp() * -force.dot(d.perp()), -moment);
                }
            }
        }
    }
}
