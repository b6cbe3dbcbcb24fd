//! What a file that follows a motion cannot have: positions of drives, and what the motion under loads has of itself.

use crate::expr::context::Context;
use crate::motion::drive::{count, moves};
use crate::motion::simulation::{of_given_positions, without_meaning};
use assur_model::model::{BalanceKind, LinkId, PairKind, Positions};
use assur_syntax::document::Statement;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Reports what has no meaning beside `simulate`.
pub(super) fn check(cx: &mut Context<'_>, simulate: Span) {
    // a drive that could not be read may have been what moves
    let is_bad = cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Bad(_)));
    let all_read = !is_bad && cx.builder.mech.drives.len() >= cx.drive_statements().len();
    if all_read {
        starts_or_drives(cx, simulate);
    }
    positions(cx, simulate);
    no_meaning(cx);
    time_is_taken(cx, simulate);
    if all_read {
        balances(cx);
    }
}

/// Reports a motion in which nothing is free and no drive moves.
fn starts_or_drives(cx: &mut Context<'_>, span: Span) {
    let written = cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Start(_)));
    if written
        || cx
            .builder
            .mech
            .drives
            .iter()
            .any(|d| d.free || d.of_time || d.speed.is_some() || d.acceleration.is_some())
    {
        return;
    }
    let drives = &cx.builder.mech.drives;
    let help = match drives.first() {
        Some(drive) => {
            let value = drive.written.clone().unwrap_or_else(|| "45 deg".into());
            format!(
                "write `start {} = {value}` in place of its `drive`, or give it a speed after `at`",
                drive.name
            )
        }
        None => {
            let turning = cx.builder.mech.pairs.iter().find_map(|p| match &p.kind {
                PairKind::Revolute(pins) if pins.iter().any(|pin| pin.link == LinkId::GROUND) => {
                    pins.iter().find(|pin| pin.link != LinkId::GROUND).map(|pin| pin.link)
                }
                _ => None,
            });
            let mech = &cx.builder.mech;
            let joined = |link: LinkId| mech.pairs.iter().any(|pair| pair.kind.links().contains(&link));
            let alone = (1..mech.links.len()).map(LinkId::at).find(|link| !joined(*link));
            let point =
                alone.and_then(|link| Some((&mech.link(link).name, &mech.link(link).points.first()?.name)));
            match (turning, point) {
                (None, Some((link, point))) => {
                    format!(
                        "`{link}` is joined to nothing; let it move freely: add `start {link}.{point} = (0 m, 0 m)` and `start {link} = 0 deg`"
                    )
                }
                _ => {
                    let link = turning.map_or("LINK", |link| mech.link(link).name.as_str());
                    format!("add `start {link} = 45 deg`: one line for each freedom, of a link or a pair")
                }
            }
        }
    };
    cx.error(
        Diagnosis::error(
            "mech::simulate::no_start",
            "nothing moves: no coordinate is free, and no drive has a speed",
        )
        .label(span, "nothing is free")
        .help(help),
    );
}

/// Reports sweeps, lists and poses.
fn positions(cx: &mut Context<'_>, simulate: Span) {
    let mut found = Vec::new();
    for drive in &cx.builder.mech.drives {
        let several = !matches!(drive.positions, Positions::None)
            && count(&drive.positions, moves(cx, drive.target)) != Some(1);
        if several {
            let help =
                format!("give `{}` one position and its speed: it goes on from there in time", drive.name);
            found.push((format!("the sweep of `{}`", drive.name), help, drive.span));
        }
    }
    for drive in cx.builder.mech.drives.iter().filter(|d| d.sense.is_some()) {
        let help =
            format!("give `{}` a speed after `at`; without one and without a sense it rests", drive.name);
        found.push((format!("the sense of `{}`, which has no speed,", drive.name), help, drive.span));
    }
    for pose in &cx.builder.mech.poses {
        let help = "ask for an instant: `expect … at time = 0.5 s`".to_owned();
        found.push((format!("the pose `{}`", pose.name), help, pose.span));
    }
    for (what, help, span) in found {
        cx.error(of_given_positions(&what, help, span, simulate));
    }
}

/// Reports `ignore inertia` and flywheels that are to be found.
fn no_meaning(cx: &mut Context<'_>) {
    for statement in &cx.doc.statements {
        let (what, help) = match &statement.node {
            Statement::Ignore(_) => (
                "`ignore inertia`".to_owned(),
                "leave it out: without inertia nothing tells how the links speed up".to_owned(),
            ),
            Statement::Flywheel(f) => (
                format!("the flywheel `{}`, which is to be found,", f.name.node),
                "give its moment of inertia to a link or a shaft: `inertia 2 kg*m^2`".to_owned(),
            ),
            _ => continue,
        };
        cx.error(without_meaning(&what, &help, statement.span));
    }
}

/// Reports a quantity that is called as the instant.
fn time_is_taken(cx: &mut Context<'_>, simulate: Span) {
    if let Some(span) = cx.names.quantities.get("time").map(|declared| declared.span) {
        cx.error(
            Diagnosis::error(
                "mech::simulate::time",
                "`time` is the instant of the motion in a file with `simulate`",
            )
            .primary(span, "declared here")
            .label(simulate, "the motion")
            .help("give the quantity another name"),
        );
    }
}

/// Reports more balances than coordinates are prescribed.
fn balances(cx: &mut Context<'_>) {
    let driven = cx.builder.mech.drives.iter().filter(|d| !d.free).count();
    let balances = &cx.builder.mech.balances;
    let (Some(last), true) = (balances.last(), balances.len() > driven) else { return };
    let is = if matches!(last.kind, BalanceKind::Torque(_)) { "torque" } else { "force" };
    let help = format!(
        "leave out `{}`, or give the {is} a value: `{is} {} … = …`; write `drive` \
         in place of `start` for a motion that is given",
        last.name, last.name
    );
    let of = |n: usize, one: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") };
    let count = of(balances.len(), "balance");
    let driven = match driven {
        0 => "no coordinate that is driven".to_owned(),
        n => of(n, "coordinate") + if n == 1 { " that is driven" } else { " that are driven" },
    };
    let span = last.span;
    cx.error(
        Diagnosis::error(
            "mech::simulate::balance",
            format!("{count} for {driven}: nothing holds a free coordinate"),
        )
        .label(span, "not needed")
        .help(help),
    );
}
