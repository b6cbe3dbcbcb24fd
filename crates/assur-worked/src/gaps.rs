//! An exercise as a question with gaps: what a sheet shows, and a gap in place of every cell.

use crate::course::plain;
use crate::document::{Block, Document, Line, commas};
use crate::questions::questions;
use crate::sheet::{Exercise, SheetQuestion, document};
use crate::words::{Language, Message, say};
use crate::worked::without_empty;
use assur_model::model::Value;

/// A number that is asked for.
#[derive(Clone, Debug)]
pub struct Gap {
    /// The name of its position and what a heading says of it, where there are several.
    pub position: Option<[String; 2]>,
    /// What `assur grade` reads it by: of a component with `.x` or `.y`.
    pub name: String,
    pub letters: Line,
    /// The place of its question among those of the file, where it has one.
    pub question: Option<usize>,
}

/// What is shown of an exercise, and what is asked.
#[derive(Clone, Debug)]
pub struct GapSheet {
    /// Statement, scheme, given values; the list of questions comes last.
    pub document: Document,
    pub gaps: Vec<Gap>,
    /// Questions whose answer is true or false.
    pub verdicts: Vec<String>,
}

/// A sheet with gaps in place of its cells. It hides what a sheet hides, and tells what a figure shows where there is none.
#[must_use]
pub fn gaps(exercise: &Exercise<'_>, language: Language, pictures: bool) -> GapSheet {
    let heading = |message: Message| Block::Heading(2, plain(&say(language, message, &[])));
    let mut blocks = exercise.statement(language, None);
    blocks.push(heading(Message::Given));
    blocks.extend(exercise.given(language, pictures));
    blocks.push(heading(Message::Find));
    blocks.push(Block::List(questions(exercise.mechanism, exercise.text, language)));
    let is_verdict = |value: &Option<Value>| matches!(value, Some(Value::Bool(_)));
    let verdicts = exercise.asked.iter().filter(|a| is_verdict(&a.value));
    let mut document = document(exercise, language, without_empty(blocks));
    // one picture needs no number
    document.labels.figure = "";
    GapSheet { document, verdicts: verdicts.map(|a| a.name.clone()).collect(), gaps: all(exercise, language) }
}

/// All gaps, position by position where there are several, then those of no position.
fn all(exercise: &Exercise<'_>, language: Language) -> Vec<Gap> {
    let own = exercise.own_letters(language);
    let at = |(position, asked): (Option<&String>, Vec<&SheetQuestion>)| -> Vec<Gap> {
        let position = position.map(|name| [name.clone(), exercise.position_in_words(name, language)]);
        let of = |(name, letters, question)| Gap { position: position.clone(), name, letters, question };
        asked.into_iter().flat_map(|asked| exercise.letters(asked, &own, language)).map(of).collect()
    };
    exercise.places().into_iter().flat_map(at).collect()
}

/// How a number is typed: with a decimal point, and with its unit where that is asked for.
#[must_use]
pub fn how_to_answer(language: Language, with_unit: bool) -> String {
    let message = if with_unit { Message::HowToAnswerWithUnit } else { Message::HowToAnswer };
    plain(&say(language, message, &[]))
}

/// A solution without its pictures, which says so.
#[must_use]
pub fn without_pictures(document: Document, language: Language) -> Document {
    let mut document = document.without_figures();
    document.blocks.push(Block::Remark(say(language, Message::PicturesLeftOut, &[])));
    document
}

/// What an answer is, as a sentence: `Right.`, `Twice the value.`
#[must_use]
pub fn verdict(language: Language, slip: Option<&str>) -> String {
    let words = match slip {
        Some(slip) => crate::words::phrase(language, slip),
        None => plain(&say(language, Message::AnswerIsRight, &[])),
    };
    let words = if language.letters().comma { commas(&words) } else { words };
    let mut letters = words.chars();
    let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
    let end = match language {
        _ if words.ends_with(['?', '.', '。', '？']) => "",
        Language::Chinese => "。",
        _ => ".",
    };
    format!("{first}{}{end}", letters.as_str())
}
