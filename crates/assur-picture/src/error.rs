//! Pictures that cannot exist.

use crate::scene::{Scene, Subject};
use crate::words::offered;
use assur_model::model::LinkId;
use assur_position::position::turns;
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::source::Span;

/// No such point; the help names those that are meant.
pub(crate) fn no_point(scene: &Scene<'_>, name: &str) -> Diagnosis {
    let links = scene.mechanism().links.iter().skip(1);
    let all = links.flat_map(|link| link.points.iter().map(|p| format!("{}.{}", link.name, p.name)));
    let all: Vec<String> = all.collect();
    let near = did_you_mean(name, all.iter().map(String::as_str));
    let help = match near.first() {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the points are {}", offered(&all)),
    };
    let own = name.split_once('.').map_or(name, |(link, _)| link);
    let link =
        scene.mechanism().links.iter().skip(1).find(|l| l.name == own || l.number.as_deref() == Some(own));
    Diagnosis::error(
        "mech::picture::no_point",
        format!("there is no point `{name}` whose path could be drawn"),
    )
    .label(link.map(|link| link.span), "this link has no such point")
    .help(help)
}

pub(crate) fn no_forces(why: &str, help: &str) -> Diagnosis {
    no_forces_for(why, None, "", help.to_owned())
}

/// No forces, because of a drive.
pub(crate) fn no_forces_by_drive(scene: &Scene<'_>, why: &str, what: &'static str, help: &str) -> Diagnosis {
    let at = scene.mechanism().drives.first().map(|drive| drive.span);
    no_forces_for(why, at, what, help.to_owned())
}

/// No motion over which something could be drawn.
pub(crate) fn no_way(scene: &Scene<'_>) -> Diagnosis {
    Diagnosis::error(
        "mech::picture::no_way",
        "there is no motion over which paths or other poses could be drawn",
    )
    .label(scene.mechanism().drives.first().map(|drive| drive.span), "one position")
    .help("give the only drive a range: `drive crank = 0 deg .. 360 deg in 12 steps`")
}

/// No link has a place.
pub(crate) fn nothing_placed(scene: &Scene<'_>, needs: &'static str) -> Diagnosis {
    let links = &scene.mechanism().links;
    let open = (1..links.len()).find(|i| !scene.is_placed(LinkId::at(*i)));
    Diagnosis::error("mech::picture::not_placed", format!("no link has a position: {needs}"))
        .label(open.map(|i| links[i].span), "has no position")
        .help("draw the `train`, which shows shafts without positions")
}

/// No body is elsewhere in any frame.
pub(crate) fn nothing_moves(scene: &Scene<'_>) -> Diagnosis {
    let mechanism = scene.mechanism();
    let drive = mechanism.drives.first();
    let (why, help) = match mechanism.simulation {
        Some(_) => {
            ("all bodies rest until the end", "give a `start` a speed, or a body a load that moves it")
        }
        None => ("no body moves over the range of the drive", "give the drive a longer range"),
    };
    Diagnosis::error("mech::picture::nothing_moves", format!("there is no animation: {why}"))
        .label(drive.map(|drive| drive.span), "nothing moves")
        .help(help)
}

/// No link has a place at which it could be drawn in its own size.
pub(crate) fn no_true_size(scene: &Scene<'_>) -> Diagnosis {
    let link = scene.mechanism().links.get(1);
    Diagnosis::error(
        "mech::picture::no_true_size",
        "there is no mechanism to draw in true size: no link has a position",
    )
    .label(link.map(|link| link.span), "has no position")
    .help("leave `--true-size` out: the section of the train has no millimetres of its own")
}

/// No drive has a speed; the help writes one behind the first.
pub(crate) fn no_speed(scene: &Scene<'_>, what: &'static str) -> Diagnosis {
    let mechanism = scene.mechanism();
    let why = match mechanism.drives.is_empty() {
        true => "the file has no drive",
        false if scene.model.plan.effects.moving => "no drive has a speed, only a sense",
        false => "no drive has a speed",
    };
    let line = mechanism.drives.first().map_or_else(
        || "drive crank = 45 deg at 80 rpm".to_owned(),
        |drive| {
            let speed = if turns(&scene.model, drive) { "80 rpm" } else { "0.1 m/s" };
            match &drive.written {
                Some(written) => format!("drive {} = {written} at {speed}", drive.name),
                None => format!("drive {} at {speed}", drive.name),
            }
        },
    );
    let at = mechanism.drives.first().map(|drive| drive.span);
    Diagnosis::error("mech::picture::no_speed", format!("there are no {what} to draw: {why}"))
        .label(at, "without a speed")
        .help(format!("give the drive a speed: `{line}`"))
}

/// No position, or none of a name, is solved.
pub(crate) fn no_position(subject: &Subject<'_, '_>, name: Option<&str>) -> Diagnosis {
    let at = subject.mechanism.drives.first().map(|drive| drive.span);
    let solved = subject.solution.poses.iter().filter(|p| p.outcome.is_ok());
    let known: Vec<String> = solved.map(|p| p.name.clone()).collect();
    match name {
        Some(name) if !known.is_empty() => Diagnosis::error(
            "mech::picture::no_position",
            format!("there is no position to draw: no solved pose is named `{name}`"),
        )
        .label(at, "these are the positions")
        .help(format!("the poses are {}", offered(&known))),
        _ => without_position(subject),
    }
}

/// What is drawn needs a position, and there is none.
fn without_position(subject: &Subject<'_, '_>) -> Diagnosis {
    let code = "mech::picture::no_position";
    let kinds: Vec<String> = subject.kinds().into_iter().map(|kind| kind.name().to_owned()).collect();
    if !kinds.is_empty() {
        return Diagnosis::error(code, "there is no position to draw")
            .help(format!("without one the file has {}", offered(&kinds)));
    }
    if subject.mechanism.links.len() > 1 {
        return Diagnosis::error(code, "there is no position to draw")
            .help("give a link a drive: `drive crank = 45 deg`");
    }
    Diagnosis::error(code, "there is nothing to draw: the file has numbers and no link").help(
        "declare a link with a drive: `drive crank = 45 deg`; a curve is drawn as the load of a shaft: \
             `torque T on S = M(angle(S))`",
    )
}

pub fn no_forces_for(why: &str, at: Option<Span>, what: &'static str, help: impl Into<Help>) -> Diagnosis {
    Diagnosis::error("mech::picture::no_forces", format!("there are no forces to draw: {why}"))
        .label(at, what)
        .help(help)
}
