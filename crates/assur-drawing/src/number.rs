//! Numbers of a document: two decimals at most, the same on every machine.

use std::fmt::{self, Display, Formatter};

/// Magnitudes below this are written from whole hundredths.
const SHORT: f64 = 1e9;
/// Hundredths nearer to a half than this may be rounded either way: there the digits decide.
const HALF: f64 = 1e-4;
/// Room for a sign, ten digits, a point and two decimals.
const ROOM: usize = 16;

/// A number with two decimals at most, without zeros at its end and without a minus before nothing.
#[derive(Clone, Copy, Debug)]
pub struct Number(f64);

/// A number with two decimals at most, without zeros at its end and without a minus before nothing.
#[must_use]
pub const fn number(x: f64) -> Number {
    Number(x)
}

impl Number {
    /// Writes it behind a text.
    pub fn push_to(self, out: &mut String) {
        let Some(hundredths) = self.hundredths() else { return self.push_long(out) };
        if self.0 < 0.0 && hundredths > 0 {
            out.push('-');
        }
        push_whole(out, hundredths / 100);
        let decimals = hundredths % 100;
        if decimals > 0 {
            out.push('.');
            push_digit(out, decimals / 10);
            if !decimals.is_multiple_of(10) {
                push_digit(out, decimals % 10);
            }
        }
    }

    /// Its magnitude in hundredths, where it is clear how they are rounded.
    fn hundredths(self) -> Option<u64> {
        let hundredths = self.0.abs() * 100.0;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // below 1e11, not negative
        let below = hundredths as u64;
        #[allow(clippy::cast_precision_loss)] // far below 2^53
        let rest = hundredths - below as f64;
        (self.0.abs() < SHORT && (rest - 0.5).abs() > HALF).then(|| below + u64::from(rest > 0.5))
    }

    fn push_long(self, out: &mut String) {
        let mut long = format!("{:.2}", self.0);
        if long.contains('.') {
            long.truncate(long.trim_end_matches('0').trim_end_matches('.').len());
        }
        out.push_str(if long == "-0" { "0" } else { &long });
    }
}

fn push_whole(out: &mut String, whole: u64) {
    if whole >= 10 {
        push_whole(out, whole / 10);
    }
    push_digit(out, whole % 10);
}

#[allow(clippy::cast_possible_truncation)] // a digit
fn push_digit(out: &mut String, digit: u64) {
    out.push(char::from(b'0' + digit as u8));
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut text = String::with_capacity(ROOM);
        self.push_to(&mut text);
        f.write_str(&text)
    }
}
