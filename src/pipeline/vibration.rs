//! Small vibrations about an equilibrium: det(K − ω² M) = 0 and λ² M + λ C + K = 0 in the coordinates of the equilibria.
//!
//! K are the derivatives of the efforts that hold the mechanism, C those by the speeds, and M follows from the kinetic energy at unit
//! speeds, T = ½ q̇ᵀ M q̇.

use super::equilibrium::Search;
use assur_model::model::{DriveId, Expr, Mode, Query};
use assur_model::structure;
use assur_position::plan;
use assur_position::position::DriveValue;
use nalgebra::{DMatrix, DVector};

/// Differences for the stiffness, rad or sizes of the mechanism.
const DIFFERENCE: f64 = 0.004;
/// Weights of the central difference of order 8, at one to four steps.
const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
/// An imaginary part below this part of the whole is rounding.
const REAL: f64 = 1e-9;

/// Stiffness, mass and damping in the coordinates of the equilibria.
pub(super) struct Small {
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    damping: DMatrix<f64>,
}

impl Small {
    /// Whether it vibrates about the equilibrium: all squares of frequencies are real and positive.
    pub(super) fn is_stable(&self) -> bool {
        self.squares().is_some_and(|all| all.iter().all(|(re, im)| *re > 0.0 && im.abs() <= REAL * re.abs()))
    }

    /// The eigenvalues of M⁻¹ K; where nothing has a mass, of K.
    fn squares(&self) -> Option<Vec<(f64, f64)>> {
        let matrix = match self.mass.clone().try_inverse() {
            Some(inverse) => inverse * &self.stiffness,
            None => self.stiffness.clone(),
        };
        let found = matrix.complex_eigenvalues();
        Some(found.iter().map(|value| (value.re, value.im)).collect())
    }

    /// The vibrations, with rising frequencies of the undamped motion; NaN where there is none.
    pub(super) fn modes(&self) -> Vec<Mode> {
        let n = self.stiffness.nrows();
        let nothing = Mode { natural: f64::NAN, ratio: f64::NAN, damped: f64::NAN };
        let Some(inverse) = self.mass.clone().try_inverse() else { return vec![nothing; n] };
        let natural = self.squares().unwrap_or_default().into_iter().map(|(re, im)| {
            let real = im.abs() <= REAL * re.abs();
            if real && re > 0.0 { re.sqrt() } else { f64::NAN }
        });
        let mut natural: Vec<f64> = natural.collect();
        natural.sort_by(f64::total_cmp);
        let mut modes = vec![nothing; n];
        modes.iter_mut().zip(natural).for_each(|(mode, natural)| mode.natural = natural);
        if let [one] = modes.as_mut_slice() {
            let (m, c) = (self.mass[(0, 0)], self.damping[(0, 0)]);
            one.ratio = c / (2.0 * m * one.natural);
            one.damped = one.natural * ((1.0 - one.ratio) * (1.0 + one.ratio)).sqrt();
            return modes;
        }
        let mut matrix = DMatrix::zeros(2 * n, 2 * n);
        matrix.view_mut((0, n), (n, n)).copy_from(&DMatrix::identity(n, n));
        matrix.view_mut((n, 0), (n, n)).copy_from(&-(&inverse * &self.stiffness));
        matrix.view_mut((n, n), (n, n)).copy_from(&-(&inverse * &self.damping));
        let mut pairs: Vec<(f64, f64)> = matrix
            .complex_eigenvalues()
            .iter()
            .filter(|value| value.im > 0.0)
            .map(|value| (value.re, value.im))
            .collect();
        pairs.sort_by(|a, b| libm::hypot(a.0, a.1).total_cmp(&libm::hypot(b.0, b.1)));
        // a pair of real values is no vibration, and the order of the others is not that of the undamped motion
        if pairs.len() == n {
            for (mode, (re, im)) in modes.iter_mut().zip(pairs) {
                (mode.ratio, mode.damped) = (-re / libm::hypot(re, im), im);
            }
        }
        modes
    }
}

impl Search {
    /// The small vibrations about an equilibrium; none where the positions around it do not exist.
    pub(super) fn small(&mut self, others: &[DriveValue], at: &[f64]) -> Option<Small> {
        let stiffness = self.stiffness(others, at)?;
        let n = at.len();
        let sought = self.sought.clone();
        let efforts = sought.iter().map(|i| Query::Effort(DriveId::at(*i))).collect::<Vec<_>>();
        let mut damped = self.moving(&efforts);
        // a central difference leaves out what goes with squares of speeds
        damped.mechanism.ignore_inertia = true;
        damped.plan = plan::plan(&damped.mechanism, &damped.structure);
        let mut energetic = self.moving(&[Query::KineticEnergy]);
        let unit = |k: usize, sign: f64, search: &mut Self| {
            let speeds: Vec<f64> = (0..n).map(|i| if i == k { sign } else { 0.0 }).collect();
            search.at_speeds(others, at, &speeds)
        };
        let mut damping = DMatrix::zeros(n, n);
        let mut mass = DMatrix::zeros(n, n);
        for k in 0..n {
            let (up, down) = (unit(k, 1.0, &mut damped)?, unit(k, -1.0, &mut damped)?);
            damping.set_column(k, &((DVector::from_vec(up) - DVector::from_vec(down)) / 2.0));
            mass[(k, k)] = 2.0 * unit(k, 1.0, &mut energetic)?.first()?;
        }
        for (i, k) in (0..n).flat_map(|i| (0..i).map(move |k| (i, k))) {
            let speeds: Vec<f64> = (0..n).map(|j| f64::from(u8::from(j == i || j == k))).collect();
            let both = *energetic.at_speeds(others, at, &speeds)?.first()?;
            let mixed = both - (mass[(i, i)] + mass[(k, k)]) / 2.0;
            (mass[(i, k)], mass[(k, i)]) = (mixed, mixed);
        }
        Some(Small { stiffness, mass, damping })
    }

    /// The derivatives of the efforts by differences of order 8.
    fn stiffness(&mut self, others: &[DriveValue], at: &[f64]) -> Option<DMatrix<f64>> {
        let n = at.len();
        let mut stiffness = DMatrix::zeros(n, n);
        for k in 0..n {
            let step = DIFFERENCE * self.sizes[k];
            let side = |sign: f64| {
                let moved = |i: usize| {
                    let mut point = at.to_vec();
                    point[k] += sign * step * i as f64;
                    point
                };
                (1..=WEIGHTS.len()).map(moved).collect::<Vec<_>>()
            };
            let (up, down) = (self.efforts(others, &side(1.0)), self.efforts(others, &side(-1.0)));
            let mut column = DVector::zeros(n);
            for ((up, down), weight) in up.into_iter().zip(down).zip(WEIGHTS) {
                column += (DVector::from_vec(up?) - DVector::from_vec(down?)) * (weight / step);
            }
            stiffness.set_column(k, &column);
        }
        Some(stiffness)
    }

    /// The same mechanism with speeds, of which something else is asked.
    fn moving(&self, asked: &[Query]) -> Self {
        let mut mechanism = self.mechanism.clone();
        for drive in &mut mechanism.drives {
            drive.speed = Some(Expr::number(0.0));
        }
        let found = structure::structure(&mechanism).map(|(structure, _)| structure);
        let structure = found.unwrap_or_else(|_| self.structure.clone());
        let mut search = Self {
            mechanism,
            structure,
            plan: self.plan.clone(),
            sought: self.sought.clone(),
            sizes: self.sizes.clone(),
            asked: Vec::new(),
            vibrates: false,
        };
        search.ask(asked);
        search
    }

    /// What is asked at a position, at these speeds of the drives sought.
    fn at_speeds(&mut self, others: &[DriveValue], at: &[f64], speeds: &[f64]) -> Option<Vec<f64>> {
        for (i, speed) in self.sought.iter().zip(speeds) {
            self.mechanism.drives[*i].speed = Some(Expr::number(*speed));
        }
        self.efforts(others, &[at.to_vec()]).pop()?
    }
}
