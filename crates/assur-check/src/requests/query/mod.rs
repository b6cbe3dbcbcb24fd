//! Functions of results: `velocity(C)`, `reaction(B, rod)`, `stroke(G)`.

mod args;
mod bearing;
mod cam;
mod cycle;
mod element;
mod flywheel;
mod force;
mod friction;
mod gear;
mod meant;
mod motion;
mod own_usage;
mod substitution;

use crate::expr::context::Context;
use crate::expr::results::{Call, Results};
use crate::values::typed::Typed;
use assur_model::model::CamPart;

/// What expressions ask of this folder.
pub const RESULTS: Results = Results {
    call: |cx, call| cx.result(call),
    part: |cx, whole, base, part| cx.part_of_result(whole, base, part),
    unknown: |cx, name| cx.no_quantity(name),
    usage: |cx, call| cx.own_usage(call),
};

impl Context<'_> {
    /// A function of results, or an error if there is no such function.
    pub(crate) fn result(&mut self, call: Call<'_>) -> Option<Typed> {
        if matches!(call.name.node.as_str(), "max" | "min" | "argmax")
            && let Some(found) = self.over_cam(call)
        {
            return found;
        }
        match call.name.node.as_str() {
            "position" | "velocity" | "acceleration" => self.point_motion(call),
            "angle" | "omega" | "alpha" | "dir" => self.link_motion(call),
            "displacement"
            | "relative_velocity"
            | "relative_acceleration"
            | "coriolis"
            | "travel"
            | "stroke"
            | "time_ratio"
            | "dead" => self.pair_motion(call),
            "transmission_angle" => self.transmission_angle(call),
            "pressure_angle" if self.asks_cam(call.args) => self.of_cam(call, CamPart::PressureAngle),
            "pressure_angle" => self.pressure_angle(call),
            "curvature_radius" => self.of_cam(call, CamPart::CurvatureRadius),
            "profile" => self.profile_alone(call),
            "contact_ratio" => self.contact_ratio(call),
            "table" | "tooth_force" | "sliding_velocity" => self.gear_alone(call),
            "start" => self.cam_start(call),
            "smallest_base_radius" => self.smallest_base_radius(call),
            "reaction" | "moment" | "normal" | "friction" => self.reaction(call),
            "contact_force" => self.contact_force(call),
            "line_offset" => self.line_offset(call),
            "inertia_force" | "inertia_torque" | "inertia_arm" => self.inertia(call),
            "static_substitution" | "dynamic_substitution" => self.substitution_alone(call),
            "effort" => self.effort(call),
            "power" => self.power(call),
            "efficiency" | "locked" => self.verdict(call),
            "critical" => self.critical(call),
            "frictionless" => self.frictionless(call),
            "speed" => self.speed(call),
            "radius" => self.radius_of_wheel(call),
            "tangential_force" | "normal_force" | "tension" => self.transmission_force(call),
            "journal_torque" | "thrust_torque" => self.bearing(call),
            "max" | "min" | "mean" | "integral" | "argmax" => self.over_sweep(call),
            "fluctuation" | "rim" | "work" | "reduced_torque" | "reduced_inertia" => self.of_flywheel(call),
            _ => {
                self.no_function(call);
                None
            }
        }
    }
}
