//! Springs.

use crate::error::PairError;
use crate::expr::context::Context;
use crate::expr::property::{find, read};
use crate::pairs::pair::link_point;
use assur_model::model;
use assur_syntax::document::{Spring, Statement};
use assur_text::language::SPRING;
use assur_text::units::Dimension;

/// Enters all springs into the mechanism.
pub(crate) fn springs(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Spring(s) = &statement.node
            && cx.is_own(&s.name)
            && let Some(spring) = spring(cx, s)
        {
            cx.builder.mech.springs.push(spring);
        }
    }
}

fn spring(cx: &mut Context<'_>, spring: &Spring) -> Option<model::Spring> {
    let properties = read(cx, "a spring", &spring.properties, SPRING);
    let from = link_point(cx, &spring.from, "a spring");
    let to = link_point(cx, &spring.to, "a spring");
    let (properties, from, to) = (properties?, from?, to?);
    if from.0 == to.0 {
        cx.error(PairError::JoinedWithItself {
            help: "name another link at one of the two ends: a link is rigid".into(),
            what: "spring".into(),
            name: spring.name.node.clone(),
            link: spring.from.head.node.clone(),
            first: spring.from.span(),
            second: spring.to.span(),
        });
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
    if let Some(missing) = missing {
        let inside = if spring.properties.is_empty() { " in braces" } else { "" };
        cx.error(PairError::Incomplete {
            message: format!("spring `{}` is not fully described", spring.name.node),
            help: format!("add `{missing}`{inside}, with its own value; a damper alone needs only `damping`"),
            span: spring.name.span,
            label: "its force is not known".into(),
        });
        return None;
    }
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
