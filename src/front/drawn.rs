//! Pictures of a text.

use super::problem::Problem;
use super::solution::Diagnostics;
use crate::pipeline::{self, Solved};
use assur_drawing::Theme;
use assur_picture::{KINDS, Kind, Options, Scene};
use assur_text::diagnostic::{Diagnosis, Problems, did_you_mean};

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
        let (solved, mut problems) =
            pipeline::solve_document_drawn(&self.source, &self.document, found, &overrides, &[kind]);
        let wrong = |problems: &Problems| DrawError::Diagnostics(self.diagnostics(problems));
        let Some(solved) = solved else { return Err(wrong(&problems)) };
        self.drawn(&solved, kind, pose).map_err(|missing| {
            problems.push(missing);
            wrong(&problems)
        })
    }

    fn drawn(&self, solved: &Solved, kind: Kind, pose: Option<&str>) -> Result<Vec<String>, Diagnosis> {
        let file = (self.source.name.as_str(), self.source.text.as_str());
        let (compiled, options) = (&solved.compiled, Options::default());
        if solved.solution.poses.is_empty() && kind == Kind::Cam {
            let cams = assur_picture::cams_alone(&compiled.mechanism, file.0, &options.scheme.paper())?;
            return Ok(svg(cams));
        }
        let scene = Scene::of(compiled.model(), &solved.solution, file, pose)?;
        if kind != Kind::Animation {
            return assur_picture::draw(kind, &scene, &options).map(svg);
        }
        let turn = &pipeline::turn(compiled, &solved.solution);
        let words = assur_worked::Language::English;
        assur_picture::animation(&Scene { turn, ..scene }, &options, Theme::Auto, &words)
            .map(|page| vec![page])
    }
}

fn svg(drawings: Vec<assur_drawing::Drawing>) -> Vec<String> {
    drawings.into_iter().map(|drawing| drawing.placed().svg(Theme::Auto)).collect()
}

/// Why there is no picture.
#[derive(Clone, Debug)]
pub enum DrawError {
    /// No kind of picture has this name; what may be meant.
    Kind(Option<String>),
    /// The diagnostics of the text.
    Diagnostics(Diagnostics),
}
