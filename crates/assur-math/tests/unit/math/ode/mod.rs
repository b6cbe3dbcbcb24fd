//! Integrators, against closed forms.

mod dop853;
mod energy;
mod event;
mod extrapolation;
mod radau;
mod trees;

use assur_math::math::ode::{Integrator, Real, Step, System, Undefined};

/// Rates by a closure.
pub struct Rates<F>(pub F);

impl<S, F: FnMut(S, &[S], &mut [S])> System<S> for Rates<F> {
    fn rates(&mut self, t: S, y: &[S], dy: &mut [S]) -> Result<(), Undefined> {
        (self.0)(t, y, dy);
        Ok(())
    }
}

/// Two bodies: places, then speeds.
pub fn kepler<S: Real>() -> impl System<S> {
    Rates(|_, y: &[S], dy: &mut [S]| {
        let square = y[0] * y[0] + y[1] * y[1];
        let cube = square * square.sqrt();
        (dy[0], dy[1], dy[2], dy[3]) = (y[2], y[3], -y[0] / cube, -y[1] / cube);
    })
}

/// Where two bodies begin, at the perihelion of an orbit of half axis 1.
pub fn perihelion<S: Real>(eccentricity: f64) -> [S; 4] {
    let e = S::of(eccentricity);
    [S::one() - e, S::zero(), S::zero(), ((S::one() + e) / (S::one() - e)).sqrt()]
}

/// Place and speed of two bodies by Kepler's equation.
pub fn orbit(eccentricity: f64, t: f64) -> [f64; 4] {
    let e = eccentricity;
    let mut anomaly = t;
    for _ in 0..60 {
        anomaly -= (anomaly - e * libm::sin(anomaly) - t) / (1.0 - e * libm::cos(anomaly));
    }
    let (sin, cos) = libm::sincos(anomaly);
    let (root, rate) = ((1.0 - e * e).sqrt(), 1.0 / (1.0 - e * cos));
    [cos - e, root * sin, -sin * rate, root * cos * rate]
}

/// Runs to the end.
pub fn run<S: Real, F: System<S>>(method: &mut impl Integrator<S>, system: &mut F, t: S, y: &[S], end: S) {
    method.start(system, t, y, end).expect("the start has rates");
    while method.step(system).expect("it goes on") == Step::Within {}
}

/// The greatest difference.
pub fn distance<S: Real>(a: &[S], b: &[S]) -> S {
    a.iter().zip(b).fold(S::zero(), |most, (a, b)| most.max((*a - *b).abs()))
}

/// sn and cn of u at modulus k, by the arithmetic–geometric mean; the quarter period.
pub fn jacobi(u: f64, k: f64) -> (f64, f64, f64) {
    let (mut a, mut b, mut c) = (vec![1.0], (1.0 - k * k).sqrt(), vec![k]);
    while c[c.len() - 1].abs() > 1e-15 {
        let last: f64 = a[a.len() - 1];
        a.push(0.5 * (last + b));
        c.push(0.5 * (last - b));
        b = (last * b).sqrt();
    }
    let n = a.len() - 1;
    let mut phi = f64::from(1 << n) * a[n] * u;
    for i in (1..=n).rev() {
        phi = 0.5 * (phi + libm::asin(c[i] / a[i] * libm::sin(phi)));
    }
    (libm::sin(phi), libm::cos(phi), std::f64::consts::FRAC_PI_2 / a[n])
}
