//! What may be meant by a transmission that cannot be as it is written.

use crate::expr::context::Context;
use crate::names::suggestion::wrong_kind;
use crate::statements::lines::{end_text, line_of};
use assur_syntax::document::{End, Expr, ExprKind, Joint, Path};

/// The line with `%` after an efficiency that is written as a number up to 100.
pub(crate) fn percent(cx: &Context<'_>, joint: &Joint, value: f64) -> Option<String> {
    let property = joint.properties.iter().find(|p| p.name.node == "efficiency")?;
    let bare = |e: &Expr| matches!(&e.kind, ExprKind::Number(n) if n.unit.is_none());
    let written = property.values.first()?;
    let line = match &written.kind {
        ExprKind::Name(name) if bare(cx.given_as_written(name)?) => format!("given {name} = {value} %"),
        _ if bare(written) => format!("efficiency {value} %"),
        _ => return None,
    };
    (value <= 100.0).then(|| format!("write `{line}`"))
}

/// Reports a shaft or a link in place of the one wheel on it.
pub(crate) fn only_wheels(cx: &mut Context<'_>, joint: &Joint, paths: [&Path; 2]) -> Option<()> {
    let only = |path: &Path| {
        let link = cx.find_link(&path.head.node)?;
        let mut on = cx.builder.mech.wheels.iter().filter(|w| w.link == link);
        let first = on.next()?;
        on.next().is_none().then(|| first.name.clone())
    };
    let is_wheel = |p: &&Path| p.tail.is_some() || cx.wheel(&p.head.node).is_some();
    let Some(odd) = paths.into_iter().find(|p| !is_wheel(p)) else { return Some(()) };
    if !paths.iter().all(|p| is_wheel(p) || only(p).is_some()) {
        return Some(());
    }
    let line = line_of(joint, |end| match end {
        End::At(path) if !is_wheel(&path) => only(path).unwrap_or_default(),
        end => end_text(end),
    });
    let declared = cx.names.things.get(&odd.head.node);
    let error = wrong_kind(
        &odd.head.node,
        &declared.map_or_else(|| "a link".into(), |d| d.what.phrase()),
        "a wheel",
        odd.span(),
        declared.map(|d| d.span),
        Some(format!("name the wheels: `{line}`")),
    );
    cx.error(error);
    None
}
