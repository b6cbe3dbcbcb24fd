//! Accelerations under loads without any reduction: all bodies with their masses, the constraints of all pairs with
//! multipliers, one linear system.

use crate::support::draft::Frame;
use crate::support::equilibrium::Outside;
use crate::support::reference::{Body, Rates, Solver, constraints, rollers};
use crate::support::run::Run;
use assur::internals::math::Vec2;
use assur::internals::model::{Mechanism, Simulation};
use assur::internals::source::Span;
use nalgebra::{DMatrix, DVector};

/// A mechanism whose free coordinates nothing holds.
pub struct Bodies {
    /// It with the drives that are prescribed alone.
    mechanism: Mechanism,
    mass: DMatrix<f64>,
}

impl Bodies {
    /// `None` where a link that is started would count as a roller, whose turning is left out, without its drive.
    pub fn new(mechanism: &Mechanism) -> Option<Self> {
        let with_drives = rollers(mechanism);
        let mut mechanism = mechanism.clone();
        mechanism.drives.retain(|drive| !drive.free);
        let n = 3 * (mechanism.links.len() - 1);
        (rollers(&mechanism) == with_drives).then(|| Self { mass: DMatrix::zeros(n, n), mechanism })
    }

    fn moving(frames: &[Frame], rates: &[Rates]) -> Vec<Body> {
        frames.iter().zip(rates).map(|(f, r)| Body::moving(f.p, f.u, r)).collect()
    }

    /// Derivatives of the constraints by the velocities of the bodies, row by row.
    pub fn jacobian(&self, frames: &[Frame], elapsed: f64) -> DMatrix<f64> {
        let mechanism = self.at(elapsed);
        let mut rates = vec![Rates::default(); frames.len()];
        let columns = 3 * (frames.len() - 1);
        let mut jacobian = DMatrix::zeros(0, columns);
        for column in 0..columns {
            let unit = &mut rates[1 + column / 3];
            match column % 3 {
                0 => unit.v.x = 1.0,
                1 => unit.v.y = 1.0,
                _ => unit.omega = 1.0,
            }
            let rows = constraints(&mechanism, &Self::moving(frames, &rates), false);
            if column == 0 {
                jacobian = DMatrix::zeros(rows.len(), columns);
            }
            rows.iter().enumerate().for_each(|(row, c)| jacobian[(row, column)] = c.rate);
            rates[1 + column / 3] = Rates::default();
        }
        jacobian
    }

    /// What the constraints and their rates miss.
    pub fn missing(&self, frames: &[Frame], rates: &[Rates], elapsed: f64) -> (DVector<f64>, DVector<f64>) {
        let mechanism = self.at(elapsed);
        let found = constraints(&mechanism, &Self::moving(frames, rates), true);
        let of = |f: fn(&crate::support::jet::Jet) -> f64| {
            DVector::from_iterator(found.len(), found.iter().map(f))
        };
        (of(|c| c.value), of(|c| c.rate))
    }

    /// The mechanism with its prescribed drives where they are so long after the first instant.
    fn at(&self, elapsed: f64) -> Mechanism {
        let mut mechanism = self.mechanism.clone();
        for drive in &mut mechanism.drives {
            prescribe(drive, elapsed);
        }
        mechanism
    }

    /// Accelerations of all bodies; whether a load depends on the sign of what is zero but for rounding.
    pub fn accelerations(
        &mut self,
        frames: &[Frame],
        rates: &[Rates],
        elapsed: f64,
    ) -> Option<(Vec<Rates>, bool)> {
        let jacobian = self.jacobian(frames, elapsed);
        let mut rates: Vec<Rates> = rates.to_vec();
        for rate in &mut rates {
            (rate.a, rate.alpha) = (Vec2::zero(), 0.0);
        }
        let bodies = Self::moving(frames, &rates);
        let mechanism = self.at(elapsed);
        let bias = constraints(&mechanism, &bodies, true);
        let outside = Outside::new(&mechanism, &bodies, &rates);
        self.masses(frames);
        let (n, m) = (self.mass.nrows(), jacobian.nrows());
        let mut matrix = DMatrix::zeros(n + m, n + m);
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.mass);
        matrix.view_mut((n, 0), (m, n)).copy_from(&jacobian);
        matrix.view_mut((0, n), (n, m)).copy_from(&-jacobian.transpose());
        let mut right = DVector::zeros(n + m);
        for (i, frame) in frames.iter().enumerate().skip(1) {
            let w = outside.applied[i];
            let moment = w.moment - frame.p.cross(w.force);
            for (k, x) in [w.force.x, w.force.y, moment].into_iter().enumerate() {
                right[3 * (i - 1) + k] = x;
            }
        }
        bias.iter().enumerate().for_each(|(i, c)| right[n + i] = -c.second);
        let solution = Solver::new(matrix)?.solve(&right)?;
        for (rate, x) in rates[1..].iter_mut().zip(solution.as_slice().chunks_exact(3)) {
            (rate.a, rate.alpha) = (Vec2::new(x[0], x[1]), x[2]);
        }
        Some((rates, outside.doubtful))
    }

    /// Masses by the accelerations of the bodies' origins.
    fn masses(&mut self, frames: &[Frame]) {
        for (i, (link, frame)) in self.mechanism.links.iter().zip(frames).enumerate().skip(1) {
            let Some(mass) = &link.mass else { continue };
            let (k, m, r) = (3 * (i - 1), mass.mass, mass.centre.turned(frame.u));
            for j in 0..2 {
                self.mass[(k + j, k + j)] = m;
            }
            let arm = [-m * r.y, m * r.x];
            for (j, x) in arm.into_iter().enumerate() {
                self.mass[(k + j, k + 2)] = x;
                self.mass[(k + 2, k + j)] = x;
            }
            self.mass[(k + 2, k + 2)] = mass.inertia + m * r.dot(r);
        }
    }
}

/// Puts a drive where it is so long after the first instant.
fn prescribe(drive: &mut assur::internals::model::Drive, elapsed: f64) {
    use crate::support::reference::number;
    use assur::internals::model::{Expr, Positions};
    let rate = drive.speed.as_ref().map_or(0.0, number);
    let second = drive.acceleration.as_ref().map_or(0.0, number);
    if let Positions::List(list) = &mut drive.positions {
        for x in list {
            *x = Expr::number(number(x) + (rate + 0.5 * second * elapsed) * elapsed);
        }
    }
    drive.speed = Some(Expr::number(rate + second * elapsed));
}

/// The mechanism, to be followed from its first position.
pub fn followed(mechanism: &mut Mechanism, to: f64, steps: Option<usize>, within: f64) {
    let span = Span::default();
    mechanism.simulation =
        Some(Simulation { span, from: 0.0, to, steps, within: Some(within), steady: None });
}

/// The last solved position of a run that went to its end.
pub fn last(run: &Run) -> Option<usize> {
    let solution = run.solution.as_ref().ok()?;
    solution.poses.iter().all(|pose| pose.outcome.is_ok()).then(|| solution.poses.len() - 1)
}
