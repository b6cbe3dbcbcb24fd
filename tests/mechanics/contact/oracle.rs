//! Motions with friction, losses and stops in coordinates of all bodies, as independent of the solver as can be: differences of the
//! pairs' own equations, states by enumeration, fixed steps between events that are found by bisection. Slow and plain on purpose.
//!
//! An element rubs along a scalar of the positions. Its effort is `−s (Σ α |v| + s Σ β v + κ)` while it slides in the sense `s`; it lies
//! between both such efforts, times its ratio at rest, while it is held. `v` are multipliers of constraints.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]
#![allow(clippy::needless_range_loop, reason = "rows and columns of one matrix")]

mod motion;
mod states;

pub use motion::Failure;
use std::rc::Rc;

pub type Value = Rc<dyn Fn(&[f64]) -> f64>;

/// A scalar of the coordinates, and those on which it depends.
#[derive(Clone)]
pub struct Scalar {
    pub on: Vec<usize>,
    pub value: Value,
    /// without second derivatives, whose differences would be rounding
    pub linear: bool,
}

/// What is given for all time: value, rate and acceleration at an instant, on the smooth piece around another one.
pub type Law = Rc<dyn Fn(f64, f64) -> [f64; 3]>;
/// A load along a scalar, from the same two instants and the value of the scalar.
pub type Load = Rc<dyn Fn(f64, f64, f64) -> f64>;

/// A pair's equation or a drive. A bond can only press: the motion ends where it would pull.
pub struct Constraint {
    pub of: Scalar,
    pub law: Option<Law>,
    pub bond: bool,
}

/// A number or a plane vector of multipliers under bars, with its coefficients.
pub struct Part {
    pub even: f64,
    pub odd: f64,
    pub of: Vec<usize>,
}

/// What rubs. One that only drives move has the sense of its speed and is never held.
pub struct Element {
    pub of: Scalar,
    pub parts: Vec<Part>,
    pub capacity: Rc<dyn Fn(f64) -> f64>,
    pub at_rest: f64,
    pub driven: bool,
}

/// `sense (value − at) ≥ 0`.
pub struct Stop {
    pub of: Scalar,
    pub sense: f64,
    pub at: f64,
    pub restitution: f64,
}

#[derive(Default)]
pub struct System {
    pub mass: Vec<f64>,
    /// constant forces: weights
    pub weight: Vec<f64>,
    pub loads: Vec<(Scalar, Load)>,
    /// loads of constant size against the velocity of a point that moves in the plane
    pub drags: Vec<([Scalar; 2], f64)>,
    pub constraints: Vec<Constraint>,
    pub elements: Vec<Element>,
    pub stops: Vec<Stop>,
    /// where loads and drives are not smooth
    pub breaks: Vec<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rub {
    Slides(i8),
    Held,
    /// it only follows drives, which stand: what it bears is not determined
    Stands,
}

impl Rub {
    fn sense(self) -> f64 {
        if let Rub::Slides(sense) = self { f64::from(sense) } else { 0.0 }
    }
}

/// The state of a system, with the side of every part of every element.
#[derive(Clone, PartialEq, Debug)]
pub struct State {
    pub rubs: Vec<Rub>,
    pub sides: Vec<Vec<f64>>,
    pub closed: Vec<bool>,
}

/// Time, an instant on the same smooth piece, coordinates, rates.
#[derive(Clone)]
pub struct Point {
    pub time: f64,
    pub within: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
}

/// A scalar at a point: value, gradient, rate, the size of the terms of the rate, second derivative without accelerations.
pub struct Row {
    pub value: f64,
    pub gradient: Vec<f64>,
    pub rate: f64,
    pub terms: f64,
    pub bias: f64,
}

const DIFFERENCE: f64 = 1e-3;

impl Scalar {
    pub fn at(&self, point: &Point) -> Row {
        let mut q = point.q.clone();
        let mut gradient = vec![0.0; q.len()];
        let (mut rate, mut terms, mut fastest) = (0.0, 0.0, 0.0_f64);
        for &i in &self.on {
            let mut moved = |by: f64| {
                q[i] = point.q[i] + by * DIFFERENCE;
                (self.value)(&q)
            };
            gradient[i] =
                (8.0 * (moved(1.0) - moved(-1.0)) - (moved(2.0) - moved(-2.0))) / (12.0 * DIFFERENCE);
            q[i] = point.q[i];
            let term = gradient[i] * point.v[i];
            rate += term;
            terms += term.abs();
            fastest = fastest.max(point.v[i].abs());
        }
        let value = (self.value)(&q);
        let mut bias = 0.0;
        if fastest > 1e-30 && !self.linear {
            let step = 10.0 * DIFFERENCE / fastest;
            let mut moved = |by: f64| {
                for &i in &self.on {
                    q[i] = point.q[i] + by * step * point.v[i];
                }
                (self.value)(&q)
            };
            let (near, far) = (moved(1.0) + moved(-1.0), moved(2.0) + moved(-2.0));
            bias = (16.0 * near - far - 30.0 * value) / (12.0 * step * step);
        }
        Row { value, gradient, rate, terms, bias }
    }
}

/// All rows at a point.
pub struct Rows {
    pub constraints: Vec<Row>,
    pub elements: Vec<Row>,
    pub stops: Vec<Row>,
    /// what drives demand of their constraints
    pub laws: Vec<[f64; 3]>,
    pub forces: Vec<f64>,
}

impl System {
    pub fn rows(&self, point: &Point) -> Rows {
        let mut forces = self.weight.clone();
        let mut push = |row: &Row, force: f64| {
            for (sum, slope) in forces.iter_mut().zip(&row.gradient) {
                *sum += force * slope;
            }
        };
        for (of, load) in &self.loads {
            let row = of.at(point);
            push(&row, load(point.time, point.within, row.value));
        }
        for ([x, y], size) in &self.drags {
            let [x, y] = [x.at(point), y.at(point)];
            let speed = x.rate.hypot(y.rate).max(1e-300);
            push(&x, -size * x.rate / speed);
            push(&y, -size * y.rate / speed);
        }
        let law = |c: &Constraint| c.law.as_ref().map_or([0.0; 3], |law| law(point.time, point.within));
        Rows {
            constraints: self.constraints.iter().map(|c| c.of.at(point)).collect(),
            elements: self.elements.iter().map(|e| e.of.at(point)).collect(),
            stops: self.stops.iter().map(|s| s.of.at(point)).collect(),
            laws: self.constraints.iter().map(law).collect(),
            forces,
        }
    }

    /// Rates nearest to the given ones, by impulses along rows, with which the rows have the given rates.
    pub fn impulses(&self, v: &[f64], rows: &[(&[f64], f64)]) -> Option<(Vec<f64>, Vec<f64>)> {
        let (n, size) = (v.len(), v.len() + rows.len());
        let (mut k, mut b) = (vec![vec![0.0; size]; size], vec![0.0; size]);
        for i in 0..n {
            k[i][i] = self.mass[i];
            b[i] = self.mass[i] * v[i];
        }
        for (j, (row, rate)) in rows.iter().enumerate() {
            for i in 0..n {
                k[i][n + j] = -row[i];
                k[n + j][i] = row[i];
            }
            b[n + j] = *rate;
        }
        let mut x = solve(k, b)?.x;
        let impulses = x.split_off(n);
        Some((x, impulses))
    }
}

/// A solution of a small dense system, with its rank.
pub struct Solved {
    pub x: Vec<f64>,
    /// a basis of what may be added
    pub free: Vec<Vec<f64>>,
    /// the sign of the determinant
    pub sign: f64,
}

/// Below this part of the greatest entry a pivot is zero; above this part of the greatest right-hand side a row contradicts.
const ZERO: f64 = 1e-9;
const CONTRADICTS: f64 = 1e-7;

/// By elimination with full pivoting. Nothing, if the rows contradict each other.
pub fn solve(mut k: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Solved> {
    let n = b.len();
    let size = |row: &[f64]| row.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let least = ZERO * k.iter().map(|row| size(row)).fold(0.0, f64::max);
    let right = size(&b);
    let mut order: Vec<usize> = (0..n).collect();
    let (mut rank, mut sign) = (0, 1.0);
    while rank < n {
        let (mut most, mut at) = (least, None);
        for i in rank..n {
            for j in rank..n {
                if k[i][j].abs() > most {
                    (most, at) = (k[i][j].abs(), Some((i, j)));
                }
            }
        }
        let Some((i, j)) = at else { break };
        if i != rank {
            k.swap(i, rank);
            b.swap(i, rank);
            sign = -sign;
        }
        if j != rank {
            k.iter_mut().for_each(|row| row.swap(j, rank));
            order.swap(j, rank);
            sign = -sign;
        }
        sign *= k[rank][rank].signum();
        let (above, below) = k.split_at_mut(rank + 1);
        let pivot = &above[rank];
        for (row, by) in below.iter_mut().zip(rank + 1..n) {
            let factor = row[rank] / pivot[rank];
            if factor != 0.0 {
                for j in rank..n {
                    row[j] -= factor * pivot[j];
                }
                b[by] -= factor * b[rank];
            }
        }
        rank += 1;
    }
    if b[rank..].iter().any(|rest| rest.abs() > CONTRADICTS * right.max(1e-12)) {
        return None;
    }
    // with the last unknowns as they are given
    let back = |right: &dyn Fn(usize) -> f64, last: &[f64]| {
        let mut sorted = vec![0.0; n];
        sorted[rank..].copy_from_slice(last);
        for i in (0..rank).rev() {
            let sum: f64 = (i + 1..n).map(|j| k[i][j] * sorted[j]).sum();
            sorted[i] = (right(i) - sum) / k[i][i];
        }
        let mut x = vec![0.0; n];
        (0..n).for_each(|i| x[order[i]] = sorted[i]);
        x
    };
    let x = back(&|i| b[i], &vec![0.0; n - rank]);
    let unit = |at: usize| (rank..n).map(|i| if i == at { 1.0 } else { 0.0 }).collect::<Vec<_>>();
    let free = (rank..n).map(|at| back(&|_| 0.0, &unit(at))).collect();
    Some(Solved { x, free, sign: if rank == n { sign } else { 0.0 } })
}
