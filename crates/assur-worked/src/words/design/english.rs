//! English.

use super::DesignMessage as Message;

pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::CycleOf => "Extreme positions: {0}",
        Message::ExtremesOf => {
            "{0} is at its ends where its velocity passes through zero; the drive is then at φ_1 (least) and φ_2 (greatest):"
        }
        Message::TimesOf => {
            "The larger drive angle over the smaller is the ratio of the times; θ is the angle between the crank’s two extreme positions:"
        }
        Message::FlywheelOf => "Flywheel {0} on {1}",
        Message::ReducedTorque => {
            "The torque that the flywheel evens out, reduced to its shaft, has the same power there. At the position worked out:"
        }
        Message::FlywheelTable => {
            "M_r is the reduced torque, M_m = {0} the mean torque of the other side; M_r − M_m does the work W, counted from the first position:"
        }
        Message::FlywheelExtremes => {
            "Between the positions, where M_r passes through its mean, the work is least at {0}° and greatest at {1}°:"
        }
        Message::FlywheelInertia => "The moment of inertia that keeps the fluctuation of speed δ:",
        Message::FlywheelRim => "The rim, its mass on the diameter D, its height c times its width:",
        Message::CamOf => "Cam {0}",
        Message::CamStages => {
            "The law by stages; Φ is the angle of a stage, h its change of the lift, u = φ / Φ the part of it that is passed, s′ the derivative by the cam angle. The index gives u in hundredths; a law with several formulas has each of them:"
        }
        Message::CamDwell => "{0}: dwell.",
        Message::CamOther => "{0}: a law without a short formula; its values are in the table.",
        Message::CamRise => "{0}: rise, {1}:",
        Message::CamFall => "{0}: fall, {1}:",
        Message::LawUniform => "constant velocity",
        Message::LawParabolic => "constant acceleration and deceleration",
        Message::LawHarmonic => "simple harmonic motion",
        Message::LawCycloidal => "cycloidal motion",
        Message::LawPoly345 => "polynomial 3-4-5",
        Message::LawPoly4567 => "polynomial 4-5-6-7",
        Message::LawModifiedTrapezoid => {
            "modified trapezoid, in the first half; in the second half symmetric"
        }
        Message::LawModifiedSine => "modified sine, in the first half; in the second half symmetric",
        Message::LawSpline => "a piece of a spline",
        Message::CamSlopes => {
            "A cubic spline runs through the rows i of the table. Its slopes σ by the cam angle are found together, so that the second derivative does not jump at any row; a slope follows from its neighbours, the terms of a piece from the slopes at its ends:"
        }
        Message::CamStart => "On the base circle the follower is at:",
        Message::CamPressure => "The pressure angle is greatest at {0}° of the cam; there (index α):",
        Message::CamCurvature => {
            "The pitch curve is sharpest at {0}° of the cam; there (index ρ), with w the path of the follower’s point in the cam per rad:"
        }
        Message::FaceCurvature => "The profile is sharpest at {0}° of the cam; there (index ρ):",
        Message::FaceLetters => {
            "With h the distance of the face from the cam’s centre, h′ its derivative by the cam angle, and k the turn of the face in the cam per rad:"
        }
        Message::GearsOf => "Gears of {0}",
        Message::InvoluteSolved => "The angle with this involute (inv α = tan α − α):",
    }
}
