//! `assur report`

use crate::cli::args::{Report, ReportFormat};
use crate::cli::draw::file_name;
use crate::cli::error::CliError;
use crate::cli::files::{self, Input};
use crate::cli::reply::{Printer, Reply, Status, complaint, for_each_input};
use crate::cli::screen::Screen;
use crate::cli::sink::Sink;
use crate::cli::stop::{count_written, want_written};
use crate::cli::threads::Threads;
use crate::handout::{Handout, Row, Sheets};
use assur_syntax as syntax;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use assur_worked::{Document, html, html_of_several, markdown, text, typst};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

/// Rows that one thread takes at once: what they have in common is found once for all of them.
const PIECE: usize = 16;
/// Characters of the name of a row in the name of a file.
const LONGEST: usize = 60;

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
        let names = folder_names(&inputs);
        if !args.per_row {
            want_written(names.len());
        }
        return for_each_input(inputs, &mut Printer::new(screen, "\n"), |source, _| {
            let name = names.get(&source.name).map_or("report", String::as_str);
            let key = if args.key { "-key" } else { "" };
            let out = folder.join(format!("{name}{key}.{}", format.ending())).display().to_string();
            of_file(&Report { out: Some(out), made_up: true, ..args.clone() }, format, source, screen)
        });
    }
    let one_page = args.sheet || args.key;
    match out {
        Some(_) if inputs.len() > 1 && one_page && !args.per_row && format == ReportFormat::Html => {
            return chapter(args, inputs, screen);
        }
        Some(name) if inputs.len() > 1 => return refused(CliError::OneReport { name: name.to_owned() }),
        None if inputs.len() > 1 && format == ReportFormat::Html => {
            return refused(CliError::OneReport { name: "standard output".to_owned() });
        }
        _ => {}
    }
    for_each_input(inputs, &mut Printer::new(screen, "\n"), |source, _| of_file(args, format, source, screen))
}

/// The sheets or keys of several files on one page, each on new paper; only where all are there.
fn chapter(args: &Report, inputs: Vec<Result<Input, CliError>>, screen: &Screen) -> Status {
    let made: RefCell<Vec<Document>> = RefCell::default();
    let status = for_each_input(inputs, &mut Printer::new(screen, "\n"), |source, _| {
        let (document, problems) = document_of(args, source);
        made.borrow_mut().extend(document);
        reply(Ok(String::new()), &problems, source, screen)
    });
    let documents = made.into_inner();
    if status != Status::Fine || documents.is_empty() {
        return status;
    }
    let name = args.out.as_deref().unwrap_or_default();
    match Sink::page(Path::new(name)).and_then(|sink| file(sink, &html_of_several(&documents))) {
        Ok(()) => status,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

/// What documents of a file are made of, and what is wrong in its text.
fn handout<'a>(args: &'a Report, source: &'a Source) -> (Handout<'a>, Problems) {
    let (read, found) = syntax::parse(source);
    let (read, language) = (Arc::new(read), args.language.into());
    (Handout::new(source, read, args.overrides(), language, args.pose.as_deref()).at(&args.positions), found)
}

/// The document of a file, and what is wrong in it.
fn document_of(args: &Report, source: &Source) -> (Option<Document>, Problems) {
    let (handout, found) = handout(args, source);
    if args.key {
        Sheets::of(&handout, found).key()
    } else if args.sheet {
        Sheets::of(&handout, found).for_all()
    } else {
        handout.worked(found, &args.steps)
    }
}

/// The names of the files of a folder by those of the problems: without their folders where these tell none apart.
pub(in crate::cli) fn folder_names(inputs: &[Result<Input, CliError>]) -> BTreeMap<String, String> {
    let paths: Vec<&Path> = inputs.iter().flatten().filter_map(Input::path).collect();
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
    if args.per_row {
        let (handout, found) = handout(args, source);
        return each(args, format, Sheets::of(&handout, found), screen);
    }
    let (made, problems) = document_of(args, source);
    let out = args.out.as_deref();
    let written = made.map_or(Ok(String::new()), |document| written(args, format, document, out));
    reply(written, &problems, source, screen)
}

fn reply(written: Result<String, CliError>, problems: &Problems, source: &Source, screen: &Screen) -> Reply {
    match written {
        Ok(results) => Reply::new(results, problems, source, screen),
        Err(error) => {
            let diagnostics = screen.diagnostics(problems, source) + &complaint(error, screen);
            Reply { results: String::new(), diagnostics, status: Status::Unusable }
        }
    }
}

/// One sheet per row: `sheet-2.html` of `sheet.html`.
fn each(args: &Report, format: ReportFormat, sheets: Sheets<'_>, screen: &Screen) -> Reply {
    let name = args.out.as_deref().unwrap_or_default();
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let mut pieces: Vec<(&[Row], Problems, Option<CliError>)> =
        sheets.rows.chunks(PIECE).map(|rows| (rows, Problems::new(), None)).collect();
    if !sheets.problems.has_errors() {
        want_written(sheets.rows.len());
        Threads::new(None).each(&mut pieces, |(_, (rows, problems, error))| {
            sheets.each(rows, |row, document, found| {
                problems.append(found);
                let out = format!("{stem}-{}.{ending}", in_file(row));
                let written = document.map(|document| written(args, format, document, Some(&out)));
                *error = written.and_then(Result::err);
                error.is_none()
            });
        });
    }
    let (source, mut problems) = (sheets.handout.source, sheets.problems.clone());
    for (_, found, error) in pieces {
        problems.append(found);
        if let Some(error) = error {
            return reply(Err(error), &problems, source, screen);
        }
    }
    reply(Ok(String::new()), &problems, source, screen)
}

/// The number and the name of a row in the name of a file: `2-A2`.
fn in_file(row: &Row) -> String {
    let number = row.number.to_string();
    match row.label.as_deref().filter(|label| **label != number) {
        Some(label) => {
            let label: String = file_name(label).chars().take(LONGEST).collect();
            format!("{number}-{label}")
        }
        None => number,
    }
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
    if let (true, Some(folder)) = (args.made_up, path.parent()) {
        files::made_folder(folder)?;
    }
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
    count_written();
    Ok(String::new())
}

/// Writes a file, which appears only when complete.
fn file(mut sink: Sink, text: &str) -> Result<(), CliError> {
    sink.write(text.as_bytes())?;
    sink.finish_page().map(|_| ())
}
