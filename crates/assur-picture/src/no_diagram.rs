//! Diagrams that cannot exist.

use crate::scene::Scene;
use crate::words::offered;
use assur_position::position::turns;
use assur_solve::answer::NoSweep;
use assur_solve::solve::Cause;
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::Span;

/// A place with what is said of it.
pub type Place = (Option<Span>, &'static str);

/// The first item of `find`, which does not ask for what is drawn.
pub(crate) fn first_item(scene: &Scene<'_>) -> Place {
    (scene.mechanism().finds.first().map(|find| find.span), "asks for something else")
}

/// The link of a point that it has not.
pub(crate) fn link_of(scene: &Scene<'_>, point: &str) -> Place {
    let name = point.split_once('.').map_or(point, |(link, _)| link);
    let link = scene.mechanism().links.iter().skip(1).find(|link| link.name == name);
    (link.map(|link| link.span), "this link has no such point")
}

/// There is no sweep; the help writes one.
pub(crate) fn no_sweep(scene: &Scene<'_>, what: &'static str, cause: &Cause) -> Diagnosis {
    let mechanism = scene.mechanism();
    let why = match cause {
        Cause::NoSweep(NoSweep::OnePosition) if mechanism.drives.is_empty() => "the file has no drive",
        Cause::NoSweep(NoSweep::OnePosition) => "the file has one position and no sweep",
        Cause::NoSweep(NoSweep::Unordered(_)) => "the positions of the drive are listed out of order",
        Cause::NoSweep(NoSweep::TooLong) => "the sweep is too long",
        _ => "the sweep cannot be followed",
    };
    let drive = mechanism.drives.first();
    let turns = drive.is_none_or(|drive| turns(&scene.model, drive));
    let name = drive.map_or("crank", |drive| drive.name.as_str());
    let line = if turns {
        format!("drive {name} = 0 deg .. 360 deg in 36 steps at 80 rpm")
    } else {
        format!("drive {name} = 0 mm .. 100 mm in 20 steps at 0.1 m/s")
    };
    let label = match cause {
        Cause::NoSweep(NoSweep::Unordered(_)) => "out of order",
        Cause::NoSweep(NoSweep::OnePosition) => "one position",
        _ => "over this way",
    };
    let at = drive.map(|drive| drive.span);
    nothing_to_go_over(what, why, at, label, format!("let the drive go through positions: `{line}`"))
}

/// Nothing to plot; the help says what the file asks for.
pub(crate) fn no_quantity(scene: &Scene<'_>, why: &str) -> Diagnosis {
    let link = scene.mechanism().links.get(1).map_or("rocker", |link| link.name.as_str());
    let help =
        format!("name a number: `plot \"omega({link})\"`, or ask for one in the file: `find omega({link})`");
    let at = scene.mechanism().finds.first().map(|find| find.span);
    Diagnosis::error("mech::picture::no_quantity", format!("there is nothing to plot: {why}"))
        .label(at, "asked for here")
        .help(help)
}

/// No Fourier series; the help asks for one.
pub(crate) fn no_term(scene: &Scene<'_>) -> Diagnosis {
    let mechanism = scene.mechanism();
    let name = mechanism.balances.first().map_or("shaking_force().x", |balance| balance.name.as_str());
    let (at, label) = first_item(scene);
    let why = "there is no Fourier series to draw: the file asks for no amplitude of one";
    Diagnosis::error("mech::picture::no_fourier", why)
        .label(at, label)
        .help(format!("ask for a table, as in `find fourier({name}) in 8 steps`"))
}

/// No forces inside a link; the help asks for some.
pub(crate) fn no_internal(scene: &Scene<'_>) -> Diagnosis {
    let mut links = scene.mechanism().links.iter().skip(1);
    let long = links.find(|link| link.extent()[0] < link.extent()[1]);
    let name = long.map_or("beam", |link| link.name.as_str());
    let (at, label) = first_item(scene);
    let why = "there are no internal forces to draw: the file asks for none";
    Diagnosis::error("mech::picture::no_internal", why)
        .label(at, label)
        .help(format!("ask for a table, as in `find internal({name}) in 12 steps`"))
}

/// No rotor with masses in several planes.
pub(crate) fn no_planes() -> Diagnosis {
    let why = "there are no planes to draw: no link on the ground has masses in several planes";
    Diagnosis::error("mech::picture::no_planes", why)
        .help("give the masses of a link their planes: `mass 2 kg at P plane 100 mm`")
}

/// No equilibrium that was sought among all positions of one coordinate.
pub(crate) fn no_equilibrium(scene: &Scene<'_>) -> Diagnosis {
    let mechanism = scene.mechanism();
    let several = mechanism.drives.iter().rfind(|drive| drive.sought.is_some());
    let drive = several.or_else(|| mechanism.drives.first());
    let name = drive.map_or("bar", |drive| drive.name.as_str());
    let (why, label, help) = if several.is_some() {
        let help = format!("drive all but one of them, as in `drive {name} = …`");
        ("it is drawn over one coordinate, and the file seeks several", "one of several", help)
    } else {
        ("the file seeks no equilibrium", "driven", format!("seek one: `equilibrium {name} near 60 deg`"))
    };
    Diagnosis::error("mech::picture::no_equilibrium", format!("there is no potential energy to draw: {why}"))
        .label(drive.map(|drive| drive.span), label)
        .help(help)
}

/// No flywheel; the help writes one.
pub(crate) fn no_flywheel(scene: &Scene<'_>) -> Diagnosis {
    let mechanism = scene.mechanism();
    let drive = mechanism.drives.first();
    let name = drive.map_or("crank", |drive| drive.name.as_str());
    Diagnosis::error("mech::picture::no_flywheel", "there is no work to draw: the file declares no flywheel")
        .help(format!("declare one: `flywheel J on {name} {{ fluctuation 1/25 }}`"))
}

/// No point to draw the velocity of; the help names one on the command line and in the file.
pub(crate) fn no_velocity(why: String, (at, label): Place, points: &[String]) -> Diagnosis {
    let help = points.first().map_or_else(
        || "give a link a point: `link crank A-B 100 mm`".to_owned(),
        |first| {
            let known = offered(points);
            format!("name a point, `hodograph {first}`, or ask in the file, `find velocity({first})`; there are {known}")
        },
    );
    unknown("hodograph", &why, at, label, help)
}

/// No pair to draw the reaction of; the help names one on the command line and asks in the file.
pub(crate) fn no_reaction(why: String, (at, label): Place, pairs: &[String]) -> Diagnosis {
    let help = pairs.first().map_or_else(
        || "declare a pair: `revolute A: ground - crank`".to_owned(),
        |first| {
            let known = offered(pairs);
            format!("name a pair, `polar {first}`, or ask in the file, `find reactions`; there are {known}")
        },
    );
    unknown("polar diagram", &why, at, label, help)
}

/// No bar to draw the force of.
pub(crate) fn no_axial(scene: &Scene<'_>) -> Diagnosis {
    let (at, label) = first_item(scene);
    Diagnosis::error("mech::picture::no_axial", "there are no axial forces to draw: the file asks for none")
        .label(at, label)
        .help("ask in the file: `find axial`")
}

/// The file asks for no curvature of a path, or it has none here.
pub(crate) fn no_curvature(scene: &Scene<'_>) -> Diagnosis {
    let (at, label) = first_item(scene);
    let links = scene.mechanism().links.iter().skip(1);
    let point = links.flat_map(|link| link.points.last().map(|p| format!("{}.{}", link.name, p.name))).last();
    let point = point.unwrap_or_else(|| "rod.C".to_owned());
    Diagnosis::error("mech::picture::no_curvature", "there is no curvature of a path to draw")
        .label(at, label)
        .help(format!("ask in the file: `find curvature_radius({point})`"))
}

/// There are no positions to go over.
fn nothing_to_go_over(
    what: &'static str,
    why: &'static str,
    at: Option<Span>,
    label: &'static str,
    help: impl Into<Help>,
) -> Diagnosis {
    Diagnosis::error("mech::picture::no_sweep", format!("there is no {what} to draw: {why}"))
        .label(at, label)
        .help(help)
}

/// A point or a pair that is not there.
fn unknown(
    what: &'static str,
    why: &str,
    at: Option<Span>,
    label: &'static str,
    help: impl Into<Help>,
) -> Diagnosis {
    Diagnosis::error("mech::picture::unknown", format!("there is no {what} to draw: {why}"))
        .label(at, label)
        .help(help)
}
