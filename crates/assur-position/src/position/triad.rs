//! Runs triads: a link on three legs.

use super::motion::{Point, line, place, point, under};
use super::state::State;
use super::wrench::Reaction;
use crate::group::IterationLog;
use crate::group::general::Pose;
use crate::group::triad::{End, Followed, Triad, modes};
use crate::math::Vec2;
use crate::plan::{OuterJoint, TriadForceLeg, TriadForces, TriadHold, TriadLeg, TriadMotion};

impl State {
    /// Follows the link from where it stands.
    #[inline(never)]
    pub(super) fn triad<const LEVEL: u8>(
        &mut self,
        branch: usize,
        triad: &TriadMotion,
        small: f64,
        seen: &mut impl IterationLog,
    ) {
        let (before, now) = (self.triad_stands(triad), self.triad_ends(triad));
        match triad.plate.follow_seen((&before, &now), &self.triad_pose(triad), small, seen) {
            Some(found) => self.place_triad::<LEVEL>(branch, triad, &now, &found),
            None => {
                self.motion.open.get_or_insert(branch);
            }
        }
    }

    /// Puts the link into the assembly of the same sign that is nearest, over a gap. Whether there is one.
    pub fn triad_over_gap(&mut self, branch: usize, triad: &TriadMotion) -> bool {
        let (now, pose) = (self.triad_ends(triad), self.triad_pose(triad));
        let mut found = modes(&triad.plate, &now);
        found
            .retain(|m| triad.plate.group(&now, &m.pose).conditioning * self.motion.conditions[branch] > 0.0);
        let away = |m: &Followed| triad.plate.apart(&m.pose, &pose);
        let Some(nearest) = found.iter().min_by(|a, b| away(a).total_cmp(&away(b))) else { return false };
        self.place_triad::<0>(branch, triad, &now, nearest);
        true
    }

    /// What the legs depend on where the bases are now.
    pub fn triad_ends(&self, triad: &TriadMotion) -> [End; 3] {
        [0, 1, 2].map(|i| match &triad.legs[i] {
            TriadLeg::Link(leg) => {
                End::Hinge { p: point::<f64, 0>(&self.motion.bodies, &leg.base).p, length: leg.length }
            }
            TriadLeg::Slider { slide, offset, .. } => {
                let guide = line(&self.motion.bodies, slide);
                let n = guide.along.perp();
                End::Guide { p: guide.origin + n * *offset, n }
            }
        })
    }

    /// What the legs depend on as they stand.
    fn triad_stands(&self, triad: &TriadMotion) -> [End; 3] {
        [0, 1, 2].map(|i| match &triad.legs[i] {
            TriadLeg::Link(leg) => {
                End::Hinge { p: self.motion.bodies[leg.body].pin(&leg.pin).0, length: leg.length }
            }
            TriadLeg::Slider { slide, pin, .. } => {
                let slider = &self.motion.bodies[slide.body];
                End::Guide { p: slider.pin(pin).0, n: slide.direction.turned(slider.u).perp() }
            }
        })
    }

    pub(super) fn triad_pose(&self, triad: &TriadMotion) -> Pose {
        let body = &self.motion.bodies[triad.body];
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
        self.motion.conditions[branch] = group.conditioning;
        self.motion.certificates[branch] = found.h;
        let pins = group.arms.map(|arm| p + arm);
        let bases = [0, 1, 2].map(|i| match &triad.legs[i] {
            TriadLeg::Link(leg) => point::<f64, LEVEL>(&self.motion.bodies, &leg.base),
            TriadLeg::Slider { slide, .. } => under::<f64, LEVEL>(&self.motion.bodies, slide.base, pins[i]),
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
                        -2.0 * self.motion.bodies[slide.base].omega * group.d[i].cross(speeds[i])
                    }
                };
                group.d[i].dot(bases[i].a) + extra
            });
            (mean.a, alpha) = group.acceleration(omega, along);
        }
        place::<f64, LEVEL>(&mut self.motion.bodies[triad.body], &Some(triad.mean), mean, u, omega, alpha);
        for i in 0..3 {
            let (d, arm) = (group.d[i], group.arms[i]);
            let second = mean.a + arm.perp() * alpha - arm * (omega * omega) - bases[i].a;
            match &triad.legs[i] {
                TriadLeg::Link(leg) => {
                    let turn = d.cross(speeds[i]) / leg.length;
                    let turned = d.cross(second) / leg.length;
                    let direction = d.turned_back(leg.direction);
                    let body = &mut self.motion.bodies[leg.body];
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

    /// Reactions of a link on three legs; returns the condition figure.
    pub(super) fn force_triad(&mut self, triad: &TriadForces) -> f64 {
        let legs = [0, 1, 2].map(|i| self.leg_force(triad.body, &triad.legs[i]));
        let mean = (legs[0].at + legs[1].at + legs[2].at) * (1.0 / 3.0);
        let arms = [0, 1, 2].map(|i| legs[i].at - mean);
        let square = arms.iter().map(|arm| arm.dot(*arm)).sum::<f64>() / 3.0;
        let (force, moment) = self.load_about(triad.body, mean);
        let moment = legs.iter().fold(moment, |sum, leg| sum + leg.couple);
        let group = Triad::new(legs.map(|leg| leg.d), arms, square.sqrt().max(f64::MIN_POSITIVE));
        let got = group.reactions(force, moment, legs.map(|leg| leg.known));
        for (i, leg) in triad.legs.iter().enumerate() {
            let LegForce { place, load: (force, moment), couple, .. } = legs[i];
            match &leg.inner {
                TriadHold::Pin { slot, sign, .. } => {
                    self.forces.reactions[*slot] = Reaction { force: got[i] * *sign, couple: 0.0 };
                }
                TriadHold::Guide(guide) => {
                    let sign = if guide.body == triad.body { 1.0 } else { -1.0 };
                    self.way_reaction(guide, place, got[i] * sign, couple * sign);
                }
            }
            let on_leg = got[i] - force;
            match &leg.outer {
                OuterJoint::Hinge(hinge) => self.hinge_reaction(hinge, place, on_leg),
                OuterJoint::Guide(guide) => self.carried_way(guide, place, on_leg, -moment),
            }
        }
        group.conditioning
    }

    /// What a leg's own balance leaves of its force on the link.
    fn leg_force(&self, link: usize, leg: &TriadForceLeg) -> LegForce {
        let zero = Vec2::new(0.0, 0.0);
        let balanced = |place, load| LegForce { d: zero, at: zero, known: zero, couple: 0.0, place, load };
        match (&leg.outer, &leg.inner) {
            (OuterJoint::Hinge(hinge), TriadHold::Pin { link: at, direction, inverse, .. }) => {
                let (place, force, moment) = self.load_at(leg.body, &hinge.pin);
                let d = direction.turned(self.motion.bodies[leg.body].u);
                let (at, known) = (self.motion.bodies[link].position(*at), d.perp() * (moment * inverse));
                LegForce { d, at, known, ..balanced(place, (force, moment)) }
            }
            (OuterJoint::Hinge(hinge), TriadHold::Guide(guide)) => {
                let (place, force, moment) = self.load_at(leg.body, &hinge.pin);
                let d = self.direction(guide).perp();
                LegForce { d, at: place, couple: moment, ..balanced(place, (force, moment)) }
            }
            (OuterJoint::Guide(guide), TriadHold::Pin { leg: pin, link: at, .. }) => {
                let along = self.direction(guide);
                let (place, force, moment) = self.load_at(leg.body, pin);
                let (at, known) = (self.motion.bodies[link].position(*at), along * along.dot(force));
                LegForce { d: along.perp(), at, known, ..balanced(place, (force, moment)) }
            }
            // the plan makes no leg of two guides
            (OuterJoint::Guide(_), TriadHold::Guide(_)) => balanced(zero, (zero, 0.0)),
        }
    }
}

/// The force of a leg on the link: an unknown part along d through a point, a known force there and a known couple.
#[derive(Clone, Copy)]
struct LegForce {
    d: Vec2,
    at: Vec2,
    known: Vec2,
    couple: f64,
    /// Where the leg's loads are reduced to, with their force and moment.
    place: Vec2,
    load: (Vec2, f64),
}

/// All states in which a triad can stand.
pub fn assemblies(before: &State, branch: usize, triad: &TriadMotion) -> Vec<State> {
    let ends = before.triad_ends(triad);
    let each = modes(&triad.plate, &ends).into_iter().map(|mode| {
        let mut state = before.clone();
        state.motion.open = None;
        state.place_triad::<0>(branch, triad, &ends, &mode);
        state
    });
    each.collect()
}
