//! Whole numbers of all frames as text: the steps from one to the next, in digits of base 64 as in source maps. Five bits a digit, the
//! least first; a digit from 32 on is followed by more, and the first bit is the sign.

/// Digits in their order; none of them ends a text or an element.
pub const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
/// Where there is no number.
const NONE: char = '~';

/// The text of numbers, in quotes.
pub fn series(numbers: impl Iterator<Item = Option<i64>>) -> String {
    let mut out = String::from("\"");
    let mut before = 0_i64;
    for number in numbers {
        match number {
            Some(number) => {
                digits(&mut out, number.wrapping_sub(before));
                before = number;
            }
            None => out.push(NONE),
        }
    }
    out.push('"');
    out
}

fn digits(out: &mut String, step: i64) {
    let mut rest = (step.unsigned_abs() << 1) | u64::from(step < 0);
    loop {
        #[allow(clippy::cast_possible_truncation)] // five bits
        let digit = (rest & 31) as usize;
        rest >>= 5;
        let digit = if rest > 0 { digit + 32 } else { digit };
        out.push(char::from(DIGITS.as_bytes()[digit]));
        if rest == 0 {
            return;
        }
    }
}

/// Series of many things, each text once.
#[derive(Default)]
pub struct Distinct {
    pub texts: Vec<String>,
    known: std::collections::HashMap<String, usize>,
}

impl Distinct {
    /// The place of a text.
    pub fn place(&mut self, text: String) -> usize {
        *self.known.entry(text).or_insert_with_key(|text| {
            self.texts.push(text.clone());
            self.texts.len() - 1
        })
    }
}
