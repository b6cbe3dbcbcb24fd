//! Laws of motion: the way f(x) of a follower over the turn x of its cam, both from 0 to 1.
//!
//! All but the pieces of splines are antisymmetric about the middle, f(1 − x) = 1 − f(x), so that only the first half is written down. The
//! formulas are those of Norton, *Cam Design and Manufacturing Handbook*, chapters 2 and 3 (modified trapezoid
//! A = 8π/(2 + π) = 4.888, modified sine A = 4π²/(4 + π) = 5.528), integrated from the acceleration.

use crate::math::Angular;

/// A law of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    Dwell,
    Uniform,
    /// Constant acceleration, then constant deceleration.
    Parabolic,
    Harmonic,
    /// The acceleration is a whole sine.
    Cycloidal,
    /// 10 x³ − 15 x⁴ + 6 x⁵.
    Poly345,
    /// 35 x⁴ − 84 x⁵ + 70 x⁶ − 20 x⁷.
    Poly4567,
    /// The acceleration is a trapezoid with sines for flanks.
    ModifiedTrapezoid,
    /// The acceleration is a sine, four times as fast at both ends.
    ModifiedSine,
    /// A piece of a spline: the way a x + b x² + c x³ itself, m or rad, whatever the change of the lift.
    Spline([f64; 3]),
}

/// A way with its first three derivatives.
pub type Jet = [f64; 4];

/// Joints and middle this near, relative to the turn of a phase, are reached.
const NEAR: f64 = 1e-12;

impl Law {
    /// Where one formula ends and the next begins, 0 and 1 among them.
    #[must_use]
    pub const fn joints(self) -> &'static [f64] {
        match self {
            Self::Parabolic => &[0.0, 0.5, 1.0],
            Self::ModifiedTrapezoid => &[0.0, 0.125, 0.375, 0.625, 0.875, 1.0],
            Self::ModifiedSine => &[0.0, 0.125, 0.875, 1.0],
            _ => &[0.0, 1.0],
        }
    }

    /// f, f′, f″, f‴ at x in [0, 1]; at a joint those of the formula after it.
    #[must_use]
    pub fn at(self, x: f64) -> Jet {
        self.on_part(self.part_at(x), x)
    }

    /// The formula that holds at x.
    pub(super) fn part_at(self, x: f64) -> usize {
        let joints = self.joints();
        joints[1..joints.len() - 1].iter().filter(|j| x >= **j - NEAR).count()
    }

    /// The same by the formula between two joints, which holds at both of them.
    #[must_use]
    pub fn on_part<S: Angular>(self, part: usize, x: S) -> [S; 4] {
        if let Self::Spline(terms) = self {
            return cubic(terms, x);
        }
        let parts = self.joints().len() - 1;
        let one = S::one();
        // a part in the middle has one formula; it is taken from that half in which x lies
        let mirrored = if 2 * part + 1 == parts { S::of(0.5).lt(x) } else { 2 * part >= parts };
        if mirrored {
            let [s, v, a, j] = self.first_half(parts - 1 - part, one - x);
            [one - s, v, -a, j]
        } else {
            self.first_half(part, x)
        }
    }

    fn first_half<S: Angular>(self, part: usize, x: S) -> [S; 4] {
        let (of, pi, zero, one) = (S::of, S::pi(), S::zero(), S::one());
        match self {
            Self::Dwell | Self::Spline(_) => [zero; 4],
            Self::Uniform => [x, one, zero, zero],
            Self::Parabolic => [of(2.0) * x * x, of(4.0) * x, of(4.0), zero],
            Self::Harmonic => {
                let (sin, cos) = (pi * x).sine_cosine();
                let (half, _) = (of(0.5) * pi * x).sine_cosine();
                let half_pi = of(0.5) * pi;
                [half * half, half_pi * sin, half_pi * pi * cos, -half_pi * pi * pi * sin]
            }
            Self::Cycloidal => {
                let (sin, cos) = (of(2.0) * pi * x).sine_cosine();
                let (half, _) = (pi * x).sine_cosine();
                let turn = of(2.0) * pi;
                [x - sin / turn, of(2.0) * half * half, turn * sin, of(4.0) * pi * pi * cos]
            }
            Self::Poly345 => {
                let y = one - x;
                [
                    x * x * x * (of(10.0) - x * (of(15.0) - of(6.0) * x)),
                    of(30.0) * x * x * y * y,
                    of(60.0) * x * y * (one - of(2.0) * x),
                    of(60.0) - of(360.0) * x * y,
                ]
            }
            Self::Poly4567 => {
                let y = one - x;
                let xy = x * y;
                [
                    x * x * x * x * (of(35.0) - x * (of(84.0) - x * (of(70.0) - of(20.0) * x))),
                    of(140.0) * xy * xy * xy,
                    of(420.0) * xy * xy * (one - of(2.0) * x),
                    of(840.0) * xy * (one - of(5.0) * xy),
                ]
            }
            Self::ModifiedTrapezoid => modified_trapezoid(part, x),
            Self::ModifiedSine => modified_sine(part, x),
        }
    }
}

fn cubic<S: Angular>(terms: [f64; 3], x: S) -> [S; 4] {
    let [a, b, c] = terms.map(S::of);
    let (two, three, six) = (S::of(2.0), S::of(3.0), S::of(6.0));
    [x * (a + x * (b + x * c)), a + x * (two * b + x * (three * c)), two * b + six * c * x, six * c]
}

/// a = A sin wx, w = 4π: the first eighth of both modified laws.
fn first_eighth<S: Angular>(a: S, x: S) -> [S; 4] {
    let w = S::of(4.0) * S::pi();
    let (sin, cos) = (w * x).sine_cosine();
    [a / w * (x - sin / w), a / w * (S::one() - cos), a * sin, a * w * cos]
}

/// a = A sin 4πx up to 1/8, A up to 3/8, A cos 4π(x − 3/8) up to the middle.
fn modified_trapezoid<S: Angular>(part: usize, x: S) -> [S; 4] {
    let (of, pi) = (S::of, S::pi());
    let a = of(8.0) * pi / (of(2.0) + pi);
    let w = of(4.0) * pi;
    let s_1 = a / w * (of(0.125) - S::one() / w);
    match part {
        0 => first_eighth(a, x),
        1 => {
            let y = x - of(0.125);
            [s_1 + y * (a / w + of(0.5) * a * y), a / w + a * y, a, S::zero()]
        }
        _ => {
            let y = x - of(0.375);
            let (sin, cos) = (w * y).sine_cosine();
            let v_2 = a / w + a / of(4.0);
            let s_2 = s_1 + a / (of(4.0) * w) + a / of(32.0);
            let bent = a / (w * w) * (S::one() - cos);
            [s_2 + v_2 * y + bent, v_2 + a / w * sin, a * cos, -a * w * sin]
        }
    }
}

/// a = A sin 4πx up to 1/8, A sin(4πx/3 + π/3) up to the middle.
fn modified_sine<S: Angular>(part: usize, x: S) -> [S; 4] {
    let (of, pi) = (S::of, S::pi());
    let a = of(4.0) * pi * pi / (of(4.0) + pi);
    if part == 0 {
        return first_eighth(a, x);
    }
    let w = of(4.0) * pi;
    let k = w / of(3.0);
    let s_1 = a / w * (of(0.125) - S::one() / w);
    let (sin, cos) = (k * x + pi / of(3.0)).sine_cosine();
    let way = s_1 + a / w * (x - of(0.125)) - a / (k * k) * (sin - S::one());
    [way, a / w - a / k * cos, a * sin, a * k * cos]
}
