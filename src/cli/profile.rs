//! `assur profile`

use super::args::{Format, Profile};
use super::error::CliError;
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::report;
use crate::report::document::{Report, Section, Table};
use assur_model::model::{CAM_PARTS, Mechanism, PlateCam};
use assur_text::source::Source;

/// Prints the profile of a cam for other programs.
pub fn run(args: &Profile, screen: &Screen) -> Status {
    let overrides = args.problem.overrides();
    for_each_file(&args.problem.files, screen, "", |source, _| {
        let (mechanism, mut problems) = crate::pipeline::check_source(source, &overrides);
        let results = match mechanism.as_ref().map(|m| (m, chosen(m, args.cam.as_deref()))) {
            Some((mechanism, Ok(plate))) => match args.format {
                Format::Dxf => report::element::dxf(plate, args.steps as usize),
                format => {
                    let steps = args.steps as usize;
                    let table = plate.table(&CAM_PARTS, steps, |d| mechanism.display_of(d));
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
