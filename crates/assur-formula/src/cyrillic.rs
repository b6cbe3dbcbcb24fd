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

/// A text with the units behind numbers in Cyrillic, and those behind a comma or alone.
#[must_use]
pub fn units_in_cyrillic(words: &str) -> String {
    let mut out = String::new();
    let mut rest = words;
    while let Some(at) = rest.find(|c: char| c.is_ascii_alphabetic() || c == 'µ') {
        let (before, from) = rest.split_at(at);
        let end =
            from.find(|c: char| !(c.is_alphanumeric() || "·/*^²³⁴⁻¹µ".contains(c))).unwrap_or(from.len());
        let (word, behind) = from.split_at(end);
        out += before;
        let lead = out.trim_end_matches([' ', '\u{a0}', '(']);
        // behind a number, as in "1/m"; alone, or alone in brackets
        let alone = lead.trim().is_empty() || lead.trim() == "[";
        let stands = alone || lead.ends_with(|c: char| c.is_ascii_digit() || ",/".contains(c));
        let whole =
            !behind.starts_with(['_', '\'', '=']) && !out.ends_with(|c: char| c.is_alphabetic() || c == '.');
        match cyrillic(word).filter(|_| stands && whole) {
            Some(unit) => out += &unit,
            None => out += word,
        }
        rest = behind;
    }
    out + rest
}
