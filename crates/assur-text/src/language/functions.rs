//! The functions, as data.

use super::{Argument, Dimension, Form, FunctionGroup, FunctionRow, Gives, Takes};
use Gives::{Condition, Number, Parts, Varies, Vector};

/// The functions and their table. Adding a row here, the compiler asks for the rest.
macro_rules! functions {
    ($($function:ident $name:literal $group:ident $usage:literal [$($form:expr),* $(,)?],)*) => {
        /// The functions of the language.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Function {
            $(#[doc = $usage] $function,)*
        }

        /// The table of functions.
        pub static FUNCTIONS: &[FunctionRow] = &[$(FunctionRow {
            function: Function::$function,
            name: $name,
            group: FunctionGroup::$group,
            usage: $usage,
            forms: &[$($form),*],
        },)*];
    };
}

const fn form(takes: &'static [Argument], gives: Gives, means: &'static str) -> Form {
    Form { takes, gives, means }
}

const fn arg(name: &'static str, takes: Takes) -> Argument {
    Argument { name, takes, optional: false, named: false }
}

const fn optional(argument: Argument) -> Argument {
    Argument { optional: true, ..argument }
}

const fn named(name: &'static str, takes: Takes) -> Argument {
    Argument { name, takes, optional: false, named: true }
}

const fn value(name: &'static str) -> Argument {
    arg(name, Takes::Value(None))
}

const fn value_of(name: &'static str, dimension: Dimension) -> Argument {
    arg(name, Takes::Value(Some(dimension)))
}

const X: Argument = value("x");
const NUMBER: Argument = value_of("x", Dimension::NUMBER);
const ANGLE: Argument = value_of("a", Dimension::ANGLE);
const P: Argument = arg("P", Takes::Point);
const L: Argument = arg("L", Takes::Link);
const OWN: Argument = arg("P", Takes::OwnPoint);
const KP: Argument = arg("K.P", Takes::Point);
const J: Argument = arg("J", Takes::Pair);
const ON: Argument = optional(L);
const SLIDER: Argument = arg("A", Takes::Slider);
const CAM: Argument = arg("cam", Takes::Cam);
const PHI: Argument = optional(arg("phi", Takes::Angle));
const MESH: Argument = arg("mesh", Takes::Mesh);
const F: Argument = arg("F", Takes::Flywheel);
const EVENT: Argument = arg("top", Takes::Event);
/// Where the part of a motion under loads begins and ends.
const AFTER: Argument = optional(named("after", Takes::Value(Some(Dimension::TIME))));
const BEFORE: Argument = optional(named("before", Takes::Value(Some(Dimension::TIME))));
const WHICH: Argument = optional(arg("2", Takes::Count));
const LOAD: Argument = named("load", Takes::Value(Some(Dimension::FORCE)));
const COEFFICIENT: Argument = named("friction", Takes::Value(Some(Dimension::NUMBER)));
const FIT: Argument = optional(named("fit", Takes::Fit));
const RADIUS: Argument = named("radius", Takes::Value(Some(Dimension::LENGTH)));
const OUTER: Argument = named("outer", Takes::Value(Some(Dimension::LENGTH)));
const WRAP: Argument = named("wrap", Takes::Value(Some(Dimension::ANGLE)));
const GROOVE: Argument = optional(named("groove", Takes::Value(Some(Dimension::ANGLE))));
const DIAMETER: Argument = named("diameter", Takes::Value(Some(Dimension::LENGTH)));
const LEAD: Argument = named("lead", Takes::Value(Some(Dimension::LENGTH)));
const FLANK: Argument = optional(named("flank", Takes::Value(Some(Dimension::ANGLE))));
const INNER: Argument = optional(named("inner", Takes::Value(Some(Dimension::LENGTH))));

const COORDINATE: Gives = Varies("length or angle");
const OF_X: Gives = Varies("that of x");
const OF_DRIVE: Gives = Varies("that of the drive");

functions! {
    Sqrt "sqrt" Math "sqrt(x)" [form(&[X], Varies("half the powers of x"), "square root")],
    Abs "abs" Math "abs(x)" [form(&[X], OF_X, "absolute value")],
    Sin "sin" Math "sin(phi)" [form(&[ANGLE], Number(Dimension::NUMBER), "sine")],
    Cos "cos" Math "cos(phi)" [form(&[ANGLE], Number(Dimension::NUMBER), "cosine")],
    Tan "tan" Math "tan(phi)" [form(&[ANGLE], Number(Dimension::NUMBER), "tangent")],
    Asin "asin" Math "asin(x)" [form(&[NUMBER], Number(Dimension::ANGLE), "angle of a sine")],
    Acos "acos" Math "acos(x)" [form(&[NUMBER], Number(Dimension::ANGLE), "angle of a cosine")],
    Atan "atan" Math "atan(x)" [form(&[NUMBER], Number(Dimension::ANGLE), "angle of a tangent")],
    Atan2 "atan2" Math "atan2(y, x)"
        [form(&[value("y"), X], Number(Dimension::ANGLE), "direction of (x, y)")],
    Exp "exp" Math "exp(x)" [form(&[NUMBER], Number(Dimension::NUMBER), "power of e")],
    Log "log" Math "log(x)" [form(&[NUMBER], Number(Dimension::NUMBER), "natural logarithm")],
    Mag "mag" Math "mag(velocity(C))" [form(&[value("v")], Varies("that of v"), "magnitude of a vector")],
    Dot "dot" Math "dot(a, b)"
        [form(&[value("a"), value("b")], Varies("product"), "scalar product of vectors")],
    Cross "cross" Math "cross(a, b)"
        [form(&[value("a"), value("b")], Varies("product"), "vector product, a number")],
    Unit "unit" Math "unit(v)" [form(&[value("v")], Vector(Dimension::NUMBER), "unit vector")],
    Dir "dir" Math "dir(velocity(C))" [
        form(&[value("v")], Number(Dimension::ANGLE), "direction of a vector"),
        form(&[L], Vector(Dimension::NUMBER), "unit vector along the x axis of a link"),
    ],
    Max "max" Math "max(a, b)" [
        form(&[value("a"), value("b")], Varies("that of the values"), "greatest of two or more values"),
        form(&[X, AFTER, BEFORE], OF_X, "greatest value over the sweep, see Cycles"),
    ],
    Min "min" Math "min(a, b)" [
        form(&[value("a"), value("b")], Varies("that of the values"), "least of two or more values"),
        form(&[X, AFTER, BEFORE], OF_X, "least value over the sweep, see Cycles"),
    ],
    Slope "slope" Math "slope(p(x))" [form(
        &[value("p(x)")],
        Varies("that of p over that of x"),
        "derivative of a curve by its argument",
    )],
    Position "position" Motion "position(rod.C)" [
        form(&[P], Vector(Dimension::LENGTH), "position of a point; of a slider a signed number"),
        form(&[L, KP], Vector(Dimension::LENGTH), "of the point of L that coincides with K.P now"),
    ],
    Velocity "velocity" Motion "velocity(rod.C)" [
        form(&[P], Vector(Dimension::VELOCITY), "velocity of a point; of a slider a signed number"),
        form(&[L, KP], Vector(Dimension::VELOCITY), "of the point of L that coincides with K.P now"),
    ],
    Acceleration "acceleration" Motion "acceleration(rod.C)" [
        form(&[P], Vector(Dimension::ACCELERATION), "acceleration of a point; of a slider a signed number"),
        form(&[L, KP], Vector(Dimension::ACCELERATION), "of the point of L that coincides with K.P now"),
    ],
    Jerk "jerk" Motion "jerk(rod.C)" [
        form(&[P], Vector(Dimension::JERK), "rate of the acceleration of a point"),
        form(&[L, KP], Vector(Dimension::JERK), "of the point of L that coincides with K.P now"),
        form(&[J], Varies("length per time³"), "third rate of the coordinate along a line"),
    ],
    Distance "distance" Motion "distance(A, rod.C)" [form(
        &[arg("A", Takes::Point), arg("B", Takes::Point)],
        Number(Dimension::LENGTH),
        "between two points",
    )],
    InstantCentre "instant_centre" Motion "instant_centre(rod)" [
        form(&[L], Vector(Dimension::LENGTH), "the point of L at rest now"),
        form(
            &[L, arg("K", Takes::Link)],
            Vector(Dimension::LENGTH),
            "where L and K have the same velocity now",
        ),
    ],
    Angle "angle" Motion "angle(rod)" [form(&[L], Number(Dimension::ANGLE), "direction of the x axis")],
    Omega "omega" Motion "omega(rod)"
        [form(&[L], Number(Dimension::ANGULAR_VELOCITY), "angular velocity")],
    Alpha "alpha" Motion "alpha(rod)"
        [form(&[L], Number(Dimension::ANGULAR_ACCELERATION), "angular acceleration")],
    AngularJerk "angular_jerk" Motion "angular_jerk(rod)"
        [form(&[L], Number(Dimension::ANGULAR_JERK), "rate of the angular acceleration")],
    Displacement "displacement" Motion "displacement(D)" [form(
        &[J],
        COORDINATE,
        "coordinate of the pair; of a contact with `parts` its gap",
    )],
    RelativeVelocity "relative_velocity" Motion "relative_velocity(D)"
        [form(&[J], Varies("that of the coordinate per time"), "rate of the coordinate")],
    RelativeAcceleration "relative_acceleration" Motion "relative_acceleration(D)"
        [form(&[J], Varies("that of the coordinate per time²"), "second rate of the coordinate")],
    Coriolis "coriolis" Motion "coriolis(D)"
        [form(&[J], Vector(Dimension::ACCELERATION), "Coriolis acceleration in the pair")],
    SlipSpeed "slip_speed" Motion "slip_speed(D)" [form(
        &[J],
        Number(Dimension::VELOCITY),
        "magnitude of the sliding velocity in a guide, slot or contact",
    )],
    Travel "travel" Motion "travel(D)" [form(&[J], COORDINATE, "coordinate above its least value")],
    Stroke "stroke" Cycle "stroke(D)" [form(&[J], COORDINATE, "greatest minus least coordinate")],
    TimeRatio "time_ratio" Cycle "time_ratio(D)"
        [form(&[J], Number(Dimension::NUMBER), "ratio of the longer to the shorter drive travel")],
    Dead "dead" Cycle "dead(D, 1)" [form(
        &[J, arg("1", Takes::OneOrTwo)],
        OF_DRIVE,
        "drive value at the least coordinate, with 2 at the greatest",
    )],
    TransmissionAngle "transmission_angle" Motion "transmission_angle(bc)"
        [form(&[arg("group", Takes::Group)], Number(Dimension::ANGLE), "of a named group")],
    PressureAngle "pressure_angle" Motion "pressure_angle(K)" [
        form(
            &[J],
            Number(Dimension::ANGLE),
            "between the normal and the path of the follower's point (centre of its circle), also at rest",
        ),
        form(&[CAM, PHI], Number(Dimension::ANGLE), "of a designed cam, see Cams"),
    ],
    Reaction "reaction" Force "reaction(B, rod)"
        [form(&[J, ON], Vector(Dimension::FORCE), "force on L")],
    Moment "moment" Force "moment(D, piston)"
        [form(&[J, ON], Number(Dimension::TORQUE), "couple on L about the pair's reference point; in a contact that of its rolling resistance")],
    Axial "axial" Force "axial(bar)"
        [form(&[L], Number(Dimension::FORCE), "force along a link of two hinges; tension is positive")],
    Internal "internal" Force "internal(beam, 1.2 m).M" [
        form(
            &[L, X],
            Parts("force, force, torque"),
            "normal force `.N`, shear force `.Q` and bending moment `.M` at x along a link",
        ),
        form(
            &[L],
            Parts("force, force, torque"),
            "along the whole link: in `max`, `min`, `argmax`, `argmin`; in `find internal(L) in 12 steps` a table",
        ),
    ],
    Normal "normal" Force "normal(D, piston)" [form(
        &[J, ON],
        Number(Dimension::FORCE),
        "component on L along the left normal; for a contact along the common normal into L",
    )],
    Friction "friction" Force "friction(D, piston)" [form(
        &[J, ON],
        Number(Dimension::FORCE),
        "friction force on L along the line; for a contact perpendicular to the common normal",
    )],
    ContactForce "contact_force" Force "contact_force(D, 1)" [form(
        &[J, arg("1", Takes::OneOrTwo)],
        Number(Dimension::FORCE),
        "at the first of the ends given by `contacts`, with 2 at the second",
    )],
    LineOffset "line_offset" Force "line_offset(D)" [form(
        &[J],
        Number(Dimension::LENGTH),
        "point at which the resultant crosses the guide, as a coordinate of the pair",
    )],
    InertiaForce "inertia_force" Inertia "inertia_force(rod)"
        [form(&[L], Vector(Dimension::FORCE), "−m a of the mass centre")],
    InertiaTorque "inertia_torque" Inertia "inertia_torque(rod)"
        [form(&[L], Number(Dimension::TORQUE), "−J α")],
    InertiaArm "inertia_arm" Inertia "inertia_arm(rod)"
        [form(&[L], Number(Dimension::LENGTH), "magnitude of the torque divided by that of the force")],
    ShakingForce "shaking_force" Inertia "shaking_force()"
        [form(&[], Vector(Dimension::FORCE), "−Σ m a of all moving links: what their inertia does to the frame")],
    ShakingMoment "shaking_moment" Inertia "shaking_moment()" [
        form(&[], Number(Dimension::TORQUE), "−Σ (r × m a + J α) about the origin of the ground"),
        form(&[arg("P", Takes::Point)], Number(Dimension::TORQUE), "about a point of the ground"),
    ],
    RockingCouple "rocking_couple" Inertia "rocking_couple()" [
        form(&[], Vector(Dimension::TORQUE), "Σ z k × (−m a) of all masses in their planes z, about the plane 0"),
        form(
            &[arg("plane", Takes::Value(Some(Dimension::LENGTH)))],
            Vector(Dimension::TORQUE),
            "about another plane",
        ),
    ],
    Mass "mass" Inertia "mass(rod)" [
        form(&[L], Number(Dimension::MASS), "of a link"),
        form(&[], Number(Dimension::MASS), "of all moving links"),
    ],
    MassCentre "mass_centre" Inertia "mass_centre(rod)" [
        form(&[L], Vector(Dimension::LENGTH), "of a link, in the axes of the ground; also in `velocity` and `acceleration`"),
        form(&[], Vector(Dimension::LENGTH), "the common one of all moving links"),
    ],
    Inertia "inertia" Inertia "inertia(rod)" [
        form(&[L], Number(Dimension::INERTIA), "moment of inertia about the mass centre"),
        form(&[L, OWN], Number(Dimension::INERTIA), "about a point of the link"),
    ],
    StaticSubstitution "static_substitution" Inertia "static_substitution(rod, B, C).m1" [form(
        &[L, arg("B", Takes::OwnPoint), arg("C", Takes::OwnPoint)],
        Parts("see below"),
        "masses at B and C equivalent to the link; with a part",
    )],
    DynamicSubstitution "dynamic_substitution" Inertia "dynamic_substitution(rod, B).m1" [form(
        &[L, arg("B", Takes::OwnPoint)],
        Parts("see below"),
        "masses at B and a second point equivalent to the link; with a part",
    )],
    Effort "effort" Force "effort(crank)" [form(
        &[arg("D", Takes::Drive)],
        Varies("force or torque"),
        "effort of a drive if the file has no balance; of a free coordinate what its closed stops bear",
    )],
    Power "power" Force "power(Mb)"
        [form(&[arg("M", Takes::Effort)], Number(Dimension::POWER), "power of a load, balance or drive")],
    Speed "speed" Train "speed(A)"
        [form(&[SLIDER], Number(Dimension::VELOCITY), "magnitude of a slider's velocity")],
    Efficiency "efficiency" Friction "efficiency()"
        [form(&[], Number(Dimension::NUMBER), "ideal over actual effort, see Friction")],
    Stable "stable" Force "stable()"
        [form(&[], Condition, "whether the equilibrium is stable; needs `equilibrium`")],
    NaturalFrequency "natural_frequency" Force "natural_frequency(1)" [form(
        &[arg("1", Takes::Count)],
        Number(Dimension::ANGULAR_VELOCITY),
        "of a small vibration about the equilibrium without dampers; they rise",
    )],
    DampingRatio "damping_ratio" Force "damping_ratio(1)" [form(
        &[arg("1", Takes::Count)],
        Number(Dimension::NUMBER),
        "of the vibration with its dampers",
    )],
    DampedFrequency "damped_frequency" Force "damped_frequency(1)" [form(
        &[arg("1", Takes::Count)],
        Number(Dimension::ANGULAR_VELOCITY),
        "of the vibration with its dampers",
    )],
    Locked "locked" Friction "locked()" [form(&[], Condition, "self-locking, see Friction")],
    Critical "critical" Friction "critical(al)" [form(
        &[arg("al", Takes::Given)],
        Varies("that of the given"),
        "value of a `given` at which locking begins, see Friction",
    )],
    Profile "profile" Cam "profile(plate, 30 deg).point"
        [form(&[CAM, PHI], Parts("see Cams"), "profile and motion at a cam angle; with a part")],
    CurvatureRadius "curvature_radius" Cam "curvature_radius(plate, 30 deg)" [
        form(&[CAM, PHI], Number(Dimension::LENGTH), "radius of curvature, see Cams"),
        form(&[P], Number(Dimension::LENGTH), "of the path of a point, positive where it bends to the left"),
    ],
    CurvatureCentre "curvature_centre" Motion "curvature_centre(rod.C)"
        [form(&[P], Vector(Dimension::LENGTH), "centre of curvature of the path of a point")],
    Start "start" Cam "start(plate)" [form(
        &[CAM],
        COORDINATE,
        "position of the follower at lift zero: angle of its arm (face) against the line from pivot to centre, or distance of its tip (face) along its path",
    )],
    SmallestBaseRadius "smallest_base_radius" Cam "smallest_base_radius(plate, 30 deg)" [form(
        &[CAM, arg("30 deg", Takes::Angle)],
        Number(Dimension::LENGTH),
        "least base radius at which no pressure angle exceeds this one",
    )],
    Table "table" Gear "table(z12).da1"
        [form(&[MESH], Parts("see Gear pairs"), "geometry of a pair of gears; with a part")],
    ToothForce "tooth_force" Gear "tooth_force(z12, 100 N*m).Ft" [form(
        &[MESH, value_of("M", Dimension::TORQUE)],
        Parts("force"),
        "forces between the teeth for a torque on wheel 1; with a part",
    )],
    SlidingVelocity "sliding_velocity" Gear "sliding_velocity(z12, 20 rad/s).v1" [form(
        &[MESH, value_of("omega", Dimension::ANGULAR_VELOCITY)],
        Parts("velocity"),
        "sliding at the tips for a speed of wheel 1; with a part",
    )],
    ContactRatio "contact_ratio" Gear "contact_ratio(z12)"
        [form(&[MESH], Number(Dimension::NUMBER), "contact ratio of a pair of gears")],
    Time "time" Simulation "time(top, 2)" [form(
        &[EVENT, WHICH],
        Number(Dimension::TIME),
        "instant of an event, of the first or of another one",
    )],
    Drive "drive" Simulation "drive(top, 2)" [form(
        &[EVENT, WHICH],
        OF_DRIVE,
        "value of the drive at an event of a sweep, at the first or at another one",
    )],
    Count "count" Simulation "count(top)"
        [form(&[EVENT], Number(Dimension::NUMBER), "how often an event happens")],
    KineticEnergy "kinetic_energy" Simulation "kinetic_energy()"
        [form(&[], Number(Dimension::TORQUE), "of all links")],
    PotentialEnergy "potential_energy" Simulation "potential_energy()"
        [form(&[], Number(Dimension::TORQUE), "of weights, from y = 0, and of springs, from their free lengths and angles")],
    Energy "energy" Simulation "energy()"
        [form(&[], Number(Dimension::TORQUE), "kinetic and potential energy together")],
    Period "period" Simulation "period()"
        [form(&[], Number(Dimension::TIME), "of a steady motion: after what time it repeats")],
    Sticks "sticks" Simulation "sticks(P)"
        [form(&[J], Condition, "the pair is held by friction")],
    Rests "rests" Simulation "rests(G)"
        [form(&[J], Condition, "a stop of the pair is closed")],
    Impulse "impulse" Simulation "impulse(G)" [form(
        &[J],
        Varies("force or torque × time"),
        "what stops of the pair, or a contact that parts, give in an impact at this instant",
    )],
    Fluctuation "fluctuation" Flywheel "fluctuation(J)"
        [form(&[F], Number(Dimension::TORQUE), "of a flywheel: greatest minus least work")],
    Rim "rim" Flywheel "rim(J).width" [form(
        &[F],
        Parts("length, length, mass"),
        "rim of a flywheel; with `.width`, `.height` or `.mass`",
    )],
    Work "work" Flywheel "work(J)" [
        form(&[F], Number(Dimension::TORQUE), "work of the torque minus its mean, from the first pose"),
        form(
            &[arg("k", Takes::Effort)],
            Number(Dimension::TORQUE),
            "of a load or a spring, since the first instant of a motion under loads",
        ),
    ],
    FrictionWork "friction_work" Simulation "friction_work()" [form(
        &[optional(J)],
        Number(Dimension::TORQUE),
        "of friction in all pairs, or in one, since the first instant: not positive",
    )],
    ReducedTorque "reduced_torque" Flywheel "reduced_torque(J)"
        [form(&[F], Number(Dimension::TORQUE), "the torque, reduced to the flywheel's shaft")],
    ReducedInertia "reduced_inertia" Flywheel "reduced_inertia(J)" [form(
        &[F],
        Number(Dimension::INERTIA),
        "moment of inertia of all moving links, reduced to the flywheel's shaft",
    )],
    Radius "radius" Train "radius(w1)" [form(
        &[arg("w", Takes::Wheel)],
        Number(Dimension::LENGTH),
        "of a wheel, of a gear wheel that of its pitch circle",
    )],
    TangentialForce "tangential_force" Train "tangential_force(k)"
        [form(&[J, ON], Number(Dimension::FORCE), "of a mesh, rack, belt, chain or worm; with L that on L")],
    NormalForce "normal_force" Train "normal_force(k)"
        [form(&[J, ON], Number(Dimension::FORCE), "along the line of action of a mesh or rack; with L that on L")],
    Tension "tension" Train "tension(a)" [form(
        &[arg("a", Takes::Rope), optional(arg("A", Takes::RopeEnd))],
        Number(Dimension::FORCE),
        "pull in a rope; with A at that end of it",
    )],
    TightSide "tight_side" Train "tight_side(b)" [form(
        &[arg("b", Takes::Pair)],
        Number(Dimension::FORCE),
        "pull in the tight side of a belt: with its pretension, or the least with which it does not slip",
    )],
    SlackSide "slack_side" Train "slack_side(b)"
        [form(&[arg("b", Takes::Pair)], Number(Dimension::FORCE), "pull in the slack side of a belt")],
    Wrap "wrap" Train "wrap(b)" [form(
        &[arg("b", Takes::Pair)],
        Number(Dimension::ANGLE),
        "angle of contact of a belt with friction, on the smaller pulley",
    )],
    Capacity "capacity" Train "capacity(k)" [form(
        &[arg("k", Takes::Pair)],
        Varies("torque or force"),
        "greatest torque of a clutch, greatest tangential force of a belt with a pretension",
    )],
    Slips "slips" Train "slips(k)"
        [form(&[arg("k", Takes::Pair)], Condition, "a clutch or belt must transmit more than its capacity; a clutch with `slipping` slips")],
    Frictionless "frictionless" Friction "frictionless(Mb)" [form(&[X], OF_X, "x without friction")],
    Mean "mean" Cycle "mean(Mb)" [form(&[X, AFTER, BEFORE], OF_X, "mean over the sweep, see Cycles")],
    Integral "integral" Cycle "integral(Mb)" [form(
        &[X, AFTER, BEFORE],
        Varies("that of x times that of the drive"),
        "over the drive's value along the sweep",
    )],
    Fourier "fourier" Cycle "fourier(Mb, 2).amplitude" [
        form(
            &[X, arg("2", Takes::Order)],
            Parts("that of x; an angle"),
            "term of order 2 of the Fourier series over whole turns, see Cycles; with a part",
        ),
        form(&[X], Parts("that of x; an angle"), "in `find fourier(Mb) in 8 steps`: a table of the orders 1 to 8"),
    ],
    Argmax "argmax" Cycle "argmax(Mb)"
        [form(&[X, AFTER, BEFORE], OF_DRIVE, "value of the drive where x is greatest")],
    Argmin "argmin" Cycle "argmin(Mb)"
        [form(&[X, AFTER, BEFORE], OF_DRIVE, "value of the drive where x is least")],
    JournalTorque "journal_torque" Bearing "journal_torque(load = 5 kN, radius = 40 mm, friction = 0.1)"
        [form(&[LOAD, RADIUS, COEFFICIENT, FIT], Number(Dimension::TORQUE), "friction torque of a journal, k f F r")],
    ThrustTorque "thrust_torque" Bearing "thrust_torque(load = 5 kN, outer = 40 mm, inner = 0, friction = 0.1)" [form(
        &[LOAD, OUTER, INNER, COEFFICIENT, FIT],
        Number(Dimension::TORQUE),
        "friction torque of a thrust bearing",
    )],
    BeltRatio "belt_ratio" Bearing "belt_ratio(friction = 0.3, wrap = 170 deg)" [form(
        &[COEFFICIENT, WRAP, GROOVE],
        Number(Dimension::NUMBER),
        "ratio of the pulls of a belt or rope about to slip, e^(f θ / sin γ) with the half-angle γ of a V-groove",
    )],
    RaisingTorque "raising_torque" Bearing "raising_torque(load = 5 kN, diameter = 22 mm, lead = 5 mm, friction = 0.1)" [form(
        &[LOAD, DIAMETER, LEAD, COEFFICIENT, FLANK],
        Number(Dimension::TORQUE),
        "torque on a screw that raises a load, F d/2 tan(λ + ρ), tan ρ = f / cos flank",
    )],
    LoweringTorque "lowering_torque" Bearing "lowering_torque(load = 5 kN, diameter = 22 mm, lead = 5 mm, friction = 0.1)" [form(
        &[LOAD, DIAMETER, LEAD, COEFFICIENT, FLANK],
        Number(Dimension::TORQUE),
        "torque that lowers it, F d/2 tan(ρ − λ); below zero the screw is not self-locking",
    )],
}

// The letters of what they ask, as books have them.

/// The index of a letter: its arguments, the first of them behind something, or one of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    All,
    /// The first argument alone, behind this.
    Behind(&'static str),
    Own(&'static str),
}

/// The letter of what is asked of a part of the mechanism, and what its index is.
#[must_use]
pub fn letter_of(function: &str) -> Option<(&'static str, Index)> {
    use Index::{All, Behind, Own};
    Some(match function {
        "omega" => ("ω", All),
        "alpha" => ("α", All),
        "angle" => ("φ", All),
        "velocity" => ("v", All),
        "acceleration" => ("a", All),
        "jerk" => ("j", All),
        "angular_jerk" => ("ζ", All),
        "position" => ("r", All),
        "relative_velocity" | "slip_speed" => ("v", All),
        "relative_acceleration" => ("a", All),
        "displacement" => ("s", All),
        "stroke" => ("H", All),
        "time_ratio" => ("K", All),
        "pressure_angle" => ("α", All),
        "transmission_angle" => ("μ", All),
        "contact_ratio" => ("ε", All),
        "axial" => ("N", All),
        "reaction" => ("R", All),
        "normal" => ("N", All),
        "moment" => ("M", All),
        "friction" => ("F", Behind("f")),
        "tangential_force" => ("F", Behind("t,")),
        "normal_force" => ("F", Behind("n,")),
        "tight_side" => ("F", Behind("1,")),
        "slack_side" => ("F", Behind("2,")),
        "tension" => ("S", Behind("")),
        "journal_torque" | "thrust_torque" => ("M", Own("f")),
        "efficiency" => ("η", Own("")),
        "kinetic_energy" => ("E", Own("k")),
        "potential_energy" => ("E", Own("p")),
        "energy" => ("E", Own("")),
        "period" => ("T", Own("")),
        "time" => ("t", All),
        "count" => ("n", All),
        "speed" => ("ω", All),
        "curvature_radius" => ("ρ", All),
        "power" => ("P", All),
        "radius" => ("r", All),
        "dir" => ("∠", All),
        "start" => ("s₀", All),
        "mass" => ("m", All),
        "mass_centre" => ("S", All),
        "inertia" => ("J", All),
        _ => return None,
    })
}
