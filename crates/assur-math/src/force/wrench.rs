//! A force and its moment about a point.

use std::ops::{Add, AddAssign, Neg, Sub};

use crate::math::{Scalar, V2};

/// The forces on a body reduced to one of its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<S> {
    /// Force, N.
    pub F: V2<S>,
    /// Moment about the reference point, N m.
    pub M: S,
}

impl<S: Scalar> Wrench<S> {
    /// No force.
    #[inline(always)]
    #[must_use]
    pub fn zero() -> Self {
        Self { F: V2::zero(), M: S::zero() }
    }

    /// The force `F` acting at `r` from the reference point.
    #[inline(always)]
    pub fn at(F: V2<S>, r: V2<S>) -> Self {
        Self { F, M: r.cross(F) }
    }

    /// The same forces about the point at `r` from the present reference point: M' = M − r × F.
    #[inline(always)]
    #[must_use]
    pub fn about(self, r: V2<S>) -> Self {
        Self { F: self.F, M: self.M - r.cross(self.F) }
    }

    /// Power on a body whose reference point moves with `v` and which turns with `omega`, W.
    #[inline(always)]
    pub fn power(self, v: V2<S>, omega: S) -> S {
        self.F.dot(v) + self.M * omega
    }

    /// Distance |M| / |F| of the line of action from the reference point, m; infinite or NaN without a force.
    #[inline(always)]
    pub fn arm(self) -> S {
        self.M.abs() / self.F.norm()
    }
}

impl<S: Scalar> Add for Wrench<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self { F: self.F + o.F, M: self.M + o.M }
    }
}

impl<S: Scalar> Sub for Wrench<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self { F: self.F - o.F, M: self.M - o.M }
    }
}

impl<S: Scalar> Neg for Wrench<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { F: -self.F, M: -self.M }
    }
}

impl<S: Scalar> AddAssign for Wrench<S> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
