//! The page of a question of PrairieLearn: what all rows show is written, the rest comes from the row.

use super::{Quiz, QuizGap};
use assur_drawing::escaped;
use assur_text::units::significant;
use assur_worked::{Block, Document, PicturePlace, fragment, how_to_answer, inline, printed_unit};
use serde_json::{Map, Value, json};

/// The last part that belongs to the question alone: inputs are shown with an answer too, and with what is said of it.
const HOW: &str = "how";

/// A part of a page.
#[derive(Clone, Debug)]
pub(super) struct Shown {
    /// What it is in every row.
    id: String,
    html: String,
    /// The parameter of rows that have it, where it is the same in all of them.
    given: Option<String>,
}

/// The page of one row.
pub(super) struct Template {
    pub shown: Vec<Shown>,
    /// Its pictures as SVG.
    pub pictures: Vec<String>,
}

impl Template {
    /// The sheet, block by block.
    pub fn of(sheet: &Document) -> Self {
        let mut it = Self { shown: Vec::new(), pictures: Vec::new() };
        for (i, block) in sheet.blocks.iter().enumerate() {
            if let Block::Figures(figures) = block {
                for figure in figures {
                    it.pictures.push(figure.svg.clone());
                    it.picture(&figure.caption);
                }
                continue;
            }
            let alone = Document { blocks: vec![block.clone()], ..sheet.clone() };
            let none = PicturePlace { before: "", stem: "", ending: "" };
            it.add(format!("block {i}"), fragment(&alone, none).0);
        }
        it
    }

    fn add(&mut self, id: String, html: String) {
        self.shown.push(Shown { id, html, given: None });
    }

    fn picture(&mut self, caption: &str) {
        let name = format!("picture_{}", self.pictures.len());
        let html = format!(
            "<pl-figure file-name=\"{{{{params.{name}}}}}\" alt=\"{{{{params.title}}}}\"></pl-figure>\n"
        );
        self.shown.push(Shown { id: name.clone(), html, given: Some(name.clone()) });
        if !caption.is_empty() {
            self.add(format!("below {name}"), format!("<p>{}</p>\n", escaped(caption)));
        }
    }

    /// An input for every gap with its name, whether a plain number is asked for, and its weight.
    pub fn ask<'g>(
        &mut self,
        quiz: &Quiz,
        gaps: impl Iterator<Item = (&'g QuizGap, &'g str, bool, u32)>,
        within: f64,
    ) {
        self.add(HOW.to_owned(), format!("<p>{}</p>\n", escaped(&how_to_answer(quiz.language, true))));
        let mut position = &None;
        for (gap, name, is_plain, weight) in gaps {
            if gap.gap.position != *position {
                position = &gap.gap.position;
                if let Some([name, words]) = position {
                    self.add(format!("position {name}"), format!("<h5>{}</h5>\n", escaped(words)));
                }
            }
            let label = attribute(&format!("{} =", inline(&gap.gap.letters)));
            let unit = printed_unit(&quiz.language.unit(&gap.unit.text));
            let suffix = if is_plain && !unit.is_empty() {
                format!(" suffix=\"{}\"", attribute(unit.trim()))
            } else {
                String::new()
            };
            let element = if is_plain { "pl-number-input" } else { "pl-units-input" };
            let html = format!(
                "<p><{element} answers-name=\"{name}\" label=\"{label}\"{suffix} rtol=\"{}\" weight=\"{weight}\">\
                 </{element}></p>\n",
                significant(within, 6)
            );
            self.shown.push(Shown { id: format!("gap {name}"), html, given: Some(format!("asked.{name}")) });
        }
    }
}

/// A text between quotation marks, which is read as HTML.
fn attribute(text: &str) -> String {
    unbraced(&text.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;").replace('>', "&gt;"))
}

/// Two braces next to each other would be read as the name of a parameter.
pub(super) fn unbraced(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '{' | '}') && out.ends_with(c) {
            out.push(' ');
        }
        out.push(c);
    }
    out
}

/// One page for all rows, and what each row adds to its parameters.
pub(super) fn merged(rows: &[&[Shown]]) -> (String, Vec<Map<String, Value>>) {
    let mut params = vec![Map::new(); rows.len()];
    let mut page = "<pl-question-panel>\n".to_owned();
    for (number, id) in (1..).zip(ordered(rows)) {
        let all: Vec<Option<&Shown>> = rows.iter().map(|row| row.iter().find(|it| it.id == id)).collect();
        let Some(first) = all.iter().flatten().next() else { continue };
        let is_same = all.iter().flatten().all(|it| it.html == first.html);
        let is_everywhere = all.iter().all(Option::is_some);
        match &first.given {
            Some(_) if is_same && is_everywhere => page += &first.html,
            Some(name) if is_same => {
                page += &format!("{{{{#params.{name}}}}}\n{}{{{{/params.{name}}}}}\n", first.html)
            }
            None if is_same && is_everywhere => page += &unbraced(&first.html),
            _ => {
                let name = format!("text_{number}");
                page += &format!("{{{{{{params.{name}}}}}}}\n");
                for (params, shown) in params.iter_mut().zip(&all) {
                    params
                        .insert(name.clone(), json!(shown.map_or_else(String::new, |it| unbraced(&it.html))));
                }
            }
        }
        if id == HOW {
            page += "</pl-question-panel>\n";
        }
    }
    page += "<pl-answer-panel>\n{{{params.solution}}}\n</pl-answer-panel>\n";
    (page, params)
}

/// The parts of all rows in the order of the page.
fn ordered<'s>(rows: &[&'s [Shown]]) -> Vec<&'s str> {
    let mut ids: Vec<&str> = Vec::new();
    for row in rows {
        let mut next = 0;
        for shown in *row {
            match ids.iter().position(|id| *id == shown.id) {
                Some(place) => next = place + 1,
                None => {
                    ids.insert(next, &shown.id);
                    next += 1;
                }
            }
        }
    }
    ids
}
