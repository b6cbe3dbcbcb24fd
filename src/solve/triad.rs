//! Runs triads: a link on three legs.

use super::motion::{Point, line, place, point, under};
use super::state::{Reaction, State};
use crate::group::general::Pose;
use crate::group::triad::{End, Followed, Triad, modes};
use crate::math::Vec2;
use crate::plan::{OuterJoint, TriadForces, TriadLeg, TriadMotion};

impl State {
    /// Follows the link from where it stands.
    #[inline(never)]
    pub(super) fn triad<const LEVEL: u8>(&mut self, branch: usize, triad: &TriadMotion, small: f64) {
        let (before, now) = (self.triad_stands(triad), self.triad_ends(triad));
        match triad.plate.follow(&before, &now, &self.triad_pose(triad), small) {
            Some(found) => self.place_triad::<LEVEL>(branch, triad, &now, &found),
            None => {
                self.open.get_or_insert(branch);
            }
        }
    }

    /// Puts the link into the assembly of the same sign that is nearest, over a gap. Whether there is one.
    pub(super) fn triad_over_gap(&mut self, branch: usize, triad: &TriadMotion) -> bool {
        let (now, pose) = (self.triad_ends(triad), self.triad_pose(triad));
        let mut found = modes(&triad.plate, &now);
        found.retain(|m| triad.plate.group(&now, &m.pose).sine * self.sines[branch] > 0.0);
        let away = |m: &Followed| triad.plate.apart(&m.pose, &pose);
        let Some(nearest) = found.iter().min_by(|a, b| away(a).total_cmp(&away(b))) else { return false };
        self.place_triad::<0>(branch, triad, &now, nearest);
        true
    }

    /// What the legs hang on where the bases are now.
    pub(super) fn triad_ends(&self, triad: &TriadMotion) -> [End; 3] {
        [0, 1, 2].map(|i| match &triad.legs[i] {
            TriadLeg::Link(leg) => {
                End::Hinge { p: point::<f64, 0>(&self.bodies, &leg.base).p, length: leg.length }
            }
            TriadLeg::Slider { slide, offset, .. } => {
                let guide = line(&self.bodies, slide);
                let n = guide.along.perp();
                End::Guide { p: guide.origin + n * *offset, n }
            }
        })
    }

    /// What the legs hang on as they stand.
    fn triad_stands(&self, triad: &TriadMotion) -> [End; 3] {
        [0, 1, 2].map(|i| match &triad.legs[i] {
            TriadLeg::Link(leg) => {
                End::Hinge { p: self.bodies[leg.body].pin(&leg.pin).0, length: leg.length }
            }
            TriadLeg::Slider { slide, pin, .. } => {
                let slider = &self.bodies[slide.body];
                End::Guide { p: slider.pin(pin).0, n: slide.direction.turned(slider.u).perp() }
            }
        })
    }

    fn triad_pose(&self, triad: &TriadMotion) -> Pose {
        let body = &self.bodies[triad.body];
        Pose { p: body.position(triad.mean), u: body.u }
    }

    #[inline(always)]
    fn place_triad<const LEVEL: u8>(
        &mut self,
        branch: usize,
        triad: &TriadMotion,
        ends: &[End; 3],
        found: &Followed,
    ) {
        let Pose { p, u } = found.pose;
        let group = triad.plate.group(ends, &found.pose);
        self.sines[branch] = group.sine;
        self.certificates[branch] = found.h;
        let pins = group.arms.map(|arm| p + arm);
        let bases = [0, 1, 2].map(|i| match &triad.legs[i] {
            TriadLeg::Link(leg) => point::<f64, LEVEL>(&self.bodies, &leg.base),
            TriadLeg::Slider { slide, .. } => under::<f64, LEVEL>(&self.bodies, slide.base, pins[i]),
        });
        let zero = Vec2::new(0.0, 0.0);
        let mut mean = Point { p, v: zero, a: zero };
        let (mut omega, mut alpha) = (0.0, 0.0);
        if LEVEL > 0 {
            (mean.v, omega) = group.velocity([0, 1, 2].map(|i| group.d[i].dot(bases[i].v)));
        }
        let speeds = [0, 1, 2].map(|i| mean.v + group.arms[i].perp() * omega - bases[i].v);
        if LEVEL > 1 {
            let along = [0, 1, 2].map(|i| {
                let extra = match &triad.legs[i] {
                    TriadLeg::Link(leg) => -speeds[i].dot(speeds[i]) / leg.length,
                    TriadLeg::Slider { slide, .. } => {
                        -2.0 * self.bodies[slide.base].omega * group.d[i].cross(speeds[i])
                    }
                };
                group.d[i].dot(bases[i].a) + extra
            });
            (mean.a, alpha) = group.acceleration(omega, along);
        }
        place::<f64, LEVEL>(&mut self.bodies[triad.body], &Some(triad.mean), mean, u, omega, alpha);
        for i in 0..3 {
            let (d, arm) = (group.d[i], group.arms[i]);
            let second = mean.a + arm.perp() * alpha - arm * (omega * omega) - bases[i].a;
            match &triad.legs[i] {
                TriadLeg::Link(leg) => {
                    let turn = d.cross(speeds[i]) / leg.length;
                    let turned = d.cross(second) / leg.length;
                    let direction = d.turned_back(leg.direction);
                    let body = &mut self.bodies[leg.body];
                    place::<f64, LEVEL>(body, &leg.pin, bases[i], direction, turn, turned);
                }
                TriadLeg::Slider { slide, pin, .. } => {
                    let along = -d.perp();
                    let (speed, change) = (along.dot(speeds[i]), along.dot(second));
                    self.place_slider::<LEVEL>(slide, along, pin, pins[i], speed, change);
                }
            }
        }
    }

    /// Reactions of a triad; returns the condition figure.
    pub(super) fn force_triad(&mut self, triad: &TriadForces) -> f64 {
        let body = &self.bodies[triad.body];
        let (mean, arms) = (body.position(triad.mean), triad.plate.arms.map(|arm| arm.turned(body.u)));
        let (force, moment) = self.load_about(triad.body, mean);
        let zero = Vec2::new(0.0, 0.0);
        let (mut d, mut known, mut places, mut loads) = ([zero; 3], [zero; 3], [zero; 3], [(zero, 0.0); 3]);
        for (i, leg) in triad.legs.iter().enumerate() {
            match &leg.outer {
                OuterJoint::Hinge(hinge) => {
                    let (place, force, moment) = self.load_at(leg.body, &hinge.pin);
                    (places[i], loads[i]) = (place, (force, moment));
                    d[i] = leg.direction.turned(self.bodies[leg.body].u);
                    known[i] = d[i].perp() * (loads[i].1 * leg.inverse);
                }
                OuterJoint::Way(way) => {
                    let along = self.direction(way);
                    let (place, force, moment) = self.load_at(leg.body, &leg.pin);
                    (places[i], loads[i]) = (place, (force, moment));
                    d[i] = along.perp();
                    known[i] = along * along.dot(loads[i].0);
                }
            }
        }
        let group = Triad::new(d, arms, triad.plate.length);
        let got = group.reactions(force, moment, known);
        for (i, leg) in triad.legs.iter().enumerate() {
            let on_leg = got[i] - loads[i].0;
            self.reactions[leg.slot] = Reaction { force: got[i] * leg.sign, couple: 0.0 };
            match &leg.outer {
                OuterJoint::Hinge(hinge) => self.hinge_reaction(hinge, places[i], on_leg),
                OuterJoint::Way(way) => self.carried_way(way, places[i], on_leg, -loads[i].1),
            }
        }
        group.sine
    }
}

/// All states in which a triad can stand.
pub(super) fn assemblies(before: &State, branch: usize, triad: &TriadMotion) -> Vec<State> {
    let ends = before.triad_ends(triad);
    let each = modes(&triad.plate, &ends).into_iter().map(|mode| {
        let mut state = before.clone();
        state.open = None;
        state.place_triad::<0>(branch, triad, &ends, &mode);
        state
    });
    each.collect()
}
