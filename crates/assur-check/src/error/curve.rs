//! Errors of curves.

use assur_text::diagnostic::{Fix, Problem};
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

#[derive(Clone, Debug, Error, Diagnostic)]
pub enum CurveError {
    /// It has the name of a function.
    #[error("`{name}` is a function of the language, and cannot name a curve")]
    #[diagnostic(code("mech::curve::name"), help("give the curve another name, as in `curve {name}_1 {{`"))]
    Name {
        name: String,
        #[label(primary, "already a function")]
        span: Span,
    },
    /// It is no table of arguments and values.
    #[error("curve `{name}`: {message}")]
    #[diagnostic(code("mech::curve::table"), help("{help}"))]
    Table {
        name: String,
        message: String,
        help: String,
        #[label(primary, "here")]
        span: Span,
    },
    /// Its arguments do not rise.
    #[error("the arguments of curve `{name}` do not rise: {before} is followed by {here}")]
    #[diagnostic(
        code("mech::curve::order"),
        help(
            "sort the rows by their first number, and give each argument once; a jump takes two arguments close together"
        )
    )]
    Order {
        name: String,
        /// The argument of the row before.
        before: String,
        /// That of this row.
        here: String,
        #[label(primary, "not above {before}")]
        span: Span,
        #[label("{before}")]
        last: Span,
    },
    /// It is to begin again at another value than it ends with.
    #[error("curve `{name}` is periodic, but begins with {first} and ends with {last}")]
    #[diagnostic(code("mech::curve::ends"), help("{help}"))]
    Ends {
        name: String,
        first: String,
        last: String,
        /// The row to write, or the word to leave out.
        help: String,
        #[label(primary, "should end with {first}")]
        span: Span,
    },
    /// Its slope is asked of something else.
    #[error("`slope` takes a call of a curve")]
    #[diagnostic(code("mech::curve::slope"), help("{help}"))]
    Slope {
        /// A call that can be read.
        help: String,
        #[label(primary, "not a call of a curve")]
        span: Span,
    },
    /// An argument beyond its table.
    #[error("curve `{name}` has no value at {argument}: its table goes from {extent}")]
    #[diagnostic(
        code("mech::curve::outside"),
        help(
            "add rows, or write `periodic` after its name if it begins again, or `held` if its end values hold beyond the table"
        )
    )]
    Outside {
        name: String,
        argument: String,
        extent: String,
        #[label(primary, "{argument}")]
        span: Span,
        #[label("{extent}")]
        declared: Span,
    },
}

impl Problem for CurveError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::Ends { help, span, .. } => {
                let said = help.find("write `").and_then(|at| help.get(at..)).unwrap_or_default();
                Fix::quoted(said, *span).into_iter().take(1).collect()
            }
            _ => Vec::new(),
        }
    }
}
