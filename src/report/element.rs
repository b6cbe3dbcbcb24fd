//! Designed cams and tables of machine elements.

use super::answers::{Answers, NONE, with_unit};
use super::document::{Column, Report, Section, Table};
use assur_drawing::{Dxf, Role, Shape};
use assur_math::element::cam::{Law, Phase};
use assur_math::math::Vec2;
use assur_model::model::{self, CamContact, Display, LinkId, Mechanism, PlateCam, Value};
use assur_solve::solve::{Model, Pose};
use assur_text::units::{Dimension, significant};

/// Rounding of a lift, over the greatest one.
const ROUNDING: f64 = 1e-12;

/// What each designed cam does over a turn, the dwell that is left of it among them.
pub(super) fn cams(model: &Model<'_>, report: &mut Report) {
    for (i, plate) in model.mechanism.cams.iter().enumerate() {
        let mut section = phases(model.mechanism, plate);
        for contact in model.mechanism.cam_contacts.iter().filter(|contact| contact.cam == i) {
            section.text(format!("cam angle = {}", cam_angle(model.mechanism, plate, contact)));
        }
        report.section(section);
    }
}

/// `angle(disk) − 90 deg`: the angle of a cam from the angle of its link, by the direction in which the follower stands.
fn cam_angle(mechanism: &Mechanism, plate: &PlateCam, contact: &CamContact) -> String {
    let angle = mechanism.display_of(Dimension::ANGLE);
    let of = |link: LinkId| format!("angle({})", mechanism.link(link).name);
    let zero = contact.towards.angle();
    let size = format!("{} {}", angle.figures(Value::Scalar(zero.abs()), 6), angle.unit);
    let mut terms = vec![(1.0, of(contact.disk))];
    if contact.frame != LinkId::GROUND {
        terms.push((-1.0, of(contact.frame)));
    }
    if zero.abs() > ROUNDING {
        terms.push((-zero, size));
    }
    let sense = if plate.cam.ccw { 1.0 } else { -1.0 };
    // what is added comes first
    terms.sort_by_key(|(sign, _)| sign * sense < 0.0);
    let mut text = String::new();
    for (i, (sign, term)) in terms.iter().enumerate() {
        text += match (i, sign * sense < 0.0) {
            (0, false) => "",
            (0, true) => "−",
            (_, false) => " + ",
            (_, true) => " − ",
        };
        text += term;
    }
    text
}

fn phases(mechanism: &Mechanism, plate: &PlateCam) -> Section {
    let angle = mechanism.display_of(Dimension::ANGLE);
    let oscillates = plate.cam.follower.oscillates();
    let lift = mechanism.display_of(if oscillates { Dimension::ANGLE } else { Dimension::LENGTH });
    let figures = |display: &Display, x: f64| display.figures(Value::Scalar(x), 6);
    let mut table = Table::new(vec![Column::words("phase")], 1);
    for (header, display) in [("from", &angle), ("to", &angle), ("lift from", &lift), ("lift to", &lift)] {
        table.columns.push(Column::numbers(with_unit(header, &display.unit)));
    }
    table.columns.push(Column::words("law"));
    for phase in merged(plate.cam.program.phases()) {
        let what = match phase.change {
            _ if matches!(phase.law, Law::Spline(_)) => "lift",
            0.0 => "dwell",
            up if up > 0.0 => "rise",
            _ => "fall",
        };
        let (from, to) = (phase.start, phase.start + phase.angle);
        let to_lift = phase.from + phase.change;
        table.row(vec![
            what.to_owned(),
            figures(&angle, from),
            figures(&angle, to),
            figures(&lift, phase.from),
            // what comes back to the base circle does so but for rounding
            figures(
                &lift,
                if to_lift.abs() < ROUNDING * plate.cam.program.greatest_lift() { 0.0 } else { to_lift },
            ),
            law(phase.law).to_owned(),
        ]);
    }
    let mut section = Section::new(format!("Cam {}", plate.name));
    section.table(table);
    section
}

/// The phases, the pieces of a table as one.
fn merged(phases: &[Phase]) -> Vec<Phase> {
    let mut all: Vec<Phase> = Vec::new();
    for phase in phases {
        match all.last_mut() {
            Some(last) if matches!((last.law, phase.law), (Law::Spline(_), Law::Spline(_))) => {
                last.angle += phase.angle;
                last.change += phase.change;
            }
            _ => all.push(*phase),
        }
    }
    all
}

const fn law(law: Law) -> &'static str {
    match law {
        Law::Dwell => "",
        Law::Uniform => "uniform",
        Law::Parabolic => "parabolic",
        Law::Harmonic => "harmonic",
        Law::Cycloidal => "cycloidal",
        Law::Poly345 => "poly345",
        Law::Poly4567 => "poly4567",
        Law::ModifiedTrapezoid => "modified_trapezoid",
        Law::ModifiedSine => "modified_sine",
        Law::Spline(_) => "table",
    }
}

/// The tables that are asked for.
pub(super) fn tables(answers: &Answers<'_>, report: &mut Report) {
    for (name, table, pose) in answers.tables() {
        let mut section = Section::new(name);
        section.table(if table.upright { upright(answers, table) } else { lying(answers, table, pose) });
        report.section(section);
    }
}

fn figures(answers: &Answers<'_>, display: &Display, x: f64, greatest: f64) -> String {
    if x.is_finite() {
        answers.precision.figures(display.of_si(x), display.of_si(greatest))
    } else {
        NONE.to_owned()
    }
}

/// One column per entry.
fn lying(answers: &Answers<'_>, table: &model::Table, pose: Option<&Pose>) -> Table {
    let rows = table.entries.first().map_or(0, |e| e.values.len());
    let mut out = Table { rows: vec![Vec::new(); rows], ..Table::new(Vec::new(), 1) };
    for entry in &table.entries {
        let values = answers.entry(entry, pose);
        let greatest = values.iter().filter(|x| x.is_finite()).fold(0.0, |m, x| f64::max(m, x.abs()));
        let cells = values.iter().map(|x| figures(answers, &entry.display, *x, greatest));
        out.column(with_unit(&entry.name, &entry.display.unit), cells);
    }
    out
}

/// One row per entry, with what belongs to each of several parts side by side.
fn upright(answers: &Answers<'_>, table: &model::Table) -> Table {
    let most = table.entries.iter().map(|e| e.values.len()).max().unwrap_or(0);
    let mut columns = vec![Column::words("quantity")];
    columns.extend((1..=most).map(|i| Column::numbers(i.to_string())));
    columns.push(Column::words("unit"));
    let mut out = Table::new(columns, 1);
    for entry in &table.entries {
        let mut cells = vec![entry.name.clone()];
        cells.extend(entry.values.iter().map(|x| figures(answers, &entry.display, *x, 0.0)));
        cells.resize(most + 1, String::new());
        cells.push(entry.display.unit.clone());
        out.row(cells);
    }
    out
}

/// A table of a cam with all digits, for other programs.
#[must_use]
pub fn full(table: &model::Table) -> Table {
    let rows = table.entries.first().map_or(0, |e| e.values.len());
    let mut out = Table { rows: vec![Vec::new(); rows], ..Table::new(Vec::new(), 1) };
    for entry in &table.entries {
        let cell =
            |x: &f64| if x.is_finite() { significant(entry.display.of_si(*x), 15) } else { String::new() };
        out.column(with_unit(&entry.name, &entry.display.unit), entry.values.iter().map(cell));
    }
    out
}

// A cam as a drawing: DXF R12, millimetres, the cam's centre in the origin, its axes those of the drawing.

/// Profile, pitch curve and base circle, each on a layer of its own, the curves as closed polylines of `steps` vertices at
/// equal steps of the cam angle.
#[must_use]
pub fn dxf(plate: &PlateCam, steps: u32) -> String {
    let mut dxf = Dxf::new();
    let cam = &plate.cam;
    // drawings have y downwards
    let on_paper = |at: Vec2| Vec2::new(at.x * 1e3, -at.y * 1e3);
    let curve = |points: Vec<Vec2>| Shape::polygon(points.into_iter().map(on_paper).collect());
    let circle = |radius: f64| Shape::Circle { centre: Vec2::zero(), radius: radius * 1e3 };
    let pitch = cam.pitch_curve(steps).map(|points| ("PITCH", curve(points)));
    let profile = ("PROFILE", curve(cam.profile(steps)));
    let round = [("BASE", circle(cam.base_radius)), ("CENTRE", circle(0.0))];
    for (layer, shape) in [profile].into_iter().chain(pitch).chain(round) {
        let pen = dxf.pen(layer, Role::Ink, "");
        dxf.shape(pen, &shape);
    }
    dxf.finish()
}
