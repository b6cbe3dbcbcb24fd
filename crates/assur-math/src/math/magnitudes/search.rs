//! All solutions: signs of numbers and sectors of directions are tried in turn, and cut off as soon as linear bounds show
//! that nothing fits them.
//!
//! In a sector of half-angle δ a vector is a sum of its two edges with parts a, b ≥ 0, and its magnitude lies between
//! (a + b) cos δ and a + b. With the sign of a number given its magnitude is known. What is left are linear equations in
//! numbers ≥ 0: where they have no solution, neither has the system (`simplex`). Two solutions that share all sectors differ
//! by a solution of the linear system with some direction of each sector: where none of these is singular there is one at
//! most, and Newton's method finds it or not. Sectors are halved until either decides.

use super::AbsLinearSystem;
use super::simplex::Equations;
use crate::math::{Lu, Vec2};
use std::f64::consts::{FRAC_PI_4, PI};

/// Half-angle of the narrowest sector, rad.
const NARROWEST: f64 = 1e-7;
/// A direction so near the edge of a sector, rad, or a number below this part of the greatest, is inside.
const INSIDE: f64 = 1e-6;
/// Solutions that differ by less than this part of the terms are the same.
const SAME: f64 = 1e-8;
/// What a solution may leave of the equations.
const SOLVED: f64 = 1e-11;

/// What is known of a part: anything, or a direction with the half-angle of its sector; zero for a number's sign.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Sector {
    Whole,
    Around { direction: Vec2, half: f64 },
}

/// All solutions of a system with magnitudes.
#[derive(Clone, Debug, Default)]
pub struct Solutions {
    pub found: Vec<Vec<f64>>,
    /// There are no others.
    pub complete: bool,
    /// Multiplications or so that it took.
    pub work: f64,
}

/// What a node came to.
enum Verdict {
    /// Nothing fits, or what fits is found.
    Closed,
    /// This part has to be split.
    Split(usize),
    /// Neither, and no part can be split any further.
    Open,
}

struct Search<'a> {
    system: &'a AbsLinearSystem,
    /// Typical sizes of the unknowns against each other.
    sizes: Vec<f64>,
    found: Vec<Vec<f64>>,
}

impl AbsLinearSystem {
    /// All solutions, with `most_work` multiplications or so at most.
    #[must_use]
    pub fn solutions(&self, most_work: f64) -> Solutions {
        if self.parts.iter().all(|p| p.constant == Vec2::zero()) {
            return Solutions { found: vec![vec![0.0; self.len()]], complete: true, work: 0.0 };
        }
        let mut search = Search { system: self, sizes: self.typical(), found: Vec::new() };
        let mut complete = true;
        #[allow(clippy::cast_precision_loss)] // a few dozen
        let per_node = 8.0 * (self.len() + self.parts.len()).pow(3) as f64;
        let mut work = 0.0;
        let mut nodes = vec![vec![Sector::Whole; self.parts.len()]];
        while let Some(node) = nodes.pop() {
            work += per_node;
            if work > most_work {
                return Solutions { found: search.found, complete: false, work };
            }
            match search.examine(&node) {
                Verdict::Closed => {}
                Verdict::Open => complete = false,
                Verdict::Split(part) => {
                    for sector in halves(node[part], self.parts[part].plane) {
                        let mut child = node.clone();
                        child[part] = sector;
                        nodes.push(child);
                    }
                }
            }
        }
        Solutions { found: search.found, complete, work }
    }

    /// Whether there is one solution whatever the constants: no signs and directions make the linear system singular.
    #[must_use]
    pub fn unique(&self) -> bool {
        let search = Search { system: self, sizes: Vec::new(), found: Vec::new() };
        search.one_at_most(&vec![Sector::Whole; self.parts.len()])
    }

    /// The direction in which magnitudes feed on each other most: how large the unknowns are against each other.
    fn typical(&self) -> Vec<f64> {
        let mut sizes = vec![1.0; self.len()];
        for _ in 0..20 {
            let mut next = vec![0.0; self.len()];
            for part in &self.parts {
                let sum: f64 = part.slopes.iter().zip(&sizes).map(|(g, s)| g.norm() * s).sum();
                next[part.row] += self.weights[part.row].abs() * sum;
            }
            let most = next.iter().fold(f64::MIN_POSITIVE, |m: f64, x| m.max(*x));
            next.iter_mut().zip(&sizes).for_each(|(n, s)| *n = 0.5 * (*n / most + *s));
            sizes = next;
        }
        sizes
    }
}

impl Search<'_> {
    fn examine(&mut self, node: &[Sector]) -> Verdict {
        if !self.feasible(node) {
            return Verdict::Closed;
        }
        let one_at_most = self.one_at_most(node);
        if one_at_most {
            let found = self.system.newton(&vec![0.0; self.system.len()]);
            let started = self.centre(node).and_then(|start| self.system.newton(&start));
            for x in found.into_iter().chain(started).map(|f| f.x) {
                if self.system.residual(&x) <= SOLVED {
                    let inside = self.inside(node, &x);
                    self.keep(x);
                    if inside {
                        return Verdict::Closed;
                    }
                }
            }
        }
        let width = |p: usize| spread(node[p]) * self.influence(p);
        let can = |p: &usize| match node[*p] {
            Sector::Whole => true,
            Sector::Around { half, .. } => half > NARROWEST,
        };
        let split = (0..node.len()).filter(can).max_by(|a, b| width(*a).total_cmp(&width(*b)));
        match split {
            Some(part) => Verdict::Split(part),
            // all signs are given and the linear system has another solution than they say
            None if one_at_most => Verdict::Closed,
            None => Verdict::Open,
        }
    }

    fn keep(&mut self, x: Vec<f64>) {
        let sizes = self.system.sizes(&x);
        let same = |other: &Vec<f64>| {
            other.iter().zip(&x).zip(&sizes).all(|((a, b), size)| (a - b).abs() <= SAME * size)
        };
        if !self.found.iter().any(same) {
            self.found.push(x);
        }
    }

    /// How much a part adds to its row, relative to the unknown of the row.
    fn influence(&self, p: usize) -> f64 {
        let part = &self.system.parts[p];
        let sum: f64 = part.slopes.iter().zip(&self.sizes).map(|(g, s)| g.norm() * s).sum();
        self.system.weights[part.row].abs() * sum / self.sizes[part.row].max(f64::MIN_POSITIVE)
    }

    fn inside(&self, node: &[Sector], x: &[f64]) -> bool {
        let values: Vec<Vec2> = self.system.parts.iter().map(|p| p.at(x)).collect();
        let most = values.iter().map(|v| v.norm()).fold(0.0, f64::max);
        node.iter().zip(&values).all(|(sector, v)| match *sector {
            Sector::Whole => true,
            Sector::Around { direction, half } => {
                let angle = libm::atan2(direction.cross(*v).abs(), direction.dot(*v));
                angle <= half + INSIDE || v.norm() <= INSIDE * 1e-3 * most
            }
        })
    }

    /// The linear system with the middle direction of every sector, factored; `None` where it is singular.
    fn middle(&self, node: &[Sector]) -> Option<Lu> {
        let n = self.system.len();
        let mut middle = Lu::new(n);
        (0..n).for_each(|i| *middle.at_mut(i, i) = 1.0);
        for (part, sector) in self.system.parts.iter().zip(node) {
            let Sector::Around { direction, .. } = *sector else { continue };
            let weight = self.system.weights[part.row];
            for (j, slope) in part.slopes.iter().enumerate() {
                *middle.at_mut(part.row, j) += weight * direction.dot(*slope);
            }
        }
        middle.factor().then_some(middle)
    }

    /// The solution of that system.
    fn centre(&self, node: &[Sector]) -> Option<Vec<f64>> {
        let mut middle = self.middle(node)?;
        let mut x = vec![0.0; self.system.len()];
        for (part, sector) in self.system.parts.iter().zip(node) {
            if let Sector::Around { direction, .. } = *sector {
                x[part.row] -= self.system.weights[part.row] * direction.dot(part.constant);
            }
        }
        middle.solve(&mut x);
        Some(x)
    }

    /// Whether every choice of directions in the sectors gives a regular linear system: with its inverse in the middle and
    /// the greatest departures H from it, |A⁻¹| H has a spectral radius below 1.
    fn one_at_most(&self, node: &[Sector]) -> bool {
        let n = self.system.len();
        let Some(mut middle) = self.middle(node) else { return false };
        let mut departure = vec![0.0; n * n];
        for (part, sector) in self.system.parts.iter().zip(node) {
            let weight = self.system.weights[part.row].abs() * spread(*sector);
            for (j, slope) in part.slopes.iter().enumerate() {
                departure[part.row * n + j] += weight * slope.norm();
            }
        }
        // (1 − T) y = 1 has a positive solution
        let (mut test, mut column) = (Lu::new(n), vec![0.0; n]);
        for k in 0..n {
            column.fill(0.0);
            column[k] = 1.0;
            middle.solve(&mut column);
            for (i, inverse) in column.iter().enumerate() {
                for j in 0..n {
                    *test.at_mut(i, j) -= inverse.abs() * departure[k * n + j];
                }
            }
        }
        (0..n).for_each(|i| *test.at_mut(i, i) += 1.0);
        column.fill(1.0);
        test.factor() && {
            test.solve(&mut column);
            column.iter().all(|y| *y > 0.0)
        }
    }

    /// Whether the linear bounds of the sectors leave anything.
    fn feasible(&self, node: &[Sector]) -> bool {
        let parts = &self.system.parts;
        // the edges of each part, and behind them its magnitude where it is a number of its own
        let mut layout = Vec::with_capacity(parts.len());
        let mut columns = 0;
        for (part, sector) in parts.iter().zip(node) {
            let edges = edges(*sector, part.plane);
            let own = part.plane;
            let slacks = if own { 1 + usize::from(*sector != Sector::Whole) } else { 0 };
            let (first, count) = (columns, edges.len());
            columns += count + usize::from(own) + slacks;
            layout.push((first, edges));
        }
        let magnitude = |p: usize| {
            let (first, edges) = &layout[p];
            if parts[p].plane {
                *first + edges.len()..*first + edges.len() + 1
            } else {
                *first..*first + edges.len()
            }
        };
        let mut equations = Equations::new(columns);
        for (p, part) in parts.iter().enumerate() {
            let (first, edges) = &layout[p];
            // v − Σ g x = c with x_j = −w_j Σ |v|
            let mut add = |of: fn(Vec2) -> f64| {
                let row = equations.row(of(part.constant));
                for (i, edge) in edges.iter().enumerate() {
                    row[first + i] += of(*edge);
                }
                for (q, other) in parts.iter().enumerate() {
                    let slope = of(part.slopes[other.row]) * self.system.weights[other.row];
                    magnitude(q).for_each(|column| row[column] += slope);
                }
            };
            add(|v| v.x);
            if !part.plane {
                continue;
            }
            add(|v| v.y);
            bounds(&mut equations, node[p], *first, edges.len());
        }
        equations.feasible()
    }
}

/// The magnitude of a vector between its bounds by the parts along the edges.
fn bounds(equations: &mut Equations, sector: Sector, first: usize, edges: usize) {
    let magnitude = first + edges;
    let row = equations.row(0.0);
    (row[magnitude], row[magnitude + 1]) = (1.0, 1.0);
    row[first..magnitude].fill(-1.0);
    if let Sector::Around { half, .. } = sector {
        let row = equations.row(0.0);
        (row[magnitude], row[magnitude + 2]) = (1.0, -1.0);
        row[first..magnitude].fill(-libm::cos(half));
    }
}

/// How far a unit vector in the sector may be from the one it is reckoned with.
fn spread(sector: Sector) -> f64 {
    match sector {
        Sector::Whole => 1.0,
        Sector::Around { half, .. } => 2.0 * libm::sin(0.5 * half),
    }
}

/// Vectors of which a value in the sector is a sum with parts ≥ 0.
fn edges(sector: Sector, plane: bool) -> Vec<Vec2> {
    let (x, y) = (Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0));
    match sector {
        Sector::Whole if plane => vec![x, y, -x, -y],
        Sector::Whole => vec![x, -x],
        Sector::Around { direction, .. } if !plane => vec![direction],
        Sector::Around { direction, half } => {
            [-half, half].map(|angle| direction.turned(Vec2::direction(angle))).to_vec()
        }
    }
}

fn halves(sector: Sector, plane: bool) -> Vec<Sector> {
    let x = Vec2::new(1.0, 0.0);
    match sector {
        Sector::Whole if plane => [-0.75, -0.25, 0.25, 0.75]
            .map(|angle| Sector::Around { direction: Vec2::direction(angle * PI), half: FRAC_PI_4 })
            .to_vec(),
        Sector::Whole => [x, -x].map(|direction| Sector::Around { direction, half: 0.0 }).to_vec(),
        Sector::Around { direction, half } => [-0.5, 0.5]
            .map(|angle| Sector::Around {
                direction: direction.turned(Vec2::direction(angle * half)),
                half: 0.5 * half,
            })
            .to_vec(),
    }
}
