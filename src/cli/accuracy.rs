//! `assur accuracy`

use std::path::Path;

use super::args::{Accuracy, Format};
use super::batch::{Sink, end_at_once};
use super::clock::seconds;
use super::error::CliError;
use super::files;
use super::reply::{Reply, Status, complaint, for_each_file};
use super::screen::Screen;
use crate::pipeline::{Solved, solve_source};
use crate::report::{self, AccuracyShown, Precision};
use assur_check::Overrides;
use assur_solve::measure::accuracy::{AccuracyStudy, out_of_reach, study};
use assur_solve::measure::micros;
use assur_text::source::Source;

/// Prints what accuracy costs in time.
pub fn run(args: &Accuracy, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    if args.plot.is_some() {
        end_at_once();
    }
    if let (Some(name), true) = (&args.plot, files::expand(&args.problem.files).len() > 1) {
        let name = name.clone();
        screen.complain(&complaint(CliError::OneDrawing { name }, screen));
        return Status::Unusable;
    }
    for_each_file(&args.problem.files, screen, args.format.apart(), |source, _| {
        let (solved, mut problems) = solve_source(source, &overrides);
        let Some(solved) = solved.filter(|_| !problems.has_errors()) else {
            return Reply::new(String::new(), &problems, source, screen);
        };
        let model = solved.compiled.model();
        let measured = study(&model, &solved.solution, args.wanted, seconds);
        if measured.recommendation.is_none() {
            problems.push(out_of_reach(&measured, model.mechanism));
        }
        let results = printed(args, source, &overrides, &solved, &measured, screen);
        let reply = Reply::new(results, &problems, source, screen);
        match &args.plot {
            Some(path) => drawn(path, source, &solved, &measured, reply, screen),
            None => reply,
        }
    })
}

fn printed(
    args: &Accuracy,
    source: &Source,
    overrides: &Overrides,
    solved: &Solved,
    measured: &AccuracyStudy,
    screen: &Screen,
) -> String {
    if matches!(args.format, Format::Json | Format::Jsonl) {
        return report::study_json(&source.name, measured) + "\n";
    }
    let whole = micros(seconds, || drop(std::hint::black_box(whole(source, overrides))));
    let report = report::of_study(&source.name, &solved.compiled.model(), measured, whole);
    args.format.page(screen.look()).render(&report)
}

/// All that `assur solve` does, but for reading the file and writing to the screen.
fn whole(source: &Source, overrides: &Overrides) -> String {
    let (solved, _) = solve_source(source, overrides);
    let of =
        |s: &Solved| report::of_answers(&source.name, &s.answers(Precision::READABLE), AccuracyShown::Worst);
    let report = solved.as_ref().map(of);
    report.map(|r| report::text::render(&r, report::text::Look::PLAIN)).unwrap_or_default()
}

fn drawn(
    path: &str,
    source: &Source,
    solved: &Solved,
    measured: &AccuracyStudy,
    reply: Reply,
    screen: &Screen,
) -> Reply {
    let title = &solved.compiled.mechanism.title;
    let title = if title.is_empty() { &source.name } else { title };
    let Some(svg) = report::diagram::svg(title, measured) else {
        let why = "nothing can be set in this problem".to_owned();
        let complaint = complaint(CliError::Unwritable { name: path.to_owned(), why }, screen);
        return Reply { diagnostics: reply.diagnostics + &complaint, status: Status::Unusable, ..reply };
    };
    let written = Sink::file(Path::new(path)).and_then(|mut sink| {
        sink.write(&svg)?;
        sink.finish()
    });
    match written {
        Ok(_) => reply,
        Err(error) => {
            let diagnostics = reply.diagnostics + &complaint(error, screen);
            Reply { diagnostics, status: Status::Unusable, ..reply }
        }
    }
}
