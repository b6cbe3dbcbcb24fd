//! Names.

use assur_text::source::{Span, Spanned};
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// What can be wrong with a name.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum NameError {
    /// Nothing of that name is declared.
    #[error("there is no {kind} `{name}`{place}")]
    #[diagnostic(code("mech::name::unknown"))]
    Unknown {
        /// What was looked for: `link`, `point`.
        kind: &'static str,
        /// The name.
        name: String,
        /// Where it was looked for: empty, or ` in link crank`.
        place: String,
        /// Where it stands.
        #[label(primary, "not declared")]
        span: Span,
        /// What may have been meant, or what there is.
        #[help]
        help: Option<String>,
    },
    /// The name is declared, but as something else.
    #[error("`{name}` is {is}, not {wanted}")]
    #[diagnostic(code("mech::name::wrong_kind"))]
    WrongKind {
        /// The name.
        name: String,
        /// What it is, with its article.
        is: String,
        /// What was looked for, with its article.
        wanted: String,
        /// Where it stands.
        #[label(primary, "{wanted} is expected here")]
        span: Span,
        /// Where it is declared.
        #[label("declared here")]
        declared: Option<Span>,
        /// What to write instead.
        #[help]
        help: Option<String>,
    },
    /// Two things of one list have one name.
    #[error("`{name}` is declared twice")]
    #[diagnostic(code("mech::name::duplicate"), help("{help}"))]
    Duplicate {
        /// What to write.
        help: String,
        /// The name.
        name: String,
        /// The second declaration.
        #[label(primary, "declared again here")]
        again: Span,
        /// The first.
        #[label("first declared here")]
        first: Option<Span>,
    },
    /// An expected value in a `find`, of what is declared already.
    #[error("`{name}` is declared already: a `find` only asks for it")]
    #[diagnostic(code("mech::name::duplicate"))]
    ValueInFind {
        /// The name.
        name: String,
        /// The item of the `find`.
        #[label(primary, "asks and states a value at once")]
        span: Span,
        /// The declaration.
        #[label("declared here")]
        declared: Span,
        /// The lines to write.
        #[help]
        help: String,
    },
    /// Two links have one number.
    #[error("two links have the number {number}")]
    #[diagnostic(
        code("mech::name::number"),
        help(
            "a number stands for one link in the symbols of the report, as in R12 and ω2: give one of them another, or none"
        )
    )]
    SameNumber {
        /// The number.
        number: String,
        /// The second.
        #[label(primary, "again here")]
        again: Span,
        /// The first.
        #[label("first here")]
        first: Span,
    },
    /// Two names that only look alike.
    #[error("two different names look like `{name}`")]
    #[diagnostic(code("mech::name::look_alike"), help("{help}"))]
    LookAlike {
        /// The one with letters of another script.
        name: String,
        /// Where it stands.
        #[label(primary, "looks like the other one")]
        span: Span,
        /// Where the other one stands.
        #[label("the other one")]
        first: Span,
        /// What to write, and which letters differ.
        help: String,
    },
    /// A definition that hangs on itself.
    #[error("`{name}` is defined in terms of itself: {chain}")]
    #[diagnostic(code("mech::name::cycle"), help("give one of them a value of its own"))]
    Cycle {
        /// The name.
        name: String,
        /// All names on the way round.
        chain: String,
        /// The definition.
        #[label(primary, "circular definition starts here")]
        span: Span,
        /// The other definitions.
        #[label(collection)]
        others: Vec<LabeledSpan>,
    },
    /// A point name that stands for several points.
    #[error("`{name}` names several points that no pin joins")]
    #[diagnostic(code("mech::name::ambiguous_point"))]
    AmbiguousPoint {
        /// The name.
        name: String,
        /// Where it stands.
        #[label(primary, "which of them?")]
        span: Span,
        /// The points as they can be written.
        #[help]
        help: String,
    },
}

impl NameError {
    /// A second declaration of a name.
    pub fn duplicate(again: &Spanned<String>, first: Span, help: Option<String>) -> Self {
        let help = help.unwrap_or_else(|| "give one of them another name".into());
        let first = (first != Span::default()).then_some(first);
        Self::Duplicate { help, name: again.node.clone(), again: again.span, first }
    }
}
