//! Lower pairs in place of higher ones, passive freedoms, and chains of prismatic pairs.
//!
//! A pin in a slot becomes an imaginary block hinged on the pin that slides along the slot; a contact of a circle with a
//! line the same, at the distance of the radius; a contact of two circles (or a circle and a point) an imaginary rod
//! between the centres. For circular and straight profiles the replacement holds for every position, not for one
//! instant only, because the curvature is constant.

use super::joint::{Body, BodyId, BodyOrigin, BodyRate, Joint, JointId, JointKind, Replaced};
use super::weld::Welds;
use crate::math::Vec2;
use crate::model::{
    DriveTarget, Guide, Law, LinkId, LoadKind, Mechanism, PairId, PairKind, Pin, Place, Profile,
    ProfileShape, Rate,
};

const X_AXIS: Vec2 = Vec2::new(1.0, 0.0);
const ORIGIN: Vec2 = Vec2::new(0.0, 0.0);

pub(super) fn replace(mechanism: &Mechanism) -> Replaced {
    let welds = Welds::of(mechanism);
    let is_part = |link: usize| matches!(welds.parts.get(link), Some(Some(_)));
    let mut replaced = Replaced {
        bodies: (0..mechanism.links.len())
            .map(|i| Body {
                origin: BodyOrigin::Link(LinkId::at(i)),
                known: i == 0 || is_part(i),
                on_rim: false,
            })
            .collect(),
        joints: Vec::new(),
        passive: passive_links(mechanism),
        parts: welds.parts,
        first_joint: vec![None; mechanism.pairs.len()],
    };
    welds.joints.into_iter().for_each(|joint| replaced.push(joint));
    for drive in &mechanism.drives {
        if let DriveTarget::Point(link, _) = drive.target {
            replaced.bodies[link.index()].known = true;
        }
    }
    let pairs = || mechanism.pairs.iter().enumerate().map(|(i, p)| (PairId::at(i), &p.kind));
    let is_law = |kind: &PairKind| matches!(kind, PairKind::Transmission(_));
    // laws speak of the joints of other pairs
    pairs().filter(|p| !is_law(p.1)).for_each(|(id, kind)| replaced.add_pair(id, kind));
    pairs().filter(|p| is_law(p.1)).for_each(|(id, kind)| replaced.add_pair(id, kind));
    // a designed cam moves the link that carries the roller; the roller turns on that link, and moves nothing
    for contact in &mechanism.cam_contacts {
        let Some((roller, _)) = contact.roller else { continue };
        let of_contact = replaced.joints.iter_mut().filter(|j| j.pair == contact.pair);
        for joint in of_contact {
            if let JointKind::Revolute(members) = &mut joint.kind
                && let Some(member) = members.iter_mut().find(|m| m.0.0 == roller.index())
            {
                *member = (BodyId(contact.follower.index()), contact.tip);
            }
        }
    }
    for block in &mut replaced.bodies {
        block.on_rim |= matches!(block.origin, BodyOrigin::Imaginary(pair) if mechanism.genevas.iter().any(|g| g.pair == pair));
    }
    mark_chains(&mut replaced);
    replaced
}

impl Replaced {
    pub(super) fn add_pair(&mut self, pair: PairId, kind: &PairKind) {
        match kind {
            PairKind::Revolute(pins) => {
                self.revolute(pair, pins.iter().map(|p| self.place(p.link, p.at)).collect());
            }
            PairKind::Prismatic(g) => {
                let direction = self.direction(g.slider, g.direction);
                self.slide(pair, self.place(g.slider, g.point), direction, g, 0.0);
            }
            PairKind::Slot(g) => self.block(pair, self.place(g.slider, g.point), g, 0.0),
            PairKind::Contact { parts: true, .. } => {}
            PairKind::Contact { first, second, internal, .. } => self.contact(pair, first, second, *internal),
            PairKind::Cylinder { barrel, rod, from, to } => self.cylinder(pair, *barrel, *rod, from, to),
            PairKind::Transmission(t) => t.laws.iter().for_each(|law| self.law(pair, law)),
            // its joints are there from the start
            PairKind::Weld { .. } => {}
        }
    }

    fn law(&mut self, pair: PairId, law: &Law) {
        let terms = law.terms.iter().filter_map(|(rate, coefficient)| {
            let rate = match rate {
                Rate::Turn(link) => BodyRate::Turn(self.body_of(*link)),
                Rate::Slide(pair) => BodyRate::Slide(self.slide_of(*pair)?),
            };
            Some((rate, *coefficient))
        });
        let kind = JointKind::Law(terms.collect());
        self.push(Joint { pair, kind });
    }

    /// The prismatic joint of a pair.
    fn slide_of(&self, pair: PairId) -> Option<JointId> {
        self.joints_of(pair).find(|j| matches!(self.joint(*j).kind, JointKind::Prismatic { .. }))
    }

    fn revolute(&mut self, pair: PairId, members: Vec<(BodyId, Vec2)>) {
        self.push(Joint { pair, kind: JointKind::Revolute(members) });
    }

    fn slide(
        &mut self,
        pair: PairId,
        (slider, point): (BodyId, Vec2),
        direction: Vec2,
        line: &Guide,
        offset: f64,
    ) {
        let (guide, through) = self.place(line.guide, line.through);
        self.push(Joint {
            pair,
            kind: JointKind::Prismatic {
                slider,
                point,
                direction,
                guide,
                through,
                along: self.direction(line.guide, line.along),
                offset,
                angle_redundant: false,
                in_chain: false,
            },
        });
    }

    fn imaginary(&mut self, pair: PairId) -> BodyId {
        self.bodies.push(Body { origin: BodyOrigin::Imaginary(pair), known: false, on_rim: false });
        BodyId(self.bodies.len() - 1)
    }

    /// An imaginary block hinged at `pin` that slides along the line at a distance from it.
    fn block(&mut self, pair: PairId, pin: (BodyId, Vec2), line: &Guide, offset: f64) {
        let block = self.imaginary(pair);
        self.revolute(pair, vec![pin, (block, ORIGIN)]);
        self.slide(pair, (block, ORIGIN), X_AXIS, line, offset);
    }

    /// An imaginary rod of the given length between two points.
    fn rod(&mut self, pair: PairId, from: (BodyId, Vec2), to: (BodyId, Vec2), length: f64) {
        let rod = self.imaginary(pair);
        self.revolute(pair, vec![from, (rod, ORIGIN)]);
        self.revolute(pair, vec![(rod, X_AXIS * length), to]);
    }

    fn contact(&mut self, pair: PairId, first: &Profile, second: &Profile, internal: bool) {
        let round = |shape: ProfileShape| match shape {
            ProfileShape::Point(p) => Some((p, 0.0)),
            ProfileShape::Circle(c, r) => Some((c, r)),
            ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
        };
        let cam = |p: &Profile| matches!(p.shape, ProfileShape::Rim(_));
        match (round(first.shape), round(second.shape)) {
            _ if cam(first) => self.follower(pair, first, second),
            _ if cam(second) => self.follower(pair, second, first),
            (Some((p_1, r_1)), Some((p_2, r_2))) => {
                let length = if internal { (r_1 - r_2).abs() } else { r_1 + r_2 };
                self.rod(pair, self.place(first.link, p_1), self.place(second.link, p_2), length);
            }
            (Some((p, r)), None) => self.block(pair, self.place(first.link, p), &line_of(second), r),
            (None, Some((p, r))) => self.block(pair, self.place(second.link, p), &line_of(first), r),
            // check refuses a contact of two lines
            (None, None) => {}
        }
    }

    /// A block that stands for the contact of a designed cam with its follower: hinged on the tip it slides along the
    /// cam's tangent, hinged on the cam's profile along the face. Tangent and place go along the profile with the cam's
    /// angle: the step of motion sets them, what stands here in the frame of the cam has no meaning.
    fn follower(&mut self, pair: PairId, cam: &Profile, follower: &Profile) {
        match follower.shape {
            ProfileShape::Point(tip) | ProfileShape::Circle(tip, _) => {
                self.block(pair, self.place(follower.link, tip), &line_of(cam), 0.0);
            }
            ProfileShape::Line(..) => self.block(pair, self.place(cam.link, X_AXIS), &line_of(follower), 0.0),
            // check refuses a contact of two cams
            ProfileShape::Rim(_) => {}
        }
        if let Some(block) = self.bodies.last_mut().filter(|b| b.origin == BodyOrigin::Imaginary(pair)) {
            block.on_rim = true;
        }
    }

    fn cylinder(&mut self, pair: PairId, barrel: LinkId, rod: LinkId, from: &Pin, to: &Pin) {
        let (barrel_body, rod_body) = (BodyId(barrel.index()), BodyId(rod.index()));
        self.revolute(pair, vec![self.place(from.link, from.at), (barrel_body, ORIGIN)]);
        let line = Guide {
            slider: rod,
            point_name: String::new(),
            point: ORIGIN,
            direction: X_AXIS,
            own_line: None,
            guide: barrel,
            line_name: String::new(),
            through: ORIGIN,
            along: X_AXIS,
            contacts: None,
            guide_first: false,
        };
        self.slide(pair, (rod_body, ORIGIN), X_AXIS, &line, 0.0);
        self.revolute(pair, vec![(rod_body, ORIGIN), self.place(to.link, to.at)]);
    }
}

fn line_of(profile: &Profile) -> Guide {
    let (through, along) = match profile.shape {
        ProfileShape::Line(through, along) => (through, along),
        ProfileShape::Point(p) | ProfileShape::Circle(p, _) => (p, X_AXIS),
        ProfileShape::Rim(_) => (ORIGIN, X_AXIS),
    };
    Guide {
        slider: profile.link,
        point_name: String::new(),
        point: ORIGIN,
        direction: X_AXIS,
        own_line: None,
        guide: profile.link,
        line_name: profile.name.clone(),
        through,
        along,
        contacts: None,
        guide_first: false,
    }
}

/// Links whose rotation changes nothing: one hinge, and otherwise only contacts of circles about that hinge.
fn passive_links(mechanism: &Mechanism) -> Vec<LinkId> {
    let driven = |link: LinkId| mechanism.drives.iter().any(|d| d.target == DriveTarget::Link(link));
    let round = mechanism.pairs.iter().flat_map(|pair| match &pair.kind {
        PairKind::Contact { first, second, .. } => vec![first, second],
        _ => Vec::new(),
    });
    let mut rollers: Vec<LinkId> = round
        .filter(|profile| matches!(profile.shape, ProfileShape::Circle(..)) && profile.link != LinkId::GROUND)
        .map(|profile| profile.link)
        .filter(|&link| !driven(link) && is_free_roller(mechanism, link))
        .collect();
    let particles = mechanism.drives.iter().filter_map(|drive| match drive.target {
        DriveTarget::Place(link, at, _) if !driven(link) && is_particle(mechanism, link, at) => Some(link),
        _ => None,
    });
    rollers.extend(particles);
    rollers.sort_unstable();
    rollers.dedup();
    rollers
}

/// Whether nothing is at a link but at this point of it, and nothing turns it.
fn is_particle(mechanism: &Mechanism, link: LinkId, at: Vec2) -> bool {
    let is_here = |(on, point): (LinkId, Vec2)| on != link || point == at;
    let masses =
        mechanism.link(link).mass.is_none_or(|m| m.inertia == 0.0 && (m.mass == 0.0 || m.centre == at));
    let pairs = mechanism.pairs.iter().all(|pair| match &pair.kind {
        PairKind::Revolute(pins) => pins.iter().all(|pin| is_here((pin.link, pin.at))),
        PairKind::Slot(guide) => guide.guide != link && is_here((guide.slider, guide.point)),
        PairKind::Contact { first, second, .. } => {
            [first, second].iter().all(|profile| match profile.shape {
                ProfileShape::Point(point) => is_here((profile.link, point)),
                _ => profile.link != link,
            })
        }
        kind => !kind.links().contains(&link),
    });
    let loads =
        mechanism.loads.iter().filter(|load| load.link() == Some(link)).all(|load| match &load.kind {
            LoadKind::Force { at: Place::Local(point), .. }
            | LoadKind::ForceAgainstMotion { at: Place::Local(point), .. } => *point == at,
            _ => false,
        });
    let springs = mechanism.springs.iter().all(|spring| is_here(spring.from) && is_here(spring.to));
    masses && pairs && loads && springs
}

fn is_free_roller(mechanism: &Mechanism, link: LinkId) -> bool {
    let mut hinge = None;
    let mut centres = Vec::new();
    for pair in &mechanism.pairs {
        if matches!(&pair.kind, PairKind::Cylinder { barrel, rod, .. } if [*barrel, *rod].contains(&link)) {
            return false;
        }
        if !pair.kind.links().contains(&link) {
            continue;
        }
        match &pair.kind {
            PairKind::Revolute(pins) if hinge.is_none() => {
                hinge = pins.iter().find(|p| p.link == link).map(|p| p.at);
            }
            PairKind::Contact { first, second, .. } => {
                for profile in [first, second] {
                    match profile.shape {
                        ProfileShape::Circle(c, _) if profile.link == link => centres.push(c),
                        _ if profile.link == link => return false,
                        _ => {}
                    }
                }
            }
            _ => return false,
        }
    }
    let Some(hinge) = hinge else { return false };
    !centres.is_empty() && centres.iter().all(|&c| c == hinge)
}

// Chains of prismatic joints: bodies that do not turn against each other.

/// A prismatic joint at the body whose list it is in, and the body on its other side.
type Edge = (usize, usize);

/// Marks prismatic joints whose condition on the angle follows from others (a spanning forest from the ground keeps
/// those nearest to it), and all that lie on a closed chain of prismatic joints.
pub(super) fn mark_chains(replaced: &mut Replaced) {
    let mut edges: Vec<Vec<Edge>> = vec![Vec::new(); replaced.bodies.len()];
    for (i, joint) in replaced.joints.iter().enumerate() {
        if let JointKind::Prismatic { slider, guide, .. } = joint.kind {
            edges[slider.0].push((i, guide.0));
            edges[guide.0].push((i, slider.0));
        }
    }
    let kept = spanning_forest(&edges, replaced.joints.len());
    let bridges = bridges(&edges, replaced.joints.len());
    for (i, joint) in replaced.joints.iter_mut().enumerate() {
        if let JointKind::Prismatic { angle_redundant, in_chain, .. } = &mut joint.kind {
            *angle_redundant = !kept[i];
            *in_chain = !bridges[i];
        }
    }
}

/// Which joints reach a body first, from the ground outwards.
fn spanning_forest(edges: &[Vec<Edge>], joints: usize) -> Vec<bool> {
    let mut seen = vec![false; edges.len()];
    let mut kept = vec![false; joints];
    for root in 0..edges.len() {
        if std::mem::replace(&mut seen[root], true) {
            continue;
        }
        let mut queue = std::collections::VecDeque::from([root]);
        while let Some(at) = queue.pop_front() {
            for &(joint, next) in &edges[at] {
                if !std::mem::replace(&mut seen[next], true) {
                    kept[joint] = true;
                    queue.push_back(next);
                }
            }
        }
    }
    kept
}

/// Which joints lie on no closed chain: without one of them its bodies do not hang together (Tarjan, without recursion).
fn bridges(edges: &[Vec<Edge>], joints: usize) -> Vec<bool> {
    const NEW: usize = usize::MAX;
    let (mut index, mut low) = (vec![NEW; edges.len()], vec![NEW; edges.len()]);
    let mut found = vec![false; joints];
    let mut next = 0;
    for root in 0..edges.len() {
        if index[root] != NEW {
            continue;
        }
        // body, the joint it was reached by, how many of its joints are done
        let mut path = vec![(root, NEW, 0)];
        while let Some((at, by, done)) = path.pop() {
            if done == 0 {
                (index[at], low[at]) = (next, next);
                next += 1;
            }
            if let Some(&(joint, other)) = edges[at].get(done) {
                path.push((at, by, done + 1));
                if index[other] == NEW {
                    path.push((other, joint, 0));
                } else if joint != by {
                    low[at] = low[at].min(index[other]);
                }
            } else if let Some(&(before, ..)) = path.last() {
                found[by] = low[at] == index[at];
                low[before] = low[before].min(low[at]);
            }
        }
    }
    found
}
