//! What acts on a part of the mechanism from outside, from the list with which the balance of bodies is computed.

use super::Part;
use crate::scene::Scene;
use assur_drawing::{Level, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, LoadId, Pair, PairId, PairKind};
use assur_model::structure::{BodyOrigin, EffortSource};
use assur_position::position::{Action, Origin};

/// A force on a part.
#[derive(Clone, Debug)]
pub struct Force {
    pub name: Text,
    /// The link on which it acts.
    pub on: LinkId,
    /// Where, m.
    pub at: Vec2,
    /// The force, N.
    pub force: Vec2,
    /// The pair whose reaction it is.
    pub pair: Option<PairId>,
    /// It is looked for: an unknown effort, or a reaction that no group before has found.
    pub sought: bool,
    /// It presses on a face: its arrow ends there.
    pub presses: bool,
}

/// A couple on a part.
#[derive(Clone, Debug)]
pub struct Couple {
    pub name: Text,
    /// The link on which it acts.
    pub on: LinkId,
    /// Where it is drawn, m.
    pub at: Vec2,
    /// The couple, N m.
    pub moment: f64,
    /// The pair whose reaction it is.
    pub pair: Option<PairId>,
    /// It is looked for: an unknown effort, or a reaction that no group before has found.
    pub sought: bool,
}

/// All that acts on a part.
#[derive(Clone, Debug, Default)]
pub struct FreeBody {
    /// Forces, link by link.
    pub forces: Vec<Force>,
    pub couples: Vec<Couple>,
    /// Couples of some pairs are not determined: their forces are where they balance.
    pub open: bool,
}

/// Forces less than this part of the largest are rounding.
const NOTHING: f64 = 1e-9;
/// Where the largest is less than this part of what loads the mechanism, all of them.
const ROUNDING: f64 = 1e-13;

impl FreeBody {
    /// All that acts on a part from outside; none where a place or a force is not known.
    pub fn of(scene: &Scene<'_>, part: &Part) -> Option<Self> {
        let (mut free, view) = (Self::default(), scene.view());
        let inside = inside(scene, part);
        let mut in_pairs: Vec<(PairId, LinkId, Vec<Action>)> = Vec::new();
        for action in view.actions(&inside) {
            let own = part.links.iter().copied().find(|link| link.index() == action.on);
            let on = own.unwrap_or(part.links[0]);
            let Some(pair) = view.pair_of(action.from) else {
                free.apply(scene, on, &action);
                continue;
            };
            match in_pairs.iter_mut().find(|one| one.0 == pair && (one.1 == on || is_one(scene, pair))) {
                Some(one) => one.2.push(action),
                None => in_pairs.push((pair, on, vec![action])),
            }
        }
        free.sort(part);
        in_pairs.sort_by_key(|one| one.0.index());
        let mut found = Vec::new();
        for (pair, on, actions) in in_pairs {
            found.push(free.reaction(scene, part, (pair, on), &actions)?);
        }
        found.sort_by_key(|f| f.sought);
        free.forces.extend(found);
        free.settle(scene, part);
        free.clear(scene)
    }

    /// Shifts forces of pairs whose couples are not determined across their lines, as little as lets them balance.
    fn settle(&mut self, scene: &Scene<'_>, part: &Part) {
        let undetermined = &scene.model.structure.undetermined_couples;
        let open = |pair: Option<PairId>| pair.is_some_and(|pair| undetermined.contains(&pair));
        self.open = self.forces.iter().any(|f| open(f.pair));
        let largest = self.forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
        let squares = self.forces.iter().filter(|f| open(f.pair)).map(|f| f.force.dot(f.force));
        let sum: f64 = squares.sum();
        if sum.sqrt() <= NOTHING * largest {
            return;
        }
        // the shifts stand for their couples
        self.couples.retain(|c| !open(c.pair));
        if self.on_faces(scene, part, open) {
            return;
        }
        let about = centre(scene, part.links[0]);
        let turning = self.forces.iter().map(|f| (f.at - about).cross(f.force));
        let moment: f64 = turning.chain(self.couples.iter().map(|c| c.moment)).sum();
        for force in self.forces.iter_mut().filter(|f| open(f.pair)) {
            force.at += force.force.perp() * (moment / sum);
        }
    }

    /// Puts the reactions on a wedge where they meet its faces, if all lines of action may go through one point.
    fn on_faces(&mut self, scene: &Scene<'_>, part: &Part, open: impl Fn(Option<PairId>) -> bool) -> bool {
        let [link] = part.links[..] else { return false };
        let Some(corners) = crate::wedge::corners(scene, link) else { return false };
        let known: Vec<&Force> = self.forces.iter().filter(|f| !open(f.pair)).collect();
        if !self.couples.is_empty() || known.len() > 1 {
            return false;
        }
        let corners: Vec<Vec2> = corners.into_iter().map(|corner| scene.at(link, corner)).collect();
        let middle = corners.iter().fold(Vec2::zero(), |sum, c| sum + *c) * (1.0 / corners.len() as f64);
        let meet = match known.first() {
            Some(load) => match load.force.unit() {
                Some(along) => load.at + along * (middle - load.at).dot(along),
                None => middle,
            },
            None => middle,
        };
        for force in self.forces.iter_mut().filter(|f| open(f.pair)) {
            let Some((at, along)) = force.pair.and_then(|pair| face(scene, pair)) else { return false };
            let across = force.force.cross(along);
            if across == 0.0 {
                return false;
            }
            force.at = meet + force.force * ((at - meet).cross(along) / across);
            force.presses = (middle - force.at).dot(force.force) > 0.0;
        }
        true
    }

    /// Without what is rounding; none where something is not known.
    fn clear(mut self, scene: &Scene<'_>) -> Option<Self> {
        if self.forces.iter().any(|f| !(f.force.norm().is_finite() && f.at.norm().is_finite())) {
            return None;
        }
        let largest = self.forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
        let only_rounding = largest <= ROUNDING * greatest(scene);
        self.forces.retain(|f| !only_rounding && f.force.norm() > NOTHING * largest);
        let small = NOTHING * largest * assur_solve::solve::extent(&scene.model);
        self.couples.retain(|c| c.moment.is_finite() && c.moment.abs() > small);
        Some(self)
    }

    /// What acts in no pair: loads, weights, inertia, springs, unknown efforts.
    fn apply(&mut self, scene: &Scene<'_>, on: LinkId, action: &Action) {
        let (pair, sought) = (None, matches!(action.from, Origin::Effort(_)));
        let Action { from, at, force, couple, .. } = *action;
        if force != Vec2::zero() {
            let name = letters(scene, from, on, true);
            self.forces.push(Force { name, on, at, force, pair, sought, presses: false });
        }
        if couple != 0.0 {
            let at = if force == Vec2::zero() { centre(scene, on) } else { at };
            let name = letters(scene, from, on, false);
            self.couples.push(Couple { name, on, at, moment: couple, pair, sought });
        }
    }

    /// Link by link, unknown efforts last.
    fn sort(&mut self, part: &Part) {
        let place = |on: LinkId| part.links.iter().position(|link| *link == on);
        self.forces.sort_by_key(|f| (f.sought, place(f.on)));
        self.couples.sort_by_key(|c| (c.sought, place(c.on)));
    }

    /// What a pair does on a link, as a force at its place, and a couple.
    fn reaction(
        &mut self,
        scene: &Scene<'_>,
        part: &Part,
        (id, on): (PairId, LinkId),
        all: &[Action],
    ) -> Option<Force> {
        let (pair, view) = (scene.mechanism().pair(id), scene.view());
        let links = pair.kind.links();
        let from = links.iter().copied().find(|l| !part.links.contains(l)).unwrap_or(on);
        // of wheels without a place torques are known, and no forces in bearings
        let at = place(scene, id, on)?;
        let force = all.iter().fold(Vec2::zero(), |sum, act| sum + act.force);
        let couple: f64 = all.iter().map(|act| act.couple + (act.at - at).cross(act.force)).sum();
        let sought = !links.iter().any(|l| found_before(scene, *l, on));
        let name = scene.reaction_name(id, from, on);
        if view.shares_friction(id) {
            return None;
        }
        let about = if force == Vec2::zero() { centre(scene, on) } else { at };
        let whose = couple_name(pair, &name);
        self.couples.push(Couple { name: whose, on, at: about, moment: couple, pair: Some(id), sought });
        Some(Force { name, on, at, force, pair: Some(id), sought, presses: false })
    }
}

/// The letter of what acts in no pair, with the link on which it acts.
pub fn letters(scene: &Scene<'_>, from: Origin, on: LinkId, is_force: bool) -> Text {
    let mechanism = scene.mechanism();
    let letter = Text::italic(if is_force { "F" } else { "M" });
    match from {
        Origin::Load(id) => scene.load_name(&mechanism.loads[id.index()]).unwrap_or(letter),
        Origin::Weight => scene.indexed("G", on),
        Origin::Inertia => letter.lowered(&format!("I{}", scene.link_label(on))),
        Origin::Spring(id) => letter.lowered(&mechanism.springs[id.index()].name),
        Origin::Effort(slot) => match scene.model.structure.efforts[slot].source {
            EffortSource::Balance(id) => Text::name(&mechanism.balances[id.index()].name),
            EffortSource::Drive(id) => letter.lowered(&mechanism.drives[id.index()].name),
        },
        Origin::Reaction(_) | Origin::Law(_) | Origin::Friction(_) => letter.lowered(scene.link_label(on)),
    }
}

/// The bodies of a part: its links, and what stands for pairs between them. A cylinder without mass between two of its links is
/// one of these; one with mass does to each what its own end does.
fn inside(scene: &Scene<'_>, part: &Part) -> Vec<usize> {
    let mechanism = scene.mechanism();
    let has = |links: &[LinkId]| links.iter().all(|link| part.links.contains(link));
    let mut bodies: Vec<usize> = part.links.iter().map(|link| link.index()).collect();
    for pair in &mechanism.pairs {
        if let PairKind::Cylinder { barrel, rod, from, to, .. } = &pair.kind
            && has(&[from.link, to.link])
            && [*barrel, *rod].iter().all(|link| mechanism.link(*link).mass.is_none())
        {
            bodies.extend([barrel.index(), rod.index()]);
        }
    }
    for (slot, body) in scene.model.structure.replaced.bodies.iter().enumerate() {
        if let BodyOrigin::Imaginary(pair) = body.origin
            && has(&mechanism.pair(pair).kind.links())
        {
            bodies.push(slot);
        }
    }
    bodies
}

/// Whether what a pair does to several links of a part is one force: in one point.
fn is_one(scene: &Scene<'_>, pair: PairId) -> bool {
    !matches!(scene.mechanism().pair(pair).kind, PairKind::Cylinder { .. } | PairKind::Transmission(_))
}

/// The greatest force that is applied anywhere, with that of the greatest moment over the size of the mechanism.
fn greatest(scene: &Scene<'_>) -> f64 {
    let applied = &scene.solved.state.forces.applied;
    // in a motion the loads on a link and its inertia may cancel
    let loads = (0..scene.mechanism().loads.len()).filter_map(|i| scene.view().load_action(LoadId::at(i)));
    let force = applied.iter().map(|w| w.force.norm()).fold(0.0, f64::max);
    let force = loads.map(|load| load.force.norm()).fold(force, f64::max);
    let moment = applied.iter().map(|w| w.moment.abs()).fold(0.0, f64::max);
    let extent = assur_solve::solve::extent(&scene.model);
    if extent > 0.0 { force + moment / extent } else { force }
}

/// Whether the forces of a link are found before those of another.
fn found_before(scene: &Scene<'_>, link: LinkId, than: LinkId) -> bool {
    let groups = &scene.model.structure.forces;
    let place =
        |l: LinkId| groups.iter().position(|g| g.bodies.contains(&scene.model.structure.replaced.body_of(l)));
    link != LinkId::GROUND && matches!((place(link), place(than)), (Some(a), Some(b)) if a < b)
}

/// The line along which two links slide on each other.
fn face(scene: &Scene<'_>, pair: PairId) -> Option<(Vec2, Vec2)> {
    match &scene.mechanism().pair(pair).kind {
        PairKind::Prismatic(g) => Some((scene.at(g.guide, g.through), g.along.turned(scene.body(g.guide).u))),
        _ => None,
    }
}

/// The point at which a pair acts on a link.
pub fn place(scene: &Scene<'_>, id: PairId, on: LinkId) -> Option<Vec2> {
    match &scene.mechanism().pair(id).kind {
        PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
            pins.iter().find(|p| p.link == on).map(|p| scene.at(on, p.at))
        }
        PairKind::Prismatic(g) | PairKind::Slot(g) => Some(scene.at(g.slider, g.point)),
        PairKind::Contact { .. } => scene.view().contact_normal(id).map(|(at, _)| at),
        PairKind::Cylinder { from, to, .. } => {
            let pin = if from.link == on { from } else { to };
            Some(scene.at(pin.link, pin.at))
        }
        PairKind::Transmission(_) => scene.view().pitch_point(id),
    }
}

/// The letter of the couple of a reaction: `M_fA` of friction in a hinge, `M₁₂` where a guide holds a link against turning.
fn couple_name(pair: &Pair, reaction: &Text) -> Text {
    if matches!(pair.kind, PairKind::Revolute(_)) {
        return Text::italic("M").lowered(&format!("f{}", pair.name));
    }
    let index = reaction.runs.iter().filter(|run| run.level == Level::Sub).map(|run| run.letters.as_str());
    Text::italic("M").lowered(&index.collect::<String>())
}

/// Where a couple of a link is drawn: its mass centre, else a joint.
fn centre(scene: &Scene<'_>, link: LinkId) -> Vec2 {
    let pin = scene.mechanism().pairs.iter().find_map(|p| match &p.kind {
        PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
            pins.iter().find(|pin| pin.link == link).map(|pin| pin.at)
        }
        PairKind::Prismatic(g) if g.slider == link => Some(g.point),
        _ => None,
    });
    scene.at(link, pin.unwrap_or_else(Vec2::zero))
}
