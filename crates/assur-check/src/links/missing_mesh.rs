//! The mesh that may be meant by a pair that is not declared.

use crate::expr::context::Context;
use assur_syntax::document::{End, Statement};

/// The mesh that is missing: of the only wheel that no transmission names, with the only planet.
pub(crate) fn missing_mesh(cx: &Context<'_>, name: &str) -> Option<String> {
    let named = |wheel: &str| {
        cx.doc.statements.iter().any(|s| match &s.node {
            Statement::Joint(joint) => {
                joint.ends.iter().any(|e| matches!(e, End::At(path) if path.head.node == wheel))
            }
            _ => false,
        })
    };
    let mut alone = cx.builder.mech.wheels.iter().filter(|w| !named(&w.name));
    let odd = alone.next().filter(|_| alone.next().is_none())?;
    let planet = |link: &str| {
        let shafts = cx.doc.statements.iter();
        shafts
            .into_iter()
            .any(|s| matches!(&s.node, Statement::Shaft(s) if s.name.node == link && s.on.is_some()))
    };
    let mut planets = cx
        .builder
        .mech
        .wheels
        .iter()
        .filter(|w| w.link != odd.link && planet(&cx.builder.mech.link(w.link).name));
    let with = planets.next().filter(|_| planets.next().is_none())?;
    Some(format!("`{0}` meshes with no wheel: add the line `mesh {name}: {0} - {1}`", odd.name, with.name))
}
