//! Events and ends of a sweep: the range of a drive takes the place of time.

use super::{event, may_be_missing, no_simulation};
use crate::expr::context::Context;
use crate::motion::drive::{Moves, count, moves};
use assur_model::model::DriveTarget;
use assur_syntax::document::Statement;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Enters the events of a file without `simulate`. Reports them without one drive that goes through a range.
pub(super) fn events(cx: &mut Context<'_>) {
    let words = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Event(_) => Some(("event", s.span)),
        Statement::Until(_) => Some(("until", s.span)),
        _ => None,
    });
    let words: Vec<(&'static str, Span)> = words.collect();
    let Some(first) = words.first() else { return };
    event::events(cx);
    let Some(swept) = cx.builder.mech.swept_drive() else {
        if may_be_missing(cx) {
            words.into_iter().for_each(|word| needs_range(cx, word));
        }
        return;
    };
    let drives = &cx.builder.mech.drives;
    let goes_on = |target, positions| count(positions, moves(cx, target)) != Some(1);
    let mut others =
        drives.iter().enumerate().filter(|(i, d)| *i != swept && goes_on(d.target, &d.positions));
    let point = matches!(drives[swept].target, DriveTarget::Point(..));
    if let Some((_, other)) = others.next().filter(|_| !point) {
        let (name, span, range) = (other.name.clone(), other.span, drives[swept].span);
        let what = format!("`{}` looks along one drive, and `{name}` goes through positions too", first.0);
        cx.error(
            Diagnosis::error("mech::simulate::two_ranges", what)
                .primary(span, "a second one")
                .label(range, "this range")
                .help(format!(
                    "give `{name}` one position, or write `simulate` with both as expressions of `time`"
                )),
        );
    }
}

/// Reports an event in a file whose drives have one position, or a list.
fn needs_range(cx: &mut Context<'_>, (word, span): (&'static str, Span)) {
    let mech = &cx.builder.mech;
    let Some(drive) = mech.drives.iter().find(|drive| !drive.free) else {
        let help = "add `simulate 0 s .. 1 s` with a `start` for each free coordinate".to_owned();
        return cx.error(no_simulation(word, help, span));
    };
    let (range, speed) = match moves(cx, drive.target) {
        Moves::Turning => ("0 deg .. 360 deg in 36 steps", " at 10 rad/s"),
        _ => ("0 mm .. 100 mm in 20 steps", " at 0.1 m/s"),
    };
    let speed = if drive.speed.is_some() { speed } else { "" };
    let help = format!("let the drive go through a range: `drive {} = {range}{speed}`", drive.name);
    let place = drive.span;
    cx.error(
        Diagnosis::error(
            "mech::simulate::missing",
            format!("`{word}` needs the range of a drive, or `simulate`"),
        )
        .primary(span, "happens nowhere")
        .label(place, "no range")
        .help(help),
    );
}
