//! Where the resultant of a guide's reaction crosses it, of positions side by side: as [`PoseAnswers::crossing`](super::PoseAnswers::crossing).

use super::joint_reaction::JointReaction;
use super::pose_numbers::NO_FORCE;
use super::wide_columns::{couple_joints, joints};
use crate::math::{Scalar, V2};
use crate::model::{Guide, LinkId, PairId, PairKind};
use crate::position::{F64x8, Model, State};

/// The reaction on a link in a prismatic pair and where it crosses the guide.
#[derive(Clone, Debug)]
pub(super) struct WideCrossing {
    guide: Guide,
    on_link: JointReaction,
    on_slider: JointReaction,
}

impl WideCrossing {
    /// `None` where that is not all that decides.
    pub fn of(model: &Model<'_>, pair: PairId, on: LinkId, guide: &Guide) -> Option<Self> {
        let is_plain = matches!(model.mechanism.pair(pair).kind, PairKind::Prismatic(_))
            && model.plan.genevas.iter().all(|step| step.pair.pair != pair);
        is_plain.then_some(())?;
        Some(Self {
            guide: guide.clone(),
            on_link: joints(model, pair, on)?,
            on_slider: couple_joints(model, pair, guide.slider)?,
        })
    }

    /// The place, m; NaN where there is none.
    pub fn at(&self, state: &State<F64x8>) -> V2<F64x8> {
        let Self { guide, on_link, on_slider } = self;
        let body = |link: LinkId| &state.motion.bodies[link.index()];
        let along = V2::of(guide.along).turned(body(guide.guide).u);
        let through = body(guide.guide).position(guide.through);
        let displacement = (body(guide.slider).position(guide.point) - through).dot(along);
        let normal = on_slider.force(state).dot(along.perp());
        let offset = displacement + on_slider.couple(state) / normal;
        let forces = state.forces.reactions.iter().map(|r| r.force.norm());
        let scale = forces.fold(F64x8::zero(), F64x8::max);
        let crosses = (scale * F64x8::of(NO_FORCE)).lt(on_link.force(state).norm());
        let offset = F64x8::select(crosses, offset, F64x8::of(f64::NAN));
        through + along * offset
    }
}
