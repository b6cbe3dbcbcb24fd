//! One link on a body of known motion: the driven link of class I, and its counterpart for forces.
//!
//! Kinematics. The pair's coordinate, its rate and second rate are given.
//! Revolute:   the link's direction is the base's turned by the given angle, ω = ω_g + φ̇, α = α_g + φ̈.
//! Prismatic:  the link's point R keeps the offset h to the left of the guide through Q, unit direction d, left
//!             normal n, and turns with the guide. G is the point of the guide's body under R.
//!
//! ```text
//! R = Q + s d + h n,    v_R = v_G + ṡ d,    a_R = a_G + 2 ω_g ṡ n + s̈ d.
//! ```
//!
//! Nothing is solved, so there is no determinant.
//!
//! Forces. The pair leaves one freedom, so equilibrium asks for one unknown effort: a torque, or a force P along
//! a given unit direction u through a given point at r from the reference point (O of the revolute, R of the slider).
//! A contact, a pin in a slot, a mesh or a rope gives such a line of action.
//! Revolute and torque:   T = −M,                   f_O = −F.
//! Revolute and force:    P = −M / (r × u),         f_O = −F − P u;        no balance when the line meets O.
//! Prismatic and force:   P = −F·d / (u·d),         N = −(F + P u)·n,      K = −M − P r × u;
//!                        no balance when the line stands across the guide.

use crate::math::{Scalar, V2};

/// Direction of a link on a revolute.
/// # Given
/// `u_g` direction of the base; `angle` given direction of the link relative to it, (cos, sin).
#[inline(always)]
pub fn revolute_position<S: Scalar>(u_g: V2<S>, angle: V2<S>) -> V2<S> {
    angle.turned(u_g)
}

/// Angular velocity of a link on a revolute, rad/s.
/// # Given
/// `omega_g` of the base; `rate` of the given angle.
#[inline(always)]
pub fn revolute_velocity<S: Scalar>(omega_g: S, rate: S) -> S {
    omega_g + rate
}

/// Angular acceleration of a link on a revolute, rad/s².
/// # Given
/// `alpha_g` of the base; `second_rate` of the given angle.
#[inline(always)]
pub fn revolute_acceleration<S: Scalar>(alpha_g: S, second_rate: S) -> S {
    alpha_g + second_rate
}

/// Position of the point R of a slider, m.
/// # Given
/// `p_Q` point of the guide, m; `d` its unit direction; `h` offset of R, m; `s` given coordinate, m.
#[inline(always)]
pub fn prismatic_position<S: Scalar>(p_Q: V2<S>, d: V2<S>, h: S, s: S) -> V2<S> {
    p_Q + d * s + d.perp() * h
}

/// Velocity of the point R of a slider, m/s.
/// # Given
/// `v_G` velocity of the guide's point under R, m/s; `d` unit direction; `s_dot` given, m/s.
#[inline(always)]
pub fn prismatic_velocity<S: Scalar>(v_G: V2<S>, d: V2<S>, s_dot: S) -> V2<S> {
    v_G + d * s_dot
}

/// Acceleration of the point R of a slider, m/s².
/// # Given
/// `a_G` acceleration of the guide's point under R, m/s²; `omega_g` of the guide, rad/s; `d` unit
/// direction; `s_dot`, `s_ddot` given, m/s, m/s².
#[inline(always)]
pub fn prismatic_acceleration<S: Scalar>(a_G: V2<S>, omega_g: S, d: V2<S>, s_dot: S, s_ddot: S) -> V2<S> {
    a_G + d.perp() * (S::of(2.0) * omega_g * s_dot) + d * s_ddot
}

/// A link on a revolute held by a torque.
#[derive(Clone, Copy, Debug)]
pub struct RevoluteTorque<S> {
    /// On the link at O, N.
    pub f_O: V2<S>,
    /// Torque on the link, N m.
    pub torque: S,
}

/// A link on a revolute held by a force.
#[derive(Clone, Copy, Debug)]
pub struct RevoluteForce<S> {
    /// On the link at O, N.
    pub f_O: V2<S>,
    /// Force P on the link along u, N.
    pub force: S,
    /// Lever arm of the line of action over the distance of its point from O; 0 where nothing balances.
    pub sine: S,
}

/// A slider held by a force.
#[derive(Clone, Copy, Debug)]
pub struct PrismaticForce<S> {
    /// Normal force N of the guide on the slider along n through R, N.
    pub normal: S,
    /// Couple K of the guide on the slider about R, N m.
    pub couple: S,
    /// Force P on the slider along u, N.
    pub force: S,
    /// u·d; 0 where nothing balances.
    pub sine: S,
}

/// Reaction and balancing torque of a link on a revolute.
/// # Given
/// `F` applied and inertia forces, N; `M` their moment about O, N m.
#[inline(always)]
pub fn revolute_torque<S: Scalar>(F: V2<S>, M: S) -> RevoluteTorque<S> {
    RevoluteTorque { f_O: -F, torque: -M }
}

/// Reaction and balancing force of a link on a revolute.
/// # Given
/// `F`, `M` about O as above; `r` from O to a point of the line of action, m, not null; `u` its unit direction.
#[inline(always)]
pub fn revolute_force<S: Scalar>(F: V2<S>, M: S, r: V2<S>, u: V2<S>) -> RevoluteForce<S> {
    let arm = r.cross(u);
    let force = -M / arm;
    RevoluteForce { f_O: -F - u * force, force, sine: arm / r.norm().max(S::of(f64::MIN_POSITIVE)) }
}

/// Reactions and balancing force of a slider.
/// # Given
/// `F` applied and inertia forces, N; `M` their moment about R, N m; `d` unit direction of the guide; `r` from
/// R to a point of the line of action, m; `u` its unit direction.
#[inline(always)]
pub fn prismatic_force<S: Scalar>(F: V2<S>, M: S, d: V2<S>, r: V2<S>, u: V2<S>) -> PrismaticForce<S> {
    let sine = u.dot(d);
    let force = -F.dot(d) / sine;
    let push = u * force;
    PrismaticForce { normal: -d.cross(F + push), couple: -M - r.cross(push), force, sine }
}
