//! Springs.

use crate::expr::context::Context;
use crate::expr::property::{find, read};
use crate::loads::load::form;
use crate::motion::drive::{Moves, coordinate};
use crate::pairs::pair::{joined_with_itself, link_point};
use assur_model::model;
use assur_model::model::{BinaryOp, Expr, LoadId, LoadKind, Query};
use assur_syntax::document::{Name, Path, Spring, SpringSite, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::{SPRING, TORSION_SPRING};
use assur_text::units::Dimension;

/// Enters all springs into the mechanism.
pub(crate) fn springs(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let Statement::Spring(s) = &statement.node else { continue };
        if !cx.is_own(&s.name) {
            continue;
        }
        match &s.site {
            SpringSite::Points(from, to) => {
                let spring = spring(cx, s, [from, to]);
                cx.builder.mech.springs.extend(spring);
            }
            SpringSite::Pair(pair) => {
                let load = in_pair(cx, s, pair);
                cx.builder.mech.loads.extend(load);
            }
        }
    }
}

fn spring(cx: &mut Context<'_>, spring: &Spring, ends: [&Path; 2]) -> Option<model::Spring> {
    let properties = read(cx, "a spring", &spring.properties, SPRING);
    let [from, to] = ends.map(|end| link_point(cx, end, "the end of a spring"));
    let (properties, from, to) = (properties?, from?, to?);
    if from.0 == to.0 {
        cx.error(joined_with_itself(
            "name another link at one of the two ends: a link is rigid",
            "spring",
            &spring.name.node,
            &ends[0].head.node,
            ends[0].span(),
            ends[1].span(),
        ));
        return None;
    }
    let number = |name| find(&properties, name).map(crate::expr::property::Read::number);
    let mut stiffness = || {
        let own = cx.only_given(Dimension::STIFFNESS);
        format!("stiffness {}", own.unwrap_or_else(|| "4530 N/m".into()))
    };
    let missing = match (number("stiffness"), number("free_length"), number("damping")) {
        (None, None, None) => Some(format!("{}; free_length 80 mm", stiffness())),
        (Some(_), None, _) => Some("free_length 80 mm".to_owned()),
        (None, Some(_), _) => Some(stiffness()),
        _ => None,
    };
    complete(cx, spring, missing)?;
    Some(model::Spring {
        name: spring.name.node.clone(),
        span: spring.name.span,
        from,
        to,
        stiffness: number("stiffness").unwrap_or(0.0),
        free_length: number("free_length").unwrap_or(0.0),
        damping: number("damping").unwrap_or(0.0),
    })
}

/// The torque in a revolute pair, positive along its coordinate: −k (φ − φ₀) − c φ̇.
fn in_pair(cx: &mut Context<'_>, spring: &Spring, pair: &Name) -> Option<model::Load> {
    let (pair_id, moves) = coordinate(cx, pair)?;
    if moves != Moves::Turning {
        let message = format!("`{}` slides; a spring in a pair turns", pair.node);
        let help = format!(
            "join two points: `spring {}: ground.A - ram.B {{ stiffness 4530 N/m; free_length 80 mm }}`",
            spring.name.node
        );
        form(cx, message, &help, pair.span);
        return None;
    }
    let properties = read(cx, "a spring in a pair", &spring.properties, TORSION_SPRING)?;
    let number = |name| find(&properties, name).map(crate::expr::property::Read::number);
    let (stiffness, free, damping) = (number("stiffness"), number("free_angle"), number("damping"));
    let missing = match (stiffness, free, damping) {
        (None, None, None) => Some("stiffness 20 N*m/rad; free_angle 30 deg".to_owned()),
        (Some(_), None, _) => Some("free_angle 30 deg".to_owned()),
        (None, Some(_), _) => Some("stiffness 20 N*m/rad".to_owned()),
        _ => None,
    };
    complete(cx, spring, missing)?;
    let scaled =
        |factor: f64, expr| Expr::Binary(BinaryOp::Mul, Box::new(Expr::number(factor)), Box::new(expr));
    let elastic = stiffness.zip(free).map(|(k, free)| {
        let angle = Box::new(Expr::Query(Query::Displacement(pair_id)));
        scaled(k, Expr::Binary(BinaryOp::Sub, Box::new(Expr::number(free)), angle))
    });
    let (stiffness, free_angle) = (stiffness.unwrap_or(0.0), free.unwrap_or(0.0));
    let load = LoadId::at(cx.builder.mech.loads.len());
    cx.builder.mech.torsion_springs.push(model::TorsionSpring { load, stiffness, free_angle });
    let viscous = damping.filter(|c| *c > 0.0);
    let viscous = viscous.map(|c| scaled(-c, Expr::Query(Query::RelativeVelocity(pair_id))));
    let value = match (elastic, viscous) {
        (Some(a), Some(b)) => Expr::Binary(BinaryOp::Add, Box::new(a), Box::new(b)),
        (a, b) => a.or(b).unwrap_or_else(|| Expr::number(0.0)),
    };
    let kind = LoadKind::InPair { pair: pair_id, value, against_motion: false };
    Some(model::Load {
        name: Some(spring.name.node.clone()),
        span: spring.name.span,
        kind,
        pin: None,
        spread: None,
        when: None,
    })
}

/// Reports a spring of which a property is missing.
fn complete(cx: &mut Context<'_>, spring: &Spring, missing: Option<String>) -> Option<()> {
    let Some(missing) = missing else { return Some(()) };
    let inside = if spring.properties.is_empty() { " in braces" } else { "" };
    cx.error(
        Diagnosis::error(
            "mech::geometry::incomplete",
            format!("spring `{}` is not fully described", spring.name.node),
        )
        .label(spring.name.span, "its force is not known")
        .help(format!("add `{missing}`{inside}, with its own value; a damper alone needs only `damping`")),
    );
    None
}
