//! What a page asks for besides its text: pictures, the motion, answers as tables, files.

use super::{Analysis, Declared, Results};
use crate::handout::{self, Handout, Pictured, Sheets};
use crate::pipeline::{Solved, solve_document_drawn};
use crate::report::document::Report;
use crate::report::{AccuracyShown, PrintedDigits, of_answers};
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_picture::{ArrowKind, KINDS, Kind, Moving};
use assur_text::diagnostic::{Diagnosis, Problems, did_you_mean};
use assur_worked::{Document, Language, html};
use serde::Deserialize;

/// What is wanted of a text; each question uses a part of it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
pub struct Wish {
    /// The name of a position.
    pub pose: Option<String>,
    /// A part of the way, from 0 to 1, where no position is named.
    pub part: Option<f64>,
    /// A kind of picture.
    pub kind: Option<String>,
    /// One of the files.
    pub what: Option<String>,
    /// A kind of arrows, or `none`.
    pub show: Option<String>,
    pub theme: Option<String>,
    /// `en`, `ru`, `zh`.
    pub language: Option<String>,
}

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

/// A file that a page saves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    pub name: String,
    /// Its type of media: `text/html`.
    pub kind: &'static str,
    pub text: String,
}

/// The files that can be written, with their types of media.
pub const FILES: [(&str, &str); 7] = [
    ("solution.json", "application/json"),
    ("poses.csv", "text/csv"),
    ("worked.html", "text/html"),
    ("sheet.html", "text/html"),
    ("key.html", "text/html"),
    ("motion.html", "text/html"),
    ("motion.svg", "image/svg+xml"),
];

impl Wish {
    pub(super) fn language(&self) -> Result<Language, String> {
        let all = [Language::English, Language::Russian, Language::Chinese];
        one_of("language", self.language.as_deref().unwrap_or("en"), &all.map(|one| (one.code(), one)))
    }

    fn theme(&self) -> Result<Theme, String> {
        let all = [("auto", Theme::Auto), ("light", Theme::Light), ("dark", Theme::Dark)];
        one_of("theme", self.theme.as_deref().unwrap_or("auto"), &all)
    }

    fn arrows(&self) -> Result<Option<ArrowKind>, String> {
        let Some(name) = self.show.as_deref().filter(|name| *name != "none") else { return Ok(None) };
        one_of("kind of arrows", name, &ArrowKind::ALL.map(|one| (one.name(), one))).map(Some)
    }

    fn kind(&self) -> Result<Kind, String> {
        one_of(
            "kind of picture",
            self.kind.as_deref().unwrap_or("scheme"),
            &KINDS.map(|one| (one.name(), one)),
        )
    }

    /// The name of the position; none where the first one is meant.
    fn pose<'s>(&'s self, solved: &'s Solved) -> Option<&'s str> {
        if self.pose.is_some() {
            return self.pose.as_deref();
        }
        let part = self.part?.clamp(0.0, 1.0);
        let found: Vec<_> = solved.solution.poses.iter().filter(|pose| pose.outcome.is_ok()).collect();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        // a part of a count
        let index = (part * found.len().saturating_sub(1) as f64).round() as usize;
        found.get(index).map(|pose| pose.name.as_str())
    }
}

/// What has a name, or the names that there are.
fn one_of<T: Copy>(what: &str, name: &str, all: &[(&str, T)]) -> Result<T, String> {
    let found = all.iter().find(|one| one.0 == name).map(|one| one.1);
    found.ok_or_else(|| {
        let names = all.iter().map(|one| one.0);
        let help = match did_you_mean(name, names.clone()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => {
                format!("there are {}", names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "))
            }
        };
        format!("there is no {what} `{name}`: {help}")
    })
}

impl Analysis {
    /// The scheme at a position, or the first picture of a text without one.
    ///
    /// # Errors
    /// There is no such position, in words.
    pub fn picture(&self, results: &Results, wish: &Wish) -> Result<Picture, String> {
        let solved = solution(results)?;
        let none = Overrides::none();
        let pictured = self.pictured(&none, wish.language()?);
        let drawn = pictured.drawn(solved, pictured.first_kind(solved), wish.pose(solved));
        let poses = solved.solution.poses.iter().filter(|pose| pose.outcome.is_ok());
        Ok(Picture {
            svg: drawn.map_err(in_words)?.concat(),
            poses: poses.map(|pose| pose.name.clone()).collect(),
            places: self.declared(),
        })
    }

    /// The mechanism in motion, with arrows of a kind, for which it is solved again if the text does not call for them.
    ///
    /// # Errors
    /// There is no such motion, in words.
    pub fn motion(&self, results: &Results, wish: &Wish) -> Result<Moving, String> {
        let solved = solution(results)?;
        let none = Overrides::none();
        let pictured = self.pictured(&none, wish.language()?);
        let Some(arrows) = wish.arrows()? else { return pictured.moving(solved, None).map_err(in_words) };
        let more = self.solved_for(&[arrows.kind()])?;
        pictured.moving(&more, Some(arrows)).map_err(in_words)
    }

    /// The answers as tables.
    ///
    /// # Errors
    /// There are none, in words.
    pub fn report(&self, results: &Results) -> Result<Report, String> {
        let answers = solution(results)?.answers(PrintedDigits::READABLE);
        Ok(of_answers(&self.source.name, &answers, AccuracyShown::Worst))
    }

    /// The kinds of pictures that the text has.
    ///
    /// # Errors
    /// It has no answers, in words.
    pub fn kinds(&self, results: &Results) -> Result<Vec<&'static str>, String> {
        let solved = solution(results)?;
        let none = Overrides::none();
        let more = self.solved_for(&KINDS).ok();
        let kinds = self.pictured(&none, Language::English).kinds(more.as_ref().unwrap_or(solved));
        Ok(kinds.into_iter().map(Kind::name).collect())
    }

    /// Pictures of a kind as SVG; an animation is a page.
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn drawn(&self, wish: &Wish) -> Result<Vec<String>, String> {
        let (kind, theme) = (wish.kind()?, wish.theme()?);
        let solved = self.solved_for(&[kind])?;
        let none = Overrides::none();
        let pictured = Pictured { theme, ..self.pictured(&none, wish.language()?) };
        pictured.drawn(&solved, kind, wish.pose(&solved)).map_err(in_words)
    }

    /// A file of the answers: one of [`FILES`].
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn file(&self, wish: &Wish) -> Result<Written, String> {
        let what = wish.what.as_deref().unwrap_or_default();
        let (what, kind) = one_of("file", what, &FILES.map(|file| (file.0, file)))?;
        let text = match what {
            "solution.json" => handout::solution(&self.source),
            "poses.csv" => handout::poses(&self.source),
            "worked.html" => self.handout(wish, |handout, found| handout.worked(found, &[]))?,
            "sheet.html" => self.handout(wish, |handout, found| Sheets::of(handout, found).for_all())?,
            "key.html" => self.handout(wish, |handout, found| Sheets::of(handout, found).key())?,
            "motion.svg" => {
                let solved = self.solved_for(&[Kind::Animation])?;
                let none = Overrides::none();
                self.pictured(&none, wish.language()?).without_script(&solved).map_err(in_words)?
            }
            _ => {
                let kind = Some(Kind::Animation.name().to_owned());
                self.drawn(&Wish { kind, pose: None, part: None, ..wish.clone() })?.concat()
            }
        };
        let stem = self.source.name.rsplit(['/', ':']).next().unwrap_or_default();
        let stem = stem.strip_suffix(".mech").unwrap_or(stem);
        Ok(Written { name: format!("{stem}-{what}"), kind, text })
    }

    /// A document for people, as a page.
    fn handout(
        &self,
        wish: &Wish,
        made: impl FnOnce(&Handout<'_>, Problems) -> (Option<Document>, Problems),
    ) -> Result<String, String> {
        if self.problems.has_errors() {
            return Err(first(&self.problems));
        }
        let pose = match (&wish.pose, wish.part) {
            (None, Some(_)) => wish.pose(&self.solved_for(&[])?).map(str::to_owned),
            (pose, _) => pose.clone(),
        };
        let language = wish.language()?;
        let document = self.document.clone();
        let handout = Handout::new(&self.source, document, Overrides::none(), language, pose.as_deref());
        let (document, problems) = made(&handout, Problems::new());
        document.map(|document| html(&document)).ok_or_else(|| first(&problems))
    }

    /// The text solved with all that some kinds of pictures show.
    fn solved_for(&self, kinds: &[Kind]) -> Result<Solved, String> {
        if self.problems.has_errors() {
            return Err(first(&self.problems));
        }
        let none = Overrides::none();
        let (solved, problems) =
            solve_document_drawn(&self.source, &self.document, Problems::new(), &none, kinds);
        solved.ok_or_else(|| first(&problems))
    }

    pub(super) const fn pictured<'a>(&'a self, overrides: &'a Overrides, language: Language) -> Pictured<'a> {
        Pictured { source: &self.source, document: &self.document, overrides, language, theme: Theme::Auto }
    }
}

fn solution(results: &Results) -> Result<&Solved, String> {
    results.solved.as_ref().ok_or_else(|| "the text has no solution".to_owned())
}

fn in_words(missing: Diagnosis) -> String {
    let help = miette::Diagnostic::help(&missing).map(|help| format!(" ({help})"));
    format!("{missing}{}", help.unwrap_or_default())
}

/// The first error, in words.
fn first(problems: &Problems) -> String {
    problems.sorted().first().map_or_else(|| "the text has no solution".to_owned(), |one| one.to_string())
}
