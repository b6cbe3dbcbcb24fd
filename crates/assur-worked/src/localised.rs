//! Tables and pictures that are made in English, in the language and with the letters of a solution.

use crate::document::{Block, Inline, Line, Table, commas};
use crate::words::{Language, known, phrase, title};
use assur_drawing::{Drawing, Level, Run, Text};
use assur_formula::units_in_cyrillic;
use assur_model::model::Mechanism;
use assur_picture::Wording;

/// Blocks of another document in a language; names of the file stay as they are.
#[must_use]
pub fn localised(language: Language, blocks: Vec<Block>) -> Vec<Block> {
    let line = |line: Line| -> Line {
        let part = |part: Inline| match part {
            Inline::Text(words) => Inline::Text(phrase(language, &words)),
            part => part,
        };
        line.into_iter().map(part).collect()
    };
    let block = |block: Block| match block {
        Block::Heading(level, words) => Block::Heading(level, phrase(language, &words)),
        Block::Paragraph(words) => Block::Paragraph(line(words)),
        Block::Remark(words) => Block::Remark(line(words)),
        Block::Table(table) => Block::Table(Table {
            headers: table.headers.into_iter().map(line).collect(),
            rows: table.rows.into_iter().map(|row| row.into_iter().map(line).collect()).collect(),
            ..table
        }),
        block => block,
    };
    let blocks = blocks.into_iter().map(block);
    if language.letters().comma { blocks.map(Block::with_commas).collect() } else { blocks.collect() }
}

/// A picture in a language, with the letters of its courses.
#[must_use]
pub fn drawing_in(language: Language, mechanism: &Mechanism, mut drawing: Drawing) -> Drawing {
    if language == Language::English {
        return drawing;
    }
    let figures = |words: String| {
        if language.letters().comma { units_in_cyrillic(&commas(&words)) } else { words }
    };
    drawing.title = figures(title(language, &drawing.title));
    drawing.description = figures(with_frame(language, &said_in(language, &drawing.description)));
    if drawing.description.is_empty() {
        drawing.description.clone_from(&drawing.title);
    }
    let labels = drawing.labels.iter_mut().map(|label| &mut label.text);
    let captions = drawing.captions.iter_mut().flat_map(|caption| {
        std::iter::once(&mut caption.text).chain(caption.bar.as_mut().map(|(_, text)| text))
    });
    for text in labels.chain(captions) {
        relabel(language, mechanism, text);
    }
    drawing
}

impl Wording for Language {
    fn code(&self) -> &'static str {
        (*self).code()
    }

    fn decimal(&self) -> char {
        if self.letters().comma { ',' } else { '.' }
    }

    fn phrase(&self, english: &str) -> String {
        phrase(*self, english)
    }

    fn drawing(&self, mechanism: &Mechanism, drawing: Drawing) -> Drawing {
        drawing_in(*self, mechanism, drawing)
    }
}

/// The word for the frame in place of `ground`, which no other link is called.
fn with_frame(language: Language, words: &str) -> String {
    let frame = if language == Language::Russian { "стойка" } else { "机架" };
    let is_in_name = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '.');
    let mut out = String::new();
    let mut rest = words;
    while let Some((before, behind)) = rest.split_once("ground") {
        let is_word = !before.ends_with(is_in_name) && !behind.starts_with(is_in_name);
        out = out + before + if is_word { frame } else { "ground" };
        rest = behind;
    }
    out + rest
}

/// What a picture says, sentence by sentence; one that the language does not have is left out.
fn said_in(language: Language, english: &str) -> String {
    let sentences = english.split_inclusive(". ").flat_map(|sentence| {
        let sentence = sentence.trim();
        known(language, sentence).map_or_else(
            || {
                // what is said of one pair after another
                let items = sentence.trim_end_matches('.').split("; ");
                items.filter_map(|item| known(language, &format!("{item}."))).collect()
            },
            |said| vec![said],
        )
    });
    let apart = if language == Language::Chinese { "" } else { " " };
    sentences.collect::<Vec<_>>().join(apart)
}

fn relabel(language: Language, mechanism: &Mechanism, text: &mut Text) {
    let letters = language.letters();
    for i in 0..text.runs.len() {
        let next = text.runs.get(i + 1).cloned();
        let index = next.as_ref().filter(|run| run.level == Level::Sub).map(|run| run.letters.clone());
        let run = &mut text.runs[i];
        let quantity = run.italic && run.level == Level::Base;
        if run.level == Level::Sup && run.letters == "t" {
            run.letters = letters.tangential.to_owned();
        } else if run.level == Level::Base && (!run.italic || run.letters.contains(' ')) {
            // `a (rope)`: a name with its kind
            let kind = run.letters.strip_suffix(')').and_then(|words| words.split_once(" ("));
            run.letters = match kind {
                Some((name, kind)) => format!("{name} ({})", phrase(language, kind)),
                None => phrase(language, &run.letters),
            };
        }
        // a reaction may have a mark between its letter and its index
        let index = index.or_else(|| {
            let mark =
                next.filter(|run| run.level == Level::Sup && matches!(run.letters.as_str(), "n" | "t"))?;
            let behind =
                text.runs.get(i + 2).filter(|run| run.level == Level::Sub && mark.level == Level::Sup)?;
            Some(behind.letters.clone())
        });
        if text.runs[i].letters.contains("ground") {
            text.runs[i].letters = with_frame(language, &text.runs[i].letters);
        }
        let Some(index) = index.filter(|_| quantity) else { continue };
        let letter = text.runs[i].letters.clone();
        let base = if letter.trim_end().ends_with('R') && is_reaction(mechanism, &index) {
            let (letter, lead) = letters.reaction;
            text.runs[i].letters = letter.to_owned();
            Some(format!("{lead}{}", with_frame(language, &index)))
        } else {
            let own = index.strip_prefix('I').filter(|own| is_link(mechanism, own));
            own.filter(|_| matches!(letter.as_str(), "F" | "M"))
                .map(|own| format!("{}{own}", letters.inertia))
        };
        let lowered = |run: &&mut Run| run.level == Level::Sub;
        if let (Some(index), Some(run)) = (base, text.runs.iter_mut().skip(i + 1).find(lowered)) {
            run.letters = index;
        }
    }
    if letters.comma {
        for run in &mut text.runs {
            run.letters = commas(&run.letters);
            if run.unit {
                run.letters = language.unit(&run.letters);
            } else if !run.italic && run.level == Level::Base {
                run.letters = units_in_cyrillic(&run.letters);
            }
        }
    }
}

fn is_link(mechanism: &Mechanism, label: &str) -> bool {
    mechanism.links.iter().any(|link| link.number.as_deref().unwrap_or(&link.name) == label)
}

/// Whether an index is of a reaction: of two links, or of a link and a pair that stands for one.
fn is_reaction(mechanism: &Mechanism, index: &str) -> bool {
    let is_body =
        |label: &str| is_link(mechanism, label) || mechanism.pairs.iter().any(|pair| pair.name == label);
    match index.split_once(',') {
        Some((from, on)) => is_body(from) && is_body(on),
        None => {
            let cuts = index.char_indices().skip(1).map(|(at, _)| index.split_at(at));
            cuts.into_iter().any(|(from, on)| is_body(from) && is_body(on))
        }
    }
}
