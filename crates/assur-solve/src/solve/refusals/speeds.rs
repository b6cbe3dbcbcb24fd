//! Rates, dampers and loads that depend on speeds, where no drive has one.

use crate::answer::every_query;
use crate::model::{DriveId, Expr, LoadId, Mechanism, Query, SpringId};
use crate::plan::Level;
use crate::position::Model;
use crate::solve::note::Note;
use crate::solve::refusal::Refusal;
use crate::source::Span;

/// The drive that would have a speed.
const FIRST: DriveId = DriveId::at(0);

/// Velocities and accelerations of a mechanism whose drives have no speed.
pub(in crate::solve) fn missing_speeds(model: &Model<'_>) -> Option<Refusal> {
    let (mechanism, effects) = (model.mechanism, model.plan.effects);
    let allowed = match (effects.moving, effects.timed) {
        (_, true) => return None,
        (true, false) => Level::Velocities,
        (false, false) => Level::Positions,
    };
    mechanism.drives.first()?;
    let mut needed = allowed;
    let mut places: Vec<Span> = Vec::new();
    let mut ask = |level: Level, span: Span| {
        if level > allowed {
            needed = needed.max(level);
            places.push(span);
        }
    };
    // what rests does not act on a damper
    let dampers: Vec<Span> =
        mechanism.torsion_springs.iter().map(|s| mechanism.loads[s.load.index()].span).collect();
    every_query(mechanism, &mut |query, span| {
        if dampers.contains(&span) {
            return;
        }
        let facts = query.facts();
        if !(facts.geometric && effects.geometric) {
            ask(facts.level, span);
        }
        if let Query::Load(id) = query
            && mechanism.loads[id.index()].is_against_motion()
        {
            ask(Level::Velocities, span);
        }
    });
    for load in mechanism.loads.iter().filter(|_| effects.forces) {
        if load.is_against_motion() {
            ask(Level::Velocities, load.span);
        }
    }
    places.dedup();
    if places.is_empty() {
        return None;
    }
    Some(Refusal::NeedsSpeed { drive: FIRST, level: needed, places })
}

/// Dampers and loads that depend on speeds, while no drive has one.
pub(in crate::solve) fn unit_speeds(model: &Model<'_>) -> Option<Note> {
    let (mechanism, effects) = (model.mechanism, model.plan.effects);
    mechanism.drives.first().filter(|_| effects.forces && !effects.timed)?;
    let springs = mechanism.springs.iter().enumerate().filter(|(_, s)| s.damping > 0.0);
    let springs: Vec<SpringId> = springs.map(|(i, _)| SpringId::at(i)).collect();
    let loads = mechanism.loads.iter().enumerate().filter(|(_, l)| takes_speeds(mechanism, l.value()));
    let loads: Vec<LoadId> = loads.map(|(i, _)| LoadId::at(i)).collect();
    if !effects.moving {
        // at an equilibrium it acts in the vibrations about it
        let damped = !springs.is_empty() || !loads.is_empty();
        let left_out = damped && !mechanism.seeks_equilibrium();
        return left_out.then_some(Note::NoDamping { drive: FIRST, springs, loads });
    }
    (!springs.is_empty() || !loads.is_empty()).then_some(Note::UnitSpeed { drive: FIRST, springs, loads })
}

/// Whether a value depends on speeds, through quantities of the file too.
fn takes_speeds(mechanism: &Mechanism, value: &Expr) -> bool {
    let mut found = false;
    value.parts(&mut |part| {
        found |= match part {
            Expr::Quantity(id) => {
                mechanism.quantities.get(id.index()).is_some_and(|q| takes_speeds(mechanism, &q.expr))
            }
            Expr::Query(query) => query.facts().level > Level::Positions,
            _ => false,
        };
    });
    found
}
