//! The usual slips: what a wrong answer would be right for.

use std::f64::consts::{PI, TAU};

/// What was probably done wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Slip {
    /// The other sign.
    Sign,
    /// Both components have the other sign: the force on the other link of the pair.
    OtherLink,
    /// Too large or too small by a factor with a name, the sign aside.
    Factor {
        /// How often the answer contains the key.
        factor: f64,
        /// What that factor is.
        what: &'static str,
        /// The sign is wrong too.
        sign: bool,
    },
    /// The other component.
    Swapped,
    /// The magnitude of the vector.
    Magnitude,
    /// Another quantity of the same row.
    OtherQuantity {
        /// Its name.
        name: String,
        /// With the other sign.
        sign: bool,
    },
    /// The same quantity of another row.
    OtherRow(String),
    /// Not far off.
    Near,
}

/// Factors with a name. The first that fits is told.
const FACTORS: [(f64, &str); 10] = [
    (1000.0, "a prefix: mm and m, N and kN, g and kg"),
    (180.0 / PI, "degrees and radians"),
    (30.0 / PI, "revolutions per minute and radians per second"),
    (TAU, "revolutions and radians"),
    (9.81, "the acceleration of free fall: mass and weight"),
    (60.0, "minutes and seconds"),
    (10.0, "the decimal point"),
    (100.0, "the decimal point, or cm and m"),
    (1.0e6, "two prefixes, or mm² and m²"),
    (2.0, "a half"),
];

/// The factor by which an answer differs from the key, the sign aside.
pub(super) fn factor(given: f64, near: &dyn Fn(f64) -> bool) -> Option<Slip> {
    let signs = [(1.0, false), (-1.0, true)];
    for (value, what) in FACTORS {
        for (sign, wrong) in signs {
            for factor in [value, 1.0 / value] {
                if near(sign * given / factor) {
                    return Some(Slip::Factor { factor, what, sign: wrong });
                }
            }
        }
    }
    None
}

impl Slip {
    /// A short word for it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::OtherLink => "other link",
            Self::Factor { .. } => "factor",
            Self::Swapped => "other component",
            Self::Magnitude => "magnitude",
            Self::OtherQuantity { .. } => "other quantity",
            Self::OtherRow(_) => "other row",
            Self::Near => "near",
        }
    }

    /// A sentence for it.
    #[must_use]
    pub fn words(&self) -> String {
        let also = |sign: &bool| if *sign { ", and the other sign" } else { "" };
        match self {
            Self::Sign => "right but for the sign".to_owned(),
            Self::OtherLink => {
                "the reaction on the other link of the pair: both signs are opposite".to_owned()
            }
            Self::Factor { factor, what, sign } => {
                let (n, way) = if *factor < 1.0 { (1.0 / factor, "small") } else { (*factor, "large") };
                let n = assur_text::units::significant(n, 4);
                format!("too {way} by a factor of {n} ({what}){}", also(sign))
            }
            Self::Swapped => "the other component of the vector".to_owned(),
            Self::Magnitude => "the magnitude of the vector, not its component".to_owned(),
            Self::OtherQuantity { name, sign } => format!("the value of `{name}`{}", also(sign)),
            Self::OtherRow(row) => format!("the value of {row}"),
            Self::Near => "not far off: rounded too early, or read off roughly".to_owned(),
        }
    }
}
