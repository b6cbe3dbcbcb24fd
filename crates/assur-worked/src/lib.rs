//! Worked solutions: what a good student hands in, from one position of a solved problem. Nothing is solved here: every number is
//! the solver's, and a formula that does not agree with it is not printed.

mod angle;
mod asked;
mod asked_formula;
mod asked_rest;
mod asked_results;
mod cam_law;
mod course;
mod design;
mod document;
mod expressions;
mod forces;
mod formulas;
mod gaps;
mod given;
mod jerks;
mod letters;
mod localised;
mod motion;
mod notation;
mod overview;
mod pictures;
mod points;
mod problem;
mod prune;
mod questions;
mod results;
mod sheet;
mod spline;
mod structure;
mod symbols;
mod system;
mod words;
mod worked;
mod write;

pub use asked_formula::written_in_letters;
pub use assur_formula::Name;
pub use course::Counts;
pub use design::{Page, design};
pub use document::{Block, Document, Figure, Inline, Table, Term};
pub use forces::quantity_name;
pub use formulas::Formula;
pub use gaps::{Gap, GapSheet, gaps, how_to_answer, verdict, without_pictures};
pub use given::{Data, drive_letter, given};
pub use localised::{drawing_in, localised};
pub use pictures::drawn_for_paper;
pub use questions::question;
pub use results::unit_of;
pub use sheet::{
    Exercise, SheetQuestion, Variants, asks_for_positions, in_letters, key, letters_in_text, printed_unit,
    sheet,
};
pub use words::{Language, Sentence, TutorialMessage, phrase};
pub use worked::{Part, Size, Worked, worked, worked_from};
pub use write::{
    PicturePlace, fragment, html, html_of_several, inline, markdown, text, typst, typst_escaped,
};
