//! The worked solution of a file.

use super::{Handout, KINDS, places, sizes, tables};
use crate::pipeline::{self, Solved};
use crate::report::PrintedDigits;
use assur_picture::Scene;
use assur_solve::solve::Pose;
use assur_syntax as syntax;
use assur_text::diagnostic::{Diagnosis, Problems};
use assur_text::source::Source;
use assur_worked::{Block, Data, Document, Figure, Inline, Language, Part, design, given, worked_from};

impl Handout<'_> {
    /// The worked solution: these parts of it, or all. `found` is what was wrong in the text.
    #[must_use]
    pub fn worked(&self, found: Problems, parts: &[Part]) -> (Option<Document>, Problems) {
        let (solved, mut problems) =
            pipeline::solve_document_drawn(self.source, &self.document, found, &self.overrides, &KINDS);
        let Some(solved) = solved else { return (None, problems) };
        let replaced = |name: &str| self.overrides.has(name);
        let at = (self.pose, parts);
        match document_with(self.source, &self.document, &solved, self.language, at, &replaced) {
            Ok(document) => (Some(document), problems),
            Err(missing) => {
                problems.push(missing);
                (None, problems)
            }
        }
    }
}

/// The solution of a file in a language: of a position, with some of its parts or all of them.
///
/// # Errors
/// There is no such position.
pub fn document(
    source: &Source,
    read: &syntax::document::Document,
    solved: &Solved,
    language: Language,
    at: (Option<&str>, &[Part]),
) -> Result<Document, Diagnosis> {
    document_with(source, read, solved, language, at, &|_| false)
}

/// The same of a file some of whose values are replaced, by name.
pub(super) fn document_with(
    source: &Source,
    read: &syntax::document::Document,
    solved: &Solved,
    language: Language,
    (pose, parts): (Option<&str>, &[Part]),
    replaced: &dyn Fn(&str) -> bool,
) -> Result<Document, Diagnosis> {
    let mechanism = &solved.compiled.mechanism;
    let in_table = |_: &str| false;
    let data = Data {
        document: read,
        mechanism,
        scene: None,
        in_table: &in_table,
        replaced,
        figure: !solved.solution.poses.is_empty(),
        plots: false,
        headings: false,
        position: None,
    };
    if solved.solution.poses.is_empty() && pose.is_none() {
        return Ok(without_position(language, source, solved, data));
    }
    let file = (source.name.as_str(), source.text.as_str());
    let pose = pose.or_else(|| moving(solved));
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, pose)?;
    let sizes = sizes::sizes(read, &solved.compiled.mechanism);
    let formulas = sizes::formulas(read, &solved.compiled.mechanism);
    let named = pose
        .filter(|_| solved.solution.poses.len() > 1)
        .map(|_| places::drives_at(&solved.answers(PrintedDigits::READABLE), scene.pose));
    let data = Data { scene: Some(scene), position: named.as_deref(), ..data };
    let mut document = worked_from(scene, language, parts, (&sizes, &formulas), Some(data)).document;
    if parts.is_empty() || parts.contains(&Part::Results) {
        let more = tables::blocks(source, solved, Some(&scene), language);
        document.blocks.extend(without_repeated(&document.blocks, more));
    }
    Ok(document)
}

/// Blocks without the figures that are there already: the scheme of a train is its section, a motion begins with its plot.
fn without_repeated(there: &[Block], more: Vec<Block>) -> Vec<Block> {
    let is_same = |one: &Figure, two: &Figure| one.svg == two.svg || one.name == "plot" && two.name == "plot";
    let shown = |figure: &Figure| {
        there.iter().any(|b| matches!(b, Block::Figures(all) if all.iter().any(|one| is_same(one, figure))))
    };
    let left = |block| match block {
        Block::Figures(mut figures) => {
            figures.retain(|figure| !shown(figure));
            (!figures.is_empty()).then_some(Block::Figures(figures))
        }
        block => Some(block),
    };
    more.into_iter().filter_map(left).collect()
}

/// The name of the first position at which nothing is at rest, of several; the first where there is none.
fn moving(solved: &Solved) -> Option<&str> {
    let poses = &solved.solution.poses;
    if poses.len() < 2 {
        return None;
    }
    let is_moving = |pose: &&Pose| {
        pose.outcome.as_ref().is_ok_and(|at| {
            let rates = at.state.motion.bodies.iter().skip(1).map(|b| b.omega.abs() + b.v.norm());
            let largest = rates.clone().fold(0.0, f64::max);
            largest > 0.0 && rates.fold(f64::INFINITY, f64::min) > 1e-6 * largest
        })
    };
    poses.iter().find(is_moving).map(|pose| pose.name.as_str())
}

/// Of a file without positions: its text, and the tables of its cams, gears and flywheels.
fn without_position(language: Language, source: &Source, solved: &Solved, data: Data<'_>) -> Document {
    let mechanism = &solved.compiled.mechanism;
    let mut document = Document { language: language.code(), ..Document::default() };
    document.title = if mechanism.title.is_empty() { source.name.clone() } else { mechanism.title.clone() };
    let notes = mechanism.notes.join(" ");
    if !notes.is_empty() {
        document.blocks.push(Block::Paragraph(vec![Inline::Text(notes)]));
    }
    document.blocks.extend(given(data, language));
    let page = design(solved.compiled.model(), &solved.solution, language);
    document.blocks.extend(page.blocks);
    document.blocks.extend(tables::blocks(source, solved, None, language).into_iter().map(
        |block| match block {
            Block::Heading(_, words) => Block::Heading(2, words),
            block => block,
        },
    ));
    document
}
