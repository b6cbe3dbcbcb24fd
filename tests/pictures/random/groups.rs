//! A driven link, then structural groups of all kinds on random earlier links, with slots, contacts, cylinders, springs, loads
//! and friction.

use crate::bars::Tally;
use crate::drawn::Shown;
use crate::support::draft::Draft;
use crate::support::generate;
use crate::support::random::Random;
use assur::internals::model::{Friction, Level, Mechanism, PairKind};
use assur::internals::picture::KINDS;
use assur::internals::plan::{Effects, plan_with};
use assur::internals::solve::{Model, solve};
use assur::internals::structure::structure;

/// Draws the mechanism of a number; whether it is solved.
pub fn judge(seed: u64, tally: &mut Tally) -> bool {
    let draft = generate::with_dead(seed, 0.05, 0.5);
    let mechanism = if seed.is_multiple_of(3) { rubbing(&draft, seed) } else { draft.mechanism };
    let Ok((structure, _)) = structure(&mechanism) else { return false };
    let effects = Effects::at_least(&mechanism, Level::Accelerations, structure.force_defect.is_none());
    let plan = plan_with(&mechanism, &structure, effects);
    let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
    let Ok(solution) = solve(&model) else { return false };
    let name = format!("groups {seed}");
    let shown = Shown { model, solution: &solution, file: (&name, "") };
    for kind in KINDS {
        for (pose, sheet) in shown.sheets(kind, true) {
            tally.judge(&shown, kind, pose, &sheet);
        }
    }
    solution.poses.iter().any(|p| p.outcome.is_ok())
}

/// The same with a little friction in its hinges and guides.
fn rubbing(draft: &Draft, seed: u64) -> Mechanism {
    let mut random = Random::new(seed);
    let mut mechanism = draft.mechanism.clone();
    for pair in &mut mechanism.pairs {
        let rolls = pair.kind.links().iter().any(|l| draft.rollers.contains(l));
        if rolls || random.chance(0.5) {
            continue;
        }
        pair.friction = match &pair.kind {
            PairKind::Revolute(_) => Some(Friction::Circle(random.within(1e-4, 0.02))),
            PairKind::Prismatic(g) if g.contacts.is_none() => {
                Some(Friction::Coefficient(random.within(0.01, 0.1)))
            }
            _ => None,
        };
    }
    mechanism
}
