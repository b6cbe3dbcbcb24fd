//! Shafts, wheels, sliders and what runs between them: names and units are checked, nothing of it can be solved yet.

use super::context::Context;
use super::expr::Want;
use super::link::positive;
use super::names::{QuantityKind, ThingKind};
use super::pair_property::{phrase, specs as joint_specs};
use super::property::{Spec, Takes, read};
use crate::source::Span;
use crate::syntax::document::{
    Body, End, Expr, ExprKind, Joint, JointKind, Member, Statement, WheelMember, WheelSize,
};
use crate::units::Dimension;

/// How many parts of an expression are looked at before it counts as not plain.
const PARTS: usize = 200;

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

const WORM: &[Spec] =
    &[Spec { name: "starts", takes: Takes::Positive(Dimension::NUMBER), example: "starts 2" }, EFFICIENCY];

const SCREW: &[Spec] =
    &[Spec { name: "lead", takes: Takes::Any(Dimension::LENGTH), example: "lead 5 mm" }, EFFICIENCY];

/// The properties a transmission may have.
pub(super) const fn specs(kind: JointKind) -> &'static [Spec] {
    match kind {
        JointKind::Mesh => MESH,
        JointKind::Belt => BELT,
        JointKind::Worm => WORM,
        JointKind::Screw => SCREW,
        JointKind::Chain | JointKind::Rack | JointKind::Rope => &[EFFICIENCY],
        _ => &[],
    }
}

/// Checks the shafts, the sliders and all wheels.
pub(super) fn elements(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        match &statement.node {
            Statement::Shaft(shaft) => {
                if let Some(on) = &shaft.on {
                    known(cx, on, "shaft", &[ThingKind::Shaft, ThingKind::Link]);
                }
                wheels(cx, &shaft.body, false);
                if moves(cx) {
                    cx.unsupported("a shaft", statement.span);
                }
            }
            Statement::Slider(slider) => {
                wheels(cx, &slider.body, false);
                cx.unsupported("a slider on a rope", statement.span);
            }
            Statement::Ground(ground) => wheels(cx, &ground.body, true),
            Statement::Link(link) => wheels(cx, &link.body, true),
            _ => {}
        }
    }
}

fn wheels(cx: &mut Context<'_>, body: &Body, on_link: bool) {
    for member in body {
        if let Member::Wheel(w) = &member.node {
            wheel(cx, w);
            if on_link && moves(cx) {
                cx.unsupported("a wheel on a link", member.span);
            }
        }
    }
}

fn wheel(cx: &mut Context<'_>, wheel: &WheelMember) {
    let name = &wheel.name.node;
    let (size, dimension, what) = match &wheel.size {
        Some(WheelSize::Radius(x)) => (Some(x), Dimension::LENGTH, "radius"),
        Some(WheelSize::Diameter(x)) => (Some(x), Dimension::LENGTH, "diameter"),
        Some(WheelSize::Teeth(x)) => (Some(x), Dimension::NUMBER, "number of teeth"),
        None => (None, Dimension::NUMBER, ""),
    };
    if let Some(size) = size {
        plain(cx, size, dimension, &format!("the {what} of wheel `{name}`"));
    }
    if let Some(module) = &wheel.module {
        plain(cx, module, Dimension::LENGTH, &format!("the module of wheel `{name}`"));
    }
}

/// Checks a value that is known beforehand, and leaves any other alone.
fn plain(cx: &mut Context<'_>, expr: &Expr, dimension: Dimension, what: &str) {
    if is_plain(cx, expr, &mut { PARTS }) {
        positive(cx, expr, dimension, what);
    }
}

/// Whether an expression asks for nothing that hangs on other wheels or on results.
fn is_plain(cx: &Context<'_>, expr: &Expr, parts: &mut usize) -> bool {
    let Some(left) = parts.checked_sub(1) else { return false };
    *parts = left;
    let mut all = |these: &[&Expr]| these.iter().all(|e| is_plain(cx, e, parts));
    match &expr.kind {
        ExprKind::Number(_) => true,
        ExprKind::Name(name) => match cx.names.quantities.get(name).map(|d| d.what) {
            Some(QuantityKind::Given(value) | QuantityKind::Let(value)) => all(&[value]),
            Some(_) => false,
            None => true,
        },
        ExprKind::Unary(_, a) => all(&[a]),
        ExprKind::Vector(a, b) | ExprKind::Polar(a, b) | ExprKind::Power(a, b) => all(&[a, b]),
        ExprKind::Chain(a, rest) => all(&[a]) && rest.iter().all(|(_, e)| is_plain(cx, e, parts)),
        ExprKind::Member(..) | ExprKind::Call { .. } | ExprKind::Compare(..) => false,
    }
}

/// Checks a transmission and notes it.
pub(super) fn transmission(cx: &mut Context<'_>, joint: &Joint, span: Span) {
    let kind = joint.kind.node;
    let what = phrase(kind);
    read(cx, &what, &joint.properties, joint_specs(kind));
    for end in &joint.ends {
        transmission_end(cx, kind, end);
    }
    if moves(cx) || kind != JointKind::Mesh {
        cx.unsupported(what, span);
    }
}

/// Whether anything is driven. Of a mesh at rest the geometry alone is asked.
fn moves(cx: &Context<'_>) -> bool {
    cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Drive(_)))
}

fn transmission_end(cx: &mut Context<'_>, kind: JointKind, end: &End) {
    use ThingKind::{Link, Shaft, Slider, Wheel};
    let path = match end {
        End::At(path) => path,
        End::Over(_) => return,
        End::Under(slider) => return known(cx, slider, "slider", &[Slider]),
    };
    let Some(part) = &path.tail else {
        return match kind {
            JointKind::Mesh | JointKind::Belt | JointKind::Chain => known(cx, &path.head, "wheel", &[Wheel]),
            JointKind::Rope => known(cx, &path.head, "wheel or slider", &[Wheel, Slider]),
            _ => known(cx, &path.head, "wheel, shaft, slider or link", &[Wheel, Shaft, Slider, Link]),
        };
    };
    let Some(link) = cx.link(&path.head) else { return };
    match cx.kind_inside(link, &part.node) {
        Some(_) => {}
        None if kind == JointKind::Rack => {
            cx.line(link, part);
        }
        None => {
            cx.point(link, part);
        }
    }
}

/// Reports a name that is none of these kinds of things.
pub(super) fn known(
    cx: &mut Context<'_>,
    name: &crate::syntax::document::Name,
    kind: &'static str,
    kinds: &[ThingKind],
) {
    let ground = name.node == "ground" && kinds.contains(&ThingKind::Link);
    if !ground {
        cx.no_thing(name, kind, &format!("a {kind}"), |is| kinds.contains(&is));
    }
}

/// A value of a simulation or an element that is known beforehand.
pub(super) fn constant(cx: &mut Context<'_>, expr: &Expr, dimension: Dimension, what: &str) {
    cx.scalar_constant(expr, &Want(dimension), what);
}
