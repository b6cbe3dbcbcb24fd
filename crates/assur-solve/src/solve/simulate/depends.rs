//! What values that are watched depend on.

use crate::model::{Expr, Level, LinkId, Mechanism, PairId, PairKind, Query};

/// What does not move: pairs, and links that loads against the motion hold.
#[derive(Clone, Debug, Default)]
pub(super) struct Kept {
    pub pairs: Vec<PairId>,
    pub links: Vec<LinkId>,
}

impl Kept {
    /// Whether everything moves.
    pub const fn is_empty(&self) -> bool {
        self.pairs.is_empty() && self.links.is_empty()
    }
}

/// Whether links join moving links: then rates go with angles.
pub(super) fn is_linkage(mechanism: &Mechanism) -> bool {
    let mut joined = vec![false; mechanism.links.len()];
    let pairs = mechanism.pairs.iter().filter(|pair| !matches!(pair.kind, PairKind::Transmission(_)));
    let mut links = pairs.flat_map(|pair| pair.kind.links()).filter(|link| link.index() > 0);
    links.any(|link| std::mem::replace(&mut joined[link.index()], true))
}

/// Whether a value is of anything but speeds, angles and their sums and products.
pub(super) fn comes_again(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut again = false;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => {
            again |= !matches!(
                query,
                Query::Omega(_)
                    | Query::Alpha(_)
                    | Query::Angle(_)
                    | Query::Time
                    | Query::KineticEnergy
                    | Query::LoadPower(_)
            );
        }
        Expr::Quantity(id) => again |= comes_again(mechanism, &mechanism.quantities[id.index()].expr),
        Expr::Call(..) | Expr::Curve(..) => again = true,
        _ => {}
    });
    again
}

/// Whether a value stays as it is while these pairs and links do not move: it consists of their coordinates and rates.
pub(super) fn is_kept(mechanism: &Mechanism, kept: &Kept, expr: &Expr) -> bool {
    let (mut any, mut all) = (false, true);
    expr.parts(&mut |part| match part {
        Expr::Query(
            Query::Displacement(pair) | Query::RelativeVelocity(pair) | Query::RelativeAcceleration(pair),
        ) if kept.pairs.contains(pair) => any = true,
        Expr::Query(Query::Angle(link) | Query::Omega(link) | Query::Alpha(link))
            if kept.links.contains(link) =>
        {
            any = true;
        }
        Expr::Query(_) => all = false,
        Expr::Quantity(id) => {
            let own = is_kept(mechanism, kept, &mechanism.quantities[id.index()].expr);
            (any, all) = (any || own, all && own);
        }
        _ => {}
    });
    any && all
}

/// Whether a value depends on accelerations or forces.
pub(super) fn is_deep(mechanism: &Mechanism, expr: &Expr) -> bool {
    let mut deep = false;
    expr.parts(&mut |part| match part {
        Expr::Query(query) => {
            let facts = query.facts();
            deep |= facts.forces || facts.level > Level::Velocities;
            // at rest a load against the motion is what it holds
            if let Query::Load(id) = query {
                deep |= mechanism.loads[id.index()].is_against_motion();
            }
        }
        Expr::Quantity(id) => deep |= is_deep(mechanism, &mechanism.quantities[id.index()].expr),
        _ => {}
    });
    deep
}
