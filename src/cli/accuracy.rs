//! `assur accuracy`

use std::path::Path;

use super::args::{Accuracy, Format};
use super::error::CliError;
use super::files;
use super::motion::MotionProgress;
use super::reply::{Reply, Status, complaint, for_each_file};
use super::screen::{Screen, processor_seconds};
use super::sink::Sink;
use crate::pipeline::{Solved, solve_source_conducted};
use crate::report::{self, Extent};
use assur_model::model::Simulation;
use assur_solve::measure::{
    RunStudy,
    accuracy::{self, AccuracyStudy, study},
    study_runs,
};
use assur_solve::message;
use assur_solve::solve::IntegrationOptions;
use assur_text::diagnostic::{Diagnosis, Problems};
use assur_text::source::Source;

/// Prints what accuracy costs in time.
pub fn run(args: &Accuracy, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    if let (Some(name), true) = (&args.plot, files::expand(&args.problem.files).len() > 1) {
        let name = name.clone();
        screen.complain(&complaint(CliError::OneDrawing { name }, screen));
        return Status::Unusable;
    }
    for_each_file(&args.problem.files, screen, args.format.apart(), |source, _| {
        let way = MotionProgress::shown(&source.name);
        let watch = |reached: f64, last: f64| way.goes_on(reached, last);
        let conduct = IntegrationOptions { watch: Some(&watch), ..IntegrationOptions::default() };
        let (solved, mut problems) = solve_source_conducted(source, &overrides, &conduct);
        let Some(solved) = solved.filter(|_| !problems.has_errors()) else {
            return Reply::new(String::new(), &problems, source, screen);
        };
        let measured = Measured::of(&solved, args.wanted, &conduct);
        drop(way);
        let measured = match measured {
            Ok(measured) => measured,
            Err(failed) => {
                problems.append(*failed);
                return Reply::new(String::new(), &problems, source, screen);
            }
        };
        problems.extend(measured.out_of_reach(&solved));
        let results = measured.printed(args, source, &solved, screen);
        let reply = Reply::new(results, &problems, source, screen);
        match &args.plot {
            Some(path) => drawn(path, measured.picture(source, &solved), reply, screen),
            None => reply,
        }
    })
}

/// What was measured: positions, or a motion under loads.
enum Measured {
    Positions(Box<AccuracyStudy>),
    Runs(Box<RunStudy>),
}

impl Measured {
    fn of(
        solved: &Solved,
        wanted: Option<f64>,
        conduct: &IntegrationOptions<'_>,
    ) -> Result<Self, Box<Problems>> {
        let model = solved.compiled.model();
        let problems = |failure| Box::new(Problems::of([message::failure(&model, &failure)]));
        Ok(
            match study_runs(&model, &solved.solution, wanted, processor_seconds, conduct)
                .map_err(problems)?
            {
                Some(runs) => Self::Runs(Box::new(runs)),
                None => {
                    let wanted = wanted.unwrap_or(Simulation::WITHIN);
                    Self::Positions(Box::new(study(&model, &solved.solution, wanted, processor_seconds)))
                }
            },
        )
    }

    fn out_of_reach(&self, solved: &Solved) -> Option<Diagnosis> {
        let mechanism = &solved.compiled.mechanism;
        match self {
            Self::Positions(study) => {
                let missed = study.recommendation.is_none() && !study.choices.is_empty();
                missed.then(|| accuracy::out_of_reach(study, mechanism))
            }
            Self::Runs(study) => {
                study.recommendation.is_none().then(|| accuracy::run_out_of_reach(study, mechanism))
            }
        }
    }

    fn printed(&self, args: &Accuracy, source: &Source, solved: &Solved, screen: &Screen) -> String {
        if matches!(args.format, Format::Json | Format::Jsonl) {
            return match self {
                Self::Positions(study) => report::study_json(&source.name, study),
                Self::Runs(study) => report::run_study_json(&source.name, study),
            } + "\n";
        }
        let shown = if args.details { Extent::Details } else { Extent::Answer };
        let model = solved.compiled.model();
        let report = match self {
            Self::Positions(study) => report::of_study(&source.name, &model, study, shown),
            Self::Runs(study) => report::of_run_study(&source.name, &model, study, shown),
        };
        args.format.page(screen.look()).render(&report)
    }

    fn picture(&self, source: &Source, solved: &Solved) -> Option<String> {
        let title = &solved.compiled.mechanism.title;
        let title = if title.is_empty() { &source.name } else { title };
        match self {
            Self::Positions(study) => report::diagram::svg(title, study),
            Self::Runs(study) => report::diagram::of_runs(title, study),
        }
    }
}

fn drawn(path: &str, picture: Option<String>, reply: Reply, screen: &Screen) -> Reply {
    let Some(svg) = picture else {
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
