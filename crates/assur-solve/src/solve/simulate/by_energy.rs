//! Which motions follow from the energy: those of one coordinate under forces that depend on its value alone.

use super::equations::Equations;
use super::loads::all_parts;
use super::report::{NotByEnergy, On};
use crate::model::{Expr, PairId, Query};

impl Equations<'_, '_> {
    /// Why mass and force along the one coordinate do not tell the motion, if they do not.
    pub fn not_by_energy(&self) -> Option<NotByEnergy> {
        let (mechanism, plan) = (self.model.mechanism, self.model.plan);
        if self.order() != 1 {
            return Some(NotByEnergy::Coordinates(self.order()));
        }
        if !self.reduced.is_alone() {
            let moved =
                mechanism.drives.iter().find(|drive| !drive.free && (drive.of_time || drive.speed.is_some()));
            let moved = moved.or_else(|| mechanism.drives.iter().find(|drive| !drive.free));
            return moved.map(|drive| NotByEnergy::Drive(drive.target));
        }
        if plan.effects.losses {
            return plan.losing.first().map(|&slot| NotByEnergy::Losses(plan.laws[slot].pair));
        }
        if plan.effects.friction {
            let rubs = mechanism.pairs.iter().position(|pair| pair.friction.is_some_and(|f| f.is_some()));
            return rubs.map(|pair| NotByEnergy::Friction(PairId::at(pair)));
        }
        if let Some(spring) = mechanism.springs.iter().position(|spring| spring.damping > 0.0) {
            return Some(NotByEnergy::Damper(spring));
        }
        if let Some(load) = self.acting().find_map(|(id, load, exprs)| {
            if load.is_against_motion() {
                Some((id, On::Sense))
            } else {
                Some((id, self.beyond_place(exprs)?))
            }
        }) {
            return Some(NotByEnergy::Load(load.0, load.1));
        }
        if let Some(step) = plan.genevas.first() {
            return Some(NotByEnergy::Geneva(step.pair.pair));
        }
        self.closed.first().map(|&stop| NotByEnergy::Stop(stop))
    }

    /// What values depend on that a position does not tell.
    fn beyond_place<'m>(&self, exprs: Vec<&'m Expr>) -> Option<On>
    where
        Self: 'm,
    {
        let mut found = None;
        all_parts(self.model.mechanism, exprs.into_iter(), |part| match part {
            Expr::Query(Query::Time) => found = found.or(Some(On::Time)),
            Expr::Query(query) if !is_place(query) => found = found.or(Some(On::Speeds)),
            _ => {}
        });
        found
    }
}

/// Whether a position tells it; what stops bear is nothing while none is closed.
const fn is_place(query: &Query) -> bool {
    matches!(
        query,
        Query::Position(_)
            | Query::LinkDirection(_)
            | Query::Angle(_)
            | Query::Displacement(_)
            | Query::StopEffort(_)
    )
}
