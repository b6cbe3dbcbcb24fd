//! The kinds of picture, by name.

use crate::error::Missing;
use crate::scene::Scene;
use crate::scheme::{Scheme, scheme};
use assur_drawing::Drawing;

/// A kind of picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The kinematic scheme.
    Scheme,
}

/// All kinds.
pub const KINDS: [Kind; 1] = [Kind::Scheme];

/// How pictures are drawn.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The scheme.
    pub scheme: Scheme,
}

impl Kind {
    /// Its name on the command line and in file names.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scheme => "scheme",
        }
    }

    /// The kind of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        KINDS.into_iter().find(|kind| kind.name() == name)
    }
}

/// The pictures of a kind at a position.
///
/// # Errors
/// What the file does not declare.
pub fn draw(kind: Kind, scene: &Scene<'_>, options: &Options) -> Result<Vec<Drawing>, Missing> {
    match kind {
        Kind::Scheme => Ok(vec![scheme(scene, &options.scheme)]),
    }
}
