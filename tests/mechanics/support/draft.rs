//! A mechanism under construction: the poses of all links are known before the pairs are, so that every pair closes.

use crate::support::random::Random;
use assur::internals::math::Vec2;
use assur::internals::model::{
    Drive, DriveTarget, Expr, Guide, Hint, HintKind, Link, LinkId, Mechanism, Pair, PairId, PairKind, Pin,
    Positions, Profile, ProfileShape, Value,
};
use assur::internals::source::Span;

/// Where a link stands: the origin and the x axis of its frame.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub p: Vec2,
    pub u: Vec2,
}

impl Frame {
    pub const GROUND: Self = Self { p: Vec2::new(0.0, 0.0), u: Vec2::new(1.0, 0.0) };

    pub fn local(&self, place: Vec2) -> Vec2 {
        (place - self.p).turned_back(self.u)
    }

    pub fn place(&self, local: Vec2) -> Vec2 {
        self.p + local.turned(self.u)
    }
}

/// A group as it was put on: what the decomposition has to find again.
#[derive(Clone, Debug)]
pub struct Made {
    pub links: Vec<LinkId>,
    /// Kind as `Group::kind_name` prints it.
    pub kind: &'static str,
}

/// A place on a link that a group is hung on.
#[derive(Clone, Copy, Debug)]
pub struct Anchor {
    pub host: LinkId,
    pub at: Vec2,
    /// A pin that stands there already.
    pub pin: Option<PairId>,
}

#[derive(Clone, Debug)]
pub struct Draft {
    pub mechanism: Mechanism,
    pub frames: Vec<Frame>,
    pub made: Vec<Made>,
    pub random: Random,
    /// Links that turn alike have the same number.
    pub turning: Vec<usize>,
    /// Links that turn freely.
    pub rollers: Vec<LinkId>,
    /// Links driven at a point, with its place.
    pub outer: Vec<(LinkId, Vec2)>,
    /// Pairs whose coordinate is driven.
    pub driven: Vec<PairId>,
    /// The share of groups drawn near their dead positions.
    pub flat: f64,
    /// The share of groups that take a general step which are drawn as such; the others become dyads.
    pub general: f64,
}

impl Draft {
    pub fn new(random: Random) -> Self {
        let ground = Link { name: "ground".into(), ..Link::default() };
        Self {
            mechanism: Mechanism { links: vec![ground], ..Mechanism::default() },
            frames: vec![Frame::GROUND],
            made: Vec::new(),
            random,
            turning: vec![0],
            rollers: Vec::new(),
            outer: Vec::new(),
            driven: Vec::new(),
            flat: 0.0,
            general: 1.0,
        }
    }

    /// A place in the box that all mechanisms fill.
    pub fn spot(&mut self) -> Vec2 {
        self.random.vector(1.0)
    }

    /// A new link somewhere near a place, turned anyhow.
    pub fn link(&mut self, near: Vec2) -> LinkId {
        let frame = Frame { p: near + self.random.vector(0.3), u: self.random.direction() };
        self.link_at(frame)
    }

    pub fn link_at(&mut self, frame: Frame) -> LinkId {
        let id = LinkId::at(self.frames.len());
        self.frames.push(frame);
        self.turning.push(id.index());
        self.mechanism.links.push(Link { name: format!("link{}", id.0), ..Link::default() });
        id
    }

    pub fn frame(&self, link: LinkId) -> Frame {
        self.frames[link.index()]
    }

    pub fn local(&self, link: LinkId, place: Vec2) -> Vec2 {
        self.frame(link).local(place)
    }

    /// A direction in the frame of a link.
    pub fn axis(&self, link: LinkId, direction: Vec2) -> Vec2 {
        direction.turned_back(self.frame(link).u)
    }

    pub fn pair(&mut self, kind: PairKind) -> PairId {
        let id = PairId::at(self.mechanism.pairs.len());
        self.mechanism.pairs.push(Pair {
            name: format!("pair{}", id.0),
            span: Span::default(),
            kind,
            friction: None,
            bearing: None,
        });
        id
    }

    pub fn pin(&self, link: LinkId, at: Vec2) -> Pin {
        Pin { link, name: "P".into(), at: self.local(link, at) }
    }

    /// A revolute of two links, in either order.
    pub fn revolute(&mut self, a: LinkId, b: LinkId, at: Vec2) -> PairId {
        let mut pins = vec![self.pin(a, at), self.pin(b, at)];
        if self.random.chance(0.5) {
            pins.swap(0, 1);
        }
        self.pair(PairKind::Revolute(pins))
    }

    /// A revolute at an anchor: of its own, or one link more on the pin that stands there.
    pub fn hang(&mut self, anchor: Anchor, link: LinkId) {
        let Some(id) = anchor.pin else {
            self.revolute(anchor.host, link, anchor.at);
            return;
        };
        let pin = self.pin(link, anchor.at);
        if let PairKind::Revolute(pins) = &mut self.mechanism.pairs[id.index()].kind {
            let place = self.random.below(pins.len() + 1);
            pins.insert(place, pin);
        }
    }

    /// The line of `carrier` along `direction` through `point` of `slider`, with the origin somewhere on it.
    pub fn guide(&mut self, slider: LinkId, carrier: LinkId, point: Vec2, direction: Vec2) -> Guide {
        let through = point - direction * self.random.signed(0.1, 1.0);
        let a = self.random.within(-0.5, -0.05);
        let contacts = self.random.chance(0.3).then(|| [a, a + self.random.within(0.2, 0.6)]);
        Guide {
            slider,
            point_name: "P".into(),
            point: self.local(slider, point),
            direction: self.axis(slider, direction),
            own_line: None,
            guide: carrier,
            line_name: "l".into(),
            through: self.local(carrier, through),
            along: self.axis(carrier, direction),
            contacts,
            guide_first: self.random.chance(0.5),
        }
    }

    /// A prismatic pair along a direction between two links, either of which carries the line; `near` is a place of
    /// the sliding point.
    pub fn prismatic(&mut self, a: LinkId, b: LinkId, near: Vec2, direction: Vec2) -> PairId {
        let (slider, carrier) = if self.random.chance(0.6) { (a, b) } else { (b, a) };
        let point = if self.random.chance(0.4) { near } else { near + self.random.vector(0.4) };
        let direction = direction * self.random.sign();
        let guide = self.guide(slider, carrier, point, direction);
        let (from, to) = (self.turning[a.index()], self.turning[b.index()]);
        for turning in &mut self.turning {
            if *turning == from {
                *turning = to;
            }
        }
        self.pair(PairKind::Prismatic(guide))
    }

    pub fn slot(&mut self, slider: LinkId, carrier: LinkId, point: Vec2, direction: Vec2) -> PairId {
        let mut guide = self.guide(slider, carrier, point, direction);
        guide.contacts = None;
        self.pair(PairKind::Slot(guide))
    }

    pub fn round(&self, link: LinkId, centre: Vec2, radius: f64) -> Profile {
        let at = self.local(link, centre);
        let shape = if radius == 0.0 { ProfileShape::Point(at) } else { ProfileShape::Circle(at, radius) };
        Profile { link, name: "c".into(), shape }
    }

    pub fn straight(&mut self, link: LinkId, through: Vec2, direction: Vec2) -> Profile {
        let through = through + direction * self.random.within(-0.5, 0.5);
        let shape = ProfileShape::Line(self.local(link, through), self.axis(link, direction));
        Profile { link, name: "l".into(), shape }
    }

    pub fn contact(&mut self, a: Profile, b: Profile, internal: bool) -> PairId {
        let (first, second) = if self.random.chance(0.5) { (a, b) } else { (b, a) };
        self.pair(PairKind::Contact { first, second, internal, parts: false })
    }

    pub fn drive(&mut self, target: DriveTarget, value: f64) {
        let speed = self.random.signed(0.5, 3.0);
        let acceleration = self.random.chance(0.7).then(|| Expr::number(self.random.within(-5.0, 5.0)));
        if let DriveTarget::Pair(pair) = target {
            self.driven.push(pair);
        }
        self.mechanism.drives.push(Drive {
            name: format!("drive{}", self.mechanism.drives.len()),
            span: Span::default(),
            target,
            positions: Positions::List(vec![Expr::number(value)]),
            written: None,
            speed: Some(Expr::number(speed)),
            acceleration,
            sense: None,
            free: false,
            sought: None,
            of_time: false,
        });
    }

    /// A link that nothing is known of but the motion of one of its points.
    pub fn outer_link(&mut self) {
        let at = self.spot();
        let origin = at + self.random.vector(0.3);
        let link = self.link_at(Frame { p: origin, u: Vec2::new(1.0, 0.0) });
        self.outer.push((link, at));
        let target = DriveTarget::Point(link, self.local(link, at));
        self.drive(target, 0.0);
        let (speed, acceleration) = (self.random.vector(2.0), self.random.vector(4.0));
        let constant = |v| Expr::Constant(Value::Vector(v));
        if let Some(drive) = self.mechanism.drives.last_mut() {
            drive.positions = Positions::List(vec![constant(at)]);
            drive.speed = Some(constant(speed));
            drive.acceleration = Some(constant(acceleration));
        }
    }

    /// Chooses the assembly: every link is near the place where it was drawn.
    pub fn hints(&mut self) {
        for (i, frame) in self.frames.iter().enumerate().skip(1) {
            for at in [Vec2::zero(), Vec2::new(1.0, 0.0)] {
                let kind = HintKind::Near { point: (LinkId::at(i), at), place: frame.place(at) };
                self.mechanism.hints.push(Hint { span: Span::default(), kind });
            }
        }
    }
}
