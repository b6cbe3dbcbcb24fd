//! Integrals by adaptive Gauss–Kronrod quadrature (A. S. Kronrod 1965): the rules of 7 and 15 places, the part with the
//! greatest error is halved until the sum of the errors is small enough. Error estimate of R. Piessens, E. de
//! Doncker-Kapenga, C. W. Überhuber, D. K. Kahaner, QUADPACK (1983).

use super::scalar::{Real, epsilon, finite, wide};
use std::f64::consts::TAU;

/// Places of the 15-point rule, from the end of [−1, 1] to its middle; every second one is of the 7-point rule. In two
/// parts, computed with 60 digits as zeros of P₇ and of its Stieltjes polynomial.
const PLACES: [[f64; 2]; 8] = [
    [0.991_455_371_120_812_6, 2.732_206_749_538_298_5e-17],
    [0.949_107_912_342_758_5, 3.825_796_587_866_57e-17],
    [0.864_864_423_359_769_1, -2.388_778_344_758_419_7e-17],
    [0.741_531_185_599_394_5, -2.022_013_477_406_989_7e-17],
    [0.586_087_235_467_691_1, -1.746_697_080_598_481_7e-17],
    [0.405_845_151_377_397_2, -1.724_927_544_754_71e-17],
    [0.207_784_955_007_898_48, -1.322_698_778_629_045e-17],
    [0.0, 0.0],
];

const KRONROD: [[f64; 2]; 8] = [
    [0.022_935_322_010_529_224, 5.957_180_517_223_158e-19],
    [0.063_092_092_629_978_56, -4.536_585_404_360_517e-18],
    [0.104_790_010_322_250_19, -3.906_585_979_588_14e-18],
    [0.140_653_259_715_525_92, -2.484_164_787_968_961e-19],
    [0.169_004_726_639_267_9, -7.566_432_909_858_09e-18],
    [0.190_350_578_064_785_42, -9.616_513_280_901_216e-18],
    [0.204_432_940_075_298_89, 6.740_401_802_865_974e-18],
    [0.209_482_141_084_727_82, 9.321_252_782_204_223e-18],
];

/// Weights of the 7-point rule.
const GAUSS: [[f64; 2]; 4] = [
    [0.129_484_966_168_869_7, -9.625_448_970_284_404e-18],
    [0.279_705_391_489_276_64, 2.326_718_022_171_713_8e-17],
    [0.381_830_050_505_118_9, 2.186_274_792_382_482_2e-17],
    [0.417_959_183_673_469_4, -1.549_780_711_925_728_8e-17],
];

/// How the integrand grows towards an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    Smooth,
    /// As one over the root of the distance, as time does towards a turning point.
    InverseRoot,
}

/// A place within the interval, with its distances from both ends: next to an end their difference would lose digits.
#[derive(Clone, Copy, Debug)]
pub struct Place<S> {
    pub x: S,
    /// It less the beginning.
    pub from_start: S,
    /// The end less it.
    pub to_end: S,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral<S> {
    pub value: S,
    /// The estimate of its error.
    pub error: S,
    /// Evaluations of the integrand.
    pub evaluations: usize,
    /// The error is within what was allowed, or as small as rounding lets it be.
    pub reached: bool,
}

/// Room for the parts of an interval, taken once.
#[derive(Clone, Debug)]
pub struct Quadrature<S> {
    parts: Vec<Part<S>>,
    most: usize,
}

/// A part of [0, 1].
#[derive(Clone, Copy, Debug)]
struct Part<S> {
    middle: S,
    half: S,
    value: S,
    error: S,
    /// No better than rounding.
    exact: bool,
}

/// An interval as the image of [0, 1].
#[derive(Clone, Copy, Debug)]
struct Interval<S> {
    from: S,
    length: S,
    ends: (End, End),
}

impl<S: Real> Interval<S> {
    /// The place at u and dx/du: x = a + (b − a)p(u) with p = u, u² and 1 − (1 − u)² at one end, u²(3 − 2u) at both, so that
    /// f dx/du is smooth where f grows as one over a root. `v` = 1 − u.
    fn place(&self, u: S, v: S) -> (Place<S>, S) {
        let two = S::of(2.0);
        let (p, q, rate) = match self.ends {
            (End::Smooth, End::Smooth) => (u, v, S::one()),
            (End::InverseRoot, End::Smooth) => (u * u, v * (S::one() + u), two * u),
            (End::Smooth, End::InverseRoot) => (u * (S::one() + v), v * v, two * v),
            (End::InverseRoot, End::InverseRoot) => {
                (u * u * (S::one() + two * v), v * v * (S::one() + two * u), S::of(6.0) * u * v)
            }
        };
        let place =
            Place { x: self.from + self.length * p, from_start: self.length * p, to_end: self.length * q };
        (place, self.length * rate)
    }
}

impl<S: Real> Quadrature<S> {
    /// Room for so many parts.
    #[must_use]
    pub fn new(parts: usize) -> Self {
        let most = parts.max(1);
        Self { parts: Vec::with_capacity(most), most }
    }

    /// ∫ f from a to b to an absolute error or one relative to it, whichever is greater, or as far as there is room.
    ///
    /// # Errors
    /// That of the integrand.
    pub fn integrate<E>(
        &mut self,
        (a, b): (S, S),
        ends: (End, End),
        (absolute, relative): (f64, f64),
        mut f: impl FnMut(Place<S>) -> Result<S, E>,
    ) -> Result<Integral<S>, E> {
        let interval = Interval { from: a, length: b - a, ends };
        let half = S::of(0.5);
        self.parts.clear();
        self.parts.push(part(&interval, half, half, &mut f)?);
        loop {
            let mut integral = self.sum();
            let allowed = S::of(absolute).max(S::of(relative) * integral.value.abs());
            let number = finite(integral.value) && finite(integral.error);
            integral.reached = number && !allowed.lt(integral.error);
            let worst = self.parts.iter().enumerate().filter(|(_, part)| !part.exact);
            let worst = worst.reduce(|most, next| if most.1.error.lt(next.1.error) { next } else { most });
            let Some((i, &worst)) = worst else { return Ok(Integral { reached: number, ..integral }) };
            if integral.reached || self.parts.len() == self.most {
                return Ok(integral);
            }
            let half = half * worst.half;
            self.parts[i] = part(&interval, worst.middle - half, half, &mut f)?;
            self.parts.push(part(&interval, worst.middle + half, half, &mut f)?);
        }
    }

    fn sum(&self) -> Integral<S> {
        let (value, error) = self
            .parts
            .iter()
            .fold((S::zero(), S::zero()), |(value, error), part| (value + part.value, error + part.error));
        // each halving replaced one part by two
        Integral { value, error, evaluations: 15 * (2 * self.parts.len() - 1), reached: false }
    }
}

/// Both rules on a part.
fn part<S: Real, E>(
    interval: &Interval<S>,
    middle: S,
    half: S,
    f: &mut impl FnMut(Place<S>) -> Result<S, E>,
) -> Result<Part<S>, E> {
    let mut values = [S::zero(); 15];
    let (mut kronrod, mut gauss, mut magnitude) = (S::zero(), S::zero(), S::zero());
    for (j, (place, weight)) in PLACES.iter().zip(KRONROD).enumerate() {
        let offset = half * wide(*place);
        let sides: &[S] = if j == 7 { &[offset] } else { &[-offset, offset] };
        for (side, &offset) in sides.iter().enumerate() {
            let (place, rate) = interval.place(middle + offset, (S::one() - middle) - offset);
            let value = f(place)? * rate;
            values[2 * j + side] = value;
            kronrod = kronrod + wide::<S>(weight) * value;
            magnitude = magnitude + wide::<S>(weight) * value.abs();
            if j % 2 == 1 {
                gauss = gauss + wide::<S>(GAUSS[j / 2]) * value;
            }
        }
    }
    let mean = half_of(kronrod);
    let spread = values
        .iter()
        .enumerate()
        .fold(S::zero(), |spread, (i, value)| spread + wide::<S>(KRONROD[i / 2]) * (*value - mean).abs());
    let (mut error, spread) = ((kronrod - gauss).abs() * half, spread * half);
    if S::zero().lt(spread) {
        // (200 |K − G| / spread)^(3/2): the 15-point rule is that much better than the difference says
        let ratio = S::of(200.0) * error / spread;
        error = spread * S::one().min(ratio * ratio.sqrt());
    }
    let rounding = S::of(50.0) * epsilon::<S>() * magnitude * half;
    let exact = !rounding.lt(error);
    Ok(Part { middle, half, value: kronrod * half, error: error.max(rounding), exact })
}

fn half_of<S: Real>(x: S) -> S {
    x * S::of(0.5)
}

// Means of smooth periodic quantities from equally spaced samples.
//
// The mean of N samples over a period is wrong by the Fourier coefficients c_N, c_2N, …, which fall geometrically where
// the quantity is analytic (Trefethen and Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56, 2014).
// The coefficients up to N/2 follow from the same samples: how they fall from the greatest of them to those between
// 3N/8 and N/2 tells the rest.

/// A mean with the error it was estimated to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    pub value: f64,
    /// Estimated error, rounding included.
    pub error: f64,
    /// The greatest magnitude of the samples.
    pub scale: f64,
}

impl Mean {
    /// Whether the error is within a part of the greatest magnitude, or more samples would not help.
    #[must_use]
    pub fn has_converged(&self, tolerance: f64) -> bool {
        self.error <= tolerance.max(16.0 * f64::EPSILON) * self.scale
    }
}

/// The mean of equally spaced samples over one period.
#[must_use]
#[allow(clippy::cast_precision_loss)] // numbers of samples are far below 2^52
pub fn mean(samples: &[f64]) -> Mean {
    let n = samples.len();
    let scale = samples.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    let value = samples.iter().sum::<f64>() / n.max(1) as f64;
    let cosines: Vec<f64> = (0..n).map(|i| libm::cos(TAU * i as f64 / n as f64)).collect();
    let magnitude = |k: usize| {
        let (mut re, mut im) = (0.0, 0.0);
        for (j, f) in samples.iter().enumerate() {
            // sin x = cos(x − a quarter turn)
            re += f * cosines[(k * j) % n];
            im += f * cosines[(k * j + n - n / 4) % n];
        }
        libm::hypot(re, im) / n as f64
    };
    let first = 3 * n / 8 + 1;
    let (peak, head) = (1..=n / 2)
        .map(|k| (k, magnitude(k)))
        .fold((1, 0.0), |most, here| if here.1 > most.1 { here } else { most });
    let tail = (first..=n / 2).map(magnitude).fold(0.0, f64::max);
    // from the peak to the tail the coefficients fall as they go on falling to the N-th
    let further = if peak < first { (n - peak) as f64 / (first - peak) as f64 } else { 1.0 };
    let smooth = if head > 0.0 { 4.0 * head * libm::pow(tail / head, further.min(4.0)) } else { 0.0 };
    let window = |from: usize, to: usize| (from + 1..=to).map(magnitude).fold(0.0, f64::max);
    // fewer tell nothing of how they fall
    let kinked = if n < 16 { 0.0 } else { kinked(window(n / 8, n / 4), window(n / 4, 3 * n / 8), tail) };
    let left_off = smooth.max(kinked);
    Mean { value, error: left_off + 2.0 * f64::EPSILON * scale, scale }
}

/// What is left off where the coefficients fall slower and slower, as a power of their number: after a kink. Given are the
/// greatest beyond an eighth, a quarter and three eighths of the number of samples.
fn kinked(first: f64, second: f64, third: f64) -> f64 {
    // of a smooth function each is the same part of the one before, or less
    if third * first <= 1.4 * second * second {
        return 0.0;
    }
    let power = libm::log(second / third) / libm::log(1.5);
    4.0 * third * libm::pow(3.0 / 8.0, power.max(0.0))
}
