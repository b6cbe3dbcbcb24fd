//! What stands in a cell of a sheet.

use crate::exercise::table::{Separator, Written};
use assur_text::units::{Unit, lookup};

/// Longer texts are not repeated in the reason why they cannot be read, bytes.
const LONG: usize = 60;

/// What stands in a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    Empty,
    /// A number, SI.
    Number(f64),
    Bool(bool),
    /// What cannot be read.
    Unreadable(Box<Unread>),
}

/// What cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unread {
    pub text: String,
    pub why: String,
}

impl Unread {
    /// A text with the reason.
    pub(super) fn new(text: &str, why: impl Into<String>) -> Box<Self> {
        Box::new(Self { text: text.to_owned(), why: why.into() })
    }
}

impl Entry {
    /// Reads a cell: a number, in the column's unit or in one of its own; true or false; nothing.
    pub(super) fn read(text: &str, unit: &Unit) -> Self {
        match text {
            "" | "-" | "—" => return Self::Empty,
            "true" => return Self::Bool(true),
            "false" => return Self::Bool(false),
            _ => {}
        }
        let (value, why) = match plain(text) {
            Ok(value) => (Some(unit.to_si(value)), String::new()),
            Err(why) => (with_unit(text, unit), why),
        };
        match value {
            Some(x) if x.is_finite() => Self::Number(x),
            Some(_) => Self::Unreadable(Unread::new(text, "it is too large")),
            None if text.len() > LONG => Self::Unreadable(Unread::new(text, "it is not a number")),
            None => Self::Unreadable(Unread::new(text, why)),
        }
    }

    /// The same answer given again in another column.
    pub(super) fn and(&mut self, text: &str, other: Self) {
        match (&*self, other) {
            (_, Self::Empty) => {}
            (Self::Empty, other) => *self = other,
            _ => *self = Self::Unreadable(Unread::new(text, "it is given in two columns")),
        }
    }
}

/// A number; a cell of its own may have a decimal comma.
pub(super) fn plain(text: &str) -> Result<f64, String> {
    Written::read(text, Separator::Semicolon).map(|written| written.value).map_err(|(why, _)| why)
}

/// A number with a unit of its own, SI.
fn with_unit(text: &str, unit: &Unit) -> Option<f64> {
    let begins_unit = |c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E') || matches!(c, '%' | '°');
    let (number, word) = text.split_at(text.find(begins_unit)?);
    let own = lookup(word.trim()).ok().filter(|own| own.dimension.fits(unit.dimension))?;
    Some(own.to_si(plain(number.trim()).ok()?))
}
