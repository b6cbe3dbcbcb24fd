//! Clutches, and what turns in them and in threads.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use crate::pairs::transmission::known;
use crate::trains::transmission::{Runs, incomplete, two};
use assur_model::model::{Law, LinkId, Rate};
use assur_syntax::document::{Joint, Path};

/// A shaft, a wheel, or a link that turns.
pub(crate) fn turning(cx: &mut Context<'_>, path: &Path) -> Option<LinkId> {
    let kinds = &[ThingKind::Shaft, ThingKind::Wheel, ThingKind::Link];
    known(cx, &path.head, "shaft, wheel or link", kinds);
    let link = cx.find_link(&path.head.node)?;
    if link == LinkId::GROUND {
        return incomplete(cx, "the ground does not turn", "name a shaft or a wheel of one", path.span());
    }
    Some(link)
}

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
