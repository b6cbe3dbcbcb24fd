//! Questions whose answer stands in the file.

use crate::expr::context::Context;
use assur_model::model::{DriveTarget, Expr, FindKind, Load, LoadKind, Mechanism, PairKind, Query};
use assur_text::diagnostic::Diagnosis;

/// A load that is given at the drive and asked for, where nothing is to balance: the effort was probably meant.
pub(super) fn given_load(cx: &mut Context<'_>) {
    let mech = &cx.builder.mech;
    if !mech.balances.is_empty() {
        return;
    }
    let found = mech.finds.iter().find_map(|find| {
        let FindKind::Value { expr: Expr::Query(Query::Load(id)), .. } = &find.kind else { return None };
        let load = mech.loads.get(id.index())?;
        let is_given = load.when.is_none() && matches!(load.value(), Expr::Constant(_));
        is_given.then(|| at_drive(mech, load))?.map(|line| (find.span, load.span, line))
    });
    let Some((asked, given, line)) = found else { return };
    let name = line.split(' ').nth(2).unwrap_or_default();
    cx.error(
        Diagnosis::advice("mech::request::given_load", format!("`{name}` is asked for, but it is given"))
            .label(asked, "asked for here")
            .primary(given, "given here")
            .help(format!("write `{line}`, if it is the unknown effort that keeps the balance"))
            .quoted(given),
    );
}

/// The statement of an unknown effort in place of a load, where that acts on what is driven.
fn at_drive(mech: &Mechanism, load: &Load) -> Option<String> {
    let name = load.name.as_deref()?;
    let drives = |target| mech.drives.iter().any(|d| !d.is_unaided() && d.target == target);
    match load.kind {
        LoadKind::Torque { on, against_motion: false, .. } if drives(DriveTarget::Link(on)) => {
            Some(format!("balance torque {name} on {}", mech.link(on).name))
        }
        LoadKind::InPair { pair, against_motion: false, .. } if drives(DriveTarget::Pair(pair)) => {
            let pair = mech.pair(pair);
            let kind = if matches!(pair.kind, PairKind::Revolute(_)) { "torque" } else { "force" };
            Some(format!("balance {kind} {name} in {}", pair.name))
        }
        _ => None,
    }
}
