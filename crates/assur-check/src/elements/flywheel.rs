//! `flywheel J on O1 for Mb { … }`

use crate::expr::context::Context;
use crate::expr::property::{Read, find, given_twice, read};
use crate::names::declared::{QuantityKind, ThingKind};
use crate::names::suggestion::{not_declared, suggestion};
use crate::pairs::transmission::known;
use assur_model::model;
use assur_model::model::{FlywheelTorque, LinkId, Rim};
use assur_syntax::document::{Flywheel, Name, Statement};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::source::Span;

use assur_text::language::{FLYWHEEL, RIM};

/// Enters all flywheels into the mechanism.
pub(crate) fn flywheels(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Flywheel(f) = &statement.node
            && let Some(flywheel) = flywheel(cx, f)
        {
            cx.builder.mech.flywheels.push(flywheel);
        }
    }
}

fn flywheel(cx: &mut Context<'_>, flywheel: &Flywheel) -> Option<model::Flywheel> {
    let on = link(cx, &flywheel.on);
    let torque = match &flywheel.torque {
        Some(name) => torque(cx, name).map(Some),
        None => Some(None),
    };
    let properties = read(cx, "a flywheel", &flywheel.properties, FLYWHEEL)?;
    let (name, span) = (flywheel.name.node.clone(), flywheel.name.span);
    let Some(fluctuation) = find(&properties, "fluctuation").map(Read::number) else {
        let (message, label) =
            (format!("flywheel `{name}` is not fully described"), "its fluctuation is missing");
        let help = "add `fluctuation 1/30`: the greatest minus the least speed, divided by the mean speed";
        incomplete(cx, message, help, span, label);
        return None;
    };
    let speed = find(&properties, "speed");
    if let Some(speed) = speed
        && cx.builder.mech.drives.iter().any(|d| d.speed.is_some())
    {
        let message = format!("the speed of `{name}` follows from that of the drive");
        incomplete(cx, message, "leave `speed` out", speed.span, "the drive has a speed");
        return None;
    }
    let on_shaft = cx.names.things.get(&flywheel.on.node).is_some_and(|d| d.what == ThingKind::Shaft);
    if let Some(ratio) = find(&properties, "ratio").filter(|_| on_shaft) {
        let message = format!("the speed of `{name}` follows from that of its shaft");
        incomplete(cx, message, "leave `ratio` out", ratio.span, "the shaft is part of the file");
        return None;
    }
    let block = flywheel.properties.iter().find(|p| p.name.node == "rim");
    let rim = match block {
        Some(block) => {
            let described = read(cx, "`rim`", &block.properties, RIM)?;
            Some(rim(cx, &described, &name, block.span)?)
        }
        None => None,
    };
    Some(model::Flywheel {
        name,
        span,
        on: on?,
        torque: torque?,
        fluctuation,
        speed: speed.map(Read::number),
        ratio: find(&properties, "ratio").map_or(1.0, Read::number),
        with_links: find(&properties, "with_links").is_some(),
        rim,
    })
}

fn link(cx: &mut Context<'_>, on: &Name) -> Option<LinkId> {
    if cx.find_link(&on.node).is_none() {
        known(cx, on, "shaft or link", &[ThingKind::Shaft, ThingKind::Link]);
        if cx.names.things.get(&on.node).is_some_and(|d| d.what == ThingKind::Shaft) {
            cx.builder.unsupported("a flywheel on a shaft", on.span);
        }
        return None;
    }
    let link = cx.link(on)?;
    crate::motion::drive::on_moving(cx, link, on.span, "a flywheel")?;
    Some(link)
}

fn rim(cx: &mut Context<'_>, properties: &[Read], name: &str, span: Span) -> Option<Rim> {
    let value = |name: &str| find(properties, name);
    let (weight, density) = (value("weight_density"), value("density"));
    if let (Some(weight), Some(density)) = (weight, density) {
        let what = "the density of the rim".to_owned();
        cx.error(given_twice(&what, density.span, weight.span));
        return None;
    }
    let density = match (density, weight) {
        (Some(density), _) => Some(density.number()),
        (None, Some(weight)) => {
            let Some(gravity) = cx.builder.mech.gravity.map(|g| g.acceleration.norm()).filter(|g| *g > 0.0)
            else {
                let message = "a density by weight needs `gravity`, which the file does not declare".into();
                let help = "add `gravity 9.81 m/s^2`, or give `density 7200 kg/m^3`";
                incomplete(cx, message, help, weight.span, "a weight is a mass times gravity");
                return None;
            };
            Some(weight.number() / gravity)
        }
        (None, None) => None,
    };
    let missing = match (value("diameter"), density, value("height_to_width")) {
        (None, ..) => "diameter 0.5 m",
        (_, None, _) => "density 7200 kg/m^3",
        (.., None) => "height_to_width 1.5",
        (Some(diameter), Some(density), Some(proportion)) => {
            let (diameter, height_to_width) = (diameter.number(), proportion.number());
            return Some(Rim { diameter, density, height_to_width });
        }
    };
    let message = format!("the rim of flywheel `{name}` is not fully described");
    incomplete(cx, message, &format!("add `{missing}`, with its own value"), span, "its size is not known");
    None
}

fn incomplete(cx: &mut Context<'_>, message: String, help: &str, span: Span, label: &str) {
    let needless = help.strip_prefix("leave ").and_then(|help| help.strip_suffix(" out"));
    cx.error(
        Diagnosis::error("mech::geometry::incomplete", message)
            .label(span, label)
            .help(help)
            .fixes(needless.map(|what| Fix::left_out(what, span))),
    );
}

/// The load or balance of that name.
fn torque(cx: &mut Context<'_>, name: &Name) -> Option<FlywheelTorque> {
    let torque = |kind: &QuantityKind<'_>| match kind {
        QuantityKind::Load(id, _) | QuantityKind::Brake(id) => Some(FlywheelTorque::Load(*id)),
        QuantityKind::Balance(id, _) => Some(FlywheelTorque::Balance(*id)),
        _ => None,
    };
    cx.names.note_quantity(name);
    let declared = cx.names.quantities.get(&name.node);
    if let Some(found) = declared.and_then(|d| torque(&d.what)) {
        return Some(found);
    }
    if cx.names.bad.contains(&name.node) {
        return None;
    }
    let loads = cx.names.quantities.iter().filter(|(_, d)| torque(&d.what).is_some());
    let help =
        suggestion(&name.node, name.span, &loads.map(|(n, _)| n.as_str()).collect::<Vec<_>>(), "loads");
    let (name, span) = (name.node.clone(), name.span);
    cx.error(not_declared("load or balance", &name, None, span, help));
    None
}
