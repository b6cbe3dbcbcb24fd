//! Worms and screws: a thread that turns a wheel, and one that moves a nut.

use crate::expr::context::Context;
use crate::expr::property::{Read, find};
use crate::names::declared::ThingKind;
use crate::pairs::transmission::known;
use crate::statements::written::braces;
use crate::trains::ends::{AGREES, Runs, incomplete, turning, two, wheel};
use crate::trains::rope::merged;
use assur_model::model::{Law, LinkId, PairId, PairKind, Rate};
use assur_syntax::document::{Joint, Path};
use std::f64::consts::TAU;

/// ω of the wheel times its teeth is ω of the worm times its starts.
pub(crate) fn worm(cx: &mut Context<'_>, joint: &Joint, properties: &[Read]) -> Option<Runs> {
    let [first, second] = two(cx, joint)?;
    let (worm, wheel) = (turning(cx, first), wheel(cx, second));
    let (worm, wheel) = (worm?, wheel?);
    let Some(teeth) = wheel.teeth else {
        let message = format!("worm wheel `{}` needs a number of teeth", wheel.name);
        let help = format!("write `wheel {} teeth 40`", wheel.name);
        return incomplete(cx, &message, &help, second.span());
    };
    if worm == wheel.link {
        return incomplete(
            cx,
            "a worm and its wheel are on the same shaft",
            "name two shafts",
            joint.name.span,
        );
    }
    let starts = find(properties, "starts").map_or(1.0, Read::number);
    let terms = vec![(Rate::Turn(worm), starts), (Rate::Turn(wheel.link), -teeth)];
    let law = Law { terms, constant: 0.0, force: teeth / wheel.radius, efficiency: None };
    Some(Runs { laws: vec![law], links: vec![worm, wheel.link], meeting: None })
}

/// v = ω lead / 2π.
pub(crate) fn screw(cx: &mut Context<'_>, joint: &Joint, properties: &[Read]) -> Option<Runs> {
    let [first, second] = two(cx, joint)?;
    let (spindle, nut) = (turning(cx, first), sliding(cx, second));
    let (spindle, (pair, link, sense)) = (spindle?, nut?);
    let Some(lead) = find(properties, "lead") else {
        let help = format!(
            "add the lead, with its own value: `{}`",
            braces(&joint.properties, &["lead 5 mm"]).trim()
        );
        return incomplete(cx, "the lead of the screw is missing", &help, joint.name.span);
    };
    let lead_per_angle = lead.number() / TAU;
    if lead_per_angle == 0.0 {
        return incomplete(cx, "a screw without lead moves nothing", "write `lead 5 mm`", lead.span);
    }
    let terms = vec![(Rate::Turn(spindle), lead_per_angle), (Rate::Slide(pair), -sense)];
    let law = Law { terms: merged(terms), constant: 0.0, force: 1.0, efficiency: None };
    Some(Runs { laws: vec![law], links: vec![spindle, link], meeting: None })
}

/// The coordinate of what slides: a slider, or a link on a guide, with the sense in which its own line counts.
fn sliding(cx: &mut Context<'_>, path: &Path) -> Option<(PairId, LinkId, f64)> {
    let kinds = &[ThingKind::Slider, ThingKind::Link];
    known(cx, &path.head, "slider or link", kinds);
    if cx.names.things.get(&path.head.node).is_some_and(|d| !kinds.contains(&d.what)) {
        return None;
    }
    let link = cx.find_link(&path.head.node)?;
    let line = match &path.tail {
        Some(part) => Some(cx.line(link, part)?),
        None => None,
    };
    let guides = cx.builder.mech.pairs.iter().enumerate().filter_map(|(i, p)| match &p.kind {
        PairKind::Prismatic(g) if g.slider == link && g.guide == LinkId::GROUND => {
            Some((PairId::at(i), g.direction, 1.0))
        }
        PairKind::Prismatic(g) if g.guide == link && g.slider == LinkId::GROUND => {
            Some((PairId::at(i), g.along, -1.0))
        }
        _ => None,
    });
    let guides: Vec<_> = guides.collect();
    let [(pair, direction, sense)] = guides[..] else {
        let message = format!("`{}` does not slide along one line of the ground", path.head.node);
        let help = "name a `slider`, or a link with one prismatic pair to the ground";
        return incomplete(cx, &message, help, path.span());
    };
    let sense = match line {
        None => sense,
        Some(line) if line.along.cross(direction).abs() <= AGREES => {
            sense * line.along.dot(direction).signum()
        }
        Some(line) => {
            let message = format!("the line `{}` is not parallel to the guide of its link", line.name);
            return incomplete(
                cx,
                &message,
                "make it parallel to the guide: the teeth of a rack lie along it",
                path.span(),
            );
        }
    };
    Some((pair, link, sense))
}
