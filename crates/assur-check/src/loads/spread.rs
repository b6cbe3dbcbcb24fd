//! Loads per length along a segment of a link.

use super::load::{described, form, moving, of_open_shaft, slider, value_of};
use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::statements::written::written;
use crate::values::fold;
use crate::values::typed::{Dim, Type};
use assur_math::math::Vec2;
use assur_model::model::{BinaryOp, Expr, LoadKind, Place, Spread};
use assur_syntax::document::{self, ExprKind, Load, Name};
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Ends whose directions differ by more than this have two.
const PARALLEL: f64 = 1e-9;
/// Ends whose sum is less than this part of them cancel: the place of the resultant is not known well.
const CANCELS: f64 = 1e-6;

/// The resultant of a load `from A to B`, and how it is spread.
pub(super) fn along(
    cx: &mut Context<'_>,
    load: &Load,
    (link, from, to): (&Name, &Name, &Name),
) -> Option<(LoadKind, Spread)> {
    let segment = from.span.to(to.span);
    fits(cx, load, link, segment)?;
    let on = moving(cx, link, "a force")?;
    let ends = [from, to].map(|name| cx.point(on, name));
    let values = values(cx, load);
    let frame = super::load::frame(cx, load.frame.as_ref());
    let ([Some(from), Some(to)], [first, last]) = (ends, values?) else { return None };
    let length = (to - from).norm();
    if length == 0.0 {
        form(cx, "the segment has no length".to_owned(), "name two points that are apart", segment);
        return None;
    }
    let share = share(cx, load, &first, &last)?;
    let sum = fold::binary(BinaryOp::Add, first, last);
    let value = fold::binary(BinaryOp::Mul, sum, Expr::number(length / 2.0));
    let spread = Spread { from, to, share };
    Some((LoadKind::Force { on, at: Place::Local(spread.centre()), value, frame: frame? }, spread))
}

/// Reports what has no meaning along a segment.
fn fits(cx: &mut Context<'_>, load: &Load, link: &Name, segment: Span) -> Option<()> {
    if load.kind.node == document::LoadKind::Torque {
        let help = format!("write it without the segment: `torque on {} = …`", link.node);
        form(cx, "a torque acts on a whole link".to_owned(), &help, segment);
        return None;
    }
    if slider(cx, link).is_some() {
        form(cx, "a load on a slider needs no point".to_owned(), "leave the segment out", segment);
        return None;
    }
    of_open_shaft(cx, link, "a force")?;
    if let Some(against) = load.against_motion {
        let message =
            "a load per length has one direction along its segment, and the motion has not".to_owned();
        form(cx, message, "give its direction: `3 kN/m down`, or `3 kN/m down in beam`", against);
        return None;
    }
    if let Some(sense) = &load.value.sense {
        let message = "a force has no sense of rotation".to_owned();
        form(cx, message, "give its direction: `3 kN/m @ 180 deg`", sense.span);
        return None;
    }
    Some(())
}

/// The forces per length at both ends.
fn values(cx: &mut Context<'_>, load: &Load) -> Option<[Expr; 2]> {
    let first = &load.value.value;
    let Some(last) = &load.last else { return value(cx, load, first).map(|value| [value.clone(), value]) };
    // `0 kN/m .. 5 kN/m @ 270 deg`
    let first = match &last.kind {
        ExprKind::Polar(_, angle) if !cx.is_vector(first)? => {
            let kind = ExprKind::Polar(Box::new(first.clone()), angle.clone());
            document::Expr { kind, span: first.span }
        }
        _ => first.clone(),
    };
    let values = [&first, last].map(|end| value(cx, load, end));
    let [Some(first), Some(last)] = values else { return None };
    Some([first, last])
}

fn value(cx: &mut Context<'_>, load: &Load, source: &document::Expr) -> Option<Expr> {
    let read = cx.read(source)?;
    let is_other = |dim| [Dimension::FORCE, Dimension::NUMBER].map(Dim::Of).contains(&dim);
    if matches!(read.ty, Type::Number(dim) | Type::Vector(dim) if is_other(dim)) {
        let message = format!("{} is distributed: its value must be a force per length", described(load));
        form(cx, message, "write the force per length, as in `3 kN/m down`, or give one point", source.span);
        return None;
    }
    if matches!(read.ty, Type::Vector(_)) {
        return value_of(cx, load, source, true, Dimension::STIFFNESS);
    }
    cx.scalar(source, &Want(Dimension::STIFFNESS), &described(load))?;
    let text = written(source).unwrap_or_else(|| "3 kN/m".to_owned());
    let message = format!("{} has no direction", described(load));
    form(cx, message, &format!("write the direction after the value: `{text} down`"), source.span);
    None
}

/// The share of the end in the sum of both.
fn share(cx: &mut Context<'_>, load: &Load, first: &Expr, last: &Expr) -> Option<f64> {
    let span = load.last.as_ref().map_or(load.value.value.span, |last| load.value.value.span.to(last.span));
    let known = [first, last].map(fold::vector);
    match known {
        _ if first == last => return Some(0.5),
        [Some(none), _] if none == Vec2::zero() => return Some(1.0),
        [_, Some(none)] if none == Vec2::zero() => return Some(0.0),
        [Some(first), Some(last)] => {
            let (sum, size) = (first + last, first.norm() + last.norm());
            if first.cross(last).abs() > PARALLEL * first.norm() * last.norm() {
                let help = "write one direction for both: `3 kN/m .. 5 kN/m down`";
                form(cx, "the ends of the load have two directions".to_owned(), help, span);
                return None;
            }
            if sum.norm() > CANCELS * size {
                return Some(last.dot(sum) / sum.dot(sum));
            }
            let help = "write two loads: one `.. 0` to the point where it is zero, one `0 ..` from there";
            form(cx, "both ends of the load cancel: it is a couple".to_owned(), help, span);
        }
        _ => {
            let help =
                "write two loads, each with one end at zero: `q1 .. 0 N/m down` and `0 N/m .. q2 down`";
            form(cx, "the ends of a load that varies with the motion differ".to_owned(), help, span);
        }
    }
    None
}
