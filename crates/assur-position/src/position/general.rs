//! Runs general groups: Newton's method from the state as it stands.

use super::body::BodyState;
use super::general_work::Workspace;
use super::state::{Branch, State};
use crate::group::IterationLog;
use crate::group::general::{
    self, Acceleration, Constraint, Geared, General, InitialGuess, Law, Pose, Velocity,
};
use crate::plan::{GeneralMotion, Settings};

/// Starts of the search for assemblies: many for few bodies, as `group::general::assemblies` advises.
pub const STARTS: usize = 400;

impl State {
    pub(super) fn general<const LEVEL: u8>(
        &mut self,
        branch: usize,
        problem: usize,
        group: &GeneralMotion,
        small: f64,
        seen: &mut impl IterationLog,
    ) {
        let Some(mut work) = self.scratch.motion_work.get_mut(problem).and_then(Option::take) else {
            self.motion.open.get_or_insert(branch);
            return;
        };
        self.set_drives(&mut work.equations, group);
        self.set_sides(&mut work.equations, group, self.branches[branch]);
        self.set_turns(&mut work.equations, group);
        self.read_poses(&group.bodies, &mut work.poses);
        match work.equations.position_seen(&mut work.poses, small, seen) {
            Ok(condition) => {
                self.motion.conditions[branch] = condition * work.equations.branch();
                self.motion.certificates[branch] = work.equations.certificate();
                self.write_poses(&group.bodies[..group.moving], &work.poses);
                self.keep_turns(&work.equations, group);
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
        work.equations.velocity(&work.poses, &mut work.velocities);
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
        for &(index, drive, ahead) in &group.driven {
            let input = self.motion.inputs[drive];
            equations.change(index, |constraint| match constraint {
                Constraint::Angle { angle, rate, second, .. } => {
                    *angle = ahead.map_or(input.place, |ahead| input.place.turned(ahead));
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

    /// The angles that laws of wheels count from: those where the bodies stand.
    fn set_turns(&mut self, equations: &mut General, group: &GeneralMotion) {
        for &(body, _, followed) in &group.turning {
            if followed {
                self.follow_turns(body);
            }
        }
        for term in equations.laws.iter_mut().flat_map(|law| &mut law.terms) {
            if let Geared::Turn { body, near, angle } = &mut term.of {
                let body = &self.motion.bodies[group.bodies[*body]];
                (*near, *angle) = (body.u, body.turned);
            }
        }
    }

    /// Keeps the angles of the group's bodies with their whole turns.
    fn keep_turns(&mut self, equations: &General, group: &GeneralMotion) {
        for term in equations.laws.iter().flat_map(|law| &law.terms) {
            let Geared::Turn { body, near, angle } = term.of else { continue };
            if body < group.moving {
                let slot = group.bodies[body];
                let body = &mut self.motion.bodies[slot];
                body.turned = angle + body.u.turned_back(near).angle();
                self.follow_turns(slot);
            }
        }
    }

    pub(super) fn read_poses(&self, slots: &[usize], poses: &mut [Pose]) {
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
}

/// Whether a general group can be moved within its pairs wherever it stands.
pub fn is_never_regular(state: &State, problem: usize, group: &GeneralMotion) -> bool {
    let Some(mut work) = state.scratch.motion_work.get(problem).cloned().flatten() else { return false };
    state.set_drives(&mut work.equations, group);
    state.read_poses(&group.bodies, &mut work.poses);
    general::is_never_regular(&mut work.equations, &work.poses)
}

/// Puts the bodies of a group to the start from which the search for its assemblies comes first to how they stand now.
pub fn to_start(
    state: &mut State,
    branch: usize,
    problem: usize,
    group: &GeneralMotion,
    (starts, meant): (usize, Option<&InitialGuess>),
) -> bool {
    let Some(mut work) = state.scratch.motion_work.get(problem).cloned().flatten() else { return false };
    state.set_drives(&mut work.equations, group);
    state.set_sides(&mut work.equations, group, state.branches[branch]);
    state.set_turns(&mut work.equations, group);
    state.read_poses(&group.bodies, &mut work.poses);
    let own = group.moving;
    let stands = work.poses[..own].to_vec();
    let rest = BodyState::rest();
    work.poses[..own].fill(Pose { p: rest.p, u: rest.u });
    let Some(poses) = general::start_of(&mut work.equations, &work.poses, starts, meant, &stands) else {
        return false;
    };
    state.write_poses(&group.bodies[..own], &poses);
    for &(body, member, _) in &group.turning {
        if member {
            state.motion.bodies[body].turned = state.motion.bodies[body].u.angle();
        }
    }
    true
}

/// All states in which a general group can be, from a given number of starts, and from where it is meant to stand.
pub fn assemblies(
    before: &State,
    branch: usize,
    problem: usize,
    group: &GeneralMotion,
    (starts, meant): (usize, Option<&InitialGuess>),
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
        state.set_turns(&mut work.equations, group);
        state.read_poses(&group.bodies, &mut work.poses);
        for poses in general::assemblies_near(&mut work.equations, &work.poses, starts, meant) {
            let mut found = state.clone();
            found.motion.open = None;
            found.write_poses(&group.bodies[..group.moving], &poses);
            for &(body, member, _) in &group.turning {
                if member {
                    found.motion.bodies[body].turned = found.motion.bodies[body].u.angle();
                }
            }
            // Newton's method from the answer itself: sets the condition figure
            found.general::<0>(branch, problem, group, Settings::FULL.newton, &mut ());
            if found.motion.open.is_none() {
                out.push(found);
            }
        }
    }
    out
}
