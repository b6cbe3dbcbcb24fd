//! Mechanisms, random and known, against independent computations.
//!
//! One module per subject: `cargo test --test mechanics friction`.

mod cams;
mod contact;
mod friction;
mod geared_chains;
mod gears;
mod geneva;
mod grip;
mod hard;
mod jerks;
mod legs;
mod motion;
mod no_silent_errors;
mod planets;
mod power_residual;
mod precise;
mod properties;
mod reference_position;
mod rolling;
mod rubbing_wheels;
#[path = "../share/mod.rs"]
mod share;
mod slipping;
mod structure;
mod support;
mod train_losses;
mod trains;
