//! Numbers as spreadsheets and people write them.

use super::Separator;
use assur_syntax::{between_digits, readings};
use assur_text::units::{is_unit, lookup};

/// Powers of ten with exact values.
const EXACT: usize = 22;

/// A number with what its figures say of its precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreciseNumber {
    pub value: f64,
    /// One unit in the last digit written.
    pub digit: f64,
}

/// The mistake, and the correction.
pub type Why = (String, Option<String>);

impl PreciseNumber {
    /// Reads a plain number. Where cells are not separated by commas it may have a decimal comma.
    ///
    /// # Errors
    /// The mistake, and the correction.
    pub fn read(text: &str, separator: Separator) -> Result<Self, Why> {
        let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'e' | b'E'));
        if plain && let Ok(value) = text.parse::<f64>() {
            return if value.is_finite() {
                Ok(Self { value, digit: last_digit(text) })
            } else {
                Err((format!("`{text}` is too large"), None))
            };
        }
        let mended = mended(text);
        match &mended {
            Some(number) if separator != Separator::Comma || !text.contains(',') => {
                Self::read(number, Separator::Comma)
            }
            Some(_) => Err(with_comma(text)),
            None => Err(no_number(text)),
        }
    }
}

/// With a hyphen for a minus sign and a point for a comma; `None` where that is no number either.
fn mended(text: &str) -> Option<String> {
    let number = text.replace('\u{2212}', "-");
    let number = if number.matches(',').count() == 1 && !number.contains('.') {
        number.replace(',', ".")
    } else {
        number
    };
    let figures = number.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'e' | b'E'));
    (number != text && figures && number.parse::<f64>().is_ok()).then_some(number)
}

/// A comma between digits, which may separate thousands where exactly three digits follow.
fn with_comma(text: &str) -> Why {
    let numbers = readings(text, &between_digits(text));
    let list = numbers.iter().map(|number| format!("`{number}`")).collect::<Vec<_>>().join(" or ");
    match numbers.as_slice() {
        [_] => {
            let help = format!("write {list}, or separate the cells by semicolons");
            (format!("`{text}` has a decimal comma"), Some(help))
        }
        _ => (
            format!("`{text}` may have a decimal comma or separate thousands"),
            Some(format!("write {list}")),
        ),
    }
}

fn no_number(text: &str) -> Why {
    let point = text.replace('.', "").replace(',', ".");
    if let [number] = readings(text, &between_digits(text)).as_slice()
        && number.parse::<f64>().is_ok()
        && number != text
    {
        return (format!("`{text}` separates thousands"), Some(format!("write `{number}`")));
    }
    if text.contains(',') && text.matches(',').count() == 1 && point.parse::<f64>().is_ok() {
        return (format!("`{text}` is not a number"), Some(format!("write `{point}`")));
    }
    let split = text.find(|c: char| c.is_alphabetic() || matches!(c, '%' | '°')).unwrap_or(text.len());
    let (number, unit) = (text[..split].trim(), text[split..].trim());
    if !number.is_empty() && number.parse::<f64>().is_ok() && (is_unit(unit) || lookup(unit).is_ok()) {
        let help = "write the number without a unit, in the unit of the header".to_owned();
        return (format!("`{text}` has a unit"), Some(help));
    }
    (format!("`{text}` is not a number"), Some("write a plain number, as `120` or `-1.5e3`".to_owned()))
}

/// `0.350` is good to 0.001, `1.5e3` to 100.
fn last_digit(text: &str) -> f64 {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().unwrap_or(0)),
        None => (text, 0),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    if exponent == 0 && decimals <= EXACT {
        return 1.0 / POWERS[decimals];
    }
    let power = i64::from(exponent) - i64::try_from(decimals).unwrap_or(0);
    format!("1e{power}").parse().unwrap_or(0.0)
}

const POWERS: [f64; EXACT + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];
