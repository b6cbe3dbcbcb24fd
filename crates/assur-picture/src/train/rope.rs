//! A rope from end to end over and under what it runs.

use super::layout::{Layout, wheel_named};
use crate::symbol::hinge;
use assur_drawing::{Drawing, Shape, Style};
use assur_math::math::Vec2;
use assur_model::model::{Mechanism, Transmission};

/// Radius of a pulley that has no wheel.
const PULLEY: f64 = 4.0;
/// From a weight to its pulley, to its upper edge, and to what is above all.
const HANGING: f64 = 12.0;
const EDGE: f64 = 3.4;
const ABOVE: f64 = 30.0;
/// From one of those that are above to the next.
const BESIDE: f64 = 11.0;

/// What a rope touches.
#[derive(Clone, Copy)]
enum Touched {
    /// It ends there, or leaves a wheel.
    End(Vec2),
    /// It runs around, with growing angles on paper where the sense is positive.
    Pulley(Vec2, f64),
}

impl Touched {
    const fn middle(&self) -> Vec2 {
        match self {
            Self::End(p) | Self::Pulley(p, _) => *p,
        }
    }
}

/// Draws a rope; the middle of its first part.
pub fn draw(
    mechanism: &Mechanism,
    layout: &Layout,
    t: &Transmission,
    (face, gap): (f64, f64),
    drawing: &mut Drawing,
) -> Option<Vec2> {
    let bare = |end: &str| {
        end.trim_start_matches("over(").trim_start_matches("under(").trim_end_matches(')').to_owned()
    };
    let wheel = |end: &str| layout.wheel(wheel_named(mechanism, &bare(end))?);
    let slider = |end: &str| {
        let own = layout.sliders.iter().find(|(link, _)| mechanism.link(*link).name == bare(end));
        own.map(|(_, at)| *at)
    };
    let pulley =
        |end: &str| slider(end).filter(|_| end.starts_with("under(")).map(|at| at - Vec2::new(0.0, HANGING));
    let toward = toward(t, |end| wheel(end).map(|w| w.x), |end| pulley(end).map(|at| at.x));
    let top = layout.sliders.first().map_or(Vec2::zero(), |s| s.1) - Vec2::new(0.0, ABOVE);
    let mut touched: Vec<Touched> = Vec::new();
    for (i, end) in t.ends.iter().enumerate() {
        if let Some(drawn) = wheel(end) {
            touched.push(Touched::End(Vec2::new(drawn.x + face, -(drawn.level - drawn.radius + gap))));
        } else if let Some(centre) = pulley(end) {
            drawing.mark(Style::Hinge, Shape::Circle { centre, radius: PULLEY });
            drawing.line(
                Style::Link,
                centre + Vec2::new(0.0, PULLEY),
                centre + Vec2::new(0.0, HANGING - EDGE),
            );
            touched.push(Touched::Pulley(centre, -toward));
        } else if let Some(at) = slider(end) {
            touched.push(Touched::End(at - Vec2::new(0.0, EDGE)));
        } else {
            // the ground, or an idler: upright above the pulley beside it
            let before =
                t.ends.get(i + 1).and_then(|next| pulley(next)).map(|c| (c.x - toward * PULLEY, -1.0));
            let behind = match touched.last() {
                Some(Touched::Pulley(c, _)) => Some((c.x + toward * PULLEY, 1.0)),
                _ => None,
            };
            let apart = BESIDE * (i as f64 - t.ends.len() as f64 / 2.0);
            let (x, side) = before.or(behind).unwrap_or((top.x + apart, 0.0));
            let fixed = bare(end) == "ground" || bare(end).starts_with("ground.");
            let at = Vec2::new(if fixed { x } else { x + side * toward * PULLEY }, top.y);
            touched.push(if fixed { Touched::End(at) } else { Touched::Pulley(at, toward) });
            above(at, fixed, drawing);
        }
    }
    let lines = untangled(touched);
    lines.iter().for_each(|(a, b)| drawing.line(Style::Medium, *a, *b));
    lines.first().map(|(a, b)| (*a + *b) * 0.5)
}

/// To which side a rope goes over its pulleys: to that of the wheel it comes to.
fn toward(
    t: &Transmission,
    wheel: impl Fn(&str) -> Option<f64>,
    pulley: impl Fn(&str) -> Option<f64>,
) -> f64 {
    let first = |place: &dyn Fn(&str) -> Option<f64>| {
        t.ends.iter().enumerate().find_map(|(i, end)| place(end).map(|x| (i, x)))
    };
    match (first(&wheel), first(&pulley)) {
        (Some((i, x)), Some((j, p))) if (x < p) == (i > j) => -1.0,
        _ => 1.0,
    }
}

/// What holds a rope above all: a piece of the ground, or an idler.
fn above(at: Vec2, fixed: bool, drawing: &mut Drawing) {
    if fixed {
        let line = Vec2::new(4.0, 0.0);
        drawing.line(Style::Medium, at - line, at + line);
        hinge::hatch(drawing, at - line, at + line, Vec2::new(0.0, -1.0));
    } else {
        drawing.mark(Style::Hinge, Shape::Circle { centre: at, radius: PULLEY });
    }
}

/// The straight parts; where two beside a pulley cross, the rope runs the other way around it.
fn untangled(mut touched: Vec<Touched>) -> Vec<(Vec2, Vec2)> {
    for i in 1..touched.len().max(1) - 1 {
        let lines = straight(&touched);
        if let (Touched::Pulley(_, sense), true) = (&mut touched[i], cross(lines[i - 1], lines[i])) {
            *sense = -*sense;
        }
    }
    straight(&touched)
}

fn straight(touched: &[Touched]) -> Vec<(Vec2, Vec2)> {
    touched.windows(2).map(|pair| (place(&pair[0], &pair[1], -1.0), place(&pair[1], &pair[0], 1.0))).collect()
}

/// Where a rope that comes from something else, or with the other sign leaves for it, touches this.
fn place(own: &Touched, other: &Touched, comes: f64) -> Vec2 {
    let Touched::Pulley(at, sense) = *own else { return own.middle() };
    let reach = match other {
        Touched::End(_) => PULLEY,
        // the pulleys lie on different sides of it, or on the same one
        Touched::Pulley(_, its) if its * sense < 0.0 => 2.0 * PULLEY,
        Touched::Pulley(..) => 0.0,
    };
    let way = other.middle() - at;
    let turn = libm::acos((reach / way.norm()).clamp(-1.0, 1.0));
    at + way.unit().unwrap_or(Vec2::new(1.0, 0.0)).turned(Vec2::direction(comes * sense * turn)) * PULLEY
}

fn cross((a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2)) -> bool {
    let sides = |a: Vec2, b: Vec2, p: Vec2, q: Vec2| (b - a).cross(p - a) * (b - a).cross(q - a) < 0.0;
    sides(a, b, c, d) && sides(c, d, a, b)
}
