//! Numbers in decimal figures.

use std::fmt::Write;

/// The most figures that a number is rounded to here. Of more the shortest ones say too little.
const MOST_FROM_SHORTEST: usize = 15;

/// A number rounded to a number of significant digits, without trailing zeros: `98.212`, `-0.0024`, `1.5e9`.
///
/// Very large and very small numbers are written with an exponent.
#[must_use]
pub fn significant(x: f64, digits: usize) -> String {
    let mut out = String::new();
    write_significant(&mut out, x, digits);
    out
}

/// As [`significant`], appended to `out`.
pub fn write_significant(out: &mut String, x: f64, digits: usize) {
    let text = Text::of_number(x, digits);
    out.push_str(std::str::from_utf8(&text.bytes[..text.len]).unwrap_or_default());
}

/// As [`write_significant`], appended to a text in bytes.
#[inline]
pub fn push_significant(out: &mut Vec<u8>, x: f64, digits: usize) {
    let text = Text::of_number(x, digits);
    // as a whole, whose size is known beforehand
    let len = out.len() + text.len;
    out.extend_from_slice(&text.bytes);
    out.truncate(len);
}

/// A short text in place.
#[derive(Default)]
struct Text {
    bytes: [u8; 32],
    len: usize,
}

impl Write for Text {
    fn write_str(&mut self, more: &str) -> std::fmt::Result {
        if self.len + more.len() > self.bytes.len() {
            return Err(std::fmt::Error);
        }
        self.push(more.as_bytes());
        Ok(())
    }
}

impl Text {
    fn push(&mut self, more: &[u8]) {
        self.bytes[self.len..self.len + more.len()].copy_from_slice(more);
        self.len += more.len();
    }

    fn of_number(x: f64, digits: usize) -> Self {
        if x == 0.0 {
            return Self::of(b"0");
        }
        if !x.is_finite() {
            return Self::of(if x.is_nan() {
                b"NaN"
            } else if x < 0.0 {
                b"-inf"
            } else {
                b"inf"
            });
        }
        let digits = digits.clamp(1, 17);
        Self::plain(x, digits).unwrap_or_else(|| Self::of_figures(x, digits))
    }

    #[inline(never)]
    fn of_figures(x: f64, digits: usize) -> Self {
        let figures = Figures::from_shortest(x, digits).unwrap_or_else(|| Figures::exact(x, digits));
        let mut text = Self::default();
        if x < 0.0 {
            text.push(b"-");
        }
        figures.write(&mut text);
        text
    }

    /// Rounds the shortest decimal number that is read as `x` where it stands, see [`Figures::from_shortest`]. `None` where it
    /// has an exponent before or after, or does not decide how `x` is rounded.
    fn plain(x: f64, digits: usize) -> Option<Self> {
        let size = x.abs();
        if !(1e-5..1e7).contains(&size) || digits > MOST_FROM_SHORTEST {
            return None;
        }
        let mut buffer = zmij::Buffer::new();
        let shortest = buffer.format_finite(x).as_bytes();
        let begin = usize::from(x < 0.0);
        let end = if size < 1.0 {
            let zeros =
                [0.1, 0.01, 1e-3, 1e-4].iter().map(|&border| usize::from(size < border)).sum::<usize>();
            begin + 2 + zeros + digits
        } else {
            let more = [10.0, 100.0, 1e3, 1e4, 1e5, 1e6].iter().map(|&border| usize::from(size >= border));
            let before = 1 + more.sum::<usize>();
            if digits <= before {
                return None;
            }
            begin + digits + 1
        };
        let mut text = Self::of(shortest);
        match shortest.get(end..) {
            None | Some([]) => {}
            Some([next, more @ ..]) => {
                text.len = end;
                let up = match (next, more) {
                    (b'5', []) => is_greater(size, shortest)?,
                    _ => *next >= b'5',
                };
                if up && !text.round_up(begin) {
                    return None;
                }
            }
        }
        while text.bytes[text.len - 1] == b'0' {
            text.len -= 1;
        }
        text.len -= usize::from(text.bytes[text.len - 1] == b'.');
        Some(text)
    }

    /// Copies a text of at most 32 bytes, in pieces of a size known beforehand.
    #[inline(always)]
    fn of(text: &[u8]) -> Self {
        let mut copy = Self { len: text.len(), ..Self::default() };
        match (text.first_chunk::<16>(), text.last_chunk::<16>()) {
            (Some(first), Some(last)) => {
                copy.bytes[..16].copy_from_slice(first);
                copy.bytes[text.len() - 16..text.len()].copy_from_slice(last);
            }
            _ => copy.bytes[..text.len()].copy_from_slice(text),
        }
        copy
    }

    /// Adds one to the last figure; `false` where a figure would be added before `begin`.
    fn round_up(&mut self, begin: usize) -> bool {
        for byte in self.bytes[begin..self.len].iter_mut().rev() {
            match byte {
                b'.' => {}
                b'9' => *byte = b'0',
                _ => {
                    *byte += 1;
                    return true;
                }
            }
        }
        false
    }
}

/// Whether a number from 10⁻⁵ to 10⁷ is greater than the shortest decimal number that is read as it, which is written without an
/// exponent; `None` where they are equal.
#[cold]
fn is_greater(x: f64, shortest: &[u8]) -> Option<bool> {
    let bits = x.to_bits();
    let (mantissa, exponent) = (bits & ((1 << 52) - 1) | 1 << 52, (bits >> 52) as i32 - 1075);
    let (mut figures, mut places) = (0_u128, None);
    for byte in shortest {
        match byte {
            b'.' => places = Some(0_u32),
            b'0'..=b'9' => {
                figures = 10 * figures + u128::from(byte - b'0');
                places = places.map(|n| n + 1);
            }
            _ => {}
        }
    }
    // x = mantissa × 2^exponent against figures / 10^places: both times 10^places / 2^(exponent + places)
    let places = places?;
    let left = u128::from(mantissa) * 5_u128.checked_pow(places)?;
    let shift = -(exponent + i32::try_from(places).ok()?);
    let right = figures.checked_mul(1_u128.checked_shl(u32::try_from(shift).ok()?)?)?;
    (left != right).then_some(left > right)
}

/// Decimal figures of a number, the first of which is not zero.
struct Figures {
    figures: [u8; 17],
    count: usize,
    /// The power of ten of the first figure.
    power: i32,
}

impl Figures {
    /// From the shortest decimal number that is read as `x`. `None` where that does not decide how `x` is rounded: half way
    /// between two numbers of so many digits, with more than 15 digits, and below the normal numbers.
    ///
    /// No other case is doubtful. The border between rounding up and down has one digit more than what is wanted. Were it
    /// between `x` and the shortest number, it would be read as `x` too, and be shorter or nearer.
    fn from_shortest(x: f64, digits: usize) -> Option<Self> {
        if digits > MOST_FROM_SHORTEST || x.abs() < f64::MIN_POSITIVE {
            return None;
        }
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format_finite(x.abs()).as_bytes();
        let mut found = Self { figures: [b'0'; 17], count: 0, power: -1 };
        let mut point = false;
        for (i, byte) in text.iter().enumerate() {
            match byte {
                b'.' => point = true,
                b'e' => {
                    let exponent = std::str::from_utf8(&text[i + 1..]).ok()?;
                    found.power += exponent.parse::<i32>().ok()?;
                    break;
                }
                b'0' if found.count == 0 => found.power -= i32::from(point),
                digit => {
                    // what lies beyond are zeros before the point
                    if let Some(place) = found.figures.get_mut(found.count) {
                        *place = *digit;
                    }
                    found.count += 1;
                    found.power += i32::from(!point);
                }
            }
        }
        found.count = found.count.min(17);
        found.strip();
        if found.count > digits {
            let half_way = found.figures[digits] == b'5' && found.count == digits + 1;
            if half_way {
                return None;
            }
            let up = found.figures[digits] >= b'5';
            found.count = digits;
            if up {
                found.round_up();
            }
            found.strip();
        }
        Some(found)
    }

    /// From all digits of `x`.
    #[cold]
    fn exact(x: f64, digits: usize) -> Self {
        let mut all = Text::default();
        // at most 17 digits with an exponent: that fits
        let _ = write!(all, "{:.*e}", digits - 1, x.abs());
        let text = std::str::from_utf8(&all.bytes[..all.len]).unwrap_or("0");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let mut found = Self { figures: [b'0'; 17], count: 0, power: exponent.parse().unwrap_or(0) };
        for digit in mantissa.bytes().filter(u8::is_ascii_digit).take(17) {
            found.figures[found.count] = digit;
            found.count += 1;
        }
        found.strip();
        found
    }

    /// Adds one to the last figure.
    fn round_up(&mut self) {
        for i in (0..self.count).rev() {
            if self.figures[i] < b'9' {
                self.figures[i] += 1;
                return;
            }
            self.figures[i] = b'0';
        }
        self.figures[0] = b'1';
        self.power += 1;
    }

    /// Leaves trailing zeros out.
    fn strip(&mut self) {
        while self.count > 1 && self.figures[self.count - 1] == b'0' {
            self.count -= 1;
        }
    }

    fn write(&self, out: &mut Text) {
        let figures = &self.figures[..self.count];
        match self.power {
            power @ 0..=6 => {
                let before = usize::try_from(power + 1).unwrap_or(1);
                out.push(&figures[..before.min(self.count)]);
                out.push(&b"000000"[..before.saturating_sub(self.count)]);
                if self.count > before {
                    out.push(b".");
                    out.push(&figures[before..]);
                }
            }
            power @ -5..=-1 => {
                out.push(b"0.");
                out.push(&b"0000"[..usize::try_from(-power - 1).unwrap_or(0)]);
                out.push(figures);
            }
            power => {
                out.push(&figures[..1]);
                if self.count > 1 {
                    out.push(b".");
                    out.push(&figures[1..]);
                }
                out.push(b"e");
                // three digits and a sign
                let _ = write!(out, "{power}");
            }
        }
    }
}
