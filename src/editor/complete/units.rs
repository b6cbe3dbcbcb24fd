//! Units after a number.

use super::super::Analysis;
use super::place::Place;
use super::{Completion, CompletionKind};
use assur_syntax::{TokenKind, parse_with_tokens};
use assur_text::language::{Dimension, PROPERTIES, PropertyValue, UNITS, WORDS};
use assur_text::source::Source;
use assur_text::units::{Unit, lookup};
use indexmap::IndexSet;
use std::sync::LazyLock;

/// The units that fit; all where the place does not tell.
pub fn offered(analysis: &Analysis, place: &Place<'_>) -> Vec<Completion> {
    let wanted = wanted(place);
    let own = analysis.tokens.iter().filter(|t| t.kind == TokenKind::Unit);
    let own = own.map(|t| t.text(&analysis.source.text));
    let all = own.chain(KNOWN.iter().map(String::as_str)).collect::<IndexSet<_>>().into_iter();
    let fitting = all.filter_map(|text| {
        let unit = lookup(text).ok()?;
        let fits = wanted.is_none_or(|wanted| unit.dimension.fits(wanted));
        let means = unit.dimension.name().unwrap_or_default();
        fits.then(|| Completion::plain(text, CompletionKind::Unit, means))
    });
    fitting.collect()
}

/// Other units of the dimension of one, each with its factor.
pub fn alike(own: &Unit) -> Vec<(&'static str, f64)> {
    let mut found: Vec<(&str, f64)> = Vec::new();
    for text in KNOWN.iter() {
        let Ok(unit) = lookup(text) else { continue };
        let is_new = unit.factor != own.factor && found.iter().all(|(_, factor)| *factor != unit.factor);
        if is_new && unit.dimension == own.dimension {
            found.push((text, unit.factor));
        }
    }
    found
}

/// Units of one word, and those of several as the tables of the language use them.
static KNOWN: LazyLock<Vec<String>> = LazyLock::new(|| {
    let words = WORDS.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let properties = PROPERTIES.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let lines =
        words.map(str::to_owned).chain(properties.map(|example| format!("brake M on d {{ {example} }}")));
    let text = lines.collect::<Vec<_>>().join("\n");
    let (_, tokens, _) = parse_with_tokens(&Source::new("", &*text));
    let of_examples = tokens.iter().filter(|t| t.kind == TokenKind::Unit).map(|t| t.text(&text).to_owned());
    UNITS.iter().map(|unit| unit.text.to_owned()).chain(of_examples).collect()
});

/// What the place takes, where the tables say so.
fn wanted(place: &Place<'_>) -> Option<Dimension> {
    let tables = PROPERTIES.iter().filter(|(word, _)| word.split(' ').next() == Some(place.body()));
    let property = tables.flat_map(|(_, all)| all.iter()).find(|row| row.name == place.head());
    if let Some(row) = property {
        return match row.takes {
            PropertyValue::Any(d)
            | PropertyValue::Positive(d)
            | PropertyValue::NotNegative(d)
            | PropertyValue::Two(d)
            | PropertyValue::Word(_, d) => Some(d),
            PropertyValue::Flag | PropertyValue::Block(_) => None,
        };
    }
    match (place.body(), place.head(), place.words().any(|word| word == "=")) {
        (_, "mass", _) => Some(Dimension::MASS),
        (_, "weight", _) | ("", "force", true) => Some(Dimension::FORCE),
        (_, "inertia", _) => Some(Dimension::INERTIA),
        ("", "torque", true) => Some(Dimension::TORQUE),
        ("", "gravity", _) => Some(Dimension::ACCELERATION),
        ("", "link", _) | ("ground" | "link", ..) if place.words().all(|word| word != "along") => {
            Some(Dimension::LENGTH)
        }
        ("ground" | "link", ..) => Some(Dimension::ANGLE),
        _ => None,
    }
}
