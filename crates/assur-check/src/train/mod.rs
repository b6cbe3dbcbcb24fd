//! Shafts, wheels, sliders and what runs between them.

mod at_rest;
mod carrier;
mod meant;
mod planet;
mod property;
mod rope;
mod shaft;
mod size;
mod transmission;

pub(super) use at_rest::at_rest;
pub(super) use meant::missing_mesh;
pub(super) use property::{constant, known};
pub(super) use shaft::shafts;
pub(super) use size::{Sizes, wheels};
pub(super) use transmission::transmissions;
