//! The geometry of a pair of involute spur gears, external or internal, with profile shift.
//!
//! Formulas after Litvin and Fuentes, *Gear Geometry and Applied Theory*, chapters 10 and 11, in the terms of ISO 21771. Wheel 1 is
//! the pinion; of an internal pair wheel 2 is the ring. Lengths in m.
//!
//! - inv α_w = inv α + 2 (x₁ ± x₂)/(z₁ ± z₂) tan α, a = m (z₁ ± z₂)/2 · cos α/cos α_w (external +; internal z₂ − z₁, x₂ − x₁)
//! - tip circles keep the clearance c: external da = d + 2m (h* + x − k), k = x₁ + x₂ − (a − a₀)/m; internal
//!   da₂ = d₂ − 2m (h* − x₂), where nothing needs shortening
//! - ε = (z₁ (tan α_a1 − tan α_w) ± z₂ (tan α_a2 − tan α_w)) / 2π

use std::f64::consts::PI;

/// The standard basic rack: pressure angle, rad, addendum and clearance in modules.
pub const STANDARD_RACK: [f64; 3] = [20.0 * PI / 180.0, 1.0, 0.25];

/// What a pair is given by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Teeth {
    pub z: [f64; 2],
    /// Module, m.
    pub module: f64,
    /// Pressure angle of the basic rack, rad.
    pub pressure_angle: f64,
    pub addendum: f64,
    pub clearance: f64,
    /// Profile shifts in modules.
    pub shift: [f64; 2],
    /// The second wheel is a ring.
    pub internal: bool,
}

/// One wheel of a pair.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gear {
    /// Reference diameter, m.
    pub d: f64,
    /// Tip diameter, m.
    pub da: f64,
    /// Root diameter, m.
    pub df: f64,
    /// Base diameter, m.
    pub db: f64,
    /// Working pitch diameter, m.
    pub dw: f64,
    /// Tooth thickness on the reference circle, m.
    pub s: f64,
    /// Space width on the reference circle, m.
    pub e: f64,
    /// Tooth thickness on the tip circle, m; not positive where the tooth is pointed.
    pub sa: f64,
    /// Pressure angle on the tip circle, rad; not a number where that lies inside the base circle.
    pub alpha_a: f64,
    /// Way of the contact from the pitch point to the tip, m.
    pub approach: f64,
    /// Specific sliding at the lowest point of the active flank, 1 − the other's velocity along the flank over the own.
    pub slip: f64,
    /// Least profile shift without undercut by the rack; of a ring not a number.
    pub x_min: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearPair {
    /// What it is given by.
    pub teeth: Teeth,
    pub gears: [Gear; 2],
    /// Centre distance, m.
    pub a: f64,
    /// Working pressure angle, rad.
    pub alpha_w: f64,
    /// Pitch, m.
    pub p: f64,
    /// Base pitch, m.
    pub pb: f64,
    /// Clearance, m.
    pub c: f64,
    /// Length of contact, m.
    pub g: f64,
    pub ratio: f64,
    /// Number of teeth without undercut at no shift.
    pub z_min: f64,
}

/// The shifts are so negative that the flanks never meet: the involute of the working pressure angle would be this.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoMesh(pub f64);

impl GearPair {
    /// The geometry of a pair. Of an internal pair the ring must have more teeth than the pinion.
    ///
    /// # Errors
    /// The shifts leave no working pressure angle.
    pub fn new(teeth: Teeth) -> Result<Self, NoMesh> {
        let Teeth { z, module: m, pressure_angle: alpha, addendum, clearance, shift: x, internal } = teeth;
        let sign = if internal { -1.0 } else { 1.0 };
        // z₂ ± z₁ and x₂ ± x₁
        let (z_sum, x_sum) = (z[1] + sign * z[0], x[1] + sign * x[0]);
        let (sin, cos) = libm::sincos(alpha);
        let inv = involute(alpha) + 2.0 * x_sum / z_sum * libm::tan(alpha);
        let alpha_w = if x_sum == 0.0 { alpha } else { inverse_involute(inv).ok_or(NoMesh(inv))? };
        let stretch = if x_sum == 0.0 { 1.0 } else { cos / libm::cos(alpha_w) };
        let a = 0.5 * m * z_sum * stretch;
        // what the tips of an external pair are shortened by, in modules
        let short = if internal { 0.0 } else { x_sum - 0.5 * z_sum * (stretch - 1.0) };
        let gear = |i: usize| {
            let ring = internal && i == 1;
            let out = if ring { -1.0 } else { 1.0 };
            let d = m * z[i];
            let da = d + 2.0 * m * (out * addendum + x[i] - short);
            let db = d * cos;
            let s = m * (0.5 * PI + out * 2.0 * x[i] * libm::tan(alpha));
            let tan_a = ((da - db) * (da + db)).sqrt() / db;
            let alpha_a = libm::atan(tan_a);
            let bend = out * (involute(alpha) - involute(alpha_a));
            Gear {
                d,
                da,
                df: d - 2.0 * m * (out * (addendum + clearance) - x[i]),
                db,
                dw: d * stretch,
                s,
                e: PI * m - s,
                sa: da * (s / d + bend),
                alpha_a,
                approach: out * 0.5 * db * (tan_a - libm::tan(alpha_w)),
                slip: f64::NAN,
                x_min: if ring { f64::NAN } else { addendum - 0.5 * z[i] * sin * sin },
            }
        };
        let mut gears = [gear(0), gear(1)];
        let g = gears[0].approach + gears[1].approach;
        let pb = PI * m * cos;
        let mut pair = Self {
            teeth,
            gears,
            a,
            alpha_w,
            p: PI * m,
            pb,
            c: clearance * m,
            g,
            ratio: g / pb,
            z_min: 2.0 * addendum / (sin * sin),
        };
        for (i, gear) in gears.iter_mut().enumerate() {
            let [own, other] = pair.lowest(i);
            gear.slip = 1.0 - other * z[i] / (own * z[1 - i]);
        }
        pair.gears = gears;
        Ok(pair)
    }

    /// Radii of curvature of both flanks where the tip of the other wheel touches wheel `i`, own one first, m.
    #[must_use]
    pub fn lowest(&self, i: usize) -> [f64; 2] {
        let [mine, other] = [&self.gears[i], &self.gears[1 - i]];
        let to_pitch = |g: &Gear| 0.5 * g.db * libm::tan(self.alpha_w);
        // the pinion's flanks are less curved towards its tip, those of a ring towards its root
        let ring = |k: usize| if self.teeth.internal && k == 1 { -1.0 } else { 1.0 };
        [to_pitch(mine) - ring(i) * other.approach, to_pitch(other) + ring(1 - i) * other.approach]
    }

    /// Velocity of sliding over the angular velocity of wheel 1 where the tip of wheel `i` touches, m/rad: the way from the
    /// pitch point times (1 ± z₁/z₂).
    #[must_use]
    pub fn sliding(&self, i: usize) -> f64 {
        let [z_1, z_2] = self.teeth.z;
        let relative = if self.teeth.internal { 1.0 - z_1 / z_2 } else { 1.0 + z_1 / z_2 };
        self.gears[i].approach * relative
    }

    /// Tooth forces over the torque on wheel 1: along the pitch circle, towards the axis, along the line of contact, 1/m.
    #[must_use]
    pub fn forces(&self) -> [f64; 3] {
        let tangential = 2.0 / self.gears[0].dw;
        [tangential, tangential * libm::tan(self.alpha_w), 2.0 / self.gears[0].db]
    }
}

// The involute function inv α = tan α − α and its inverse.

/// Beyond this angle tan α − α loses nothing, rad.
const DIRECT: f64 = 1.0;

/// inv α = tan α − α, rad, accurate for small angles too: tan α − α = (sin α − α cos α) / cos α with the series
/// sin α − α cos α = Σ (−1)ⁿ⁺¹ 2n α²ⁿ⁺¹ / (2n + 1)!.
#[must_use]
pub fn involute(alpha: f64) -> f64 {
    if alpha.abs() > DIRECT {
        return libm::tan(alpha) - alpha;
    }
    let square = alpha * alpha;
    // αⁿ/n! with its sign, n = 2k + 1
    let (mut power, mut sum, mut n) = (alpha, 0.0, 1.0);
    for _ in 0..12 {
        power *= -square / ((n + 1.0) * (n + 2.0));
        n += 2.0;
        sum -= power * (n - 1.0);
    }
    sum / libm::cos(alpha)
}

/// The angle in [0, π/2) whose involute is `value`; `None` where that is negative or not finite.
///
/// Newton's method from above, d(inv α)/dα = tan² α; started at the root of the leading term it converges monotonically.
#[must_use]
pub fn inverse_involute(value: f64) -> Option<f64> {
    if !(value >= 0.0 && value.is_finite()) {
        return None;
    }
    if value == 0.0 {
        return Some(0.0);
    }
    // inv α ≥ α³/3, and α < π/2
    let mut alpha = libm::cbrt(3.0 * value).min(std::f64::consts::FRAC_PI_2 - 1.0 / (value + 2.0));
    for _ in 0..100 {
        let tan = libm::tan(alpha);
        let step = (involute(alpha) - value) / (tan * tan);
        alpha -= step;
        if step.abs() <= 2.0 * f64::EPSILON * alpha {
            break;
        }
    }
    Some(alpha)
}

// Whether the teeth of a pair run together.

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
