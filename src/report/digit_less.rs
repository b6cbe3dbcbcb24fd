//! What the accuracy of the answers took, and what a digit less would save, in one line.

use super::answers::Answers;
use super::cost_words::{count, size};
use assur_position::plan::{ForceStep, MotionStep, Numbers};
use assur_solve::measure::{DigitLess, run_with_a_digit_less, samples_with_a_digit_less};

/// The line; nothing where nothing was computed.
pub(super) fn line(answers: &Answers<'_>) -> Option<String> {
    let (model, solution) = (&answers.model, answers.solution);
    if solution.simulation.is_some() {
        let found = run_with_a_digit_less(model, solution)?;
        let less = format!("within {}", size(10.0 * found.within));
        return Some(format!(
            "an error of {} took {}",
            size(found.within),
            compared(&found, "evaluations", &less)
        ));
    }
    if let Some(found) = samples_with_a_digit_less(model, solution) {
        return Some(format!(
            "functions over the sweep took {}",
            compared(&found, "samples", "a digit less")
        ));
    }
    let poses = answers.poses().count();
    let plan = model.plan;
    let iterated =
        plan.motion.iter().any(|s| matches!(s, MotionStep::General { .. } | MotionStep::Triad { .. }))
            || plan.forces.iter().any(|s| matches!(s, ForceStep::Friction { .. }));
    let numbers = match plan.settings.scalar {
        Numbers::Double => "f64",
        Numbers::DoubleDouble => "double-double",
    };
    let saves =
        if iterated { "the last steps of its iterations at most" } else { "nothing: nothing is iterated" };
    (poses > 0).then(|| format!("{} in {numbers}; a digit less would save {saves}", positions(poses)))
}

fn positions(count: usize) -> String {
    format!("{} position{}", self::count(count), if count == 1 { "" } else { "s" })
}

/// Counts of both, and what the smaller one saves.
fn compared(found: &DigitLess, what: &str, less: &str) -> String {
    let took = format!("{} {what}", count(found.took));
    match found.less {
        Some(fewer) if fewer < found.took => {
            let saved = 100.0 * (found.took - fewer) as f64 / found.took as f64;
            format!("{took}; {less} would take {}, {saved:.0} % less", count(fewer))
        }
        Some(_) => format!("{took}; {less} would save nothing"),
        None => took,
    }
}
