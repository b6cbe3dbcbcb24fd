//! Loads that depend on one another.

use crate::expr::context::Context;
use crate::output::behind;
use crate::values::order::{circular, way_round};
use assur_model::model::{Expr, LoadId, Query};
use miette::LabeledSpan;

/// Reports loads that depend on themselves. Only where nothing else is wrong: then loads have their ids.
pub(crate) fn load_cycles(cx: &mut Context<'_>) {
    if cx.problems.has_errors() || !cx.builder.mech.unsupported.is_empty() {
        return;
    }
    let uses = cx.builder.mech.loads.iter().map(|load| loads_in(cx, load.expressions()));
    let uses = uses.collect::<Vec<_>>();
    let mut free = vec![false; uses.len()];
    while let Some(next) = (0..uses.len()).find(|&i| !free[i] && uses[i].iter().all(|u| free[u.index()])) {
        free[next] = true;
    }
    let Some(start) = free.iter().position(|free| !free) else { return };
    report(cx, &round_from(start, &uses, &free));
}

fn loads_in<'e>(cx: &Context<'_>, exprs: impl Iterator<Item = &'e Expr>) -> Vec<LoadId> {
    let mut found = Vec::new();
    for expr in exprs {
        behind::queries(&cx.builder.mech, expr, &mut |query| {
            if let Query::Load(id) = query {
                found.push(*id);
            }
        });
    }
    found
}

/// From a load that is not free along others that are not, until one comes again.
fn round_from(start: usize, uses: &[Vec<LoadId>], free: &[bool]) -> Vec<usize> {
    let mut path = vec![start];
    loop {
        let last = path[path.len() - 1];
        let Some(next) = uses[last].iter().map(|u| u.index()).find(|u| !free[*u]) else { return path };
        if let Some(again) = path.iter().position(|p| *p == next) {
            return path[again..].to_vec();
        }
        path.push(next);
    }
}

fn report(cx: &mut Context<'_>, loads: &[usize]) {
    let name = |i: &usize| cx.builder.mech.loads[*i].name.clone().unwrap_or_default();
    let Some(first) = loads.first() else { return };
    let chain = way_round(&loads.iter().map(name).collect::<Vec<_>>());
    let place = |i: &usize| cx.builder.mech.loads[*i].span;
    let label = |i: &usize| LabeledSpan::at(place(i).start..place(i).end, "depends on the next one");
    let others = loads[1..].iter().map(label).collect();
    let (name, span) = (name(first), place(first));
    cx.error(circular(&name, &chain, span, others));
}
