//! Errors of a unit.

use thiserror::Error;

/// Why a word is no unit. Ranges are bytes within the word.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnitError {
    /// A part of the word is in no table.
    #[error("`{part}` is not a unit")]
    Unknown {
        part: String,
        /// First byte of the part.
        start: usize,
        /// One past its last byte.
        end: usize,
        /// Spellings of the whole word that are units, the nearest first.
        nearest: Vec<String>,
    },
    /// The exponent does not fit.
    #[error("the exponent of `{part}` is too large")]
    Power {
        /// The part with its exponent.
        part: String,
        /// First byte of the part.
        start: usize,
        /// One past its last byte.
        end: usize,
    },
    /// The word is empty.
    #[error("a unit is missing")]
    Empty,
}

impl UnitError {
    /// The bytes of the word that are wrong.
    #[must_use]
    pub fn range(&self) -> (usize, usize) {
        match *self {
            Self::Unknown { start, end, .. } | Self::Power { start, end, .. } => (start, end),
            Self::Empty => (0, 0),
        }
    }

    /// Spellings of the whole word that are units, the nearest first.
    #[must_use]
    pub fn nearest(&self) -> &[String] {
        match self {
            Self::Unknown { nearest, .. } => nearest,
            _ => &[],
        }
    }

    /// What to write instead, if anything is near.
    #[must_use]
    pub fn help(&self) -> Option<String> {
        let list = self.nearest().iter().map(|n| format!("`{n}`")).collect::<Vec<_>>();
        (!list.is_empty()).then(|| format!("write {}", list.join(" or ")))
    }
}
