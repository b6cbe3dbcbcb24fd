//! What a page shows of a text: its picture in motion, its answers, what is wrong with it, and where what is drawn is declared.

use super::symbols::{Symbol, SymbolKind};
use super::{Analysis, Results, symbols};
use crate::pipeline::{Solved, turn_with_effects};
use crate::report::{
    AccuracyShown, PrintedDigits, of_answers,
    text::{self, Look},
};
use assur_drawing::Theme;
use assur_picture::{ArrowKind, Kind, Moving, Options, Scene, draw, motion};
use assur_text::diagnostic::{Diagnosis, Problems, Style, place, render_most};
use assur_text::source::{Span, shown_in_line};
use assur_worked::{Language, drawing_in};
use serde::Serialize;

/// How diagnostics are drawn: as in a terminal of 100 columns, without colours.
const STYLE: Style = Style::Graphical { colour: false, width: 100 };
/// The most diagnostics, as in a terminal.
const MOST: usize = 50;

/// What a page shows of a text.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PageParts {
    /// The mechanism, in motion where it can move; none where nothing is solved.
    pub picture: Option<Moving>,
    /// The answers as in a terminal.
    pub answers: String,
    /// What is wrong, as in a terminal.
    pub diagnostics: String,
    /// Where names are declared.
    pub declared: Vec<Declared>,
}

/// A name with the statement that declares it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Declared {
    pub name: String,
    /// As groups of a picture are called: `link`, `pair`, else empty.
    pub class: &'static str,
    /// Its line, from 1.
    pub line: usize,
    /// The first line of the statement.
    pub text: String,
    #[serde(skip)]
    pub whole: Span,
}

impl Analysis {
    /// The text with its answers, or with why it has none.
    #[must_use]
    pub fn preview(&self, results: Option<&Results>) -> PageParts {
        let mut diagnostics = render_most(&self.problems, &self.source, STYLE, MOST);
        if let Some(results) = results {
            diagnostics += &render_most(&results.problems, &self.source, STYLE, MOST);
        }
        let Some(solved) = results.and_then(|results| results.solved.as_ref()) else {
            return PageParts { diagnostics, ..PageParts::default() };
        };
        let picture = match self.moving(solved, Language::English, None) {
            Ok(picture) => Some(picture),
            Err(missing) => {
                diagnostics += &render_most(&Problems::of([missing]), &self.source, STYLE, MOST);
                None
            }
        };
        PageParts { picture, answers: self.answers(solved), diagnostics, declared: self.declared() }
    }

    /// The mechanism in motion; of what does not move the scheme.
    fn moving(
        &self,
        solved: &Solved,
        language: Language,
        shown: Option<ArrowKind>,
    ) -> Result<Moving, Diagnosis> {
        let file = (self.source.name.as_str(), self.source.text.as_str());
        let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None)?;
        let (turn, arrows) = turn_with_effects(&solved.compiled, &solved.solution, None);
        let scene = Scene { turn: &turn, ..scene };
        let options = Options { arrows, shown, ..Options::default() };
        motion(&scene, &options, Theme::Auto, &language).or_else(|_| {
            let drawings = draw(Kind::Scheme, &scene, &options)?;
            let title = solved.compiled.mechanism.title.clone();
            let drawings =
                drawings.into_iter().map(|one| drawing_in(language, &solved.compiled.mechanism, one));
            Ok(Moving {
                title,
                markup: drawings.map(|one| one.placed().svg(Theme::Auto)).collect(),
                motion: None,
            })
        })
    }

    fn answers(&self, solved: &Solved) -> String {
        let answers = solved.answers(PrintedDigits::READABLE);
        text::render(&of_answers(&self.source.name, &answers, AccuracyShown::Worst), Look::PLAIN)
    }

    /// Links and pairs first, where several things have one name.
    pub(super) fn declared(&self) -> Vec<Declared> {
        let all = symbols(&self.document);
        let parts = all.iter().flat_map(|symbol| &symbol.parts);
        all.iter().chain(parts).map(|symbol| self.declaration(symbol)).collect()
    }

    /// What of a picture is at a byte: its class and its name; of a point its link.
    #[must_use]
    pub fn marked(&self, byte: usize) -> Option<(&'static str, String)> {
        let found = self.names.declarations(self.names.at(byte)?);
        let of_kind = |kind, class| {
            let one = found.iter().find(|d| d.kind == kind)?;
            Some((class, one.name.clone()))
        };
        let owner = || found.iter().find_map(|d| Some(("link", d.owner.clone()?)));
        of_kind(SymbolKind::Pair, "pair").or_else(|| of_kind(SymbolKind::Link, "link")).or_else(owner)
    }

    fn declaration(&self, symbol: &Symbol) -> Declared {
        let text = self.source.text.get(symbol.whole.start..symbol.whole.end).unwrap_or_default();
        Declared {
            name: symbol.name.clone(),
            class: match symbol.kind {
                SymbolKind::Link => "link",
                SymbolKind::Pair => "pair",
                _ => "",
            },
            line: place(&self.source.text, symbol.whole.start).line,
            text: shown_in_line(text.lines().next().unwrap_or_default().trim_end()).to_string(),
            whole: symbol.whole,
        }
    }
}

// The mechanism at one position.

/// The mechanism at a position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The drawing; empty where nothing has a position.
    pub svg: String,
    /// The names of all positions that are solved.
    pub poses: Vec<String>,
    /// Where what is drawn is declared: groups of the drawing have its class and, in `data-name`, its name.
    pub places: Vec<Declared>,
}

impl Analysis {
    /// The scheme at the position of a name, else at the first.
    ///
    /// # Errors
    /// There is no such position, in words.
    pub fn picture(&self, results: &Results, pose: Option<&str>) -> Result<Picture, String> {
        let solved = results.solved.as_ref().ok_or("the text has no solution")?;
        let file = (self.source.name.as_str(), self.source.text.as_str());
        let scene = Scene::of(solved.compiled.model(), &solved.solution, file, pose);
        let drawings = scene.and_then(|scene| draw(Kind::Scheme, &scene, &Options::default()));
        let drawings = drawings.map_err(|missing| missing.to_string())?;
        let poses = solved.solution.poses.iter().filter(|pose| pose.outcome.is_ok());
        Ok(Picture {
            svg: drawings.into_iter().map(|drawing| drawing.placed().svg(Theme::Auto)).collect(),
            poses: poses.map(|pose| pose.name.clone()).collect(),
            places: self.declared(),
        })
    }
}
