//! `assur profile`

use super::args::{Format, Profile};
use super::error::CliError;
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::report;
use crate::report::document::{Report, Section, Table};
use assur_math::element::cam::MOST_STEPS;
use assur_model::model::{CAM_PARTS, Mechanism, PlateCam};
use assur_text::source::Source;

/// Steps of a table, and how far the curves of a drawing are from the lines between their points, m.
const STEPS: u32 = 360;
const DRAWN_WITHIN: f64 = 10e-6;

/// Prints the profile of a cam for other programs.
pub fn run(args: &Profile, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    for_each_file(&args.problem.files, screen, "", |source, _| {
        let (mechanism, mut problems) = crate::pipeline::check_source(source, &overrides);
        let results = match mechanism.as_ref().map(|m| (m, wanted(args, m))) {
            Some((mechanism, Ok((plate, steps)))) => match args.format {
                Format::Dxf => report::element::dxf(plate, steps),
                format => {
                    let table = plate.table(&CAM_PARTS, steps as usize, |d| mechanism.display_of(d));
                    let table = report::full_table(&table);
                    match format {
                        Format::Csv => report::csv::render(&table),
                        format => format.page(screen.look()).render(&of_cam(source, plate, table)),
                    }
                }
            },
            Some((_, Err(error))) => {
                problems.push(error);
                String::new()
            }
            None => String::new(),
        };
        Reply::new(results, &problems, source, screen)
    })
}

/// The cam that is wanted, and its steps.
fn wanted<'m>(args: &Profile, mechanism: &'m Mechanism) -> Result<(&'m PlateCam, u32), CliError> {
    let plate = chosen(mechanism, args.cam.as_deref())?;
    Ok((plate, steps(args, plate)?))
}

/// How many steps a cam has: those that are wanted, or those of a wanted error; a drawing has one of its own.
fn steps(args: &Profile, plate: &PlateCam) -> Result<u32, CliError> {
    match (args.steps, args.within) {
        (Some(steps), _) => Ok(steps),
        (None, Some(error)) => plate.cam.steps_within(error).ok_or_else(|| {
            let reached = format!("{:.1e}", plate.cam.chord_error(MOST_STEPS) * 1e6);
            CliError::TooManySteps { name: plate.name.clone(), most: MOST_STEPS, reached }
        }),
        (None, None) if args.format == Format::Dxf => {
            Ok(plate.cam.steps_within(DRAWN_WITHIN).unwrap_or(MOST_STEPS))
        }
        (None, None) => Ok(STEPS),
    }
}

/// A page with the profile.
fn of_cam(source: &Source, plate: &PlateCam, table: Table) -> Report {
    let mut section = Section::new(format!("Profile of {}", plate.name));
    section.table(table);
    Report { title: source.name.clone(), notes: Vec::new(), sections: vec![section] }
}

/// The cam of that name, or the only one.
fn chosen<'m>(mechanism: &'m Mechanism, name: Option<&str>) -> Result<&'m PlateCam, CliError> {
    let names = || mechanism.cams.iter().map(|c| format!("`{}`", c.name)).collect::<Vec<_>>().join(", ");
    match (name, mechanism.cams.as_slice()) {
        (_, []) => Err(CliError::NoCam {
            message: "the file has no cam".to_owned(),
            help: "add `cam NAME { … }`".to_owned(),
        }),
        (None, [one]) => Ok(one),
        (None, _) => {
            let message = "the file has several cams".to_owned();
            Err(CliError::NoCam { message, help: format!("choose one with `--cam`: {}", names()) })
        }
        (Some(name), all) => all.iter().find(|c| c.name == name).ok_or_else(|| CliError::NoCam {
            message: format!("the file has no cam `{name}`"),
            help: format!("its cams are {}", names()),
        }),
    }
}
