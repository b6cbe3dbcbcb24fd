//! Answers do not depend on how a mechanism lies, how large it is, and how it is written down.

use super::compare::Worst;
use crate::support::change::Change;
use crate::support::draft::Draft;
use crate::support::reference::{Reference, rollers};
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{
    BalanceId, BalanceKind, DriveId, DriveTarget, LinkId, PairId, PairKind, PointRef, Query,
};

/// The changes tried on a mechanism.
fn changes(draft: &mut Draft) -> Vec<(&'static str, Change)> {
    let none = Change::none(&draft.mechanism);
    let random = &mut draft.random;
    let turned = Change { turn: random.within(-3.0, 3.0), shift: random.vector(2.0), ..none.clone() };
    let mirrored = Change { mirror: -1.0, ..none.clone() };
    let scaled =
        Change { length: random.within(0.01, 30.0), mass: random.within(0.001, 50.0), ..none.clone() };
    let mut links: Vec<usize> = random.shuffled(none.links.len() - 1).into_iter().map(|i| i + 1).collect();
    links.insert(0, 0);
    let pairs = random.shuffled(none.pairs.len());
    let reordered = Change { links, pairs, rename: true, ..none.clone() };
    vec![
        ("turned", turned),
        ("mirrored", mirrored),
        ("scaled", scaled),
        ("reordered", reordered),
        ("renamed", Change { rename: true, ..none }),
    ]
}

/// Solves a mechanism and its changed forms, and compares.
pub fn invariance(draft: &Draft, run: &Run, reference: &Reference) -> Result<Worst, String> {
    let mut worst = Worst::default();
    for (kind, change) in changes(&mut draft.clone()) {
        let other = Run::new(&change.apply(&draft.mechanism)).map_err(|e| format!("{kind}: {e}"))?;
        let one = agree(kind, draft, &change, run, &other, reference).map_err(|e| format!("{kind}: {e}"))?;
        worst.merge(one);
    }
    Ok(worst)
}

fn agree(
    kind: &'static str,
    draft: &Draft,
    change: &Change,
    run: &Run,
    other: &Run,
    reference: &Reference,
) -> Result<Worst, String> {
    let m = &draft.mechanism;
    let (a, b) = (run.view(0)?, other.view(0)?);
    let sigma = run.solved(0)?.condition.min(other.solved(0)?.condition).clamp(1e-6, 1.0);
    let mut worst = Worst::default();
    let exact = kind == "renamed";
    let mut note = |error: f64, scale: f64, what: String| {
        worst.note(kind, if exact && error > 0.0 { f64::INFINITY } else { error }, scale, || what);
    };
    let most = reference.rates.iter().map(|r| r.v.norm().max(r.omega.abs())).fold(1.0, f64::max);
    let rates = reference.rates.iter().map(|r| r.a.norm().max(r.alpha.abs()));
    let fastest = rates.fold(most * most, f64::max);
    let (length, free) = (change.length, rollers(m));
    for link in (1..m.links.len()).map(LinkId::at).filter(|l| !free.contains(l)) {
        let new = change.link(link);
        let local = Vec2::new(0.3, -0.2);
        let (p, q) = (PointRef::Fixed(link, local), PointRef::Fixed(new, change.point(link, local)));
        let apart = change.place(vector(&a, &Query::Position(p))) - vector(&b, &Query::Position(q));
        let size = length * (3.0 + change.shift.norm()) / sigma;
        note(apart.norm(), size, format!("position of {link:?}"));
        let v = change.free(vector(&a, &Query::Velocity(p))) * length - vector(&b, &Query::Velocity(q));
        note(v.norm(), length * most / sigma.powi(2), format!("velocity of {link:?}"));
        let w = change.mirror * scalar(&a, &Query::Omega(link)) - scalar(&b, &Query::Omega(new));
        note(w.abs(), most / sigma.powi(2), format!("omega of {link:?}"));
        let v =
            change.free(vector(&a, &Query::Acceleration(p))) * length - vector(&b, &Query::Acceleration(q));
        note(v.norm(), length * fastest / sigma.powi(3), format!("acceleration of {link:?}"));
    }
    let Some(forces) = reference.forces.as_ref().filter(|f| !f.doubtful && f.condition > 0.0) else {
        return Ok(worst);
    };
    let scale = forces.most.0 * change.force() / sigma.powi(3);
    let turning = forces.most.0 * change.torque().abs() / sigma.powi(3);
    for on in forces.reactions.iter().filter(|on| on.determined.0) {
        if matches!(m.pair(on.pair).kind, PairKind::Cylinder { barrel, rod, .. } if on.link == barrel || on.link == rod)
        {
            continue;
        }
        let (pair, link) = (change.pair(on.pair), change.link(on.link));
        let force = change.free(vector(&a, &Query::Reaction(on.pair, on.link))) * change.force();
        let apart = force - vector(&b, &Query::Reaction(pair, link));
        note(apart.norm(), scale, format!("reaction of {:?} on {:?}", on.pair, on.link));
        if on.determined.1 && matches!(m.pair(on.pair).kind, PairKind::Prismatic(_)) {
            let couple = change.torque() * scalar(&a, &Query::Moment(on.pair, on.link));
            let apart = couple - scalar(&b, &Query::Moment(pair, link));
            note(apart.abs(), turning, format!("couple of {:?} on {:?}", on.pair, on.link));
        }
    }
    let in_pair = |pair: PairId| change.in_pair(m, pair);
    for (i, balance) in m.balances.iter().enumerate() {
        let factor = match balance.kind.places()[0] {
            BalanceKind::Force { .. } => change.force(),
            BalanceKind::InPair(pair) => in_pair(pair),
            BalanceKind::Torque(_) | BalanceKind::Several(_) => change.torque(),
        };
        let query = Query::Balance(BalanceId::at(i));
        let apart = factor * scalar(&a, &query) - scalar(&b, &query);
        note(apart.abs(), factor.abs() * forces.most.0 / sigma.powi(3), format!("balance {i}"));
    }
    for (i, drive) in m.drives.iter().enumerate().filter(|_| m.balances.is_empty()) {
        let factor = match drive.target {
            DriveTarget::Link(_) => change.torque(),
            DriveTarget::Pair(pair) => in_pair(pair),
            DriveTarget::Point(..) | DriveTarget::Place(..) => change.force(),
        };
        let query = Query::Effort(DriveId::at(i));
        let apart = factor * scalar(&a, &query) - scalar(&b, &query);
        note(apart.abs(), factor.abs() * forces.most.0 / sigma.powi(3), format!("effort {i}"));
    }
    Ok(worst)
}
