//! What the questions of a document need: motion alone, else all. It errs towards more.

use super::kinds::GivenLevel::{self, Accelerations, Forces, Positions, Velocities};
use crate::document::{Definition, Document, Expr, ExprKind, Statement, children};
use std::collections::BTreeMap;

/// The questions that need no forces and no masses, by function or word.
const OF_MOTION: [(&str, GivenLevel); 33] = [
    ("position", Positions),
    ("positions", Positions),
    ("angle", Positions),
    ("displacement", Positions),
    ("distance", Positions),
    ("travel", Positions),
    ("stroke", Positions),
    ("dead", Positions),
    ("time_ratio", Positions),
    ("transmission_angle", Positions),
    ("radius", Positions),
    ("contact_ratio", Positions),
    ("smallest_base_radius", Positions),
    ("start", Positions),
    ("velocity", Velocities),
    ("velocities", Velocities),
    ("omega", Velocities),
    ("speed", Velocities),
    ("relative_velocity", Velocities),
    ("slip_speed", Velocities),
    ("sliding_velocity", Velocities),
    ("coriolis", Velocities),
    ("instant_centre", Velocities),
    ("profile", Velocities),
    ("curvature_radius", Velocities),
    ("acceleration", Accelerations),
    ("accelerations", Accelerations),
    ("alpha", Accelerations),
    ("relative_acceleration", Accelerations),
    ("jerk", Accelerations),
    ("angular_jerk", Accelerations),
    ("curvature_centre", Accelerations),
    ("pressure_angle", Velocities),
];

/// Functions of what is in their brackets.
const OF_VALUES: [&str; 21] = [
    "sqrt", "abs", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "mag", "dot", "cross", "unit",
    "dir", "max", "min", "mean", "integral", "argmax", "argmin",
];

/// What a document asks for.
pub(super) fn level(document: &Document) -> GivenLevel {
    let mut questions = Vec::new();
    let mut definitions: BTreeMap<&str, &Definition> = BTreeMap::new();
    for statement in &document.statements {
        match &statement.node {
            Statement::Start(_) | Statement::Simulate(_) | Statement::Equilibrium(_) => return Forces,
            Statement::Find(find) => questions.extend(find.items.iter().map(|item| &item.value)),
            Statement::Given(own) | Statement::Let(own) => {
                definitions.insert(&own.name.node, own);
            }
            _ => {}
        }
    }
    let all = questions.into_iter().map(|question| of(question, &definitions));
    all.max().unwrap_or(Forces)
}

fn of(expr: &Expr, definitions: &BTreeMap<&str, &Definition>) -> GivenLevel {
    let known = |word: &str| OF_MOTION.iter().find(|(own, _)| *own == word).map(|(_, level)| *level);
    let parts = || {
        let mut parts = Vec::new();
        children(expr, &mut |part| parts.push(part));
        parts.into_iter().map(|part| of(part, definitions)).max().unwrap_or(Positions)
    };
    match &expr.kind {
        ExprKind::Name(name) if name == "pi" => Positions,
        ExprKind::Name(name) => match definitions.get(name.as_str()) {
            // a definition is in terms of no other before it, so this ends
            Some(definition) => of(&definition.value, definitions),
            None => known(name).unwrap_or(Forces),
        },
        ExprKind::Call { function, .. } if OF_VALUES.contains(&&*function.node) => parts(),
        ExprKind::Call { function, .. } => known(&function.node).unwrap_or(Forces),
        _ => parts(),
    }
}
