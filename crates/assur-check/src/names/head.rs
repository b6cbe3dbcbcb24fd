//! What stands at the head of the file, and what it leaves out.

use crate::names::scope::Scope;
use crate::names::suggestion::{not_declared, suggestion};
use assur_syntax::document::{Name, Statement};

/// Enters the title, the problem's text and `ignore` into the mechanism.
pub(crate) fn head(cx: &mut Scope<'_, '_>) {
    let doc = cx.doc;
    cx.builder.mech.title = doc.title().map_or_else(String::new, |t| t.node.clone());
    cx.builder.mech.notes = doc.notes.iter().map(|n| n.node.clone()).collect();
    for statement in &doc.statements {
        if let Statement::Ignore(name) = &statement.node {
            ignore(cx, name);
        }
    }
}

fn ignore(cx: &mut Scope<'_, '_>, name: &Name) {
    if name.node == "inertia" {
        cx.builder.mech.ignore_inertia = true;
        return;
    }
    let help = suggestion(&name.node, name.span, &["inertia"], "effects that can be ignored");
    let (name, span) = (name.node.clone(), name.span);
    cx.error(not_declared("effect", &name, None, span, help));
}
