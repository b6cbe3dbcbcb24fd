//! Poses beside those of the sweep.

use crate::expr::context::Context;
use crate::motion::drive::{Moves, count, moves, stated_twice, value, zero};
use crate::motion::place;
use crate::names::suggestion::suggestion;
use crate::statements::written::text;
use assur_model::model::{Axis, DriveId, Expr, NamedPose, Positions};
use assur_syntax::document::{Pose, Setting, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Enters all named poses into the mechanism.
pub(crate) fn poses(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Pose(pose) = &statement.node {
            let free = not_of_sweep(cx, pose);
            let at = settings(cx, &pose.settings, &format!("pose `{}`", pose.name.node), pose.name.span);
            if let (true, Some(at)) = (free, at) {
                cx.builder.mech.poses.push(NamedPose {
                    name: pose.name.node.clone(),
                    span: statement.span,
                    at,
                });
            }
        }
    }
}

/// Drive values after `at`. Drives that are not named keep their single position. `what` is what needs them; `span` is
/// its place. Reports what is not driven, left open or said twice; silent about drives that have an error.
pub(crate) fn settings(
    cx: &mut Context<'_>,
    settings: &[Setting],
    what: &str,
    span: Span,
) -> Option<Vec<(DriveId, Expr)>> {
    let mut at = Some(Vec::new());
    for (i, setting) in settings.iter().enumerate() {
        let name = text(&setting.target);
        if let Some(first) = settings[..i].iter().find(|s| text(&s.target) == name) {
            stated_twice(cx, &name, setting.target.span(), first.target.span());
            at = None;
            continue;
        }
        let set = set(cx, setting, &name);
        at = at.zip(set).map(|(mut at, set)| {
            at.extend(set);
            at
        });
    }
    let mut at = at?;
    for index in 0..cx.builder.mech.drives.len() {
        let id = DriveId::at(index);
        if at.iter().any(|(drive, _)| *drive == id) {
            continue;
        }
        let drive = &cx.builder.mech.drives[index];
        match &drive.positions {
            Positions::None => {}
            Positions::List(values) if values.len() == 1 => at.push((id, values[0].clone())),
            _ => {
                let name = &drive.name;
                let error = Diagnosis::error(
                    "mech::geometry::pose_incomplete",
                    format!("{what} does not give the position of `{name}`"),
                )
                .primary(span, format!("the position of `{name}` is missing"))
                .label(drive.span, "several positions")
                .help(format!(
                    "add `, {name} = {}`, with its own value: `{name}` goes through several positions",
                    zero(moves(cx, drive.target), 0)
                ));
                cx.error(error);
                return None;
            }
        }
    }
    at.sort_by_key(|(drive, _)| *drive);
    Some(at)
}

fn set(cx: &mut Context<'_>, setting: &Setting, name: &str) -> Option<Vec<(DriveId, Expr)>> {
    let span = setting.target.span();
    cx.names.note_path(&setting.target);
    if let Some(index) = cx.builder.mech.drives.iter().position(|d| d.name == name) {
        let moves = moves(cx, cx.builder.mech.drives[index].target);
        return value(cx, &setting.value, moves, 0, name).map(|v| vec![(DriveId::at(index), v)]);
    }
    if place::is_place(cx, &setting.target)
        && let Some(index) = cx.builder.mech.drives.iter().position(|d| d.written_name() == name)
    {
        let place = value(cx, &setting.value, Moves::Freely, 0, name)?;
        let of = |axis: Axis| place::component(&place, axis);
        return Some(vec![(DriveId::at(index), of(Axis::X)), (DriveId::at(index + 1), of(Axis::Y))]);
    }
    if name == "time" {
        cx.builder.unsupported("an instant of a simulation", span);
        return None;
    }
    let declared = |s: &Statement| match s {
        Statement::Drive(d) => text(&d.target) == name,
        Statement::Bad(bad) => bad.names.contains(&setting.target.head.node),
        _ => false,
    };
    if cx.doc.statements.iter().any(|s| declared(&s.node)) {
        return None;
    }
    if !cx.problems.reported.insert(("drive", name.to_owned())) {
        return None;
    }
    let driven = cx.builder.mech.drives.iter().map(|d| d.name.as_str()).collect::<Vec<_>>();
    let help = suggestion(name, span, &driven, "drives").unwrap_or_else(|| {
        format!("add the line `drive {name} = {}`, with your own values", positions(cx, name)).into()
    });
    cx.error(
        Diagnosis::error("mech::geometry::not_driven", format!("`{name}` is not driven"))
            .label(span, "no drive moves it")
            .help(help),
    );
    None
}

/// An example of positions: as many as values are expected.
fn positions(cx: &Context<'_>, name: &str) -> String {
    let lists = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Expect(e) => Some(e.values.len()),
        _ => None,
    });
    let sliding = cx.find_link(name).is_none()
        && cx.find_pair(name).is_some_and(|p| {
            !matches!(cx.builder.mech.pair(p).kind, assur_model::model::PairKind::Revolute(_))
        });
    match lists.max() {
        _ if sliding => "100 mm".into(),
        Some(n) if n > 1 => format!("0 deg .. 360 deg in {n} steps at 60 rpm"),
        _ => "45 deg".into(),
    }
}

/// The poses of the sweep have numbers for names.
fn not_of_sweep(cx: &mut Context<'_>, pose: &Pose) -> bool {
    let Ok(number) = pose.name.node.parse::<usize>() else { return true };
    let longest = cx.builder.mech.drives.iter().filter_map(|d| {
        let count = count(&d.positions, moves(cx, d.target))?;
        Some((count, d.span))
    });
    let Some((count, drive)) = longest.max_by_key(|(count, _)| *count) else { return true };
    if number == 0 || number > count {
        return true;
    }
    let name = pose.name.node.clone();
    cx.error(
        Diagnosis::error("mech::geometry::pose_of_sweep", format!("the sweep already has a pose {name}"))
            .primary(pose.name.span, "this name is taken")
            .label(drive, format!("{count} poses"))
            .help(format!("write `pose {name}'`; poses of the sweep are numbered from 1 to {count}")),
    );
    false
}
