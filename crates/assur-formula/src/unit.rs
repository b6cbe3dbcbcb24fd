//! Units of equations.

/// The unit of a quantity: SI, degrees for angles, and millimetres for teeth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Unit {
    #[default]
    One,
    /// m
    Length,
    /// mm
    Millimetre,
    /// m²
    Area,
    /// °
    Angle,
    /// rad
    Radian,
    /// m/s
    Velocity,
    /// m/s²
    Acceleration,
    /// rad/s
    AngularVelocity,
    /// rad/s²
    AngularAcceleration,
    /// m/s³
    Jerk,
    /// rad/s³
    AngularJerk,
    /// kg
    Mass,
    /// kg·m²
    Inertia,
    /// kg·m
    MassLength,
    /// 1/m
    PerLength,
    /// kg/m
    MassPerLength,
    /// 1/m²
    PerArea,
    /// N
    Force,
    /// N·m
    Torque,
    /// W
    Power,
    /// N/m
    Stiffness,
    /// N·s/m
    Damping,
    /// N·m/rad
    TorsionStiffness,
    /// N·m·s/rad
    TorsionDamping,
    /// kg/m³
    Density,
    Speed,
    /// J
    Work,
}

impl Unit {
    /// As it is written after a number.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::One => "",
            Self::Length => "m",
            Self::Millimetre => "mm",
            Self::MassLength => "kg·m",
            Self::PerLength => "1/m",
            Self::MassPerLength => "kg/m",
            Self::PerArea => "1/m²",
            Self::Area => "m²",
            Self::Angle => "°",
            Self::Radian => "rad",
            Self::Velocity => "m/s",
            Self::Acceleration => "m/s²",
            Self::AngularVelocity => "rad/s",
            Self::AngularAcceleration => "rad/s²",
            Self::Jerk => "m/s³",
            Self::AngularJerk => "rad/s³",
            Self::Mass => "kg",
            Self::Inertia => "kg·m²",
            Self::Force => "N",
            Self::Torque => "N·m",
            Self::Power => "W",
            Self::Stiffness => "N/m",
            Self::Damping => "N·s/m",
            Self::TorsionStiffness => "N·m/rad",
            Self::TorsionDamping => "N·m·s/rad",
            Self::Density => "kg/m³",
            Self::Speed => "rpm",
            Self::Work => "J",
        }
    }
}

/// A unit of a file as formulas have it: `kg*m^2` is kg·m².
#[must_use]
pub fn unit_words(unit: &str) -> String {
    unit.replace('*', "·").replace("^2", "²").replace("^3", "³").replace("^4", "⁴")
}
