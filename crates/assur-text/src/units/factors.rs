//! The factors of a unit word.

/// A factor of a composite unit, as written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factor<'a> {
    /// The symbol without its power.
    pub symbol: &'a str,
    /// The power, negative after a stroke; `None` if it is too large.
    pub power: Option<i8>,
    /// First byte of the symbol in the word.
    pub start: usize,
    /// One past the last byte of the power.
    pub end: usize,
    /// Whether a stroke stands before it.
    pub divided: bool,
}

/// What stands between two factors: a blank and a point mean a product.
const BETWEEN: [char; 6] = ['*', '/', '·', '⋅', '.', ' '];

/// The factors of a unit word, left to right. `1/s` is one factor.
#[must_use]
pub fn factors(word: &str) -> Vec<Factor<'_>> {
    let mut found = Vec::new();
    let mut start = 0;
    let mut divided = false;
    let mut push = |start: usize, end: usize, divided: bool| {
        let text = &word[start..end];
        if !(found.is_empty() && text == "1") {
            found.push(factor(text, start, end, divided));
        }
    };
    for (i, c) in word.char_indices() {
        if BETWEEN.contains(&c) {
            push(start, i, divided);
            start = i + c.len_utf8();
            divided = c == '/';
        }
    }
    push(start, word.len(), divided);
    found
}

fn factor(text: &str, start: usize, end: usize, divided: bool) -> Factor<'_> {
    let (symbol, digits) = split_power(text);
    let power = match digits {
        Some(digits) => digits.parse::<i8>().ok().filter(|p| *p != i8::MIN),
        None => Some(1),
    };
    Factor { symbol, power: power.map(|p| if divided { -p } else { p }), start, end, divided }
}

/// `s^-1` and `s⁻¹` into `s` and `-1`.
fn split_power(text: &str) -> (&str, Option<String>) {
    if let Some((symbol, digits)) = text.split_once('^') {
        return (symbol, Some(digits.replace('−', "-")));
    }
    if text.is_ascii() {
        return (text, None);
    }
    let at = text.find(|c| superscript(c).is_some()).unwrap_or(text.len());
    let (symbol, raised) = text.split_at(at);
    let digits = raised.chars().map(|c| superscript(c).unwrap_or('?')).collect::<String>();
    (symbol, (!digits.is_empty()).then_some(digits))
}

fn superscript(c: char) -> Option<char> {
    let index = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".chars().position(|s| s == c)?;
    "0123456789-".chars().nth(index)
}
