//! The appearance of a name.

/// Letters of the Cyrillic and Greek scripts with the Latin letters they look like.
const LOOK_ALIKES: &[(&str, &str)] = &[
    // Cyrillic capitals
    ("АВЕЗКМНОРСТУХ\u{405}\u{406}\u{408}\u{51A}\u{51C}\u{4AE}", "ABE3KMHOPCTYXSIJQWY"),
    // Cyrillic small letters
    ("аеорсух\u{455}\u{456}\u{458}\u{4BB}\u{51B}\u{51D}\u{4AF}", "aeopcyxsijhqwy"),
    // Greek capitals
    ("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧ", "ABEZHIKMNOPTYX"),
    // Greek small letters; α, γ, ρ are told from a, y, p by every reader of formulas
    ("ον", "ov"),
];

/// What a name looks like: two names with one skeleton cannot be told apart by eye.
///
/// Letters of the Cyrillic and Greek scripts are folded to the Latin letters they resemble; nothing else changes, so a
/// skeleton is for comparing and not for showing.
#[must_use]
pub fn skeleton(name: &str) -> String {
    if name.is_ascii() { name.to_owned() } else { name.chars().map(latin).collect() }
}

fn latin(c: char) -> char {
    let found = LOOK_ALIKES.iter().find_map(|(from, to)| {
        let index = from.chars().position(|f| f == c)?;
        to.chars().nth(index)
    });
    found.unwrap_or(c)
}
