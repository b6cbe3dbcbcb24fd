//! Values out of all proportion, and units that are converted twice.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::names::declared::QuantityKind;
use crate::statements::walk::{expressions, parts};
use crate::statements::written::written;
use crate::values::definition::Settled;
use crate::values::format_value::digits;
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Pair, PairKind};
use assur_syntax::document::{BinaryOp, Expr, ExprKind, Property, Statement};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::units::Dimension;

/// Notes `pi*n/30` and `phi*pi/180` of what has its unit already.
pub(super) fn converted_twice(cx: &mut Context<'_>) {
    let mut found = Vec::new();
    for statement in &cx.doc.statements {
        expressions(&statement.node, &mut |expr| {
            parts(expr, &mut |part| found.extend(conversion(cx, part).map(|name| (part, name))));
        });
    }
    for (expr, name) in found {
        let Some(whole) = written(expr) else { continue };
        let message = format!("`{name}` has its unit already: `{whole}` converts it again");
        cx.error(
            Diagnosis::advice("mech::unit::converted_twice", message)
                .label(expr.span, "a conversion of units")
                .help(Help::write(expr.span, &[name])),
        );
    }
}

/// The name that a product converts from rpm or degrees though its dimension is right.
fn conversion(cx: &Context<'_>, expr: &Expr) -> Option<String> {
    let ExprKind::Chain(first, rest) = &expr.kind else { return None };
    let times = |op: &BinaryOp| *op == BinaryOp::Multiply;
    let mut factors = vec![(true, &**first)];
    for (op, operand) in rest {
        if !matches!(op.node, BinaryOp::Multiply | BinaryOp::Divide) {
            return None;
        }
        factors.push((times(&op.node), operand));
    }
    let (mut number, mut name, mut pi) = (1.0, None, 0);
    for (above, factor) in factors {
        match &factor.kind {
            ExprKind::Number(n) if n.unit.is_none() => {
                number = if above { number * n.value } else { number / n.value };
            }
            ExprKind::Name(n) if n == "pi" && !cx.names.quantities.contains_key("pi") => {
                pi += if above { 1 } else { -1 }
            }
            ExprKind::Name(n) if above && name.is_none() => name = Some(n.clone()),
            _ => return None,
        }
    }
    let dimension = dimension_of(cx, name.as_ref()?)?;
    let near = |value: f64| (number / value - 1.0).abs() < 1e-9;
    let of_speed = dimension == Dimension::ANGULAR_VELOCITY
        && ((pi == 1 && near(1.0 / 30.0)) || (pi == -1 && near(30.0)));
    let of_angle =
        dimension == Dimension::ANGLE && ((pi == 1 && near(1.0 / 180.0)) || (pi == -1 && near(180.0)));
    name.filter(|_| of_speed || of_angle)
}

/// The dimension of a constant of the file.
fn dimension_of(cx: &Context<'_>, name: &str) -> Option<Dimension> {
    let is_constant =
        matches!(cx.names.quantities.get(name)?.what, QuantityKind::Given(_) | QuantityKind::Let(_));
    match cx.values.definitions.settled(name)? {
        Settled::Constant(t) if is_constant => Some(t.ty.dimension()),
        _ => None,
    }
}

/// A bound of a property beyond which its value is noted.
struct Bound {
    property: &'static str,
    is_odd: fn(f64) -> bool,
    what: &'static str,
    /// What percent of the number may be meant.
    percent: bool,
}

const BOUNDS: &[Bound] = &[
    Bound {
        property: "fluctuation",
        is_odd: |x| x > 2.0,
        what: "with a fluctuation above 2 the shaft would turn back",
        percent: true,
    },
    Bound {
        property: "friction",
        is_odd: |x| x > 1.0,
        what: "a coefficient of friction is seldom above 1",
        percent: true,
    },
    Bound {
        property: "static_friction",
        is_odd: |x| x > 1.0,
        what: "a coefficient of friction is seldom above 1",
        percent: true,
    },
    Bound {
        property: "equivalent_friction",
        is_odd: |x| x > 1.0,
        what: "a coefficient of friction is seldom above 1",
        percent: true,
    },
    Bound {
        property: "efficiency",
        is_odd: |x| x < 0.01,
        what: "an efficiency below 1 % passes on nearly nothing",
        percent: false,
    },
];

/// Notes properties out of all proportion.
pub(super) fn properties(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let all: &[Property] = match &statement.node {
            Statement::Joint(joint) => &joint.properties,
            Statement::All(all) => &all.properties,
            Statement::Flywheel(flywheel) => &flywheel.properties,
            Statement::Brake(brake) => &brake.properties,
            _ => &[],
        };
        for property in all {
            property_out_of_bounds(cx, property);
        }
    }
}

fn property_out_of_bounds(cx: &mut Context<'_>, property: &Property) -> Option<()> {
    let bound = BOUNDS.iter().find(|bound| bound.property == property.name.node)?;
    let [value] = property.values.as_slice() else { return None };
    let number = cx.quietly(|cx| cx.scalar_constant(value, &Want::NUMBER, ""))?;
    if !(bound.is_odd)(number) {
        return None;
    }
    let text =
        written(value).filter(|text| bound.percent && !text.contains('%') && (3.0..=100.0).contains(&number));
    let help = match text {
        Some(text) => format!("write `{} {text} %` if percent is meant", bound.property),
        None if !bound.percent => {
            "write the part that is passed on, as in `efficiency 0.98` or `efficiency 98 %`".into()
        }
        None => "check the value".into(),
    };
    let message = format!("{}; here it is {}", bound.what, digits(number));
    cx.error(
        Diagnosis::advice("mech::geometry::unusual_value", message)
            .label(property.span, "this value")
            .help(help),
    );
    Some(())
}

/// Notes a radius of gyration beyond ten times the size of its link.
pub(super) fn gyration(cx: &mut Context<'_>) {
    /// How many times the size of a link its radius of gyration may be.
    const MOST: f64 = 10.0;
    // a link that turns about the ground may carry a flywheel
    let of_ground = |pair: &&Pair| {
        matches!(pair.kind, PairKind::Revolute(_)) && pair.kind.links().contains(&LinkId::GROUND)
    };
    let grounded = cx.builder.mech.pairs.iter().filter(of_ground).flat_map(|pair| pair.kind.links());
    let grounded = grounded.collect::<Vec<_>>();
    let links = cx.builder.mech.links.iter().enumerate().skip(1);
    let links = links.filter(|(i, _)| !grounded.contains(&LinkId::at(*i)));
    let odd = links.filter_map(|(i, link)| {
        let mass = link.mass.as_ref()?;
        let radius = libm::sqrt(mass.inertia / mass.mass);
        let points = link.points.iter().map(|p| p.at).chain([mass.centre]).collect::<Vec<Vec2>>();
        let apart = |a: &Vec2| points.iter().map(|b| (*a - *b).norm()).fold(0.0, f64::max);
        let wheels = cx.builder.mech.wheels.iter().filter(|w| w.link == LinkId::at(i)).map(|w| w.radius);
        let round = link.circles.iter().map(|c| c.radius).chain(wheels).fold(0.0, f64::max);
        let size = points.iter().map(apart).fold(round, f64::max);
        (size > 0.0 && radius.is_finite() && radius > MOST * size)
            .then(|| (link.name.clone(), link.span, radius, size))
    });
    for (name, span, radius, size) in odd.collect::<Vec<_>>() {
        let times = digits((radius / size).round());
        let message = format!("the radius of gyration of `{name}` is {times} times its size");
        cx.error(
            Diagnosis::advice("mech::geometry::unusual_value", message)
                .label(
                    span,
                    format!(
                        "√(inertia/mass) = {} m, its points are at most {} m apart",
                        digits(radius),
                        digits(size)
                    ),
                )
                .help("check the units of its mass and inertia: kg*m^2, not kg*cm^2"),
        );
    }
}
