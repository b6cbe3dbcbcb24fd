//! Meshes, belts, chains, racks, worms and screws: each a law between rates.

use crate::expr::{
    context::Context,
    property::{Read, Value, find, read},
};
use crate::links::lookup::is_linkage_pair;
use crate::pairs::property::{phrase, shared};
use crate::statements::written::end_text;
use crate::trains::{
    bevel,
    carrier::carrier,
    ends::{AGREES, Runs, clutch, incomplete, two, wheel},
    friction_torque::{friction_torque, varying},
    grip::{belt_grip, slip},
    losses::{losses, only_wheels},
    planet::{Arms, arm, distance, is_planet},
    rack::rack,
    rope::{rope, two_sides},
    size::label,
    thread::{screw, worm},
};
use crate::values::format_value::digits;
use assur_model::model::{
    Bevel, FrictionLimit, Law, LinkId, Meeting, Pair, PairId, PairKind, Rate, Transmission, TransmissionKind,
    Wheel,
};
use assur_syntax::document::{Joint, JointKind, Property, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::properties_of_pair;
use std::f64::consts::FRAC_PI_2;

/// Enters all transmissions into the mechanism.
pub(crate) fn transmissions(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let shared = shared(cx);
    let mut arms = Arms::new();
    for statement in &doc.statements {
        let Statement::Joint(joint) = &statement.node else { continue };
        if is_linkage_pair(joint.kind.node) || !cx.is_own(&joint.name) {
            continue;
        }
        let properties = own_properties(cx, joint).map(|mut own| {
            for more in shared.iter().filter(|s| s.0 == joint.kind.node).flat_map(|s| &s.1) {
                if find(&own, more.name).is_none() {
                    own.push(more.clone());
                }
            }
            own
        });
        let read = properties.and_then(|properties| transmission(cx, joint, &properties, &mut arms));
        if read.is_none() {
            // What is asked of it is no second mistake.
            cx.names.bad.insert(joint.name.node.clone());
        }
        if let Some(transmission) = read {
            let id = PairId::at(cx.builder.mech.pairs.len());
            let (name, span) = (joint.name.node.clone(), joint.name.span);
            cx.names.pairs.entry(name.clone()).or_insert(id);
            let kind = PairKind::Transmission(transmission);
            cx.builder.mech.pairs.push(Pair { name, span, kind, friction: None, bearing: None });
        }
    }
    bevel::planets(cx);
}

/// The properties in its braces. A capacity of the instant, of a clutch that slips, is read with the loads: here it is not a number.
fn own_properties(cx: &mut Context<'_>, joint: &Joint) -> Option<Vec<Read>> {
    let (what, specs) = (phrase(joint.kind.node), properties_of_pair(joint.kind.node));
    // a word that is none may be one of these
    let may_slip = |p: &Property| {
        let name = p.name.node.as_str();
        matches!(name, "slipping" | "freewheel") || specs.iter().all(|spec| spec.name != name)
    };
    let slips = joint.kind.node == JointKind::Clutch && joint.properties.iter().any(may_slip);
    let Some(varies) = varying(cx, joint).filter(|_| slips) else {
        return read(cx, &what, &joint.properties, specs);
    };
    let others: Vec<_> = joint.properties.iter().filter(|p| !std::ptr::eq(*p, varies)).cloned().collect();
    let mut own = read(cx, &what, &others, specs)?;
    own.push(Read { name: "capacity", value: Value::Number(f64::NAN), span: varies.span });
    Some(own)
}

fn transmission(
    cx: &mut Context<'_>,
    joint: &Joint,
    properties: &[Read],
    arms: &mut Arms,
) -> Option<Transmission> {
    let kind = kind(joint.kind.node)?;
    let efficiency = losses(cx, joint, kind, properties)?;
    let grip = match kind {
        TransmissionKind::Belt => belt_grip(cx, joint, properties)?,
        TransmissionKind::Clutch => {
            Some(FrictionLimit::Clutch(friction_torque(cx, &joint.name, properties)?))
        }
        _ => None,
    };
    let pressure_angle = pressure_angle(cx, properties)?;
    let mut runs = match kind {
        TransmissionKind::Rope => rope(cx, joint).map(|(laws, links)| Runs { laws, links, meeting: None }),
        TransmissionKind::Mesh | TransmissionKind::Belt | TransmissionKind::Chain => {
            let tangent = pressure_angle.map(libm::tan);
            wheels(cx, joint, kind, properties, (arms, tangent))
        }
        TransmissionKind::Rack => rack(cx, joint, find(properties, "efficiency").map(|e| e.span)),
        TransmissionKind::Worm => worm(cx, joint, properties),
        TransmissionKind::Screw => screw(cx, joint, properties),
        TransmissionKind::Clutch => {
            let has = |name| find(properties, name).is_some();
            clutch(cx, joint, (has("slipping") || has("freewheel"), has("freewheel")))
        }
    }?;
    if efficiency.is_some() {
        if kind == TransmissionKind::Rope {
            two_sides(cx, joint, &runs.laws)?;
        }
        runs.laws.iter_mut().for_each(|l| l.efficiency = efficiency);
    }
    let mut ends: Vec<String> = joint.ends.iter().map(end_text).collect();
    let Runs { laws, links, meeting } = runs;
    let bevel = bevel::side(properties);
    // a bevel planet comes second
    if bevel.is_some() && links.first() != ends.first().and_then(|end| cx.wheel(end)).map(|w| w.link).as_ref()
    {
        ends.reverse();
    }
    Some(Transmission {
        kind,
        ends,
        links,
        laws,
        meeting,
        bevel,
        pressure_angle,
        grip,
        slip: slip(properties),
        freewheel: find(properties, "freewheel")
            .map_or(0.0, |p| if p.value == Value::Word("cw") { -1.0 } else { 1.0 }),
    })
}

fn kind(kind: JointKind) -> Option<TransmissionKind> {
    Some(match kind {
        JointKind::Mesh => TransmissionKind::Mesh,
        JointKind::Rope => TransmissionKind::Rope,
        JointKind::Belt => TransmissionKind::Belt,
        JointKind::Chain => TransmissionKind::Chain,
        JointKind::Rack => TransmissionKind::Rack,
        JointKind::Worm => TransmissionKind::Worm,
        JointKind::Screw => TransmissionKind::Screw,
        JointKind::Clutch => TransmissionKind::Clutch,
        _ => return None,
    })
}

fn pressure_angle(cx: &mut Context<'_>, properties: &[Read]) -> Option<Option<f64>> {
    let Some(property) = find(properties, "pressure_angle") else { return Some(None) };
    if property.number() < FRAC_PI_2 {
        return Some(Some(property.number()));
    }
    incomplete(
        cx,
        "a pressure angle must be less than 90 deg",
        "write for example `pressure_angle 20 deg`",
        property.span,
    )
}

/// Two wheels: meshing, or joined by a belt or chain.
fn wheels(
    cx: &mut Context<'_>,
    joint: &Joint,
    kind: TransmissionKind,
    properties: &[Read],
    (arms, tangent): (&mut Arms, Option<f64>),
) -> Option<Runs> {
    let paths = two(cx, joint)?;
    only_wheels(cx, joint, paths)?;
    let (a, b) = (wheel(cx, paths[0]), wheel(cx, paths[1]));
    let (a, b) = (a?, b?);
    if a.link == b.link {
        let link = cx.builder.mech.link(a.link).name.clone();
        cx.error(
            Diagnosis::error(
                "mech::train::same_shaft",
                format!(
                    "`{}` joins `{}` and `{}`, which are both on `{link}`",
                    joint.name.node, a.name, b.name
                ),
            )
            .label(paths[0].span(), format!("on `{link}`"))
            .primary(paths[1].span(), format!("on `{link}` too"))
            .help(format!("put one of them on another shaft: {} joins wheels of two shafts", kind.phrase())),
        );
        return None;
    }
    let is = |name| find(properties, name).is_some();
    let meshes = kind == TransmissionKind::Mesh;
    let internal = meshes && is("internal");
    let (c_1, c_2) = coefficients(cx, &a, &b, kind, joint)?;
    if internal && c_1 == c_2 {
        let size = match a.teeth {
            Some(teeth) => format!("{} teeth", digits(teeth)),
            None => crate::values::format_value::format_value(a.radius, assur_text::units::Dimension::LENGTH),
        };
        let (first, second) = (a.name, b.name);
        cx.error(
            Diagnosis::error(
                "mech::train::internal",
                format!(
                    "`{first}` and `{second}` have the same size ({size}): neither fits into \
                     the other"
                ),
            )
            .primary(joint.name.span, "internal")
            .help(
                "make one wheel larger, it is the ring; or leave out `internal` if both \
                 have outer teeth",
            ),
        );
        return None;
    }
    let turned = if meshes { !internal } else { is("crossed") };
    let c_2 = if turned { c_2 } else { -c_2 };
    let carrier = carrier(cx, &a, &b, joint.name.span)?;
    let bevel = bevel::side(properties);
    if bevel.is_some() {
        bevel::fits(cx, properties)?;
    }
    let c_2 = if bevel == Some(Bevel::Far) { -c_2 } else { c_2 };
    let mut meeting = None;
    if meshes {
        crate::trains::carrier::turns_at_all(cx, &a, &b, joint.name.span)?;
        crate::trains::carrier::turns_at_all(cx, &b, &a, joint.name.span)?;
        if !is("shift") && bevel.is_none() {
            distance(cx, [&a, &b], carrier, internal, joint.name.span)?;
        }
        for (planet, other) in [(&a, &b), (&b, &a)] {
            if bevel.is_none() && is_planet(cx, planet, carrier) && !is_planet(cx, other, carrier) {
                arm(cx, arms, planet, other, internal, joint);
            }
        }
        if let (Some(p), Some(q), Some(tangent)) = (a.centre, b.centre, tangent) {
            let (links, centres) = ([a.link, b.link], [p, q]);
            meeting = Some(Meeting { links, centres, radii: [a.radius, b.radius], internal, tangent });
        }
    }
    let force = c_1 / a.radius;
    // the first wheel drives: the second gets the speed that is left
    let c_1 = c_1 * (1.0 - slip(properties));
    let constant = find(properties, "phase").map_or(0.0, |phase| c_2 * phase.number());
    let terms = match bevel {
        Some(_) => bevel::terms(cx, [(&a, c_1), (&b, c_2)], carrier, joint.name.span)?,
        None => about(a.link, c_1, b.link, c_2, carrier),
    };
    let law = Law { terms, constant, force, efficiency: None };
    let links = law.terms.iter().take(2).filter_map(|term| term.0.turning()).collect();
    Some(Runs { laws: vec![law], links, meeting })
}

/// Two sides, and the carrier that they are counted from.
fn about(a: LinkId, c_1: f64, b: LinkId, c_2: f64, carrier: LinkId) -> Vec<(Rate, f64)> {
    let mut terms = vec![(Rate::Turn(a), c_1), (Rate::Turn(b), c_2)];
    if carrier != LinkId::GROUND {
        terms.push((Rate::Turn(carrier), -(c_1 + c_2)));
    }
    terms
}

/// Teeth where both have them, else radii. Reports sizes that do not agree.
fn coefficients(
    cx: &mut Context<'_>,
    a: &Wheel,
    b: &Wheel,
    kind: TransmissionKind,
    joint: &Joint,
) -> Option<(f64, f64)> {
    let (Some(z_1), Some(z_2)) = (a.teeth, b.teeth) else { return Some((a.radius, b.radius)) };
    let modules = [2.0 * a.radius / z_1, 2.0 * b.radius / z_2];
    if (modules[0] - modules[1]).abs() <= AGREES * modules[0] {
        return Some((z_1, z_2));
    }
    if kind == TransmissionKind::Belt {
        return Some((a.radius, b.radius));
    }
    let length = |x| crate::values::format_value::format_value(x, assur_text::units::Dimension::LENGTH);
    cx.error(
        Diagnosis::error(
            "mech::train::sizes",
            format!(
                "`{}` has a module of {} and `{}` one of {}: their teeth do not fit",
                a.name,
                length(modules[0]),
                b.name,
                length(modules[1])
            ),
        )
        .labels(vec![
            label(format!("joins {} and {}", a.name, b.name), joint.name.span),
            label(format!("module {}", length(modules[0])), a.span),
            label(format!("module {}", length(modules[1])), b.span),
        ])
        .help("give both the same module, diameter divided by number of teeth"),
    );
    None
}
