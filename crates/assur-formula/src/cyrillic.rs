//! Units in Cyrillic, as Russian texts have them (GOST 8.417).

/// A unit, and what it is in Cyrillic.
const UNITS: [(&str, &str); 36] = [
    ("deg", "°"),
    ("m", "м"),
    ("mm", "мм"),
    ("cm", "см"),
    ("km", "км"),
    ("µm", "мкм"),
    ("um", "мкм"),
    ("kg", "кг"),
    ("g", "г"),
    ("t", "т"),
    ("s", "с"),
    ("ms", "мс"),
    ("min", "мин"),
    ("h", "ч"),
    ("N", "Н"),
    ("kN", "кН"),
    ("MN", "МН"),
    ("J", "Дж"),
    ("kJ", "кДж"),
    ("MJ", "МДж"),
    ("W", "Вт"),
    ("kW", "кВт"),
    ("MW", "МВт"),
    ("Pa", "Па"),
    ("kPa", "кПа"),
    ("MPa", "МПа"),
    ("GPa", "ГПа"),
    ("bar", "бар"),
    ("Hz", "Гц"),
    ("rad", "рад"),
    ("mrad", "мрад"),
    ("rev", "об"),
    ("rpm", "об/мин"),
    ("kgf", "кгс"),
    ("l", "л"),
    ("K", "К"),
];

/// A unit in Cyrillic: `кг·м²` of `kg·m²`; none where a part of it is no unit that is known.
#[must_use]
pub fn cyrillic(unit: &str) -> Option<String> {
    let mut out = String::new();
    let mut rest = unit;
    while !rest.is_empty() {
        let letters = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
        if letters > 0 {
            let (_, known) = UNITS.iter().find(|(latin, _)| *latin == &rest[..letters])?;
            out += known;
            rest = &rest[letters..];
        }
        let signs = rest.find(char::is_alphabetic).unwrap_or(rest.len());
        if !rest[..signs].chars().all(|c| "·/*^()1234²³⁴⁻¹".contains(c)) {
            return None;
        }
        out += &rest[..signs];
        rest = &rest[signs..];
    }
    (out != unit).then_some(out)
}

/// A text with its units in Cyrillic: those behind numbers, and one that it begins with behind a blank, a comma or a bracket, as
/// behind a name.
#[must_use]
pub fn units_in_cyrillic(words: &str) -> String {
    let mut out = String::new();
    let mut rest = words;
    let mut in_unit = false;
    while let Some(at) = rest.find(|c: char| c.is_ascii_alphabetic() || c == 'µ') {
        let (before, from) = rest.split_at(at);
        let end =
            from.find(|c: char| !(c.is_alphanumeric() || "·/*^²³⁴⁻¹µ".contains(c))).unwrap_or(from.len());
        let (word, behind) = from.split_at(end);
        out += before;
        // behind a number, as in "1/m" and "°/s", or in "(m/s)/mm"; else a name may be meant
        let goes_on = in_unit && before == ")/";
        let stands = goes_on || begins(&out) || behind_number(&out);
        let whole =
            !behind.starts_with(['_', '\'', '=']) && !out.ends_with(|c: char| c.is_alphabetic() || c == '.');
        let unit = cyrillic(word).filter(|_| stands && whole);
        in_unit = unit.is_some();
        out += unit.as_deref().unwrap_or(word);
        rest = behind;
    }
    out + rest
}

/// Whether all that stands before is a blank, a comma or a bracket.
fn begins(before: &str) -> bool {
    !before.is_empty() && before.chars().all(|c| c.is_whitespace() || ",[(°/".contains(c))
}

fn behind_number(before: &str) -> bool {
    let lead = before.trim_end_matches([' ', '\u{a0}', '(']);
    let lead = lead.strip_suffix('/').unwrap_or(lead).trim_end_matches('°').trim_end();
    let word = lead.rsplit([' ', '\u{a0}', '(']).next().unwrap_or_default();
    word.ends_with(|c: char| c.is_ascii_digit() || "²³⁴⁵⁶⁹".contains(c))
        && word.chars().all(|c| c == 'e' || !c.is_alphabetic())
}

/// A header with its unit in Cyrillic: what comes after its last comma or is in its last bracket.
#[must_use]
pub fn header_in_cyrillic(header: &str) -> String {
    let tail = header.rfind([',', '[']).map_or(0, |at| at + 1);
    let (name, unit) = header.split_at(tail);
    let inner = unit.trim_matches([' ', ']']);
    match cyrillic(inner).filter(|_| tail > 0) {
        Some(own) => format!("{name}{}", unit.replacen(inner, &own, 1)),
        None => units_in_cyrillic(header),
    }
}
