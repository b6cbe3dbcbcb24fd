//! Whether the teeth of a pair run together.

use super::involute::involute;
use super::pair::GearPair;

/// What is wrong with a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GearFault {
    /// The rack cuts into the flank: the shift is less than the least one.
    Undercut {
        /// Which wheel, 0 or 1.
        wheel: usize,
        shift: f64,
        /// The least shift without undercut.
        least: f64,
    },
    /// The flanks of a tooth meet below the tip circle: its thickness there would be this, m.
    Pointed {
        /// Which wheel, 0 or 1.
        wheel: usize,
        /// Thickness, m.
        thickness: f64,
    },
    /// A pair of teeth parts before the next one meets.
    Gap { ratio: f64 },
    /// The tip of the other wheel reaches below the involute of this one: radius of curvature where it touches, and where the
    /// involute begins, m.
    Tip {
        /// The wheel whose flank is met, 0 or 1.
        wheel: usize,
        /// Radius of curvature that the other tip reaches, m.
        reached: f64,
        /// Radius of curvature at which the involute begins, m.
        begin: f64,
    },
    /// The tip circle of a ring lies inside its base circle: diameters, m.
    RingTip {
        /// Tip diameter, m.
        tip: f64,
        /// Base diameter, m.
        base: f64,
    },
    /// The tips of pinion and ring meet away from the line of contact: the gap between them is this angle of the pinion,
    /// rad, negative.
    Overlap {
        /// The gap, rad.
        gap: f64,
    },
}

const NEAR: f64 = 1e-12;

impl GearPair {
    /// All that is wrong with the pair.
    #[must_use]
    pub fn faults(&self) -> Vec<GearFault> {
        let mut found = Vec::new();
        for (wheel, gear) in self.gears.iter().enumerate() {
            let shift = self.teeth.shift[wheel];
            if shift < gear.x_min - NEAR {
                found.push(GearFault::Undercut { wheel, shift, least: gear.x_min });
            }
            if gear.sa <= 0.0 {
                found.push(GearFault::Pointed { wheel, thickness: gear.sa });
            }
        }
        let ring = self.gears[1];
        if self.teeth.internal && ring.da < ring.db {
            found.push(GearFault::RingTip { tip: ring.da, base: ring.db });
            return found;
        }
        found.extend([0, 1].into_iter().filter_map(|wheel| self.tip_reaches(wheel)));
        found.extend(self.overlap());
        if self.ratio < 1.0 {
            found.push(GearFault::Gap { ratio: self.ratio });
        }
        found
    }

    /// Whether the other tip meets a flank below its involute. Where the flank is undercut the rack has taken away what the
    /// tip would meet; the flanks of a ring end outside, at its root.
    fn tip_reaches(&self, wheel: usize) -> Option<GearFault> {
        let undercut = self.teeth.shift[wheel] < self.gears[wheel].x_min - NEAR;
        if self.teeth.internal && wheel == 1 || undercut {
            return None;
        }
        let sin = libm::sin(self.teeth.pressure_angle);
        let gear = &self.gears[wheel];
        let cut = (self.teeth.addendum - self.teeth.shift[wheel]) * self.teeth.module / sin;
        let begin = 0.5 * gear.d * sin - cut;
        let [reached, _] = self.lowest(wheel);
        (reached < begin - NEAR * gear.d).then_some(GearFault::Tip { wheel, reached, begin })
    }

    /// The gap between the tips of pinion and ring where their tip circles cross:
    /// z₁ (inv α_a1 + δ₁) − z₂ (inv α_a2 + δ₂) + (z₂ − z₁) inv α_w ≥ 0 with the angles δ of the crossing against the line
    /// of centres.
    fn overlap(&self) -> Option<GearFault> {
        let [one, two] = &self.gears;
        let (r_1, r_2, a) = (0.5 * one.da, 0.5 * two.da, self.a);
        if !self.teeth.internal || r_1 + a <= r_2 {
            return None;
        }
        let delta_1 = libm::acos(((r_2 * r_2 - r_1 * r_1 - a * a) / (2.0 * a * r_1)).clamp(-1.0, 1.0));
        let delta_2 = libm::acos(((r_2 * r_2 - r_1 * r_1 + a * a) / (2.0 * a * r_2)).clamp(-1.0, 1.0));
        let [z_1, z_2] = self.teeth.z;
        let gap = z_1 * (involute(one.alpha_a) + delta_1) - z_2 * (involute(two.alpha_a) + delta_2)
            + (z_2 - z_1) * involute(self.alpha_w);
        (gap < 0.0).then_some(GearFault::Overlap { gap: gap / z_1 })
    }
}
