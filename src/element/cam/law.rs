//! Laws of motion: the way f(x) of a follower over the turn x of its cam, both from 0 to 1.
//!
//! All of them are antisymmetric about the middle, f(1 − x) = 1 − f(x), so that only the first half is written down. The
//! formulas are those of Norton, *Cam Design and Manufacturing Handbook*, chapters 2 and 3 (modified trapezoid
//! A = 8π/(2 + π) = 4.888, modified sine A = 4π²/(4 + π) = 5.528), integrated from the acceleration.

use std::f64::consts::PI;

/// A law of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// No motion.
    Dwell,
    /// Constant speed.
    Uniform,
    /// Constant acceleration, then constant deceleration.
    Parabolic,
    /// A half cosine.
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

    /// f, f′, f″, f‴ at x in [0, 1]; at a joint those of the formula behind it.
    #[must_use]
    pub fn at(self, x: f64) -> Jet {
        let joints = self.joints();
        let part = joints[1..joints.len() - 1].iter().filter(|j| x >= **j - NEAR).count();
        self.on_part(part, x)
    }

    /// The same by the formula between two joints, which holds at both of them.
    #[must_use]
    pub fn on_part(self, part: usize, x: f64) -> Jet {
        let parts = self.joints().len() - 1;
        // a part in the middle has one formula; it is taken from that half in which x lies
        let mirrored = if 2 * part + 1 == parts { x > 0.5 } else { 2 * part >= parts };
        if mirrored {
            let [s, v, a, j] = self.first_half(parts - 1 - part, 1.0 - x);
            [1.0 - s, v, -a, j]
        } else {
            self.first_half(part, x)
        }
    }

    fn first_half(self, part: usize, x: f64) -> Jet {
        match self {
            Self::Dwell => [0.0; 4],
            Self::Uniform => [x, 1.0, 0.0, 0.0],
            Self::Parabolic => [2.0 * x * x, 4.0 * x, 4.0, 0.0],
            Self::Harmonic => {
                let (sin, cos) = libm::sincos(PI * x);
                let half = libm::sin(0.5 * PI * x);
                [half * half, 0.5 * PI * sin, 0.5 * PI * PI * cos, -0.5 * PI * PI * PI * sin]
            }
            Self::Cycloidal => {
                let (sin, cos) = libm::sincos(2.0 * PI * x);
                let half = libm::sin(PI * x);
                [x - sin / (2.0 * PI), 2.0 * half * half, 2.0 * PI * sin, 4.0 * PI * PI * cos]
            }
            Self::Poly345 => {
                let y = 1.0 - x;
                [
                    x * x * x * (10.0 - x * (15.0 - 6.0 * x)),
                    30.0 * x * x * y * y,
                    60.0 * x * y * (1.0 - 2.0 * x),
                    60.0 - 360.0 * x * y,
                ]
            }
            Self::Poly4567 => {
                let y = 1.0 - x;
                let xy = x * y;
                [
                    x * x * x * x * (35.0 - x * (84.0 - x * (70.0 - 20.0 * x))),
                    140.0 * xy * xy * xy,
                    420.0 * xy * xy * (1.0 - 2.0 * x),
                    840.0 * xy * (1.0 - 5.0 * xy),
                ]
            }
            Self::ModifiedTrapezoid => modified_trapezoid(part, x),
            Self::ModifiedSine => modified_sine(part, x),
        }
    }
}

/// a = A sin 4πx: the first eighth of both modified laws.
fn first_eighth(a: f64, x: f64) -> Jet {
    let w = 4.0 * PI;
    let (sin, cos) = libm::sincos(w * x);
    [a / w * (x - sin / w), a / w * (1.0 - cos), a * sin, a * w * cos]
}

/// a = A sin 4πx up to 1/8, A up to 3/8, A cos 4π(x − 3/8) up to the middle.
fn modified_trapezoid(part: usize, x: f64) -> Jet {
    const A: f64 = 8.0 * PI / (2.0 + PI);
    const W: f64 = 4.0 * PI;
    const S_1: f64 = A / W * (0.125 - 1.0 / W);
    const V_2: f64 = A / W + A / 4.0;
    const S_2: f64 = S_1 + A / (4.0 * W) + A / 32.0;
    match part {
        0 => first_eighth(A, x),
        1 => {
            let y = x - 0.125;
            [S_1 + y * (A / W + 0.5 * A * y), A / W + A * y, A, 0.0]
        }
        _ => {
            let y = x - 0.375;
            let (sin, cos) = libm::sincos(W * y);
            [S_2 + V_2 * y + A / (W * W) * (1.0 - cos), V_2 + A / W * sin, A * cos, -A * W * sin]
        }
    }
}

/// a = A sin 4πx up to 1/8, A sin(4πx/3 + π/3) up to the middle.
fn modified_sine(part: usize, x: f64) -> Jet {
    const A: f64 = 4.0 * PI * PI / (4.0 + PI);
    const W: f64 = 4.0 * PI;
    const K: f64 = W / 3.0;
    const S_1: f64 = A / W * (0.125 - 1.0 / W);
    if part == 0 {
        return first_eighth(A, x);
    }
    let (sin, cos) = libm::sincos(K * x + PI / 3.0);
    [S_1 + A / W * (x - 0.125) - A / (K * K) * (sin - 1.0), A / W - A / K * cos, A * sin, A * K * cos]
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [Law; 8] = [
        Law::Uniform,
        Law::Parabolic,
        Law::Harmonic,
        Law::Cycloidal,
        Law::Poly345,
        Law::Poly4567,
        Law::ModifiedTrapezoid,
        Law::ModifiedSine,
    ];

    #[test]
    fn every_law_goes_from_nothing_to_one_and_is_antisymmetric() {
        for law in LAWS {
            assert_eq!(law.at(0.0)[0], 0.0, "{law:?}");
            assert!((law.at(1.0)[0] - 1.0).abs() < 1e-15, "{law:?}");
            assert!((law.at(0.5)[0] - 0.5).abs() < 1e-15, "{law:?}");
            for i in 1..50 {
                let x = f64::from(i) / 50.0 + 1e-3;
                let (a, b) = (law.at(x), law.at(1.0 - x));
                let off = [a[0] + b[0] - 1.0, a[1] - b[1], a[2] + b[2], a[3] - b[3]];
                assert!(off.iter().all(|o| o.abs() < 1e-12), "{law:?} at {x}: {off:?}");
            }
        }
    }

    /// Each derivative against a difference of eighth order of the one before it, inside every part.
    #[test]
    fn derivatives_are_those_of_the_way() {
        const C: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
        let h = 2e-3;
        for law in LAWS {
            for (part, ends) in law.joints().windows(2).enumerate() {
                for i in 0..=40 {
                    let x = ends[0] + 4.5 * h + (ends[1] - ends[0] - 9.0 * h) * f64::from(i) / 40.0;
                    for n in 0..3 {
                        let slope: f64 = (1..=4)
                            .map(|k| {
                                let d = f64::from(k) * h;
                                let (r, l) = (law.on_part(part, x + d)[n], law.on_part(part, x - d)[n]);
                                C[k as usize - 1] * (r - l) / h
                            })
                            .sum();
                        let got = law.on_part(part, x)[n + 1];
                        assert!(
                            (slope - got).abs() < 2e-10 * (1.0 + got.abs()),
                            "{law:?} {n} at {x}: {slope} {got}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn joints_are_as_smooth_as_promised() {
        for law in LAWS {
            let joints = law.joints();
            for (i, &x) in joints.iter().enumerate().skip(1).take(joints.len() - 2) {
                let (before, behind) = (law.on_part(i - 1, x), law.on_part(i, x));
                let continuous = if law == Law::Parabolic { 2 } else { 3 };
                for n in 0..continuous {
                    assert!(
                        (before[n] - behind[n]).abs() < 1e-13,
                        "{law:?} {n} at {x}: {before:?} {behind:?}"
                    );
                }
            }
        }
        for law in [Law::Cycloidal, Law::Poly345, Law::Poly4567, Law::ModifiedTrapezoid, Law::ModifiedSine] {
            for x in [0.0, 1.0] {
                assert!(law.at(x)[1].abs() < 1e-14 && law.at(x)[2].abs() < 1e-14, "{law:?} starts at rest");
            }
        }
        assert!(Law::Poly4567.at(0.0)[3].abs() < 1e-14);
    }

    /// Greatest velocity and acceleration as tabulated by Norton, table 2-? (values derived: 15/8, 10/√3, 35/16, 84√5/25).
    #[test]
    fn peak_factors_are_those_of_the_handbook() {
        let peak = |law: Law, n: usize| {
            let each = law.joints().windows(2).enumerate().map(|(part, e)| {
                crate::element::search::greatest(e[0], e[1], &|x| law.on_part(part, x)[n]).1
            });
            each.fold(0.0, f64::max)
        };
        let table = [
            (Law::Parabolic, 2.0, 4.0),
            (Law::Harmonic, PI / 2.0, PI * PI / 2.0),
            (Law::Cycloidal, 2.0, 2.0 * PI),
            (Law::Poly345, 15.0 / 8.0, 10.0 / 3.0_f64.sqrt()),
            (Law::Poly4567, 35.0 / 16.0, 84.0 * 5.0_f64.sqrt() / 25.0),
            (Law::ModifiedTrapezoid, 2.0, 8.0 * PI / (2.0 + PI)),
            (Law::ModifiedSine, 4.0 * PI / (4.0 + PI), 4.0 * PI * PI / (4.0 + PI)),
        ];
        for (law, v, a) in table {
            assert!((peak(law, 1) - v).abs() < 1e-13, "{law:?} {}", peak(law, 1));
            assert!((peak(law, 2) - a).abs() < 1e-12, "{law:?} {}", peak(law, 2));
        }
    }
}
