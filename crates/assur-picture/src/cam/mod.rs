//! Designed cams: the profile with its follower, and the motion of the follower over a turn.

mod motion;
mod profile;

use crate::paper::Paper;
use crate::scene::Scene;
use crate::words;
use assur_drawing::Drawing;
use assur_model::model::Mechanism;
use assur_text::diagnostic::Diagnosis;
use profile::PlacedCam;

/// Whose cams are drawn.
struct Subject<'s, 'a> {
    mechanism: &'a Mechanism,
    title: String,
    /// The begin of ids.
    id: String,
    /// The position at which cams stand that are in the mechanism.
    scene: Option<&'s Scene<'a>>,
}

/// Two pictures per cam.
///
/// # Errors
/// There is none.
pub fn cams(scene: &Scene<'_>, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let (title, id) = (words::title(scene), words::id(scene, "cam"));
    drawn(&Subject { mechanism: scene.mechanism(), title, id, scene: Some(scene) }, paper)
}

/// The cams of a file that has no position: each at the angle of its greatest pressure angle.
///
/// # Errors
/// There is none.
pub fn cams_alone(mechanism: &Mechanism, file: &str, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let title = if mechanism.title.is_empty() { file.to_owned() } else { mechanism.title.clone() };
    let stem = file.rsplit(['/', '\\']).next().unwrap_or_default().trim_end_matches(".mech");
    drawn(&Subject { mechanism, title, id: format!("cam-{stem}"), scene: None }, paper)
}

fn drawn(subject: &Subject<'_, '_>, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
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
