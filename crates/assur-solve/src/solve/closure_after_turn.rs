//! Whether a mechanism is after whole turns of its drive where it began: the last position of such a sweep is left out.

use super::note::{Note, WholeCycleRange};
use super::positions::Sweep;
use super::run::{Arrival, Run};
use super::track::Tracker;
use crate::math::Vec2;
use crate::model::LinkId;
use crate::position::{DriveValue, PoseRequest, extent};
use crate::structure::{BodyId, BodyOrigin, GroupKind};

/// Bodies are elsewhere if they are by this part of the mechanism's size, or by such an angle.
const ELSEWHERE: f64 = 1e-6;

/// Origins and directions of the bodies at the first position.
pub(super) type FirstPoses = Vec<(Vec2, Vec2)>;

pub(super) fn begin(tracker: &Tracker) -> FirstPoses {
    tracker.state.motion.bodies.iter().map(|b| (b.p, b.u)).collect()
}

/// The most sweeps that are followed to find out after how many the mechanism is back.
const SWEEPS: u32 = 60;
/// The most positions of them.
const POSITIONS: usize = 10_000;

/// A link that is not where it began: by how much its origin is elsewhere, and how far it is turned.
type Away = (LinkId, f64, Vec2);

impl Run<'_, '_> {
    /// Reports a mechanism that is not where it began.
    pub(super) fn elsewhere(&mut self, begin: &FirstPoses, last: &Tracker, sweep: &Sweep) -> Option<Note> {
        let after = sweep.after_turns()?;
        let mut tracker = last.clone();
        self.moved(&mut tracker, &after).ok()?;
        let (link, off, turned) = self.farthest(begin, &tracker)?;
        let whole = self.whole_cycle(begin, tracker, sweep, &after);
        Some(Note::Elsewhere { link, off, turned: turned.angle().abs(), drives: after.drives, whole })
    }

    /// The link that is farthest from where it began. Wheels that only turn are not looked at: with most ratios they never
    /// come back.
    fn farthest(&self, begin: &FirstPoses, tracker: &Tracker) -> Option<Away> {
        let model = self.model;
        let size = extent(model);
        let linked = model.structure.motion.iter().filter(|group| group.kind != GroupKind::Train);
        let links = linked.flat_map(|group| &group.bodies).filter_map(|&BodyId(slot)| {
            let BodyOrigin::Link(link) = model.structure.replaced.bodies[slot].origin else { return None };
            let ((p, u), now) = (begin.get(slot)?, &tracker.state.motion.bodies[slot]);
            let (off, turned) = ((now.p - *p).norm(), (now.u - *u).norm());
            (off > ELSEWHERE * size || turned > ELSEWHERE).then_some((link, off, u.turned_back(now.u)))
        });
        let far = |off: f64, turned: Vec2| off + size * turned.angle().abs();
        links.max_by(|a, b| far(a.1, a.2).total_cmp(&far(b.1, b.2)))
    }

    /// The range of the one swept drive after which all links are back, found by going on in the same steps.
    #[allow(clippy::cast_possible_truncation)] // `SWEEPS` bounds the count
    fn whole_cycle(
        &mut self,
        begin: &FirstPoses,
        mut tracker: Tracker,
        sweep: &Sweep,
        after: &PoseRequest,
    ) -> Option<WholeCycleRange> {
        let first = sweep.values(0);
        let (drive, from, by) = moved_by(&first, &after.drives)?;
        for sweeps in 1..SWEEPS.min((POSITIONS / sweep.len()) as u32) {
            for step in 1..=sweep.len() {
                let mut pose = if step < sweep.len() { sweep.at(step) } else { after.clone() };
                if let DriveValue::Scalar(x) = &mut pose.drives[drive] {
                    *x += by * f64::from(sweeps);
                }
                let Ok(Arrival::Followed(_)) = self.moved(&mut tracker, &pose) else { return None };
            }
            if self.farthest(begin, &tracker).is_none() {
                let count = sweeps + 1;
                return Some(WholeCycleRange {
                    from,
                    to: from + by * f64::from(count),
                    steps: sweep.len() * count as usize,
                });
            }
        }
        None
    }
}

/// The one drive that moves, its first value and by how much it has moved.
fn moved_by(first: &[DriveValue], after: &[DriveValue]) -> Option<(usize, f64, f64)> {
    let moves = |(i, pair): (usize, (&DriveValue, &DriveValue))| match pair {
        (DriveValue::Scalar(from), DriveValue::Scalar(to)) if from != to => Some((i, *from, to - from)),
        _ => None,
    };
    let all = first.iter().zip(after).enumerate().filter_map(moves).collect::<Vec<_>>();
    <[_; 1]>::try_from(all).ok().map(|[one]| one)
}
