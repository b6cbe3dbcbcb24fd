//! Whether a mechanism is after whole turns of its drive where it began: the last position of such a sweep is left out.

use super::note::{Note, WholeCycleRange};
use super::positions::Sweep;
use super::run::{Arrival, Run};
use super::track::Tracker;
use crate::answer::{Measured, PoseAnswers, Sizes};
use crate::math::Vec2;
use crate::model::{Expr, LinkId, Query, Value};
use crate::plan::LoadStep;
use crate::position::{BodyState, DriveValue, PoseRequest, extent};
use crate::structure::{BodyId, BodyOrigin, GroupKind};

/// Bodies are elsewhere if they are by this part of the mechanism's size, or by such an angle.
const ELSEWHERE: f64 = 1e-6;
/// A little behind a position, in steps of the sweep.
const BEHIND: f64 = 0.381_966;
/// Loads differ by more than this part of their terms.
const WOUND: f64 = 1e-9;

/// Origins and directions of the bodies at the first position.
type FirstPoses = Vec<(Vec2, Vec2)>;

/// What the first position is compared by.
pub(super) struct First {
    poses: FirstPoses,
    /// The loads whose values depend on the position, there and a little behind it.
    loads: [Vec<Measured>; 2],
}

/// What whole turns have changed.
pub(super) enum AfterTurns {
    /// A link is elsewhere.
    Elsewhere(Note),
    /// All links are back, but something is wound up: the position is not the first one again.
    Wound,
}

/// The most sweeps that are followed to find out after how many the mechanism is back.
const SWEEPS: u32 = 60;
/// The most positions of them.
const POSITIONS: usize = 10_000;

/// A link that is not where it began: by how much its origin is elsewhere, and how far it is turned.
type Away = (LinkId, f64, Vec2);

impl Run<'_, '_> {
    pub(super) fn begin(&mut self, tracker: &Tracker, sweep: &Sweep) -> Option<First> {
        sweep.after_turns()?;
        let poses = tracker.state.motion.bodies.iter().map(|b| (b.p, b.u)).collect();
        let loads = [0.0, BEHIND].map(|behind| self.loads(tracker, sweep, (sweep.values(0), behind)));
        Some(First { poses, loads })
    }

    /// Whether the mechanism is not as it began.
    pub(super) fn after_turns(&mut self, begin: &First, last: &Tracker, sweep: &Sweep) -> Option<AfterTurns> {
        let after = sweep.after_turns()?;
        let mut tracker = last.clone();
        self.moved(&mut tracker, &after).ok()?;
        let Some((link, off, turned)) = self.farthest(&begin.poses, &tracker) else {
            return self.is_wound(begin, (&tracker, sweep), after).then_some(AfterTurns::Wound);
        };
        let whole = self.whole_cycle(&begin.poses, tracker, sweep, &after);
        let turned = turned.angle().abs();
        Some(AfterTurns::Elsewhere(Note::Elsewhere { link, off, turned, drives: after.drives, whole }))
    }

    /// Whether sliders on ropes, racks and screws have gone on, or loads have other values, as that of a spring has which is wound up.
    fn is_wound(&mut self, begin: &First, (tracker, sweep): (&Tracker, &Sweep), after: PoseRequest) -> bool {
        let size = extent(self.model);
        let mut bodies = tracker.state.motion.bodies.iter().zip(&begin.poses);
        let differ = |(one, other): (&Measured, &Measured)| {
            let apart = match (one.value, other.value) {
                (Value::Scalar(a), Value::Scalar(b)) => (a - b).abs(),
                (Value::Vector(a), Value::Vector(b)) => (a - b).norm(),
                _ => 0.0,
            };
            apart > WOUND * one.size.max(other.size)
        };
        // a wheel that has turned may have its origin anywhere
        let gone_on = |(body, (p, u)): (&BodyState, &(Vec2, Vec2))| {
            (body.p - *p).norm() > ELSEWHERE * size && (body.u - *u).norm() <= ELSEWHERE
        };
        // a load that jumps there has either value, one that ends with the sweep another one behind it
        let mut changed = |(begun, behind): (&Vec<Measured>, f64)| {
            let loads = self.loads(tracker, sweep, (after.drives.clone(), behind));
            loads.iter().zip(begun).any(differ)
        };
        bodies.any(gone_on) || begin.loads.iter().zip([0.0, BEHIND]).all(&mut changed)
    }

    /// The loads whose values depend on the position, so many steps behind it.
    fn loads(
        &mut self,
        tracker: &Tracker,
        sweep: &Sweep,
        (mut drives, behind): (Vec<DriveValue>, f64),
    ) -> Vec<Measured> {
        let model = self.model;
        let evaluated = model.plan.loads.iter().filter_map(|step| match step {
            LoadStep::Evaluated(id) => Some(Expr::Query(Query::Load(*id))),
            _ => None,
        });
        let evaluated: Vec<Expr> = evaluated.collect();
        if evaluated.is_empty() {
            return Vec::new();
        }
        for ((drive, first), next) in drives.iter_mut().zip(sweep.values(0)).zip(sweep.values(1)) {
            if let (DriveValue::Scalar(x), DriveValue::Scalar(a), DriveValue::Scalar(b)) =
                (drive, first, next)
            {
                *x += behind * (b - a);
            }
        }
        let mut tracker = tracker.clone();
        if tracker.advance_to(model, &self.rates, &drives).is_err() {
            return Vec::new();
        }
        let mut state = tracker.state.clone();
        self.rates.at(&drives, &mut state.motion.inputs);
        state.run_planned_motion(model.plan);
        let view = PoseAnswers::new(model, &state, &tracker.angles, &self.statics);
        let quantities = if self.loads_name_quantities { view.all_quantities() } else { Vec::new() };
        let view = PoseAnswers { quantities: &quantities, ..view };
        let mut sizes = Sizes::new(quantities.len());
        sizes.update_max(&view);
        evaluated.iter().map(|load| view.measured(load, &sizes)).collect()
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
