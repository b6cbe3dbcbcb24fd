//! The numbers of a position as its JSON lists them, of positions side by side: as [`read_numbers`](super::read_numbers), without a
//! state of each position.

use super::pose_numbers::Source;
use super::wide_columns::{Column, WideBeside, WideColumns, WideExpr, WideShown};
use super::wide_crossing::WideCrossing;
use crate::model::{DriveTarget, FindKind};
use crate::position::Model;
use assur_text::units::Conversion;

impl WideColumns {
    /// A column for every number; `None` where one is evaluated position by position.
    #[must_use]
    pub fn of_sources(model: &Model<'_>, sources: &[Source]) -> Option<Self> {
        let column = |source| Some(Column { shown: WideShown::of(model, source)?, unit: Conversion::None });
        sources.iter().map(column).collect::<Option<_>>().map(Self)
    }

    /// Whether one shows the angle of a link.
    #[must_use]
    pub fn shows_angles(&self) -> bool {
        self.0.iter().any(|column| matches!(column.shown, WideShown::PoseExtras(WideBeside::Angle(_))))
    }
}

impl WideShown {
    fn of(model: &Model<'_>, source: &Source) -> Option<Self> {
        let found = match source {
            Source::Drive(drive) => {
                let target = model.mechanism.drives.get(*drive)?.target;
                return Some(Self::Drive(*drive, matches!(target, DriveTarget::Point(..))));
            }
            Source::Angle(link) => return Some(Self::PoseExtras(WideBeside::Angle(*link))),
            Source::Equilibrium => return Some(Self::PoseExtras(WideBeside::Equilibrium)),
            Source::Power => return Some(Self::PoseExtras(WideBeside::Power)),
            Source::Condition => return Some(Self::PoseExtras(WideBeside::Condition)),
            Source::Omega(link) => WideExpr::Omega(*link),
            Source::Alpha(link) => WideExpr::Alpha(*link),
            Source::InertiaForce(link, centre, mass) => WideExpr::Acceleration(*link, *centre).times(-mass),
            Source::InertiaTorque(link, inertia) => WideExpr::Alpha(*link).times(-inertia),
            Source::Position(link, at) => WideExpr::Position(*link, *at),
            Source::Velocity(link, at) => WideExpr::Velocity(*link, *at),
            Source::Acceleration(link, at) => WideExpr::Acceleration(*link, *at),
            Source::Force(joints) => WideExpr::Force(joints.clone()),
            Source::Couple(joints) => WideExpr::Couple(joints.clone()),
            Source::Effort(slot) => WideExpr::Effort(*slot),
            Source::Find(index) => match &model.mechanism.finds.get(*index)?.kind {
                FindKind::Value { expr, .. } => WideExpr::of_answer(model, expr)?,
                FindKind::Reactions | FindKind::Table(_) => return None,
            },
            Source::Crossing(pair, on, guide) => {
                WideExpr::Crossing(Box::new(WideCrossing::of(model, *pair, *on, guide)?))
            }
            Source::Contacts(..) => return None,
        };
        Some(Self::Found(found))
    }
}
