//! The points of a plan: joints of the links, in the order in which they are known.

use crate::scene::Scene;
use assur_drawing::Text;
use assur_math::math::Vec2;
use assur_model::model::{DriveTarget, Guide, LinkId, PairId, PairKind, Point, Profile, ProfileShape};
use assur_solve::solve::BodyState;

/// A point of a link whose velocity and acceleration have an image.
#[derive(Clone, Debug)]
pub struct Node {
    pub name: String,
    /// The number of the link, where several links have a point there.
    pub sub: Option<String>,
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
    pub nodes: Vec<Node>,
    /// Sliding between moving links.
    pub sliding: Vec<Sliding>,
    /// Centres of profiles in contact, which the link that replaces the contact joins: indices of nodes.
    pub centres: Vec<(usize, usize)>,
}

/// When the motion of a link is known: 0 for the ground.
pub fn rank(scene: &Scene<'_>, link: LinkId) -> usize {
    let groups = &scene.model.structure.motion;
    groups
        .iter()
        .position(|g| g.bodies.contains(&scene.model.structure.replaced.body_of(link)))
        .map_or(0, |r| r + 1)
}

impl Nodes {
    /// Points of links that the author named, with their places, m, where no joint is.
    pub fn others<'n>(&'n self, scene: &'n Scene<'_>) -> impl Iterator<Item = (LinkId, &'n str, Vec2)> {
        let near = 1e-7 * assur_solve::solve::extent(&scene.model);
        let links = scene.mechanism().links.iter().enumerate().skip(1).map(|(i, link)| (LinkId::at(i), link));
        let placed = links.filter(move |(id, _)| scene.is_placed(*id) && !scene.is_in_cylinder(*id));
        let points = placed.flat_map(move |(id, link)| {
            link.points.iter().map(move |p| (id, p.name.as_str(), scene.at(id, p.at)))
        });
        points.filter(move |(_, _, at)| self.nodes.iter().all(|n| (n.at - *at).norm() > near))
    }

    /// The letter of the pole, which is that of no image.
    pub fn pole(&self, scene: &Scene<'_>) -> &'static str {
        let joints = self.nodes.iter().filter(|node| !node.fixed).map(Node::image);
        let others = self.others(scene).map(|(link, name, _)| super::other_image(scene, link, name));
        let images: Vec<String> = joints.chain(others).map(|image| image.plain()).collect();
        let is_free = |letter: &&str| images.iter().all(|image| image != letter);
        ["p", "o", "π"].into_iter().find(is_free).unwrap_or("p")
    }

    /// The joints of a mechanism at a position.
    pub fn of(scene: &Scene<'_>, contacts: bool) -> Self {
        let mut nodes = Self::default();
        let pairs = &scene.mechanism().pairs;
        for pair in pairs {
            match &pair.kind {
                PairKind::Revolute(pins) | PairKind::Weld { pins, .. }
                    if pins.iter().all(|p| scene.is_placed(p.link)) =>
                {
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
        for (i, pair) in pairs.iter().enumerate().filter(|(_, p)| p.bearing.is_none()) {
            if let PairKind::Prismatic(g) | PairKind::Slot(g) = &pair.kind {
                nodes.slide(scene, (PairId::at(i), &pair.name), g);
            }
        }
        for (i, pair) in pairs.iter().enumerate() {
            if let PairKind::Contact { first, second, .. } = &pair.kind {
                nodes.touch(scene, (PairId::at(i), &pair.name), [first, second], contacts);
            }
        }
        for drive in &scene.mechanism().drives {
            let DriveTarget::Place(link, at, _) = drive.target else { continue };
            let points = &scene.mechanism().link(link).points;
            // the driven one first
            let (driven, others): (Vec<&Point>, Vec<&Point>) =
                points.iter().partition(|point| point.at == at);
            for point in driven.iter().chain(&others) {
                let at = scene.at(link, point.at);
                if nodes.nodes.iter().all(|node| !node.links.contains(&link) || node.at != at) {
                    nodes.add(scene, &point.name, vec![link], at);
                }
            }
        }
        // those known first first
        let mut order: Vec<usize> = (0..nodes.nodes.len()).collect();
        order.sort_by_key(|i| (nodes.nodes[*i].rank, *i));
        let place = |old: usize| order.iter().position(|i| *i == old).unwrap_or(old);
        let sliding =
            nodes.sliding.iter().map(|s| Sliding { slider: place(s.slider), guide: place(s.guide) });
        let centres = nodes.centres.iter().map(|(a, b)| (place(*a), place(*b)));
        Self {
            sliding: sliding.collect(),
            centres: centres.collect(),
            nodes: order.iter().map(|i| nodes.nodes[*i].clone()).collect(),
        }
    }

    /// Centres of round profiles; of others the place of contact on both links.
    fn touch(
        &mut self,
        scene: &Scene<'_>,
        (id, name): (PairId, &str),
        profiles: [&Profile; 2],
        contacts: bool,
    ) {
        let centre = |profile: &Profile| match profile.shape {
            ProfileShape::Point(at) | ProfileShape::Circle(at, _) => Some(at),
            ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
        };
        let round = profiles.map(|p| centre(p).map(|at| self.centre(scene, p, at)));
        if let [Some(first), Some(second)] = round {
            self.centres.push((first, second));
            return;
        }
        let Some((at, _)) = scene.view().contact_normal(id).filter(|_| contacts) else { return };
        let ends = profiles.map(|p| (p.link, self.add(scene, name, vec![p.link], at)));
        for (link, node) in ends {
            self.nodes[node].sub = Some(scene.link_label(link).to_owned());
        }
        let moving = ends.iter().all(|(link, _)| *link != LinkId::GROUND);
        if moving {
            self.sliding.push(Sliding { slider: ends[0].1, guide: ends[1].1 });
        }
    }

    fn centre(&mut self, scene: &Scene<'_>, profile: &Profile, local: Vec2) -> usize {
        let at = scene.at(profile.link, local);
        let near = 1e-7 * assur_solve::solve::extent(&scene.model);
        let there =
            self.nodes.iter().position(|n| n.links.contains(&profile.link) && (n.at - at).norm() <= near);
        let named =
            scene.mechanism().link(profile.link).points.iter().find(|p| (p.at - local).norm() <= near);
        let name = named.map_or(profile.name.as_str(), |p| p.name.as_str());
        there.unwrap_or_else(|| self.add(scene, name, vec![profile.link], at))
    }

    fn add(&mut self, scene: &Scene<'_>, name: &str, links: Vec<LinkId>, at: Vec2) -> usize {
        let fixed = links.contains(&LinkId::GROUND);
        let link = links.iter().copied().find(|l| *l != LinkId::GROUND).unwrap_or(LinkId::GROUND);
        let rank = links.iter().map(|l| rank(scene, *l)).min().unwrap_or(0);
        self.nodes.push(Node { name: name.to_owned(), sub: None, link, at, links, fixed, rank });
        self.nodes.len() - 1
    }

    fn slide(&mut self, scene: &Scene<'_>, (pair, name): (PairId, &str), g: &Guide) {
        if !scene.is_placed(g.slider) || !scene.is_placed(g.guide) {
            return;
        }
        let at = scene.at(g.slider, g.point);
        let near = 1e-7 * assur_solve::solve::extent(&scene.model);
        let there = self.nodes.iter().position(|n| n.links.contains(&g.slider) && (n.at - at).norm() <= near);
        let name = if g.point_name.is_empty() { name } else { &g.point_name };
        let slider = there.unwrap_or_else(|| self.add(scene, name, vec![g.slider], at));
        if g.guide == LinkId::GROUND || g.slider == LinkId::GROUND || !scene.slides(pair) {
            return;
        }
        let name = self.nodes[slider].name.clone();
        self.nodes[slider].sub = Some(scene.link_label(g.slider).to_owned());
        let guide = self.add(scene, &name, vec![g.guide], at);
        self.nodes[guide].sub = Some(scene.link_label(g.guide).to_owned());
        self.sliding.push(Sliding { slider, guide });
    }

    /// Vectors of all points that links name: what a plan must have room for.
    pub fn extent(scene: &Scene<'_>, of: fn(&BodyState, Vec2) -> Vec2) -> Vec<Vec2> {
        let links = scene.mechanism().links.iter().enumerate().skip(1);
        let links = links.map(|(i, link)| (LinkId::at(i), link));
        let placed = links.filter(|(id, _)| scene.is_placed(*id) && !scene.is_in_cylinder(*id));
        placed
            .flat_map(|(id, link)| link.points.iter().map(move |p| of(scene.body(id), scene.at(id, p.at))))
            .collect()
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

pub fn acceleration(body: &BodyState, at: Vec2) -> Vec2 {
    let r = at - body.p;
    body.a + r.perp() * body.alpha - r * (body.omega * body.omega)
}
