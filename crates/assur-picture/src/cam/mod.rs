//! Designed cams: the profile with its follower, and the motion of the follower over a turn.

mod motion;
mod profile;

use crate::paper::Paper;
use crate::scene::Subject;
use assur_drawing::Drawing;
use assur_text::diagnostic::Diagnosis;
use profile::PlacedCam;

/// Two pictures per cam: as it stands in its mechanism at a position, else at the angle of its greatest pressure angle.
///
/// # Errors
/// There is none.
pub fn cams(subject: &Subject<'_, '_>, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let plates = &subject.mechanism.cams;
    if plates.is_empty() {
        return Err(Diagnosis::error(
            "mech::picture::no_cam",
            "there is no cam to draw: the file designs none",
        )
        .help(
            "design one: `cam plate { base_radius 50 mm; follower translating roller { radius 10 mm }; \
             rise 120 deg through 30 mm cycloidal; fall 120 deg poly345 }`",
        ));
    }
    let mut drawings = Vec::new();
    for (i, plate) in plates.iter().enumerate() {
        drawings.push(profile::profile(subject, &PlacedCam::of(subject, i, plate), paper)?);
        drawings.push(motion::motion(subject, plate));
    }
    Ok(drawings)
}
