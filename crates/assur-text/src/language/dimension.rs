//! Dimensions and their algebra.

use std::fmt;

/// What tells quantities of equal dimension apart where angle is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A plain number, or a plain number per time (Hz).
    Plain,
    /// An angle, or an angle per time.
    Angle,
    /// Either: angle has been multiplied with, or never played a part in, another dimension.
    Free,
}

/// Exponents of length, mass and time, and the kind.
///
/// Angle is a kind and not a dimension: `omega * r` is a velocity. Sums and comparisons need equal kinds, a product
/// with a plain number keeps the kind, and a product with anything else is free.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    pub length: i8,
    pub mass: i8,
    pub time: i8,
    /// Angle, plain number, or free.
    pub kind: Kind,
}

const fn free(length: i8, mass: i8, time: i8) -> Dimension {
    Dimension { length, mass, time, kind: Kind::Free }
}

impl Dimension {
    pub const NUMBER: Self = Self { kind: Kind::Plain, ..free(0, 0, 0) };
    pub const ANGLE: Self = Self { kind: Kind::Angle, ..free(0, 0, 0) };
    pub const LENGTH: Self = free(1, 0, 0);
    pub const MASS: Self = free(0, 1, 0);
    pub const TIME: Self = free(0, 0, 1);
    pub const VELOCITY: Self = free(1, 0, -1);
    pub const ACCELERATION: Self = free(1, 0, -2);
    pub const ANGULAR_VELOCITY: Self = Self { kind: Kind::Angle, ..free(0, 0, -1) };
    pub const ANGULAR_ACCELERATION: Self = Self { kind: Kind::Angle, ..free(0, 0, -2) };
    pub const JERK: Self = free(1, 0, -3);
    pub const ANGULAR_JERK: Self = Self { kind: Kind::Angle, ..free(0, 0, -3) };
    /// Turns per time of which nobody said whether they are revolutions or radians.
    pub const FREQUENCY: Self = Self { kind: Kind::Plain, ..free(0, 0, -1) };
    pub const FORCE: Self = free(1, 1, -2);
    /// A torque, a work, an energy.
    pub const TORQUE: Self = free(2, 1, -2);
    pub const POWER: Self = free(2, 1, -3);
    /// A moment of inertia.
    pub const INERTIA: Self = free(2, 1, 0);
    /// A stiffness: force per length.
    pub const STIFFNESS: Self = free(0, 1, -2);
    /// A viscous damping: force per velocity.
    pub const DAMPING: Self = free(0, 1, -1);
    /// A rotary damping: torque per angular velocity.
    pub const ROTARY_DAMPING: Self = free(2, 1, -1);
    pub const PRESSURE: Self = free(-1, 1, -2);
    pub const DENSITY: Self = free(-3, 1, 0);
    /// A weight per volume.
    pub const WEIGHT_DENSITY: Self = free(-2, 1, -2);
    pub const AREA: Self = free(2, 0, 0);
    pub const VOLUME: Self = free(3, 0, 0);

    const fn exponents(self) -> (i8, i8, i8) {
        (self.length, self.mass, self.time)
    }

    /// A plain number or an angle: no length, mass or time in it.
    #[must_use]
    pub const fn is_dimensionless(self) -> bool {
        matches!(self.exponents(), (0, 0, 0))
    }

    /// A number without dimension and without the kind of an angle.
    #[must_use]
    pub fn is_number(self) -> bool {
        self.is_dimensionless() && self.kind != Kind::Angle
    }

    /// Whether the two may be added and compared.
    #[must_use]
    pub fn fits(self, other: Self) -> bool {
        self.unify(other).is_some()
    }

    /// The dimension of a sum of the two, if they have one.
    #[must_use]
    pub fn unify(self, other: Self) -> Option<Self> {
        if self.exponents() != other.exponents() {
            return None;
        }
        match (self.kind, other.kind) {
            (Kind::Free, _) => Some(other),
            (_, Kind::Free) => Some(self),
            (a, b) => (a == b).then_some(self),
        }
    }

    fn with(self, exponents: (i8, i8, i8), other: Self) -> Self {
        let kind = if other == Self::NUMBER {
            self.kind
        } else if self == Self::NUMBER {
            other.kind
        } else {
            Kind::Free
        };
        let (length, mass, time) = exponents;
        Self { length, mass, time, kind }
    }

    /// The dimension of a product. Exponents stop at the ends of `i8`, which no formula of mechanics reaches.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let ((l, m, t), (a, b, c)) = (self.exponents(), other.exponents());
        self.with((l.saturating_add(a), m.saturating_add(b), t.saturating_add(c)), other)
    }

    /// The dimension of a quotient.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        let ((l, m, t), (a, b, c)) = (self.exponents(), other.exponents());
        let kind = if self == Self::NUMBER && other.kind == Kind::Angle { Kind::Free } else { other.kind };
        self.with((l.saturating_sub(a), m.saturating_sub(b), t.saturating_sub(c)), Self { kind, ..other })
    }

    /// The dimension of an integer power.
    #[must_use]
    pub fn powi(self, n: i8) -> Self {
        match n {
            0 => Self::NUMBER,
            1 => self,
            _ => {
                let (l, m, t) = self.exponents();
                let kind = if self.kind == Kind::Plain { Kind::Plain } else { Kind::Free };
                Self {
                    length: l.saturating_mul(n),
                    mass: m.saturating_mul(n),
                    time: t.saturating_mul(n),
                    kind,
                }
            }
        }
    }

    /// The dimension of a square root, where all exponents are even.
    #[must_use]
    pub fn sqrt(self) -> Option<Self> {
        let (l, m, t) = self.exponents();
        let even = l % 2 == 0 && m % 2 == 0 && t % 2 == 0;
        let kind = if self.kind == Kind::Plain { Kind::Plain } else { Kind::Free };
        even.then_some(Self { length: l / 2, mass: m / 2, time: t / 2, kind })
    }

    /// What such a quantity is called, with its article: `a length`, `a torque or energy`.
    #[must_use]
    pub fn name(self) -> Option<&'static str> {
        Some(match (self.exponents(), self.kind) {
            ((0, 0, 0), Kind::Angle) => "an angle",
            ((0, 0, 0), _) => "a plain number",
            ((1, 0, 0), _) => "a length",
            ((0, 1, 0), _) => "a mass",
            ((0, 0, 1), _) => "a time",
            ((2, 0, 0), _) => "an area",
            ((3, 0, 0), _) => "a volume",
            ((1, 0, -1), _) => "a velocity",
            ((1, 0, -2), _) => "an acceleration",
            ((1, 0, -3), _) => "a jerk",
            ((0, 0, -3), _) => "an angular jerk",
            ((0, 0, -1), Kind::Plain) => "a frequency",
            ((0, 0, -1), _) => "an angular velocity",
            ((0, 0, -2), _) => "an angular acceleration",
            ((1, 1, -2), _) => "a force",
            ((2, 1, -2), _) => "a torque or energy",
            ((2, 1, -3), _) => "a power",
            ((2, 1, 0), _) => "a moment of inertia",
            ((0, 1, -2), _) => "a stiffness",
            ((0, 1, -1), _) => "a damping",
            ((2, 1, -1), _) => "a rotary damping or angular momentum",
            ((1, 1, -1), _) => "a momentum",
            ((1, 1, 0), _) => "a mass times a length",
            ((-1, 1, -2), _) => "a pressure",
            ((-3, 1, 0), _) => "a density",
            ((-2, 1, -2), _) => "a weight per volume",
            ((-1, 0, 0), _) => "a curvature",
            _ => return None,
        })
    }

    /// The spelling of its SI unit: `N*m`, `m/s^2`; empty for a plain number.
    #[must_use]
    pub fn si_text(self) -> String {
        let named = match (self.exponents(), self.kind) {
            ((0, 0, 0), Kind::Angle) => "rad",
            ((0, 0, 0), _) => "",
            ((0, 0, -1), Kind::Angle) => "rad/s",
            ((0, 0, -2), Kind::Angle) => "rad/s^2",
            ((0, 0, -3), Kind::Angle) => "rad/s^3",
            ((0, 0, -1), Kind::Plain) => "Hz",
            ((1, 1, -2), _) => "N",
            ((2, 1, -2), _) => "N*m",
            ((2, 1, -3), _) => "W",
            ((0, 1, -2), _) => "N/m",
            ((0, 1, -1), _) => "N*s/m",
            ((2, 1, -1), _) => "N*m*s",
            ((-1, 1, -2), _) => "Pa",
            ((-2, 1, -2), _) => "N/m^3",
            _ => return self.base_text(),
        };
        named.to_owned()
    }

    fn base_text(self) -> String {
        let bases = [("kg", self.mass), ("m", self.length), ("s", self.time)];
        let power =
            |(symbol, n): (&str, i16)| if n == 1 { symbol.to_owned() } else { format!("{symbol}^{n}") };
        let above =
            bases.iter().filter(|b| b.1 > 0).map(|&(s, n)| power((s, i16::from(n)))).collect::<Vec<_>>();
        let below =
            bases.iter().filter(|b| b.1 < 0).map(|&(s, n)| power((s, -i16::from(n)))).collect::<Vec<_>>();
        match (above.is_empty(), below.is_empty()) {
            (true, true) => String::new(),
            (_, true) => above.join("*"),
            (true, false) => format!("1/{}", below.join("/")),
            (false, false) => format!("{}/{}", above.join("*"), below.join("/")),
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name() {
            Some(name) => f.write_str(name),
            None => write!(f, "a quantity in {}", self.si_text()),
        }
    }
}
