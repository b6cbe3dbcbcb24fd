//! What a solved file says: one document of titles, facts and tables printed by several renderers, and JSON.
//!
//! No mechanics happens here.

mod accuracy;
mod answers;
#[cfg(feature = "arrow")]
pub mod arrow;
mod brief;
pub mod card;
mod columns;
mod cost;
pub mod csv;
mod cycle;
pub mod diagram;
pub mod document;
pub mod element;
mod expectations;
mod friction;
pub mod grade;
pub mod json;
mod latex;
pub mod lines;
pub mod manual;
pub mod markdown;
mod mobility;
mod modes;
mod page;
mod places;
mod plan;
mod reactions;
mod results;
mod row_numbers;
pub mod rows;
mod run_tradeoff;
mod signs;
mod simulation;
#[doc(hidden)]
pub mod symbols;
pub mod text;
mod tradeoff;
mod train;
mod typst;

pub use accuracy::AccuracyShown;
pub use answers::{Answers, PrintedDigits};
pub use brief::brief;
pub use element::full as full_table;
pub use mobility::groups_in_order;
pub use page::Page;
pub use places::AnswerLine;
pub use reactions::{ContactEntry, ReactionEntry, reactions};
pub use results::{OF_CYCLE, OF_MOTION};
pub use row_numbers::{NumberField, NumberRows};
pub use run_tradeoff::{of_run_study, run_study_json};
pub use tradeoff::{Extent, of_study, study_json};

use assur_solve::measure::Costs;
use assur_solve::solve::{Assemblies, Model};
use assur_text::source::Source;
use document::Report;

/// What `check` prints: structure, order of solution, effects, steps, with their costs where they were measured. Nothing is
/// solved for it.
#[must_use]
pub fn of_structure(source: &Source, model: &Model<'_>, costs: Option<&Costs>) -> Report {
    let mut report = headed(&source.name, model);
    if has_mechanism(model) {
        mobility::sections(model, &mut report);
    }
    reactions::section(model, &mut report);
    train::laws(model, &mut report);
    element::cams(model, &mut report);
    plan::sections(source, model, costs, &mut report);
    report
}

/// The output of `check --modes`: all assemblies of every group at the first pose.
pub fn add_modes(report: &mut Report, model: &Model<'_>, modes: &Assemblies) {
    report.section(modes::section(model, modes));
}

/// The output of `solve`: structure in short, answers, reactions, expectations, accuracy.
#[must_use]
pub fn of_answers(file: &str, answers: &Answers<'_>, accuracy: AccuracyShown) -> Report {
    let mut report = headed(file, &answers.model);
    if has_mechanism(&answers.model) {
        mobility::summary(&answers.model, &mut report);
    }
    element::cams(&answers.model, &mut report);
    results::sections(answers, &mut report);
    simulation::section(answers, &mut report);
    element::tables(answers, &mut report);
    reactions::sections(answers, &mut report);
    train::section(answers, &mut report);
    friction::section(answers, &mut report);
    signs::powers(answers, &mut report);
    signs::bars(answers, &mut report);
    cycle::flywheels(answers, &mut report);
    expectations::section(answers, &mut report);
    accuracy::section(answers, accuracy, &mut report);
    report
}

/// The answers as one table, one row per pose, with all digits, for CSV.
#[must_use]
pub fn table_of_poses(answers: &Answers<'_>) -> document::Table {
    results::full_table(answers)
}

fn headed(file: &str, model: &Model<'_>) -> Report {
    Report { title: title(file, model), notes: model.mechanism.notes.clone(), sections: Vec::new() }
}

/// The mechanism's title with the file's name; the name alone where there is none.
fn title(file: &str, model: &Model<'_>) -> String {
    let title = &model.mechanism.title;
    if title.is_empty() { file.to_owned() } else { format!("{title} ({file})") }
}

/// There are links in addition to the ground.
fn has_mechanism(model: &Model<'_>) -> bool {
    model.mechanism.links.len() > 1
}
