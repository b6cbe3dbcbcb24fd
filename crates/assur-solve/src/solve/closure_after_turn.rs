//! Whether a mechanism is after whole turns of its drive where it began: the last position of such a sweep is left out.

use super::note::Note;
use super::run::Run;
use super::track::Tracker;
use crate::math::Vec2;
use crate::position::{PoseRequest, extent};
use crate::structure::{BodyId, BodyOrigin, GroupKind};

/// Bodies are elsewhere if they are by this part of the mechanism's size, or by such an angle.
const ELSEWHERE: f64 = 1e-6;

/// Origins and directions of the bodies at the first position.
pub(super) type FirstPoses = Vec<(Vec2, Vec2)>;

pub(super) fn begin(tracker: &Tracker) -> FirstPoses {
    tracker.state.motion.bodies.iter().map(|b| (b.p, b.u)).collect()
}

impl Run<'_, '_> {
    /// The link that is farthest from where it began. Wheels that only turn are not looked at: with most ratios they never
    /// come back.
    pub(super) fn elsewhere(
        &mut self,
        begin: &FirstPoses,
        last: &Tracker,
        after: &PoseRequest,
    ) -> Option<Note> {
        let model = self.model;
        let mut tracker = last.clone();
        self.moved(&mut tracker, after).ok()?;
        let size = extent(model);
        let linked = model.structure.motion.iter().filter(|group| group.kind != GroupKind::Train);
        let links = linked.flat_map(|group| &group.bodies).filter_map(|&BodyId(slot)| {
            let BodyOrigin::Link(link) = model.structure.replaced.bodies[slot].origin else { return None };
            let ((p, u), now) = (begin.get(slot)?, &tracker.state.motion.bodies[slot]);
            let (off, turned) = ((now.p - *p).norm(), (now.u - *u).norm());
            (off > ELSEWHERE * size || turned > ELSEWHERE).then_some((link, off, u.turned_back(now.u)))
        });
        let far = |off: f64, turned: Vec2| off + size * turned.angle().abs();
        let (link, off, turned) = links.max_by(|a, b| far(a.1, a.2).total_cmp(&far(b.1, b.2)))?;
        Some(Note::Elsewhere { link, off, turned: turned.angle().abs(), drives: after.drives.clone() })
    }
}
