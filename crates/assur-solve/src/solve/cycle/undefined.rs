//! Why a function over the sweep has no value.

use super::interval::Interval;
use crate::message::{four, short};
use crate::position::{Scene, turns};

/// Why a function over the sweep has no value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Undefined {
    /// It has none at this place of the sweep.
    At(f64),
    /// Friction locks the mechanism there.
    Locked(f64),
    /// The mechanism does not close there.
    Open(f64),
    /// It changes too often.
    Unresolved,
}

impl Undefined {
    pub(super) fn text(self, scene: &Scene<'_>, way: &Interval) -> String {
        let place = |s: f64| match scene.mechanism.drives.as_slice() {
            [drive] if turns(scene, drive) => {
                format!(" at {} = {} deg", drive.name, short(way.value(s).to_degrees()))
            }
            [drive] => format!(" at {} = {} mm", drive.name, four(way.value(s) * 1e3)),
            _ => format!(" at {} % of the sweep", short(100.0 * s)),
        };
        match self {
            Self::At(s) => format!("the quantity has no value{}", place(s)),
            Self::Locked(s) => format!("friction locks the mechanism{}", place(s)),
            Self::Open(s) => format!("the mechanism does not close{}", place(s)),
            Self::Unresolved => "the quantity changes too often over the sweep".to_owned(),
        }
    }
}
