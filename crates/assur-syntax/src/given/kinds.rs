//! The kinds of data, as a table.

use GivenLevel::{Accelerations, Forces, Positions, Velocities};

/// From which questions on a datum counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum GivenLevel {
    Positions,
    Velocities,
    Accelerations,
    /// Forces, masses, energies.
    Forces,
}

/// A kind of datum. Its words have the same key.
#[derive(Debug, PartialEq, Eq)]
pub struct GivenKind {
    pub key: &'static str,
    /// The usual letter, with what its index begins with after a `_`; empty where it has none.
    pub letter: &'static str,
    pub level: GivenLevel,
    /// The letter is always indexed; of others only where a sheet has several of that letter.
    pub indexed: bool,
    /// It is said with the datum before it.
    pub after: bool,
}

impl GivenKind {
    /// The kind of that key.
    #[must_use]
    pub fn named(key: &str) -> Option<&'static Self> {
        KINDS.iter().find(|kind| kind.key == key)
    }

    /// The kind of a property of a block, such as `brake`.
    #[must_use]
    pub fn of_property(block: &str, property: &str) -> Option<&'static Self> {
        let of = |block: &str| Self::named(&format!("{block}.{property}"));
        let faces = || if matches!(block, "clutch" | "brake") { of("face") } else { None };
        of(block).or_else(faces).or_else(|| Self::named(property))
    }
}

const fn row(key: &'static str, letter: &'static str, level: GivenLevel) -> GivenKind {
    GivenKind { key, letter, level, indexed: false, after: false }
}

const fn indexed(key: &'static str, letter: &'static str, level: GivenLevel) -> GivenKind {
    GivenKind { indexed: true, ..row(key, letter, level) }
}

const fn after(key: &'static str, letter: &'static str, level: GivenLevel) -> GivenKind {
    GivenKind { after: true, ..row(key, letter, level) }
}

/// All kinds.
pub static KINDS: &[GivenKind] = &[
    row("gravity", "g", Forces),
    row("point", "", Positions),
    row("point.polar", "", Positions),
    row("point.from", "", Positions),
    indexed("bar", "l", Positions),
    row("line.along", "λ", Positions),
    row("circle.radius", "r", Positions),
    indexed("mass", "m", Forces),
    row("mass.density", "ρ", Forces),
    indexed("weight", "G", Forces),
    after("mass.at", "", Forces),
    after("rod", "", Forces),
    after("disc", "", Forces),
    after("ring", "", Forces),
    after("sphere", "", Forces),
    after("plate", "", Forces),
    after("inner", "", Forces),
    after("thickness", "", Forces),
    after("section", "", Forces),
    indexed("inertia", "J", Forces),
    row("plane", "z", Forces),
    indexed("wheel.radius", "r", Positions),
    indexed("wheel.diameter", "d", Positions),
    indexed("wheel.teeth", "z", Positions),
    row("wheel.module", "m", Positions),
    indexed("revolute.radius", "r", Forces),
    indexed("friction", "f", Forces),
    indexed("static_friction", "f_0", Forces),
    row("fit.line", "", Forces),
    row("fit.even", "", Forces),
    row("fit.worn", "", Forces),
    indexed("fit", "k", Forces),
    indexed("friction_circle", "ρ", Forces),
    indexed("equivalent_friction", "f", Forces),
    indexed("prismatic.angle", "δ", Positions),
    row("contacts", "", Forces),
    indexed("prismatic.groove", "β", Forces),
    indexed("slots", "z", Positions),
    row("internal", "", Positions),
    row("mesh.internal", "", Positions),
    row("bevel", "", Positions),
    after("bevel.far", "", Positions),
    indexed("efficiency", "η", Forces),
    row("pressure_angle", "α", Positions),
    indexed("phase", "ψ", Positions),
    row("addendum", "h", Positions),
    row("clearance", "c", Positions),
    row("shift", "x", Positions),
    row("crossed", "", Positions),
    row("wrap", "α", Forces),
    row("centre_distance", "a", Positions),
    row("belt.groove", "β", Forces),
    row("pretension", "F", Forces),
    row("slip", "s", Positions),
    row("starts", "z", Positions),
    row("lead", "h", Positions),
    row("screw.diameter", "d", Forces),
    row("friction_angle", "φ", Forces),
    row("flank", "β", Forces),
    row("capacity", "M", Forces),
    row("band.load", "F", Forces),
    row("outer", "R", Forces),
    row("worn", "", Forces),
    row("faces", "z", Forces),
    row("cone", "γ", Forces),
    row("slipping", "", Forces),
    row("weld.angle", "δ", Positions),
    indexed("stiffness", "c", Forces),
    indexed("free_length", "l_0", Forces),
    indexed("free_angle", "φ_0", Forces),
    indexed("damping", "k", Forces),
    row("restitution", "e", Forces),
    row("cam.base_radius", "r_0", Positions),
    row("cam.speed", "n", Velocities),
    row("cam.turning", "", Positions),
    row("follower", "", Positions),
    row("arm", "l", Positions),
    row("pivot_distance", "a", Positions),
    row("follower.radius", "r_r", Positions),
    row("offset", "e", Positions),
    row("with_cam", "", Positions),
    row("against_cam", "", Positions),
    indexed("rise", "Φ", Positions),
    indexed("dwell", "Φ", Positions),
    indexed("fall", "Φ", Positions),
    GivenKind { indexed: true, ..after("through", "h", Positions) },
    row("lift", "", Positions),
    indexed("counterweight.radius", "r", Forces),
    indexed("counterweight.mass", "m", Forces),
    indexed("counterweight.plane", "z", Forces),
    row("fluctuation", "δ", Forces),
    row("rim.diameter", "D", Forces),
    row("weight_density", "γ", Forces),
    row("density", "ρ", Forces),
    row("height_to_width", "k", Forces),
    row("flywheel.speed", "n", Forces),
    row("ratio", "i", Forces),
    row("with_links", "", Forces),
    indexed("drive.at", "n", Velocities),
    indexed("drive.accelerating", "ε", Accelerations),
    row("force", "F", Forces),
    row("torque", "M", Forces),
    row("distributed", "q", Forces),
    after("force.place", "", Forces),
    after("against", "", Forces),
    after("when", "", Forces),
    indexed("balance.along", "", Forces),
    row("steady", "", Positions),
    row("equilibrium.rate", "", Velocities),
    row("face.load", "F", Forces),
    row("face.radius", "r", Forces),
    row("face.inner", "r", Forces),
    row("groove.round", "", Forces),
    row("stop", "", Forces),
    indexed("rolling", "δ", Forces),
    row("parts", "", Forces),
    row("freewheel", "", Forces),
    after("freewheel.turn", "", Forces),
    after("law", "", Positions),
    indexed("drive.position", "φ", Positions),
    after("drive.sense", "", Velocities),
    after("in.frame", "", Forces),
    indexed("start", "φ", Positions),
    indexed("start.rate", "ω", Positions),
    row("simulate", "t", Positions),
    row("curve", "", Positions),
    after("curve.linear", "", Positions),
    after("curve.smooth", "", Positions),
    after("curve.periodic", "", Positions),
    after("curve.held", "", Positions),
    row("event", "", Positions),
    row("until", "", Positions),
    row("assemble", "", Positions),
    row("assemble.phase", "ψ", Positions),
    row("given", "", Positions),
    row("let", "", Positions),
    row("find", "", Positions),
    row("method", "", Positions),
    row("expect", "", Positions),
];
