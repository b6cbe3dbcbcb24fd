//! Numbers of a document: two decimals at most, the same on every machine.

use std::fmt::{self, Display, Formatter};

/// Magnitudes below this are written from whole hundredths.
const SHORT: f64 = 1e9;
/// Hundredths nearer to a half than this may be rounded either way: there the digits decide.
const HALF: f64 = 1e-4;
/// Room for a sign, ten digits, a point and two decimals.
const ROOM: usize = 16;

/// A number with two decimals at most, without zeros at its end and without a minus before nothing.
#[derive(Clone, Debug)]
pub struct Number {
    text: [u8; ROOM],
    /// Where it begins in the room, which is filled from its end.
    begin: usize,
    /// One that is too large for it.
    long: Option<String>,
}

/// A number with two decimals at most, without zeros at its end and without a minus before nothing.
#[must_use]
pub fn number(x: f64) -> Number {
    let (text, begin) = ([0; ROOM], ROOM);
    let hundredths = x.abs() * 100.0;
    let below = hundredths.floor();
    let rest = hundredths - below;
    if x.abs() < SHORT && (rest - 0.5).abs() > HALF {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // below 1e11, not negative
        let whole = below as u64 + u64::from(rest > 0.5);
        let mut number = Number { text, begin, long: None };
        number.fill(whole, x < 0.0);
        return number;
    }
    let mut long = format!("{x:.2}");
    if long.contains('.') {
        long.truncate(long.trim_end_matches('0').trim_end_matches('.').len());
    }
    if long == "-0" {
        long.remove(0);
    }
    Number { text, begin, long: Some(long) }
}

impl Number {
    /// From hundredths.
    fn fill(&mut self, hundredths: u64, negative: bool) {
        let (mut whole, decimals) = (hundredths / 100, hundredths % 100);
        if decimals > 0 {
            if decimals % 10 > 0 {
                self.push(decimals % 10);
            }
            self.push(decimals / 10);
            self.sign(b'.');
        }
        self.push(whole % 10);
        whole /= 10;
        while whole > 0 {
            self.push(whole % 10);
            whole /= 10;
        }
        if negative && hundredths > 0 {
            self.sign(b'-');
        }
    }

    #[allow(clippy::cast_possible_truncation)] // a digit
    fn push(&mut self, digit: u64) {
        self.sign(b'0' + digit as u8);
    }

    fn sign(&mut self, sign: u8) {
        self.begin -= 1;
        self.text[self.begin] = sign;
    }

    /// Its digits.
    #[must_use]
    pub fn as_str(&self) -> &str {
        match &self.long {
            Some(long) => long,
            None => std::str::from_utf8(&self.text[self.begin..]).unwrap_or_default(),
        }
    }
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
