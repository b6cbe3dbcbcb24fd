//! The usual slips: what a wrong answer would be right for.

use assur_text::units::{Dimension, Kind};
use std::f64::consts::{PI, TAU};

/// What was probably done wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum CommonMistake {
    Sign,
    /// Both components have the other sign: the force on the other link of the pair.
    OtherLink,
    /// Too large or too small by a factor with a name, the sign aside.
    Factor {
        /// How often the answer contains the key.
        factor: f64,
        /// What that factor is.
        cause: Cause,
        /// The sign is wrong too.
        sign: bool,
    },
    /// An angle less by a half turn: the direction the other way along the same line.
    Opposite,
    /// The supplement of an angle, 180° − ψ.
    Supplement,
    Swapped,
    /// The magnitude of the vector.
    Magnitude,
    /// Another quantity of the same row.
    OtherQuantity {
        name: String,
        /// With the other sign.
        sign: bool,
    },
    /// The same quantity of another row.
    OtherRow(String),
    Close,
}

/// What a factor comes from: the short name of the slip, and what to say of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cause {
    name: &'static str,
    words: &'static str,
}

/// A factor with a name, and the quantities of which it can be meant.
struct Factor {
    value: f64,
    cause: Cause,
    of: fn(Dimension) -> bool,
}

const fn factor(value: f64, name: &'static str, words: &'static str, of: fn(Dimension) -> bool) -> Factor {
    Factor { value, cause: Cause { name, words }, of }
}

const FACTORS: [Factor; 12] = [
    factor(1000.0, "unit", "a prefix: mm and m, N and kN, g and kg", is_prefixed),
    factor(180.0 / PI, "unit", "degrees and radians", is_of_angle),
    factor(30.0 / PI, "unit", "revolutions per minute and radians per second", is_rate),
    factor(TAU, "unit", "revolutions and radians", |d| d == Dimension::ANGLE || is_rate(d)),
    factor(9.81, "weight", "the acceleration of free fall: mass and weight", is_weighed),
    factor(60.0, "unit", "minutes and seconds", |d| d.time < 0 && d.mass == 0),
    factor(10.0, "decimal-point", "the decimal point", |_| true),
    factor(100.0, "decimal-point", "the decimal point, or cm and m", |d| d.length != 0),
    factor(100.0, "decimal-point", "the decimal point, or percent", Dimension::is_number),
    factor(100.0, "decimal-point", "the decimal point", |d| d.length == 0 && !d.is_number()),
    factor(1.0e6, "unit", "two prefixes, or mm² and m²", is_prefixed),
    factor(TWICE, "half", "", |_| true),
];
/// This factor has words of its own.
const TWICE: f64 = 2.0;

const fn is_prefixed(of: Dimension) -> bool {
    of.mass != 0 || of.length != 0
}

/// An angle, or one per time, whatever the power.
fn is_of_angle(of: Dimension) -> bool {
    of == Dimension::ANGLE || of.time < 0 && !is_prefixed(of) && of.kind != Kind::Plain
}

/// An angular velocity, or a number of turns per time.
const fn is_rate(of: Dimension) -> bool {
    of.time == -1 && !is_prefixed(of)
}

fn is_weighed(of: Dimension) -> bool {
    [Dimension::FORCE, Dimension::TORQUE, Dimension::MASS].contains(&of)
}

/// The short names of all slips.
pub const SLIPS: [&str; 13] = [
    "sign",
    "other-link",
    "unit",
    "weight",
    "decimal-point",
    "half",
    "opposite-direction",
    "supplement",
    "other-component",
    "magnitude",
    "other-quantity",
    "other-row",
    "close",
];

/// The factors that can be meant of a quantity, with their signs, and their slips.
pub(super) fn factors(of: Dimension) -> impl Iterator<Item = (f64, CommonMistake)> {
    FACTORS.iter().filter(move |factor| (factor.of)(of)).flat_map(|Factor { value, cause, .. }| {
        let both = [(*value, 1.0), (1.0 / value, 1.0), (*value, -1.0), (1.0 / value, -1.0)];
        both.map(|(factor, sign)| {
            (sign * factor, CommonMistake::Factor { factor, cause: *cause, sign: sign < 0.0 })
        })
    })
}

impl CommonMistake {
    /// Its short name, one of [`SLIPS`].
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::OtherLink => "other-link",
            Self::Factor { cause, .. } => cause.name,
            Self::Opposite => "opposite-direction",
            Self::Supplement => "supplement",
            Self::Swapped => "other-component",
            Self::Magnitude => "magnitude",
            Self::OtherQuantity { .. } => "other-quantity",
            Self::OtherRow(_) => "other-row",
            Self::Close => "close",
        }
    }

    /// Whether the sign is wrong in addition to it.
    #[must_use]
    pub const fn has_other_sign(&self) -> bool {
        matches!(self, Self::Factor { sign: true, .. } | Self::OtherQuantity { sign: true, .. })
    }

    /// How common it is: the least number is the commonest. Two slips at once, or two prefixes, are rare.
    #[must_use]
    pub fn rank(&self) -> usize {
        let place = SLIPS.iter().position(|name| *name == self.name()).unwrap_or(SLIPS.len());
        let two = matches!(self, Self::Factor { factor, .. } if factor.max(1.0 / factor) > 1e5);
        place + SLIPS.len() * (usize::from(self.has_other_sign()) + usize::from(two))
    }

    /// What it is, in words.
    #[must_use]
    pub fn words(&self) -> String {
        let also = if self.has_other_sign() { ", opposite sign" } else { "" };
        match self {
            Self::Sign => "right but for the sign".to_owned(),
            Self::OtherLink => {
                "the reaction on the other link of the pair: both signs are opposite".to_owned()
            }
            Self::Factor { factor, .. } if *factor == TWICE => format!("twice the value{also}"),
            Self::Factor { factor, .. } if *factor == 1.0 / TWICE => format!("half the value{also}"),
            Self::Factor { factor, cause, .. } => {
                let (n, size) = if *factor < 1.0 { (1.0 / factor, "small") } else { (*factor, "large") };
                let n = assur_text::units::significant(n, 4);
                format!("too {size} by a factor of {n} ({}){also}", cause.words)
            }
            Self::Opposite => "the opposite direction: 180° more or less".to_owned(),
            Self::Supplement => "the supplement: 180° less the angle".to_owned(),
            Self::Swapped => "the other component of the vector".to_owned(),
            Self::Magnitude => "the magnitude of the vector, not its component".to_owned(),
            Self::OtherQuantity { name, .. } => format!("the value of `{name}`{also}"),
            Self::OtherRow(row) => format!("the value of {row}"),
            Self::Close => "close: a rounding or reading error?".to_owned(),
        }
    }
}
