//! Change points: places where a group has both its assemblies in one, and the motion goes on smoothly in the other one.
//!
//! There the formulas divide nothing by nothing, yet all that moves is a smooth function of the coordinate. It is taken from
//! regular positions on both sides, by Chebyshev's series over a short way.

use super::change::{
    CHANGES, CLOSE, FARTHEST, IS_LENGTH, OF_ALL, ORDERS, REACH, SMOOTH, WIDTH, change_point, put_numbers,
};
use super::equations::Equations;
use crate::math::Vec2;
use crate::math::chebyshev::{NODES, Nodes, add_rows, polynomials, tail};
use crate::position::{BodyState, Branch, Motion, State};

/// The way over a change point.
#[derive(Clone, Debug)]
pub(super) struct SingularCrossing {
    low: f64,
    high: f64,
    /// The sense in which it lies from where it was found.
    ahead: f64,
    /// The motion begins on it, and may go away from the change point.
    beside: bool,
    /// The assemblies before it and behind it.
    below: Vec<Branch>,
    above: Vec<Branch>,
    /// Coefficients: of each polynomial, those of all numbers of all bodies.
    series: [Vec<f64>; NODES],
    /// Conditions of the groups before it: those on it say nothing of what is computed there.
    conditions: Vec<f64>,
    /// Memory for the numbers at a place.
    numbers: Vec<f64>,
    /// What positions, velocities and accelerations are not known to, of the extent or 1, at a unit rate.
    pub rough: [f64; 3],
}

impl SingularCrossing {
    /// Over the change point near where the present step begins: ahead in the sense of the motion, or so close behind that the formulas
    /// have lost digits.
    pub fn near(equations: &Equations<'_, '_>, value: f64, sense: f64) -> Option<Self> {
        let towards = |side: f64| Self::towards(equations, value, side);
        let ahead = if sense == 0.0 { None } else { towards(sense) };
        if ahead.is_some() || equations.condition() >= CLOSE {
            return ahead;
        }
        let beside = [1.0, -1.0].into_iter().filter_map(towards).find(|bridge| bridge.covers(value))?;
        Some(Self { beside: true, ..beside })
    }

    /// Over the change point on this side of where the present step begins, if there is one.
    fn towards(equations: &Equations<'_, '_>, value: f64, ahead: f64) -> Option<Self> {
        let plan = equations.model.plan;
        let rubs = equations.rubs();
        if rubs || !equations.reduced.is_alone() || plan.goes_on() {
            return None;
        }
        let mut state = equations.here().1.clone();
        let drive = equations.reduced.free()[0];
        let mut at = |q: f64, branches: &[Branch]| {
            state.branches.copy_from_slice(branches);
            let input = &mut state.motion.inputs[drive];
            (input.value, input.place) = (q, Vec2::direction(q));
            (input.rate, input.acceleration) = (1.0, 0.0);
            state.run_motion::<2>(plan);
            state.motion.open.is_none().then(|| state.clone())
        };
        let near = equations.here().1.branches.clone();
        let (change, there) = change_point(&mut at, &near, value, ahead)?;
        let turned = near.iter().zip(&there.motion.conditions).map(|(branch, condition)| {
            let root = if condition.abs() < CHANGES { -branch.root } else { branch.root };
            Branch { root, ..*branch }
        });
        let far: Vec<Branch> = turned.collect();
        let (below, above) = if ahead > 0.0 { (near, far) } else { (far, near) };
        let mut reach = REACH;
        for _ in 0..3 {
            let (low, high) = (change - reach, change + reach);
            let positions = |node: usize, nodes: &Nodes| {
                let q = nodes.at(low, high, node);
                at(q, if q < change { &below } else { &above })
            };
            if let Some((series, rough)) = smooth(positions, equations.extent()) {
                let numbers = vec![0.0; series[0].len()];
                let here = equations.here().1;
                let conditions = if equations.condition() < CLOSE {
                    at(change - ahead * reach, &here.branches)?.motion.conditions
                } else {
                    here.motion.conditions.clone()
                };
                let beside = false;
                return Some(Self {
                    low,
                    high,
                    ahead,
                    beside,
                    below,
                    above,
                    series,
                    conditions,
                    numbers,
                    rough,
                });
            }
            reach *= 0.5;
        }
        None
    }

    /// Whether a value of the coordinate lies on it.
    pub fn covers(&self, q: f64) -> bool {
        self.low <= q && q <= self.high
    }

    /// The assemblies at a value.
    pub fn branches(&self, q: f64) -> &[Branch] {
        if q < 0.5 * (self.low + self.high) { &self.below } else { &self.above }
    }

    /// Whether it lies behind a value.
    pub fn is_behind(&self, q: f64) -> bool {
        if self.ahead > 0.0 { q > self.high } else { q < self.low }
    }

    /// Whether it is of no use at a value: passed, or not gone over.
    pub fn is_left(&self, q: f64) -> bool {
        let left = self.beside && !self.covers(q);
        left || self.is_behind(q) || (q - 0.5 * (self.low + self.high)).abs() > FARTHEST
    }

    /// Moves the bodies at a value of the coordinate, for a unit rate of it.
    pub fn put(&mut self, q: f64, motion: &mut Motion) {
        motion.open = None;
        motion.conditions.copy_from_slice(&self.conditions);
        let factors = polynomials(self.low, self.high, q);
        self.numbers.fill(0.0);
        add_rows(&mut self.numbers, &self.series, &factors);
        for (body, n) in motion.bodies.iter_mut().zip(self.numbers.chunks_exact(WIDTH)) {
            put_numbers(body, n);
        }
    }
}

/// The series of all that moves over these positions, with what their orders are not known to; `None` where they do not close or
/// are not smooth.
fn smooth(
    mut positions: impl FnMut(usize, &Nodes) -> Option<State>,
    extent: f64,
) -> Option<([Vec<f64>; NODES], [f64; 3])> {
    let nodes = Nodes::new();
    let mut values: [Vec<f64>; NODES] = std::array::from_fn(|_| Vec::new());
    for (node, values) in values.iter_mut().enumerate() {
        let state = positions(node, &nodes)?;
        values.reserve_exact(WIDTH * state.motion.bodies.len());
        for BodyState { p, u, v, omega, a, alpha, .. } in &state.motion.bodies {
            values.extend([p.x, p.y, u.x, u.y, v.x, v.y, *omega, a.x, a.y, *alpha]);
        }
    }
    let series = nodes.coefficients_of_all(&values);
    let [.., a, b, c] = &series;
    let mut rough = [0.0_f64; 3];
    for (number, ((a, b), c)) in a.iter().zip(b).zip(c).enumerate() {
        let order = ORDERS[number % WIDTH];
        let unit = if IS_LENGTH[number % WIDTH] { extent } else { 1.0 };
        rough[order] = rough[order].max(tail(&[*a, *b, *c]) / unit);
    }
    // positions tell whether it is smooth; rates have fewer digits where the formulas are near to fail
    (rough[0] <= SMOOTH).then_some((series, rough.map(|left| OF_ALL * left)))
}
