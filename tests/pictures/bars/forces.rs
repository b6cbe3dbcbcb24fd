//! Polygons close as they are printed, levers balance, action lines touch their friction circles.

use super::Judged;
use assur::internals::drawing::{Shape, Sheet, Style, Theme};
use assur::internals::math::Vec2;
use assur::internals::model::{Friction, PairId};

/// How far a polygon may be open, mm, from printed coordinates.
const OPEN: f64 = 0.02;
/// How far an action line may be off its circle, mm.
const OFF: f64 = 0.01;
/// The largest part of its greatest term that the sum of a lever may be.
const SHARE: f64 = 1e-9;

/// The sides of a polygon end where it began, and each begins where the one before ends. How many polygons there are.
pub fn polygon(sheet: &Sheet, wrong: &mut Vec<String>) -> usize {
    if !sheet.drawing.id.starts_with("polygon") {
        return 0;
    }
    let sides = printed(&sheet.svg(Theme::Light));
    let Some(&(first, mut end)) = sides.first() else { return 0 };
    for (a, b) in &sides[1..] {
        if (end - first).norm() <= OPEN {
            break;
        }
        if (*a - end).norm() > OPEN {
            wrong.push(format!("a gap of {} mm", (*a - end).norm()));
        }
        end = *b;
    }
    if (end - first).norm() > OPEN {
        wrong.push(format!("{} is open by {} mm", sheet.drawing.id, (end - first).norm()));
    }
    1
}

/// Arrows and lines of vectors as they are printed: the begin of the shaft, the tip of the head.
fn printed(svg: &str) -> Vec<(Vec2, Vec2)> {
    let mut sides = Vec::new();
    for group in svg.split("<g class=\"vector\"").skip(1) {
        let group = group.split("</g>").next().unwrap_or_default();
        let number = |key: &str| {
            let (_, rest) = group.split_once(&format!("{key}=\""))?;
            rest.split('"').next()?.parse::<f64>().ok()
        };
        let end = |x: &str, y: &str| Some(Vec2::new(number(x)?, number(y)?));
        let Some((from, to)) = end("x1", "y1").zip(end("x2", "y2")) else { continue };
        let tip = group.split_once(" head\" d=\"M").and_then(|(_, path)| {
            let (x, y) = path.split('L').next()?.split_once(' ')?;
            Some(Vec2::new(x.parse().ok()?, y.parse().ok()?))
        });
        sides.push((from, tip.unwrap_or(to)));
    }
    sides
}

/// What rounding leaves of the largest term of a lever, over the condition of the position.
const ROUNDING: f64 = 1e-14;

/// The moments about the pole of a lever add up to nothing, as far as the condition of the position lets them.
pub fn lever(sheet: &Sheet, condition: f64, wrong: &mut Vec<String>) -> usize {
    let said = sheet.drawing.description.split_once("Their sum is ").map(|(_, said)| said);
    let share = said.and_then(|said| said.split(' ').next()?.parse::<f64>().ok());
    if share.is_none_or(|share| share > SHARE.max(ROUNDING / condition)) {
        wrong.push(sheet.drawing.description.clone());
    }
    1
}

/// The action line of every hinge touches its friction circle. How many there are.
pub fn action_lines(judged: &Judged<'_>, wrong: &mut Vec<String>) -> usize {
    let drawing = &judged.sheet.drawing;
    let mut count = 0;
    for (i, group) in drawing.groups.iter().enumerate().filter(|(_, g)| g.class == "pair") {
        let own = || drawing.marks.iter().filter(move |m| m.group == i);
        let circle = own().find_map(|m| match m.shape {
            Shape::Circle { centre, radius } if m.style == Style::FrictionCircle => Some((centre, radius)),
            _ => None,
        });
        let line = own().find_map(|m| match m.shape {
            Shape::Line(a, b) if m.style == Style::Dashed => Some((a, b)),
            _ => None,
        });
        let (Some((centre, radius)), Some((a, b))) = (circle, line) else { continue };
        count += 1;
        let away = ((b - a) / (b - a).norm()).cross(centre - a).abs();
        // a hinge that does not turn has a line through it, and one that is held at rest has it within its circle at rest
        let held = at_rest(judged, &group.name).is_some_and(|times| away <= times * radius + OFF);
        if (away - radius).abs() > OFF && away > OFF && !held {
            wrong.push(format!("{} is {away} mm off a circle of {radius} mm", group.name));
        }
    }
    count
}

/// How many times greater the friction circle of a hinge is while it rests in a motion, where it has one.
fn at_rest(judged: &Judged<'_>, name: &str) -> Option<f64> {
    let mechanism = judged.shown.model.mechanism;
    let of = |(pair, rest): &(PairId, Friction)| {
        let own = mechanism.pair(*pair);
        match (own.friction, *rest) {
            (Some(Friction::Circle(moving)), Friction::Circle(rest)) if own.name == name => {
                Some(rest / moving)
            }
            _ => None,
        }
    };
    mechanism.friction_at_rest.iter().find_map(of)
}
