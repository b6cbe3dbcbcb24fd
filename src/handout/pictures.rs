//! Pictures of a text, with all that their kinds show.

use crate::pipeline::{self, Solved};
use assur_check::Overrides;
use assur_drawing::{Drawing, Theme};
use assur_picture::{ArrowKind, Kind, Moving, Options, Scene, Subject};
use assur_syntax::document::Document;
use assur_text::diagnostic::{Diagnosis, Problems};
use assur_text::source::Source;
use assur_worked::{Language, drawing_in};
use std::sync::Arc;

/// A text of which pictures are made.
pub struct Pictured<'a> {
    pub source: &'a Source,
    pub document: &'a Arc<Document>,
    pub overrides: &'a Overrides,
    pub language: Language,
    pub theme: Theme,
}

impl Pictured<'_> {
    /// It solved with all that some kinds show; `found` is what was wrong in the text.
    ///
    /// # Errors
    /// It cannot be solved.
    pub fn solved(&self, found: Problems, kinds: &[Kind]) -> (Option<Solved>, Problems) {
        pipeline::solve_document_drawn(self.source, self.document, found, self.overrides, kinds)
    }

    /// Pictures of a kind as SVG, at the position of a name, else at the first; an animation is a page.
    ///
    /// # Errors
    /// Why there is no such picture.
    pub fn drawn(&self, solved: &Solved, kind: Kind, pose: Option<&str>) -> Result<Vec<String>, Diagnosis> {
        let options = Options::default();
        let scene = match self.scene(solved, pose) {
            Err(_) if !kind.needs().place.is_needed() => {
                return Ok(
                    self.svg(solved, assur_picture::draw(kind, self.without_position(solved), &options)?)
                );
            }
            scene => scene?,
        };
        if kind != Kind::Animation {
            return Ok(self.svg(solved, assur_picture::draw(kind, &scene, &options)?));
        }
        let turn = &pipeline::turn(&solved.compiled, &solved.solution);
        assur_picture::animation(&Scene { turn, ..scene }, &options, self.theme, &self.language)
            .map(|page| vec![page])
    }

    /// The kinds of which there are pictures, without the animation.
    pub fn kinds(&self, solved: &Solved) -> Vec<Kind> {
        let scene = self.scene(solved, None);
        let mut kinds = scene.as_ref().map_or_else(|_| self.without_position(solved), Subject::from).kinds();
        kinds.retain(|kind| *kind != Kind::Animation);
        kinds
    }

    /// The kind that is drawn where none is named; the scheme where a text has none, which tells why.
    pub fn first_kind(&self, solved: &Solved) -> Kind {
        self.kinds(solved).first().copied().unwrap_or(Kind::Scheme)
    }

    /// The mechanism in motion, with the arrows that its effects have; of what does not move the scheme.
    ///
    /// # Errors
    /// There is no picture, or no arrow of the kind that is wanted.
    pub fn moving(&self, solved: &Solved, shown: Option<ArrowKind>) -> Result<Moving, Diagnosis> {
        let still = || {
            let markup = self.drawn(solved, self.first_kind(solved), None)?.concat();
            Ok(Moving { title: solved.compiled.mechanism.title.clone(), markup, motion: None })
        };
        let Ok(scene) = self.scene(solved, None) else { return still() };
        let (turn, arrows) = pipeline::turn_with_effects(&solved.compiled, &solved.solution, None);
        let options = Options { arrows, shown, ..Options::default() };
        assur_picture::motion(&Scene { turn: &turn, ..scene }, &options, self.theme, &self.language)
            .or_else(|missing| if shown.is_some() { Err(missing) } else { still() })
    }

    /// The mechanism in motion as one picture without a script.
    ///
    /// # Errors
    /// There is no way to go.
    pub fn without_script(&self, solved: &Solved) -> Result<String, Diagnosis> {
        let turn = pipeline::turn(&solved.compiled, &solved.solution);
        let scene = Scene { turn: &turn, ..self.scene(solved, None)? };
        assur_picture::moving(&scene, &Options::default(), self.theme, &self.language)
    }

    fn scene<'s>(&'s self, solved: &'s Solved, pose: Option<&str>) -> Result<Scene<'s>, Diagnosis> {
        let file = (self.source.name.as_str(), self.source.text.as_str());
        Scene::of(solved.compiled.model(), &solved.solution, file, pose)
    }

    fn without_position<'s>(&'s self, solved: &'s Solved) -> Subject<'s, 's> {
        Subject::without_position(&solved.compiled.mechanism, &solved.solution, &self.source.name)
    }

    fn svg(&self, solved: &Solved, drawings: Vec<Drawing>) -> Vec<String> {
        let mechanism = &solved.compiled.mechanism;
        let drawings = drawings.into_iter().map(|one| drawing_in(self.language, mechanism, one));
        drawings.map(|drawing| drawing.placed().svg(self.theme)).collect()
    }
}
