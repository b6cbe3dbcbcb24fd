//! What needs no position of its own: gears, cams, flywheels, quantities of the cycle.

mod cam;
mod cam_extreme;
mod flywheel;
mod gear;
mod page;

pub use page::Page;

use crate::words::Language;
use assur_solve::solve::{Model, Solution};

/// The steps of all that needs no position.
#[must_use]
pub fn design(model: Model<'_>, solution: &Solution, language: Language) -> Page {
    let mut page = Page::new(language);
    page.cycle(&model, solution);
    page.flywheels(&model, solution);
    page.cams(model.mechanism);
    page.gears(model.mechanism, solution);
    page
}
