//! The usual slips: what a wrong answer would be right for.

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

const fn cause(name: &'static str, words: &'static str) -> Cause {
    Cause { name, words }
}

/// Factors with a name.
const FACTORS: [(f64, Cause); 10] = [
    (1000.0, cause("unit", "a prefix: mm and m, N and kN, g and kg")),
    (180.0 / PI, cause("unit", "degrees and radians")),
    (30.0 / PI, cause("unit", "revolutions per minute and radians per second")),
    (TAU, cause("unit", "revolutions and radians")),
    (9.81, cause("weight", "the acceleration of free fall: mass and weight")),
    (60.0, cause("unit", "minutes and seconds")),
    (10.0, cause("decimal-point", "the decimal point")),
    (100.0, cause("decimal-point", "the decimal point, or cm and m")),
    (1.0e6, cause("unit", "two prefixes, or mm² and m²")),
    (TWICE, cause("half", "")),
];
/// This factor has words of its own.
const TWICE: f64 = 2.0;

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

/// The factor by which an answer differs from the key, the sign aside: of those that fit the nearest. `off` says how far
/// a number is from the key, where that is near.
pub(super) fn factor(given: f64, off: &dyn Fn(f64) -> Option<f64>) -> Option<CommonMistake> {
    let signs = [(1.0, false), (-1.0, true)];
    let mut nearest: Option<(f64, CommonMistake)> = None;
    for (value, cause) in FACTORS {
        for ((sign, wrong), factor) in signs.into_iter().flat_map(|s| [(s, value), (s, 1.0 / value)]) {
            let Some(off) = off(sign * given / factor) else { continue };
            if nearest.as_ref().is_none_or(|(least, _)| off < *least) {
                nearest = Some((off, CommonMistake::Factor { factor, cause, sign: wrong }));
            }
        }
    }
    nearest.map(|(_, slip)| slip)
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
