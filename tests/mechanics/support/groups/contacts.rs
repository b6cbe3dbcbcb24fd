//! Contacts and slots of all shapes on a mechanism under construction, drawn as the groups are.

use super::sine;
use crate::support::draft::{Draft, Frame};
use assur::internals::math::Vec2;
use assur::internals::model::{DriveTarget, LinkId};

impl Draft {
    fn radius(&mut self) -> f64 {
        if self.random.chance(0.25) { 0.0 } else { self.random.within(0.05, 0.3) }
    }

    /// A link on a revolute that touches another with a round or straight profile.
    pub fn add_contact(&mut self) -> Option<()> {
        match self.random.below(3) {
            0 => {
                let (a, b, c) = self.triangle()?;
                let link = self.link(a.at);
                self.hang(a, link);
                self.round_on_round(link, b.host, c, b.at);
                self.made(vec![link], "RRR");
            }
            1 => {
                let (a, c, d) = self.leg_and_line()?;
                let host = self.host();
                let link = self.link(a.at);
                self.hang(a, link);
                self.round_on_straight(link, host, c, d);
                self.made(vec![link], "RRP");
            }
            _ => {
                let (a, b, d) = self.two_pins_and_line()?;
                let link = self.link(a.at);
                self.hang(a, link);
                self.round_on_straight(b.host, link, b.at, d);
                self.made(vec![link], "RPR");
            }
        }
        Some(())
    }

    /// A link on a guide with a pin in a slot or a contact.
    pub fn add_sliding_follower(&mut self) -> Option<()> {
        let (host, other) = (self.host(), self.host());
        match self.random.below(5) {
            0 | 1 => {
                let ((d, e), c) = (self.two_lines()?, self.spot());
                let link = self.link(c);
                self.prismatic(link, host, c, d);
                if self.random.chance(0.5) {
                    self.slot(link, other, c, e);
                } else {
                    self.round_on_straight(link, other, c, e);
                }
                self.made(vec![link], "PRP");
            }
            2 | 3 => {
                let ((d, e), c) = (self.two_lines()?, self.spot());
                let link = self.link(c);
                self.prismatic(link, host, c, d);
                if self.random.chance(0.5) {
                    self.slot(other, link, c, e);
                } else {
                    self.round_on_straight(other, link, c, e);
                }
                self.made(vec![link], "RPP");
            }
            _ => {
                let (a, c, d) = self.leg_and_line()?;
                let link = self.link(c);
                self.prismatic(link, host, c, d);
                self.round_on_round(link, a.host, c, a.at);
                self.made(vec![link], "RRP");
            }
        }
        Some(())
    }

    fn round_on_round(&mut self, a: LinkId, b: LinkId, centre_a: Vec2, centre_b: Vec2) {
        let distance = (centre_a - centre_b).norm();
        let internal = self.random.chance(0.3);
        let (small, great) = if internal {
            let small = self.radius();
            (small, small + distance)
        } else {
            let small = if self.random.chance(0.25) { 0.0 } else { distance * self.random.within(0.1, 0.9) };
            (small, distance - small)
        };
        let (one, two) = if self.random.chance(0.5) { (small, great) } else { (great, small) };
        let (one, two) = (self.round(a, centre_a, one), self.round(b, centre_b, two));
        self.contact(one, two, internal);
    }

    fn round_on_straight(&mut self, round: LinkId, straight: LinkId, centre: Vec2, direction: Vec2) {
        let radius = self.radius();
        let through = centre + direction.perp() * (radius * self.random.sign());
        let (one, two) = (self.round(round, centre, radius), self.straight(straight, through, direction));
        self.contact(one, two, false);
    }

    /// A follower with a roller that turns freely on it.
    pub fn add_roller(&mut self) -> Option<()> {
        let (a, b, c) = self.triangle()?;
        // the rotation of a passive link is set to zero
        let still = Frame { p: c + self.random.vector(0.3), u: Vec2::new(1.0, 0.0) };
        let (follower, roller) = (self.link(a.at), self.link_at(still));
        self.hang(a, follower);
        self.revolute(follower, roller, c);
        self.rollers.push(roller);
        if self.random.chance(0.5) {
            let r = (c - b.at).norm() * self.random.within(0.1, 0.9);
            let profiles = (self.round(roller, c, r), self.round(b.host, b.at, (c - b.at).norm() - r));
            self.contact(profiles.0, profiles.1, false);
        } else {
            let direction = (c - b.at).perp() / (c - b.at).norm();
            let r = self.random.within(0.05, 0.3);
            let through = c + direction.perp() * (r * self.random.sign());
            let profiles = (self.round(roller, c, r), self.straight(b.host, through, direction));
            self.contact(profiles.0, profiles.1, false);
        }
        self.made(vec![follower, roller], "general");
        Some(())
    }

    /// A link with three legs: class III.
    pub fn add_triad(&mut self) -> Option<()> {
        let (anchors, pins) = self.draw(|x| {
            let anchors = [x.anchor(), x.anchor(), x.anchor()];
            let pins = [x.spot(), x.spot(), x.spot()];
            let legs = [0, 1, 2].map(|i| pins[i] - anchors[i].at);
            let far = legs.iter().all(|l| l.norm() > 0.4)
                && (0..3).all(|i| (pins[i] - pins[(i + 1) % 3]).norm() > 0.4);
            let crossing = sine(legs[0], legs[1]) > 0.3;
            let share = (pins[1] - pins[0]).cross(legs[1]) / legs[0].cross(legs[1]);
            let pole = pins[0] + legs[0] * share;
            let arm = (pins[2] - pole).cross(legs[2]).abs() / legs[2].norm();
            (far && crossing && arm > 0.4 && (pins[2] - pole).norm() < 3.0).then_some((anchors, pins))
        })?;
        let plate = self.link(pins[0]);
        let mut links = vec![plate];
        let mut sliders = 0;
        for (anchor, pin) in anchors.into_iter().zip(pins) {
            let leg = self.link(anchor.at);
            links.push(leg);
            let driven = self.outer.iter().any(|o| o.0 == anchor.host);
            if driven || self.random.chance(0.75) {
                self.hang(anchor, leg);
            } else {
                // a slider that moves across the leg it stands for
                let d = (pin - anchor.at).perp() / (pin - anchor.at).norm();
                self.prismatic(leg, anchor.host, pin, d);
                sliders += 1;
            }
            self.revolute(plate, leg, pin);
        }
        // three sliders have no sextic
        self.made(links, if sliders < 3 { "triad" } else { "general" });
        Some(())
    }

    /// A dyad one link of which is a cylinder, or holds a driven elbow.
    pub fn add_driven_legs(&mut self) -> Option<()> {
        let cylinder = self.random.chance(0.6);
        let sliding = self.random.chance(0.3);
        let (a, b, c) = self.triangle()?;
        let far = self.link(b.at);
        let mut links = vec![far];
        if sliding {
            let d = (c - b.at).perp() / (c - b.at).norm();
            self.prismatic(far, b.host, c, d);
        } else {
            self.hang(b, far);
        }
        let target = if cylinder {
            let (barrel, rod, pair) = self.cylinder((a.host, a.at), (far, c));
            links.extend([barrel, rod]);
            pair
        } else {
            let bend = self.spot();
            let (near, middle) = (self.link(a.at), self.link(bend));
            self.hang(a, near);
            let elbow = self.revolute(near, middle, bend);
            self.revolute(middle, far, c);
            links.extend([near, middle]);
            elbow
        };
        let value = self.coordinate(target);
        self.drive(DriveTarget::Pair(target), value);
        self.made(links, "driven legs");
        Some(())
    }
}
