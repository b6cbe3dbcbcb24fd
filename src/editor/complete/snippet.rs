//! Examples of the tables as texts with places to fill.

use assur_syntax::{TokenKind, parse_with_tokens};
use assur_text::language::{FUNCTIONS, Function, PROPERTIES, WORDS};
use assur_text::source::Source;
use indexmap::IndexMap;
use std::fmt::Write;
use std::sync::LazyLock;

/// All examples of the tables, made once.
static ALL: LazyLock<IndexMap<&'static str, String>> = LazyLock::new(|| {
    let words = WORDS.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let properties = PROPERTIES.iter().flat_map(|(_, all)| all.iter()).map(|row| row.example);
    let functions = FUNCTIONS.iter().map(|row| row.usage);
    words.chain(properties).chain(functions).map(|example| (example, made(example))).collect()
});

/// An example of the tables whose names and numbers are places to fill.
pub fn of(example: &str) -> String {
    ALL.get(example).cloned().unwrap_or_else(|| example.to_owned())
}

fn made(example: &str) -> String {
    // the tables have a sentence in place of rows
    if let Some((before, _)) = example.split_once("{ then ") {
        return format!("{}{{\n\t$0\n}}", made(before));
    }
    let (_, tokens, _) = parse_with_tokens(&Source::new("", example));
    let (mut out, mut end, mut places) = (String::new(), 0, 0);
    for (index, token) in tokens.iter().enumerate() {
        out.push_str(&escaped(example.get(end..token.span.start).unwrap_or_default()));
        let text = token.text(example);
        let is_name = token.kind == TokenKind::Word && index > 0 && !is_word(text);
        if is_name || token.kind == TokenKind::Number {
            places += 1;
            // writing to a text cannot fail
            _ = write!(out, "${{{places}:{}}}", escaped(text));
        } else {
            out.push_str(&escaped(text));
        }
        end = token.span.end;
    }
    out + &escaped(example.get(end..).unwrap_or_default())
}

fn is_word(text: &str) -> bool {
    let is_property = || PROPERTIES.iter().flat_map(|(_, all)| all.iter()).any(|p| p.name == text);
    WORDS.iter().flat_map(|(_, all)| all.iter()).any(|row| row.word == text)
        || Function::named(text).is_some()
        || is_property()
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}")
}
