//! The pictures of a solved file, as text.

use super::{Drawing, output};
#[cfg(feature = "gif")]
use crate::cli::args::DrawFormat;
use crate::cli::args::{Choice, Picture};
use crate::cli::error::CliError;
use crate::cli::variant_rows::ChosenRow;
use crate::pipeline::{self, Solved};
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_math::math::Vec2;
use assur_model::model::{Mechanism, Positions};
use assur_picture::{Kind, Options, Place, Scales, Scene, Scheme, Subject};
use assur_solve::solve::{Pose, PoseOrigin};
use assur_syntax::document::Document;
use assur_text::diagnostic::{Diagnosis, Problems};
use assur_text::source::Source;
use assur_worked::{Language, drawing_in, phrase};
use std::borrow::Cow;

/// A picture as text, with the name of its file.
pub struct Page {
    /// Of its file, without its ending.
    pub name: String,
    /// The folder of the file that is drawn, as a title.
    pub chapter: String,
    pub text: String,
    pub ending: &'static str,
    /// The frames, where there is a picture of each.
    #[cfg(feature = "gif")]
    pub film: Option<assur_picture::Film>,
}

/// What pictures are made of.
pub struct Pages<'d, 'a> {
    pub drawing: &'d Drawing<'a>,
    /// The text of the file.
    pub source: &'d Source,
    /// The same as statements.
    pub document: &'d Document,
    pub solved: &'d Solved,
    /// The row of variants.
    pub row: &'d ChosenRow,
}

/// Positions in small steps, for paths and other poses and for an animation.
struct Ways {
    turn: Vec<Pose>,
    frames: Vec<Pose>,
    /// The frames have all effects.
    arrows: bool,
}

impl Pages<'_, '_> {
    pub fn all(&self, problems: &mut Problems) -> Vec<Page> {
        let mut found = Problems::new();
        let scenes = self.scenes(&mut found);
        let pictures = self.pictures(scenes.first());
        if pictures.is_empty() || pictures.iter().any(|picture| picture.kind.needs().place.is_needed()) {
            problems.append(found);
        }
        let ways = self.ways(&pictures);
        let (mut pages, mut lacking) = (Vec::new(), Vec::new());
        for picture in &*pictures {
            let plotted = items(self.source, &self.solved.compiled.mechanism, &picture.of);
            let options = Options { plotted, of: picture.of.clone(), arrows: ways.arrows, ..self.options() };
            let turn = if picture.kind == Kind::Animation { &ways.frames } else { &ways.turn };
            let mut shown: Vec<Option<&Scene<'_>>> = scenes.iter().map(Some).collect();
            match picture.kind.needs().place {
                Place::File => shown = vec![None],
                Place::Way => shown.truncate(1),
                Place::Any if shown.is_empty() => shown.push(None),
                Place::Any | Place::Pose => {}
            }
            for scene in shown {
                let name = self.name(picture, scene.filter(|_| scenes.len() > 1));
                let scene = scene.map(|scene| Scene { turn, ..*scene });
                match self.drawn(picture.kind, &self.subject(scene.as_ref()), &options, &name) {
                    Ok(drawn) => pages.extend(drawn),
                    // of all kinds those are left out that the file has no effects for
                    Err(_) if self.drawing.args.all => {}
                    Err(missing) => {
                        // what lacks at every pose is said once
                        let words = missing.to_string();
                        if !lacking.contains(&words) {
                            lacking.push(words);
                            problems.push(missing);
                        }
                    }
                }
            }
        }
        if scenes.is_empty() && self.drawing.args.choice() == Choice::First && self.drawing.output.is_single()
        {
            // a cam has two
            pages.truncate(1);
        }
        pages
    }

    /// What is drawn, at a position or without one.
    fn subject<'s>(&'s self, scene: Option<&'s Scene<'s>>) -> Subject<'s, 's> {
        let Solved { compiled, solution, .. } = self.solved;
        scene.map_or_else(
            || Subject::without_position(&compiled.mechanism, solution, &self.source.name),
            Subject::from,
        )
    }

    /// The pictures that are wanted: where none is named all that the file has, or the first.
    fn pictures<'s>(&'s self, scene: Option<&'s Scene<'s>>) -> Cow<'s, [Picture]> {
        let subject = self.subject(scene);
        let kinds = match self.drawing.args.choice() {
            Choice::Named => return Cow::Borrowed(&self.drawing.pictures),
            Choice::All => subject.kinds(),
            Choice::First => subject.first_kind().into_iter().collect(),
        };
        kinds.into_iter().map(Picture::from).collect()
    }

    fn ways(&self, pictures: &[Picture]) -> Ways {
        let args = self.drawing.args;
        let (compiled, solution) = (&self.solved.compiled, &self.solved.solution);
        let animated = pictures.iter().any(|picture| picture.kind == Kind::Animation);
        let traced = args.ghosts > 0 || !args.path.is_empty();
        let turn = if traced { pipeline::turn(compiled, solution) } else { Vec::new() };
        let (frames, arrows) = match self.frames() {
            _ if !animated => (Vec::new(), false),
            count if args.arrows.is_some() => pipeline::turn_with_effects(compiled, solution, count),
            Some(count) => (pipeline::turn_in(compiled, solution, count), false),
            None => (pipeline::turn(compiled, solution), false),
        };
        Ways { turn, frames, arrows }
    }

    /// The number of frames that is wanted.
    fn frames(&self) -> Option<usize> {
        self.drawing.args.frames_in(self.drawing.output.format())
    }

    fn options(&self) -> Options {
        let args = self.drawing.args;
        let scales = args.scale.iter().fold(Scales::default(), |all, (of, scale)| all.with(*of, *scale));
        let mut scheme = Scheme {
            loads: args.loads.into(),
            ghosts: args.ghosts,
            paths: args.path.clone(),
            scales,
            numbers: args.numbers,
            ..Scheme::default()
        };
        if args.dimensions {
            scheme.dimensions = pipeline::dimensions(self.document, &self.solved.compiled.mechanism);
        }
        if let Some((width, height)) = args.size {
            (scheme.size, scheme.grows) = (Vec2::new(width, height), false);
        }
        Options { scheme, frames: self.frames(), shown: args.arrows.map(Into::into), ..Options::default() }
    }

    /// The name of the file of a picture.
    fn name(&self, picture: &Picture, of_several: Option<&Scene<'_>>) -> String {
        let mut name = format!("{}-{}", self.stem(), picture.kind.name());
        if !picture.of.is_empty() {
            name += &format!("-{}", picture.of);
        }
        if let Some(scene) = of_several.filter(|_| picture.kind.needs().place.is_of_position()) {
            name += &format!("-{}", scene.pose.name);
        }
        output::file_name(&name)
    }

    /// The pictures of a kind at a position; an animation is a page of its own where the output is not one.
    fn drawn(
        &self,
        kind: Kind,
        subject: &Subject<'_, '_>,
        options: &Options,
        name: &str,
    ) -> Result<Vec<Page>, Diagnosis> {
        let Some(scene) = subject.scene else {
            return Ok(self.numbered(name, assur_picture::draw(kind, *subject, options)?));
        };
        #[cfg(feature = "gif")]
        if self.drawing.output.format().is_some_and(DrawFormat::is_film) {
            return Ok(vec![self.film(scene, options, name)?]);
        }
        if kind == Kind::Animation && !self.drawing.output.is_still() {
            let (theme, language) = (self.drawing.args.theme.into(), self.language());
            let (text, ending) = if self.drawing.output.is_picture() {
                (assur_picture::moving(scene, options, theme, &language)?, "svg")
            } else {
                (assur_picture::animation(scene, options, theme, &language)?, "html")
            };
            return Ok(vec![self.page(name.to_owned(), text, ending)]);
        }
        if kind == Kind::Scheme && self.drawing.args.true_size {
            return Ok(self.numbered(name, vec![assur_picture::true_size(scene, &options.scheme)?]));
        }
        Ok(self.numbered(name, assur_picture::draw(kind, scene, options)?))
    }

    /// A picture as text.
    fn page(&self, name: String, text: String, ending: &'static str) -> Page {
        Page {
            name,
            chapter: self.chapter(),
            text,
            ending,
            #[cfg(feature = "gif")]
            film: None,
        }
    }

    /// An animation as its frames.
    #[cfg(feature = "gif")]
    fn film(&self, scene: &Scene<'_>, options: &Options, name: &str) -> Result<Page, Diagnosis> {
        let theme = match self.drawing.args.theme.into() {
            // nothing in it follows the reader
            Theme::Auto => Theme::Light,
            theme => theme,
        };
        let film = assur_picture::film(scene, options, theme, &self.language())?;
        let ending = self.drawing.output.format().map_or("", DrawFormat::ending).trim_start_matches('.');
        Ok(Page { film: Some(film), ..self.page(name.to_owned(), String::new(), ending) })
    }

    fn language(&self) -> Language {
        self.drawing.args.language.into()
    }

    /// The begin of the names of pictures.
    fn stem(&self) -> String {
        let name = &self.source.name;
        let stem = if self.drawing.several { path_in_one(name) } else { stem(name) };
        if self.row.name.is_empty() { stem } else { format!("{stem}-row-{}", self.row.name) }
    }

    /// The folder of the file as a title: `Mass substitution` of `mass-substitution`.
    fn chapter(&self) -> String {
        let mut folders = self.source.name.rsplit(['/', '\\']).skip(1);
        let folder = folders.next().filter(|folder| !matches!(*folder, "." | "..")).unwrap_or_default();
        let mut letters = folder.chars().map(|c| if matches!(c, '-' | '_') { ' ' } else { c });
        letters.next().into_iter().flat_map(char::to_uppercase).collect::<String>()
            + &letters.collect::<String>()
    }

    /// Pictures of one kind and one position as text, numbered where there are several.
    fn numbered(&self, name: &str, drawings: Vec<assur_drawing::Drawing>) -> Vec<Page> {
        let theme: Theme = self.drawing.args.theme.into();
        let many = drawings.len() > 1;
        let words = &self.row.words;
        let (language, mechanism) = (self.language(), &self.solved.compiled.mechanism);
        let pages = drawings.into_iter().enumerate().map(|(i, drawing)| {
            let mut drawing = drawing_in(language, mechanism, drawing);
            let name = if many { format!("{name}-{}", i + 1) } else { name.to_owned() };
            if self.drawing.several || !words.is_empty() {
                // two files of one name, and rows of a table, may be in one page
                drawing.id.clone_from(&name);
            }
            if !words.is_empty() {
                drawing.title += &format!(", {}", phrase(language, words));
            }
            let sheet = drawing.placed();
            let (text, ending) = self.drawing.output.text(&sheet, theme);
            self.page(name, text, ending)
        });
        pages.collect()
    }

    /// The positions that are shown: those named, else all of a list, the first of a sweep.
    fn scenes(&self, problems: &mut Problems) -> Vec<Scene<'_>> {
        let (solved, named) = (self.solved, &self.drawing.args.pose);
        let file = (self.source.name.as_str(), self.source.text.as_str());
        let of = |name: Option<&str>| Scene::of(solved.compiled.model(), &solved.solution, file, name);
        let listed = if named.is_empty() { listed(solved) } else { Vec::new() };
        let drawn = if self.drawing.output.is_single() { listed.len().min(1) } else { listed.len() };
        if drawn < listed.len()
            && self.drawing.pictures.iter().any(|picture| picture.kind.needs().place.is_of_position())
        {
            let (first, count) = (listed[0].to_owned(), listed.len());
            problems.push(CliError::FirstPose { first, count });
        }
        let all = named.iter().map(String::as_str).chain(listed[..drawn].iter().copied());
        let mut names: Vec<Option<&str>> = Vec::new();
        for name in all.map(Some) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        if names.is_empty() {
            names.push(None);
        }
        let mut scenes = Vec::new();
        for scene in names.into_iter().map(of) {
            match scene {
                Ok(scene) => scenes.push(scene),
                Err(missing) => problems.push(missing),
            }
        }
        scenes
    }
}

/// The file's name without folders and ending.
fn stem(name: &str) -> String {
    let last = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let stem = last.strip_suffix(".mech").unwrap_or(last);
    if stem == "-" { "picture".to_owned() } else { stem.to_owned() }
}

/// The file's name with its folders, so that two of one name in two folders are apart: `cams-lever` of `cams/lever.mech`.
fn path_in_one(name: &str) -> String {
    let parts = name.split(['/', '\\']).filter(|part| !part.is_empty() && *part != "." && *part != "..");
    stem(&parts.collect::<Vec<_>>().join("-"))
}

// Numbers to plot that are written on the command line: they become items of `find` behind the text, so that they are
// checked, and followed over the sweep, as if they stood in it.

/// The text with items of `find` for what is plotted and not asked for in it; none where it has all.
pub fn extended(source: &Source, overrides: &Overrides, pictures: &[Picture]) -> Option<Source> {
    let wanted = pictures.iter().filter(|p| p.kind == Kind::Plot).flat_map(|p| parts(&p.of));
    let wanted: Vec<&str> = wanted.collect();
    if wanted.is_empty() {
        return None;
    }
    let compiled = pipeline::compile(source, overrides).0;
    let known = |part: &&str| compiled.as_ref().is_some_and(|c| position(&c.mechanism, part).is_some());
    let mut text = String::new();
    for part in wanted.into_iter().filter(|part| !known(part)) {
        let line = format!("\nfind {part}");
        if !text.contains(&line) {
            text += &line;
        }
    }
    (!text.is_empty()).then(|| Source::new(&source.name, source.text.clone() + &text + "\n"))
}

/// The items of `find` that a plot shows, by index.
pub fn items(source: &Source, mechanism: &Mechanism, wanted: &str) -> Vec<usize> {
    let of = |part: &str| {
        let written = |i: &usize| {
            let span = mechanism.finds[*i].span;
            source.text.get(span.start..span.end).is_some_and(|text| same(text, part))
        };
        position(mechanism, part).or_else(|| (0..mechanism.finds.len()).find(written))
    };
    parts(wanted).into_iter().filter_map(of).collect()
}

/// The item of `find` of a name.
fn position(mechanism: &Mechanism, name: &str) -> Option<usize> {
    mechanism.finds.iter().position(|find| same(&find.name, name))
}

/// Whether two texts differ in blanks alone.
fn same(a: &str, b: &str) -> bool {
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
    letters(a) == letters(b)
}

/// The parts of a list between its commas, those in brackets aside.
fn parts(list: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0_i32, 0);
    for (at, c) in list.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(list[start..].trim());
    parts.retain(|part| !part.is_empty());
    parts
}

// The positions that are drawn where none is named.

/// The names of the solved poses of a list, those of `pose` with them; of a motion under loads the first and the last. None where a
/// drive goes through a range.
pub fn listed(solved: &Solved) -> Vec<&str> {
    let drives = &solved.compiled.mechanism.drives;
    if drives.iter().any(|drive| matches!(drive.positions, Positions::Range { .. })) {
        return Vec::new();
    }
    let asked = |origin: PoseOrigin| !matches!(origin, PoseOrigin::Expected(_));
    let poses = solved.solution.poses.iter().filter(|pose| asked(pose.origin) && pose.outcome.is_ok());
    let mut names: Vec<&str> = poses.map(|pose| pose.name.as_str()).collect();
    if solved.compiled.mechanism.simulation.is_some() && names.len() > 2 {
        names.drain(1..names.len() - 1);
    }
    names
}
