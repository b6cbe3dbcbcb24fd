//! What acts on a part of the mechanism: loads, weights, inertia, reactions of what is outside.

use super::Part;
use crate::scene::Scene;
use assur_drawing::{Level, Text};
use assur_math::math::Vec2;
use assur_model::model::{
    BalanceKind, DriveTarget, LinkId, LoadId, LoadKind, Pair, PairId, PairKind, Query, Value,
};

/// What a force comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Acts {
    /// A load, a weight, an inertia force, a spring.
    Load,
    /// The reaction of a pair, and whether a group before has found it.
    Reaction {
        /// The pair.
        pair: PairId,
        /// It is known.
        known: bool,
    },
    /// An unknown effort.
    Effort,
}

/// A force on a part.
#[derive(Clone, Debug)]
pub struct Force {
    /// Its name.
    pub name: Text,
    /// The link on which it acts.
    pub on: LinkId,
    /// Where, m.
    pub at: Vec2,
    /// The force, N.
    pub force: Vec2,
    /// Where it comes from.
    pub acts: Acts,
}

/// A couple on a part.
#[derive(Clone, Debug)]
pub struct Couple {
    /// Its name.
    pub name: Text,
    /// The link on which it acts.
    pub on: LinkId,
    /// Where it is drawn, m.
    pub at: Vec2,
    /// The couple, N m.
    pub moment: f64,
    /// Where it comes from.
    pub acts: Acts,
}

impl Acts {
    /// Whether it is looked for.
    pub const fn is_unknown(&self) -> bool {
        matches!(self, Self::Reaction { known: false, .. } | Self::Effort)
    }
}

/// All that acts on a part.
#[derive(Clone, Debug, Default)]
pub struct Acting {
    /// Forces, link by link.
    pub forces: Vec<Force>,
    /// Couples.
    pub couples: Vec<Couple>,
}

/// Forces less than this part of the largest are rounding.
const NOTHING: f64 = 1e-9;
/// Where the largest is less than this part of what loads the mechanism, all of them.
const ROUNDING: f64 = 1e-13;

impl Acting {
    /// All that acts on a part from outside; none where a place or a force is not known.
    pub fn on(scene: &Scene<'_>, part: &Part) -> Option<Self> {
        let mut acting = Self::default();
        for link in &part.links {
            acting.loads(scene, *link);
            acting.masses(scene, *link);
            acting.rest(scene, *link);
        }
        acting.efforts(scene, part);
        acting.reactions(scene, part)?;
        acting.hidden_effort(scene, part);
        acting.hidden_couple(scene, part);
        if acting.forces.iter().any(|f| !(f.force.norm().is_finite() && f.at.norm().is_finite())) {
            return None;
        }
        let largest = acting.forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
        let only_rounding = largest <= ROUNDING * greatest(scene);
        acting.forces.retain(|f| !only_rounding && f.force.norm() > NOTHING * largest);
        let small = NOTHING * largest * assur_solve::solve::extent(&scene.model);
        acting.couples.retain(|c| c.moment.is_finite() && c.moment.abs() > small);
        Some(acting)
    }

    fn push(&mut self, name: Text, on: LinkId, at: Vec2, force: Vec2, acts: Acts) {
        self.forces.push(Force { name, on, at, force, acts });
    }

    fn turn(&mut self, name: Text, on: LinkId, at: Vec2, moment: f64, acts: Acts) {
        self.couples.push(Couple { name, on, at, moment, acts });
    }

    fn loads(&mut self, scene: &Scene<'_>, link: LinkId) {
        let view = scene.view();
        for (i, load) in scene.mechanism().loads.iter().enumerate() {
            let value = view.query(&Query::Load(LoadId::at(i)));
            let name = scene.load_name(load);
            match (&load.kind, value) {
                (
                    LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. },
                    Value::Vector(force),
                ) if *on == link => {
                    self.push(
                        name.unwrap_or_else(|| Text::italic("F")),
                        link,
                        view.place(link, at),
                        force,
                        Acts::Load,
                    );
                }
                (LoadKind::Torque { on, .. }, Value::Scalar(m)) if *on == link => {
                    let name = name.unwrap_or_else(|| Text::italic("M"));
                    self.turn(name, link, centre(scene, link), m, Acts::Load);
                }
                _ => {}
            }
        }
    }

    fn masses(&mut self, scene: &Scene<'_>, link: LinkId) {
        let effects = &scene.model.plan.effects;
        let Some(mass) = scene.mechanism().link(link).mass else { return };
        let at = scene.at(link, mass.centre);
        if let (true, Some(gravity)) = (effects.gravity && mass.mass > 0.0, scene.mechanism().gravity) {
            self.push(scene.indexed("G", link), link, at, gravity.acceleration * mass.mass, Acts::Load);
        }
        if effects.inertia {
            if let Value::Vector(force) = scene.view().query(&Query::InertiaForce(link)) {
                let name = Text::italic("F").lowered(&format!("I{}", scene.link_label(link)));
                self.push(name, link, at, force, Acts::Load);
            }
            if let Value::Scalar(m) = scene.view().query(&Query::InertiaTorque(link)) {
                let name = Text::italic("M").lowered(&format!("I{}", scene.link_label(link)));
                self.turn(name, link, at, m, Acts::Load);
            }
        }
    }

    /// What else is applied to a link: springs and dampers.
    fn rest(&mut self, scene: &Scene<'_>, link: LinkId) {
        let Some(applied) = scene.solved.state.forces.applied.get(link.index()) else { return };
        let own = self.forces.iter().filter(|f| f.on == link);
        let listed = own.clone().fold(Vec2::zero(), |sum, f| sum + f.force);
        let size = own.map(|f| f.force.norm()).fold(applied.force.norm(), f64::max);
        let rest = applied.force - listed;
        if rest.norm() <= 1e-7 * size {
            return;
        }
        let springs: Vec<_> = scene
            .mechanism()
            .springs
            .iter()
            .filter_map(|s| [s.from, s.to].into_iter().find(|(l, _)| *l == link).map(|(_, at)| (s, at)))
            .collect();
        let (name, at) = match springs.as_slice() {
            [(spring, at)] => (Text::italic("F").lowered(&spring.name), scene.at(link, *at)),
            _ => (Text::italic("F").lowered("s"), centre(scene, link)),
        };
        self.push(name, link, at, rest, Acts::Load);
    }

    fn efforts(&mut self, scene: &Scene<'_>, part: &Part) {
        let view = scene.view();
        for (i, balance) in scene.mechanism().balances.iter().enumerate() {
            let id = assur_model::model::BalanceId::at(i);
            let Value::Scalar(value) = view.query(&Query::Balance(id)) else { continue };
            for place in balance.kind.places() {
                match place {
                    BalanceKind::Torque(link) if part.links.contains(link) => {
                        let name = Text::name(&balance.name);
                        self.turn(name, *link, centre(scene, *link), value, Acts::Effort);
                    }
                    BalanceKind::Force { on, .. } if part.links.contains(on) => {
                        if let Some((at, along)) = view.balance_line(place) {
                            self.push(Text::name(&balance.name), *on, at, along * value, Acts::Effort);
                        }
                    }
                    _ => {}
                }
            }
        }
    }

    /// Reactions of what is outside the part; those found by groups before come first.
    fn reactions(&mut self, scene: &Scene<'_>, part: &Part) -> Option<()> {
        let mut found = Vec::new();
        for (i, pair) in scene.mechanism().pairs.iter().enumerate() {
            let id = PairId::at(i);
            let links = pair.kind.links();
            let inside: Vec<LinkId> = links.iter().copied().filter(|l| part.links.contains(l)).collect();
            let outside = links.iter().copied().find(|l| !part.links.contains(l));
            if let (PairKind::Cylinder { barrel, rod, .. }, None) = (&pair.kind, outside) {
                found.extend(held(scene, id, [*barrel, *rod], &inside));
            }
            let (Some(on), Some(from)) = (inside.first().copied(), outside) else { continue };
            let force = inside.iter().fold(Vec2::zero(), |sum, l| sum + scene.view().reaction(id, *l));
            let at = place(scene, id, on)?;
            let known = links.iter().any(|l| found_before(scene, *l, on));
            let name = scene.reaction_name(id, from, on);
            let couple = inside.iter().fold(0.0, |sum, l| sum + scene.view().moment(id, *l));
            let acts = Acts::Reaction { pair: id, known };
            self.turn(couple_name(pair, &name), on, at, couple, acts);
            found.push(Force { name, on, at, force, acts });
        }
        found.sort_by_key(|f| !matches!(f.acts, Acts::Reaction { known: true, .. }));
        self.forces.extend(found);
        Some(())
    }

    /// An effort, or a load, inside a pair that the part shares with the outside: what the other forces leave.
    fn hidden_effort(&mut self, scene: &Scene<'_>, part: &Part) {
        let sum = self.forces.iter().fold(Vec2::zero(), |sum, f| sum + f.force);
        let largest = self.forces.iter().map(|f| f.force.norm()).fold(0.0, f64::max);
        let mechanism = scene.mechanism();
        let touches = |pair: PairId| mechanism.pair(pair).kind.links().iter().any(|l| part.links.contains(l));
        let balances = mechanism.balances.iter().filter(|b| {
            b.kind.places().iter().any(|p| matches!(p, BalanceKind::InPair(pair) if touches(*pair)))
        });
        let loads = mechanism
            .loads
            .iter()
            .filter(|l| matches!(&l.kind, LoadKind::InPair { pair, .. } if touches(*pair)));
        // where nothing else is unknown, the drives' own efforts are
        let own = mechanism.balances.is_empty();
        let drives = mechanism.drives.iter().filter_map(|d| match d.target {
            DriveTarget::Pair(pair) if own && touches(pair) => Some(Text::italic("F").lowered(&d.name)),
            DriveTarget::Point(link, _) if own && part.links.contains(&link) => {
                Some(Text::italic("F").lowered(&d.name))
            }
            _ => None,
        });
        let names = balances
            .map(|b| Text::name(&b.name))
            .chain(loads.map(|l| scene.load_name(l).unwrap_or_else(|| Text::italic("F"))))
            .chain(drives);
        let Some(name) = names.into_iter().next().filter(|_| sum.norm() > 1e-7 * largest) else { return };
        let on = part.links[0];
        self.push(name, on, centre(scene, on), -sum, Acts::Effort);
    }
}

impl Acting {
    /// A couple inside a pair, or that of a drive without a balance: what all else leaves of the moments, so that a reader finds them
    /// add up to nothing.
    fn hidden_couple(&mut self, scene: &Scene<'_>, part: &Part) {
        let about = centre(scene, part.links[0]);
        let of_forces = self.forces.iter().map(|f| (f.at - about).cross(f.force));
        let moments: Vec<f64> = of_forces.chain(self.couples.iter().map(|c| c.moment)).collect();
        let largest = moments.iter().fold(0.0_f64, |most, m| most.max(m.abs()));
        let sum: f64 = moments.iter().sum();
        let mechanism = scene.mechanism();
        let touches = |pair: PairId| mechanism.pair(pair).kind.links().iter().any(|l| part.links.contains(l));
        let loads = mechanism
            .loads
            .iter()
            .filter(|l| matches!(l.kind, LoadKind::InPair { pair, .. } if touches(pair)));
        let balances = mechanism.balances.iter().filter(|b| {
            b.kind.places().iter().any(|p| matches!(p, BalanceKind::InPair(pair) if touches(*pair)))
        });
        let own = mechanism.balances.is_empty();
        let drives = mechanism.drives.iter().filter(|d| match d.target {
            DriveTarget::Link(link) => own && part.links.contains(&link),
            DriveTarget::Pair(pair) => own && touches(pair),
            DriveTarget::Point(..) => false,
        });
        let loads = loads.map(|l| (scene.load_name(l).unwrap_or_else(|| Text::italic("M")), false));
        let efforts = balances.map(|b| (Text::name(&b.name), true));
        let drives = drives.map(|d| (Text::italic("M").lowered(&d.name), true));
        // those of several pairs of a link together
        let together = loads.chain(efforts).chain(drives).reduce(|(sum, unknown), (name, more)| {
            let mut sum = sum.and(" + ", false, Level::Base);
            sum.runs.extend(name.runs);
            (sum, unknown || more)
        });
        // what is not determined is no number
        if sum.abs() > 1e-7 * largest
            && let Some((name, unknown)) = together
        {
            let acts = if unknown { Acts::Effort } else { Acts::Load };
            self.turn(name, part.links[0], about, -sum, acts);
        }
    }
}

/// The greatest force that is applied anywhere, with that of the greatest moment over the size of the mechanism.
fn greatest(scene: &Scene<'_>) -> f64 {
    let applied = &scene.solved.state.forces.applied;
    let force = applied.iter().map(|w| w.force.norm()).fold(0.0, f64::max);
    let moment = applied.iter().map(|w| w.moment.abs()).fold(0.0, f64::max);
    let extent = assur_solve::solve::extent(&scene.model);
    if extent > 0.0 { force + moment / extent } else { force }
}

/// What a cylinder between two links of a part does to both: they differ by what its barrel and its rod carry.
fn held(scene: &Scene<'_>, id: PairId, own: [LinkId; 2], links: &[LinkId]) -> Vec<Force> {
    if own.iter().all(|l| scene.mechanism().link(*l).mass.is_none()) {
        return Vec::new();
    }
    let on = |link: &LinkId| {
        let (at, force) = (place(scene, id, *link)?, scene.view().reaction(id, *link));
        let name = scene.reaction_name(id, *link, *link);
        Some(Force { name, on: *link, at, force, acts: Acts::Reaction { pair: id, known: true } })
    };
    links.iter().filter_map(on).collect()
}

/// Whether the forces of a link are found before those of another.
fn found_before(scene: &Scene<'_>, link: LinkId, than: LinkId) -> bool {
    let groups = &scene.model.structure.forces;
    let place = |l: LinkId| groups.iter().position(|g| g.bodies.iter().any(|b| b.0 == l.index()));
    link != LinkId::GROUND && matches!((place(link), place(than)), (Some(a), Some(b)) if a < b)
}

/// The point at which a pair acts on a link.
fn place(scene: &Scene<'_>, id: PairId, on: LinkId) -> Option<Vec2> {
    match &scene.mechanism().pair(id).kind {
        PairKind::Revolute(pins) => pins.iter().find(|p| p.link == on).map(|p| scene.at(on, p.at)),
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
        PairKind::Revolute(pins) => pins.iter().find(|pin| pin.link == link).map(|pin| pin.at),
        PairKind::Prismatic(g) if g.slider == link => Some(g.point),
        _ => None,
    });
    scene.at(link, pin.unwrap_or_else(Vec2::zero))
}
