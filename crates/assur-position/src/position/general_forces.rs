//! Forces of general groups, from the Jacobian of their constraints transposed.
//!
//! Laws of wheels act in these equations as couples on the wheels' links, which gives their multipliers and all efforts: the
//! forces between teeth do no work where the wheels roll. Where the pitch point is known, what the forces there add to the
//! couples is put on the links as a load, and the reactions are found again.

use super::consistent::Consistent;
use super::general_work::Workspace;
use super::losses::Losses;
use super::state::State;
use super::wrench::{LawForce, Reaction};
use crate::group::general::{Constraint, Line, Load, Point};
use crate::math::Vec2;
use crate::plan::{BalanceSystem, Guide, LawSite, Plan, PlannedLaw, SharedPlace, UnknownForce};

impl State {
    pub(super) fn force_general(&mut self, plan: &Plan, index: usize, losses: Losses) -> f64 {
        let system = &plan.balance_systems[index];
        let Some(mut work) = self.scratch.force_work.get_mut(index).and_then(Option::take) else {
            return 0.0;
        };
        self.read_poses(&system.bodies, &mut work.poses);
        for &(constraint, effort) in &system.lines {
            let (p, n) = self.forces.lines[effort];
            let bodies = &self.motion.bodies;
            work.equations.change(constraint, |c| {
                if let Constraint::Coordinate { point, line, .. } = c {
                    let body = &bodies[system.bodies[point.body]];
                    *point = Point { body: point.body, r: (p - body.p).turned_back(body.u) };
                    *line = Line { body: line.body, r: p, d: n };
                }
            });
        }
        for &constraint in &system.torques {
            let poses = &work.poses;
            work.equations.change(constraint, |c| {
                if let Constraint::Angle { a, b, angle, .. } = c {
                    *angle = poses[*b].u.turned_back(poses[*a].u);
                }
            });
        }
        for (&slot, load) in system.bodies.iter().zip(&mut work.loads) {
            *load = Load { F: self.forces.wrenches[slot].force, M: self.forces.wrenches[slot].moment };
        }
        self.set_columns(plan, system, &mut work, losses == Losses::InSenses);
        let mut condition = work.equations.factor(&work.poses).unwrap_or(0.0);
        if condition > 0.0 {
            work.equations.reactions(&work.loads, &mut work.lambda);
            let consistent = self.general_laws(plan, system, &mut work, losses);
            self.keep_general(system, &work.lambda);
            if consistent != Consistent::One {
                self.forces.consistent = consistent;
                if !matches!(consistent, Consistent::Several { .. }) {
                    condition = 0.0;
                }
            }
        }
        self.scratch.force_work[index] = Some(work);
        condition
    }

    /// Keeps the multipliers of the laws of wheels, and puts the forces between the teeth in the place of their couples.
    fn general_laws(
        &mut self,
        plan: &Plan,
        system: &BalanceSystem,
        work: &mut Workspace,
        losses: Losses,
    ) -> Consistent {
        if system.laws.is_empty() {
            return Consistent::One;
        }
        if losses != Losses::InSenses {
            for &slot in &system.laws {
                self.forces.law_forces[slot] = LawForce { sides: [1.0, 1.0], ..LawForce::default() };
            }
        }
        let found = losses == Losses::Found;
        let consistent = if found { self.general_losses(plan, system, work) } else { Consistent::One };
        let first = work.lambda.len() - system.laws.len();
        for (&slot, multiplier) in system.laws.iter().zip(&work.lambda[first..]) {
            self.forces.law_forces[slot].multiplier = *multiplier;
        }
        let mut meets = false;
        for &slot in &system.laws {
            let law = &plan.laws[slot];
            meets |= law.meeting.is_some();
            self.act_of_law(system, work, law, slot);
        }
        if meets {
            work.equations.reactions(&work.loads, &mut work.lambda);
        }
        consistent
    }

    /// Puts the forces of a law on the bodies outside the group, and in the group what they are more than couples.
    fn act_of_law(&mut self, system: &BalanceSystem, work: &mut Workspace, law: &PlannedLaw, slot: usize) {
        let place = |body: usize| system.bodies[..system.moving].iter().position(|b| *b == body);
        let mut wrenches = std::mem::take(&mut self.forces.wrenches);
        self.forces_of_law(law, slot, &mut |body, p, force, couple| {
            let moment = (p - self.motion.bodies[body].p).cross(force) + couple;
            match place(body) {
                None => {
                    wrenches[body].force += force;
                    wrenches[body].moment += moment;
                }
                Some(place) if law.meeting.is_some() => {
                    work.loads[place].F += force;
                    work.loads[place].M += moment;
                }
                Some(_) => {}
            }
        });
        self.forces.wrenches = wrenches;
        if law.meeting.is_none() {
            return;
        }
        for (term, (site, _)) in law.terms.iter().enumerate() {
            if let LawSite::Turn(body) = site
                && let Some(place) = place(*body)
            {
                work.loads[place].M -= self.law_force(law, slot, term);
            }
        }
    }

    /// Keeps reactions and efforts and passes them on to bodies outside the group.
    fn keep_general(&mut self, system: &BalanceSystem, lambda: &[f64]) {
        let inside = |body: usize| system.bodies[..system.moving].contains(&body);
        let mut at = 0;
        for unknown in &system.unknowns {
            let x = lambda[at];
            match unknown {
                UnknownForce::Hinge { slot, hinge } => {
                    let force = Vec2::new(x, lambda[at + 1]);
                    at += 1;
                    self.forces.reactions[*slot] = Reaction { force, couple: 0.0 };
                    if !inside(hinge.base) {
                        let p = self.motion.bodies[hinge.body].pin(&hinge.pin).0;
                        self.carry(hinge.base, p, force);
                    }
                }
                UnknownForce::Couple(guide) => {
                    let couple = on_body(guide, x);
                    self.forces.reactions[guide.slot] = Reaction { force: Vec2::zero(), couple };
                    if !inside(guide.base) {
                        self.forces.wrenches[guide.base].moment -= couple;
                    }
                }
                UnknownForce::Normal(guide) => {
                    let force = self.direction(guide).perp() * on_body(guide, x);
                    // a couple kept stands before its normal force; without one there is none
                    let couple = self.forces.reactions[guide.slot].couple;
                    self.forces.reactions[guide.slot] = Reaction { force, couple };
                    if !inside(guide.base) {
                        let p = self.motion.bodies[guide.slider].position(guide.point);
                        self.carry(guide.base, p, force);
                    }
                }
                UnknownForce::Torque { effort, body, base } => {
                    self.forces.efforts[*effort] = x;
                    for (other, moment) in [(*base, -x), (*body, x)] {
                        if !inside(other) {
                            self.forces.wrenches[other].moment += moment;
                        }
                    }
                }
                UnknownForce::Along { effort, guide } => {
                    self.forces.efforts[*effort] = x;
                    let force = self.direction(guide) * on_body(guide, x);
                    if !inside(guide.base) {
                        let p = self.motion.bodies[guide.slider].position(guide.point);
                        self.carry(guide.base, p, force);
                    }
                }
                UnknownForce::Line(effort) => self.forces.efforts[*effort] = x,
                UnknownForce::Passive => {}
            }
            at += 1;
        }
        for ((effort, places), x) in system.shared.iter().zip(&lambda[at..]) {
            self.forces.efforts[*effort] = *x;
            places.iter().for_each(|place| self.act_outside(place, *x, inside));
        }
    }

    /// Passes an effort at one of its places on to bodies outside the group.
    fn act_outside(&mut self, place: &SharedPlace, x: f64, inside: impl Fn(usize) -> bool) {
        match place {
            SharedPlace::Torque(body, base) => {
                for (other, moment) in [(*base, -x), (*body, x)] {
                    if !inside(other) {
                        self.forces.wrenches[other].moment += moment;
                    }
                }
            }
            SharedPlace::Along(guide) => {
                let p = self.motion.bodies[guide.slider].position(guide.point);
                let force = self.direction(guide) * x;
                for (other, on_other) in [(guide.base, force), (guide.slider, -force)] {
                    if !inside(other) {
                        self.carry(other, p, on_other);
                    }
                }
            }
        }
    }
}

/// What acts on the slider, counted on the joint's body.
fn on_body(guide: &Guide, on_slider: f64) -> f64 {
    if guide.slider == guide.body { on_slider } else { -on_slider }
}
