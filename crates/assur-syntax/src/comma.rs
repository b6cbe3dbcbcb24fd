//! Commas within numbers: decimal commas, and commas between thousands.

/// What a comma between digits may mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Meaning {
    Decimal,
    /// A separator of thousands for certain: `1,500,000`, `1,500.5`.
    Thousands,
    /// `1,500`
    Either,
}

/// The commas between two digits.
pub fn between_digits(text: &str) -> Vec<usize> {
    let bytes = text.as_bytes();
    let digit = |i: Option<usize>| i.and_then(|i| bytes.get(i)).is_some_and(u8::is_ascii_digit);
    let is_within = |i: &usize| bytes[*i] == b',' && digit(i.checked_sub(1)) && digit(Some(i + 1));
    (0..bytes.len()).filter(is_within).collect()
}

/// The text with commas between digits replaced: by points first; where exactly three digits follow, also the text in
/// which they separate thousands.
pub fn readings(text: &str, commas: &[usize]) -> Vec<String> {
    let meanings = commas.iter().map(|at| (*at, meaning(text, *at))).collect::<Vec<_>>();
    let with = |either: &str| {
        let mut new = text.to_owned();
        for (at, meaning) in meanings.iter().rev() {
            let sign = match meaning {
                Meaning::Decimal => ".",
                Meaning::Thousands => "",
                Meaning::Either => either,
            };
            new.replace_range(*at..at + 1, sign);
        }
        new
    };
    if meanings.iter().any(|(_, m)| *m == Meaning::Either) {
        vec![with("."), with("")]
    } else {
        vec![with(".")]
    }
}

fn meaning(text: &str, comma: usize) -> Meaning {
    let is_digit = |c: char| c.is_ascii_digit();
    let (before, behind) = (&text[..comma], &text[comma + 1..]);
    let head = before.trim_end_matches(is_digit);
    let whole = &before[head.len()..];
    let rest = behind.trim_start_matches(is_digit);
    let group = behind.len() - rest.len() == 3;
    let goes_on = rest.strip_prefix(',').is_some_and(|more| {
        let behind = more.trim_start_matches(is_digit);
        more.len() - behind.len() == 3
    });
    let continues = whole.len() == 3 && head.strip_suffix(',').is_some_and(|h| h.ends_with(is_digit));
    let has_decimals = rest.strip_prefix('.').is_some_and(|more| more.starts_with(is_digit));
    if !group || (whole.starts_with('0') && !continues) || whole.len() > 3 {
        Meaning::Decimal
    } else if goes_on || continues || has_decimals {
        Meaning::Thousands
    } else {
        Meaning::Either
    }
}
