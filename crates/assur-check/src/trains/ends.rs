//! The ends of a transmission: wheels, shafts, what turns.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use crate::pairs::{property::phrase, transmission::known};
use assur_model::model::{Law, LinkId, Meeting, Rate, Wheel};
use assur_syntax::document::{End, Joint, Path};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Sizes may differ from what the teeth say by this part.
pub(crate) const AGREES: f64 = 1e-9;

/// What runs between the ends, before losses.
pub(crate) struct Runs {
    pub(crate) laws: Vec<Law>,
    pub(crate) links: Vec<LinkId>,
    pub(crate) meeting: Option<Meeting>,
}

pub(crate) fn incomplete<T>(cx: &mut Context<'_>, message: &str, help: &str, span: Span) -> Option<T> {
    let (message, help) = (message.to_owned(), help.to_owned());
    cx.error(Diagnosis::error("mech::geometry::incomplete", message).label(span, "here").help(help));
    None
}

/// The two ends; reports more of them.
pub(crate) fn two<'j>(cx: &mut Context<'_>, joint: &'j Joint) -> Option<[&'j Path; 2]> {
    let what = phrase(joint.kind.node);
    let odd = joint.ends.iter().enumerate().find(|(i, e)| *i > 1 || !matches!(e, End::At(_)));
    if let Some((i, end)) = odd {
        let got = if i > 1 { format!("{} of them", joint.ends.len()) } else { "a pulley".into() };
        cx.error(
            Diagnosis::error("mech::geometry::wrong_ends", format!("{what} joins two ends, not {got}"))
                .label(end.span(), &got)
                .help("write one statement for each two ends; use `over` and `under` only in a rope"),
        );
        return None;
    }
    match joint.ends.as_slice() {
        [End::At(a), End::At(b)] => Some([a, b]),
        _ => None,
    }
}

impl Context<'_> {
    /// The wheel of that name.
    pub(crate) fn wheel(&self, name: &str) -> Option<Wheel> {
        self.builder.mech.wheels.iter().find(|w| w.name == name).cloned()
    }
}

pub(crate) fn wheel(cx: &mut Context<'_>, path: &Path) -> Option<Wheel> {
    known(cx, &path.head, "wheel", &[ThingKind::Wheel]);
    if let Some(part) = &path.tail {
        return incomplete(cx, "a wheel has no points", "leave out the part after the dot", part.span);
    }
    cx.wheel(&path.head.node)
}

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

// Clutches.

/// Both sides have one speed, but where it slips. A freewheel may hold a shaft at the ground.
pub(crate) fn clutch(cx: &mut Context<'_>, joint: &Joint, (slips, freewheel): (bool, bool)) -> Option<Runs> {
    let [first, second] = two(cx, joint)?;
    let is_ground =
        freewheel && first.tail.is_none() && cx.find_link(&first.head.node) == Some(LinkId::GROUND);
    let first = if is_ground { Some(LinkId::GROUND) } else { turning(cx, first) };
    let (a, b) = (first, turning(cx, second));
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
    let laws = if slips { Vec::new() } else { vec![law] };
    Some(Runs { laws, links: vec![a, b], meeting: None })
}
