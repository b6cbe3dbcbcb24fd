//! Friction: the state of every pair at a position, or the power that each loses over a sweep.

use super::answers::{Answers, NONE, with_unit};
use super::document::{Column, Report, Section, Table};
use assur_model::model::{Display, Find, FindKind, Value};
use assur_solve::solve::{PairFriction, Pose, PoseAnswers, Solved};
use assur_text::units::{Dimension, significant};

/// Digits of coefficients and angles.
const LAW_DIGITS: usize = 4;

/// Friction of every pair at the one pose, or, where positions are asked for, the power lost in each at every pose of a sweep.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    if !answers.model.plan.effects.friction {
        return;
    }
    let poses: Vec<(&Pose, &Solved)> =
        answers.poses().filter_map(|p| Some((p, p.outcome.as_ref().ok()?))).collect();
    let mut section = Section::new("Friction");
    match poses.as_slice() {
        [] => {}
        [(_, solved)] if solved.state.forces.locked => {
            section.text("The mechanism is locked: no effort moves it.");
        }
        [(_, solved)] => {
            let view = answers.solution.view(&answers.model, solved);
            section.table(of_one_pose(answers, &view.pair_frictions()));
            if answers.model.mechanism.simulation.is_none() {
                section.text(balance(answers, &view));
            }
        }
        _ if asks_of_the_whole(answers) => {}
        _ => section.table(of_a_sweep(answers, &poses)),
    }
    report.section(section);
}

/// Whether nothing is asked of single positions: then nobody reads what each of them loses.
fn asks_of_the_whole(answers: &Answers<'_>) -> bool {
    let finds = &answers.model.mechanism.finds;
    let of_whole = |find: &Find| matches!(find.kind, FindKind::Value { poseless: true, .. });
    !finds.is_empty() && finds.iter().all(of_whole)
}

/// One row per pair and its two links.
fn of_one_pose(answers: &Answers<'_>, all: &[PairFriction]) -> Table {
    let mechanism = answers.model.mechanism;
    let (force, power) = (mechanism.display_of(Dimension::FORCE), power_display(answers));
    let columns = vec![
        Column::words("pair"),
        Column::words("from → on"),
        Column::words("law"),
        Column::right("relative velocity"),
        Column::right("pressed by"),
        Column::right("friction"),
        Column::right("power lost"),
    ];
    let mut table = Table::new(columns, 2);
    let greatest =
        |number: fn(&PairFriction) -> f64| all.iter().map(number).fold(0.0, |m, x| f64::max(m, x.abs()));
    let (normals, powers) = (greatest(|r| r.normal), greatest(|r| r.power));
    // rounding errors are 0
    let precision = answers.precision;
    let clean = |x: f64, scale: f64| if x.abs() <= precision.noise * scale { 0.0 } else { x };
    for r in all {
        let (speed, effort) = if r.turns {
            (Dimension::ANGULAR_VELOCITY, Dimension::TORQUE)
        } else {
            (Dimension::VELOCITY, Dimension::FORCE)
        };
        let text = |display: &Display, x: f64| display.text(Value::Scalar(x), precision.digits);
        let normal = clean(r.normal, normals);
        // friction is proportional to what presses
        let friction = if normal == 0.0 { 0.0 } else { r.effort };
        let moves = r.speed != 0.0;
        table.row(vec![
            mechanism.pair(r.pair).name.clone(),
            format!("{} → {}", mechanism.link(r.from).name, mechanism.link(r.on).name),
            law(answers, r),
            if moves { text(&mechanism.display_of(speed), r.speed) } else { "none".to_owned() },
            text(&force, normal),
            if moves { text(&mechanism.display_of(effort), friction) } else { NONE.to_owned() },
            if moves { text(&power, clean(r.power, powers)) } else { NONE.to_owned() },
        ]);
    }
    table
}

/// `ρ = 5 mm`, `f = 0.1, 5.711 deg`
fn law(answers: &Answers<'_>, r: &PairFriction) -> String {
    if r.turns {
        let length = answers.model.mechanism.display_of(Dimension::LENGTH);
        return format!("ρ = {}", length.text(Value::Scalar(r.factor), LAW_DIGITS));
    }
    let angle = significant(libm::atan(r.factor).to_degrees(), LAW_DIGITS);
    format!("f = {}, {angle} deg", significant(r.factor, LAW_DIGITS))
}

fn power_display(answers: &Answers<'_>) -> Display {
    answers.model.mechanism.display_of(Dimension::POWER)
}

/// The loads and the motion are the same without friction, so the efforts differ by the losses of the pairs.
fn balance(answers: &Answers<'_>, view: &PoseAnswers<'_>) -> String {
    let display = power_display(answers);
    let text = |x: f64| display.text(Value::Scalar(x), answers.precision.digits);
    let lost: f64 = view.pair_frictions().iter().map(|r| r.power).sum();
    let (actual, ideal) = (view.power_of_efforts(), view.without_friction().power_of_efforts());
    let speed = if answers.model.plan.effects.timed { "" } else { ", at unit drive speed" };
    format!(
        "Friction losses {} = power of the efforts with friction ({}) minus without ({}){speed}.",
        text(lost),
        text(actual),
        text(ideal)
    )
}

/// Power lost: one row per pose, one column per pair.
fn of_a_sweep(answers: &Answers<'_>, poses: &[(&Pose, &Solved)]) -> Table {
    let display = power_display(answers);
    let mut table = Table::new(vec![Column::words(answers.pose_header())], 1);
    table.rows = poses.iter().map(|(p, _)| vec![p.name.clone()]).collect();
    let all: Vec<Vec<PairFriction>> =
        poses.iter().map(|(_, s)| answers.solution.view(&answers.model, s).pair_frictions()).collect();
    let scale = all.iter().flatten().map(|r| r.power).fold(0.0, f64::max);
    for (i, pair) in answers.model.mechanism.pairs.iter().enumerate() {
        let of_pair = |r: &&PairFriction| r.pair.index() == i;
        if !all.iter().flatten().any(|r| of_pair(&r)) {
            continue;
        }
        let lost =
            |rubbing: &Vec<PairFriction>| -> f64 { rubbing.iter().filter(of_pair).map(|r| r.power).sum() };
        let cells = all.iter().zip(poses).map(|(r, (_, solved))| {
            if solved.state.forces.locked {
                return "locked".to_owned();
            }
            answers.precision.figures(display.of_si(lost(r)), display.of_si(scale))
        });
        table.column(with_unit(&format!("lost in {}", pair.name), &display.unit), cells);
    }
    table
}
