//! `assur check`

use super::args::Check;
use super::clock::seconds;
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::pipeline::Compiled;
use crate::report;
use crate::report::document::Report;
use assur_solve::measure::Costs;
use assur_solve::message::failures;
use assur_text::diagnostic::Problems;

/// Prints what the mechanisms are built from and, where it is asked for, what their plans cost and how they can be
/// assembled.
pub fn run(args: &Check, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    for_each_file(&args.problem.files, screen, args.format.apart(), |source, _| {
        let (compiled, mut problems) = crate::pipeline::compile(source, &overrides);
        let results = compiled.map_or_else(String::new, |c| {
            let costs = if args.plan && !problems.has_errors() { costs(&c, &mut problems) } else { None };
            let mut report = report::of_structure(source, &c.model(), costs.as_ref());
            if args.modes {
                add_modes(&mut report, &c, &mut problems);
            }
            args.format.page(screen.look()).render(&report)
        });
        Reply::new(results, &problems, source, screen)
    })
}

fn costs(compiled: &Compiled, problems: &mut Problems) -> Option<Costs> {
    let model = compiled.model();
    match assur_solve::measure::costs(&model, seconds) {
        Ok(costs) => costs,
        Err(errors) => {
            problems.extend(failures(&model, &errors));
            None
        }
    }
}

fn add_modes(report: &mut Report, compiled: &Compiled, problems: &mut Problems) {
    let model = compiled.model();
    match assur_solve::solve::assemblies(&model) {
        Ok(modes) => {
            report::add_modes(report, &model, &modes);
            problems.extend(failures(&model, modes.problem.as_slice()));
        }
        Err(errors) => problems.extend(failures(&model, &errors)),
    }
}
