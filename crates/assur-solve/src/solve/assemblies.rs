//! All assemblies of every group at the first position, each with the line that chooses it.

use super::assemble::{Assembly, assemble, every_way};
use super::extremes::statics;
use super::inputs::Rates;
use super::positions::Sweep;
use crate::message::{
    SolveError, does_not_close, lines, missing_speeds, near_lines, not_supported, place, with_pose,
};
use crate::position::{Model, State, extent};
use crate::structure::GroupKind;

/// The assemblies at the first position.
#[derive(Debug)]
pub struct Assemblies {
    /// ` at pose 1 (crank = 20 deg)`, or empty.
    pub pose: String,
    /// The groups that can stand in several ways or are not driven links, in the order of solution.
    pub groups: Vec<GroupAssemblies>,
    /// Why the mechanism is not assembled, where it is not.
    pub problem: Option<SolveError>,
}

/// The assemblies of one group, the groups before it standing as `assemble` chooses, or in their first way.
#[derive(Debug)]
pub struct GroupAssemblies {
    /// Index into [`crate::structure::Structure::motion`].
    pub group: usize,
    /// Its assemblies.
    pub assemblies: Vec<AssemblyLine>,
    /// There is no proof that there are no others.
    pub searched: bool,
}

/// One assembly.
#[derive(Debug)]
pub struct AssemblyLine {
    /// The line that chooses it; none where there is no other.
    pub line: Option<String>,
    /// Its condition figure, in [0, 1].
    pub condition: f64,
    /// The file chooses it.
    pub chosen: bool,
}

/// Lists all assemblies of every group.
///
/// # Errors
/// Constructs not supported yet, requests without the speeds they need, strokes that do not exist.
pub fn assemblies(model: &Model<'_>) -> Result<Assemblies, Vec<SolveError>> {
    let mut errors = not_supported(model.mechanism);
    errors.extend(missing_speeds(model));
    if !errors.is_empty() {
        return Err(errors);
    }
    let mut out = Assemblies { pose: String::new(), groups: Vec::new(), problem: None };
    if model.mechanism.links.len() < 2 {
        return Ok(out);
    }
    let statics = statics(model).map_err(|e| vec![e])?;
    let first = Sweep::of(model, &statics).at(0);
    out.pose = place(model, &first);
    let mut state = State::new(model.plan);
    Rates::of(model, &statics).at(&first.drives, &mut state.motion.inputs);
    let whole = match assemble(model, state.clone()) {
        Ok(whole) => Some(whole),
        Err(SolveError::Ambiguous { .. }) => None,
        Err(error) => {
            out.problem = Some(with_pose(error, &out.pose));
            None
        }
    };
    state.start(model.plan);
    let extent = extent(model);
    for (index, group) in model.structure.motion.iter().enumerate() {
        let ways = every_way(model, &mut state, index, extent);
        let Some(first) = ways.first() else {
            out.problem.get_or_insert_with(|| does_not_close(model, state, index, &out.pose));
            break;
        };
        let stands = whole.as_ref().map(|whole| Assembly::of(model, whole, index));
        let chosen = |assembly: &Assembly| stands.as_ref().is_some_and(|s| s.is_same(assembly, extent));
        let next = ways.iter().find(|assembly| chosen(assembly)).unwrap_or(first);
        if ways.len() > 1 || group.kind != GroupKind::Driven {
            let modes = ways.iter().zip(choosing(model, &state, &ways, index)).map(|(assembly, line)| {
                AssemblyLine { line, condition: assembly.conditioning.abs(), chosen: chosen(assembly) }
            });
            let searched = matches!(model.plan.motion[index], crate::plan::MotionStep::General { .. });
            out.groups.push(GroupAssemblies { group: index, assemblies: modes.collect(), searched });
        }
        next.put(model, &mut state, index);
    }
    Ok(out)
}

/// A line for every way; none for the only one.
fn choosing(model: &Model<'_>, before: &State, ways: &[Assembly], index: usize) -> Vec<Option<String>> {
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
    let mut found = lines(model, &states, group);
    if found.len() != ways.len() {
        found = near_lines(model, &states, group);
    }
    let mut found = found.into_iter();
    ways.iter().map(|_| found.next()).collect()
}
