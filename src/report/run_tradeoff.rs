//! The time that accuracy costs in a motion under loads, as tables and as JSON.

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::cost::{change, count, digits, part, size, time};
use super::document::{Column, Report, Section, Table};
use super::headed;
use super::tradeoff::{Extent, ONE_BY_ONE, SCHEMA};
use assur_solve::measure::{Choice, MethodStudy, Price, RunRow, RunStudy};
use assur_solve::solve::{Method, Model};
use assur_text::units::significant;

/// So many rows the answer has.
const ROWS: usize = 4;

/// The output of `accuracy` for a file that follows a motion.
#[must_use]
pub fn of_run_study(file: &str, model: &Model<'_>, study: &RunStudy, shown: Extent) -> Report {
    let mut report = headed(file, model);
    report.notes.clear();
    report.title += ": what accuracy costs";
    report.section(answer(study, shown));
    if shown == Extent::Answer {
        return report;
    }
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
    report
}

/// What to write for a choice.
pub(super) fn options(study: &RunStudy, choice: Choice) -> String {
    let row = study.row(choice);
    // of the same runs as the file asks for them
    let own = study.own() == Some(choice);
    let within = size(if own { study.asked } else { row.within });
    match study.methods[choice.method].asked {
        None => format!("--within {within}"),
        Some(Method::Radau) => format!("--within {within} --method radau"),
        Some(_) => format!("--within {within} --method dop853"),
    }
}

/// Digits against time, what one more takes, the file's own setting, and what is recommended.
fn answer(study: &RunStudy, shown: Extent) -> Section {
    let mut section = Section::new("");
    let right = ["digits", "evaluations", "time", "a digit more"].map(Column::right);
    let [digit, evaluations, times, more] = right;
    let columns = vec![Column::words(""), digit, Column::words("solve with"), evaluations, times, more];
    let mut table = Table::new(columns, 6);
    let chosen = study.in_short(ROWS);
    for (i, choice) in chosen.iter().enumerate() {
        let row = study.row(*choice);
        table.row(vec![
            mark(study, *choice).to_owned(),
            digits(row.error),
            options(study, *choice),
            count(row.evaluations),
            time(row.micros),
            one_more(row, chosen.get(i + 1).map(|next| study.row(*next))),
        ]);
    }
    section.table(table);
    for line in findings(study, shown) {
        section.text(line);
    }
    section
}

fn mark(study: &RunStudy, choice: Choice) -> &'static str {
    match (study.own() == Some(choice), study.recommendation == Some(choice)) {
        (true, true) => "▸ ✓",
        (true, false) => "▸",
        (false, true) => "✓",
        (false, false) => "",
    }
}

/// What a digit more takes on the way to a row with more of them.
fn one_more(row: &RunRow, next: Option<&RunRow>) -> String {
    // less than half a digit tells nothing of a whole one
    let Some(next) = next.filter(|next| next.digits() >= row.digits() + 0.5) else {
        return "the most".to_owned();
    };
    change(libm::pow(next.micros / row.micros, 1.0 / (next.digits() - row.digits())))
}

/// The recommendation in one line, and what the table shows.
pub(super) fn findings(study: &RunStudy, shown: Extent) -> [String; 2] {
    let wanted = size(study.wanted);
    let own = study.own();
    let found = match study.recommendation {
        None => {
            let rows = study.methods.iter().flat_map(|method| &method.rows);
            let least = rows.filter(|row| !row.missed).map(|row| row.error).fold(f64::INFINITY, f64::min);
            format!("No setting keeps an error of {wanted}; the least is {}.", size(least))
        }
        found if found == own => format!("Recommended for an error of {wanted}: this file's own setting."),
        Some(found) => {
            let of_time = own.map_or_else(String::new, |own| {
                let ratio = study.row(found).micros / study.row(own).micros;
                format!(", in {} of this file's time", part(ratio))
            });
            let why = if found.method == 0 { ", the loosest that keeps it" } else { "" };
            format!("Recommended for {wanted}: `{}`{why}{of_time}.", options(study, found))
        }
    };
    [found, format!("▸ this file, ✓ recommended; errors are true ones, {}.{}", against(study), shown.more())]
}

const fn against(study: &RunStudy) -> &'static str {
    if study.precise { "from double-double" } else { "from finer runs" }
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
        "A time is that of all runs from the first position on, the estimate of the error among them: evaluations times their price, on one thread. The price fits all measured times of a method, each the best of repeated ones."
    );
    let prices = study.methods.iter().map(|method| {
        let Price { once, each } = method.price;
        format!("{}: {} an evaluation and {} a run", name(method), time(each), time(once))
    });
    section.list(prices.collect());
    section
}

const fn short(method: Method) -> &'static str {
    match method {
        Method::Dop853 => "DOP853",
        Method::Energy => "energy",
        Method::Radau => "Radau IIA",
    }
}

pub(super) fn heading(study: &MethodStudy) -> String {
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

fn marked(error: f64, row: &RunRow) -> String {
    if row.is_floor { format!("~ {}", size(error)) } else { size(error) }
}

fn costs(study: &MethodStudy) -> Table {
    let heads = ["steps", "rejected", "evaluations", "in all runs"].map(Column::right);
    let mut columns = vec![Column::words("within")];
    columns.extend(heads);
    columns.extend(["µs", "measured"].map(Column::numbers));
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
            significant(row.measured, 3),
            marked(row.error, row),
            reported,
            digits(row.error),
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

#[derive(Serialize)]
struct View<'a> {
    schema: &'static str,
    file: &'a str,
    summary: Value,
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
    view.insert("measured".to_owned(), json!(row.measured));
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

fn summary(study: &RunStudy) -> Value {
    let rows = study.in_short(ROWS).into_iter().map(|choice| {
        let row = study.row(choice);
        let mut view = Map::new();
        view.insert("digits".to_owned(), json!(row.digits()));
        view.insert("solve_with".to_owned(), json!(options(study, choice)));
        view.insert("evaluations".to_owned(), json!(row.evaluations));
        view.insert("microseconds".to_owned(), json!(row.micros));
        super::tradeoff::flags(&mut view, study.own() == Some(choice), study.recommendation == Some(choice));
        Value::Object(view)
    });
    let [found, _] = findings(study, Extent::Details);
    json!({ "rows": rows.collect::<Vec<_>>(), "finding": found })
}

/// The same as one line of JSON: `docs/json-schema/accuracy-1.json`.
#[must_use]
pub fn run_study_json(file: &str, study: &RunStudy) -> String {
    let knobs = study.methods.iter().map(|method| {
        let rows: Vec<Value> = method.rows.iter().map(|row| row_view(study, row)).collect();
        json!({ "name": name(method), "per": "run", "settings": rows })
    });
    let recommendation = study.recommendation.map(|choice| {
        let row = study.row(choice);
        let setting = json!({ "name": name(&study.methods[choice.method]), "setting": size(row.within) });
        json!({ "settings": [setting], "microseconds": row.micros, "error": row.error })
    });
    let view = View {
        schema: SCHEMA,
        file,
        summary: summary(study),
        positions: study.instants,
        reference: if study.precise { "double-double" } else { "f64" },
        floor: study.floor,
        instructions: ONE_BY_ONE,
        lanes: 1,
        knobs: knobs.collect(),
        absent: [],
        wanted: study.wanted,
        recommendation,
    };
    // a view of texts and finite numbers is always written
    serde_json::to_string(&view).unwrap_or_default()
}
