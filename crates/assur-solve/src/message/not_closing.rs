//! What to say of a group that does not close.

use super::assembly_lines::point_of;
use super::error::SolveError;
use super::format::{labels, links};
use super::gap::gap_text;
use crate::plan::MotionStep;
use crate::position::{Model, State, is_never_regular};

/// What to say of a group that does not close.
pub(crate) fn does_not_close(model: &Model<'_>, state: State, index: usize, pose: &str) -> SolveError {
    let mut state = state;
    let step = &model.plan.motion[index];
    let group = &model.structure.motion[index];
    let labels = labels(model, group, "does not close");
    if let MotionStep::General { problem, .. } = step {
        let help = match point_of(model, group) {
            _ if is_never_regular(&state, *problem, &model.plan.general[*problem]) => {
                "change a direction or a length: wherever these links stand, their pairs let them move or are too many, as \
                 with two parallel guides"
                    .to_owned()
            }
            Some(point) => format!(
                "say where its points are about, as in `assemble {point} near (200 mm, 100 mm)`, or check the lengths"
            ),
            None => "check the lengths".to_owned(),
        };
        return SolveError::NotFound { pose: pose.to_owned(), links: links(model, group), help, labels };
    }
    state.step::<0>(model.plan, step);
    let (gap, help) = gap_text(model, &state, index);
    SolveError::DoesNotClose { pose: pose.to_owned(), gap, help, labels }
}
