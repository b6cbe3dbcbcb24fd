//! Words of the language, by their places.

use super::place::Place;
use super::{Completion, CompletionKind};
use assur_text::language::{PROPERTIES, Place as WordPlace, WORDS, Word};

/// What may begin a statement or a member.
pub fn beginnings(place: &Place<'_>) -> Vec<Completion> {
    let begins = |row: &Word| Completion::snippet(row.word, CompletionKind::Snippet, row.means, row.example);
    let of = |places: &[WordPlace]| rows(places).map(begins).collect::<Vec<_>>();
    match place.body() {
        "" => of(&[WordPlace::Statement, WordPlace::Pair]),
        "ground" | "link" | "shaft" | "slider" => of(&[WordPlace::Member]),
        "cam" => [of(&[WordPlace::CamMember]), properties("cam")].concat(),
        word => properties(word),
    }
}

fn rows(places: &[WordPlace]) -> impl Iterator<Item = &'static Word> {
    WORDS.iter().filter(|(place, _)| places.contains(place)).flat_map(|(_, all)| all.iter())
}

fn properties(of: &str) -> Vec<Completion> {
    // a spring in a pair has properties of its own
    let tables = PROPERTIES.iter().filter(|(word, _)| word.split(' ').next() == Some(of));
    let mut found: Vec<Completion> = Vec::new();
    for row in tables.flat_map(|(_, all)| all.iter()) {
        if found.iter().all(|known| known.label != row.name) {
            found.push(Completion::snippet(row.name, CompletionKind::Property, row.means, row.example));
        }
    }
    found
}

pub fn within() -> Vec<Completion> {
    let places = [WordPlace::Connecting, WordPlace::Contextual, WordPlace::Law];
    let words = rows(&places).map(|row| Completion::plain(row.word, CompletionKind::Word, row.means));
    words.collect()
}

/// Words that begin statements, within others.
pub fn some(words: &[&str]) -> Vec<Completion> {
    let rows = rows(&[WordPlace::Statement]).filter(|row| words.contains(&row.word));
    rows.map(|row| Completion::plain(row.word, CompletionKind::Word, row.means)).collect()
}

/// The kinds of pairs, as `all` takes them.
pub fn kinds() -> Vec<Completion> {
    let words = rows(&[WordPlace::Pair]);
    words.map(|row| Completion::plain(row.word, CompletionKind::Word, row.means)).collect()
}
