//! All assemblies of every group at the first position, each with the clause that chooses it.

use super::assemble::{Assembly, assemble, every_way};
use super::clause::{Clause, clauses, near_clauses};
use super::extremes::statics;
use super::failure::{Cause, Failure};
use super::inputs::Rates;
use super::positions::Sweep;
use super::refusals::{missing_speeds, not_supported};
use super::unassembled::does_not_close;
use crate::plan::MotionStep;
use crate::position::{Model, PoseRequest, State, extent};
use crate::structure::GroupKind;

/// The assemblies at the first position.
#[derive(Debug)]
pub struct Assemblies {
    /// The position; absent where there is no mechanism to assemble.
    pub pose: Option<PoseRequest>,
    /// The groups that can stand in several ways or are not driven links, in the order of solution.
    pub groups: Vec<GroupAssemblies>,
    /// Why the mechanism is not assembled, where it is not.
    pub problem: Option<Failure>,
}

/// The assemblies of one group, the groups before it standing as `assemble` chooses, or in their first way.
#[derive(Debug)]
pub struct GroupAssemblies {
    /// Index into [`crate::structure::Structure::motion`].
    pub group: usize,
    pub assemblies: Vec<GroupAssembly>,
    /// There is no proof that there are no others.
    pub searched: bool,
}

#[derive(Debug)]
pub struct GroupAssembly {
    /// The clause that chooses it; none where there is no other.
    pub clause: Option<Clause>,
    /// Its condition figure, in [0, 1].
    pub condition: f64,
    /// The file chooses it.
    pub chosen: bool,
}

/// That `assemble` does not choose at the first position: of a mechanism whose groups all have closed forms, and whose drives are given.
#[must_use]
pub fn not_chosen(model: &Model<'_>) -> Option<Failure> {
    let mechanism = model.mechanism;
    let searched = model.plan.motion.iter().any(|step| matches!(step, MotionStep::General { .. }));
    let sought = mechanism.drives.iter().any(|drive| drive.is_unaided() || drive.of_time);
    if mechanism.links.len() < 2 || mechanism.simulation.is_some() || searched || sought {
        return None;
    }
    let statics = statics(model).ok()?;
    let first = Sweep::of(model, &statics).at(0);
    let mut state = State::new(model.plan);
    Rates::of(model, &statics).at(&first.drives, &mut state.motion.inputs);
    match assemble(model, state) {
        Err(cause @ Cause::Ambiguous { .. }) => Some(Failure::at(&first, cause)),
        _ => None,
    }
}

/// Lists all assemblies of every group.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, strokes that do not exist.
pub fn assemblies(model: &Model<'_>) -> Result<Assemblies, Vec<Failure>> {
    let mut refused = not_supported(model.mechanism);
    refused.extend(missing_speeds(model));
    if !refused.is_empty() {
        return Err(refused.into_iter().map(Failure::from).collect());
    }
    let mut out = Assemblies { pose: None, groups: Vec::new(), problem: None };
    if model.mechanism.links.len() < 2 {
        return Ok(out);
    }
    let statics = statics(model).map_err(|cause| vec![cause.into()])?;
    let first = Sweep::of(model, &statics).at(0);
    let mut state = State::new(model.plan);
    Rates::of(model, &statics).at(&first.drives, &mut state.motion.inputs);
    let whole = match assemble(model, state.clone()) {
        Ok(whole) => Some(whole),
        Err(Cause::Ambiguous { .. }) => None,
        Err(cause) => {
            out.problem = Some(Failure::at(&first, cause));
            None
        }
    };
    state.start(model.plan);
    let extent = extent(model);
    for (index, group) in model.structure.motion.iter().enumerate() {
        let mut ways = every_way(model, &mut state, index, extent);
        let stands = whole.as_ref().map(|whole| Assembly::of(model, whole, index));
        // the search may miss how a group of many bodies stands as written
        let missed = stands.clone().filter(|stands| !ways.iter().any(|way| way.is_same(stands, extent)));
        ways.extend(missed);
        let Some(other) = ways.first() else {
            out.problem.get_or_insert_with(|| Failure::at(&first, does_not_close(model, state, index)));
            break;
        };
        let chosen = |assembly: &Assembly| stands.as_ref().is_some_and(|s| s.is_same(assembly, extent));
        let next = ways.iter().find(|assembly| chosen(assembly)).unwrap_or(other);
        if ways.len() > 1 || group.kind != GroupKind::Driven {
            let modes = ways.iter().zip(choosing(model, &state, &ways, index)).map(|(assembly, clause)| {
                GroupAssembly { clause, condition: assembly.conditioning.abs(), chosen: chosen(assembly) }
            });
            let searched = matches!(model.plan.motion[index], MotionStep::General { .. });
            out.groups.push(GroupAssemblies { group: index, assemblies: modes.collect(), searched });
        }
        next.put(model, &mut state, index);
    }
    out.pose = Some(first);
    Ok(out)
}

/// A clause for every way; none for the only one.
fn choosing(model: &Model<'_>, before: &State, ways: &[Assembly], index: usize) -> Vec<Option<Clause>> {
    if ways.len() < 2 {
        return vec![None; ways.len()];
    }
    let each = ways.iter().map(|assembly| {
        let mut state = before.clone();
        assembly.put(model, &mut state, index);
        state
    });
    let states: Vec<State> = each.collect();
    let states: Vec<&State> = states.iter().collect();
    let group = &model.structure.motion[index];
    let mut found = clauses(model, &states, group);
    if found.len() != ways.len() {
        found = near_clauses(model, &states, group);
    }
    let mut found = found.into_iter();
    ways.iter().map(|_| found.next()).collect()
}
