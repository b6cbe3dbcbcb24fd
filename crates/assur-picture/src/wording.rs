//! What pictures need of a language besides English, in which they are made.

use assur_drawing::Drawing;
use assur_model::model::Mechanism;

/// A language of pictures.
pub trait Wording {
    /// Its code: `en`.
    fn code(&self) -> &'static str;
    /// The sign before decimals.
    fn decimal(&self) -> char;
    /// A phrase that is made in English.
    fn phrase(&self, english: &str) -> String;
    /// A picture with its labels, its title and what it says of itself.
    fn drawing(&self, mechanism: &Mechanism, drawing: Drawing) -> Drawing;
}
