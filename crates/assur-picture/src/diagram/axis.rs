//! Axes with round steps: 1, 2, 2.5 or 5 × 10ᵏ, angles in parts of a turn.

use assur_drawing::plain;
use assur_math::math::SAME;

/// The series, of which the last is the first of the next power.
const SERIES: [f64; 5] = [1.0, 2.0, 2.5, 5.0, 10.0];
/// Steps of an angle in degrees.
const DEGREES: [f64; 13] = [0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0, 720.0];
/// The most digits behind the point; more are taken into a power of ten.
const DECIMALS: i32 = 4;
/// The least number that is written with a power of ten.
const LARGE: f64 = 1e5;

#[derive(Clone, Copy, Debug)]
pub struct Axis {
    pub from: f64,
    pub to: f64,
    /// From tick to tick.
    step: f64,
    /// Digits of a tick behind the point, before the power is taken out; fewer than none where its last ones are zeros.
    decimals: i32,
    /// Power of ten that is taken out of the numbers at the ticks.
    pub power: i32,
}

impl Axis {
    /// An axis up to the next ticks beyond two numbers, of about so many steps; null is on it where it is not far.
    #[must_use]
    pub fn around(least: f64, greatest: f64, parts: f64) -> Self {
        let (mut from, mut to) = (least.min(greatest), least.max(greatest));
        if !(from.is_finite() && to.is_finite()) {
            (from, to) = (0.0, 1.0);
        }
        let most = from.abs().max(to.abs());
        if to - from <= SAME * most || (from > 0.0 && from < 0.6 * to) || (to < 0.0 && to > 0.6 * from) {
            (from, to) = (from.min(0.0), to.max(0.0));
        }
        if to - from <= f64::MIN_POSITIVE {
            return Self::of_nothing();
        }
        let (step, decimals) = round_step((to - from) / parts);
        let least = (from / step + 1e-6).floor() * step;
        let greatest = (to / step - 1e-6).ceil() * step;
        Self { from: least, to: greatest, step, decimals, power: 0 }.with_power()
    }

    /// An axis with zero alone.
    const fn of_nothing() -> Self {
        Self { from: -1.0, to: 1.0, step: 2.0, decimals: 0, power: 0 }
    }

    /// Whether there is nothing on it but zero.
    #[must_use]
    pub fn is_of_nothing(&self) -> bool {
        self.step > self.to - self.from - f64::EPSILON
    }

    /// An axis from one number to another and not beyond.
    #[must_use]
    pub fn between(from: f64, to: f64, parts: f64, degrees: bool) -> Self {
        let (from, to) = (from.min(to), from.max(to));
        let wide = if to > from { to - from } else { 1.0 };
        let of_turn =
            DEGREES.into_iter().find(|step| *step >= wide / parts).filter(|_| degrees && wide > 3.0);
        let (step, decimals) =
            of_turn.map_or_else(|| round_step(wide / parts), |step| (step, i32::from(step < 1.0)));
        Self { from, to: from + wide, step, decimals, power: 0 }.with_power()
    }

    fn with_power(mut self) -> Self {
        let most = self.from.abs().max(self.to.abs());
        if most >= LARGE || self.decimals > DECIMALS {
            #[allow(clippy::cast_possible_truncation)] // logarithms of numbers
            let exponent = libm::floor(libm::log10(most)) as i32;
            self.power = exponent.div_euclid(3) * 3;
        }
        self
    }

    /// The ticks: their numbers, and how they are written.
    pub fn ticks(self) -> impl Iterator<Item = (f64, String)> {
        let first = (self.from / self.step - 1e-6).ceil();
        let last = (self.to / self.step + 1e-6).floor();
        let scale = libm::pow(10.0, f64::from(self.power));
        #[allow(clippy::cast_sign_loss, clippy::cast_possible_truncation)] // a few hundred at most
        let count = ((last - first).clamp(0.0, 400.0)) as u32;
        let decimals = usize::try_from(self.decimals + self.power).unwrap_or(0).min(12);
        (0..=count).map(move |i| {
            let value = (first + f64::from(i)) * self.step;
            let written = format!("{:.decimals$}", value / scale);
            let is_zero = written.chars().all(|c| matches!(c, '0' | '.' | '-'));
            (value, if is_zero { "0".to_owned() } else { written.replace('-', "−") })
        })
    }

    /// How far a number is along the axis: 0 at its begin, 1 at its end.
    #[must_use]
    pub fn share(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    /// The power of ten before the unit, `10³ `; empty where there is none.
    #[must_use]
    pub fn power_text(&self) -> String {
        match self.power {
            0 => String::new(),
            3 => "10³ ".to_owned(),
            -3 => "10⁻³ ".to_owned(),
            power => format!("{} ", plain(1.0, power)),
        }
    }
}

/// The least round step of at least this length, and its digits behind the point.
fn round_step(least: f64) -> (f64, i32) {
    #[allow(clippy::cast_possible_truncation)] // logarithms of numbers
    let exponent = libm::floor(libm::log10(least)) as i32;
    let power = |e: i32| -> f64 { format!("1e{e}").parse().unwrap_or(f64::NAN) };
    let found = SERIES.into_iter().find(|m| m * power(exponent) >= least * (1.0 - SAME));
    let (mantissa, exponent) = match found {
        Some(10.0) | None => (1.0, exponent + 1),
        Some(mantissa) => (mantissa, exponent),
    };
    let step: f64 = format!("{mantissa}e{exponent}").parse().unwrap_or(least);
    let decimals = if mantissa == 2.5 { 1 - exponent } else { -exponent };
    (step, decimals)
}
