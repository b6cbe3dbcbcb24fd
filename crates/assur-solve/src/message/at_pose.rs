//! An error with the pose at which it happened.

use super::error::SolveError;

/// The same error at a pose.
pub(crate) fn with_pose(mut error: SolveError, place: &str) -> SolveError {
    match &mut error {
        SolveError::DoesNotClose { pose, .. }
        | SolveError::NotFound { pose, .. }
        | SolveError::Ambiguous { pose, .. }
        | SolveError::HintNotMet { pose, .. } => place.clone_into(pose),
        _ => {}
    }
    error
}
