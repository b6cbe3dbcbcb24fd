//! Hinges are where the solution says.

use super::Judged;
use assur::internals::drawing::{Shape, Style};
use assur::internals::math::Vec2;
use assur::internals::model::{Bearing, LinkId, PairKind};

/// How far a hinge may be off, mm.
const OFF: f64 = 0.01;

/// Distances of hinges on paper are those of the solution over the scale factor. How many hinges there are.
pub fn hinges(judged: &Judged<'_>, wrong: &mut Vec<String>) -> usize {
    let Some(factor) = judged.factor("Length scale ") else { return 0 };
    // where a shaft without a place is laid out is a matter of the picture
    let pairs = judged.shown.model.mechanism.pairs.iter();
    let pairs = pairs.filter(|pair| pair.bearing != Some(Bearing::Open));
    let hinges = pairs.filter_map(|pair| {
        let PairKind::Revolute(pins) = &pair.kind else { return None };
        let pin = pins.iter().find(|p| p.link != LinkId::GROUND)?;
        let at = judged.state.motion.bodies[pin.link.index()].position(pin.at);
        Some((pair.name.as_str(), at, circle(judged, &pair.name)?))
    });
    let hinges: Vec<(&str, Vec2, Vec2)> = hinges.collect();
    let Some(&(_, first, first_paper)) = hinges.first() else { return 0 };
    for (name, at, paper) in &hinges {
        let wanted = Vec2::new(at.x - first.x, first.y - at.y) / factor;
        let away = (*paper - first_paper - wanted).norm();
        if away > OFF {
            wrong.push(format!("{name} is {away} mm off"));
        }
    }
    hinges.len()
}

/// The middle of the first circle of a pair.
fn circle(judged: &Judged<'_>, pair: &str) -> Option<Vec2> {
    judged.sheet.drawing.marks.iter().find_map(|mark| match mark.shape {
        Shape::Circle { centre, .. } if mark.style == Style::Hinge => {
            (judged.group(mark) == ("pair", pair)).then_some(centre)
        }
        _ => None,
    })
}
