//! Scale factors of the series: 1, 2, 2.5, 4 or 5 × 10ᵏ units per millimetre.

pub const SERIES: [f64; 5] = [1.0, 2.0, 2.5, 4.0, 5.0];

/// A scale factor: `mantissa` × 10^`exponent` units per millimetre of paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// One of the series.
    pub mantissa: f64,
    pub exponent: i32,
}

impl Scale {
    /// The smallest factor with which `units` fit into `millimetres`; `None` where there is nothing to fit.
    #[must_use]
    pub fn fitting(units: f64, millimetres: f64) -> Option<Self> {
        let least = units / millimetres;
        if !(least.is_finite() && least > 0.0) {
            return None;
        }
        // rounding makes no factor too small
        let least = least * (1.0 - 1e-12);
        #[allow(clippy::cast_possible_truncation)] // logarithms of numbers
        let first = libm::floor(libm::log10(least)) as i32 - 1;
        (first..first + 4)
            .flat_map(|exponent| SERIES.map(|mantissa| Self { mantissa, exponent }))
            .find(|scale| scale.factor() >= least)
    }

    /// The largest factor up to a number; `None` where that is no factor.
    #[must_use]
    pub fn largest(most: f64) -> Option<Self> {
        let least = Self::fitting(most, 1.0)?;
        if least.factor() <= most * (1.0 + 1e-9) {
            return Some(least);
        }
        let at = SERIES.iter().position(|m| m.to_bits() == least.mantissa.to_bits())?;
        Some(match at.checked_sub(1) {
            Some(before) => Self { mantissa: SERIES[before], ..least },
            None => Self { mantissa: 5.0, exponent: least.exponent - 1 },
        })
    }

    /// Units per millimetre: the number that its decimal digits make.
    #[must_use]
    pub fn factor(&self) -> f64 {
        format!("{}e{}", self.mantissa, self.exponent).parse().unwrap_or(f64::NAN)
    }

    /// As a program reads it: `0.005`, `4e-9`.
    #[must_use]
    pub fn written(&self) -> String {
        match self.exponent {
            -4..=4 => self.text(),
            exponent => format!("{}e{exponent}", self.mantissa),
        }
    }

    /// As it is printed: `0.005`, `2.5`, `4·10⁻⁹`.
    #[must_use]
    pub fn text(&self) -> String {
        plain(self.mantissa, self.exponent)
    }
}

/// A number of few digits times a power of ten, as it is printed.
#[must_use]
pub fn plain(mantissa: f64, exponent: i32) -> String {
    if (-4..=4).contains(&exponent) {
        let value: f64 = format!("{mantissa}e{exponent}").parse().unwrap_or(f64::NAN);
        return format!("{value}");
    }
    let power = ten_to(exponent);
    if (mantissa - 1.0).abs() < f64::EPSILON { power } else { format!("{mantissa}·{power}") }
}

/// A power of ten as it is printed: `10⁻⁴`.
#[must_use]
pub fn ten_to(exponent: i32) -> String {
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

const fn raised(c: char) -> char {
    match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

/// A round length for a scale bar: 1, 2 or 5 × 10ᵏ units, the longest up to `most` millimetres. Its mantissa and exponent.
#[must_use]
pub fn round_length(scale: &Scale, most: f64) -> (f64, i32) {
    let units = scale.factor() * most;
    #[allow(clippy::cast_possible_truncation)] // logarithms of numbers
    let first = libm::floor(libm::log10(units)) as i32 - 1;
    (first..first + 3)
        .flat_map(|exponent| [1.0, 2.0, 5.0].map(|mantissa| (mantissa, exponent)))
        .take_while(|(mantissa, exponent)| {
            mantissa * libm::pow(10.0, f64::from(*exponent)) <= units * (1.0 + 1e-9)
        })
        .last()
        .unwrap_or((1.0, first))
}
