//! RRR: two links joined by a revolute C, hung by revolutes A and B on bodies of known motion.
//!
//! Link 1 is AC, link 2 is BC; r_1 = C − A, r_2 = C − B, r = B − A, L = |r|.
//!
//! Position: |r_1| = l_1 and |r_2| = l_2, two circles. With q = L², the sum and the difference of the lengths
//! s = l_1 + l_2 and d = l_1 − l_2, and A the area of the triangle,
//!
//! ```text
//! 16A² = (s² − q) (q − d²),    r_1 = (q + sd)/2q r + 2A/q perp(r),    r_2 = −(q − sd)/2q r + 2A/q perp(r).
//! ```
//!
//! s², d² and sd = l_1² − l_2² do not change with the position: they are formed once with twice the digits, [`Sides`].
//! A difference of q and the leading part of one of them is exact wherever it cancels, the rest is added after it. So
//! A and both r are accurate for q as it is, near the dead centres and relative to a link however short. It takes one
//! root and no length L.
//!
//! Velocity:      v_A + ω_1 × r_1 = v_B + ω_2 × r_2.
//! Acceleration:  a_A + α_1 × r_1 − ω_1² r_1 = a_B + α_2 × r_2 − ω_2² r_2.
//!
//! Both read x_1 perp(r_1) − x_2 perp(r_2) = b. Scalar products with r_2 and r_1 leave one unknown each:
//!
//! ```text
//! x_1 = b·r_2 / D,    x_2 = b·r_1 / D,    D = r_1 × r_2 = ±2A = l_1 l_2 sin(transmission angle).
//! ```
//!
//! D vanishes where the links are in line: stretched, L = l_1 + l_2, or folded, L = |l_1 − l_2|.
//!
//! Forces: f_C is the force of link 1 on link 2. Moments of link 1 about A and of link 2 about B:
//!
//! ```text
//! r_1 × f_C = M_1,    r_2 × f_C = −M_2    ⇒    f_C = (M_2 r_1 + M_1 r_2) / D,
//! ```
//!
//! then f_A = f_C − F_1 and f_B = −f_C − F_2.
//!
//! A link 2 of given changing length, a cylinder, is the same group: with u = r_2 / l_2 give v_B + l̇_2 u in place of
//! v_B, and a_B + l̈_2 u + 2 ω_2 l̇_2 perp(u) in place of a_B.

use super::Gap;
use crate::math::{Scalar, V2, Vec2};

/// Where the links are.
#[derive(Clone, Copy, Debug)]
pub struct Position<S> {
    /// The inner revolute C, m.
    pub p_C: V2<S>,
    /// C − A, m, accurate relative to its own length.
    pub r_1: V2<S>,
    /// C − B, m, accurate relative to its own length.
    pub r_2: V2<S>,
    /// 1 / (r_1 × r_2), 1/m²; not finite where the links are in line.
    pub inverse: S,
    /// sin of the angle from r_1 to r_2; positive when C is left of A→B.
    pub conditioning: S,
    /// The length by which the links suffice, m: (s² − q)/2s or (q − d²)/2|d|, the lesser; ≥ 0 when they close.
    pub closure: S,
}

/// The lengths of the links as the position needs them: m² but for the last three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides<S> {
    /// (l_1 + l_2)², leading part and rest.
    sum: (S, S),
    /// (l_1 − l_2)².
    difference: (S, S),
    /// l_1² − l_2².
    across: (S, S),
    /// 1 / 2 l_1 l_2, 1/m².
    product: S,
    /// 1 / 2(l_1 + l_2), 1/m.
    far: S,
    /// 1 / 2|l_1 − l_2|, 1/m.
    near: S,
}

impl<S: Scalar> Sides<S> {
    /// # Given
    /// `l_1` = AC, `l_2` = BC, m, > 0.
    #[inline(always)]
    pub fn new(l_1: S, l_2: S) -> Self {
        let half = S::of(0.5);
        let s = two_sum(l_1, l_2);
        let d = two_sum(l_1, -l_2);
        Self {
            sum: product(s, s),
            difference: product(d, d),
            across: product(s, d),
            product: half / (l_1 * l_2),
            far: half / s.0,
            near: half / d.0.abs().max(S::tiny()),
        }
    }

    /// Position of the inner revolute.
    /// # Given
    /// `p_A`, `p_B` outer revolutes, m; `side` +1 with C left of A→B, −1 right.
    /// # Returns
    /// See [`Position`]. Where the links do not close, C lies on AB; where A and B coincide `sine` is 0 and C is not
    /// determined.
    #[inline(always)]
    pub fn position(&self, p_A: V2<S>, p_B: V2<S>, side: S) -> Position<S> {
        let half = S::of(0.5);
        let r = p_B - p_A;
        let q = r.dot(r);
        // coincident pins: a finite position that `sine` marks as dead
        let inverse = half / q.max(S::tiny());
        let far = (self.sum.0 - q) + self.sum.1;
        let near = (q - self.difference.0) - self.difference.1;
        // 2 r_1 × r_2
        let area = side * (far * near).max(S::zero()).sqrt();
        let across = r.perp() * (area * inverse);
        let along_1 = ((q + self.across.0) + self.across.1) * inverse;
        let along_2 = ((q - self.across.0) - self.across.1) * inverse;
        let r_1 = r * along_1 + across;
        Position {
            p_C: p_A + r_1,
            r_1,
            r_2: across - r * along_2,
            inverse: S::of(2.0) / area,
            conditioning: area * self.product,
            closure: (far * self.far).min(near * self.near),
        }
    }
}

impl Sides<f64> {
    /// The same in every lane.
    #[inline(always)]
    #[must_use]
    pub fn of<S: Scalar>(&self) -> Sides<S> {
        let pair = |(x, y)| (S::of(x), S::of(y));
        Sides {
            sum: pair(self.sum),
            difference: pair(self.difference),
            across: pair(self.across),
            product: S::of(self.product),
            far: S::of(self.far),
            near: S::of(self.near),
        }
    }
}

/// Position of the inner revolute, for links that change their lengths: see [`Sides::position`].
/// # Given
/// `p_A`, `p_B` outer revolutes, m; `l_1` = AC, `l_2` = BC, m, > 0; `side` +1 with C left of A→B, −1 right.
#[inline(always)]
pub fn position<S: Scalar>(p_A: V2<S>, p_B: V2<S>, l_1: S, l_2: S, side: S) -> Position<S> {
    Sides::new(l_1, l_2).position(p_A, p_B, side)
}

/// x + y and its rounding error (Knuth).
#[inline(always)]
fn two_sum<S: Scalar>(x: S, y: S) -> (S, S) {
    let sum = x + y;
    let part = sum - x;
    (sum, (x - (sum - part)) + (y - part))
}

/// The product of two numbers of twice the digits.
#[inline(always)]
fn product<S: Scalar>(x: (S, S), y: (S, S)) -> (S, S) {
    let (high, low) = x.0.two_product(y.0);
    let rest = low + (x.0 * y.1 + x.1 * y.0);
    let sum = high + rest;
    (sum, rest - (sum - high))
}

/// By how much the links do not close, m; `None` when they do.
/// # Given
/// `p_A`, `p_B` outer revolutes, m; `l_1`, `l_2` link lengths, m, > 0.
#[cold]
#[must_use]
pub fn gap(p_A: Vec2, p_B: Vec2, l_1: f64, l_2: f64) -> Option<Gap> {
    let length = (p_B - p_A).norm();
    let far = length - (l_1 + l_2);
    let near = (l_1 - l_2).abs() - length;
    if far > 0.0 {
        Some(Gap::TooFar(far))
    } else if near > 0.0 {
        Some(Gap::TooNear(near))
    } else {
        None
    }
}

/// The group in one position: what velocity, acceleration and reactions share.
#[derive(Clone, Copy, Debug)]
pub struct Rrr<S> {
    /// C − A, m.
    pub r_1: V2<S>,
    /// C − B, m.
    pub r_2: V2<S>,
    /// 1 / (r_1 × r_2), 1/m².
    pub inverse: S,
}

/// Forces in the three revolutes, N.
#[derive(Clone, Copy, Debug)]
pub struct Reactions<S> {
    /// On link 1 at A.
    pub f_A: V2<S>,
    /// Of link 1 on link 2 at C.
    pub f_C: V2<S>,
    /// On link 2 at B.
    pub f_B: V2<S>,
}

impl<S: Copy> Position<S> {
    /// The group in this position.
    #[inline(always)]
    pub fn group(&self) -> Rrr<S> {
        Rrr { r_1: self.r_1, r_2: self.r_2, inverse: self.inverse }
    }
}

impl<S: Scalar> Rrr<S> {
    /// The group in one position.
    /// # Given
    /// `r_1` = C − A, `r_2` = C − B, m, not in line.
    #[inline(always)]
    pub fn new(r_1: V2<S>, r_2: V2<S>) -> Self {
        Self { r_1, r_2, inverse: S::one() / r_1.cross(r_2) }
    }

    /// Angular velocities (ω_1, ω_2), rad/s.
    /// # Given
    /// `v_A`, `v_B` velocities of the outer revolutes, m/s.
    #[inline(always)]
    pub fn velocity(&self, v_A: V2<S>, v_B: V2<S>) -> (S, S) {
        self.solve(v_B - v_A)
    }

    /// Angular accelerations (α_1, α_2), rad/s².
    /// # Given
    /// `omega_1`, `omega_2` from [`Rrr::velocity`]; `a_A`, `a_B` accelerations of the outer revolutes, m/s².
    #[inline(always)]
    pub fn acceleration(&self, omega_1: S, omega_2: S, a_A: V2<S>, a_B: V2<S>) -> (S, S) {
        self.solve(a_B - a_A + self.r_1 * (omega_1 * omega_1) - self.r_2 * (omega_2 * omega_2))
    }

    /// x_1 perp(r_1) − x_2 perp(r_2) = b.
    #[inline(always)]
    fn solve(&self, b: V2<S>) -> (S, S) {
        (b.dot(self.r_2) * self.inverse, b.dot(self.r_1) * self.inverse)
    }

    /// Forces in the revolutes.
    /// # Given
    /// `F_1`, `F_2` applied and inertia forces on the links, N; `M_1` their moment about A, `M_2` about B, N m.
    #[inline(always)]
    pub fn reactions(&self, F_1: V2<S>, M_1: S, F_2: V2<S>, M_2: S) -> Reactions<S> {
        let f_C = (self.r_1 * M_2 + self.r_2 * M_1) * self.inverse;
        Reactions { f_A: f_C - F_1, f_C, f_B: -f_C - F_2 }
    }
}
