//! The functions, as data.

use crate::names::declared::ThingKind;
use assur_syntax::document::JointKind;

/// A function of the language.
pub struct FunctionRow {
    /// Its name.
    pub name: &'static str,
    /// How it is written.
    pub usage: &'static str,
    /// It asks for something that is known only once the mechanism is solved.
    pub result: bool,
    /// Its arguments are values, not names of things.
    pub values: bool,
}

const fn math(name: &'static str, usage: &'static str) -> FunctionRow {
    FunctionRow { name, usage, result: false, values: true }
}

const fn of_things(name: &'static str, usage: &'static str) -> FunctionRow {
    FunctionRow { name, usage, result: true, values: false }
}

const fn of_values(name: &'static str, usage: &'static str) -> FunctionRow {
    FunctionRow { name, usage, result: true, values: true }
}

/// All functions.
pub const FUNCTIONS: &[FunctionRow] = &[
    math("sqrt", "sqrt(x)"),
    math("abs", "abs(x)"),
    math("sin", "sin(phi)"),
    math("cos", "cos(phi)"),
    math("tan", "tan(phi)"),
    math("asin", "asin(x)"),
    math("acos", "acos(x)"),
    math("atan", "atan(x)"),
    math("atan2", "atan2(y, x)"),
    math("mag", "mag(velocity(C))"),
    math("dot", "dot(a, b)"),
    math("cross", "cross(a, b)"),
    math("unit", "unit(v)"),
    math("dir", "dir(velocity(C))"),
    math("max", "max(a, b)"),
    math("min", "min(a, b)"),
    of_things("position", "position(rod.C)"),
    of_things("velocity", "velocity(rod.C)"),
    of_things("acceleration", "acceleration(rod.C)"),
    of_things("angle", "angle(rod)"),
    of_things("omega", "omega(rod)"),
    of_things("alpha", "alpha(rod)"),
    of_things("displacement", "displacement(D)"),
    of_things("relative_velocity", "relative_velocity(D)"),
    of_things("relative_acceleration", "relative_acceleration(D)"),
    of_things("coriolis", "coriolis(D)"),
    of_things("travel", "travel(D)"),
    of_things("stroke", "stroke(D)"),
    of_things("time_ratio", "time_ratio(D)"),
    of_things("dead", "dead(D, 1)"),
    of_things("transmission_angle", "transmission_angle(bc)"),
    of_things("pressure_angle", "pressure_angle(K)"),
    of_things("reaction", "reaction(B, rod)"),
    of_things("moment", "moment(D, piston)"),
    of_things("normal", "normal(D, piston)"),
    of_things("friction", "friction(D, piston)"),
    of_things("contact_force", "contact_force(D, 1)"),
    of_things("line_offset", "line_offset(D)"),
    of_things("inertia_force", "inertia_force(rod)"),
    of_things("inertia_torque", "inertia_torque(rod)"),
    of_things("inertia_arm", "inertia_arm(rod)"),
    of_things("static_substitution", "static_substitution(rod, B, C).m1"),
    of_things("dynamic_substitution", "dynamic_substitution(rod, B).m1"),
    of_things("effort", "effort(crank)"),
    of_things("power", "power(Mb)"),
    of_things("speed", "speed(A)"),
    of_things("efficiency", "efficiency()"),
    of_things("locked", "locked()"),
    of_things("critical", "critical(al)"),
    of_things("profile", "profile(plate, 30 deg).point"),
    of_things("curvature_radius", "curvature_radius(plate, 30 deg)"),
    of_things("start", "start(plate)"),
    of_things("smallest_base_radius", "smallest_base_radius(plate, 30 deg)"),
    of_things("table", "table(z12).da1"),
    of_values("tooth_force", "tooth_force(z12, 100 N*m).Ft"),
    of_values("sliding_velocity", "sliding_velocity(z12, 20 rad/s).v1"),
    of_things("contact_ratio", "contact_ratio(z12)"),
    of_things("fluctuation", "fluctuation(J)"),
    of_things("rim", "rim(J).width"),
    of_things("work", "work(J)"),
    of_things("reduced_torque", "reduced_torque(J)"),
    of_things("reduced_inertia", "reduced_inertia(J)"),
    of_things("radius", "radius(w1)"),
    of_things("tangential_force", "tangential_force(k)"),
    of_things("normal_force", "normal_force(k)"),
    of_things("tension", "tension(a)"),
    of_values("frictionless", "frictionless(Mb)"),
    of_values("mean", "mean(Mb)"),
    of_values("integral", "integral(Mb)"),
    of_values("argmax", "argmax(Mb)"),
    math("journal_torque", "journal_torque(load = 5 kN, radius = 40 mm, friction = 0.1)"),
    math("thrust_torque", "thrust_torque(load = 5 kN, outer = 40 mm, inner = 0, friction = 0.1)"),
];

/// Whether a function's arguments are values; those of an unknown one are taken for values.
pub fn takes_values(function: &str) -> bool {
    FUNCTIONS.iter().find(|f| f.name == function).is_none_or(|f| f.values)
}

/// How a function is written.
pub fn usage(function: &str) -> String {
    FUNCTIONS.iter().find(|f| f.name == function).map_or_else(String::new, |f| f.usage.to_owned())
}

/// What may be asked of a thing whose name stands where a value is due.
pub fn ask_of(kind: ThingKind, name: &str) -> Option<String> {
    let asked = match kind {
        ThingKind::Link => [format!("angle({name})"), format!("omega({name})")],
        ThingKind::Joint(JointKind::Revolute) => {
            [format!("position({name})"), format!("mag(reaction({name}))")]
        }
        ThingKind::Joint(JointKind::Prismatic | JointKind::Slot | JointKind::Cylinder) => {
            [format!("displacement({name})"), format!("relative_velocity({name})")]
        }
        ThingKind::Shaft | ThingKind::Wheel => [format!("omega({name})"), format!("alpha({name})")],
        ThingKind::Slider => [format!("speed({name})"), format!("velocity({name})")],
        _ => return None,
    };
    Some(format!("ask something of it: `{}` or `{}`", asked[0], asked[1]))
}
