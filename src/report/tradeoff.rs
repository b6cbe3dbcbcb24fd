//! The time that accuracy costs, as tables and as JSON.

use serde::Serialize;

use super::answers::NONE;
use super::document::{Column, Report, Section, Table};
use super::headed;
use assur_position::plan::{Numbers, Settings};
use assur_solve::measure::accuracy::{
    AccuracyStudy, AchievedAccuracy, Kind, Recommendation, Row, Setting, Source, lanes,
};
use assur_solve::solve::Model;
use assur_text::units::significant;

/// Name and version of the format.
pub(super) const SCHEMA: &str = "assur.accuracy/1";

/// The output of `accuracy`. `solve` is the time of a whole `assur solve`, µs.
#[must_use]
pub fn of_study(file: &str, model: &Model<'_>, study: &AccuracyStudy, solve: f64) -> Report {
    let mut report = headed(file, model);
    report.notes.clear();
    report.section(measured(study));
    for knob in &study.knobs {
        let mut section = Section::new(heading(knob.kind));
        section.table(table(knob));
        report.section(section);
    }
    let mut section = Section::new("Settings without effect here");
    section.list(study.absent.iter().map(|a| format!("{}: {}", a.what, a.why)).collect());
    report.section(section);
    report.section(recommended(study, solve));
    report
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
    let wide = match lanes() {
        (1, _) => String::new(),
        (width, instructions) => format!("; lanes are {width} wide with {instructions}"),
    };
    section.text(format!("Times are the best of repeated runs, on one thread{wide}."));
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

fn digits(row: &Row) -> String {
    match row.error {
        None => NONE.to_owned(),
        Some(error) => format!("{:.1}", -libm::log10(error.max(1e-40))),
    }
}

fn time(micros: f64) -> String {
    significant(micros, 3)
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
        cells.extend([time(row.micros), error_text(row), digits(row)]);
        table.row(cells);
    }
    table
}

fn recommended(study: &AccuracyStudy, solve: f64) -> Section {
    let mut section = Section::new(format!("For an error of {:.0e}", study.wanted));
    let Some(found) = &study.recommendation else {
        section.text("No setting reaches it.");
        return section;
    };
    let settings = found.settings.iter().map(|(kind, setting)| format!("{}: {setting}", kind.name()));
    section.list(settings.collect());
    if let Some((micros, error)) = found.together {
        section.text(format!(
            "Together {} µs per position with an error of {error:.0e}: {} of the time of f64 with all its digits.",
            time(micros),
            share(micros, found.full)
        ));
    }
    if let Some((micros, error, full)) = found.cycle {
        section.text(format!(
            "For the cycle {} µs with an error of {error:.0e}: {} of the time for all digits.",
            time(micros),
            share(micros, full)
        ));
    }
    let positions = found.together.map_or(0.0, |t| study.positions as f64 * (found.full - t.0));
    let cycle = found.cycle.map_or(0.0, |c| c.2 - c.0);
    let saved = 100.0 * (positions + cycle) / solve;
    let saves =
        if saved >= 1.0 { format!("{} %", significant(saved, 2)) } else { "less than 1 %".to_owned() };
    section.text(format!("This saves {saves} of a whole solve ({} µs from text to report).", time(solve)));
    section
}

fn share(part: f64, whole: f64) -> String {
    format!("{} %", significant(100.0 * part / whole, 2))
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

/// Settings in words.
fn words(settings: &Settings) -> String {
    let numbers = match settings.scalar {
        Numbers::Double => "f64",
        Numbers::DoubleDouble => "double-double",
    };
    if (Settings { scalar: Numbers::Double, ..*settings }) == Settings::FULL {
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
    recommendation: Option<RecommendationView<'a>>,
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

#[derive(Serialize)]
struct ChosenView<'a> {
    name: &'static str,
    setting: &'a str,
}

#[derive(Serialize)]
struct CycleView {
    microseconds: f64,
    error: f64,
}

#[derive(Serialize)]
struct RecommendationView<'a> {
    settings: Vec<ChosenView<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    microseconds: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cycle: Option<CycleView>,
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
        positions: study.positions,
        reference: match study.source {
            Source::DoubleDouble => "double-double",
            Source::Full => "f64",
        },
        floor: study.floor,
        instructions: lanes().1,
        lanes: lanes().0,
        knobs: knobs.collect(),
        absent: study.absent.iter().map(|a| AbsentView { name: a.what, why: a.why }).collect(),
        wanted: study.wanted,
        recommendation: study.recommendation.as_ref().map(view_of),
    };
    // a view of texts and finite numbers is always written
    serde_json::to_string(&view).unwrap_or_default()
}

fn view_of(found: &Recommendation) -> RecommendationView<'_> {
    RecommendationView {
        settings: found
            .settings
            .iter()
            .map(|(kind, setting)| ChosenView { name: kind.name(), setting })
            .collect(),
        microseconds: found.together.map(|t| t.0),
        error: found.together.map(|t| t.1),
        cycle: found.cycle.filter(|c| c.1.is_finite()).map(|c| CycleView { microseconds: c.0, error: c.1 }),
    }
}
