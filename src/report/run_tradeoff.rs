//! The time that accuracy costs in a motion under loads, as tables and as JSON.

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::answers::NONE;
use super::document::{Column, Report, Section, Table};
use super::headed;
use super::tradeoff::SCHEMA;
use assur_model::model::Simulation;
use assur_solve::measure::accuracy::lanes;
use assur_solve::measure::{MethodStudy, RunRow, RunStudy};
use assur_solve::solve::{Method, Model};
use assur_text::units::significant;

/// The output of `accuracy` for a file that follows a motion. `solve` is the time of a whole `assur solve`, µs.
#[must_use]
pub fn of_run_study(file: &str, model: &Model<'_>, study: &RunStudy, solve: f64) -> Report {
    let mut report = headed(file, model);
    report.notes.clear();
    report.section(measured(study));
    for method in &study.methods {
        let mut section = Section::new(heading(method));
        section.table(costs(method));
        if method.cut {
            section.text("Finer accuracies take too many steps by this method and were left out.");
        }
        let errors = errors(study, method);
        if !errors.rows.is_empty() {
            section.text("The errors kind by kind:");
        }
        section.table(errors);
        report.section(section);
    }
    let wanted = model.mechanism.simulation.as_ref().and_then(|s| s.within).unwrap_or(Simulation::WITHIN);
    report.section(recommended(study, wanted, solve));
    report
}

fn measured(study: &RunStudy) -> Section {
    let mut section = Section::new("Measured");
    let against = if study.precise {
        "the same motion in double-double".to_owned()
    } else {
        format!("the same motion in f64 at the finest tolerances, by {},", short(study.reference))
    };
    section.text(format!(
        "{} instants up to {} s, compared with {against} whose own error is about {:.0e}.",
        study.instants,
        significant(study.end, 6),
        study.floor
    ));
    section.text(
        "Errors are the greatest over all instants, each relative to the greatest of its kind in the motion; `~` marks those no greater than that of the reference."
    );
    section.text(
        "A time is that of all runs from the first position on, the estimate of the error among them; the best of repeated ones, on one thread."
    );
    section
}

const fn short(method: Method) -> &'static str {
    match method {
        Method::Dop853 => "DOP853",
        Method::Energy => "energy",
        Method::Radau => "Radau IIA",
    }
}

fn heading(study: &MethodStudy) -> String {
    match (study.asked, study.method) {
        (Some(Method::Radau), _) => "Radau IIA of order 5 from the first instant on".to_owned(),
        (Some(_), method) => short(method).to_owned(),
        (None, Method::Dop853) => "As `solve` does it: DOP853".to_owned(),
        (None, Method::Energy) => "As `solve` does it: energy and quadrature".to_owned(),
        (None, Method::Radau) => {
            "As `solve` does it: DOP853, and Radau IIA from where stability holds it up".to_owned()
        }
    }
}

fn size(error: f64) -> String {
    if error == 0.0 {
        return "0".to_owned();
    }
    if error.is_finite() { format!("{error:.0e}") } else { NONE.to_owned() }
}

fn marked(error: f64, row: &RunRow) -> String {
    if row.is_floor { format!("~ {}", size(error)) } else { size(error) }
}

fn costs(study: &MethodStudy) -> Table {
    let heads = ["steps", "rejected", "evaluations", "in all runs"].map(Column::right);
    let mut columns = vec![Column::words("within")];
    columns.extend(heads);
    columns.push(Column::numbers("µs"));
    columns.extend(["error", "reported", "digits"].map(Column::right));
    let mut table = Table::new(columns, 1);
    for row in &study.rows {
        let reported =
            if row.missed { format!("{} (not kept)", size(row.reported)) } else { size(row.reported) };
        table.row(vec![
            size(row.within),
            row.steps.to_string(),
            row.rejected.to_string(),
            row.printed.to_string(),
            row.evaluations.to_string(),
            significant(row.micros, 3),
            marked(row.error, row),
            reported,
            if row.error.is_finite() {
                format!("{:.1}", -libm::log10(row.error.max(1e-40)))
            } else {
                NONE.to_owned()
            },
        ]);
    }
    table
}

/// The errors kind by kind, of those kinds that have some.
fn errors(study: &RunStudy, method: &MethodStudy) -> Table {
    let in_play = kinds_in_play(method);
    let mut columns = vec![Column::words("within")];
    columns.extend(in_play.iter().map(|kind| Column::right(study.kinds[*kind])));
    let mut table = Table::new(columns, 1);
    for row in method.rows.iter().filter(|_| in_play.len() > 1) {
        let errors = in_play.iter().map(|kind| size(row.each[*kind]));
        table.row(std::iter::once(size(row.within)).chain(errors).collect());
    }
    table
}

fn kinds_in_play(method: &MethodStudy) -> Vec<usize> {
    let kinds = method.rows.first().map_or(0, |row| row.each.len());
    (0..kinds).filter(|kind| method.rows.iter().any(|row| row.each[*kind] > 0.0)).collect()
}

fn recommended(study: &RunStudy, asked: f64, solve: f64) -> Section {
    let mut section = Section::new(format!("For an error of {:.0e}", study.wanted));
    let Some(row) = &study.recommendation else {
        section.text("No accuracy that can be asked for reaches it.");
        return section;
    };
    let within = size(row.within);
    section.text(format!("Write `within {within}` behind `simulate`, or `--within {within}`."));
    section.text(format!(
        "It takes {} µs with an error of {}; {} is reported.",
        significant(row.micros, 3),
        marked(row.error, row),
        size(row.reported)
    ));
    if let Some(now) = study.of_accuracy(asked).filter(|now| now.micros > row.micros) {
        let part = significant(100.0 * row.micros / now.micros, 2);
        section.text(format!(
            "That is {part} % of the time for {asked:.0e}, which the file asks for; a whole solve takes {} µs from text to report.",
            significant(solve, 3)
        ));
    }
    section
}

#[derive(Serialize)]
struct View<'a> {
    schema: &'static str,
    file: &'a str,
    positions: usize,
    reference: &'static str,
    floor: f64,
    instructions: &'static str,
    lanes: usize,
    knobs: Vec<Value>,
    absent: [(); 0],
    #[serde(rename = "for")]
    wanted: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    recommendation: Option<Value>,
}

fn name(method: &MethodStudy) -> &'static str {
    match method.asked {
        None => "run",
        Some(Method::Radau) => "run by Radau IIA",
        Some(_) => "run by DOP853",
    }
}

fn row_view(study: &RunStudy, row: &RunRow) -> Value {
    let errors = study.kinds.iter().zip(row.each).filter(|(_, error)| *error > 0.0 && error.is_finite());
    let errors: Map<String, Value> = errors.map(|(kind, error)| ((*kind).to_owned(), json!(error))).collect();
    let mut view = Map::new();
    view.insert("setting".to_owned(), json!(size(row.within)));
    view.insert("microseconds".to_owned(), json!(row.micros));
    if row.error.is_finite() {
        view.insert("error".to_owned(), json!(row.error));
    }
    if row.is_floor {
        view.insert("estimated".to_owned(), json!(true));
    }
    view.insert("steps".to_owned(), json!(row.steps));
    view.insert("rejected".to_owned(), json!(row.rejected));
    view.insert("evaluations".to_owned(), json!(row.evaluations));
    view.insert("printed_evaluations".to_owned(), json!(row.printed));
    if row.reported.is_finite() {
        view.insert("reported".to_owned(), json!(row.reported));
    }
    if row.missed {
        view.insert("kept".to_owned(), json!(false));
    }
    view.insert("errors".to_owned(), Value::Object(errors));
    Value::Object(view)
}

/// The same as one line of JSON: `docs/json-schema/accuracy-1.json`.
#[must_use]
pub fn run_study_json(file: &str, study: &RunStudy) -> String {
    let knobs = study.methods.iter().map(|method| {
        let rows: Vec<Value> = method.rows.iter().map(|row| row_view(study, row)).collect();
        json!({ "name": name(method), "per": "run", "settings": rows })
    });
    let recommendation = study.recommendation.as_ref().map(|row| {
        let setting = json!({ "name": "run", "setting": size(row.within) });
        json!({ "settings": [setting], "microseconds": row.micros, "error": row.error })
    });
    let view = View {
        schema: SCHEMA,
        file,
        positions: study.instants,
        reference: if study.precise { "double-double" } else { "f64" },
        floor: study.floor,
        instructions: lanes().1,
        lanes: lanes().0,
        knobs: knobs.collect(),
        absent: [],
        wanted: study.wanted,
        recommendation,
    };
    // a view of texts and finite numbers is always written
    serde_json::to_string(&view).unwrap_or_default()
}
