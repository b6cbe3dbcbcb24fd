//! Positions of a trajectory, instant by instant.

use super::drives::{Instant, prescribed};
use super::records::{BodyPose, Origin};
use super::trajectory::Trajectory;
use crate::model::{DriveTarget, Positions};
use crate::position::{DriveInput, DriveValue, Model, PoseOrigin, PoseRequest};
use crate::solve::failure::Failure;
use crate::solve::solution::Pose;
use crate::solve::sweep::Following;

impl Following<'_, '_> {
    /// The next instant of the trajectory that is wanted, then the instant at which it ends early.
    pub(in crate::solve) fn next_instant(&mut self) -> Option<Result<Pose, Failure>> {
        let index = self.next;
        let mut trajectory = self.trajectory.take()?;
        let (reached, end) = (trajectory.records.count, trajectory.report.end);
        let pose = if index < reached {
            Some(Ok(self.solved_instant(index, &mut trajectory)))
        } else {
            let ended = trajectory.ended.clone().filter(|_| index == reached);
            ended.map(|ended| if index == 0 { Err(ended) } else { Ok(self.ended(index, end, ended)) })
        };
        self.trajectory = Some(trajectory);
        self.next += 1;
        self.run.closing.swept += usize::from(pose.is_some());
        pose
    }

    /// The instant at which the motion ends early.
    fn ended(&mut self, index: usize, end: f64, why: Failure) -> Pose {
        let drives = vec![DriveValue::None; self.run.model.mechanism.drives.len()];
        let name = self.run.model.mechanism.instant_text(end);
        self.run.posed(PoseRequest { name, origin: PoseOrigin::Sweep(index), drives }, Err(why))
    }

    fn solved_instant(&mut self, index: usize, trajectory: &mut Trajectory) -> Pose {
        let (wanted, instant) = trajectory.wanted(self.run.model, index);
        self.run.instant = Some(instant);
        if let Some(stand) = trajectory.records.bodies_at(index) {
            BodyPose::put(stand, &mut trajectory.start.motion.bodies);
        }
        let assemblies = trajectory.records.assemblies[index].as_deref().unwrap_or(&trajectory.assemblies);
        trajectory.start.branches.copy_from_slice(assemblies);
        let given = trajectory.records.given[index].as_deref();
        let outcome =
            self.run.solved_from(&trajectory.start, trajectory.records.angles(index), &wanted, given);
        self.run.posed(wanted, outcome)
    }
}

impl Trajectory {
    /// How many instants are printed.
    pub fn printed(&self) -> usize {
        self.records.origins.iter().filter(|origin| **origin == Origin::Printed).count()
    }

    /// The position at an instant, and what the drives say there.
    fn wanted(&mut self, model: &Model<'_>, index: usize) -> (PoseRequest, Instant) {
        let (time, n) = (self.records.times[index], self.records.order);
        let elapsed = time - self.from;
        let mut drives = Vec::with_capacity(self.first.len());
        let mut rates = Vec::with_capacity(self.first.len());
        let mut free = 0;
        for (drive, first) in model.mechanism.drives.iter().zip(&self.first) {
            let said = if drive.free {
                let (state, accelerations) = (self.records.state(index), self.records.accelerations(index));
                free += 1;
                let (value, rate) = (state[free - 1], state[n + free - 1]);
                DriveInput { value, rate, acceleration: accelerations[free - 1], ..DriveInput::default() }
            } else {
                prescribed(drive, first, (time, elapsed), &[])
            };
            drives.push(match (&drive.positions, drive.target) {
                (Positions::None, _) => DriveValue::None,
                (_, DriveTarget::Point(..)) => DriveValue::Point(said.place),
                _ => DriveValue::Scalar(said.value),
            });
            rates.push(said);
        }
        let name = model.mechanism.instant_text(time);
        let origin = match self.records.origins[index] {
            Origin::Printed => {
                self.handed_out += 1;
                PoseOrigin::Sweep(self.handed_out - 1)
            }
            Origin::Expected(expect) => PoseOrigin::Expected(expect),
        };
        (
            PoseRequest { name, origin, drives },
            Instant {
                time,
                rates,
                work: self.records.work.get(index).copied().unwrap_or(f64::NAN),
                works: self.records.works(index).to_vec(),
                bearing: self.records.bearings[index].clone(),
                spread: self.records.spreads[index].clone(),
                impulses: self.records.impulses(index).to_vec(),
                sides: self.start.motion.sides.clone(),
            },
        )
    }
}
