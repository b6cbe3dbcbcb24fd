//! The one position of a mechanism, solved again and again with other numbers in the memory of the last time. What has more
//! positions, and what something is to be said of, is for [`super::Following`].

use super::assemble::{Assembly, cylinders_are_positive, fits, hints_by_group, radii};
use super::centre_notes::CentreNotes;
use super::cycle::loads_name_quantities;
use super::extremes::asks_extremes;
use super::inputs::{Rates, known_value};
use super::refusals::{refusals, unit_speeds};
use super::run::Run;
use super::solution::{Pose, Solution, Solved};
use crate::answer::{WholeCycle, first_angles_in};
use crate::model::{At, Expr, HintKind, LoadId, Mechanism, Positions, Value};
use crate::position::{Branch, DriveValue, Model, PoseOrigin, State, Wanted, Wrench, extent};

/// Memory for a position.
pub struct Again {
    /// The hints that are settled with each group.
    hints: Vec<Vec<usize>>,
    /// The ways in which a group can stand.
    ways: Vec<Assembly>,
    /// The assembled state.
    assembled: State,
    angles: Vec<f64>,
    rates: Rates,
    loads_name_quantities: bool,
    memory: Memory,
}

/// What a position leaves for the next.
#[derive(Default)]
struct Memory {
    state: Option<Box<State>>,
    carried: Vec<f64>,
    totals: Vec<Wrench>,
    evaluated: Vec<(LoadId, Value)>,
    wanted: Option<Wanted>,
}

impl Again {
    /// Memory for a mechanism of closed forms without losses that has one position, and for all that differ from it in numbers
    /// alone; `None` for others.
    #[must_use]
    pub fn of(model: &Model<'_>) -> Option<Self> {
        let mechanism = model.mechanism;
        let plain = has_one_position(mechanism)
            && model.plan.is_renumbered()
            && !model.plan.effects.loses()
            && mechanism.links.len() > 1
            && mechanism.cycles.is_empty()
            && mechanism.flywheels.is_empty()
            && !mechanism.has_curves
            && !mechanism.asks_again()
            && !asks_extremes(mechanism)
            && CentreNotes::of(mechanism).is_empty()
            && unit_speeds(model).is_none()
            && refusals(model).is_empty();
        plain.then(|| Self {
            hints: hints_by_group(model),
            ways: Vec::new(),
            assembled: State::new(model.plan),
            angles: Vec::new(),
            rates: Rates::of(model, &WholeCycle::EMPTY),
            loads_name_quantities: loads_name_quantities(mechanism),
            memory: Memory::default(),
        })
    }

    /// Solves the position of a mechanism that differs from the first in numbers alone; `false` where it is not found, or
    /// something is to be said of it: then the solution is nothing.
    pub fn solve(&mut self, model: &Model<'_>, solution: &mut Solution) -> bool {
        solution.notes.clear();
        (solution.positions, solution.unlisted) = (1, 0);
        let mut wanted = self.memory.wanted.take().unwrap_or_else(|| Wanted {
            name: "1".to_owned(),
            origin: PoseOrigin::Sweep(0),
            drives: Vec::new(),
        });
        wanted.drives.clear();
        wanted.drives.extend(model.mechanism.drives.iter().map(|drive| match &drive.positions {
            Positions::List(list) => {
                list.first().and_then(known_value).map_or(DriveValue::None, DriveValue::of)
            }
            Positions::None | Positions::Range { .. } => DriveValue::None,
        }));
        if !matches!(solution.poses.as_slice(), [Pose { outcome: Ok(_), .. }]) {
            let name = wanted.name.clone();
            let outcome = Ok(Solved::default());
            solution.poses.clear();
            solution.poses.push(Pose { name, origin: wanted.origin, drives: Vec::new(), outcome });
        }
        let found = match solution.poses.as_mut_slice() {
            [Pose { drives, outcome: Ok(solved), .. }] => {
                drives.clone_from(&wanted.drives);
                self.solved(model, &wanted, solved)
            }
            _ => false,
        };
        if !found {
            solution.poses.clear();
        }
        self.memory.wanted = Some(wanted);
        found
    }

    fn solved(&mut self, model: &Model<'_>, wanted: &Wanted, solved: &mut Solved) -> bool {
        self.rates.refresh(model);
        self.rates.at(&wanted.drives, &mut self.assembled.motion.inputs);
        if !self.assemble(model) {
            return false;
        }
        first_angles_in(model, &self.assembled, &mut self.angles);
        let memory = &mut self.memory;
        let rates = std::mem::take(&mut self.rates);
        let mut run = Run::new(model, rates, WholeCycle::EMPTY, self.loads_name_quantities);
        run.memory = memory.state.take();
        run.carried = std::mem::take(&mut memory.carried);
        run.totals = std::mem::take(&mut memory.totals);
        run.evaluated = std::mem::take(&mut memory.evaluated);
        let found = run.solve_into(&self.assembled, (&self.angles, wanted), None, solved).is_ok();
        let quiet = run.notes.is_empty();
        memory.state = run.memory.take();
        memory.carried = run.carried;
        memory.totals = run.totals;
        memory.evaluated = run.evaluated;
        self.rates = run.rates;
        found && quiet
    }

    /// Puts every group in the only way that its hints leave, as `assemble` does; `false` where they leave none or several.
    fn assemble(&mut self, model: &Model<'_>) -> bool {
        let Self { hints, ways, assembled: state, .. } = self;
        let extent = extent(model);
        state.start(model.plan);
        hints.iter().enumerate().all(|(index, hints)| {
            let mut count = all_ways(model, state, (index, extent), ways);
            let hints = hints.iter().map(|hint| &model.mechanism.hints[*hint].kind);
            for hint in hints.filter(|hint| !matches!(hint, HintKind::Near { .. })) {
                let mut fitting = 0;
                for i in 0..count {
                    ways[i].put(model, state, index);
                    if fits(model, state, hint) {
                        ways.swap(fitting, i);
                        fitting += 1;
                    }
                }
                count = fitting;
            }
            if count == 1 {
                ways[0].put(model, state, index);
            }
            count == 1
        })
    }
}

/// Finds all ways in which a group with a closed form can stand, each once; gives how many there are.
fn all_ways(
    model: &Model<'_>,
    state: &mut State,
    (index, extent): (usize, f64),
    ways: &mut Vec<Assembly>,
) -> usize {
    let step = &model.plan.motion[index];
    let roots: &[f64] = if state.has_two_roots(step) { &[1.0, -1.0] } else { &[1.0] };
    let sides = radii(step).map(|r| -> &[f64] {
        if r != 0.0 { &[1.0, -1.0] } else { &[1.0] }
    });
    let mut count = 0;
    for &root in roots {
        for &first in sides[0] {
            for &second in sides[1] {
                state.branches[index] = Branch { root, sides: [first, second], general_sides: 0 };
                state.motion.open = None;
                state.step::<0>(model.plan, step);
                if state.motion.open.is_some() || !cylinders_are_positive(model, state, index) {
                    continue;
                }
                match ways.get_mut(count) {
                    Some(way) => way.take(model, state, index),
                    None => ways.push(Assembly::of(model, state, index)),
                }
                let (before, way) = ways.split_at(count);
                count += usize::from(!before.iter().any(|w| w.is_same(&way[0], extent)));
            }
        }
    }
    count
}

/// Whether each drive has one value, known before anything is solved, and nothing asks for another position.
fn has_one_position(mechanism: &Mechanism) -> bool {
    let known = |expr: &Expr| known_value(expr).is_some();
    let one = |positions: &Positions| matches!(positions, Positions::List(list) if matches!(list.as_slice(), [e] if known(e)));
    let beside = mechanism.expects.iter().any(|e| matches!(e.at, Some(At::Drives(_))));
    let rates = mechanism.drives.iter().flat_map(|d| d.speed.iter().chain(&d.acceleration));
    mechanism.poses.is_empty()
        && !beside
        && mechanism.drives.iter().all(|d| one(&d.positions))
        && rates.into_iter().all(known)
}
