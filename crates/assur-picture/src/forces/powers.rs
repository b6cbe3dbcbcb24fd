//! What does work in a mechanism: the terms of Zhukovsky's lever with the forces that stand for them, from the list with which the
//! balance of bodies is computed.

use super::actions::{Force, letters};
use crate::motion::{Nodes, velocity_at};
use crate::scene::Scene;
use assur_drawing::{Level, Text};
use assur_math::math::{ROUNDING, Vec2};
use assur_model::model::{LinkId, PairId, PairKind};
use assur_position::position::{Action, Origin};
use assur_solve::solve::BodyState;

/// The arm of a pair of forces on a link with one joint alone, over the size of the mechanism.
const ARM: f64 = 0.2;

/// A term of the sum of moments about the pole.
pub struct Term {
    pub name: Text,
    /// The power, W.
    pub power: f64,
    /// The forces, of a couple a pair of them, as far as their links have places.
    pub forces: Vec<Force>,
    /// Of links with one joint alone, the points of such a pair.
    pub arms: Vec<(LinkId, [Vec2; 2])>,
    /// It has a part without a place.
    pub open: bool,
}

/// The terms at a position: all that acts but the reactions, which do no work.
pub fn terms(scene: &Scene<'_>) -> Vec<Term> {
    let (view, nodes) = (scene.view(), Nodes::of(scene, false));
    let mut terms: Vec<Term> = Vec::new();
    let works = |action: &Action| match action.from {
        Origin::Reaction(_) => false,
        Origin::Law(slot) => scene.model.plan.laws[slot].efficiency.is_some(),
        _ => true,
    };
    for action in view.all_actions().into_iter().filter(works) {
        for side in [Some(action), action.opposite()].into_iter().flatten().filter(|side| side.on != 0) {
            put(scene, &nodes, &side, &mut terms);
        }
    }
    let largest = terms.iter().map(|t| t.power.abs()).fold(0.0, f64::max);
    terms.retain(|t| t.power.is_finite() && (t.power.abs() > ROUNDING * largest || !t.forces.is_empty()));
    terms
}

/// Adds what acts on one body to its terms: of its force and of its couple.
fn put(scene: &Scene<'_>, nodes: &Nodes, act: &Action, terms: &mut Vec<Term>) {
    let body = &scene.solved.state.motion.bodies[act.on];
    let is_placed = is_placed(scene, act.on);
    if act.force != Vec2::zero() && !meets(scene, act.from) {
        let power = act.force.dot(velocity_at(body, act.at));
        let name = name(scene, act, true);
        let term = term(terms, name.clone(), power, !is_placed);
        let (at, force) = (on_line(scene, act), act.force);
        if is_placed {
            term.forces.push(acting(act, name, at, force));
        }
    }
    if act.couple != 0.0 {
        let power = act.couple * body.omega;
        let term = term(terms, name(scene, act, false), power, !is_placed);
        // two forces at images that coincide have no moment
        if is_placed && body.omega != 0.0 {
            couple(scene, nodes, (act, body), term);
        }
    }
}

/// A force of the lever; of an image the drawing asks only for the body.
fn acting(act: &Action, name: Text, at: Vec2, force: Vec2) -> Force {
    let sought = matches!(act.from, Origin::Effort(_));
    Force { name, on: LinkId::at(act.on), at, force, pair: None, sought, presses: false }
}

/// Whether it is from teeth that meet: two opposite forces at one image.
fn meets(scene: &Scene<'_>, from: Origin) -> bool {
    matches!(from, Origin::Law(slot) if scene.model.plan.laws[slot].meeting.is_some())
}

/// The term of a name with more power.
fn term(terms: &mut Vec<Term>, name: Text, power: f64, open: bool) -> &mut Term {
    let there = terms.iter().position(|term| term.name == name).unwrap_or_else(|| {
        terms.push(Term { name, power: 0.0, forces: Vec::new(), arms: Vec::new(), open: false });
        terms.len() - 1
    });
    let found = &mut terms[there];
    found.power += power;
    found.open |= open && power != 0.0;
    found
}

/// The name of the term of a force or a couple: what friction does in a pair to both of its links is one.
fn name(scene: &Scene<'_>, act: &Action, is_force: bool) -> Text {
    let mechanism = scene.mechanism();
    let pair = scene.view().pair_of(act.from).map(|pair| mechanism.pair(pair).name.as_str());
    let letter = Text::italic(if is_force { "F" } else { "M" });
    match (act.from, pair) {
        (Origin::Friction(_), Some(pair)) if is_force => letter.lowered(&format!("f{pair}")),
        (Origin::Law(_) | Origin::Friction(_), Some(pair)) => Text::italic("M").lowered(&format!("f{pair}")),
        _ => letters(scene, act.from, LinkId::at(act.on), is_force),
    }
}

/// Whether a body has a place: what stands for a pair has one.
fn is_placed(scene: &Scene<'_>, body: usize) -> bool {
    body >= scene.mechanism().links.len() || scene.is_placed(LinkId::at(body))
}

/// A couple as a pair of forces in two points of its link; one that is there already takes more.
fn couple(scene: &Scene<'_>, nodes: &Nodes, (act, body): (&Action, &BodyState), term: &mut Term) {
    let on = LinkId::at(act.on);
    let joints: Vec<Vec2> = nodes.on(on).iter().map(|n| n.at).collect();
    let first = joints.first().copied().unwrap_or(body.p);
    let near = 1e-7 * assur_solve::solve::extent(&scene.model);
    let second = joints.iter().copied().find(|at| (*at - first).norm() > near).unwrap_or_else(|| {
        let second = beside(scene, on, first);
        term.arms.push((on, [first, second]));
        second
    });
    let arm = second - first;
    let force = arm.perp() * (act.couple / arm.dot(arm));
    let pair = Text::italic("F").lowered(&term.name.plain().replacen('_', "", 1));
    let back = pair.clone().and("′", false, Level::Base);
    for (name, at, force) in [(pair, second, force), (back, first, -force)] {
        match term.forces.iter_mut().find(|f| f.on == on && f.at == at && f.name == name) {
            Some(there) => there.force += force,
            None => term.forces.push(acting(act, name, at, force)),
        }
    }
}

/// A second point of a link with one joint alone: where its teeth meet others, else one at a distance.
fn beside(scene: &Scene<'_>, link: LinkId, first: Vec2) -> Vec2 {
    let mechanism = scene.mechanism();
    let pairs = (0..mechanism.pairs.len()).map(PairId::at);
    let own = pairs.filter(|pair| mechanism.pair(*pair).kind.links().contains(&link));
    let meets = own.filter_map(|pair| match mechanism.pair(pair).kind {
        PairKind::Transmission(_) => scene.view().pitch_point(pair),
        _ => None,
    });
    let extent = assur_solve::solve::extent(&scene.model);
    let there = meets.into_iter().find(|at| (*at - first).norm() > 1e-7 * extent && at.norm().is_finite());
    there.unwrap_or_else(|| first + scene.body(link).u * (ARM * extent))
}

/// The point of its line at which a force has its image: that of a cylinder acts at its pins.
fn on_line(scene: &Scene<'_>, act: &Action) -> Vec2 {
    // what its two parts do to each other is along it
    let is = |link: &LinkId, body: Option<usize>| Some(link.index()) == body;
    let pin = scene.mechanism().pairs.iter().find_map(|pair| match &pair.kind {
        PairKind::Cylinder { from, to, barrel, rod } => {
            let (on, by) = (Some(act.on), act.by);
            let found = [(from, barrel, rod), (to, rod, barrel)];
            found.into_iter().find(|(_, own, other)| is(own, on) && is(other, by)).map(|(pin, ..)| pin)
        }
        _ => None,
    });
    pin.map_or(act.at, |pin| scene.at(pin.link, pin.at))
}
