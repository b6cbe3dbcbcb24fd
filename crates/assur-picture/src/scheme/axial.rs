//! Bars in the colours of tension and compression, with the forces along them.

use super::{Scheme, Shows, Sketch, scheme};
use crate::no_diagram::no_axial;
use crate::scene::Scene;
use assur_drawing::{Drawing, Label, Role, Style, Text};
use assur_model::model::LinkId;
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

/// A force below this part of the greatest is none.
const NOTHING: f64 = 1e-9;
/// Size of the numbers.
const NUMBER: f64 = 3.6;

/// The forces along all bars that are asked for.
pub(super) struct Axial {
    forces: Vec<(LinkId, f64)>,
    nothing: f64,
}

impl Axial {
    fn of(scene: &Scene<'_>) -> Self {
        let view = scene.view();
        let forces: Vec<_> =
            scene.mechanism().bars.iter().map(|bar| (bar.link, view.axial(bar.link))).collect();
        let nothing = NOTHING * forces.iter().map(|(_, force)| force.abs()).fold(0.0, f64::max);
        Self { forces, nothing }
    }

    /// The force along a link; none where none is asked for. What is rounding is zero.
    fn force(&self, link: LinkId) -> Option<f64> {
        let (_, force) = self.forces.iter().find(|(bar, _)| *bar == link)?;
        force.is_finite().then_some(if force.abs() > self.nothing { *force } else { 0.0 })
    }
}

/// The scheme with the forces along its bars in place of their names.
///
/// # Errors
/// No axial force is asked for.
pub fn axial(scene: &Scene<'_>, wanted: &Scheme) -> Result<Drawing, Diagnosis> {
    if scene.mechanism().bars.is_empty() {
        return Err(no_axial(scene));
    }
    scheme(scene, &Scheme { shows: Shows::Axial, ..wanted.clone() })
}

impl Sketch<'_, '_> {
    pub(super) fn shows_axial(&mut self) {
        self.axial = Some(Axial::of(self.scene));
    }

    /// How the lines of a link are drawn.
    pub(super) fn style_of(&self, link: LinkId) -> Style {
        match self.axial.as_ref().and_then(|axial| axial.force(link)) {
            Some(force) if force > 0.0 => Style::Pulled,
            Some(force) if force < 0.0 => Style::Pushed,
            _ => Style::Link,
        }
    }

    /// The force along a link, at its line.
    pub(super) fn axial_number(&self, link: LinkId) -> Option<Label> {
        let force = self.axial.as_ref()?.force(link)?;
        let display = self.scene.mechanism().display_of(Dimension::FORCE);
        let text = Text::upright(&self.scene.value_text(&display, force));
        let (a, b) = self.longest(link)?;
        let label = Label::along(text, NUMBER, a, b).ranked(1);
        Some(match self.style_of(link) {
            Style::Pulled => label.coloured(Role::Blue),
            Style::Pushed => label.coloured(Role::Vermilion),
            _ => label,
        })
    }
}
