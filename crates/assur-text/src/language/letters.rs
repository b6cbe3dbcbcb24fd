//! The letters of quantities, as books have them.

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
