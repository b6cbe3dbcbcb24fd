//! Cams and flywheels: names and units are checked, nothing of it can be solved yet.

use super::context::Context;
use super::element::known;
use super::error::NameError;
use super::lookup::suggestion;
use super::names::{QuantityKind, ThingKind};
use super::property::{Spec, Takes, read};
use crate::syntax::document::{Flywheel, Name, Statement};
use crate::units::Dimension;

const RIM: &[Spec] = &[
    Spec { name: "diameter", takes: Takes::Positive(Dimension::LENGTH), example: "diameter 0.5 m" },
    Spec {
        name: "weight_density",
        takes: Takes::Positive(Dimension::WEIGHT_DENSITY),
        example: "weight_density 7.0e4 N/m^3",
    },
    Spec { name: "density", takes: Takes::Positive(Dimension::DENSITY), example: "density 7200 kg/m^3" },
    Spec {
        name: "height_to_width",
        takes: Takes::Positive(Dimension::NUMBER),
        example: "height_to_width 1.5",
    },
];

const FLYWHEEL: &[Spec] = &[
    Spec { name: "fluctuation", takes: Takes::Positive(Dimension::NUMBER), example: "fluctuation 1/30" },
    Spec { name: "rim", takes: Takes::Block(RIM), example: "rim { diameter 0.5 m }" },
    Spec { name: "speed", takes: Takes::Any(Dimension::ANGULAR_VELOCITY), example: "speed 80 rpm" },
    Spec { name: "ratio", takes: Takes::Any(Dimension::NUMBER), example: "ratio 3" },
    Spec { name: "with_links", takes: Takes::Flag, example: "with_links" },
];

/// Checks all cams and flywheels.
pub(super) fn cams_and_flywheels(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Flywheel(f) = &statement.node {
            flywheel(cx, f);
            cx.unsupported("a flywheel", statement.span);
        }
    }
    profiles(cx);
}

fn flywheel(cx: &mut Context<'_>, flywheel: &Flywheel) {
    known(cx, &flywheel.on, "shaft or link", &[ThingKind::Shaft, ThingKind::Link]);
    if let Some(torque) = &flywheel.torque {
        load(cx, torque);
    }
    read(cx, "a flywheel", &flywheel.properties, FLYWHEEL);
}

/// Reports a name that is no load and no balance.
fn load(cx: &mut Context<'_>, name: &Name) {
    let is_load =
        |kind: &QuantityKind<'_>| matches!(kind, QuantityKind::Load(..) | QuantityKind::Balance(..));
    let declared = cx.names.quantities.get(&name.node);
    if declared.is_some_and(|d| is_load(&d.what)) || cx.names.bad.contains(&name.node) {
        return;
    }
    let loads = cx.names.quantities.iter().filter(|(_, d)| is_load(&d.what)).map(|(n, _)| n.as_str());
    let help = suggestion(&name.node, &loads.collect::<Vec<_>>(), "loads");
    let (name, span) = (name.node.clone(), name.span);
    cx.error(NameError::Unknown { kind: "load or balance", name, place: String::new(), span, help });
}

/// Cams that profiles of links refer to.
fn profiles(cx: &mut Context<'_>) {
    use crate::syntax::document::Member;
    let doc = cx.doc;
    for statement in &doc.statements {
        let body = match &statement.node {
            Statement::Ground(ground) => &ground.body,
            Statement::Link(link) => &link.body,
            _ => continue,
        };
        for member in body {
            if let Member::Profile(profile) = &member.node {
                known(cx, &profile.of, "cam", &[ThingKind::Cam]);
            }
        }
    }
}
