//! The rank of the equations of velocity at random dimensions in a random position, by singular values.

use super::linkage::{Kind, Linkage};
use crate::support::random::Random;
use nalgebra::{DMatrix, DVector};

/// What is left over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Truth {
    /// Conditions too many.
    pub surplus: usize,
    /// Freedoms that nothing holds.
    pub missing: usize,
    /// Links that no drive moves, where everything is determined.
    pub immobile: Vec<usize>,
}

impl Truth {
    pub fn is_sound(&self) -> bool {
        (self.surplus, self.missing) == (0, 0)
    }
}

/// Singular values below this part of the largest are zero.
const ZERO: f64 = 1e-9;

pub fn truth(linkage: &Linkage, seed: u64) -> Truth {
    let (rows, rates) = equations(linkage, &mut Random::new(seed));
    let moving: Vec<usize> = (1..linkage.links.len()).filter(|l| linkage.links[*l]).collect();
    let columns: Vec<usize> = moving.iter().flat_map(|l| [3 * l, 3 * l + 1, 3 * l + 2]).collect();
    let matrix = DMatrix::from_fn(rows.len(), columns.len(), |i, k| rows[i][columns[k]]);
    if rows.is_empty() || columns.is_empty() {
        return Truth { surplus: rows.len(), missing: columns.len(), immobile: Vec::new() };
    }
    let svd = matrix.svd(true, true);
    let largest = svd.singular_values.max();
    let rank = svd.singular_values.iter().filter(|s| **s > ZERO * largest).count();
    let (surplus, missing) = (rows.len() - rank, columns.len() - rank);
    let mut immobile = Vec::new();
    if surplus == 0 && missing == 0 && !linkage.drives.is_empty() {
        let velocities = svd.solve(&DVector::from_vec(rates), ZERO).expect("both sides are there");
        let size = velocities.amax();
        let stands = |k: &usize| velocities.rows(3 * k, 3).amax() < 1e-7 * size;
        immobile = (0..moving.len()).filter(stands).map(|k| moving[k]).collect();
    }
    Truth { surplus, missing, immobile }
}

/// Rows over three columns per link (velocity of the origin, angular velocity), and the rates on their right.
fn equations(linkage: &Linkage, random: &mut Random) -> (Vec<Vec<f64>>, Vec<f64>) {
    let columns = 3 * linkage.links.len();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    // links that prismatic pairs keep parallel
    let mut parallel: Vec<usize> = (0..linkage.links.len()).collect();
    for pair in &linkage.pairs {
        let (at, n) = (random.vector(1.0), random.direction());
        let mut relative = |a: usize, b: usize, x: f64, y: f64, turn: f64| {
            let mut row = vec![0.0; columns];
            for (link, sign) in [(a, 1.0), (b, -1.0)].into_iter().filter(|l| l.0 != 0) {
                row[3 * link] += sign * x;
                row[3 * link + 1] += sign * y;
                row[3 * link + 2] += sign * turn;
            }
            rows.push(row);
        };
        match &pair.kind {
            Kind::Revolute(links) => {
                for &link in &links[1..] {
                    relative(link, links[0], 1.0, 0.0, -at.y);
                    relative(link, links[0], 0.0, 1.0, at.x);
                }
            }
            Kind::Prismatic(a, b) => {
                relative(*a, *b, n.x, n.y, at.x * n.y - at.y * n.x);
                let (from, to) = (parallel[*a], parallel[*b]);
                if from != to {
                    relative(*a, *b, 0.0, 0.0, 1.0);
                    parallel.iter_mut().filter(|p| **p == from).for_each(|p| *p = to);
                }
            }
            Kind::Slot(a, b) => relative(*a, *b, n.x, n.y, at.x * n.y - at.y * n.x),
        }
    }
    let mut rates = vec![0.0; rows.len()];
    for drive in &linkage.drives {
        let mut row = vec![0.0; columns];
        row[3 * drive + 2] = 1.0;
        rows.push(row);
        rates.push(random.within(1.0, 2.0));
    }
    (rows, rates)
}
