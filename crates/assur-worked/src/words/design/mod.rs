//! Sentences about what needs no position: cycles, flywheels, cams, gears.

mod chinese;
mod english;
mod russian;

use super::{Language, Sentence};

/// A message; its parts are numbered in the sentences of the languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DesignMessage {
    /// Heading; 0: pair.
    CycleOf,
    /// Extreme positions of a pair; 0: it.
    ExtremesOf,
    TimesOf,
    /// Heading; 0: flywheel, 1: link.
    FlywheelOf,
    /// The torque reduced to the shaft of a flywheel.
    ReducedTorque,
    /// The table of a flywheel; 0: mean torque.
    FlywheelTable,
    /// Extremes of the work; 0, 1: drive.
    FlywheelExtremes,
    /// The size of a flywheel.
    FlywheelInertia,
    FlywheelRim,
    /// Heading; 0: cam.
    CamOf,
    /// The law of a cam.
    CamStages,
    /// A stage; 0: angles.
    CamDwell,
    /// A stage; 0: angles.
    CamOther,
    /// A stage; 0: angles, 1: law.
    CamRise,
    /// A stage; 0: angles, 1: law.
    CamFall,
    LawUniform,
    LawParabolic,
    LawHarmonic,
    LawCycloidal,
    LawPoly345,
    LawPoly4567,
    LawModifiedTrapezoid,
    LawModifiedSine,
    LawSpline,
    /// The slopes of splines through tables of lifts.
    CamSlopes,
    /// The follower at lift zero.
    CamStart,
    /// Pressure angle; 0: cam angle.
    CamPressure,
    /// Curvature; 0: cam angle.
    CamCurvature,
    /// Curvature of the profile of a swinging or sliding face; 0: cam angle.
    FaceCurvature,
    /// The letters of a swinging face.
    FaceLetters,
    /// Heading; 0: mesh.
    GearsOf,
    InvoluteSolved,
}

impl Sentence for DesignMessage {
    fn template(self, language: Language) -> &'static str {
        match language {
            Language::English => english::template(self),
            Language::Chinese => chinese::template(self),
            Language::Russian => russian::template(self),
        }
    }
}
