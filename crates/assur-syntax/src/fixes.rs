//! The fixes of errors of the lines of a text.

use super::error::SyntaxError;
use assur_text::diagnostic::{Fix, Help, Problem};
use assur_text::source::{Edit, Span};

impl SyntaxError {
    /// A comma within a number: the lines are those that may be meant.
    pub(super) fn comma_in_number(at: Span, lines: Vec<Help>) -> Self {
        match <[Help; 1]>::try_from(lines) {
            Ok([help]) => Self::DecimalComma { at, help },
            Err(lines) => Self::ThousandsComma { at, help: Help::one_of(lines) },
        }
    }

    fn help(&self) -> Option<&Help> {
        match self {
            Self::BareDecimalPoint { help, .. }
            | Self::DecimalComma { help, .. }
            | Self::ThousandsComma { help, .. }
            | Self::BraceOnItsOwnLine { help, .. }
            | Self::StatementInBraces { help, .. }
            | Self::EqualsExpected { help, .. }
            | Self::ColonExpected { help, .. }
            | Self::UnclosedText { help, .. }
            | Self::TitleWithoutQuotes { help, .. }
            | Self::UnitInRow { help, .. }
            | Self::UnknownStatement { help, .. }
            | Self::FindAt { help, .. }
            | Self::MisplacedMember { help, .. }
            | Self::ReservedName { help, .. }
            | Self::TwoStatements { help, .. }
            | Self::MissingWord { help, .. }
            | Self::SeveralMistakes { help, .. }
            | Self::MissingOperator { help, .. }
            | Self::OtherWord { help, .. }
            | Self::NeedlessSign { help, .. }
            | Self::CommaBetween { help, .. }
            | Self::WithoutBrackets { help, .. }
            | Self::DigitFirst { help, .. }
            | Self::CommentSign { help, .. }
            | Self::PointWithoutCoordinates { help, .. }
            | Self::MissingBrace { help, .. } => Some(help),
            Self::UnclosedBracket { help, .. }
            | Self::UnmatchedBracket { help, .. }
            | Self::MisspeltWord { help, .. }
            | Self::Unexpected { help, .. } => help.as_ref(),
            _ => None,
        }
    }
}

impl Problem for SyntaxError {
    fn fixes(&self) -> Vec<Fix> {
        if let Self::UnknownEdition { at, .. } = self {
            let (title, edits) = ("write `mech 1`".to_owned(), vec![Edit::new(*at, "1")]);
            return vec![Fix { title, edits, certain: false }];
        }
        match self {
            Self::TitleTwice { at, .. } => return vec![Fix::left_out("the second title", *at)],
            Self::EditionNotFirst { at, help, .. } if help.starts_with("remove ") => {
                return vec![Fix::left_out("this one", *at)];
            }
            _ => {}
        }
        let Some(help) = self.help() else { return Vec::new() };
        match self {
            Self::BareDecimalPoint { .. }
            | Self::BraceOnItsOwnLine { .. }
            | Self::ColonExpected { .. }
            | Self::CommentSign { .. }
            | Self::DecimalComma { .. }
            | Self::EqualsExpected { .. }
            | Self::NeedlessSign { .. }
            | Self::TitleWithoutQuotes { .. }
            | Self::UnclosedText { .. } => help.clone().certain().fixes().to_vec(),
            // `im` may be `in` or `on`
            Self::MisspeltWord { wanted, .. } if wanted.len() > 3 => help.clone().certain().fixes().to_vec(),
            _ => help.fixes().to_vec(),
        }
    }
}
