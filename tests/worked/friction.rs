//! The iteration of friction as it is shown ends with the friction of the solver.

use crate::examples::{Example, examples};
use assur::internals::plan::ForceStep;

#[test]
fn the_last_step_has_the_friction_of_the_solver() {
    let (mut groups, mut searched, mut wrong) = (0, 0, Vec::new());
    for Example { name, solved, .. } in examples() {
        let Some((_, solved)) = solved else { continue };
        let plan = solved.compiled.model().plan;
        for pose in solved.solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok()) {
            for (index, step) in plan.forces.iter().enumerate() {
                let ForceStep::Friction { group, .. } = step else { continue };
                let steps = pose.state.friction_steps(plan, index);
                let Some(last) = steps.last().filter(|_| !pose.state.forces.locked) else { continue };
                groups += 1;
                let same = group.elements.iter().zip(last).all(|(&element, presses)| {
                    let own = plan.friction[element].kind.factor() * presses;
                    let found = pose.state.forces.frictions[element].abs();
                    pose.state.forces.senses[element] == 0.0 || (own - found).abs() <= 1e-9 * own.max(found)
                });
                if !same && steps.len() < 20 {
                    wrong.push(format!("{name}: {steps:?}"));
                }
                searched += usize::from(!same);
            }
        }
    }
    println!("{groups} groups, {searched} searched");
    assert!(wrong.is_empty() && groups > 60, "{groups} groups, {wrong:#?}");
}
