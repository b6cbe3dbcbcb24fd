//! Functions of results: `velocity(C)`, `reaction(B, rod)`, `stroke(G)`.

mod args;
mod bearing;
mod cam;
mod cycle;
mod element;
mod flywheel;
mod force;
mod formula;
mod fourier;
mod friction;
mod gear;
mod grip;
mod mass;
mod motion;
mod named;
mod own_usage;
mod pair_kinds;
mod part;
mod relative;
mod shaking;
mod simulation;
mod substitution;
mod suggestion;

use crate::expr::context::Context;
use crate::expr::results::{Call, Results};
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_model::model::{self, CamPart, CurvePart, CycleFunction, FlywheelPart, Query};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::Dimension;
use bearing::Bearing;
use gear::GearRate;
use pair_kinds::{ALONG_LINE, GUIDE, has_moment, has_normal};

/// What expressions ask of this folder.
pub const RESULTS: Results = Results {
    call: |cx, call| cx.function(call),
    part: |cx, whole, base, part| cx.part_of_result(whole, base, part),
    unknown: |cx, name| cx.no_quantity(name),
    usage: |cx, call| cx.own_usage(call),
};

impl Context<'_> {
    /// A call of any function, or an error if there is no such function.
    pub(crate) fn function(&mut self, call: Call<'_>) -> Option<Typed> {
        let Some(function) = Function::named(&call.name.node) else {
            if self.is_curve(&call.name.node) {
                return self.curve(call, CurvePart::Value);
            }
            self.no_function(call);
            return None;
        };
        if function.yields_to_curve() && self.is_curve(&call.name.node) {
            return self.curve(call, CurvePart::Value);
        }
        if let Some(found) = self.of_counterweight(call, function) {
            return found;
        }
        self.answer(call, function)
    }

    /// A function by its kind: one arm for each in the table of the language.
    /// Elementary functions of a number or an angle.
    fn elementary(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        use model::Function as M;
        match function {
            Function::Sin => self.of_angle(call, M::Sin),
            Function::Cos => self.of_angle(call, M::Cos),
            Function::Tan => self.of_angle(call, M::Tan),
            Function::Asin => self.angle_of(call, M::Asin),
            Function::Acos => self.angle_of(call, M::Acos),
            Function::Atan => self.angle_of(call, M::Atan),
            Function::Exp => self.of_number(call, M::Exp),
            Function::Log => self.of_number(call, M::Log),
            _ => self.atan2(call),
        }
    }

    fn answer(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        use Function as F;
        self.is_of_a_motion(call, function)?;
        match function {
            F::Sqrt => self.root(call),
            F::Abs => self.absolute(call),
            F::Sin | F::Cos | F::Tan | F::Asin | F::Acos | F::Atan | F::Atan2 | F::Exp | F::Log => {
                self.elementary(call, function)
            }
            F::Mag => self.magnitude(call),
            F::Unit => self.unit_vector(call),
            F::Dir if self.names.is_result(F::Dir.name(), call.args) => {
                self.link_motion(call, Query::LinkDirection, Type::vector(Dimension::NUMBER))
            }
            F::Dir => self.direction(call),
            F::Slope => self.slope(call),
            F::Dot => self.product(call, model::Function::Dot),
            F::Cross => self.product(call, model::Function::Cross),
            F::Max | F::Min | F::Argmax | F::Argmin | F::Mean | F::Integral => self.over_all(call, function),
            F::Fourier => self.fourier_alone(call),
            F::ShakingForce | F::ShakingMoment | F::RockingCouple => self.on_the_frame(call, function),
            F::Position => self.point_motion(call, Dimension::LENGTH, Query::Position, Query::Displacement),
            F::Velocity => {
                self.point_motion(call, Dimension::VELOCITY, Query::Velocity, Query::RelativeVelocity)
            }
            F::Acceleration => {
                let of_slider = Query::RelativeAcceleration;
                self.point_motion(call, Dimension::ACCELERATION, Query::Acceleration, of_slider)
            }
            F::Jerk | F::AngularJerk => self.jerk(call, function),
            F::Distance => self.distance(call),
            F::InstantCentre => self.instant_centre(call),
            F::Angle => self.link_motion(call, Query::Angle, Type::number(Dimension::ANGLE)),
            F::Omega => self.link_motion(call, Query::Omega, Type::number(Dimension::ANGULAR_VELOCITY)),
            F::Alpha => self.link_motion(call, Query::Alpha, Type::number(Dimension::ANGULAR_ACCELERATION)),
            F::Displacement => self.of_coordinate(call, Query::Displacement, 0),
            F::RelativeVelocity => self.of_coordinate(call, Query::RelativeVelocity, 1),
            F::RelativeAcceleration => self.of_coordinate(call, Query::RelativeAcceleration, 2),
            F::SlipSpeed => self.slip_speed(call),
            F::Travel => self.of_coordinate(call, Query::Travel, 0),
            F::Stroke => self.of_coordinate(call, Query::Stroke, 0),
            F::TimeRatio => self.time_ratio(call),
            F::Dead => self.dead(call),
            F::Coriolis => {
                self.of_pair(call, ALONG_LINE, Query::Coriolis, Type::vector(Dimension::ACCELERATION))
            }
            F::TransmissionAngle => self.transmission_angle(call),
            F::PressureAngle if self.asks_cam(call.args) => self.of_cam(call, CamPart::PressureAngle),
            F::PressureAngle => {
                self.of_pair(call, (has_normal, None), Query::PressureAngle, Type::number(Dimension::ANGLE))
            }
            F::CurvatureRadius | F::CurvatureCentre => self.curvature(call, function),
            F::Profile => self.profile_alone(call),
            F::Start => self.cam_start(call),
            F::SmallestBaseRadius => self.smallest_base_radius(call),
            F::ContactRatio => self.contact_ratio(call),
            F::Table => self.gear_table_alone(call),
            F::ToothForce => self.gear_rate_alone(call, GearRate::ToothForce),
            F::SlidingVelocity => self.gear_rate_alone(call, GearRate::SlidingVelocity),
            F::Reaction => self.reaction(call, |_| true, Query::Reaction, Type::vector(Dimension::FORCE)),
            F::Axial => self.axial(call),
            F::Internal => self.internal_alone(call),
            F::Stable => self.stable(call),
            F::NaturalFrequency | F::DampingRatio | F::DampedFrequency => self.vibration(call, function),
            F::Moment => self.reaction(call, has_moment, Query::Moment, Type::number(Dimension::TORQUE)),
            F::Normal => self.reaction(call, has_normal, Query::Normal, Type::number(Dimension::FORCE)),
            F::Friction => self.reaction(call, has_normal, Query::Friction, Type::number(Dimension::FORCE)),
            F::ContactForce => self.contact_force(call),
            F::LineOffset => self.of_pair(call, GUIDE, Query::LineOffset, Type::number(Dimension::LENGTH)),
            F::InertiaForce => self.inertia(call, Query::InertiaForce, Type::vector(Dimension::FORCE)),
            F::InertiaTorque => self.inertia(call, Query::InertiaTorque, Type::number(Dimension::TORQUE)),
            F::InertiaArm => self.inertia(call, Query::InertiaArm, Type::number(Dimension::LENGTH)),
            F::Mass | F::MassCentre | F::Inertia => self.of_masses(call, function),
            F::StaticSubstitution | F::DynamicSubstitution => self.substitution_alone(call),
            F::Effort => self.effort(call),
            F::Power => self.power(call),
            F::Efficiency => self.verdict(call, Query::Efficiency, Type::number(Dimension::NUMBER)),
            F::Locked => self.verdict(call, Query::Locked, Type::Bool),
            F::FrictionWork | F::Period | F::Sticks | F::Rests | F::Impulse => self.of_motion(call, function),
            F::Time | F::Drive | F::Count | F::KineticEnergy | F::PotentialEnergy | F::Energy => {
                self.of_motion(call, function)
            }
            F::Critical => self.critical(call),
            F::Frictionless => self.frictionless(call),
            F::Speed => self.speed(call),
            F::Radius => self.radius_of_wheel(call),
            F::TangentialForce => self.tangential_force(call),
            F::NormalForce => self.normal_force(call),
            F::Tension => self.tension(call),
            F::TightSide | F::SlackSide | F::Wrap | F::Capacity | F::Slips => self.by_grip(call, function),
            F::JournalTorque => self.bearing(call, Bearing::Journal),
            F::ThrustTorque => self.bearing(call, Bearing::Thrust),
            F::BeltRatio => self.belt_ratio(call),
            F::RaisingTorque | F::LoweringTorque => self.screw_torque(call, function),
            F::Fluctuation => self.of_flywheel(call, FlywheelPart::Fluctuation, Dimension::TORQUE),
            F::Work if self.names.simulates => self.work(call),
            F::Work => self.of_flywheel(call, FlywheelPart::Work, Dimension::TORQUE),
            F::ReducedTorque => self.of_flywheel(call, FlywheelPart::Torque, Dimension::TORQUE),
            F::ReducedInertia => self.of_flywheel(call, FlywheelPart::LinksInertia, Dimension::INERTIA),
            F::Rim => self.rim_alone(call),
        }
    }

    fn slip_speed(&mut self, call: Call<'_>) -> Option<Typed> {
        let kinds = (has_normal as fn(&_) -> bool, None);
        let t = self.of_pair(call, kinds, Query::Sliding, Type::number(Dimension::VELOCITY))?;
        // a magnitude of its own is known to have a kink where it is zero
        Some(Typed { expr: fold::call(model::Function::Abs, vec![t.expr]), ..t })
    }

    fn jerk(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        match function {
            _ if self.follows_from_loads(call) => None,
            Function::AngularJerk => {
                self.link_motion(call, Query::AngularJerk, Type::number(Dimension::ANGULAR_JERK))
            }
            _ if self.asks_guide(call.args) => self.of_coordinate(call, Query::RelativeJerk, 3),
            _ => self.point_motion(call, Dimension::JERK, Query::Jerk, Query::RelativeJerk),
        }
    }

    /// `max` and `min` of several values, or a function of one over a turn or a sweep.
    fn over_all(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        let several = positional(call) != 1;
        match function {
            Function::Max if several => self.extreme(call, model::Function::Max),
            Function::Min if several => self.extreme(call, model::Function::Min),
            Function::Max => self.extreme_over(call, CycleFunction::Max, false),
            Function::Min => self.extreme_over(call, CycleFunction::Min, true),
            Function::Argmax => self.extreme_over(call, CycleFunction::Argmax, false),
            Function::Argmin => self.extreme_over(call, CycleFunction::Argmax, true),
            Function::Mean => self.over_sweep(call, CycleFunction::Mean, false),
            _ => self.over_sweep(call, CycleFunction::Integral, false),
        }
    }

    /// `max`, `min`, `argmax`, `argmin` of one value: along a link, over the turn of a cam, else over the sweep.
    fn extreme_over(&mut self, call: Call<'_>, how: CycleFunction, least: bool) -> Option<Typed> {
        if let Some(found) = self.along_link(call, how, least) {
            return found;
        }
        if let Some(found) = self.over_cam(call, how, least) {
            return found;
        }
        self.over_sweep(call, how, least && how == CycleFunction::Argmax)
    }
}

/// How many arguments have no name.
fn positional(call: Call<'_>) -> usize {
    call.args.iter().filter(|arg| arg.name.is_none()).count()
}

/// A point is named where a value is expected.
pub fn not_a_quantity(path: &str, span: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::request::no_value", format!("`{path}` is not a quantity"))
        .primary(span, "a value is expected here")
        .help_if(help)
        .quoted(span)
}
