//! The train from the front, beside its section and at the same heights: the scheme of the machine with its places.

use super::layout::{Layout, Shaft};
use crate::machine::Laid;
use crate::paper::Frame;
use crate::scene::Scene;
use crate::scheme::front_view;
use crate::shape::shapes;
use crate::symbol::thread;
use assur_drawing::Drawing;
use assur_math::math::Vec2;
use assur_model::model::{Bearing, LinkId, PairKind, TransmissionKind};

/// From the section to the front view.
const BESIDE: f64 = 24.0;
/// With more wheels the view is too crowded to read.
const MOST: usize = 10;
/// From a worm to the end of its shaft with the bearing, and to the other end.
const LONG: f64 = 14.0;
const SHORT: f64 = 4.0;

/// The front view. Puts what has no place in section into it, which it returns: shafts of worms, sliders on ropes.
pub fn draw(scene: &Scene<'_>, layout: &Layout, drawing: &mut Drawing) -> (Vec<Shaft>, Vec<(LinkId, Vec2)>) {
    let laid = Laid::at_rest(scene).filter(|laid| is_shown(scene, layout, laid));
    let Some(laid) = laid else { return Default::default() };
    let unit = layout.unit(scene.mechanism());
    let Some(scene) = laid.still(scene) else { return Default::default() };
    let shapes = shapes(&scene);
    let left = drawing.extent().max.x.max(0.0) + BESIDE;
    let mut alone = Drawing::default();
    front_view(&scene, &shapes, &Frame::of_unit(unit, Vec2::zero()), &mut alone);
    let origin = Vec2::new((alone.extent().min.x - left) * unit, 0.0);
    let frame = Frame::of_unit(unit, origin);
    front_view(&scene, &shapes, &frame, drawing);
    let mechanism = scene.mechanism();
    let across = laid.arrangement.threads.iter().filter_map(|own| {
        let PairKind::Transmission(t) = &mechanism.pair(own.pair).kind else { return None };
        let link = *t.links.first().filter(|link| !scene.is_placed(**link))?;
        let (at, half) = (frame.point(own.at), thread::WORM);
        let ends = (at.x - half - LONG, at.x + half + SHORT);
        let shaft = Shaft { ends, level: -at.y, ..Shaft::new(link, LinkId::GROUND) };
        (t.kind == TransmissionKind::Worm).then_some(shaft)
    });
    let own = mechanism.pairs.iter().filter(|pair| pair.bearing == Some(Bearing::Placed));
    let sliders = own.filter_map(|pair| match &pair.kind {
        PairKind::Prismatic(g) => Some((g.slider, frame.point(scene.at(g.slider, Vec2::zero())))),
        _ => None,
    });
    let hung = sliders.filter(|(link, _)| layout.sliders.iter().all(|known| known.0 != *link));
    (across.collect(), hung.collect())
}

/// Whether it shows more than the section: not of axes that meet, of wheels that are not in one scale, of very many.
fn is_shown(scene: &Scene<'_>, layout: &Layout, laid: &Laid) -> bool {
    let has = |wanted: fn(TransmissionKind) -> bool| {
        scene.mechanism().pairs.iter().any(|pair| match &pair.kind {
            PairKind::Transmission(t) => wanted(t.kind),
            _ => false,
        })
    };
    let hangs = has(|kind| matches!(kind, TransmissionKind::Rope | TransmissionKind::Worm));
    let runs = !layout.runs.is_empty() || has(|kind| kind == TransmissionKind::Rack);
    let is_flat = layout.runs.iter().all(|run| run.cones.is_none());
    is_flat && layout.wheels.len() <= MOST && (hangs || runs && laid.arrangement.to_scale)
}
