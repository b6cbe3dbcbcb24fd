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

use crate::error::RequestError;
use crate::expr::context::Context;
use crate::expr::read::Sign;
use crate::names::functions::FUNCTIONS;
use crate::values::typed::Typed;
use assur_model::model::CamPart;
use assur_syntax::document::{Arg, Expr, ExprKind, Name};
use assur_text::source::Span;

/// A call as the functions of results see it.
#[derive(Clone, Copy)]
pub(crate) struct Call<'c> {
    /// The function.
    pub name: &'c Name,
    /// Its arguments.
    pub args: &'c [Arg],
    /// The whole call.
    pub span: Span,
    /// Whether the sign of the result matters.
    pub sign: Sign,
}

impl Context<'_> {
    /// Whether a call asks for something that is known only once the mechanism is solved.
    pub fn is_result(&self, function: &str, args: &[Arg]) -> bool {
        match function {
            "dir" => match args {
                [Arg { value: Expr { kind: ExprKind::Name(name), .. }, .. }] => {
                    !self.names.quantities.contains_key(name)
                }
                _ => false,
            },
            "max" | "min" => args.len() == 1,
            _ => FUNCTIONS.iter().any(|f| f.name == function && f.result),
        }
    }

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

    /// The arguments, if there are as many as there should be and none has a name.
    pub(crate) fn arguments<'c>(
        &mut self,
        call: Call<'c>,
        least: usize,
        most: usize,
    ) -> Option<Vec<&'c Expr>> {
        let named = call.args.iter().find_map(|a| a.name.as_ref());
        if let Some(name) = named {
            let usage = self.own_usage(call);
            let wanted = "a value without a name".to_owned();
            self.error(RequestError::Argument {
                function: call.name.node.clone(),
                wanted,
                span: name.span,
                usage,
            });
            return None;
        }
        if (least..=most).contains(&call.args.len()) {
            return Some(call.args.iter().map(|a| &a.value).collect());
        }
        let takes = match (least, most) {
            (0, 0) => "no argument",
            (1, 1) => "one argument",
            (1, 2) => "one or two arguments",
            (2, 2) => "two arguments",
            (3, 3) => "three arguments",
            _ => "other arguments",
        };
        let (function, found, usage) = (call.name.node.clone(), call.args.len(), self.own_usage(call));
        self.error(RequestError::Arguments { function, takes, found, span: call.span, usage });
        None
    }

    /// Reports an argument of the wrong kind.
    pub(crate) fn wrong_argument(&mut self, call: Call<'_>, wanted: &str, span: Span) {
        let (function, usage) = (call.name.node.clone(), self.own_usage(call));
        self.error(RequestError::Argument { function, wanted: wanted.to_owned(), span, usage });
    }
}
