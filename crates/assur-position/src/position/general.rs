//! Runs general groups: Newton's method from the state as it stands, forces from the same Jacobian transposed.

use super::general_work::Workspace;
use super::state::{Branch, State};
use super::wrench::Reaction;
use crate::group::general::{
    self, Acceleration, Constraint, General, Law, Line, Load, Point, Pose, Velocity,
};
use crate::math::Vec2;
use crate::plan::{BalanceSystem, GeneralMotion, Guide, Settings, UnknownForce};

/// Starts of the search for assemblies: many for few bodies, as `group::general::assemblies` advises.
pub const STARTS: usize = 400;

impl State {
    pub(super) fn general<const LEVEL: u8>(
        &mut self,
        branch: usize,
        problem: usize,
        group: &GeneralMotion,
        small: f64,
    ) {
        let Some(mut work) = self.scratch.motion_work.get_mut(problem).and_then(Option::take) else {
            self.motion.open.get_or_insert(branch);
            return;
        };
        self.set_drives(&mut work.equations, group);
        self.set_sides(&mut work.equations, group, self.branches[branch]);
        self.read_poses(&group.bodies, &mut work.poses);
        match work.equations.position(&mut work.poses, small) {
            Ok(condition) => {
                self.motion.conditions[branch] = condition * work.equations.branch();
                self.motion.certificates[branch] = work.equations.certificate();
                self.write_poses(&group.bodies[..group.moving], &work.poses);
                if LEVEL > 0 {
                    self.general_rates::<LEVEL>(group, &mut work);
                }
            }
            Err(_) => {
                self.motion.open.get_or_insert(branch);
            }
        }
        self.scratch.motion_work[problem] = Some(work);
    }

    fn general_rates<const LEVEL: u8>(&mut self, group: &GeneralMotion, work: &mut Workspace) {
        for (&slot, velocity) in group.bodies.iter().zip(&mut work.velocities) {
            *velocity = Velocity { v: self.motion.bodies[slot].v, omega: self.motion.bodies[slot].omega };
        }
        work.equations.velocity(&mut work.velocities);
        if LEVEL > 1 {
            for (&slot, acceleration) in group.bodies.iter().zip(&mut work.accelerations) {
                *acceleration =
                    Acceleration { a: self.motion.bodies[slot].a, alpha: self.motion.bodies[slot].alpha };
            }
            work.equations.acceleration(&work.poses, &work.velocities, &mut work.accelerations);
        }
        for (i, &slot) in group.bodies[..group.moving].iter().enumerate() {
            let body = &mut self.motion.bodies[slot];
            body.v = work.velocities[i].v;
            body.omega = work.velocities[i].omega;
            if LEVEL > 1 {
                body.a = work.accelerations[i].a;
                body.alpha = work.accelerations[i].alpha;
            }
        }
    }

    fn set_drives(&self, equations: &mut General, group: &GeneralMotion) {
        for &(index, drive) in &group.driven {
            let input = self.motion.inputs[drive];
            equations.change(index, |constraint| match constraint {
                Constraint::Angle { angle, rate, second, .. } => {
                    *angle = input.place;
                    *rate = input.rate;
                    *second = input.acceleration;
                }
                Constraint::Coordinate { law, .. } => {
                    *law = Law { value: input.value, rate: input.rate, second: input.acceleration };
                }
                _ => {}
            });
        }
    }

    /// The side of round profiles: one bit of the branch's number each.
    fn set_sides(&self, equations: &mut General, group: &GeneralMotion, branch: Branch) {
        for (bit, &(index, radius)) in group.round.iter().enumerate() {
            equations.change(index, |constraint| {
                if let Constraint::Offset { law, .. } = constraint {
                    law.value = if branch.general_sides >> bit & 1 == 0 { radius } else { -radius };
                }
            });
        }
    }

    fn read_poses(&self, slots: &[usize], poses: &mut [Pose]) {
        for (&slot, pose) in slots.iter().zip(poses) {
            *pose = Pose { p: self.motion.bodies[slot].p, u: self.motion.bodies[slot].u };
        }
    }

    fn write_poses(&mut self, slots: &[usize], poses: &[Pose]) {
        for (&slot, pose) in slots.iter().zip(poses) {
            self.motion.bodies[slot].p = pose.p;
            self.motion.bodies[slot].u = pose.u;
        }
    }

    pub(super) fn force_general(&mut self, index: usize, system: &BalanceSystem) -> f64 {
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
        let condition = work.equations.factor(&work.poses).unwrap_or(0.0);
        if condition > 0.0 {
            work.equations.reactions(&work.loads, &mut work.lambda);
            self.keep_general(system, &work.lambda);
        }
        self.scratch.force_work[index] = Some(work);
        condition
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
    }
}

/// What acts on the slider, counted on the joint's body.
fn on_body(guide: &Guide, on_slider: f64) -> f64 {
    if guide.slider == guide.body { on_slider } else { -on_slider }
}

/// Whether a general group can be moved within its pairs wherever it stands.
pub fn is_never_regular(state: &State, problem: usize, group: &GeneralMotion) -> bool {
    let Some(mut work) = state.scratch.motion_work.get(problem).cloned().flatten() else { return false };
    state.set_drives(&mut work.equations, group);
    state.read_poses(&group.bodies, &mut work.poses);
    general::is_never_regular(&mut work.equations, &work.poses)
}

/// All states in which a general group can be, from a given number of starts.
pub fn assemblies(
    before: &State,
    branch: usize,
    problem: usize,
    group: &GeneralMotion,
    starts: usize,
) -> Vec<State> {
    let Some(work) = before.scratch.motion_work.get(problem).and_then(Option::as_ref) else {
        return Vec::new();
    };
    let mut out = Vec::new();
    for sides in 0..(1_u32 << group.round.len().min(8)) {
        let mut state = before.clone();
        state.branches[branch].general_sides = sides;
        let mut work = work.clone();
        state.set_drives(&mut work.equations, group);
        state.set_sides(&mut work.equations, group, state.branches[branch]);
        state.read_poses(&group.bodies, &mut work.poses);
        for poses in general::assemblies(&mut work.equations, &work.poses, starts) {
            let mut found = state.clone();
            found.motion.open = None;
            found.write_poses(&group.bodies[..group.moving], &poses);
            // Newton's method from the answer itself: sets the condition figure
            found.general::<0>(branch, problem, group, Settings::FULL.newton);
            if found.motion.open.is_none() {
                out.push(found);
            }
        }
    }
    out
}
