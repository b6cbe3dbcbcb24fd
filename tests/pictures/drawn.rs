//! Pictures of a text, and what holds for the marks of every picture.

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::drawing::{Obstacle, Rect, Sheet, Style, Theme, touches};
use assur::internals::picture::{KINDS, Kind, Options, Scene, animation, draw};
use assur::internals::pipeline::solve_drawn;
use assur::internals::source::Source;

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
    animation(&scene, &Options::default(), Theme::Auto).ok()
}

/// The same as one picture without a script.
pub fn moving_picture(source: &Source, solved: &Solved) -> Option<String> {
    let turn = assur::internals::pipeline::turn(&solved.compiled, &solved.solution);
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let scene = Scene { turn: &turn, ..scene };
    assur::internals::picture::moving(&scene, &Options::default(), Theme::Auto).ok()
}

/// All pictures of a kind, of the first position or of all.
pub fn sheets(source: &Source, solved: &Solved, kind: Kind, every_pose: bool) -> Vec<Sheet> {
    let model = solved.compiled.model();
    let file = (source.name.as_str(), source.text.as_str());
    let poses = solved.solution.poses.iter().filter(|p| p.outcome.is_ok());
    let poses = poses.take(if every_pose && !kind.is_of_sweep() { 8 } else { 1 });
    let scenes = poses.filter_map(|pose| Scene::of(model, &solved.solution, file, Some(&pose.name)).ok());
    let drawings = scenes.filter_map(|scene| draw(kind, &scene, &Options::default()).ok()).flatten();
    drawings.map(|drawing| drawing.placed()).collect()
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
