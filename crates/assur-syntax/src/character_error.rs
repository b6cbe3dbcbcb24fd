//! Errors of the characters of a text, before it is read.

use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Characters that the language does not have. `help` is the corrected line.
#[derive(Clone, Debug, Diagnostic, Error)]
pub enum CharacterError {
    #[error("full-width characters cannot be read")]
    #[diagnostic(code(mech::syntax::full_width))]
    FullWidth {
        #[label("written in full width")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("use straight quotes (`\"`)")]
    #[diagnostic(code(mech::syntax::curly_quotes))]
    CurlyQuotes {
        #[label("this is another kind of quote")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("`{found}` is not used here")]
    #[diagnostic(code(mech::syntax::foreign_sign))]
    ForeignSign {
        found: char,
        #[label("written `{wanted}` in this language")]
        at: Span,
        wanted: &'static str,
        #[help]
        help: Help,
    },

    #[error("invisible character (U+{found:04X})")]
    #[diagnostic(code(mech::syntax::invisible_character))]
    InvisibleCharacter {
        found: u32,
        #[label("invisible")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("this line ends with a carriage return alone")]
    #[diagnostic(
        code(mech::syntax::lone_carriage_return),
        severity(Warning),
        help("save the file with line ends LF or CR LF")
    )]
    LoneCarriageReturn {
        #[label("CR without LF")]
        at: Span,
    },
}

impl Problem for CharacterError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::FullWidth { help, .. }
            | Self::CurlyQuotes { help, .. }
            | Self::ForeignSign { help, .. }
            | Self::InvisibleCharacter { help, .. } => help.clone().certain().fixes().to_vec(),
            Self::LoneCarriageReturn { .. } => Vec::new(),
        }
    }
}
