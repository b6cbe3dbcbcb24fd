//! Friction that has no direction, since nothing says how the machine moves.

use crate::expr::context::Context;
use crate::motion::drive::{Moves, moves};
use crate::pairs::property::AMOUNTS;
use assur_model::model::Drive;
use assur_syntax::document::{Property, Statement};
use assur_text::diagnostic::Diagnosis;
use miette::LabeledSpan;

/// Warns of friction that has no direction: the drive has neither a speed nor a sense.
pub(crate) fn no_motion(cx: &mut Context<'_>) {
    let still = |d: &Drive| d.speed.is_none() && d.acceleration.is_none() && d.sense.is_none();
    let rubs = cx.builder.mech.pairs.iter().any(|p| p.friction.is_some_and(|f| f.is_some()));
    let drives = &cx.builder.mech.drives;
    if !rubs || drives.is_empty() || !drives.iter().all(still) {
        return;
    }
    let amount = |p: &&Property| AMOUNTS.contains(&p.name.node.as_str());
    let mut labels = Vec::new();
    for statement in &cx.doc.statements {
        let properties = match &statement.node {
            Statement::Joint(joint) => &joint.properties,
            Statement::All(all) => &all.properties,
            _ => continue,
        };
        for property in properties.iter().filter(amount) {
            let span = property.span;
            let text = if labels.is_empty() { "against a motion without direction" } else { "and here" };
            labels.push(LabeledSpan::at(span.start..span.end, text));
        }
    }
    let drive = &drives[0];
    let sense = match moves(cx, drive.target) {
        Moves::Turning => "turning ccw",
        _ => "moving forward",
    };
    let (drive, sense) = (drive.name.clone(), sense.to_owned());
    cx.error(
        Diagnosis::warning(
            "mech::friction::no_motion",
            format!("friction is left out: the direction in which `{drive}` moves is not given"),
        )
        .labels(labels)
        .help(format!("give its direction, `drive {drive} = … {sense}`, or a speed")),
    );
}
