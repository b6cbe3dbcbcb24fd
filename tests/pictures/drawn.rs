//! Pictures of a text, and what holds for the marks of every picture.

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::drawing::{Drawing, Obstacle, Rect, Sheet, Style, Theme, touches};
use assur::internals::model::{Drive, Positions};
use assur::internals::picture::{KINDS, Kind, Options, Place, Scene, Subject, animation, draw};
use assur::internals::pipeline::solve_drawn;
use assur::internals::solve::{Model, Pose, Solution};
use assur::internals::source::Source;
use assur::internals::worked::Language;

/// A solved text; none where it has errors.
pub fn solved(name: &str, text: &str) -> Option<(Source, Solved)> {
    let source = Source::new(name, text);
    solve_drawn(&source, &Overrides::none(), &KINDS).0.map(|solved| (source, solved))
}

/// The scheme with other poses and the path of a point, where the drive has a way.
pub fn moving(source: &Source, solved: &Solved) -> Option<Sheet> {
    let turn = assur::internals::pipeline::turn(&solved.compiled, &solved.solution);
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let links = solved.compiled.mechanism.links.iter().skip(1);
    let path = links.filter_map(|l| Some(format!("{}.{}", l.name, l.points.last()?.name))).next();
    let mut options = Options::default();
    options.scheme.ghosts = 12;
    options.scheme.paths.extend(path);
    let scene = Scene { turn: &turn, ..scene };
    draw(Kind::Scheme, &scene, &options).ok()?.into_iter().next().map(|drawing| drawing.placed())
}

/// The page of the mechanism in motion, where it moves.
pub fn animated(source: &Source, solved: &Solved) -> Option<String> {
    let turn = assur::internals::pipeline::turn(&solved.compiled, &solved.solution);
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let scene = Scene { turn: &turn, ..scene };
    animation(&scene, &Options::default(), Theme::Auto, &Language::English).ok()
}

/// The same as one picture without a script.
pub fn moving_picture(source: &Source, solved: &Solved) -> Option<String> {
    let turn = assur::internals::pipeline::turn(&solved.compiled, &solved.solution);
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let scene = Scene { turn: &turn, ..scene };
    assur::internals::picture::moving(&scene, &Options::default(), Theme::Auto, &Language::English).ok()
}

/// A solution that is drawn.
#[derive(Clone, Copy)]
pub struct Shown<'a> {
    pub model: Model<'a>,
    pub solution: &'a Solution,
    /// Name and text.
    pub file: (&'a str, &'a str),
}

/// The most positions of a list or of a sweep that are drawn.
const POSES: usize = 8;

impl<'a> Shown<'a> {
    pub fn of(source: &'a Source, solved: &'a Solved) -> Self {
        let file = (source.name.as_str(), source.text.as_str());
        Self { model: solved.compiled.model(), solution: &solved.solution, file }
    }

    /// The positions that are drawn: of a sweep some over all of it, else all.
    pub fn poses(&self, every: bool) -> Vec<&'a Pose> {
        let solved: Vec<&Pose> = self.solution.poses.iter().filter(|p| p.outcome.is_ok()).collect();
        let sweeps = |d: &Drive| matches!(d.positions, Positions::Range { .. });
        let swept = self.model.mechanism.drives.iter().any(sweeps);
        let most = if !every {
            1
        } else if swept {
            POSES
        } else {
            solved.len()
        };
        let step = (solved.len() as f64 / most.max(1) as f64).max(1.0);
        (0..most).filter_map(|i| solved.get((i as f64 * step) as usize).copied()).collect()
    }

    /// Pictures of a kind at a position.
    pub fn drawn(&self, kind: Kind, pose: &Pose) -> Vec<Sheet> {
        let Ok(scene) = Scene::of(self.model, self.solution, self.file, Some(&pose.name)) else {
            return Vec::new();
        };
        let drawings = draw(kind, &scene, &Options::default()).unwrap_or_default();
        drawings.into_iter().map(Drawing::placed).collect()
    }

    /// Pictures of a kind, of the first position or of all.
    pub fn sheets(&self, kind: Kind, every: bool) -> Vec<(&'a Pose, Sheet)> {
        let poses = self.poses(every && kind.needs().place.is_of_position()).into_iter();
        poses.flat_map(|pose| self.drawn(kind, pose).into_iter().map(move |sheet| (pose, sheet))).collect()
    }
}

/// Pictures of a kind at the first position, or without one.
pub fn sheets(source: &Source, solved: &Solved, kind: Kind) -> Vec<Sheet> {
    let place = kind.needs().place;
    if place == Place::File || !place.is_needed() && solved.solution.poses.is_empty() {
        let (mechanism, solution) = (&solved.compiled.mechanism, &solved.solution);
        let subject = Subject::without_position(mechanism, solution, &source.name);
        let drawings = draw(kind, subject, &Options::default()).unwrap_or_default();
        return drawings.into_iter().map(Drawing::placed).collect();
    }
    Shown::of(source, solved).sheets(kind, false).into_iter().map(|(_, sheet)| sheet).collect()
}

/// What is wrong with a sheet.
pub fn faults(sheet: &Sheet) -> Vec<String> {
    let mut faults = Vec::new();
    let labels: Vec<(String, Rect)> = sheet.placed.iter().map(|p| (p.label.text.plain(), p.bounds)).collect();
    for (i, (a, first)) in labels.iter().enumerate() {
        for (b, second) in &labels[i + 1..] {
            if first.overlaps(second) {
                faults.push(format!("the label {a} lies on the label {b}"));
            }
        }
    }
    for mark in sheet.drawing.marks.iter().filter(|m| m.style.is_solid()) {
        for obstacle in mark.shape.obstacles(mark.style.half_width()) {
            for (placed, (name, bounds)) in sheet.placed.iter().zip(&labels) {
                let round = placed.label.ring.is_some_and(|r| placed.label.half().x <= r);
                if touches(bounds, round, &obstacle, 0.0) {
                    let what = if matches!(obstacle, Obstacle::Disc(..)) { "disc" } else { "stroke" };
                    faults.push(format!("the label {name} lies on a {what} of {:?}", mark.style));
                }
            }
        }
    }
    for mark in &sheet.drawing.marks {
        if !sheet.bounds.contains(&mark.shape.bounds()) && mark.style != Style::Number {
            faults.push(format!("a mark of {:?} is off the sheet: {:?}", mark.style, mark.shape));
        }
    }
    for (name, bounds) in &labels {
        if !sheet.bounds.contains(bounds) {
            faults.push(format!("the label {name} is off the sheet"));
        }
    }
    let size = sheet.bounds.size();
    if !(size.x.is_finite() && size.y.is_finite()) {
        faults.push(format!("the sheet has no size: {size:?}"));
    }
    faults.extend(document_faults(sheet));
    faults
}

/// What is wrong with the document.
fn document_faults(sheet: &Sheet) -> Vec<String> {
    let mut faults = Vec::new();
    for theme in [Theme::Auto, Theme::Mono] {
        let text = sheet.svg(theme);
        if text != sheet.svg(theme) {
            faults.push("two runs give different bytes".to_owned());
        }
        if let Err(fault) = crate::xml::check(&text) {
            faults.push(format!("no XML: {fault}"));
        }
        for forbidden in ["var(", "<script", "NaN", "inf", "-0\"", "href"] {
            let body = text.split_once("</desc>").map_or(text.as_str(), |(_, body)| body);
            let geometry = body.split('<').filter_map(|tag| tag.split_once('>').map(|(tag, _)| tag));
            if geometry
                .filter(|tag| !tag.contains("data-name") && !tag.contains("aria-label"))
                .any(|tag| tag.contains(forbidden))
            {
                faults.push(format!("the document contains {forbidden}"));
            }
        }
        if !text.contains("<title ") || !text.contains("<desc ") || text.contains("-d\"></desc>") {
            faults.push("title or description is missing".to_owned());
        }
        if text.replace("http://www.w3.org/2000/svg", "").contains("http") {
            faults.push("the document names an address".to_owned());
        }
    }
    faults
}
