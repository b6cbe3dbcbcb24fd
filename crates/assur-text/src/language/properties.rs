//! The properties, as data.

use super::{Dimension, JointKind};
use PropertyValue::{Any, Block, Flag, FlagOr, NotNegative, Positive, Two, Word};
use std::fmt;

const fn row(
    name: &'static str,
    takes: PropertyValue,
    example: &'static str,
    means: &'static str,
) -> Property {
    Property { name, takes, example, means }
}

const FRICTION: Property =
    row("friction", NotNegative(Dimension::NUMBER), "friction 0.1", "coefficient of friction");
const STATIC_FRICTION: Property = row(
    "static_friction",
    Positive(Dimension::NUMBER),
    "static_friction 0.4",
    "coefficient of friction at rest, in a motion under loads",
);
const FIT: Property = row(
    "fit",
    Word(&["line", "even", "worn"], Dimension::NUMBER),
    "fit even",
    "distribution of the pressure: the factor k, see Friction",
);
const EFFICIENCY: Property =
    row("efficiency", Positive(Dimension::NUMBER), "efficiency 0.98", "part of the power that is passed on");
const PRESSURE_ANGLE: Property =
    row("pressure_angle", Positive(Dimension::ANGLE), "pressure_angle 20 deg", "angle of the line of action");
const PHASE: Property = row(
    "phase",
    Any(Dimension::ANGLE),
    "phase 40 deg",
    "angle of the second wheel's link when that of the first is 0, both from the carrier",
);
const INTERNAL: Property = row("internal", Flag, "internal", "one is inside the other");

const BEVEL: Property = row(
    "bevel",
    FlagOr(&["far"]),
    "bevel",
    "bevel wheels: their axes meet; `bevel far` on the other side of the planet",
);

const REVOLUTE: &[Property] = &[
    row("radius", Positive(Dimension::LENGTH), "radius 20 mm", "radius of the pin"),
    FRICTION,
    STATIC_FRICTION,
    FIT,
    row(
        "friction_circle",
        NotNegative(Dimension::LENGTH),
        "friction_circle 3 mm",
        "radius of the friction circle",
    ),
    row(
        "equivalent_friction",
        NotNegative(Dimension::NUMBER),
        "equivalent_friction 0.18",
        "radius of the friction circle divided by that of the pin",
    ),
];

const PRISMATIC: &[Property] = &[
    row("angle", Any(Dimension::ANGLE), "angle 90 deg", "constant angle between slider and line"),
    row("contacts", Two(Dimension::LENGTH), "contacts -20 mm, 25 mm", "the two ends of the slider"),
    FRICTION,
    STATIC_FRICTION,
    row(
        "groove",
        Word(&["round"], Dimension::ANGLE),
        "groove 35 deg",
        "half-angle of a V-groove, or a round one",
    ),
    FIT,
];

const SLOT: &[Property] = &[
    FRICTION,
    STATIC_FRICTION,
    row(
        "slots",
        Positive(Dimension::NUMBER),
        "slots 4",
        "of a Geneva wheel, of which the line is one; an arc locks the wheel in between",
    ),
];
const RESTITUTION: Property = row(
    "restitution",
    NotNegative(Dimension::NUMBER),
    "restitution 0.7",
    "ratio of the speeds after and before an impact",
);
const CONTACT: &[Property] = &[
    FRICTION,
    STATIC_FRICTION,
    row(
        "rolling",
        NotNegative(Dimension::LENGTH),
        "rolling 0.5 mm",
        "arm of the rolling resistance: its couple is this arm times the normal force",
    ),
    INTERNAL,
    row(
        "parts",
        Flag,
        "parts",
        "in a motion it opens where it would have to transmit tension, and closes again",
    ),
    RESTITUTION,
];

const MESH: &[Property] = &[
    INTERNAL,
    BEVEL,
    EFFICIENCY,
    PRESSURE_ANGLE,
    PHASE,
    row("addendum", Positive(Dimension::NUMBER), "addendum 1", "of the basic rack, in modules"),
    row("clearance", NotNegative(Dimension::NUMBER), "clearance 0.25", "of the basic rack, in modules"),
    row("shift", Two(Dimension::NUMBER), "shift 0.3, -0.3", "profile shift of each wheel, in modules"),
];

const BELT: &[Property] = &[
    row("crossed", Flag, "crossed", "the belt reverses the sense of rotation"),
    EFFICIENCY,
    PHASE,
    FRICTION,
    row("wrap", Positive(Dimension::ANGLE), "wrap 165 deg", "angle of contact on the smaller pulley"),
    row("centre_distance", Positive(Dimension::LENGTH), "centre_distance 600 mm", "between the two axes"),
    row("groove", Positive(Dimension::ANGLE), "groove 19 deg", "half-angle of a V-groove"),
    row("pretension", Positive(Dimension::FORCE), "pretension 400 N", "pull on both sides at rest"),
    row(
        "slip",
        NotNegative(Dimension::NUMBER),
        "slip 2 %",
        "part of the speed that is lost, with the first wheel driving",
    ),
];
const CHAIN: &[Property] = &[EFFICIENCY, PHASE];
const LOSSES: &[Property] = &[EFFICIENCY];
const RACK: &[Property] = &[EFFICIENCY, PRESSURE_ANGLE];
const WORM: &[Property] =
    &[row("starts", Positive(Dimension::NUMBER), "starts 2", "number of starts"), EFFICIENCY];
const SCREW: &[Property] = &[
    row("lead", Any(Dimension::LENGTH), "lead 5 mm", "travel of the nut per turn"),
    EFFICIENCY,
    row("diameter", Positive(Dimension::LENGTH), "diameter 22 mm", "mean diameter of the thread"),
    FRICTION,
    row("friction_angle", NotNegative(Dimension::ANGLE), "friction_angle 6 deg", "instead of its tangent"),
    row("flank", NotNegative(Dimension::ANGLE), "flank 15 deg", "angle of the flank of the thread"),
];

const CAPACITY: Property = row(
    "capacity",
    Positive(Dimension::TORQUE),
    "capacity 40 N*m",
    "greatest torque, instead of what gives it",
);
const PRESSED: Property = row(
    "load",
    Positive(Dimension::FORCE),
    "load 2 kN",
    "force that presses the faces; pull on the slack end of a band",
);
const FACE_FRICTION: Property =
    row("friction", Positive(Dimension::NUMBER), "friction 0.3", "coefficient of friction");
const FACE_RADIUS: Property =
    row("radius", Positive(Dimension::LENGTH), "radius 150 mm", "at which the friction acts");
const OUTER: Property =
    row("outer", Positive(Dimension::LENGTH), "outer 120 mm", "outer radius of the faces");
const INNER: Property =
    row("inner", NotNegative(Dimension::LENGTH), "inner 80 mm", "inner radius of the faces");
const WORN: Property = row("worn", Flag, "worn", "pressure as after wear, otherwise even");
const FACES: Property = row("faces", Positive(Dimension::NUMBER), "faces 2", "number of faces that rub");
const CONE: Property = row("cone", Positive(Dimension::ANGLE), "cone 12 deg", "half-angle of a cone");

const CLUTCH: &[Property] = &[
    CAPACITY,
    PRESSED,
    FACE_FRICTION,
    FACE_RADIUS,
    OUTER,
    INNER,
    WORN,
    FACES,
    CONE,
    row(
        "slipping",
        Flag,
        "slipping",
        "friction alone joins the sides: it slips until their speeds are equal",
    ),
    row(
        "freewheel",
        FlagOr(&["ccw", "cw"]),
        "freewheel",
        "it slips, and the second side may turn ahead of the first, in this sense",
    ),
];

const WELD: &[Property] =
    &[row("angle", Any(Dimension::ANGLE), "angle 60 deg", "of the second link, less that of the first")];

/// The properties of a brake.
pub static BRAKE: &[Property] = &[
    CAPACITY,
    PRESSED,
    FACE_FRICTION,
    FACE_RADIUS,
    OUTER,
    INNER,
    WORN,
    FACES,
    CONE,
    row("wrap", Positive(Dimension::ANGLE), "wrap 270 deg", "angle of contact of a band"),
];

/// The properties of a spring.
pub static SPRING: &[Property] = &[
    row("stiffness", Positive(Dimension::STIFFNESS), "stiffness 4530 N/m", "force per elongation"),
    row("free_length", NotNegative(Dimension::LENGTH), "free_length 80 mm", "length without force"),
    row("damping", NotNegative(Dimension::DAMPING), "damping 20 N*s/m", "force per rate of elongation"),
];

/// The properties of a stop.
pub static STOP: &[Property] = &[RESTITUTION];

/// The properties of a spring in a revolute pair.
pub static TORSION_SPRING: &[Property] = &[
    row("stiffness", Positive(Dimension::TORQUE), "stiffness 20 N*m/rad", "torque per angle"),
    row("free_angle", Any(Dimension::ANGLE), "free_angle 30 deg", "angle of the pair without torque"),
    row(
        "damping",
        NotNegative(Dimension::ROTARY_DAMPING),
        "damping 0.5 N*m*s/rad",
        "torque per angular velocity",
    ),
];

/// The properties of a cam.
pub static CAM: &[Property] = &[
    row(
        "base_radius",
        Positive(Dimension::LENGTH),
        "base_radius 50 mm",
        "least radius of the pitch curve, or least distance of a flat face",
    ),
    row(
        "speed",
        Positive(Dimension::ANGULAR_VELOCITY),
        "speed 80 rpm",
        "speed of the cam, for rates by time of the design itself",
    ),
];

/// The properties of a follower.
pub static FOLLOWER: &[Property] = &[
    row("arm", Positive(Dimension::LENGTH), "arm 130 mm", "distance of its tip or roller from the pivot"),
    row(
        "pivot_distance",
        Positive(Dimension::LENGTH),
        "pivot_distance 140 mm",
        "distance of the pivot from the cam's centre",
    ),
    row("radius", Positive(Dimension::LENGTH), "radius 15 mm", "radius of the roller"),
    row("offset", Any(Dimension::LENGTH), "offset 10 mm", "distance of its path or face, see Cams"),
    row("with_cam", Flag, "with_cam", "the rise turns it in the sense of the cam"),
    row("against_cam", Flag, "against_cam", "the rise turns it against the cam"),
];

/// The properties of a counterweight.
pub static COUNTERWEIGHT: &[Property] = &[
    row("radius", Positive(Dimension::LENGTH), "radius 100 mm", "distance from the hinge; its mass is found"),
    row("mass", Positive(Dimension::MASS), "mass 180 kg", "its mass; its radius is found"),
    row("plane", Any(Dimension::LENGTH), "plane 100 mm", "its place along the axis"),
];

/// The properties of the rim of a flywheel.
pub static RIM: &[Property] = &[
    row("diameter", Positive(Dimension::LENGTH), "diameter 0.5 m", "at which its mass is taken"),
    row(
        "weight_density",
        Positive(Dimension::WEIGHT_DENSITY),
        "weight_density 7.0e4 N/m^3",
        "weight per volume; needs `gravity`",
    ),
    row("density", Positive(Dimension::DENSITY), "density 7200 kg/m^3", "mass per volume"),
    row(
        "height_to_width",
        Positive(Dimension::NUMBER),
        "height_to_width 1.5",
        "ratio of its height to its width",
    ),
];

/// The properties of a flywheel.
pub static FLYWHEEL: &[Property] = &[
    row(
        "fluctuation",
        Positive(Dimension::NUMBER),
        "fluctuation 1/30",
        "(greatest − least speed) / mean speed",
    ),
    row("rim", Block(RIM), "rim { diameter 0.5 m }", "the rim, to be sized"),
    row(
        "speed",
        Positive(Dimension::ANGULAR_VELOCITY),
        "speed 80 rpm",
        "mean speed of its shaft, if no drive gives it",
    ),
    row(
        "ratio",
        Positive(Dimension::NUMBER),
        "ratio 3",
        "speed of its shaft divided by that of the link named",
    ),
    row("with_links", Flag, "with_links", "the inertia of the moving links is included"),
];

/// The properties that a pair or a transmission may have.
#[must_use]
pub const fn properties_of_pair(kind: JointKind) -> &'static [Property] {
    match kind {
        JointKind::Revolute => REVOLUTE,
        JointKind::Prismatic => PRISMATIC,
        JointKind::Slot => SLOT,
        JointKind::Contact => CONTACT,
        JointKind::Cylinder => &[],
        JointKind::Mesh => MESH,
        JointKind::Belt => BELT,
        JointKind::Chain => CHAIN,
        JointKind::Rope => LOSSES,
        JointKind::Rack => RACK,
        JointKind::Worm => WORM,
        JointKind::Screw => SCREW,
        JointKind::Clutch => CLUTCH,
        JointKind::Weld => WELD,
    }
}

/// All properties, by the word before their braces.
pub static PROPERTIES: &[(&str, &[Property])] = &[
    ("revolute", REVOLUTE),
    ("prismatic", PRISMATIC),
    ("slot", SLOT),
    ("contact", CONTACT),
    ("weld", WELD),
    ("mesh", MESH),
    ("rope", LOSSES),
    ("belt", BELT),
    ("chain", CHAIN),
    ("rack", RACK),
    ("worm", WORM),
    ("screw", SCREW),
    ("clutch", CLUTCH),
    ("brake", BRAKE),
    ("spring", SPRING),
    ("spring … in", TORSION_SPRING),
    ("stop", STOP),
    ("cam", CAM),
    ("follower", FOLLOWER),
    ("counterweight", COUNTERWEIGHT),
    ("flywheel", FLYWHEEL),
    ("rim", RIM),
];

// Rows of the tables of properties.

/// A property that a statement may have in its braces.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    pub name: &'static str,
    /// The values after it.
    pub takes: PropertyValue,
    pub example: &'static str,
    /// Its meaning, in one sentence without its full stop.
    pub means: &'static str,
}

/// The values of a property.
#[derive(Clone, Copy, Debug)]
pub enum PropertyValue {
    Flag,
    /// Nothing, or one of these words.
    FlagOr(&'static [&'static str]),
    /// A value of this dimension.
    Any(Dimension),
    /// A value greater than zero.
    Positive(Dimension),
    /// A value not less than zero.
    NotNegative(Dimension),
    Two(Dimension),
    /// One of these words, or a value greater than zero.
    Word(&'static [&'static str], Dimension),
    /// Properties of its own.
    Block(&'static [Property]),
}

impl fmt::Display for PropertyValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag => f.write_str("no value"),
            Self::FlagOr(words) => write!(f, "no value, or `{}`", words.join("`, `")),
            Self::Any(dimension) => write!(f, "{dimension}"),
            Self::Positive(dimension) => write!(f, "{dimension} > 0"),
            Self::NotNegative(dimension) => write!(f, "{dimension} ≥ 0"),
            Self::Two(dimension) => write!(f, "two values, each {dimension}"),
            Self::Word(words, dimension) => {
                let words = words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ");
                write!(f, "{words} or {dimension} > 0")
            }
            Self::Block(_) => f.write_str("properties of its own"),
        }
    }
}
