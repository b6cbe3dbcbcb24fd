//! Names and values that transmissions share.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use assur_syntax::document::Name;

/// Reports a name that is none of these kinds of things.
pub(crate) fn known(cx: &mut Context<'_>, name: &Name, kind: &'static str, kinds: &[ThingKind]) {
    cx.names.note_thing(name);
    let ground = name.node == "ground" && kinds.contains(&ThingKind::Link);
    if !ground {
        cx.no_thing(name, kind, &format!("a {kind}"), |is| kinds.contains(&is));
    }
}
