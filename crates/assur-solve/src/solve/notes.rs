//! Collects what deserves a note over all positions, each kind once.

use super::failure::{Cause, GroupId};
use super::note::{Closing, Gap, Loss, Note, Pull, Uncertified};
use super::track::Switch;
use crate::model::PairId;
use crate::position::{Consistent, DriveValue, Model, PoseRequest};

/// With fewer digits left a note is made: σ = 1e-3 for accelerations, 5e-5 for velocities and forces.
const FEW_DIGITS: f64 = 7.0;
/// Digits that forces of inertia lose beside: 16 ε/σ³.
const GATHERED: f64 = 1.2;

/// More switches are counted, not kept.
const MOST_SWITCHES: usize = 1000;
/// The same for gaps.
const MOST_GAPS: usize = 100;

/// The first position of a kind, and how many more there are.
type First<T> = Option<(T, usize)>;

/// The notes of a run.
#[derive(Debug, Default)]
pub(super) struct Notes {
    switches: Vec<Note>,
    /// Switches that are not kept.
    more_switches: usize,
    gaps: Vec<Gap>,
    /// Gaps that are not kept.
    more_gaps: usize,
    in_gap: bool,
    /// The fewest digits left, with their note.
    fewest: Option<(f64, Note)>,
    pulls: Vec<Pull>,
    slack: Vec<Pull>,
    /// Belts and clutches that slip.
    slips: Vec<Pull>,
    locking: First<PoseRequest>,
    /// Several states of the forces: their number, and whether the one reported was followed.
    several: First<(usize, bool, PoseRequest)>,
    /// The greatest figure h beyond 1/2.
    uncertified: Option<Uncertified>,
}

impl Notes {
    /// Whether there are none.
    pub(super) const fn is_empty(&self) -> bool {
        self.switches.is_empty()
            && self.gaps.is_empty()
            && self.fewest.is_none()
            && self.pulls.is_empty()
            && self.slack.is_empty()
            && self.slips.is_empty()
            && self.locking.is_none()
            && self.several.is_none()
            && self.uncertified.is_none()
    }

    pub(super) const fn in_gap(&self) -> bool {
        self.in_gap
    }

    pub(super) fn gap_begins(&mut self, from: Option<Vec<DriveValue>>) {
        self.in_gap = true;
        if self.gaps.len() < MOST_GAPS {
            self.gaps.push(Gap { from, to: None });
        } else {
            self.more_gaps += 1;
        }
    }

    pub(super) fn gap_ends(&mut self, to: Vec<DriveValue>) {
        self.in_gap = false;
        if let Some(gap) = self.gaps.last_mut().filter(|_| self.more_gaps == 0) {
            gap.to = Some(to);
        }
    }

    pub(super) fn switched(&mut self, switch: Switch, from: &str, to: &str) {
        if self.switches.len() == MOST_SWITCHES {
            self.more_switches += 1;
            return;
        }
        let Switch { group, at } = switch;
        self.switches.push(Note::Switched { group, at, from: from.to_owned(), to: to.to_owned() });
    }

    /// The condition figure σ of a group; the error of what is asked of it grows as ε over a power of σ.
    pub(super) fn condition(
        &mut self,
        model: &Model<'_>,
        group: GroupId,
        (condition, loss): (f64, Loss),
        pose: &PoseRequest,
    ) {
        let power = match loss {
            Loss::ForcesNearLocking => 1.0,
            Loss::Velocities | Loss::Forces => 2.0,
            Loss::Accelerations => 3.0,
        };
        // forces of inertia add up what the accelerations of several links lose
        let gathers = loss == Loss::Accelerations && model.plan.effects.inertia;
        let gathered = if gathers { GATHERED } else { 0.0 };
        let left = power * libm::log10(condition.max(f64::MIN_POSITIVE)) - libm::log10(f64::EPSILON);
        let digits = left - gathered;
        // what is no number is reported by itself
        if condition.is_nan() || digits >= FEW_DIGITS || self.fewest.as_ref().is_some_and(|f| f.0 <= digits) {
            return;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 0 and 7
        let left = digits.clamp(0.0, FEW_DIGITS) as u32;
        let pose = pose.clone();
        self.fewest = Some((digits, Note::IllConditioned { pose, group, condition, digits: left, loss }));
    }

    /// The figure h of Newton and Kantorovich of a group of motion that was solved by iteration.
    pub(super) fn certificate(&mut self, group: usize, h: f64, sigma: f64, pose: &PoseRequest) {
        if h <= 0.5 {
            return;
        }
        let poses = self.uncertified.as_ref().map_or(0, |worst| worst.poses) + 1;
        if let Some(worst) = self.uncertified.as_mut().filter(|worst| h <= worst.h) {
            worst.poses = poses;
            return;
        }
        self.uncertified = Some(Uncertified { pose: pose.clone(), group, h, sigma, poses });
    }

    /// A contact that pulls with this normal force.
    pub(super) fn pulls(&mut self, pair: PairId, normal: f64, pose: &PoseRequest) {
        add(&mut self.pulls, pair, normal, pose);
    }

    /// A rope that pushes with this tension.
    pub(super) fn pushes(&mut self, pair: PairId, tension: f64, pose: &PoseRequest) {
        add(&mut self.slack, pair, tension, pose);
    }

    /// A belt or a clutch that must transmit this force or torque, which is more than it can.
    pub(super) fn slips(&mut self, pair: PairId, wanted: f64, pose: &PoseRequest) {
        add(&mut self.slips, pair, -wanted, pose);
    }

    /// The load cannot drive the mechanism.
    pub(super) fn self_locking(&mut self, pose: &PoseRequest) {
        match &mut self.locking {
            Some((_, more)) => *more += 1,
            None => self.locking = Some((pose.clone(), 0)),
        }
    }

    /// What the search for consistent forces of a position came to.
    pub(super) fn consistent(
        &mut self,
        model: &Model<'_>,
        found: Consistent,
        pose: &PoseRequest,
    ) -> Result<(), Cause> {
        match found {
            Consistent::Several { count, followed } => {
                match &mut self.several {
                    Some((_, more)) => *more += 1,
                    None => self.several = Some(((count, followed, pose.clone()), 0)),
                }
                Ok(())
            }
            Consistent::Undecided => Err(Cause::Undecided),
            Consistent::None if !model.plan.effects.friction => Err(Cause::Blocked),
            Consistent::None | Consistent::One => Ok(()),
        }
    }

    /// The notes, and how many there are more.
    pub(super) fn into_notes(self, closing: Closing) -> (Vec<Note>, usize) {
        let mut notes = self.switches;
        notes.extend(self.locking.map(|(pose, more)| Note::SelfLocking { pose, more }));
        notes.extend(self.several.map(|((count, followed, pose), more)| Note::SeveralBalances {
            count,
            followed,
            pose,
            more,
        }));
        notes.extend(self.slack.into_iter().map(Note::RopePushes));
        notes.extend(self.slips.into_iter().map(Note::Slips));
        notes.extend(self.pulls.into_iter().map(Note::ContactPulls));
        // where the assembly is not chosen yet, nothing is known of what closes
        if !self.gaps.is_empty() && !closing.ambiguous {
            notes.push(Note::PartialSweep { closing, gaps: self.gaps, more: self.more_gaps });
        }
        notes.extend(self.fewest.map(|f| f.1));
        notes.extend(self.uncertified.map(Note::NotCertified));
        (notes, self.more_switches)
    }
}

/// Counts a position, and keeps it where the force is the least so far.
fn add(pulls: &mut Vec<Pull>, pair: PairId, force: f64, pose: &PoseRequest) {
    match pulls.iter_mut().find(|p| p.pair == pair) {
        Some(pull) => {
            pull.poses += 1;
            if force < pull.least {
                (pull.least, pull.pose) = (force, pose.clone());
            }
        }
        None => pulls.push(Pull { pair, least: force, pose: pose.clone(), poses: 1 }),
    }
}
