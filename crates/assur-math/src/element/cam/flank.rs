//! Flanks: stretches of the cam's turn over which the lift only rises, or only falls, and the cam angle at a lift.
//!
//! On a flank the lift has one cam angle, which is found within the formula of the part that reaches the lift: by Newton's
//! method inside a bracket, which is halved where a step leaves it or gains too little.

use super::program::{Part, Program};

/// Steps of the search: halving alone needs as many as an angle has digits.
const STEPS: usize = 200;

/// A stretch of the turn on which the lift only rises, or only falls.
#[derive(Clone, Debug, PartialEq)]
pub struct Flank {
    /// Its parts, in the order of the cam angle; a flank may pass the end of the turn.
    parts: Vec<Part>,
    /// Lift at its begin and at its end, m or rad.
    pub lifts: [f64; 2],
    /// Whether a dwell lies before its begin, and after its end.
    pub dwells: [bool; 2],
}

/// The cam angle at a lift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reached {
    /// Here, rad.
    At(f64),
    /// Anywhere in the dwell next to the flank.
    Dwell,
    /// Nowhere on the flank.
    Beyond,
}

impl Flank {
    pub(super) fn new(parts: Vec<Part>, lifts: [f64; 2], dwells: [bool; 2]) -> Self {
        Self { parts, lifts, dwells }
    }

    /// Puts the flank behind another one that it goes on from.
    pub(super) fn after(self, mut before: Self) -> Self {
        before.parts.extend(self.parts);
        Self {
            parts: before.parts,
            lifts: [before.lifts[0], self.lifts[1]],
            dwells: [before.dwells[0], self.dwells[1]],
        }
    }

    /// Whether the lift rises.
    #[must_use]
    pub fn rises(&self) -> bool {
        self.lifts[1] > self.lifts[0]
    }

    /// Cam angles at its begin and its end, rad.
    #[must_use]
    pub fn angles(&self) -> [f64; 2] {
        let end = |part: Option<&Part>, of: fn(&Part) -> f64| part.map_or(f64::NAN, of);
        [end(self.parts.first(), |p| p.from), end(self.parts.last(), |p| p.to)]
    }

    /// The cam angle at a lift, which is known to `near`.
    #[must_use]
    pub fn reached(&self, program: &Program, lift: f64, near: f64) -> Reached {
        let angles = self.angles();
        for end in [0, 1] {
            if (lift - self.lifts[end]).abs() <= near {
                return if self.dwells[end] { Reached::Dwell } else { Reached::At(angles[end]) };
            }
        }
        let sign = if self.rises() { 1.0 } else { -1.0 };
        let inside = sign * (lift - self.lifts[0]) > 0.0 && sign * (self.lifts[1] - lift) > 0.0;
        if !inside {
            return Reached::Beyond;
        }
        let before = |part: &Part| sign * (program.on_part(part, part.to)[0] - lift) < 0.0;
        let Some(part) = self.parts.get(self.parts.partition_point(before)).or(self.parts.last()) else {
            return Reached::Beyond;
        };
        Reached::At(angle_on(program, part, lift, sign))
    }
}

/// The cam angle on a part that reaches the lift.
fn angle_on(program: &Program, part: &Part, lift: f64, sign: f64) -> f64 {
    let (mut low, mut high) = (part.from, part.to);
    let mut phi = 0.5 * (low + high);
    let mut last = high - low;
    for _ in 0..STEPS {
        let [s, slope, ..] = program.on_part(part, phi);
        let off = sign * (s - lift);
        if off == 0.0 {
            return phi;
        }
        if off < 0.0 {
            low = phi;
        } else {
            high = phi;
        }
        let newton = phi - (s - lift) / slope;
        let gains = (newton - phi).abs() <= 0.5 * last.abs();
        let next = if gains && newton > low && newton < high { newton } else { 0.5 * (low + high) };
        last = next - phi;
        if next == phi || next <= low || next >= high {
            return next;
        }
        phi = next;
    }
    phi
}
