//! The points of a plan: joints of the links, in the order in which they are known.

use crate::scene::Scene;
use assur_drawing::Text;
use assur_math::math::Vec2;
use assur_model::model::{Guide, LinkId, PairKind};
use assur_solve::solve::BodyState;

/// A point of a link whose velocity and acceleration have an image.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name.
    pub name: String,
    /// The number of the link, where several links have a point there.
    pub sub: Option<String>,
    /// The link.
    pub link: LinkId,
    /// Its place, m.
    pub at: Vec2,
    /// All links that have it.
    pub links: Vec<LinkId>,
    /// It is on the ground.
    pub fixed: bool,
    /// When it is known: the least rank of its links.
    pub rank: usize,
}

/// A pair in which a point slides along a moving link: the node on the slider, the node on the guide.
#[derive(Clone, Debug)]
pub struct Sliding {
    /// Index of the node of the slider.
    pub slider: usize,
    /// Index of the node of the guide.
    pub guide: usize,
}

/// The points of a plan.
#[derive(Clone, Debug, Default)]
pub struct Nodes {
    /// The points.
    pub nodes: Vec<Node>,
    /// Sliding between moving links.
    pub sliding: Vec<Sliding>,
}

/// When the motion of a link is known: 0 for the ground.
pub fn rank(scene: &Scene<'_>, link: LinkId) -> usize {
    let groups = &scene.model.structure.motion;
    groups.iter().position(|g| g.bodies.iter().any(|b| b.0 == link.index())).map_or(0, |r| r + 1)
}

impl Nodes {
    /// The joints of a mechanism at a position.
    pub fn of(scene: &Scene<'_>) -> Self {
        let mut nodes = Self::default();
        let pairs = &scene.mechanism().pairs;
        for pair in pairs {
            match &pair.kind {
                PairKind::Revolute(pins) if pins.iter().all(|p| scene.is_placed(p.link)) => {
                    let links: Vec<LinkId> = pins.iter().map(|p| p.link).collect();
                    if let Some(pin) = pins.iter().find(|p| p.link != LinkId::GROUND) {
                        nodes.add(scene, &pair.name, links, scene.at(pin.link, pin.at));
                    }
                }
                PairKind::Cylinder { from, to, barrel, rod } => {
                    for (pin, other) in [(from, *barrel), (to, *rod)] {
                        let name = if pin.name.is_empty() { &pair.name } else { &pin.name };
                        nodes.add(scene, name, vec![pin.link, other], scene.at(pin.link, pin.at));
                    }
                }
                _ => {}
            }
        }
        for pair in pairs.iter().filter(|p| p.bearing.is_none()) {
            if let PairKind::Prismatic(g) | PairKind::Slot(g) = &pair.kind {
                nodes.slide(scene, &pair.name, g);
            }
        }
        // those known first first
        let mut order: Vec<usize> = (0..nodes.nodes.len()).collect();
        order.sort_by_key(|i| (nodes.nodes[*i].rank, *i));
        let place = |old: usize| order.iter().position(|i| *i == old).unwrap_or(old);
        let sliding =
            nodes.sliding.iter().map(|s| Sliding { slider: place(s.slider), guide: place(s.guide) });
        Self { sliding: sliding.collect(), nodes: order.iter().map(|i| nodes.nodes[*i].clone()).collect() }
    }

    fn add(&mut self, scene: &Scene<'_>, name: &str, links: Vec<LinkId>, at: Vec2) -> usize {
        let fixed = links.contains(&LinkId::GROUND);
        let link = links.iter().copied().find(|l| *l != LinkId::GROUND).unwrap_or(LinkId::GROUND);
        let rank = links.iter().map(|l| rank(scene, *l)).min().unwrap_or(0);
        self.nodes.push(Node { name: name.to_owned(), sub: None, link, at, links, fixed, rank });
        self.nodes.len() - 1
    }

    fn slide(&mut self, scene: &Scene<'_>, name: &str, g: &Guide) {
        if !scene.is_placed(g.slider) || !scene.is_placed(g.guide) {
            return;
        }
        let at = scene.at(g.slider, g.point);
        let near = 1e-7 * assur_solve::solve::extent(&scene.model);
        let there = self.nodes.iter().position(|n| n.links.contains(&g.slider) && (n.at - at).norm() <= near);
        let name = if g.point_name.is_empty() { name } else { &g.point_name };
        let slider = there.unwrap_or_else(|| self.add(scene, name, vec![g.slider], at));
        if g.guide == LinkId::GROUND || g.slider == LinkId::GROUND {
            return;
        }
        let name = self.nodes[slider].name.clone();
        self.nodes[slider].sub = Some(scene.link_label(g.slider).to_owned());
        let guide = self.add(scene, &name, vec![g.guide], at);
        self.nodes[guide].sub = Some(scene.link_label(g.guide).to_owned());
        self.sliding.push(Sliding { slider, guide });
    }

    /// The points of a link.
    pub fn on(&self, link: LinkId) -> Vec<&Node> {
        self.nodes.iter().filter(|n| n.links.contains(&link)).collect()
    }
}

impl Node {
    /// Its velocity, m/s.
    pub fn velocity(&self, scene: &Scene<'_>) -> Vec2 {
        if self.fixed { Vec2::zero() } else { velocity(scene.body(self.link), self.at) }
    }

    /// Its acceleration, m/s².
    pub fn acceleration(&self, scene: &Scene<'_>) -> Vec2 {
        if self.fixed { Vec2::zero() } else { acceleration(scene.body(self.link), self.at) }
    }

    /// Its image.
    pub fn image(&self) -> Text {
        super::small(&self.name, self.sub.as_deref())
    }

    /// As an index: `A4`.
    pub fn index(&self) -> String {
        let primes = self.name.replace('\'', "′").replace('_', "");
        format!("{primes}{}", self.sub.as_deref().unwrap_or_default())
    }
}

/// Velocity of the point of a body that is at a place.
pub fn velocity(body: &BodyState, at: Vec2) -> Vec2 {
    body.v + (at - body.p).perp() * body.omega
}

/// Its acceleration.
pub fn acceleration(body: &BodyState, at: Vec2) -> Vec2 {
    let r = at - body.p;
    body.a + r.perp() * body.alpha - r * (body.omega * body.omega)
}
