//! The same mechanism seen otherwise: its frame turned, shifted and mirrored, its lengths and masses scaled, its links and
//! pairs renamed and declared in another order.

use crate::support::reference::{number, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{
    BalanceKind, Comparison, DriveTarget, Expr, HintKind, Link, LinkId, LoadKind, Mechanism, Pair, PairId,
    PairKind, Place, Positions, ProfileShape, Query, Value,
};

/// What changes. Everything that moves in the ground is first mirrored at the x axis (where `mirror` is −1), then scaled,
/// turned and shifted; the moving links keep their frames, but for mirroring and scaling.
#[derive(Clone, Debug)]
pub struct Change {
    pub mirror: f64,
    pub length: f64,
    pub mass: f64,
    /// Angle by which the ground turns.
    pub turn: f64,
    pub shift: Vec2,
    /// New places of the links; the ground keeps the first.
    pub links: Vec<usize>,
    pub pairs: Vec<usize>,
    pub rename: bool,
}

impl Change {
    pub fn none(m: &Mechanism) -> Self {
        Self {
            mirror: 1.0,
            length: 1.0,
            mass: 1.0,
            turn: 0.0,
            shift: Vec2::zero(),
            links: (0..m.links.len()).collect(),
            pairs: (0..m.pairs.len()).collect(),
            rename: false,
        }
    }

    pub fn link(&self, id: LinkId) -> LinkId {
        LinkId::at(self.links[id.index()])
    }

    pub fn pair(&self, id: PairId) -> PairId {
        PairId::at(self.pairs[id.index()])
    }

    fn mirrored(&self, v: Vec2) -> Vec2 {
        Vec2::new(v.x, self.mirror * v.y)
    }

    /// A free vector in ground axes, without scale.
    pub fn free(&self, v: Vec2) -> Vec2 {
        self.mirrored(v).turned(Vec2::direction(self.turn))
    }

    /// A place in the ground.
    pub fn place(&self, p: Vec2) -> Vec2 {
        self.free(p) * self.length + self.shift
    }

    /// A point of a link in its frame.
    pub fn point(&self, link: LinkId, p: Vec2) -> Vec2 {
        if link == LinkId::GROUND { self.place(p) } else { self.mirrored(p) * self.length }
    }

    /// A direction in the frame of a link.
    fn direction(&self, link: LinkId, d: Vec2) -> Vec2 {
        if link == LinkId::GROUND { self.free(d) } else { self.mirrored(d) }
    }

    pub fn force(&self) -> f64 {
        self.mass * self.length
    }

    /// Factor of torques, with the sense.
    pub fn torque(&self) -> f64 {
        self.mirror * self.mass * self.length * self.length
    }

    /// What a revolute's coordinate, or a link's angle, gains from the turned ground.
    fn gain(&self, first: LinkId, second: LinkId) -> f64 {
        let of = |link| if link == LinkId::GROUND { 0.0 } else { self.turn };
        of(second) - of(first)
    }

    /// The changed mechanism.
    pub fn apply(&self, m: &Mechanism) -> Mechanism {
        let mut out = m.clone();
        for (i, link) in m.links.iter().enumerate() {
            out.links[self.links[i]] = self.changed_link(link);
        }
        for (i, pair) in m.pairs.iter().enumerate() {
            out.pairs[self.pairs[i]] = self.changed_pair(pair);
        }
        self.drives(m, &mut out);
        self.efforts(m, &mut out);
        out.hints.retain_mut(|hint| {
            let HintKind::Near { point, place } = &mut hint.kind else { return true };
            let old = point.0;
            *point = (self.link(old), self.point(old, point.1));
            *place = self.place(*place);
            // the angle of a free roller is zero, however the ground lies
            !crate::support::reference::rollers(m).contains(&old)
        });
        out
    }

    fn name(&self, name: &str) -> String {
        if self.rename && name != "ground" {
            format!("{}'", name.chars().rev().collect::<String>())
        } else {
            name.to_owned()
        }
    }

    fn changed_link(&self, link: &Link) -> Link {
        let mut link = link.clone();
        link.name = self.name(&link.name);
        if let Some(mass) = &mut link.mass {
            mass.mass *= self.mass;
            mass.centre = self.mirrored(mass.centre) * self.length;
            mass.inertia *= self.mass * self.length * self.length;
        }
        link
    }

    fn changed_pair(&self, pair: &Pair) -> Pair {
        let mut pair = pair.clone();
        pair.name = self.name(&pair.name);
        match &mut pair.kind {
            PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                for pin in pins {
                    pin.at = self.point(pin.link, pin.at);
                    pin.link = self.link(pin.link);
                }
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => {
                g.point = self.point(g.slider, g.point);
                g.direction = self.direction(g.slider, g.direction);
                g.through = self.point(g.guide, g.through);
                g.along = self.direction(g.guide, g.along);
                (g.slider, g.guide) = (self.link(g.slider), self.link(g.guide));
                g.contacts = g.contacts.map(|c| c.map(|x| x * self.length));
            }
            PairKind::Contact { first, second, .. } => {
                for profile in [first, second] {
                    let link = profile.link;
                    profile.shape = match profile.shape {
                        ProfileShape::Point(p) => ProfileShape::Point(self.point(link, p)),
                        ProfileShape::Circle(c, r) => {
                            ProfileShape::Circle(self.point(link, c), r * self.length)
                        }
                        ProfileShape::Line(p, d) => {
                            ProfileShape::Line(self.point(link, p), self.direction(link, d))
                        }
                        // cams are tested by themselves
                        rim @ ProfileShape::Rim(_) => rim,
                    };
                    profile.link = self.link(link);
                }
            }
            PairKind::Cylinder { barrel, rod, from, to } => {
                for pin in [from, to] {
                    pin.at = self.point(pin.link, pin.at);
                    pin.link = self.link(pin.link);
                }
                (*barrel, *rod) = (self.link(*barrel), self.link(*rod));
            }
            // trains have tests of their own
            PairKind::Transmission(_) => {}
        }
        pair
    }

    fn drives(&self, m: &Mechanism, out: &mut Mechanism) {
        for drive in &mut out.drives {
            let (factor, gain) = match drive.target {
                DriveTarget::Link(link) => (self.mirror, self.gain(LinkId::GROUND, link)),
                DriveTarget::Pair(pair) => match &m.pair(pair).kind {
                    PairKind::Revolute(pins) => (self.mirror, self.gain(pins[0].link, pins[1].link)),
                    _ => (self.length, 0.0),
                },
                DriveTarget::Point(..) | DriveTarget::Place(..) => (self.length, 0.0),
            };
            drive.target = match drive.target {
                DriveTarget::Link(link) => DriveTarget::Link(self.link(link)),
                DriveTarget::Pair(pair) => DriveTarget::Pair(self.pair(pair)),
                DriveTarget::Point(link, at) => DriveTarget::Point(self.link(link), self.point(link, at)),
                DriveTarget::Place(link, at, axis) => {
                    DriveTarget::Place(self.link(link), self.point(link, at), axis)
                }
            };
            if let Positions::List(list) = &mut drive.positions {
                for x in list {
                    *x = Expr::number(factor * number(x) + gain);
                }
            }
            for rate in [&mut drive.speed, &mut drive.acceleration].into_iter().flatten() {
                *rate = Expr::number(factor * number(rate));
            }
        }
    }

    fn at(&self, link: LinkId, place: &mut Place) {
        match place {
            Place::Local(p) => *p = self.point(link, *p),
            Place::Ground(expr) => *expr = constant(self.place(vector(expr))),
        }
    }

    fn in_axes(&self, frame: &mut Option<LinkId>, v: Vec2) -> Vec2 {
        let turned = self.direction(frame.unwrap_or(LinkId::GROUND), v);
        *frame = frame.map(|f| self.link(f));
        turned
    }

    /// Factor of an effort in a pair.
    pub fn in_pair(&self, m: &Mechanism, pair: PairId) -> f64 {
        if matches!(m.pair(pair).kind, PairKind::Revolute(_)) { self.torque() } else { self.force() }
    }

    fn efforts(&self, m: &Mechanism, out: &mut Mechanism) {
        if let Some(gravity) = &mut out.gravity {
            gravity.acceleration = self.free(gravity.acceleration) * self.length;
        }
        for load in &mut out.loads {
            match &mut load.kind {
                LoadKind::Force { on, at, value, frame } => {
                    self.at(*on, at);
                    *value = constant(self.in_axes(frame, vector(value)) * self.force());
                    *on = self.link(*on);
                }
                LoadKind::ForceAgainstMotion { on, at, value } => {
                    self.at(*on, at);
                    *value = Expr::number(number(value) * self.force());
                    *on = self.link(*on);
                }
                LoadKind::Torque { on, value, against_motion, .. } => {
                    let factor = if *against_motion { self.torque().abs() } else { self.torque() };
                    *value = Expr::number(number(value) * factor);
                    *on = self.link(*on);
                }
                LoadKind::InPair { pair, value, .. } => {
                    *value = Expr::number(number(value) * self.in_pair(m, *pair));
                    *pair = self.pair(*pair);
                }
            }
            if let Some(Expr::Compare(how, a, _)) = &mut load.when
                && let Expr::Query(Query::Omega(link)) = a.as_mut()
            {
                *link = self.link(*link);
                if self.mirror < 0.0 {
                    *how = Comparison::Less;
                }
            }
        }
        for spring in &mut out.springs {
            for end in [&mut spring.from, &mut spring.to] {
                *end = (self.link(end.0), self.point(end.0, end.1));
            }
            spring.stiffness *= self.mass;
            spring.damping *= self.mass;
            spring.free_length *= self.length;
        }
        for balance in &mut out.balances {
            self.balance(&mut balance.kind);
        }
    }
}

impl Change {
    fn balance(&self, kind: &mut BalanceKind) {
        match kind {
            BalanceKind::Torque(link) => *link = self.link(*link),
            BalanceKind::Force { on, at, along, frame } => {
                self.at(*on, at);
                *along = self.in_axes(frame, *along);
                *on = self.link(*on);
            }
            BalanceKind::InPair(pair) => *pair = self.pair(*pair),
            BalanceKind::Several(places) => places.iter_mut().for_each(|place| self.balance(place)),
        }
    }
}

fn constant(v: Vec2) -> Expr {
    Expr::Constant(Value::Vector(v))
}
