//! Clutches.

use crate::expr::context::Context;
use crate::trains::ends::{Runs, incomplete, turning, two};
use assur_model::model::{Law, Rate};
use assur_syntax::document::Joint;

/// Both sides have one speed.
pub(crate) fn clutch(cx: &mut Context<'_>, joint: &Joint) -> Option<Runs> {
    let [first, second] = two(cx, joint)?;
    let (a, b) = (turning(cx, first), turning(cx, second));
    let (a, b) = (a?, b?);
    if a == b {
        let message = "both sides of the clutch are on the same shaft";
        return incomplete(cx, message, "name two shafts", joint.name.span);
    }
    let law = Law {
        terms: vec![(Rate::Turn(a), 1.0), (Rate::Turn(b), -1.0)],
        constant: 0.0,
        force: 1.0,
        efficiency: None,
    };
    Some(Runs { laws: vec![law], links: vec![a, b], meeting: None })
}
