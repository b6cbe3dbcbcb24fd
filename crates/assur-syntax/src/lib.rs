//! Text → [`Document`].
//!
//! Parsing cannot fail: a part that cannot be read is reported and kept as `Bad`.

mod comma;
mod confusables;
mod lower;
mod prepare;
mod recover;
mod tokens;
mod trivia;
mod whole;
mod words;

pub mod document;
pub mod given;

pub use comma::{between_digits, readings};
pub use confusables::skeleton;
pub use tokens::{Token, TokenKind};
pub use words::is_reserved;

use assur_text::diagnostic::Problems;
use assur_text::source::{Source, Span};
use document::Document;
use pest::Parser;
use pest::iterators::Pairs;
use words::{Grammar, Rule};

/// Reads a text. Every mistake is reported, and the document contains all parts that could be read.
#[must_use]
pub fn parse(source: &Source) -> (Document, Problems) {
    let (document, problems, _) = read(source, |_, _, _| ());
    (document, problems)
}

/// A text read, with the tokens it consists of.
#[must_use]
pub fn parse_with_tokens(source: &Source) -> (Document, Vec<Token>, Problems) {
    let (document, problems, found) = read(source, tokens::tokens);
    (document, found.unwrap_or_default(), problems)
}

/// Reads a text, and takes from the pairs what else is wanted of them.
fn read<T>(
    source: &Source,
    also: impl FnOnce(&str, &str, Pairs<'_, Rule>) -> T,
) -> (Document, Problems, Option<T>) {
    let mut problems = Problems::new();
    let text = &source.text;
    let read = prepare::prepare(text, &mut problems);
    let mut document = Document { trivia: trivia::scan(text), ..Document::default() };
    let mut taken = None;
    match Grammar::parse(Rule::file, &read) {
        Ok(pairs) => {
            taken = Some(also(text, &read, pairs.clone()));
            let (statements, found) = lower::file(text, &read, pairs);
            problems.append(found);
            document.notes = trivia::notes(text, &statements, &document.trivia);
            document.statements = statements;
        }
        Err(_) => problems.push(recover::unreadable(Span::new(0, text.len()))),
    }
    whole::check(&document, &mut problems);
    (document, problems, taken)
}
