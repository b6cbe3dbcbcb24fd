//! `assur check`

use super::args::Check;
use super::error::CliError;
use super::files::replace;
use super::reply::{Reply, Status, for_each_file};
use super::screen::{Screen, processor_seconds};
use crate::pipeline::Compiled;
use crate::report::{self, document::Report};
use assur_check::Overrides;
use assur_solve::measure::Costs;
use assur_solve::message::failures;
use assur_text::diagnostic::Problems;
use assur_text::source::{Source, shown_in_line};

/// Prints what the mechanisms are built from and, where it is asked for, what their plans cost and how they can be
/// assembled.
pub fn run(args: &Check, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    for_each_file(&args.problem.files, screen, args.format.apart(), |source, _| {
        let fixed = match fixed(args, source, &overrides, screen) {
            Ok(fixed) => fixed,
            Err(error) => return Reply::unusable(error, screen),
        };
        let source = fixed.as_ref().unwrap_or(source);
        let (compiled, mut problems) = crate::pipeline::look_at(source, &overrides);
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

/// A file as it is after its certain fixes, where they are wanted and there are some.
fn fixed(
    args: &Check,
    source: &Source,
    overrides: &Overrides,
    screen: &Screen,
) -> Result<Option<Source>, CliError> {
    if !args.fix {
        return Ok(None);
    }
    if source.name == "-" {
        return Err(CliError::FixesStdin);
    }
    let (fixed, count) = crate::pipeline::fixed(source, overrides);
    if count == 0 {
        return Ok(None);
    }
    replace(&fixed.name, &fixed.text)?;
    let fixes = if count == 1 { "fix" } else { "fixes" };
    screen.complain(&format!("{}: {count} {fixes} applied\n", shown_in_line(&fixed.name)));
    Ok(Some(fixed))
}

fn costs(compiled: &Compiled, problems: &mut Problems) -> Option<Costs> {
    let model = compiled.model();
    match assur_solve::measure::costs(&model, processor_seconds) {
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
