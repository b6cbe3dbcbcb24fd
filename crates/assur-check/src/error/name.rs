//! Names.

use assur_text::diagnostic::{Fix, Help, Problem, Undeclared};
use assur_text::source::{Span, Spanned};
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

#[derive(Clone, Debug, Error, Diagnostic)]
pub enum NameError {
    /// Nothing of that name is declared.
    #[error("there is no {kind} `{name}`{}", place(owner.as_deref()))]
    #[diagnostic(code("mech::name::unknown"))]
    Unknown {
        /// The kind that is expected: `link`, `point`.
        kind: &'static str,
        name: String,
        owner: Option<String>,
        #[label(primary, "not declared")]
        span: Span,
        /// Similar names, or all that exist.
        #[help]
        help: Option<Help>,
    },
    /// The name is declared, but as something else.
    #[error("`{name}` is {is}, not {wanted}")]
    #[diagnostic(code("mech::name::wrong_kind"))]
    WrongKind {
        name: String,
        /// Its kind, with its article.
        is: String,
        /// The expected kind, with its article.
        wanted: String,
        #[label(primary, "{wanted} is expected here")]
        span: Span,
        #[label("declared here")]
        declared: Option<Span>,
        #[help]
        help: Option<String>,
    },
    /// Two things of one list have one name.
    #[error("`{name}` is declared twice")]
    #[diagnostic(code("mech::name::duplicate"), help("{help}"))]
    Duplicate {
        help: String,
        name: String,
        #[label(primary, "declared again here")]
        again: Span,
        #[label("first declared here")]
        first: Option<Span>,
    },
    /// An expected value in a `find`, of a declared quantity.
    #[error("`{name}` is already declared, and a `find` takes no value")]
    #[diagnostic(code("mech::name::duplicate"))]
    ValueInFind {
        name: String,
        /// The item of the `find`.
        #[label(primary, "a question with a value")]
        span: Span,
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
            "give one of them another number, or none: the symbols of the report, such as R12 and ω2, use it"
        )
    )]
    SameNumber {
        number: String,
        #[label(primary, "again here")]
        again: Span,
        #[label("first here")]
        first: Span,
    },
    /// Two names that look alike.
    #[error("two different names look like `{name}`")]
    #[diagnostic(code("mech::name::look_alike"), help("{help}"))]
    LookAlike {
        /// The one with letters of another script.
        name: String,
        #[label(primary, "looks like the other one")]
        span: Span,
        /// The span of the other one.
        #[label("the other one")]
        first: Span,
        /// What to write, and which letters differ.
        help: String,
    },
    /// A definition that depends on itself.
    #[error("`{name}` is defined in terms of itself: {chain}")]
    #[diagnostic(code("mech::name::cycle"), help("define one of them without the others"))]
    Cycle {
        name: String,
        /// All names of the circle.
        chain: String,
        #[label(primary, "circular definition starts here")]
        span: Span,
        #[label(collection)]
        others: Vec<LabeledSpan>,
    },
    /// A point name that fits several points.
    #[error("several points have the name `{name}`, and no pin joins them")]
    #[diagnostic(code("mech::name::ambiguous_point"))]
    AmbiguousPoint {
        name: String,
        #[label(primary, "the link is missing")]
        span: Span,
        /// The points as they can be written.
        #[help]
        help: String,
    },
}

impl Problem for NameError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::Unknown { help: Some(help), .. } => help.fixes().to_vec(),
            // where a pin may be missing, it is not known which point is meant
            Self::AmbiguousPoint { help, .. } if help.contains("revolute") => Vec::new(),
            Self::AmbiguousPoint { help, span, .. } | Self::WrongKind { help: Some(help), span, .. } => {
                Fix::quoted(help, *span)
            }
            _ => Vec::new(),
        }
    }

    fn undeclared(&self) -> Option<Undeclared<'_>> {
        match self {
            Self::Unknown { kind, name, owner, span, .. } => {
                Some(Undeclared { kind, name, owner: owner.as_deref(), at: *span })
            }
            _ => None,
        }
    }
}

/// Where a name was looked for: nothing, ` on the ground` or `` in link `crank` ``.
fn place(owner: Option<&str>) -> String {
    match owner {
        None => String::new(),
        Some("ground") => " on the ground".to_owned(),
        Some(link) => format!(" in link `{link}`"),
    }
}

impl NameError {
    /// A second declaration of a name.
    pub fn duplicate(again: &Spanned<String>, first: Span, help: Option<String>) -> Self {
        let help = help.unwrap_or_else(|| "give one of them another name".into());
        let first = (first != Span::default()).then_some(first);
        Self::Duplicate { help, name: again.node.clone(), again: again.span, first }
    }
}
