//! Numbers in decimal figures.

use std::fmt::Write;

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
    if x == 0.0 {
        out.push('0');
        return;
    }
    let start = out.len();
    let digits = digits.clamp(1, 17);
    // writing to a String does not fail
    let _ = if x.is_finite() { write!(out, "{:.*e}", digits - 1, x) } else { write!(out, "{x}") };
    let Some((mantissa, exponent)) = out[start..].split_once('e') else { return };
    let power = exponent.parse::<i32>().unwrap_or(0);
    // sign, point and up to 17 digits
    let mut figures = [0_u8; 17];
    let mut count = 0;
    for digit in mantissa.bytes().filter(u8::is_ascii_digit).take(17) {
        figures[count] = digit;
        count += 1;
    }
    while count > 1 && figures[count - 1] == b'0' {
        count -= 1;
    }
    let places = (-5..=6).contains(&power).then_some(power);
    out.truncate(start);
    if x < 0.0 {
        out.push('-');
    }
    let mut push = |range: &[u8]| range.iter().for_each(|b| out.push(char::from(*b)));
    match places {
        None => {
            push(&figures[..1]);
            if count > 1 {
                push(b".");
                push(&figures[1..count]);
            }
            let _ = write!(out, "e{power}");
        }
        Some(power @ 0..) => {
            let before = usize::try_from(power + 1).unwrap_or(1);
            push(&figures[..before.min(count)]);
            push(&b"000000"[..before.saturating_sub(count)]);
            if count > before {
                push(b".");
                push(&figures[before..count]);
            }
        }
        Some(power) => {
            push(b"0.");
            push(&b"0000"[..usize::try_from(-power - 1).unwrap_or(0)]);
            push(&figures[..count]);
        }
    }
}
