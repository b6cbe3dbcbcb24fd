//! What a page shows of a text: its picture in motion, its answers, what is wrong with it, and where what is drawn is declared.

use super::symbols::{Symbol, SymbolKind};
use super::{Analysis, Results, symbols};
use crate::pipeline::Solved;
use crate::report::{
    AccuracyShown, PrintedDigits, of_answers,
    text::{self, Look},
};
use assur_check::Overrides;
use assur_picture::Moving;
use assur_text::diagnostic::{Problems, Style, place, render_most};
use assur_text::source::{Span, shown_in_line};
use assur_worked::Language;
use serde::Serialize;

/// How diagnostics are drawn: as in a terminal of 100 columns, without colours.
const STYLE: Style = Style::Graphical { colour: false, width: 100 };
/// The most diagnostics, as in a terminal.
const MOST: usize = 50;

/// What a page shows of a text.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PageParts {
    /// The mechanism, in motion where it can move; none where nothing is solved.
    pub picture: Option<Moving>,
    /// The answers as in a terminal.
    pub answers: String,
    /// What is wrong, as in a terminal.
    pub diagnostics: String,
    /// Where names are declared.
    pub declared: Vec<Declared>,
}

/// A name with the statement that declares it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Declared {
    pub name: String,
    /// As groups of a picture are called: `link`, `pair`, else empty.
    pub class: &'static str,
    /// Its line, from 1.
    pub line: usize,
    /// The first line of the statement.
    pub text: String,
    #[serde(skip)]
    pub whole: Span,
}

impl Analysis {
    /// The text with its answers, or with why it has none.
    #[must_use]
    pub fn preview(&self, results: Option<&Results>) -> PageParts {
        let mut diagnostics = render_most(&self.problems, &self.source, STYLE, MOST);
        if let Some(results) = results {
            diagnostics += &render_most(&results.problems, &self.source, STYLE, MOST);
        }
        let Some(solved) = results.and_then(|results| results.solved.as_ref()) else {
            return PageParts { diagnostics, ..PageParts::default() };
        };
        let picture = match self.pictured(&Overrides::none(), Language::English).moving(solved, None) {
            Ok(picture) => Some(picture),
            Err(missing) => {
                diagnostics += &render_most(&Problems::of([missing]), &self.source, STYLE, MOST);
                None
            }
        };
        PageParts { picture, answers: self.answers(solved), diagnostics, declared: self.declared() }
    }

    fn answers(&self, solved: &Solved) -> String {
        let answers = solved.answers(PrintedDigits::READABLE);
        text::render(&of_answers(&self.source.name, &answers, AccuracyShown::Worst), Look::PLAIN)
    }

    /// Links and pairs first, where several things have one name.
    #[must_use]
    pub fn declared(&self) -> Vec<Declared> {
        let all = symbols(&self.document);
        let parts = all.iter().flat_map(|symbol| &symbol.parts);
        all.iter().chain(parts).map(|symbol| self.declaration(symbol)).collect()
    }

    /// What of a picture is at a byte: its class and its name; of a point its link.
    #[must_use]
    pub fn marked(&self, byte: usize) -> Option<(&'static str, String)> {
        let found = self.names.declarations(self.names.at(byte)?);
        let of_kind = |kind, class| {
            let one = found.iter().find(|d| d.kind == kind)?;
            Some((class, one.name.clone()))
        };
        let owner = || found.iter().find_map(|d| Some(("link", d.owner.clone()?)));
        of_kind(SymbolKind::Pair, "pair").or_else(|| of_kind(SymbolKind::Link, "link")).or_else(owner)
    }

    fn declaration(&self, symbol: &Symbol) -> Declared {
        let text = self.source.text.get(symbol.whole.start..symbol.whole.end).unwrap_or_default();
        Declared {
            name: symbol.name.clone(),
            class: match symbol.kind {
                SymbolKind::Link => "link",
                SymbolKind::Pair => "pair",
                _ => "",
            },
            line: place(&self.source.text, symbol.whole.start).line,
            text: shown_in_line(text.lines().next().unwrap_or_default().trim_end()).to_string(),
            whole: symbol.whole,
        }
    }
}
