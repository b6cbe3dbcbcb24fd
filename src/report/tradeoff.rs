//! The time that accuracy costs, as tables and as JSON.

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::answers::NONE;
use super::cost::{digits, part, size, time};
use super::document::{Column, Report, Section, Table};
use super::headed;
use assur_position::plan::{Precision, Settings};
use assur_solve::measure::accuracy::{
    AccuracyStudy, AchievedAccuracy, Kind, PositionChoice, Row, Setting, Source,
};
use assur_solve::solve::Model;
use assur_text::units::significant;

/// Name and version of the format.
pub(super) const SCHEMA: &str = "assur.accuracy/1";
/// How positions are measured.
pub(super) const ONE_BY_ONE: &str = "one position at a time";

/// How much is shown of what was measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    Answer,
    /// All that was measured after it.
    Details,
}

impl Extent {
    /// Where to find more than is shown.
    pub(super) const fn more(self) -> &'static str {
        match self {
            Self::Answer => " More: --details, --plot",
            Self::Details => "",
        }
    }
}

/// The output of `accuracy`.
#[must_use]
pub fn of_study(file: &str, model: &Model<'_>, study: &AccuracyStudy, shown: Extent) -> Report {
    let mut report = headed(file, model);
    report.notes.clear();
    report.title += ": what accuracy costs";
    report.section(answer(model, study, shown));
    if shown == Extent::Answer {
        return report;
    }
    report.section(measured(study));
    for knob in &study.knobs {
        let mut section = Section::new(heading(knob.kind));
        section.table(table(knob));
        report.section(section);
    }
    let mut section = Section::new("Settings without effect here");
    section.list(study.absent.iter().map(|a| format!("{}: {}", a.what, a.why)).collect());
    report.section(section);
    report
}

/// What a choice is called: the options to write.
pub(super) fn options(choice: &PositionChoice) -> String {
    match (choice.within, choice.settings.scalar) {
        (None, Precision::F64) => "f64, as the file is".to_owned(),
        (None, Precision::DoubleDouble) => "double-double, the reference".to_owned(),
        (Some(within), Precision::F64) => format!("--within {}", size(within)),
        (Some(within), Precision::DoubleDouble) => format!("--within {}, double-double", size(within)),
    }
}

/// The choices of the answer, from few digits to many: the file as it is, the loosest, the one recommended, the most accurate.
pub(super) fn in_short(study: &AccuracyStudy) -> Vec<usize> {
    let all = &study.choices;
    let mut chosen = vec![0, study.recommendation.unwrap_or(0), 1, all.len().saturating_sub(1)];
    chosen.retain(|i| *i < all.len());
    chosen.sort_by(|a, b| all[*a].digits().total_cmp(&all[*b].digits()));
    chosen.dedup();
    chosen
}

fn answer(model: &Model<'_>, study: &AccuracyStudy, shown: Extent) -> Section {
    let mut section = Section::new("");
    let Some(own) = study.choices.first() else {
        section.text("Nothing is computed for positions here, and nothing can be set.");
        return section;
    };
    let mut columns = vec![Column::words(""), Column::right("digits"), Column::words("solve with")];
    columns.push(Column::right("a position"));
    if own.cycle.is_some() {
        columns.extend(["samples", "functions"].map(Column::right));
    }
    columns.push(Column::right("all together"));
    let mut table = Table::new(columns, 7);
    for i in in_short(study) {
        let choice = &study.choices[i];
        let mark = match (i == 0, study.recommendation == Some(i)) {
            (true, true) => "▸ ✓",
            (true, false) => "▸",
            (false, true) => "✓",
            (false, false) => "",
        };
        let mut cells = vec![mark.to_owned(), digits(choice.error), options(choice), time(choice.micros)];
        cells.extend(choice.cycle.iter().flat_map(|c| [c.0.to_string(), time(c.1)]));
        cells.push(if i == 0 { time(own.total) } else { part(choice.total / own.total) });
        table.row(cells);
    }
    section.table(table);
    section.text(finding(study));
    section.text(effects(study));
    let idle = model.plan.effects.not_asked_for(model.mechanism);
    let idle = if idle.is_empty() { "nothing".to_owned() } else { idle.join(", ") };
    section.text(format!("Declared but not asked for, so not computed: {idle}.{}", shown.more()));
    section
}

/// The greatest part of the file's time that fewer digits save, without their check.
pub(super) fn most_saved(study: &AccuracyStudy) -> Option<f64> {
    let own = study.choices.first()?;
    let time = |choice: &PositionChoice| {
        study.count as f64 * choice.micros + choice.cycle.map_or(0.0, |cycle| cycle.1)
    };
    let looser = study.choices.iter().filter(|choice| choice.error > own.error).map(time);
    let least = looser.fold(f64::INFINITY, f64::min);
    Some(1.0 - least / time(own)).filter(|saved| *saved >= 0.005)
}

/// What is recommended, and why.
pub(super) fn finding(study: &AccuracyStudy) -> String {
    let (wanted, own) = (size(study.wanted), study.choices.first());
    match (study.recommendation, most_saved(study)) {
        (None, _) => {
            let least = study
                .choices
                .iter()
                .filter(|c| c.can_be_had())
                .map(|c| c.error)
                .fold(f64::INFINITY, f64::min);
            format!("No setting keeps an error of {wanted}; the least is {}.", size(least))
        }
        (Some(0), None) => {
            format!("Recommended for {wanted}: the file as it is; fewer digits would save nothing.")
        }
        (Some(0), Some(saved)) => format!(
            "Recommended for {wanted}: the file as it is; fewer digits save {}, less than their check takes.",
            part(saved)
        ),
        (Some(i), _) => {
            let choice = &study.choices[i];
            let ratio = own.map_or(f64::NAN, |own| choice.total / own.total);
            format!("Recommended for {wanted}: `{}`, in {} of the file's time.", options(choice), part(ratio))
        }
    }
}

/// The price of each effect on top of those before it.
pub(super) fn effects(study: &AccuracyStudy) -> String {
    let mut words = Vec::new();
    for (i, (name, micros)) in prices(study).into_iter().enumerate() {
        words.push(match i {
            0 => format!("{name} {:.0}", 1e3 * micros),
            _ => format!("{name} +{:.0}", 1e3 * micros),
        });
    }
    format!("A position, ns: {}.", words.join(", "))
}

/// Microseconds of each effect, all loads as one, as parts of what a position takes.
pub(super) fn prices(study: &AccuracyStudy) -> Vec<(&'static str, f64)> {
    let mut all: Vec<(&'static str, f64)> = Vec::new();
    for (name, micros) in &study.effects {
        let name = if ["gravity", "inertia", "springs"].contains(name) { "loads" } else { name };
        match all.last_mut() {
            Some(last) if last.0 == name => last.1 += micros,
            _ => all.push((name, *micros)),
        }
    }
    let whole: f64 = all.iter().map(|effect| effect.1).sum();
    let scale = study.choices.first().map_or(1.0, |own| own.micros / whole);
    if scale.is_finite() {
        all.iter_mut().for_each(|effect| effect.1 *= scale);
    }
    all
}

fn measured(study: &AccuracyStudy) -> Section {
    let mut section = Section::new("Measured");
    let against = match study.source {
        Source::DoubleDouble => "the same positions in double-double",
        Source::Full => "f64 with all settings at their finest",
    };
    section.text(format!(
        "{} position{}, compared with {against}, whose own error is about {:.0e}.",
        study.positions,
        if study.positions == 1 { "" } else { "s" },
        study.floor
    ));
    let full = &study.full;
    let kinds = [
        ("positions", full.position, study.scales.extent, "m"),
        ("velocities", full.velocity, study.scales.velocity, "m/s"),
        ("accelerations", full.acceleration, study.scales.acceleration, "m/s^2"),
        ("forces", full.force, study.scales.force, "N"),
        ("moments", full.moment, study.scales.moment, "N*m"),
    ];
    let in_play: Vec<String> = kinds
        .iter()
        .filter(|k| k.2 > 0.0)
        .map(|(what, _, scale, unit)| format!("{what} relative to {} {unit}", significant(*scale, 3)))
        .collect();
    section.text(format!("Errors are the greatest over all positions: {}.", in_play.join(", ")));
    section.text("Times are the best of repeated runs, on one thread.");
    section
}

fn heading(kind: Kind) -> String {
    let says = match kind {
        Kind::Scalar => "the number type of every position",
        Kind::Friction => "tolerance of the iteration, relative to the forces",
        Kind::Newton => "last step of Newton's method",
        Kind::Triad => "error after Newton's method",
        Kind::Samples => "estimated error at which sampling of a function over the sweep ends",
        Kind::Root => "tolerance of the drive values where a function over the sweep is not smooth",
    };
    let name = kind.name();
    let (first, rest) = name.split_at(1);
    format!("{}{rest}: {says}", first.to_uppercase())
}

fn error_text(row: &Row) -> String {
    match row.error {
        None => NONE.to_owned(),
        Some(error) if row.is_floor => format!("~ {error:.0e}"),
        Some(error) => format!("{error:.0e}"),
    }
}

fn table(knob: &Setting) -> Table {
    let per = if knob.kind.per_cycle() { "µs per cycle" } else { "µs per position" };
    let mut columns = vec![Column::words(knob.kind.sets())];
    let sampled = knob.rows.iter().any(|r| r.samples.is_some());
    if sampled {
        columns.push(Column::right("samples"));
    }
    columns.extend([Column::numbers(per), Column::right("error"), Column::right("digits")]);
    let mut table = Table::new(columns, 1);
    for row in &knob.rows {
        let mut cells = vec![row.setting.clone()];
        if sampled {
            cells.push(row.samples.map_or_else(|| NONE.to_owned(), |n| n.to_string()));
        }
        cells.extend([
            significant(row.micros, 3),
            error_text(row),
            row.error.map_or_else(|| NONE.to_owned(), digits),
        ]);
        table.row(cells);
    }
    table
}

/// The accuracy wanted and reached, in one line.
pub(super) fn reached(reached: &AchievedAccuracy) -> String {
    let against = match reached.source {
        Source::DoubleDouble => {
            format!("the greatest error of {} compared with double-double", positions(reached))
        }
        Source::Full => "estimated from the condition".to_owned(),
    };
    let error = format!("{:.0e}", reached.error);
    format!("within {:.0e}: {error}, {against}; {}", reached.within, words(&reached.settings))
}

fn positions(reached: &AchievedAccuracy) -> String {
    format!("{} position{}", reached.positions, if reached.positions == 1 { "" } else { "s" })
}

fn words(settings: &Settings) -> String {
    let numbers = match settings.scalar {
        Precision::F64 => "f64",
        Precision::DoubleDouble => "double-double",
    };
    if (Settings { scalar: Precision::F64, ..*settings }) == Settings::FULL {
        return format!("{numbers}, all its digits");
    }
    format!(
        "{numbers}, friction {:.0e}, general groups {:.0e}, triads {:.0e}, samples {:.0e}, switching points {:.0e}",
        settings.friction, settings.newton, settings.triad, settings.samples, settings.root
    )
}

#[derive(Serialize)]
struct StudyView<'a> {
    schema: &'static str,
    file: &'a str,
    summary: Value,
    positions: usize,
    reference: &'static str,
    floor: f64,
    instructions: &'static str,
    lanes: usize,
    knobs: Vec<KnobView<'a>>,
    absent: Vec<AbsentView>,
    #[serde(rename = "for")]
    wanted: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    recommendation: Option<Value>,
}

#[derive(Serialize)]
struct KnobView<'a> {
    name: &'static str,
    per: &'static str,
    settings: Vec<RowView<'a>>,
}

#[derive(Serialize)]
struct RowView<'a> {
    setting: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    samples: Option<usize>,
    microseconds: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<f64>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    estimated: bool,
}

#[derive(Serialize)]
struct AbsentView {
    name: &'static str,
    why: &'static str,
}

/// Marks the file's own row and the one recommended.
pub(super) fn flags(view: &mut Map<String, Value>, own: bool, recommended: bool) {
    for (name, set) in [("file", own), ("recommended", recommended)] {
        if set {
            view.insert(name.to_owned(), json!(true));
        }
    }
}

fn summary(study: &AccuracyStudy) -> Value {
    let rows = in_short(study).into_iter().map(|i| {
        let choice = &study.choices[i];
        let mut view = Map::new();
        view.insert("digits".to_owned(), json!(choice.digits()));
        view.insert("solve_with".to_owned(), json!(options(choice)));
        view.insert("microseconds".to_owned(), json!(choice.total));
        flags(&mut view, i == 0, study.recommendation == Some(i));
        Value::Object(view)
    });
    let effects =
        prices(study).into_iter().map(|(name, micros)| json!({ "name": name, "microseconds": micros }));
    json!({
        "rows": rows.collect::<Vec<_>>(),
        "finding": finding(study),
        "effects": effects.collect::<Vec<_>>(),
    })
}

/// The same as one line of JSON: `docs/json-schema/accuracy-1.json`.
#[must_use]
pub fn study_json(file: &str, study: &AccuracyStudy) -> String {
    let knobs = study.knobs.iter().map(|knob| KnobView {
        name: knob.kind.name(),
        per: if knob.kind.per_cycle() { "cycle" } else { "position" },
        settings: knob
            .rows
            .iter()
            .map(|r| RowView {
                setting: &r.setting,
                samples: r.samples,
                microseconds: r.micros,
                error: r.error,
                estimated: r.is_floor,
            })
            .collect(),
    });
    let view = StudyView {
        schema: SCHEMA,
        file,
        summary: summary(study),
        positions: study.positions,
        reference: match study.source {
            Source::DoubleDouble => "double-double",
            Source::Full => "f64",
        },
        floor: study.floor,
        instructions: ONE_BY_ONE,
        lanes: 1,
        knobs: knobs.collect(),
        absent: study.absent.iter().map(|a| AbsentView { name: a.what, why: a.why }).collect(),
        wanted: study.wanted,
        recommendation: study.recommendation.map(|i| recommended(&study.choices[i])),
    };
    // a view of texts and finite numbers is always written
    serde_json::to_string(&view).unwrap_or_default()
}

fn recommended(choice: &PositionChoice) -> Value {
    let setting = choice.within.map_or_else(|| "f64".to_owned(), size);
    let mut view = Map::new();
    view.insert("settings".to_owned(), json!([{ "name": "within", "setting": setting }]));
    view.insert("microseconds".to_owned(), json!(choice.micros));
    if choice.error.is_finite() {
        view.insert("error".to_owned(), json!(choice.error));
    }
    Value::Object(view)
}
