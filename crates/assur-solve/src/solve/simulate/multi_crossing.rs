//! Change points of several free coordinates: all that moves is a smooth function of one of them, the others as they are.
//!
//! Where a group's two assemblies are one depends on the others. At every evaluation positions, velocities for unit rates, and
//! accelerations without any of the free coordinates are taken from regular positions on both sides, along the one coordinate, by
//! Chebyshev's series.

use super::change::{
    CHANGES, FARTHEST, IS_LENGTH, OF_ALL, ORDERS, REACH, SMOOTH, WIDTH, change_point, put_numbers,
};
use crate::math::Vec2;
use crate::math::chebyshev::{NODES, Nodes, add_rows, polynomials};
use crate::plan::Plan;
use crate::position::{BodyState, Branch, Reduced, State};

/// Where the change point is looked for from, before the place where it was, parts of the reach.
const BEFORE: [f64; 2] = [0.6, 0.3];
/// It is known well enough where it moves by less than this part of the reach: the nearest regular positions are a tenth away.
const CLOSE: f64 = 0.03;
/// So often at most it is guessed anew.
const GUESSES: usize = 6;
/// Numbers of a body for a unit rate of a coordinate.
const UNIT: usize = 3;

/// The way over a change point.
#[derive(Clone, Debug)]
pub(super) struct MultiCrossing {
    /// The slot of the drive of the coordinate that passes it.
    drive: usize,
    /// The sense in which it does.
    ahead: f64,
    /// The assemblies before it and behind it.
    near: Vec<Branch>,
    far: Vec<Branch>,
    reach: f64,
    /// Its value there: where the last step began, where the present one does, and in the last evaluation.
    before: f64,
    began: f64,
    change: f64,
    /// Its value in the last evaluation.
    here: f64,
    /// A group that changes.
    group: usize,
    /// Conditions of the groups before it.
    conditions: Vec<f64>,
    extent: f64,
    nodes: Nodes,
    /// All numbers at the nodes, and at the place itself.
    values: [Vec<f64>; NODES],
    numbers: Vec<f64>,
    /// What positions, velocities and accelerations were not known to at its begin, of the greatest.
    pub rough: [f64; 3],
}

impl MultiCrossing {
    /// Over the change point ahead of where the present step begins, if there is one in the way of a coordinate.
    pub fn near(plan: &Plan, reduced: &Reduced, here: &State, extent: f64) -> Option<Self> {
        let mut found: Option<(f64, Self)> = None;
        for drive in moving(reduced, here) {
            let value = here.motion.inputs[drive].value;
            for ahead in [1.0, -1.0] {
                let mut state = here.clone();
                let mut at = |q: f64, branches: &[Branch]| {
                    state.branches.copy_from_slice(branches);
                    set(&mut state, drive, q);
                    state.run_motion::<1>(plan);
                    state.motion.open.is_none().then(|| state.clone())
                };
                let Some((change, there)) = change_point(&mut at, &here.branches, value, ahead) else {
                    continue;
                };
                let conditions = &there.motion.conditions;
                let Some(group) = conditions.iter().position(|c| c.abs() < CHANGES) else { continue };
                let far = here.branches.iter().zip(conditions).map(|(branch, condition)| {
                    let root = if condition.abs() < CHANGES { -branch.root } else { branch.root };
                    Branch { root, ..*branch }
                });
                let passage = Self {
                    drive,
                    ahead,
                    near: here.branches.clone(),
                    far: far.collect(),
                    reach: REACH,
                    before: change,
                    began: change,
                    change,
                    here: value,
                    group,
                    conditions: here.motion.conditions.clone(),
                    extent,
                    nodes: Nodes::new(),
                    values: std::array::from_fn(|_| Vec::new()),
                    numbers: Vec::new(),
                    rough: [0.0; 3],
                };
                // the one that comes to it first: of the others it moves away
                let rate = here.motion.inputs[drive].rate.abs();
                let apart = (change - value).abs() / rate.max(f64::MIN_POSITIVE);
                if found.as_ref().is_none_or(|(least, _)| apart < *least) {
                    found = Some((apart, passage));
                }
            }
        }
        let (_, mut passage) = found?;
        let mut reduced = reduced.clone();
        for _ in 0..3 {
            let mut state = here.clone();
            if passage.covers(passage.here) && passage.run(plan, &mut reduced, &mut state) {
                passage.rough = passage.roughness(WIDTH + UNIT * reduced.free().len());
                return Some(passage);
            }
            passage.reach *= 0.5;
        }
        None
    }

    /// Moves the bodies as the inputs of a state say, no free coordinate accelerating, and finds what they do for a unit rate of each; `false`
    /// where they do not close, or do not move smoothly.
    pub fn run(&mut self, plan: &Plan, reduced: &mut Reduced, state: &mut State) -> bool {
        let value = state.motion.inputs[self.drive].value;
        self.here = value;
        if !self.find_change(plan, state) {
            return false;
        }
        set(state, self.drive, value);
        if !self.covers(value) {
            state.branches.copy_from_slice(self.branches(value));
            reduced.run_motion(plan, state);
            return state.motion.open.is_none();
        }
        let (low, high) = (self.change - self.reach, self.change + self.reach);
        let columns = reduced.free().len();
        for node in 0..NODES {
            let q = self.nodes.at(low, high, node);
            set(state, self.drive, q);
            state.branches.copy_from_slice(self.branches(q));
            reduced.run_motion(plan, state);
            if state.motion.open.is_some() {
                return false;
            }
            self.take(node, reduced, state);
        }
        set(state, self.drive, value);
        state.branches.copy_from_slice(self.branches(value));
        // what forces are found from is that of the place itself
        reduced.run_motion(plan, state);
        state.motion.open = None;
        state.motion.conditions.copy_from_slice(&self.conditions);
        self.put(polynomials(low, high, value), columns, reduced, state)
    }

    /// Takes all numbers at a node.
    fn take(&mut self, node: usize, reduced: &Reduced, state: &State) {
        let columns = reduced.free().len();
        let values = &mut self.values[node];
        values.clear();
        for (index, body) in state.motion.bodies.iter().enumerate() {
            let BodyState { p, u, v, omega, a, alpha, .. } = body;
            values.extend([p.x, p.y, u.x, u.y, v.x, v.y, *omega, a.x, a.y, *alpha]);
            for i in 0..columns {
                let (v, omega) = reduced.unit_motion(i, index);
                values.extend([v.x, v.y, omega]);
            }
        }
    }

    /// Puts all numbers at a place where Chebyshev's polynomials have these values; `false` where they are not smooth.
    fn put(
        &mut self,
        factors: [f64; NODES],
        columns: usize,
        reduced: &mut Reduced,
        state: &mut State,
    ) -> bool {
        let each = WIDTH + UNIT * columns;
        self.numbers.clear();
        self.numbers.resize(self.values[0].len(), 0.0);
        add_rows(&mut self.numbers, &self.values, &self.nodes.weights(&factors));
        let mut smooth = true;
        let bodies = state.motion.bodies.iter_mut().zip(self.numbers.chunks_exact(each));
        for (index, (body, n)) in bodies.enumerate() {
            // positions tell whether it is smooth
            smooth &= (0..4).all(|number| {
                let unit = if number < 2 { self.extent } else { 1.0 };
                let value = |node: usize| self.values[node][each * index + number];
                (NODES - 3..NODES).all(|k| self.nodes.coefficient(k, value).abs() <= SMOOTH * unit)
            });
            put_numbers(body, n);
            for (i, unit) in n[WIDTH..].chunks_exact(UNIT).enumerate() {
                reduced.set_unit_motion(i, index, (Vec2::new(unit[0], unit[1]), unit[2]));
            }
        }
        smooth
    }

    /// The greatest last term of the series of positions, velocities and accelerations, over the greatest number of that order; `each` is
    /// how many numbers a body has.
    fn roughness(&self, each: usize) -> [f64; 3] {
        let (mut greatest, mut left) = ([0.0_f64; 3], [0.0_f64; 3]);
        for index in (0..self.values[0].len()).filter(|index| index % each < WIDTH) {
            let (order, is_length) = (ORDERS[index % each], IS_LENGTH[index % each]);
            let unit = if is_length { self.extent } else { 1.0 };
            let value = |node: usize| self.values[node][index];
            for node in 0..NODES {
                greatest[order] = greatest[order].max(value(node).abs() / unit);
            }
            for k in NODES - 3..NODES {
                left[order] = left[order].max(self.nodes.coefficient(k, value).abs() / unit);
            }
        }
        std::array::from_fn(
            |order| if greatest[order] > 0.0 { OF_ALL * left[order] / greatest[order] } else { 0.0 },
        )
    }

    /// Finds about where the change point is, from where it was.
    fn find_change(&mut self, plan: &Plan, state: &mut State) -> bool {
        let guesses = [self.began, self.change, self.before];
        let found = guesses.into_iter().find_map(|guess| self.change_from(guess, plan, state));
        found.inspect(|change| self.change = *change).is_some()
    }

    /// About where it is, from regular places before a guess.
    fn change_from(&self, guess: f64, plan: &Plan, state: &mut State) -> Option<f64> {
        let mut change = guess;
        for _ in 0..GUESSES {
            let mut sigmas = [0.0; 2];
            let places = BEFORE.map(|part| change - self.ahead * part * self.reach);
            for (q, sigma) in places.into_iter().zip(&mut sigmas) {
                state.branches.copy_from_slice(&self.near);
                set(state, self.drive, q);
                state.run_motion::<1>(plan);
                if state.motion.open.is_some() {
                    return None;
                }
                *sigma = state.motion.conditions[self.group].abs();
            }
            let next = places[1] + (places[1] - places[0]) * sigmas[1] / (sigmas[0] - sigmas[1]);
            if !next.is_finite() || (next - guess).abs() > FARTHEST {
                return None;
            }
            let moved = (next - change).abs();
            change = next;
            if moved <= CLOSE * self.reach {
                return Some(change);
            }
        }
        None
    }

    fn covers(&self, q: f64) -> bool {
        (q - self.change).abs() <= self.reach
    }

    /// Whether the last evaluation was on it.
    pub fn is_on(&self) -> bool {
        self.covers(self.here)
    }

    /// The assemblies at a value of the coordinate.
    fn branches(&self, q: f64) -> &[Branch] {
        if (q - self.change) * self.ahead < 0.0 { &self.near } else { &self.far }
    }

    /// A group that changes.
    pub const fn group(&self) -> usize {
        self.group
    }

    /// A step has ended at the last evaluation. Whether the change point lies behind it; nothing where it is still near.
    pub fn accept(&mut self) -> Option<bool> {
        (self.before, self.began) = (self.began, self.change);
        let beyond = (self.here - self.change) * self.ahead;
        match beyond {
            _ if beyond > self.reach => Some(true),
            _ if beyond < -FARTHEST => Some(false),
            _ => None,
        }
    }
}

fn set(state: &mut State, drive: usize, value: f64) {
    let input = &mut state.motion.inputs[drive];
    (input.value, input.place) = (value, Vec2::direction(value));
}

/// The slots of the drives that move along a coordinate, free ones among them.
fn moving(reduced: &Reduced, here: &State) -> Vec<usize> {
    let inputs = here.motion.inputs.iter().enumerate();
    let driven = inputs.filter(|(_, input)| input.rate != 0.0 || input.acceleration != 0.0).map(|(i, _)| i);
    let driven = driven.filter(|drive| !reduced.free().contains(drive));
    reduced.free().iter().copied().chain(driven).collect()
}
