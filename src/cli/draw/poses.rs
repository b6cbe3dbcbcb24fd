//! The positions that are drawn where none is named.

use crate::pipeline::Solved;
use assur_model::model::Positions;
use assur_solve::solve::PoseOrigin;

/// The names of the solved poses of a list, those of `pose` with them; none where a drive goes through a range.
pub fn listed(solved: &Solved) -> Vec<&str> {
    let drives = &solved.compiled.mechanism.drives;
    if drives.iter().any(|drive| matches!(drive.positions, Positions::Range { .. })) {
        return Vec::new();
    }
    let asked = |origin: PoseOrigin| !matches!(origin, PoseOrigin::Expected(_));
    let poses = solved.solution.poses.iter().filter(|pose| asked(pose.origin) && pose.outcome.is_ok());
    poses.map(|pose| pose.name.as_str()).collect()
}
