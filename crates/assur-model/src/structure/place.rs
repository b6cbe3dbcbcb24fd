//! What to report of a point whose place is given: it counts as two coordinates of its link.

use super::defect::{Defect, Fit};
use super::effort::{Effort, EffortKind, X_AXES};
use super::incidence::Incidence;
use super::trial::Trial;
use super::words::{drive_statement, drive_word};
use crate::model::{Drive, DriveTarget, LinkId};
use assur_text::diagnostic::{Diagnosis, Fix};

/// A link that stands freely, whose point is given and whose angle is not.
pub(super) fn without_angle(trial: Trial<'_>, defect: &Defect) -> Option<Diagnosis> {
    let is_loose = |link| defect.loose.contains(&trial.replaced.body_of(link));
    let (link, drive) = places(trial).find(|(link, _)| {
        let angle = EffortKind::Angle(trial.replaced.body_of(*link));
        is_loose(*link) && trial.with(&[], &[angle]).fit().missing < defect.fit.missing
    })?;
    let (name, word) = (&trial.mechanism.link(link).name, drive_word(drive));
    let what = drive_statement(drive);
    let message =
        format!("`{name}` may turn: {what} gives the place of a point, and nothing gives its angle");
    Some(
        Diagnosis::error("mech::determinacy::underconstrained", message)
            .label(drive.span, "two coordinates of three")
            .help(format!("add the line\n  {word} {name} = 0 deg")),
    )
}

/// A link with one freedom left, of which a point is given.
pub(super) fn in_place_of_angle(trial: Trial<'_>, defect: &Defect) -> Option<Diagnosis> {
    if defect.fit.surplus == 0 {
        return None;
    }
    let (link, drive) = places(trial).find(|(link, _)| {
        let Fit { missing, surplus, .. } = by_angle(trial, *link).fit();
        missing == 0 && surplus == 0
    })?;
    let name = &trial.mechanism.link(link).name;
    let (what, line) = (drive_statement(drive), format!("{} {name} = 45 deg", drive_word(drive)));
    let message = format!("{what} gives two coordinates, and one freedom of `{name}` is left");
    Some(
        Diagnosis::error("mech::determinacy::overconstrained", message)
            .label(drive.span, "two coordinates")
            .help(format!("give the angle: write `{line}`, with its own value"))
            .fixes(Fix::quoted(&format!("write `{line}`"), drive.span)),
    )
}

/// With the angle of a link in place of its point.
fn by_angle(trial: Trial<'_>, link: LinkId) -> Incidence {
    let body = trial.replaced.body_of(link);
    let is_place = |effort: &&Effort| !matches!(effort.kind, EffortKind::Place(on, ..) if on == body);
    let mut efforts: Vec<Effort> = trial.efforts.iter().filter(is_place).cloned().collect();
    let source = trial.efforts.iter().find(|effort| !is_place(effort)).map(|effort| effort.source);
    efforts.extend(source.map(|source| Effort {
        source,
        kind: EffortKind::Angle(body),
        also: Vec::new(),
        axes: X_AXES,
    }));
    Incidence::new(trial.replaced, &efforts)
}

/// The links of which a point is given.
fn places(trial: Trial<'_>) -> impl Iterator<Item = (LinkId, &Drive)> {
    trial.mechanism.drives.iter().filter_map(|drive| match drive.target {
        DriveTarget::Place(link, ..) => Some((link, drive)),
        _ => None,
    })
}
