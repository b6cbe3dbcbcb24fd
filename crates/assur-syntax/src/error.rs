//! Errors of the lines of a text: signs, words, statements.

use assur_text::diagnostic::Help;
use assur_text::source::Span;
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// A mistake in the text. `help` is, where possible, the corrected line.
#[derive(Clone, Debug, Diagnostic, Error)]
pub enum SyntaxError {
    #[error("the file is empty")]
    #[diagnostic(
        code(mech::syntax::empty_file),
        help("begin with a title: mechanism \"My first crank-slider\"")
    )]
    EmptyFile,

    #[error("nested more than {limit} levels deep")]
    #[diagnostic(
        code(mech::syntax::too_deep),
        help("give a part of it a name: let part = …; the rest of this line is not read")
    )]
    TooDeep {
        limit: usize,
        #[label("one level too many")]
        at: Span,
    },

    #[error("a decimal point needs digits on both sides")]
    #[diagnostic(code(mech::syntax::bare_decimal_point))]
    BareDecimalPoint {
        #[label("no digits {side} the point")]
        at: Span,
        side: &'static str,
        #[help]
        help: Help,
    },

    #[error("the number {text} is too large")]
    #[diagnostic(
        code(mech::syntax::number_too_large),
        help("check the exponent: the largest number is 1.7e308")
    )]
    NumberTooLarge {
        text: String,
        #[label("too large")]
        at: Span,
    },

    #[error("use a decimal point, not a comma")]
    #[diagnostic(code(mech::syntax::decimal_comma))]
    DecimalComma {
        #[label("a comma separates the values of a list")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("a comma in a number is ambiguous: decimal point or thousands")]
    #[diagnostic(code(mech::syntax::decimal_comma))]
    ThousandsComma {
        #[label("three digits follow")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("put `{{` on the same line as its statement")]
    #[diagnostic(code(mech::syntax::brace_on_its_own_line))]
    BraceOnItsOwnLine {
        #[label("this brace")]
        brace: Span,
        #[label("after this")]
        statement: Span,
        #[help]
        help: Help,
    },

    #[error("a brace is not closed")]
    #[diagnostic(code(mech::syntax::missing_brace))]
    MissingBrace {
        #[label("opened here")]
        open: Span,
        #[label("still open here")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("`{word}` is a statement of its own")]
    #[diagnostic(code(mech::syntax::statement_in_braces))]
    StatementInBraces {
        word: String,
        #[label("within these braces")]
        open: Span,
        #[label(primary, "this belongs after them")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("a bracket is not closed")]
    #[diagnostic(code(mech::syntax::unclosed_bracket))]
    UnclosedBracket {
        #[label("opened here")]
        open: Span,
        #[help]
        help: Option<Help>,
    },

    #[error("unmatched `{found}`")]
    #[diagnostic(code(mech::syntax::unmatched_bracket))]
    UnmatchedBracket {
        found: char,
        #[label("no bracket is open here")]
        at: Span,
        #[help]
        help: Option<Help>,
    },

    #[error("use `=` to assign a value")]
    #[diagnostic(code(mech::syntax::equals_expected))]
    EqualsExpected {
        found: String,
        #[label("`{found}` instead of `=`")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("use `:` between a name and what it joins")]
    #[diagnostic(code(mech::syntax::colon_expected))]
    ColonExpected {
        found: String,
        #[label("`{found}` instead of `:`")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("a text is not closed")]
    #[diagnostic(code(mech::syntax::unclosed_text))]
    UnclosedText {
        #[label("the closing quote is missing on this line")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("put the title in quotes")]
    #[diagnostic(code(mech::syntax::title_without_quotes))]
    TitleWithoutQuotes {
        #[label("the title")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("the file has two titles")]
    #[diagnostic(code(mech::syntax::title_twice), help("remove one of them: one file is one problem"))]
    TitleTwice {
        #[label(primary, "a second title")]
        at: Span,
        #[label("the first one")]
        first: Span,
    },

    #[error("edition {found} of the language does not exist")]
    #[diagnostic(code(mech::syntax::unknown_edition), help("write `mech 1`; this is the only edition"))]
    UnknownEdition {
        found: String,
        #[label("only edition 1 exists")]
        at: Span,
    },

    #[error("the edition must be the first statement, once")]
    #[diagnostic(code(mech::syntax::edition_not_first), help("{help}"))]
    EditionNotFirst {
        #[label(primary, "the edition")]
        at: Span,
        #[label("{other}")]
        before: Span,
        other: &'static str,
        help: &'static str,
    },

    #[error("table rows take plain numbers; the unit goes in the header")]
    #[diagnostic(code(mech::syntax::unit_in_row))]
    UnitInRow {
        #[label("a unit")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("`{found}` is not known here")]
    #[diagnostic(code(mech::syntax::misspelt_word))]
    MisspeltWord {
        found: String,
        #[label("did you mean `{wanted}`?")]
        at: Span,
        wanted: String,
        #[help]
        help: Option<Help>,
    },

    #[error("no statement begins with `{found}`")]
    #[diagnostic(code(mech::syntax::unknown_statement), help("{help}"))]
    UnknownStatement {
        found: String,
        #[label("not a statement")]
        at: Span,
        help: Help,
    },

    #[error("an item of `find` is taken at all positions, and takes no `at`")]
    #[diagnostic(code(mech::syntax::misplaced_member), help("{help}"))]
    FindAt {
        help: Help,
        #[label("not here")]
        at: Span,
    },

    #[error("`{found}` is not a statement")]
    #[diagnostic(code(mech::syntax::misplaced_member), help("{help}"))]
    MisplacedMember {
        found: String,
        #[label("{place}")]
        at: Span,
        place: &'static str,
        help: Help,
    },

    #[error("`{found}` is a word of the language and cannot be a name")]
    #[diagnostic(code(mech::syntax::reserved_name))]
    ReservedName {
        found: String,
        #[label("choose another name")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("two statements or members are not separated")]
    #[diagnostic(code(mech::syntax::two_statements))]
    TwoStatements {
        #[label("a new line, or `;`, before this")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("`{missing}` is missing")]
    #[diagnostic(code(mech::syntax::missing_word))]
    MissingWord {
        missing: String,
        #[label("before this")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("this line has {count} mistakes")]
    #[diagnostic(code(mech::syntax::several_mistakes))]
    SeveralMistakes {
        count: usize,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
        #[help]
        help: Help,
    },

    #[error("an operator is missing")]
    #[diagnostic(code(mech::syntax::missing_operator))]
    MissingOperator {
        #[label("before this")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("`{wanted}` is expected instead of `{found}`")]
    #[diagnostic(code(mech::syntax::other_word))]
    OtherWord {
        found: String,
        wanted: String,
        #[label("`{wanted}` instead of this")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("unexpected `{found}`")]
    #[diagnostic(code(mech::syntax::needless_sign))]
    NeedlessSign {
        found: String,
        #[label("leave this out")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("a comma does not separate statements or members")]
    #[diagnostic(code(mech::syntax::comma_between))]
    CommaBetween {
        #[label("`;` or a new line instead of this")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("put the argument of `{function}` in parentheses")]
    #[diagnostic(code(mech::syntax::without_brackets))]
    WithoutBrackets {
        function: String,
        #[label("in parentheses")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("`{found}` cannot be a name: it begins with a digit")]
    #[diagnostic(code(mech::syntax::digit_first))]
    DigitFirst {
        found: String,
        #[label("a name begins with a letter")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("a vector has exactly two coordinates")]
    #[diagnostic(
        code(mech::syntax::third_coordinate),
        help("write `(x, y)`, mechanisms are planar; in numbers use a decimal point, not a comma")
    )]
    ThirdCoordinate {
        #[label("a third coordinate")]
        at: Span,
    },

    #[error("a comment begins with `//`")]
    #[diagnostic(code(mech::syntax::comment_sign))]
    CommentSign {
        #[label("`{found}` does not start a comment; use `//`")]
        at: Span,
        found: String,
        #[help]
        help: Help,
    },

    #[error("a point needs its coordinates")]
    #[diagnostic(code(mech::syntax::point_without_coordinates))]
    PointWithoutCoordinates {
        #[label("`(x, y)` is missing")]
        at: Span,
        #[help]
        help: Help,
    },

    #[error("cannot read {what}: {expected}")]
    #[diagnostic(code(mech::syntax::unexpected))]
    Unexpected {
        what: String,
        expected: String,
        #[label("{found}")]
        at: Span,
        found: String,
        #[help]
        help: Option<Help>,
    },
}
