//! Puts structural groups of all kinds on a mechanism under construction. Every place is drawn until the group is far
//! from its dead positions.

mod contacts;

use crate::support::draft::{Anchor, Draft, Frame, Made};
use assur::internals::math::Vec2;
use assur::internals::model::{DriveTarget, LinkId, PairId, PairKind};

/// The least condition figure a group is drawn with.
const MARGIN: f64 = 0.35;
const TRIES: usize = 400;

fn sine(a: Vec2, b: Vec2) -> f64 {
    (a.cross(b) / (a.norm() * b.norm())).abs()
}

fn cosine(a: Vec2, b: Vec2) -> f64 {
    (a.dot(b) / (a.norm() * b.norm())).abs()
}

impl Draft {
    /// A link to hang something on: late ones are preferred, so that chains get long.
    fn host(&mut self) -> LinkId {
        let n = self.frames.len();
        loop {
            let from = if self.random.chance(0.6) { n.saturating_sub(4) } else { 0 };
            let host = LinkId::at(from + self.random.below(n - from));
            let outer = self.outer.iter().any(|o| o.0 == host);
            if !outer && !self.rollers.contains(&host) {
                return host;
            }
        }
    }

    fn anchor(&mut self) -> Anchor {
        if !self.outer.is_empty() && self.random.chance(0.6) {
            let (host, at) = self.outer[self.random.below(self.outer.len())];
            return Anchor { host, at, pin: None };
        }
        if self.random.chance(0.15) {
            let pairs: Vec<usize> = (0..self.mechanism.pairs.len())
                .filter(|&i| {
                    matches!(self.mechanism.pairs[i].kind, PairKind::Revolute(_))
                        && !self.driven.contains(&PairId::at(i))
                })
                .collect();
            if !pairs.is_empty() {
                let id = pairs[self.random.below(pairs.len())];
                if let PairKind::Revolute(pins) = &self.mechanism.pairs[id].kind {
                    let pin = pins.iter().find(|p| !self.rollers.contains(&p.link)).unwrap_or(&pins[0]);
                    let at = self.frame(pin.link).place(pin.at);
                    return Anchor { host: pin.link, at, pin: Some(PairId::at(id)) };
                }
            }
        }
        Anchor { host: self.host(), at: self.spot(), pin: None }
    }

    /// Draws until what is drawn passes.
    fn draw<T>(&mut self, mut make: impl FnMut(&mut Self) -> Option<T>) -> Option<T> {
        (0..TRIES).find_map(|_| make(self))
    }

    fn made(&mut self, links: Vec<LinkId>, kind: &'static str) {
        self.made.push(Made { links, kind });
    }

    pub fn add_crank(&mut self) -> Option<()> {
        let a = self.anchor();
        let link = self.link(a.at);
        self.hang(a, link);
        let u = self.frame(link).u;
        self.drive(DriveTarget::Link(link), u.angle());
        self.made(vec![link], "driven");
        Some(())
    }

    /// A link driven against its base, at a pin of its own.
    pub fn add_elbow(&mut self) -> Option<()> {
        let (host, at) = (self.host(), self.spot());
        let link = self.link(at);
        let pair = self.revolute(host, link, at);
        let value = self.coordinate(pair);
        self.drive(DriveTarget::Pair(pair), value);
        self.made(vec![link], "driven");
        Some(())
    }

    pub fn add_driven_slider(&mut self) -> Option<()> {
        let (host, at, d) = (self.host(), self.spot(), self.random.direction());
        let link = self.link(at);
        let pair = self.prismatic(link, host, at, d);
        let value = self.coordinate(pair);
        self.drive(DriveTarget::Pair(pair), value);
        self.made(vec![link], "driven");
        Some(())
    }

    /// Coordinate of a pair as it stands: the difference of angles, or the place along the line.
    pub fn coordinate(&self, pair: PairId) -> f64 {
        match &self.mechanism.pair(pair).kind {
            PairKind::Revolute(pins) => {
                let (a, b) = (self.frame(pins[0].link).u, self.frame(pins[1].link).u);
                b.turned_back(a).angle()
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => {
                let (s, c) = (self.frame(g.slider), self.frame(g.guide));
                (s.place(g.point) - c.place(g.through)).dot(g.along.turned(c.u))
            }
            PairKind::Cylinder { from, to, .. } => {
                (self.frame(to.link).place(to.at) - self.frame(from.link).place(from.at)).norm()
            }
            PairKind::Contact { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => f64::NAN,
        }
    }

    /// Now and then the condition figure that the next group is drawn with: anything down to rounding.
    fn near_dead(&mut self) -> Option<f64> {
        if self.flat <= 0.0 || !self.random.chance(self.flat) {
            return None;
        }
        Some(libm::exp10(self.random.within(-16.0, -0.5)))
    }

    fn triangle(&mut self) -> Option<(Anchor, Anchor, Vec2)> {
        if let Some(height) = self.near_dead() {
            let (a, b) = self.draw(|d| {
                let (a, b) = (d.anchor(), d.anchor());
                ((a.at - b.at).norm() > 0.2).then_some((a, b))
            })?;
            // between the pins: stretched; beyond one of them: folded
            let (along, across) = (self.random.within(-1.0, 2.0), height * self.random.sign());
            let r = b.at - a.at;
            let c = a.at + r * along + r.perp() * across;
            let far = (c - a.at).norm() > 0.05 && (c - b.at).norm() > 0.05;
            return far.then_some((a, b, c));
        }
        self.draw(|d| {
            let (a, b, c) = (d.anchor(), d.anchor(), d.spot());
            let far = (c - a.at).norm() > 0.3 && (c - b.at).norm() > 0.3 && (a.at - b.at).norm() > 0.2;
            (far && sine(c - a.at, c - b.at) > MARGIN).then_some((a, b, c))
        })
    }

    pub fn add_rrr(&mut self) -> Option<()> {
        let (a, b, c) = self.triangle()?;
        let links = [self.link(a.at), self.link(b.at)];
        self.hang(a, links[0]);
        self.hang(b, links[1]);
        self.revolute(links[0], links[1], c);
        self.made(links.to_vec(), "RRR");
        Some(())
    }

    pub fn add_rrp(&mut self) -> Option<()> {
        let (a, c, d) = self.leg_and_line()?;
        let host = self.host();
        let links = [self.link(a.at), self.link(c)];
        self.hang(a, links[0]);
        self.revolute(links[0], links[1], c);
        self.prismatic(links[1], host, c, d);
        self.made(links.to_vec(), "RRP");
        Some(())
    }

    /// A direction across another but for a small angle.
    fn across(&mut self, r: Vec2, angle: f64) -> Vec2 {
        let u = r / r.norm();
        let d = u.perp() + u * (angle * self.random.sign());
        d / d.norm()
    }

    fn leg_and_line(&mut self) -> Option<(Anchor, Vec2, Vec2)> {
        if let Some(angle) = self.near_dead() {
            let (a, c) = (self.anchor(), self.spot());
            let d = self.across(c - a.at, angle);
            return ((c - a.at).norm() > 0.05).then_some((a, c, d));
        }
        self.draw(|x| {
            let (a, c, d) = (x.anchor(), x.spot(), x.random.direction());
            ((c - a.at).norm() > 0.3 && cosine(c - a.at, d) > MARGIN).then_some((a, c, d))
        })
    }

    fn two_pins_and_line(&mut self) -> Option<(Anchor, Anchor, Vec2)> {
        if let Some(angle) = self.near_dead() {
            let (a, b) = (self.anchor(), self.anchor());
            let d = self.across(b.at - a.at, angle);
            return ((b.at - a.at).norm() > 0.05).then_some((a, b, d));
        }
        self.draw(|x| {
            let (a, b, d) = (x.anchor(), x.anchor(), x.random.direction());
            ((b.at - a.at).norm() > 0.3 && cosine(b.at - a.at, d) > MARGIN).then_some((a, b, d))
        })
    }

    pub fn add_rpr(&mut self) -> Option<()> {
        let (a, b, d) = self.two_pins_and_line()?;
        let links = [self.link(a.at), self.link(b.at)];
        self.hang(a, links[0]);
        self.hang(b, links[1]);
        self.prismatic(links[0], links[1], b.at, d);
        self.made(links.to_vec(), "RPR");
        Some(())
    }

    /// A cylinder that nothing drives.
    pub fn add_cylinder(&mut self) -> Option<()> {
        let (a, b) = self.draw(|x| {
            let (a, b) = ((x.host(), x.spot()), (x.host(), x.spot()));
            (a.0 != b.0 && (a.1 - b.1).norm() > 0.3).then_some((a, b))
        })?;
        let (barrel, rod, _) = self.cylinder(a, b);
        self.made(vec![barrel, rod], "RPR");
        Some(())
    }

    fn cylinder(&mut self, from: (LinkId, Vec2), to: (LinkId, Vec2)) -> (LinkId, LinkId, PairId) {
        let along = (to.1 - from.1) / (to.1 - from.1).norm();
        let barrel = self.link_at(Frame { p: from.1, u: along });
        let rod = self.link_at(Frame { p: to.1, u: along });
        let (from, to) = (self.pin(from.0, from.1), self.pin(to.0, to.1));
        let turning = self.turning[barrel.index()];
        self.turning[rod.index()] = turning;
        let pair = self.pair(PairKind::Cylinder { barrel, rod, from, to });
        (barrel, rod, pair)
    }

    /// Two lines that cross well.
    fn two_lines(&mut self) -> Option<(Vec2, Vec2)> {
        if let Some(angle) = self.near_dead() {
            let d = self.random.direction();
            let e = self.across(d.perp(), angle);
            return Some((d, e));
        }
        self.draw(|x| {
            let (d, e) = (x.random.direction(), x.random.direction());
            (sine(d, e) > MARGIN).then_some((d, e))
        })
    }

    pub fn add_prp(&mut self) -> Option<()> {
        let ((d, e), c) = (self.two_lines()?, self.spot());
        let hosts = [self.host(), self.host()];
        let links = [self.link(c), self.link(c)];
        self.prismatic(links[0], hosts[0], c, d);
        self.prismatic(links[1], hosts[1], c, e);
        self.revolute(links[0], links[1], c);
        self.made(links.to_vec(), "PRP");
        Some(())
    }

    pub fn add_rpp(&mut self) -> Option<()> {
        let ((d, e), a, c) = (self.two_lines()?, self.anchor(), self.spot());
        let host = self.host();
        let links = [self.link(a.at), self.link(c)];
        self.hang(a, links[0]);
        self.prismatic(links[0], links[1], c, d);
        self.prismatic(links[1], host, c, e);
        self.made(links.to_vec(), "RPP");
        Some(())
    }

    /// A link between two guides whose links turn alike.
    pub fn add_wedge(&mut self) -> Option<()> {
        let (d, e) = self.two_lines()?;
        let hosts = self.draw(|x| {
            let hosts = [x.host(), x.host()];
            let alike = x.turning[hosts[0].index()] == x.turning[hosts[1].index()];
            (alike && hosts[0] != hosts[1]).then_some(hosts)
        })?;
        let c = self.spot();
        let link = self.link(c);
        self.prismatic(link, hosts[0], c, d);
        self.prismatic(link, hosts[1], c, e);
        self.made(vec![link], "PP");
        Some(())
    }

    /// A link on a revolute with a pin in a slot, the slot on either.
    pub fn add_slot(&mut self) -> Option<()> {
        if self.random.chance(0.5) {
            let (a, c, d) = self.leg_and_line()?;
            let host = self.host();
            let link = self.link(a.at);
            self.hang(a, link);
            self.slot(link, host, c, d);
            self.made(vec![link], "RRP");
        } else {
            let (a, b, d) = self.two_pins_and_line()?;
            let link = self.link(a.at);
            self.hang(a, link);
            self.slot(b.host, link, b.at, d);
            self.made(vec![link], "RPR");
        }
        Some(())
    }
}
