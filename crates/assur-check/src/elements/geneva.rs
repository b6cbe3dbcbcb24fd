//! Geneva wheels: a pin in one of several slots.

use crate::expr::{context::Context, positive::positive};
use crate::values::format_value::format_value;
use assur_math::element::geneva::Geneva;
use assur_math::math::{SAME, Vec2};
use assur_model::model::{GenevaPair, LinkId, PairId, PairKind, Pin};
use assur_syntax::document::{JointKind, Property, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;
use std::f64::consts::PI;

const MOST: f64 = 1000.0;

/// Enters all pins in several slots.
pub(crate) fn genevas(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        match &statement.node {
            Statement::Joint(joint) if joint.kind.node == JointKind::Slot => {
                let property = joint.properties.iter().find(|p| p.name.node == "slots");
                let pair = cx.names.pairs.get(&joint.name.node).copied();
                if let (Some(property), Some(pair)) = (property, pair)
                    && let Some(geneva) = geneva(cx, property, pair)
                {
                    cx.builder.mech.genevas.push(geneva);
                }
            }
            Statement::All(all) => {
                if let Some(property) = all.properties.iter().find(|p| p.name.node == "slots") {
                    let message = "every wheel has its own number of slots".to_owned();
                    let help = "write `slots` in the braces of its `slot`".to_owned();
                    refused::<()>(cx, message, help, property.span);
                }
            }
            _ => {}
        }
    }
}

fn refused<T>(cx: &mut Context<'_>, message: String, help: String, span: Span) -> Option<T> {
    let has_number = help.starts_with("write `slots ");
    let diagnosis =
        Diagnosis::error("mech::geometry::geneva", message).primary(span, "this Geneva wheel").help(help);
    cx.error(if has_number { diagnosis.quoted(span) } else { diagnosis });
    None
}

fn mm(x: f64) -> String {
    format_value(x, Dimension::LENGTH)
}

fn geneva(cx: &mut Context<'_>, property: &Property, pair: PairId) -> Option<GenevaPair> {
    let slots = positive(cx, property.values.first()?, Dimension::NUMBER, "`slots`")?;
    if slots.fract() != 0.0 || !(3.0..=MOST).contains(&slots) {
        let message = format!("a Geneva wheel has a whole number of slots, at least 3: this is {slots}");
        return refused(cx, message, "write `slots 4`".into(), property.span);
    }
    let declared = cx.builder.mech.pair(pair).clone();
    let (name, span) = (&declared.name, property.span);
    let PairKind::Slot(guide) = &declared.kind else { return None };
    if declared.friction.is_some_and(|f| f.is_some()) {
        let message = format!("friction in `{name}` is not known while the arc locks the wheel");
        return refused(cx, message, "leave out `friction`".into(), span);
    }
    let (crank, wheel) = (guide.slider, guide.guide);
    let Some((frame, [crank_at, crank_centre], [wheel_at, hub])) = hinges(cx, crank, wheel) else {
        let link = |id: LinkId| cx.builder.mech.link(id).name.clone();
        let message = format!("`{}` and `{}` are not hinged to the same link", link(crank), link(wheel));
        let help =
            "join both to one frame, as in `revolute A: ground - crank` and `revolute C: ground - wheel`";
        return refused(cx, message, help.into(), span);
    };
    let (between, radius) = (wheel_at - crank_at, guide.point - crank_centre);
    let (distance, r) = (between.norm(), radius.norm());
    let from_hub = guide.through - hub;
    if from_hub.norm() > SAME * distance {
        let message = format!("line `{}` does not begin in the centre of the wheel", guide.line_name);
        let help = "write the line of a slot through the wheel's hinge: `line slot through C along 0 deg`";
        return refused(cx, message, help.into(), span);
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, from 3 to 1000
    let count = slots as u32;
    let Some(law) = Geneva::new(r / distance, count).filter(|_| r > 0.0) else {
        let message = format!(
            "a pin at {} from the crank\'s centre does not go from slot to slot: the centres are {} apart",
            mm(r),
            mm(distance)
        );
        return refused(cx, message, proportions(distance, r, slots), span);
    };
    if law.shock() != 0.0 {
        let ratio = format_value(law.shock(), Dimension::NUMBER);
        cx.error(
            Diagnosis::warning(
                "mech::geometry::geneva_shock",
                format!(
                    "the pin of `{name}` enters its slot with a shock: the wheel starts at {ratio} of the \
                     crank's speed"
                ),
            )
            .label(declared.span, "velocity jumps here")
            .help(proportions(distance, r, slots)),
        );
    }
    Some(GenevaPair {
        pair,
        law,
        crank,
        pin: guide.point,
        crank_centre,
        arm: radius / r,
        wheel,
        hub,
        slot: guide.along,
        frame,
        frame_hub: wheel_at,
        towards: between / distance,
    })
}

/// The radius of the pin as an expression: a rounded number may miss the slot.
fn proportions(distance: f64, r: f64, slots: f64) -> String {
    format!(
        "the pin enters along the slot where its radius is the distance of the centres times sin(180 deg/{slots}): write the \
         radius as `{}*sin(180 deg/{slots})`, or put the centres {} apart",
        mm(distance),
        mm(r / libm::sin(PI / slots))
    )
}

/// The link on which both turn, with the hinge of each: in its axes and in those of the link itself.
fn hinges(cx: &Context<'_>, crank: LinkId, wheel: LinkId) -> Option<(LinkId, [Vec2; 2], [Vec2; 2])> {
    let of = |link: LinkId| {
        let pairs = cx.builder.mech.pairs.iter().filter_map(move |pair| match &pair.kind {
            PairKind::Revolute(pins) => Some((pins, pins.iter().find(|p| p.link == link)?)),
            _ => None,
        });
        pairs.flat_map(move |(pins, own): (&Vec<Pin>, &Pin)| {
            let others = pins.iter().filter(move |p| p.link != link);
            others.map(move |p| (p.link, [p.at, own.at]))
        })
    };
    of(crank)
        .find_map(|(frame, a)| of(wheel).find(|w| w.0 == frame && w.1[0] != a[0]).map(|w| (frame, a, w.1)))
}
