//! Directions of angles side by side, with the bits of one angle alone.

use super::together::{F64x8, WIDTH};
use crate::math::{V2, Vec2};

/// 2⁵² · 1.5: added to a number, its last bits hold the nearest whole one.
const TO_WHOLE: f64 = 6_755_399_441_055_744.0;
/// 2/π.
const QUARTERS: f64 = std::f64::consts::FRAC_2_PI;
/// The first 33 bits of π/2, and what is left of it.
const QUARTER: [f64; 2] = [f64::from_bits(0x3ff9_21fb_5440_0000), f64::from_bits(0x3dd0_b461_1a62_6331)];
/// Sine of an angle below π/4, less the angle: by powers of its square. As libm has them.
const SINE: [u64; 6] = [
    0xbfc5_5555_5555_5549,
    0x3f81_1111_1110_f8a6,
    0xbf2a_01a0_19c1_61d5,
    0x3ec7_1de3_57b1_fe7d,
    0xbe5a_e5e6_8a2b_9ceb,
    0x3de5_d93a_5acf_d57c,
];
/// The cosine, less 1 and half of the square.
const COSINE: [u64; 6] = [
    0x3fa5_5555_5555_554c,
    0xbf56_c16c_16c1_5177,
    0x3efa_01a0_19cb_1590,
    0xbe92_7e4f_809c_52ad,
    0x3e21_ee9e_bdb4_b1c4,
    0xbda8_fae9_be88_38d4,
];
/// Angles nearer to one half of a quarter than this, in quarters, may belong to either side of it.
const BETWEEN: f64 = 1e-5;
/// Angles nearer to whole quarters than this share of them take more digits of π.
const CANCELS: f64 = 1.0 / 32_768.0;
/// Sine and angle may be the same below.
const SMALL: f64 = 1e-7;
/// Beyond, in quarters, more digits of π are needed.
const LARGE: f64 = 1e6;

/// The directions: the operations of `libm::sincos` in its order where they are those of most angles, and itself for the others.
#[cfg_attr(in_one, inline(always))]
#[must_use]
pub fn directions(angles: F64x8) -> V2<F64x8> {
    let (mut cos, mut sin, mut plain) = ([0.0; WIDTH], [0.0; WIDTH], true);
    for lane in 0..WIDTH {
        let one = direction(angles.0[lane]);
        (cos[lane], sin[lane]) = (one.0, one.1);
        plain &= one.2;
    }
    if !plain {
        for lane in 0..WIDTH {
            let u = Vec2::direction(angles.0[lane]);
            (cos[lane], sin[lane]) = (u.x, u.y);
        }
    }
    V2 { x: crate::math::Lanes(cos), y: crate::math::Lanes(sin) }
}

/// Cosine and sine, and whether they are those of an angle as most are.
#[inline(always)]
fn direction(x: f64) -> (f64, f64, bool) {
    let quarters = x * QUARTERS;
    let shifted = quarters + TO_WHOLE;
    let whole = shifted - TO_WHOLE;
    let beside = (quarters - whole).abs();
    let plain = (beside < 0.5 - BETWEEN)
        & (beside > CANCELS * quarters.abs())
        & (quarters.abs() < LARGE)
        & (x.abs() > SMALL);
    // the angle less whole quarters, and the rounding error of that
    let (first, rest) = (x - whole * QUARTER[0], whole * QUARTER[1]);
    let y = first - rest;
    let error = (first - y) - rest;
    let (s, c) = (sine(y, error, whole == 0.0), cosine(y, error));
    // 1 in the last bit: sine and cosine change places; the next bit: both change their signs
    let number = shifted.to_bits();
    let swapped = (number & 1).wrapping_neg();
    let (a, b) = (s.to_bits(), c.to_bits());
    let change = (a ^ b) & swapped;
    let turned = (number & 2) << 62;
    let mirrored = turned ^ ((number & 1) << 63);
    (f64::from_bits(b ^ change ^ mirrored), f64::from_bits(a ^ change ^ turned), plain)
}

#[inline(always)]
fn sine(x: f64, error: f64, exact: bool) -> f64 {
    let [s_1, s_2, s_3, s_4, s_5, s_6] = SINE.map(f64::from_bits);
    let z = x * x;
    let w = z * z;
    let r = s_2 + z * (s_3 + z * s_4) + z * w * (s_5 + z * s_6);
    let v = z * x;
    let (alone, with_error) = (x + v * (s_1 + z * r), x - ((z * (0.5 * error - v * r) - error) - v * s_1));
    if exact { alone } else { with_error }
}

#[inline(always)]
fn cosine(x: f64, error: f64) -> f64 {
    let [c_1, c_2, c_3, c_4, c_5, c_6] = COSINE.map(f64::from_bits);
    let z = x * x;
    let w = z * z;
    let r = z * (c_1 + z * (c_2 + z * c_3)) + w * w * (c_4 + z * (c_5 + z * c_6));
    let half = 0.5 * z;
    let near = 1.0 - half;
    near + (((1.0 - near) - half) + (z * r - x * error))
}
