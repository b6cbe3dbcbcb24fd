//! Numbers as they are printed, with the value that a reader takes from them.

/// A printed number: sign and digits with a decimal point, and a power of ten.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figures {
    pub digits: String,
    /// It has a minus sign.
    pub negative: bool,
    /// The power of ten, 0 where there is none.
    pub exponent: i32,
}

/// Numbers from here on, and below the second, have a power of ten.
pub(crate) const LARGE: f64 = 1e7;
const SMALL: f64 = 1e-4;

impl Figures {
    /// 0
    #[must_use]
    pub fn zero() -> Self {
        Self { digits: "0".to_owned(), negative: false, exponent: 0 }
    }

    #[must_use]
    pub fn whole(n: i64) -> Self {
        Self { digits: n.unsigned_abs().to_string(), negative: n < 0, exponent: 0 }
    }

    /// The value that is read from it.
    #[must_use]
    pub fn value(&self) -> f64 {
        let text = format!("{}e{}", self.digits, self.exponent);
        let value: f64 = text.parse().unwrap_or(f64::NAN);
        if self.negative { -value } else { value }
    }

    /// One unit of its last digit.
    #[must_use]
    pub fn last_digit(&self) -> f64 {
        let decimals = self.digits.split_once('.').map_or(0, |(_, d)| d.len());
        let decimals = i32::try_from(decimals).unwrap_or(0);
        libm::pow(10.0, f64::from(self.exponent - decimals))
    }

    /// As text: `−3.0193`, `1.2000·10⁻⁷`.
    #[must_use]
    pub fn text(&self) -> String {
        let sign = if self.negative { "−" } else { "" };
        if self.exponent == 0 {
            return format!("{sign}{}", self.digits);
        }
        format!("{sign}{}·10{}", self.digits, raised(self.exponent))
    }
}

/// A power as raised digits.
pub(crate) fn raised(n: i32) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        c => char::from_u32(0x2070 + (c as u32 - 0x30)).unwrap_or(c),
    };
    n.to_string().chars().map(digit).collect()
}

/// The power of ten of the first digit.
fn magnitude(x: f64) -> i32 {
    let text = format!("{:e}", x.abs());
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// A value with this number of significant digits, those before the point all.
#[must_use]
pub fn with_digits(x: f64, digits: usize) -> Figures {
    if x == 0.0 || !x.is_finite() {
        return Figures::zero();
    }
    // rounding may give one digit more before the point
    let rounded: f64 = format!("{:.*e}", digits.saturating_sub(1), x).parse().unwrap_or(x);
    let first = magnitude(rounded);
    let last = first - i32::try_from(digits).unwrap_or(5) + 1;
    with_decimals(x, -last)
}

/// A value with this number of decimals; none where that is negative.
#[must_use]
pub fn with_decimals(x: f64, decimals: i32) -> Figures {
    let size = x.abs();
    let exponent = if size >= LARGE || size > 0.0 && size < SMALL { magnitude(x) } else { 0 };
    let after = usize::try_from(decimals + exponent).unwrap_or(0);
    let digits = if exponent == 0 {
        format!("{size:.after$}")
    } else {
        // through the decimal form, so that nothing is rounded twice
        let text = format!("{size:.after$e}");
        text.split_once('e').map_or(text.clone(), |(mantissa, _)| mantissa.to_owned())
    };
    let nothing = digits.chars().all(|c| c == '0' || c == '.');
    Figures { negative: x < 0.0 && !nothing, digits, exponent: if nothing { 0 } else { exponent } }
}

/// A value in units of a power of ten, with this number of decimals.
pub(crate) fn with_power(x: f64, exponent: i32, decimals: usize) -> Figures {
    let digits = format!("{:.decimals$}", x.abs() / libm::pow(10.0, f64::from(exponent)));
    let nothing = digits.chars().all(|c| c == '0' || c == '.');
    Figures { negative: x < 0.0 && !nothing, digits, exponent }
}

/// The digits that are needed, where they are no more than this.
pub(crate) fn shortest(x: f64, most: usize) -> Option<Figures> {
    if x == 0.0 {
        return Some(Figures::zero());
    }
    let text = format!("{x:.11e}");
    let (mantissa, exponent) = text.split_once('e')?;
    let digits = mantissa.trim_start_matches('-').trim_end_matches('0').trim_end_matches('.');
    let exponent: i32 = exponent.parse().ok()?;
    let count = digits.chars().filter(char::is_ascii_digit).count();
    if count > most {
        return None;
    }
    let decimals = i32::try_from(count).ok()? - 1 - exponent;
    Some(with_decimals(x, decimals.max(if x.abs() < SMALL { decimals } else { 0 })))
}
