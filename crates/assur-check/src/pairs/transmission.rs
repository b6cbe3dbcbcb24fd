//! The properties of transmissions.

use crate::expr::context::Context;
use crate::expr::property::{Spec, Takes};
use crate::expr::want::Want;
use crate::names::declared::ThingKind;
use assur_syntax::document::{Expr, JointKind, Name};
use assur_text::units::Dimension;

const EFFICIENCY: Spec =
    Spec { name: "efficiency", takes: Takes::Positive(Dimension::NUMBER), example: "efficiency 0.98" };

const MESH: &[Spec] = &[
    Spec { name: "internal", takes: Takes::Flag, example: "internal" },
    EFFICIENCY,
    Spec {
        name: "pressure_angle",
        takes: Takes::Positive(Dimension::ANGLE),
        example: "pressure_angle 20 deg",
    },
    Spec { name: "addendum", takes: Takes::Positive(Dimension::NUMBER), example: "addendum 1" },
    Spec { name: "clearance", takes: Takes::NotNegative(Dimension::NUMBER), example: "clearance 0.25" },
    Spec { name: "shift", takes: Takes::Two(Dimension::NUMBER), example: "shift 0.3, -0.3" },
];

const BELT: &[Spec] = &[Spec { name: "crossed", takes: Takes::Flag, example: "crossed" }, EFFICIENCY];

const RACK: &[Spec] = &[
    EFFICIENCY,
    Spec {
        name: "pressure_angle",
        takes: Takes::Positive(Dimension::ANGLE),
        example: "pressure_angle 20 deg",
    },
];

const WORM: &[Spec] =
    &[Spec { name: "starts", takes: Takes::Positive(Dimension::NUMBER), example: "starts 2" }, EFFICIENCY];

const SCREW: &[Spec] =
    &[Spec { name: "lead", takes: Takes::Any(Dimension::LENGTH), example: "lead 5 mm" }, EFFICIENCY];

/// The properties a transmission may have.
pub(crate) const fn specs(kind: JointKind) -> &'static [Spec] {
    match kind {
        JointKind::Mesh => MESH,
        JointKind::Belt => BELT,
        JointKind::Worm => WORM,
        JointKind::Screw => SCREW,
        JointKind::Rack => RACK,
        JointKind::Chain | JointKind::Rope => &[EFFICIENCY],
        _ => &[],
    }
}

/// Reports a name that is none of these kinds of things.
pub(crate) fn known(cx: &mut Context<'_>, name: &Name, kind: &'static str, kinds: &[ThingKind]) {
    let ground = name.node == "ground" && kinds.contains(&ThingKind::Link);
    if !ground {
        cx.no_thing(name, kind, &format!("a {kind}"), |is| kinds.contains(&is));
    }
}

/// A value of a simulation or an element that is known beforehand.
pub(crate) fn constant(cx: &mut Context<'_>, expr: &Expr, dimension: Dimension, what: &str) {
    cx.scalar_constant(expr, &Want(dimension), what);
}
