//! `assur report`

mod published;
mod sheets;
mod sizes;
mod tables;
mod texts;

use crate::cli::args::{Report, ReportFormat};
use crate::cli::draw::file_name;
use crate::cli::error::CliError;
use crate::cli::files::{self, Input};
use crate::cli::reply::{Printer, Reply, Status, complaint, for_each_input};
use crate::cli::screen::Screen;
use crate::cli::sink::Sink;
use crate::pipeline::{self, Solved};
use assur_picture::{Kind, Scene};
use assur_solve::solve::Pose;
use assur_syntax as syntax;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Source;
use assur_worked::{
    Block, Document, Inline, Language, Part, design, html, markdown, text, typst, worked_from,
};
use sheets::Sheets;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What is solved for a solution: all that its pictures show.
const KINDS: [Kind; 4] = [Kind::Scheme, Kind::Velocities, Kind::Accelerations, Kind::Forces];

pub fn run(args: &Report, screen: &Screen) -> Status {
    let inputs = files::expand(&args.files);
    let refused = |error| {
        screen.complain(&complaint(error, screen));
        Status::Unusable
    };
    let out = args.out.as_deref().filter(|name| *name != "-");
    let Some(format) = args.format() else {
        return refused(CliError::ReportFormat { name: out.unwrap_or_default().to_owned() });
    };
    if let Some(folder) = args.folder() {
        if let Err(error) = files::made_folder(folder) {
            return refused(error);
        }
        let names = folder_names(&inputs);
        return for_each_input(inputs, &mut Printer::new(screen, "\n"), |source, _| {
            let name = names.get(&source.name).map_or("report", String::as_str);
            let key = if args.key { "-key" } else { "" };
            let out = folder.join(format!("{name}{key}.{}", format.ending())).display().to_string();
            of_file(&Report { out: Some(out), made_up: true, ..args.clone() }, format, source, screen)
        });
    }
    match out {
        Some(name) if inputs.len() > 1 => return refused(CliError::OneReport { name: name.to_owned() }),
        None if inputs.len() > 1 && format == ReportFormat::Html => {
            return refused(CliError::OneReport { name: "standard output".to_owned() });
        }
        _ => {}
    }
    for_each_input(inputs, &mut Printer::new(screen, "\n"), |source, _| of_file(args, format, source, screen))
}

/// The names of the files of a folder by those of the problems: without their folders where these tell none apart.
fn folder_names(inputs: &[Result<Input, CliError>]) -> BTreeMap<String, String> {
    let paths = inputs.iter().flatten().filter_map(|input| match input {
        Input::File(path) => Some(path),
        Input::Stdin => None,
    });
    let paths: Vec<&PathBuf> = paths.collect();
    let last = |path: &Path| {
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        file_name(&stem)
    };
    let mut named: BTreeMap<String, String> = BTreeMap::new();
    let mut taken: BTreeSet<String> = BTreeSet::new();
    for path in &paths {
        let own = last(path);
        let shared = paths.iter().filter(|other| last(other).eq_ignore_ascii_case(&own)).count() > 1;
        let folders =
            path.parent().map(|p| p.to_string_lossy().replace(['/', '\\'], "-")).unwrap_or_default();
        let long = file_name(&format!("{}-{own}", folders.trim_matches(['.', '-'])));
        let mut name = if shared { long } else { own };
        while !taken.insert(name.to_lowercase()) {
            name.push('\'');
        }
        named.insert(path.display().to_string(), name);
    }
    named
}

fn of_file(args: &Report, format: ReportFormat, source: &Source, screen: &Screen) -> Reply {
    let (read, found) = syntax::parse(source);
    let read = Arc::new(read);
    if args.sheet || args.key {
        return Sheets::new(args, format, source, read).reply(found, screen);
    }
    let overrides = args.overrides();
    let (solved, mut problems) = pipeline::solve_document_drawn(source, &read, found, &overrides, &KINDS);
    let Some(solved) = solved else { return Reply::new(String::new(), &problems, source, screen) };
    let made = document(source, &read, &solved, args.language.into(), (args.pose.as_deref(), &args.steps));
    let document = match made {
        Ok(document) => document,
        Err(missing) => {
            problems.push(missing);
            return Reply::new(String::new(), &problems, source, screen);
        }
    };
    match written(args, format, document, args.out.as_deref()) {
        Ok(results) => Reply::new(results, &problems, source, screen),
        Err(error) => {
            let diagnostics = screen.diagnostics(&problems, source) + &complaint(error, screen);
            Reply { results: String::new(), diagnostics, status: Status::Unusable }
        }
    }
}

/// The solution of a file in a language: of a position, with some of its parts or all of them.
///
/// # Errors
/// There is no such position.
#[doc(hidden)]
pub fn document(
    source: &Source,
    read: &syntax::document::Document,
    solved: &Solved,
    language: Language,
    (pose, parts): (Option<&str>, &[Part]),
) -> Result<Document, Diagnosis> {
    if solved.solution.poses.is_empty() && pose.is_none() {
        return Ok(without_position(language, source, solved));
    }
    let file = (source.name.as_str(), source.text.as_str());
    let pose = pose.or_else(|| moving(solved));
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, pose)?;
    let sizes = sizes::sizes(read, &solved.compiled.mechanism);
    let formulas = sizes::formulas(read, &solved.compiled.mechanism);
    let mut document = worked_from(scene, language, parts, (&sizes, &formulas)).document;
    if parts.is_empty() || parts.contains(&Part::Results) {
        let more = tables::blocks(source, solved, Some(&scene), language);
        document.blocks.extend(without_repeated(&document.blocks, more));
    }
    Ok(document)
}

/// Blocks without the figures that are there already: the scheme of a train is its section.
fn without_repeated(there: &[Block], more: Vec<Block>) -> Vec<Block> {
    let shown =
        |svg: &str| there.iter().any(|b| matches!(b, Block::Figures(f) if f.iter().any(|f| f.svg == svg)));
    let left = |block| match block {
        Block::Figures(mut figures) => {
            figures.retain(|figure| !shown(&figure.svg));
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
fn without_position(language: Language, source: &Source, solved: &Solved) -> Document {
    let mechanism = &solved.compiled.mechanism;
    let mut document = Document { language: language.code(), ..Document::default() };
    document.title = if mechanism.title.is_empty() { source.name.clone() } else { mechanism.title.clone() };
    let notes = mechanism.notes.join(" ");
    if !notes.is_empty() {
        document.blocks.push(Block::Paragraph(vec![Inline::Text(notes)]));
    }
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

/// Writes a document to its file, and its pictures next to it; what goes to standard output is given back.
fn written(
    args: &Report,
    format: ReportFormat,
    mut document: Document,
    out: Option<&str>,
) -> Result<String, CliError> {
    let Some(name) = out.filter(|name| *name != "-") else {
        if format != ReportFormat::Html && format != ReportFormat::Text {
            // pictures have no place
            document = document.without_figures();
        }
        return Ok(match format {
            ReportFormat::Html => html(&document),
            ReportFormat::Text => text(&document),
            ReportFormat::Markdown => markdown(&document, "").0,
            ReportFormat::Typst => typst(&document, "").0,
        });
    };
    let path = Path::new(name);
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let (text, pictures) = match format {
        ReportFormat::Html => (html(&document), Vec::new()),
        ReportFormat::Text => (text(&document), Vec::new()),
        ReportFormat::Markdown => markdown(&document, &stem),
        ReportFormat::Typst => typst(&document, &stem),
    };
    for (picture, svg) in pictures {
        file(Sink::made_up(&path.with_file_name(picture))?, &svg)?;
    }
    file(if args.made_up || args.per_row { Sink::made_up(path)? } else { Sink::page(path)? }, &text)?;
    Ok(String::new())
}

/// Writes a file, which appears only when complete.
fn file(mut sink: Sink, text: &str) -> Result<(), CliError> {
    sink.write(text.as_bytes())?;
    sink.finish_page().map(|_| ())
}
