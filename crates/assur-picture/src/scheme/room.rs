//! How large a sheet is on which the symbols and labels of many pairs have room.

use super::{AROUND, paper};
use crate::scene::Scene;
use assur_drawing::{Rect, Scale};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, PairKind};

/// Pairs that have room on a usual sheet, and so few that their distances say nothing of all.
const USUAL: usize = 24;
const FEW: usize = 8;
/// From a pair to the one nearest to it, for half of the pairs of a sheet with more, mm.
const BETWEEN: f64 = 12.0;
/// How many times as large as usual a sheet is, at most.
const MOST: f64 = 4.0;

/// The size of a sheet that holds a box, from the usual one.
pub(super) fn for_pairs(scene: &Scene<'_>, bounds: &Rect, usual: Vec2) -> Vec2 {
    let pairs = scene.mechanism().pairs.iter().filter(|p| p.bearing.is_none()).count();
    if pairs <= FEW {
        return usual;
    }
    let least = (pairs as f64 / USUAL as f64).sqrt().max(1.0);
    let size = paper(bounds, usual);
    let wanted = between(scene).and_then(|apart| Scale::largest(apart / BETWEEN)).map_or(0.0, |scale| {
        let needed = bounds.size() * (1.0 / scale.factor()) + AROUND;
        (needed.x / size.x).max(needed.y / size.y).min(MOST)
    });
    usual * wanted.max(least)
}

/// How far half of the hinges are at least from the one nearest to them, m.
fn between(scene: &Scene<'_>) -> Option<f64> {
    let hinges = scene.mechanism().pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Revolute(pins) => {
            pins.iter().find(|pin| pin.link != LinkId::GROUND).map(|pin| (pin.link, pin.at))
        }
        PairKind::Prismatic(g) | PairKind::Slot(g) => Some((g.slider, g.point)),
        _ => None,
    });
    let hinges = hinges.filter(|(link, _)| scene.is_placed(*link)).map(|(link, at)| scene.at(link, at));
    let hinges: Vec<Vec2> = hinges.collect();
    let nearest = |at: &Vec2| {
        let squared = |other: &Vec2| (*other - *at).dot(*other - *at);
        hinges.iter().map(squared).filter(|apart| *apart > 0.0).min_by(f64::total_cmp).map(f64::sqrt)
    };
    let mut apart: Vec<f64> = hinges.iter().filter_map(nearest).collect();
    apart.sort_by(f64::total_cmp);
    apart.get(apart.len() / 2).copied()
}
