//! What is written and changes nothing, or counts twice.

use crate::expr::context::Context;
use crate::notes::texts::named_in_texts;
use crate::statements::walk::{expressions, parts, same};
use crate::statements::written::text;
use assur_model::model::{Pair, PairKind};
use assur_syntax::document::{
    Body, ExprKind, Load, Member, Place, Property, Site, Spring, SpringSite, Statement,
};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use std::collections::BTreeSet;

/// Functions whose answers depend on masses without a speed and without gravity.
const OF_MASSES: &[&str] = &[
    "mass",
    "mass_centre",
    "inertia",
    "inertia_force",
    "inertia_torque",
    "inertia_arm",
    "kinetic_energy",
    "energy",
    "potential_energy",
    "shaking_force",
    "shaking_moment",
    "rocking_couple",
    "static_substitution",
    "dynamic_substitution",
    "reduced_inertia",
    "natural_frequency",
    "damped_frequency",
    "damping_ratio",
];

/// Masses in a file without gravity and without a speed: neither weights nor inertia forces are computed.
pub(super) fn masses(cx: &mut Context<'_>) {
    let statements = || cx.doc.statements.iter().map(|s| &s.node);
    let sought = statements().any(|s| matches!(s, Statement::Equilibrium(_)));
    let counts = |s: &Statement| match s {
        Statement::Gravity(_)
        | Statement::Start(_)
        | Statement::Simulate(_)
        | Statement::Flywheel(_)
        | Statement::Counterweight(_)
        | Statement::Ignore(_) => true,
        Statement::Drive(drive) => drive.rate.is_some() || drive.acceleration.is_some(),
        _ => false,
    };
    let mut calls = BTreeSet::new();
    cx.doc.statements.iter().for_each(|s| {
        expressions(&s.node, &mut |expr| {
            parts(expr, &mut |part| {
                if let ExprKind::Call { function, .. } = &part.kind {
                    calls.insert(function.node.as_str());
                }
            });
        });
    });
    let asked = OF_MASSES.iter().any(|function| calls.contains(function));
    if statements().any(counts) || (asked && !sought) {
        return;
    }
    let bodies = cx.doc.statements.iter().filter_map(|s| body(&s.node));
    let mass =
        bodies.flatten().find(|m| matches!(m.node, Member::Mass(_) | Member::Weight(_))).map(|m| m.span);
    let Some(mass) = mass else { return };
    let turns = |pair: &Pair| matches!(pair.kind, PairKind::Revolute(_));
    // along a level line no weight acts
    if sought && !cx.builder.mech.pairs.iter().any(turns) {
        return;
    }
    let (what, help) = if sought {
        (
            "the masses have no weight: the file has no `gravity`",
            "add `gravity 9.81 m/s^2`, unless the mechanism lies flat",
        )
    } else {
        (
            "the masses have no effect: the file has neither `gravity` nor a speed",
            "add `gravity 9.81 m/s^2` for weights, or a speed to the drive for inertia forces, as in `at 60 rpm`",
        )
    };
    cx.error(Diagnosis::advice("mech::geometry::no_effect", what).label(mass, "a mass").help(help));
}

fn body(statement: &Statement) -> Option<&Body> {
    match statement {
        Statement::Link(link) => Some(&link.body),
        Statement::Shaft(shaft) => Some(&shaft.body),
        Statement::Slider(slider) => Some(&slider.body),
        _ => None,
    }
}

/// A second statement like an earlier one.
fn twice(cx: &mut Context<'_>, what: &str, again: Span, first: Span) {
    cx.error(
        Diagnosis::advice(
            "mech::geometry::counts_twice",
            format!("the same {what} is written twice, and counts twice"),
        )
        .primary(again, "again here")
        .label(first, "first here")
        .help("leave one of them out, unless there are two")
        .left_out("the second one", again),
    );
}

/// Two loads without a name that are the same.
pub(super) fn loads_twice(cx: &mut Context<'_>) {
    let loads = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Load(load) if load.name.is_none() => Some((&**load, s.span)),
        _ => None,
    });
    let loads = loads.collect::<Vec<_>>();
    for (i, (load, span)) in loads.iter().enumerate() {
        if let Some((_, first)) = loads[..i].iter().find(|(other, _)| same_load(load, other)) {
            twice(cx, "load", *span, *first);
        }
    }
}

fn same_load(a: &Load, b: &Load) -> bool {
    let option = |a: &Option<_>, b: &Option<_>| match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => same(a, b),
        _ => false,
    };
    let word = |name: &Option<assur_syntax::document::Name>| name.as_ref().map(|n| n.node.clone());
    let sense = |load: &Load| load.value.sense.as_ref().map(|s| s.node);
    a.kind.node == b.kind.node
        && same_site(&a.site, &b.site)
        && same(&a.value.value, &b.value.value)
        && sense(a) == sense(b)
        && word(&a.frame) == word(&b.frame)
        && a.against_motion.is_some() == b.against_motion.is_some()
        && option(&a.last, &b.last)
        && option(&a.when, &b.when)
}

fn same_site(a: &Site, b: &Site) -> bool {
    match (a, b) {
        (Site::Pair(a), Site::Pair(b)) | (Site::Pin(a), Site::Pin(b)) => a.node == b.node,
        (Site::Link { link: a, at: p }, Site::Link { link: b, at: q }) => {
            let place = match (p, q) {
                (None, None) => true,
                (Some(Place::Point(p)), Some(Place::Point(q))) => p.node == q.node,
                (Some(Place::Ground(p)), Some(Place::Ground(q))) => same(p, q),
                _ => false,
            };
            a.node == b.node && place
        }
        (Site::Segment { link: a, from: p, to: q }, Site::Segment { link: b, from: r, to: s }) => {
            a.node == b.node && p.node == r.node && q.node == s.node
        }
        _ => false,
    }
}

/// Two springs between the same points with the same properties.
pub(super) fn springs_twice(cx: &mut Context<'_>) {
    let springs = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Spring(spring) => Some((spring, s.span)),
        _ => None,
    });
    let springs = springs.collect::<Vec<_>>();
    let ends = |spring: &Spring| match &spring.site {
        SpringSite::Points(a, b) => {
            let mut ends = [text(a), text(b)];
            ends.sort();
            ends
        }
        SpringSite::Pair(name) => [name.node.clone(), String::new()],
    };
    let one = |a: &Property, b: &Property| {
        a.name.node == b.name.node
            && a.values.len() == b.values.len()
            && a.values.iter().zip(&b.values).all(|(a, b)| same(a, b))
    };
    let alike = |a: &Spring, b: &Spring| {
        ends(a) == ends(b)
            && a.properties.len() == b.properties.len()
            && a.properties.iter().zip(&b.properties).all(|(a, b)| one(a, b))
    };
    for (i, (spring, span)) in springs.iter().enumerate() {
        if let Some((_, first)) = springs[..i].iter().find(|(other, _)| alike(spring, other)) {
            twice(cx, "spring", *span, *first);
        }
    }
}

/// Givens that nothing uses.
pub(super) fn unused(cx: &mut Context<'_>) {
    let mut used = named_in_texts(cx);
    for statement in &cx.doc.statements {
        expressions(&statement.node, &mut |expr| {
            parts(expr, &mut |part| match &part.kind {
                ExprKind::Name(name) => _ = used.insert(name.clone()),
                ExprKind::Call { args, .. } => {
                    used.extend(args.iter().filter_map(|a| a.name.as_ref()).map(|name| name.node.clone()));
                }
                _ => {}
            });
        });
    }
    let givens = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::Given(given) => Some(&given.name),
        _ => None,
    });
    let idle = givens.filter(|name| !used.contains(&name.node)).cloned().collect::<Vec<_>>();
    for name in idle {
        cx.error(
            Diagnosis::advice("mech::name::unused", format!("nothing uses `{}`", name.node))
                .label(name.span, "given, and not used")
                .help("use it where its value is written as a number, or leave it out"),
        );
    }
}
