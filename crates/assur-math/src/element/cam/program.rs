//! The motion of a follower over one turn of its cam: phases one after the other.

use super::flank::Flank;
use super::law::{Jet, Law};
use crate::math::{Angular, Scalar};
use std::f64::consts::TAU;

/// Angles nearer than this are one, rad.
const NEAR: f64 = 1e-12;

/// A part of the cam's turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// Cam angle at which it begins, rad.
    pub start: f64,
    /// Angle the cam turns meanwhile, rad, > 0.
    pub angle: f64,
    /// Lift at its begin, m or rad.
    pub from: f64,
    /// Change of the lift, m or rad: positive for a rise, zero for a dwell.
    pub change: f64,
    pub law: Law,
}

/// A part of the turn over which one formula holds, ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    phase: usize,
    /// The part of its law.
    part: usize,
    /// Cam angle at its begin, rad.
    pub from: f64,
    /// Cam angle at its end, rad.
    pub to: f64,
}

impl Part {
    /// A cam angle in the turn in which it is nearest to the middle of the part, rad.
    #[must_use]
    pub fn near(&self, phi: f64) -> f64 {
        let middle = 0.5 * (self.from + self.to);
        phi - TAU * ((phi - middle) / TAU).round()
    }
}

/// The motion over one turn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    phases: Vec<Phase>,
}

impl Program {
    /// A motion that begins at lift zero; what is left of the turn is a dwell. Each phase is given by its angle, the change
    /// of the lift and its law.
    #[must_use]
    pub fn new(given: &[(f64, f64, Law)]) -> Self {
        Self::from_lift(0.0, given)
    }

    /// The same from another lift.
    #[must_use]
    pub fn from_lift(lift: f64, given: &[(f64, f64, Law)]) -> Self {
        let mut phases = Vec::with_capacity(given.len() + 1);
        let (mut start, mut from) = (0.0, lift);
        for &(angle, change, law) in given {
            phases.push(Phase { start, angle, from, change, law });
            start += angle;
            from += change;
        }
        if start < TAU - NEAR {
            phases.push(Phase { start, angle: TAU - start, from, change: 0.0, law: Law::Dwell });
        }
        Self { phases }
    }

    /// The phases, that which is left of the turn among them.
    #[must_use]
    pub fn phases(&self) -> &[Phase] {
        &self.phases
    }

    /// The greatest lift, m or rad.
    #[must_use]
    pub fn greatest_lift(&self) -> f64 {
        self.phases.iter().fold(0.0, |h, p| f64::max(h, p.lifts().1))
    }

    /// The least lift with the cam angle where it is, rad: that of the first phase unless a spline swings below.
    #[must_use]
    pub fn least_lift(&self) -> (f64, f64) {
        let each = self.phases.iter().map(|p| p.lifts().0);
        each.fold((0.0, f64::INFINITY), |least, here| if here.1 < least.1 { here } else { least })
    }

    /// Lift s and its derivatives s′, s″, s‴ by the cam angle (m, m/rad, … or rad), at any cam angle φ, rad. Where two
    /// phases meet, those of the later one.
    #[must_use]
    pub fn at(&self, phi: f64) -> Jet {
        let phi = wrapped(phi);
        let index = self.phases.partition_point(|p| p.start <= phi + NEAR);
        let Some(phase) = self.phases.get(index.saturating_sub(1)) else { return [0.0; 4] };
        phase.scaled(phase.law.at(((phi - phase.start) / phase.angle).clamp(0.0, 1.0)))
    }

    /// [`Program::at`] for any number, by the formula that holds at the nearest `f64`.
    #[must_use]
    pub fn at_any<S: Angular>(&self, phi: S) -> [S; 4] {
        let near = wrapped(phi.nearest());
        let turns = S::of(((phi.nearest() - near) / TAU).round());
        let index = self.phases.partition_point(|p| p.start <= near + NEAR);
        let Some(phase) = self.phases.get(index.saturating_sub(1)) else { return [S::zero(); 4] };
        let part = phase.law.part_at(((near - phase.start) / phase.angle).clamp(0.0, 1.0));
        let way = phi - turns * S::of(2.0) * S::pi() - S::of(phase.start);
        let x = (way / S::of(phase.angle)).max(S::zero()).min(S::one());
        phase.scaled(phase.law.on_part(part, x))
    }

    /// The same by the formula of a part, which holds at both its ends.
    #[must_use]
    pub fn on_part(&self, part: &Part, phi: f64) -> Jet {
        let phase = &self.phases[part.phase];
        phase.scaled(phase.law.on_part(part.part, ((phi - phase.start) / phase.angle).clamp(0.0, 1.0)))
    }

    /// The same beyond its ends too, the part being that of its turn which is nearest.
    #[must_use]
    pub fn beyond(&self, part: &Part, phi: f64) -> Jet {
        let phase = &self.phases[part.phase];
        phase.scaled(phase.law.on_part(part.part, (part.near(phi) - phase.start) / phase.angle))
    }

    /// The part whose formula holds at a cam angle, rad; where two meet, the later one.
    #[must_use]
    pub fn part_at(&self, phi: f64) -> Option<Part> {
        let phi = wrapped(phi);
        self.parts().take_while(|part| part.from <= phi + NEAR).last()
    }

    /// The part whose formula holds next to a cam angle, rad: where two meet, the earlier one if the cam turns back.
    #[must_use]
    pub fn part_towards(&self, phi: f64, back: bool) -> Option<Part> {
        let part = self.part_at(phi)?;
        let begins = part.near(phi) <= part.from + NEAR;
        if back && begins { self.beside(&part, false) } else { Some(part) }
    }

    /// The part after another one, or before it.
    #[must_use]
    pub fn beside(&self, part: &Part, after: bool) -> Option<Part> {
        let place = self.parts().position(|p| p == *part)?;
        let count = self.parts().count();
        self.parts().nth(if after { (place + 1) % count } else { (place + count - 1) % count })
    }

    /// The parts over which one formula holds, in order.
    pub fn parts(&self) -> impl Iterator<Item = Part> + '_ {
        self.phases.iter().enumerate().flat_map(|(phase, p)| {
            let joints = p.law.joints();
            (0..joints.len() - 1).map(move |part| Part {
                phase,
                part,
                from: p.start + joints[part] * p.angle,
                to: p.start + joints[part + 1] * p.angle,
            })
        })
    }

    /// The flanks in the order of the cam angle; one that passes the end of the turn comes last.
    #[must_use]
    pub fn flanks(&self) -> Vec<Flank> {
        let still = 1e-12 * self.phases.iter().fold(0.0, |h, p| f64::max(h, p.from.abs()));
        let mut flanks: Vec<Flank> = Vec::new();
        let (mut dwells, mut begins_with_dwell) = (false, false);
        let mut first = true;
        for part in self.parts().flat_map(|part| self.without_turns(part)) {
            let lifts = [part.from, part.to].map(|phi| self.on_part(&part, phi)[0]);
            let rest = self.phases[part.phase].law == Law::Dwell || (lifts[1] - lifts[0]).abs() <= still;
            if rest {
                // a spline may turn back within rounding
                if part.to - part.from > NEAR.sqrt() {
                    if let Some(last) = flanks.last_mut().filter(|_| !dwells) {
                        last.dwells[1] = true;
                    }
                    (dwells, begins_with_dwell) = (true, begins_with_dwell || first);
                }
            } else {
                let flank = Flank::new(vec![part], lifts, [dwells, false]);
                match flanks.pop() {
                    Some(last) if !dwells && last.rises() == flank.rises() => flanks.push(flank.after(last)),
                    last => flanks.extend(last.into_iter().chain([flank])),
                }
                dwells = false;
            }
            first = false;
        }
        self.close(flanks, dwells, begins_with_dwell)
    }

    /// Joins the flanks over the end of the turn.
    fn close(&self, mut flanks: Vec<Flank>, ends_with_dwell: bool, begins_with_dwell: bool) -> Vec<Flank> {
        let dwells = ends_with_dwell || begins_with_dwell;
        if let (Some(last), true) = (flanks.last_mut(), dwells) {
            last.dwells[1] = true;
        }
        if let (Some(first), true) = (flanks.first_mut(), dwells) {
            first.dwells[0] = true;
        }
        let goes_on = flanks.len() > 1 && !dwells && flanks[0].rises() == flanks[flanks.len() - 1].rises();
        if goes_on && let Some(last) = flanks.pop() {
            let first = flanks.remove(0);
            flanks.push(first.after(last));
        }
        flanks
    }

    /// A part cut where its spline turns from rising to falling or back.
    fn without_turns(&self, part: Part) -> Vec<Part> {
        let phase = &self.phases[part.phase];
        let mut ends: Vec<f64> = phase.turns().map(|x| phase.start + x * phase.angle).collect();
        ends.sort_by(f64::total_cmp);
        ends.push(part.to);
        let mut from = part.from;
        let cut = ends.into_iter().map(|to| Part { from: std::mem::replace(&mut from, to), to, ..part });
        cut.collect()
    }

    /// Cam angles where the velocity jumps, with s′ before and after.
    #[must_use]
    pub fn shocks(&self) -> Vec<(f64, f64, f64)> {
        let count = self.phases.len();
        let scale = self.phases.iter().fold(0.0, |h, p| f64::max(h, (p.change / p.angle).abs()));
        (0..count)
            .filter_map(|i| {
                let (before, behind) = (&self.phases[(i + count - 1) % count], &self.phases[i]);
                let v = (before.scaled(before.law.at(1.0))[1], behind.scaled(behind.law.at(0.0))[1]);
                ((v.1 - v.0).abs() > 1e-9 * scale).then_some((behind.start, v.0, v.1))
            })
            .collect()
    }
}

impl Phase {
    /// The least lift with its cam angle, and the greatest lift.
    fn lifts(&self) -> ((f64, f64), f64) {
        let to = self.from + self.change;
        let mut places = vec![(self.start, self.from), (self.start + self.angle, to)];
        if let Law::Spline([a, b, c]) = self.law {
            let inside = self.turns();
            places
                .extend(inside.map(|x| (self.start + x * self.angle, self.from + x * (a + x * (b + x * c)))));
        }
        let least = places.iter().copied().fold((0.0, f64::INFINITY), |m, p| if p.1 < m.1 { p } else { m });
        (least, places.iter().fold(f64::NEG_INFINITY, |m, p| m.max(p.1)))
    }

    /// Where within the phase its spline turns from rising to falling or back, as parts of its angle.
    fn turns(&self) -> impl Iterator<Item = f64> {
        let roots = match self.law {
            Law::Spline([a, b, c]) => {
                // a + 2 b x + 3 c x² = 0, both roots without cancellation
                let root = (b * b - 3.0 * a * c).sqrt();
                let q = -(b + root.copysign(b));
                [q / (3.0 * c), a / q]
            }
            _ => [f64::NAN; 2],
        };
        roots.into_iter().filter(|x| *x > 0.0 && *x < 1.0)
    }

    /// The way of the law in units of the follower, per radian of the cam.
    fn scaled<S: Scalar>(&self, [s, v, a, j]: [S; 4]) -> [S; 4] {
        let way = if matches!(self.law, Law::Spline(_)) { 1.0 } else { self.change };
        let (h, b) = (S::of(way), S::one() / S::of(self.angle));
        [S::of(self.from) + h * s, h * b * v, h * b * b * a, h * b * b * b * j]
    }
}

/// An angle in [0, one turn), rad.
fn wrapped(phi: f64) -> f64 {
    let turn = libm::fmod(phi, TAU);
    let turn = if turn < 0.0 { turn + TAU } else { turn };
    if turn >= TAU - NEAR { 0.0 } else { turn }
}
