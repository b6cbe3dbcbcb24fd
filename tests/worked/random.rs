//! Random mechanisms. A run works out a few; `ASSUR_WORKED=2000 cargo test --test worked random` works out that many.

use crate::made::Tally;
use crate::support::generate;
use assur::internals::model::Level;
use assur::internals::picture::Scene;
use assur::internals::plan::{Effects, plan_with};
use assur::internals::solve::{Model, solve};
use assur::internals::structure::structure;
use assur::internals::worked::{Language, worked};

/// How many are worked out where nothing else is asked for.
const USUAL: u64 = 120;

#[test]
fn equations_of_random_mechanisms_balance() {
    let wanted = std::env::var("ASSUR_WORKED")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or_else(|| crate::share::part(USUAL));
    let mut tally = Tally::default();
    for seed in 0..wanted {
        judge(seed, &mut tally);
    }
    tally.finish();
    assert!(10 * tally.solutions as u64 > 8 * wanted, "{tally:?}");
    let stated = [tally.derived[1], tally.derived[3], tally.reactions[1], tally.loads[1]];
    assert_eq!(stated, [0; 4], "groups of motion, groups of forces, reactions and loads that are stated");
}

fn judge(seed: u64, tally: &mut Tally) -> Option<()> {
    let draft = generate::with_dead(seed, 0.05, 0.5);
    let mechanism = draft.mechanism;
    let (structure, _) = structure(&mechanism).ok()?;
    let effects = Effects::at_least(&mechanism, Level::Accelerations, structure.force_defect.is_none());
    let plan = plan_with(&mechanism, &structure, effects);
    let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
    let solution = solve(&model).ok()?;
    let name = format!("groups {seed}");
    let scene = Scene::of(model, &solution, (&name, ""), None).ok()?;
    tally.judge(&name, &worked(scene, Language::English, &[]), scene.solved.condition);
    Some(())
}
