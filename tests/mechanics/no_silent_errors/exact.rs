//! The true motion near an answer: the constraints of all pairs solved in double-double by Newton's method from where the
//! answer is, the rates by refinement.

use crate::hard::double_double::DoubleDouble;
use crate::support::reference::{Body, Direction, Rates, Solver, constraints};
use assur::internals::math::{Scalar, V2, Vec2};
use assur::internals::model::Mechanism;
use nalgebra::{DMatrix, DVector};

type Real = DoubleDouble;

impl Direction for Real {
    /// The power series of a 1024th of the angle, doubled ten times.
    fn direction(angle: f64) -> V2<Self> {
        const DOUBLINGS: i32 = 10;
        let x = Self::of(angle * 0.5_f64.powi(DOUBLINGS));
        let square = x * x;
        // cos − 1 and sin: what is doubled is the small part
        let (mut versed, mut sine, mut term) = (Self::zero(), x, x);
        let mut even = Self::one();
        for k in 1..12 {
            let k = f64::from(k);
            even = -even * square / Self::of((2.0 * k - 1.0) * (2.0 * k));
            versed = versed + even;
            term = -term * square / Self::of(2.0 * k * (2.0 * k + 1.0));
            sine = sine + term;
        }
        for _ in 0..DOUBLINGS {
            // cos 2x − 1 = −2 sin², sin 2x = 2 sin (1 + (cos − 1))
            let twice = sine + sine;
            (versed, sine) = (-(twice * sine), twice + twice * versed);
        }
        V2::new(Self::one() + versed, sine)
    }
}

/// Where the links truly are and how they move.
pub struct Exact {
    pub p: Vec<V2<Real>>,
    pub u: Vec<V2<Real>>,
    pub rates: Vec<Rates<Real>>,
}

/// Steps of Newton's method, each with its own Jacobian.
const STEPS: usize = 12;

impl Exact {
    /// The solution that Newton's method finds from these poses; `None` where it does not converge, or where the
    /// constraints do not determine the motion.
    pub fn new(mechanism: &Mechanism, poses: &[(Vec2, Vec2)], size: f64) -> Option<Self> {
        let rest = vec![Rates::default(); poses.len()];
        let p = poses.iter().map(|x| V2::of(x.0)).collect();
        let u = poses.iter().map(|x| unit(V2::of(x.1))).collect();
        let mut exact = Self { p, u, rates: rest };
        let mut solver = None;
        for step in 0..STEPS {
            let here = exact.solver(mechanism, size)?;
            let values = exact.evaluate(mechanism, false);
            let moved = exact.step(&here, &values.iter().map(|c| c.value.0).collect::<Vec<_>>(), size)?;
            solver = Some(here);
            if moved < 1e-19 {
                break;
            }
            if step + 1 == STEPS {
                return None;
            }
        }
        exact.solve_rates(mechanism, &solver?, size).then_some(exact)
    }

    fn bodies(&self) -> Vec<Body<Real>> {
        let poses = self.p.iter().zip(&self.u).zip(&self.rates);
        poses.map(|((p, u), rates)| Body::moving(*p, *u, rates)).collect()
    }

    fn evaluate(&self, mechanism: &Mechanism, driven: bool) -> Vec<crate::support::jet::Jet<Real>> {
        constraints(mechanism, &self.bodies(), driven)
    }

    /// The Jacobian here, in f64, translations counted in `size`.
    fn solver(&self, mechanism: &Mechanism, size: f64) -> Option<Solver> {
        let n = 3 * (self.p.len() - 1);
        let at = |x: V2<Real>| Vec2::new(x.x.0, x.y.0);
        let mut rates = vec![Rates::<f64>::default(); self.p.len()];
        let mut columns = Vec::with_capacity(n);
        for column in 0..n {
            let one = &mut rates[1 + column / 3];
            match column % 3 {
                0 => one.v.x = size,
                1 => one.v.y = size,
                _ => one.omega = 1.0,
            }
            let poses = self.p.iter().zip(&self.u).zip(&rates);
            let bodies: Vec<_> = poses.map(|((p, u), r)| Body::moving(at(*p), at(*u), r)).collect();
            columns.push(constraints(mechanism, &bodies, false).iter().map(|c| c.rate).collect::<Vec<_>>());
            rates[1 + column / 3] = Rates::default();
        }
        let rows = columns[0].len();
        let matrix = DMatrix::from_fn(rows, n, |i, j| columns[j][i]);
        matrix.iter().all(|x| x.is_finite()).then(|| Solver::of_any_rank(matrix))
    }

    /// Takes a step off the poses; how large it was.
    fn step(&mut self, solver: &Solver, residual: &[f64], size: f64) -> Option<f64> {
        let step = solver.solve(&DVector::from_column_slice(residual))?;
        let mut most = 0.0_f64;
        for (i, x) in step.as_slice().chunks_exact(3).enumerate() {
            most = most.max(x[0].abs()).max(x[1].abs()).max(x[2].abs());
            let (p, u) = (&mut self.p[i + 1], &mut self.u[i + 1]);
            *p -= V2::new(Real::of(x[0] * size), Real::of(x[1] * size));
            *u = unit(*u - u.perp() * Real::of(x[2]));
        }
        most.is_finite().then_some(most)
    }

    /// Velocities, then accelerations, each refined with the residuals in double-double.
    fn solve_rates(&mut self, mechanism: &Mechanism, solver: &Solver, size: f64) -> bool {
        for second in [false, true] {
            let mut largest = 0.0_f64;
            for _ in 0..6 {
                let right = self.evaluate(mechanism, true);
                let right: Vec<f64> =
                    right.iter().map(|c| if second { c.second.0 } else { c.rate.0 }).collect();
                let Some(step) = solver.solve(&DVector::from_vec(right)) else { return false };
                let most = step.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                if !most.is_finite() {
                    return false;
                }
                for (rates, x) in self.rates[1..].iter_mut().zip(step.as_slice().chunks_exact(3)) {
                    let (v, turn) = if second {
                        (&mut rates.a, &mut rates.alpha)
                    } else {
                        (&mut rates.v, &mut rates.omega)
                    };
                    *v -= V2::new(Real::of(x[0] * size), Real::of(x[1] * size));
                    *turn = *turn - Real::of(x[2]);
                }
                largest = largest.max(most);
                if most <= 1e-20 * largest {
                    break;
                }
            }
        }
        true
    }
}

fn unit(u: V2<Real>) -> V2<Real> {
    let n = u.norm();
    V2::new(u.x / n, u.y / n)
}

#[test]
fn directions_are_exact() {
    // cosines and sines as sums of two doubles, from mpmath with 50 digits
    let known = [
        (
            1.0,
            [0.540_302_305_868_139_8, -4.760_954_612_604_417e-17],
            [0.841_470_984_807_896_5, 1.776_845_092_935_536e-18],
        ),
        (4.0, [-0.6536436208636119, 2.5846614087018284e-17], [-0.7568024953079282, -4.892224089158451e-17]),
        (
            -2.7,
            [-0.904_072_142_017_061_2, -1.508_192_658_397_614_2e-17],
            [-0.427_379_880_233_829_8, 4.685_701_930_940_738e-18],
        ),
    ];
    for (angle, cosine, sine) in known {
        let u = Real::direction(angle);
        for (got, want) in [(u.x, cosine), (u.y, sine)] {
            let error = (got - DoubleDouble(want[0], want[1])).0.abs();
            assert!(error < 1e-29, "{angle}: {got:?} for {want:?}");
        }
    }
}
