//! Names and values that transmissions share.

use crate::expr::context::Context;
use crate::expr::want::Want;
use crate::names::declared::ThingKind;
use assur_syntax::document::{Expr, Name};
use assur_text::units::Dimension;

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
