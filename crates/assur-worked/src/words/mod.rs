//! All sentences of a worked solution: keys here, texts in `messages/en.txt`, `zh.txt`, `ru.txt`.

mod message;
mod phrase;

pub use message::TutorialMessage;
pub use message::{
    DesignMessage, FrictionMessage, FunctionWords, Message, QuestionMessage, RunMessage, SymbolMessage, word,
    words_of,
};
pub use phrase::{known, phrase, title};

use crate::document::{Inline, Labels, Line};
use assur_formula::cyrillic;
use message::text;

/// A language of sentences.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    #[default]
    English,
    Chinese,
    Russian,
}

impl Language {
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Chinese => "zh",
            Self::Russian => "ru",
        }
    }

    /// What writers put before parts.
    pub(crate) fn labels(self) -> Labels {
        let of = |key| text(self, "labels", key);
        Labels {
            contents: of("contents"),
            figure: of("figure"),
            cited: of("cited"),
            rows: ["equation", "magnitude", "direction"].map(of),
        }
    }

    /// A unit as it writes it.
    #[must_use]
    pub fn unit(self, unit: &str) -> String {
        if self.letters().comma { cyrillic(unit).unwrap_or_else(|| unit.to_owned()) } else { unit.to_owned() }
    }

    /// The letters of its courses.
    pub(crate) const fn letters(self) -> Letters {
        match self {
            Self::English => Letters {
                mobility: "F",
                lower: ("P", "L"),
                higher: ("P", "H"),
                tangential: "t",
                inertia: "I",
                reaction: ("R", ""),
                comma: false,
            },
            Self::Chinese => Letters { reaction: ("F", "R"), ..Self::English.letters() },
            Self::Russian => Letters {
                mobility: "W",
                lower: ("p", "5"),
                higher: ("p", "4"),
                tangential: "τ",
                inertia: "и",
                reaction: ("R", ""),
                comma: true,
            },
        }
    }
}

/// A sentence or a heading, with places for its parts.
pub trait Sentence: Copy {
    /// What it is in a language.
    fn template(self, language: Language) -> &'static str;

    /// Whether an equation follows, unless it is nothing for all values.
    fn awaits_an_equation(self) -> bool {
        false
    }
}

/// The letters of a course.
#[derive(Clone, Copy, Debug)]
pub struct Letters {
    pub mobility: &'static str,
    /// Number of lower pairs: letter and index.
    pub lower: (&'static str, &'static str),
    /// Number of higher pairs.
    pub higher: (&'static str, &'static str),
    /// The mark of tangential parts.
    pub tangential: &'static str,
    /// The index of inertia.
    pub inertia: &'static str,
    /// A reaction: letter and the begin of its index.
    pub reaction: (&'static str, &'static str),
    /// Decimals are behind a comma.
    pub comma: bool,
}

/// A sentence with its parts in their places.
pub fn say(language: Language, message: impl Sentence, parts: &[Line]) -> Line {
    let mut line = Vec::new();
    let mut rest = message.template(language);
    while let Some((before, after)) = rest.split_once('{') {
        let Some((index, behind)) = after.split_once('}') else { break };
        if !before.is_empty() {
            line.push(Inline::Text(before.to_owned()));
        }
        let part = index.parse::<usize>().ok().and_then(|i| parts.get(i));
        line.extend(part.into_iter().flatten().cloned());
        rest = behind;
    }
    if !rest.is_empty() {
        line.push(Inline::Text(rest.to_owned()));
    }
    line
}
