//! Words of the language, and what the grammar's rules are called when speaking to people.

use assur_text::language::{Function, MEMBERS, PAIRS, Place, STATEMENTS, words_of};
pub use parser::{Grammar, Rule};

/// What may stand at a place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Expected {
    /// A word or sign, literally.
    Literal(String),
    /// A name to be chosen.
    Name,
    /// Something that is described.
    Kind(&'static str),
    /// An operator, after something complete.
    Operator,
    /// The end of what is being read.
    End,
}

/// What a rule is called; nothing for plumbing, slips and error productions.
pub(super) fn expected(rule: Rule) -> Vec<Expected> {
    if let Some(kind) = kind(rule) {
        return vec![kind];
    }
    let debug = format!("{rule:?}");
    let literal = |word: &str| Expected::Literal(word.to_owned());
    let words: &[&str] = match rule {
        Rule::law => return words_of(Place::Law).map(literal).collect(),
        Rule::kind => return words_of(Place::Pair).map(literal).collect(),
        Rule::side => &["left", "right"],
        Rule::turn => &["cw", "ccw"],
        Rule::load_kind => &["force", "torque"],
        Rule::site => &["on", "in"],
        Rule::order => &["ahead", "behind"],
        Rule::shape => &["rod", "disc", "ring", "sphere", "plate"],
        Rule::m_along => &["along"],
        Rule::m_to => &["to"],
        Rule::near => &["near"],
        Rule::frame => &["in"],
        Rule::against => &["against"],
        Rule::within => &["within"],
        Rule::compare => &["<", ">"],
        Rule::p_comma => &[","],
        Rule::p_dash => &["-"],
        Rule::p_dots => &[".."],
        Rule::p_close => &[")"],
        Rule::p_equals => &["="],
        Rule::p_colon => &[":"],
        Rule::p_end => &["}"],
        Rule::p_brace | Rule::body | Rule::properties => &["{"],
        // The rule of a word is named after it.
        _ => return debug.strip_prefix("w_").map(literal).into_iter().collect(),
    };
    words.iter().copied().map(literal).collect()
}

/// Rules that are not words.
fn kind(rule: Rule) -> Option<Expected> {
    Some(match rule {
        Rule::ident
        | Rule::pose_name
        | Rule::path
        | Rule::end
        | Rule::clause
        | Rule::setting
        | Rule::column => Expected::Name,
        Rule::expr
        | Rule::post
        | Rule::arg
        | Rule::list
        | Rule::sensed
        | Rule::position
        | Rule::find_item
        | Rule::w_not => Expected::Kind("a value"),
        Rule::number | Rule::quantity | Rule::count | Rule::cell | Rule::row => Expected::Kind("a number"),
        Rule::string => Expected::Kind("a text in quotes"),
        Rule::unit => Expected::Kind("a unit"),
        Rule::place => Expected::Kind("a point"),
        Rule::property => Expected::Kind("a property"),
        Rule::header => Expected::Kind("a header of names"),
        Rule::tight | Rule::loose | Rule::joining | Rule::compared | Rule::p_polar => Expected::Operator,
        Rule::EOI => Expected::End,
        _ => return None,
    })
}

/// What may be said to be expected: `` `=` or a value ``.
pub(super) fn list(mut expected: Vec<Expected>) -> String {
    expected.sort();
    expected.dedup();
    // Behind something complete an operator and the end are always possible; they help only where nothing else is.
    if expected.iter().any(|e| !matches!(e, Expected::Operator | Expected::Kind("a unit"))) {
        expected.retain(|e| !matches!(e, Expected::Operator | Expected::Kind("a unit")));
    }
    let mut said = expected.into_iter().map(say).collect::<Vec<_>>();
    said.truncate(6);
    match said.pop() {
        None => "this does not belong here".to_owned(),
        Some(only) if said.is_empty() && only == say(Expected::End) => "it should end here".to_owned(),
        Some(only) if said.is_empty() => format!("expected {only}"),
        Some(last) => format!("expected {} or {last}", said.join(", ")),
    }
}

fn say(expected: Expected) -> String {
    match expected {
        Expected::Literal(word) => format!("`{word}`"),
        Expected::Name => "a name".to_owned(),
        Expected::Kind(kind) => kind.to_owned(),
        Expected::Operator => "an operator".to_owned(),
        Expected::End => "its end".to_owned(),
    }
}

/// The words that begin a statement.
pub(super) fn statements() -> impl Iterator<Item = &'static str> {
    words_of(Place::Statement).chain(words_of(Place::Pair))
}

/// Whether a statement begins with the word.
pub(super) fn is_statement(word: &str) -> bool {
    statements().any(|w| w == word)
}

/// Whether a member of a link begins with the word, as a word of the language.
pub(super) fn is_member(word: &str) -> bool {
    words_of(Place::Member).any(|w| w == word)
}

/// Whether a member of a cam begins with the word.
pub(super) fn is_cam_member(word: &str) -> bool {
    words_of(Place::CamMember).any(|w| w == word)
}

/// The words that may stand within a statement.
pub(super) fn within() -> impl Iterator<Item = &'static str> {
    [Place::Connecting, Place::Contextual, Place::Shape].into_iter().flat_map(words_of)
}

/// A line that begins with the word of a statement or of a member of a link.
pub(super) fn example(word: &str) -> Option<&'static str> {
    let tables = [STATEMENTS, PAIRS, MEMBERS];
    tables.into_iter().flatten().find(|row| row.word == word).map(|row| row.example)
}

/// Whether it is called like a function: the ends of a rope are.
pub(super) fn is_called(word: &str) -> bool {
    matches!(word, "over" | "under") || Function::named(word).is_some()
}

/// Whether a word cannot be a name.
pub fn is_reserved(word: &str) -> bool {
    words_of(Place::Connecting).chain(words_of(Place::Law)).any(|w| w == word)
}

/// Whether a character may stand in a name.
pub(super) fn is_name_char(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '\'' | '\u{2080}'..='\u{2089}')
}

// What pest makes of the grammar.

mod parser {
    #[derive(pest_derive::Parser)]
    #[grammar = "../../../grammar/mech.pest"]
    pub struct Grammar;
}
