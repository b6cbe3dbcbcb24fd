//! The words of the language, by where they may be written.

use super::{LAWS, PAIRS};

/// A word with what it is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// As it is written.
    pub word: &'static str,
    /// Its purpose, in one sentence without its full stop.
    pub means: &'static str,
    /// A line that can be read; empty for a word that only connects others.
    pub example: &'static str,
}

/// The place of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// At the head of a statement.
    Statement,
    /// At the head of a statement, and after `all`: a pair or a transmission.
    Pair,
    /// At the head of a member of a link.
    Member,
    /// At the head of a member of a cam.
    CamMember,
    /// Behind the angle of a phase of a cam.
    Law,
    /// Between other words; it cannot be a name.
    Connecting,
    /// Behind the value of a mass; it may be a name elsewhere.
    Shape,
    /// Between other words; it may be a name elsewhere.
    Contextual,
}

/// All words by their places.
pub static WORDS: &[(Place, &[Word])] = &[
    (Place::Statement, STATEMENTS),
    (Place::Pair, PAIRS),
    (Place::Member, MEMBERS),
    (Place::CamMember, CAM_MEMBERS),
    (Place::Law, LAWS),
    (Place::Connecting, CONNECTING),
    (Place::Shape, SHAPES),
    (Place::Contextual, CONTEXTUAL),
];

/// The words of a place, in the order of its table.
pub fn words_of(place: Place) -> impl Iterator<Item = &'static str> {
    let tables = WORDS.iter().filter(move |(at, _)| *at == place);
    tables.flat_map(|(_, table)| table.iter()).map(|row| row.word)
}

const fn row(word: &'static str, means: &'static str, example: &'static str) -> Word {
    Word { word, means, example }
}

const fn small(word: &'static str, means: &'static str) -> Word {
    row(word, means, "")
}

/// The words that begin a statement, apart from pairs.
pub static STATEMENTS: &[Word] = &[
    row("mech", "the edition of the language", "mech 1"),
    row("mechanism", "the title", "mechanism \"Engine crank-slider\""),
    row("given", "a given value, which `--set` may replace", "given r = 100 mm"),
    row("let", "a computed value", "let l = 3.5 * r"),
    row("gravity", "the acceleration of free fall, downwards", "gravity 9.81 m/s^2"),
    row("ground", "the fixed link", "ground { A (0, 0); line guide through A along 0 deg }"),
    row("link", "a rigid link", "link rod B-C 350 mm { S (100 mm, 0); mass 2.5 kg at S }"),
    row("shaft", "a link that turns on the ground or on a carrier", "shaft I { wheel w1 radius 0.2 m }"),
    row("slider", "a link that moves along a line", "slider A"),
    row(
        "spring",
        "a spring with a damper between two points",
        "spring k: ground.C - bar.D { stiffness 4530 N/m; free_length 77.85 mm }",
    ),
    row("all", "properties of every pair of a kind", "all revolute { friction_circle 5 mm }"),
    row("group", "a structural group, asserted and named", "group rod_piston: rod, piston"),
    row("drive", "a motion that is given", "drive crank = 0 deg .. 360 deg in 12 steps at 80 rpm"),
    row("pose", "one more position, with a name", "pose 4' at crank = 90 deg"),
    row("assemble", "the choice of an assembly", "assemble C left of B-D"),
    row("balance", "an unknown force or torque", "balance torque Mb on crank"),
    row("force", "a force that acts", "force P on ram at E = 1000 N @ 180 deg"),
    row("torque", "a torque that acts", "torque M on rocker = 60 N*m cw"),
    row("brake", "a friction torque against the motion", "brake M on drum { capacity 40 N*m }"),
    row(
        "cam",
        "the design of a plate cam",
        "cam plate { base_radius 50 mm; turning cw; rise 60 deg through 18 deg parabolic }",
    ),
    row(
        "curve",
        "a function from a table of values",
        "curve p periodic { then a header and rows, each on a line of its own }",
    ),
    row(
        "counterweight",
        "a mass to be found that balances a link",
        "counterweight X on rotor { radius 100 mm; plane 100 mm }",
    ),
    row("flywheel", "a flywheel to be sized", "flywheel J on O1 for Mb { fluctuation 1/30 }"),
    row("find", "the answers wanted", "find v_C = velocity(C) as m/s"),
    row("expect", "an answer that is expected", "expect Mb = 26 N*m within 1 %"),
    row(
        "variants",
        "a table of values, a problem per row",
        "variants { then a header and rows, each on a line of its own }",
    ),
    row("start", "the state that motion under loads starts from", "start OF = 5 deg at 0 rad/s"),
    row("equilibrium", "a position in which no effort is needed", "equilibrium bar near 60 deg"),
    row("simulate", "the time of motion under loads", "simulate 0 s .. 2 s in 200 steps within 1e-9"),
    row("event", "an instant at which something happens", "event top: omega(bar) = 0 rad/s"),
    row("until", "where motion under loads ends", "until angle(crank) = 360 deg"),
    row(
        "stop",
        "a bound of a pair's coordinate in a motion under loads",
        "stop G > 0 mm { restitution 0.7 }",
    ),
    row("ignore", "an effect that is left out", "ignore inertia"),
];

/// The words that begin a member of a link, unless it is a point.
pub static MEMBERS: &[Word] = &[
    row("line", "a directed line of the link", "line guide through A along 0 deg"),
    row("circle", "a circular profile", "circle roller centre D radius 15 mm"),
    row("profile", "the profile of a designed cam", "profile rim of plate centre O"),
    row("mass", "mass, with the mass centre", "mass 2.5 kg at S"),
    row("weight", "mass by its weight", "weight 21 N at C"),
    row("plane", "the place of all masses along the axis", "plane 250 mm"),
    row("inertia", "moment of inertia", "inertia 0.0425 kg*m^2"),
    row("wheel", "a wheel, pulley or drum", "wheel z1 teeth 18 module 16 mm"),
];

/// The words that begin a member of a cam, unless it is a property.
pub static CAM_MEMBERS: &[Word] = &[
    row("turning", "the sense in which the cam turns", "turning cw"),
    row("follower", "the follower", "follower translating roller { radius 15 mm }"),
    row("rise", "a phase of rising", "rise 60 deg through 18 deg parabolic"),
    row("dwell", "a phase of rest", "dwell 10 deg"),
    row("fall", "a phase of falling", "fall 60 deg parabolic"),
    row("lift", "a phase by a table of the lift", "lift along law"),
];

/// The connecting words, which are reserved.
pub static CONNECTING: &[Word] = &[
    small("accelerating", "before the acceleration of a drive"),
    small("against", "before `motion`: opposite to the velocity"),
    small("along", "before a direction"),
    small("and", "both conditions are true"),
    small("as", "before the unit of an answer"),
    small("at", "before a point, a speed or a position"),
    small("between", "reserved"),
    small("ccw", "counter-clockwise"),
    small("cw", "clockwise"),
    small("for", "before the effort that a flywheel evens out"),
    small("from", "before a point from which a distance is taken"),
    small("in", "before a pair, a link whose axes are meant, or a number of steps"),
    small("module", "before the module of a gear wheel"),
    small("moving", "before `forward` or `back`"),
    small("near", "before the position that chooses an assembly"),
    small("not", "the condition is false"),
    small("of", "joins a name and its owner"),
    small("on", "before the link on which a load acts"),
    small("or", "at least one of the conditions is true"),
    small("steps", "after the number of steps"),
    small("through", "before the point of a line, or the lift of a phase"),
    small("to", "before the second point of a line"),
    small("turning", "before `cw` or `ccw`"),
    small("when", "before the condition of a load"),
    small("within", "before a tolerance"),
];

/// How a mass is spread, and the sizes of its shape.
pub static SHAPES: &[Word] = &[
    row("rod", "along the line between two points", "mass 3 kg rod A to B"),
    row("disc", "between an inner radius, if any, and a radius", "mass 12 kg disc centre A radius 0.3 m"),
    row("ring", "along a circle", "mass 8 kg ring centre A radius 0.3 m"),
    row("sphere", "a ball", "mass 6 kg sphere centre A radius 110 mm"),
    row("plate", "over a polygon", "mass 16 kg/m^2 plate A, B, C"),
    row(
        "inner",
        "before the radius of the hole of a disc",
        "mass 12 kg disc centre A radius 0.3 m inner 50 mm",
    ),
    row(
        "thickness",
        "before that of a disc or plate, with a mass per volume",
        "mass 7850 kg/m^3 plate A, B, C thickness 20 mm",
    ),
    row(
        "section",
        "before the area of a rod or ring, with a mass per volume",
        "mass 7850 kg/m^3 rod A to B section 300 mm^2",
    ),
];

/// Connecting words that are not reserved.
pub static CONTEXTUAL: &[Word] = &[
    small("about", "before the point that a moment of inertia is about"),
    small("ahead", "before `of`: further along the guide"),
    small("behind", "further back along the guide"),
    small("centre", "before the centre of a circle or profile"),
    small("diameter", "before the diameter of a wheel"),
    small("forward", "along the positive sense of a pair"),
    small("back", "against the positive sense of a pair"),
    small("cycle", "after `steady`: from one event to the next"),
    small("falling", "an event counts where its value falls"),
    small("held", "a curve keeps its end values beyond its table"),
    small("left", "to the left, seen along the direction; of a force, to the left of the page"),
    small("linear", "a curve of straight lines"),
    small("right", "to the right, seen along the direction; of a force, to the right of the page"),
    small("up", "the direction of a force"),
    small("down", "the direction of a force"),
    small("step", "before the size of a step"),
    small("motion", "after `against`"),
    small("over", "a rope over an idler"),
    small("periodic", "a curve that begins again after its last point"),
    small("phase", "before the angle between two wheels"),
    small("radius", "before the radius of a circle or wheel"),
    small("rising", "an event counts where its value rises"),
    small("smooth", "a curve with continuous second derivative"),
    small("steady", "a motion that repeats"),
    small("teeth", "before the number of teeth"),
    small("turn", "after `steady`: a turn of a link"),
    small("turns", "after `steady` and their number"),
    small("under", "a rope under a movable pulley"),
];
