//! Pictures of a text.

use super::problem::Problem;
use super::solution::Diagnostics;
use crate::handout::Pictured;
use assur_drawing::Theme;
use assur_picture::KINDS;
use assur_text::diagnostic::{Problems, did_you_mean};
use assur_worked::Language;

impl Problem {
    /// The names of the kinds of pictures: `scheme`, `velocities`, `forces`, …
    pub fn pictures() -> impl Iterator<Item = &'static str> {
        KINDS.iter().map(|kind| kind.name())
    }

    /// Draws pictures of a kind at a pose: at the first that is solved without a name. Each is SVG; an animation is a page that needs
    /// nothing else. `None` if there is no such kind, with the nearest.
    ///
    /// # Errors
    /// The diagnostics of a text that cannot be solved, or that has no such picture.
    pub fn draw(&self, kind: &str, pose: Option<&str>) -> Result<Vec<String>, DrawError> {
        let Some(kind) = KINDS.into_iter().find(|k| k.name() == kind) else {
            let near = did_you_mean(kind, Self::pictures()).first().map(|near| (*near).to_owned());
            return Err(DrawError::Kind(near));
        };
        let (found, overrides) = (self.found.clone(), self.overrides());
        let (source, document) = (&self.source, &self.document);
        let pictured = Pictured {
            source,
            document,
            overrides: &overrides,
            language: Language::English,
            theme: Theme::Auto,
        };
        let (solved, mut problems) = pictured.solved(found, &[kind]);
        let wrong = |problems: &Problems| DrawError::Diagnostics(self.diagnostics(problems));
        let Some(solved) = solved else { return Err(wrong(&problems)) };
        pictured.drawn(&solved, kind, pose).map_err(|missing| {
            problems.push(missing);
            wrong(&problems)
        })
    }
}

/// Why there is no picture.
#[derive(Clone, Debug)]
pub enum DrawError {
    /// No kind of picture has this name; what may be meant.
    Kind(Option<String>),
    /// The diagnostics of the text.
    Diagnostics(Diagnostics),
}
