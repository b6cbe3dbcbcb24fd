//! Errors of questions.

use assur_text::diagnostic::{Fix, Problem};
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of questions, and of expressions that depend on results.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum RequestError {
    /// A value that must be known beforehand depends on results.
    #[error("{what} must be a constant, but it depends on {result}")]
    #[diagnostic(
        code("mech::request::not_constant"),
        help("use numbers, `given` and those `let` that depend only on them")
    )]
    NotConstant {
        what: String,
        /// The result it depends on.
        result: String,
        /// The span of the result.
        #[label(primary, "known only once the mechanism is solved")]
        span: Span,
    },
    /// A value that must not differ from pose to pose does.
    #[error("{what} cannot depend on computed results")]
    #[diagnostic(
        code("mech::request::needs_pose"),
        help("use numbers, `given`, `let`, `dead(…)` and `stroke(…)`: this value determines the poses")
    )]
    NeedsPose {
        what: String,
        #[label(primary, "differs from pose to pose")]
        span: Span,
    },
    /// A function with too few or too many arguments.
    #[error("`{function}` takes {takes}, found {found}")]
    #[diagnostic(code("mech::request::arguments"), help("write `{usage}`"))]
    Arguments {
        function: String,
        /// `one argument`, `one or two arguments`
        takes: &'static str,
        found: usize,
        #[label(primary, "{found} given")]
        span: Span,
        /// How it is written.
        usage: String,
    },
    /// Links in place of the group that they form.
    #[error("`{function}` takes a group, not the links {links}")]
    #[diagnostic(code("mech::request::arguments"), help("{help}"))]
    LinksForGroup {
        function: String,
        /// The links, as written.
        links: String,
        #[label(primary, "a group is expected")]
        span: Span,
        /// The lines to write.
        help: String,
    },
    /// An argument of the wrong kind.
    #[error("`{function}` takes {wanted} here")]
    #[diagnostic(code("mech::request::argument"), help("write `{usage}`"))]
    Argument {
        function: String,
        /// `a point`, `a link`
        wanted: String,
        #[label(primary, "{wanted} is expected")]
        span: Span,
        /// How it is written.
        usage: String,
    },
    /// A force between two links without the link on which it acts.
    #[error("`{function}({pair})` acts on {count} links with opposite signs, and no link is named")]
    #[diagnostic(code("mech::request::which_link"))]
    WhichLink {
        function: String,
        pair: String,
        /// How many links the pair joins.
        count: usize,
        #[label(primary, "the link is missing")]
        span: Span,
        #[help]
        help: String,
    },
    /// A link that the pair does not join.
    #[error("`{pair}` does not join `{link}`")]
    #[diagnostic(code("mech::request::link_not_in_pair"), help("{help}"))]
    LinkNotInPair {
        pair: String,
        link: String,
        #[label(primary, "not a link of `{pair}`")]
        span: Span,
        /// Where the pair is declared.
        #[label("`{pair}` is declared here")]
        declared: Span,
        /// The links it joins.
        help: String,
    },
    /// A result that this kind of pair does not have.
    #[error("`{function}` is not defined for `{pair}`, {kind}")]
    #[diagnostic(code("mech::request::not_of_this_pair"))]
    NotOfThisPair {
        function: String,
        pair: String,
        /// Its kind, with its article.
        kind: String,
        #[label(primary, "asked here")]
        span: Span,
        /// Where the pair is declared.
        #[label("declared here")]
        declared: Span,
        #[help]
        help: Option<String>,
    },
    /// The relative motion in a pin that joins more than two links.
    #[error("`{pair}` joins {count} links and has no single relative motion")]
    #[diagnostic(code("mech::request::which_two"))]
    WhichTwo {
        pair: String,
        /// How many links it joins.
        count: usize,
        #[label(primary, "asked here")]
        span: Span,
        #[help]
        help: String,
    },
    /// Forces at contact points that are not declared.
    #[error("`{pair}` has no contact points")]
    #[diagnostic(
        code("mech::request::no_contacts"),
        help("add them in its braces: `contacts -20 mm, 25 mm`")
    )]
    NoContacts {
        pair: String,
        #[label(primary, "asked here")]
        span: Span,
        /// Where the pair is declared.
        #[label("declared here, without `contacts`")]
        declared: Span,
    },
    /// Inertia of a link without mass.
    #[error("`{link}` has no mass")]
    #[diagnostic(
        code("mech::request::no_mass"),
        help("add a mass in its braces: `mass 2 kg at S; inertia 0.1 kg*m^2`")
    )]
    NoMass {
        link: String,
        #[label(primary, "asked here")]
        span: Span,
        /// Where the link is declared.
        #[label("declared here")]
        declared: Span,
    },
    /// The effort of a link or pair that is not driven.
    #[error("nothing drives `{name}`")]
    #[diagnostic(code("mech::request::not_driven"))]
    NotDriven {
        name: String,
        #[label(primary, "no drive of that name")]
        span: Span,
        #[help]
        help: Option<String>,
    },
    /// The effort of a drive, where other unknown efforts are declared.
    #[error("`{name}` has no effort of its own, because the file declares the unknown effort `{balance}`")]
    #[diagnostic(
        code("mech::request::no_own_effort"),
        help("ask for `{balance}`, or leave out this `balance`")
    )]
    NoOwnEffort {
        /// The driven link, pair or point.
        name: String,
        /// The first unknown effort.
        balance: String,
        #[label(primary, "asked here")]
        span: Span,
        /// Where the unknown effort is declared.
        #[label("the unknown effort")]
        declared: Span,
    },
    /// An expression that is too long.
    #[error("this expression has {count} parts in a row; at most {most} can be read")]
    #[diagnostic(code("mech::request::too_long"), help("divide it among several `let` statements"))]
    TooLong {
        count: usize,
        /// How many may be.
        most: usize,
        #[label(primary, "too long")]
        span: Span,
    },
    /// Values of the drive, if there is not exactly one drive.
    #[error("`{function}` needs exactly one drive, but there are {count}")]
    #[diagnostic(code("mech::request::which_drive"), help("use it in a mechanism with one drive"))]
    WhichDrive {
        function: String,
        /// How many there are.
        count: usize,
        #[label(primary, "asked here")]
        span: Span,
    },
    /// A point is named where a value is expected.
    #[error("`{path}` is not a quantity")]
    #[diagnostic(code("mech::request::no_value"))]
    NoValue {
        path: String,
        #[label(primary, "a value is expected here")]
        span: Span,
        /// Quantities that it has.
        #[help]
        help: Option<String>,
    },
    /// A part that this result does not have.
    #[error("there is no part `.{part}` here")]
    #[diagnostic(code("mech::request::part"))]
    Part {
        part: String,
        #[label(primary, "no such part")]
        span: Span,
        #[help]
        help: Option<String>,
    },
    /// The same quantity is asked for twice.
    #[error("`{name}` is asked for twice")]
    #[diagnostic(
        code("mech::request::asked_twice"),
        severity(Warning),
        help("leave one of them out, or give it another name: `NAME = {name}`")
    )]
    AskedTwice {
        name: String,
        #[label(primary, "again here")]
        again: Span,
        #[label("first asked here")]
        first: Span,
    },
    /// A row of variants that is longer or shorter than the header.
    #[error("this row has {found}, but the table has {columns}")]
    #[diagnostic(
        code("mech::request::variant_row"),
        help("write one number per column, separated by commas")
    )]
    VariantRow {
        /// `1 number`
        found: String,
        /// `2 columns`
        columns: String,
        #[label(primary, "{found}")]
        span: Span,
        #[label("{columns}")]
        header: Option<Span>,
    },
    /// The name of a row in a column of numbers.
    #[error("`{name}` is not a number")]
    #[diagnostic(
        code("mech::request::variant_row"),
        help("{}", if *has_column {
            "write a number here; the name of a row belongs in the column `variant`"
        } else {
            "write a number; to name the rows, add a column: `variant, …` in the header"
        })
    )]
    RowName {
        name: String,
        /// The table has a column `variant`.
        has_column: bool,
        #[label(primary, "not a number")]
        span: Span,
        #[label("the columns")]
        header: Option<Span>,
    },
    /// A separate table without a column that the file's answer key needs.
    #[error("the table has no column `{name}`, which an `expect` of the file needs")]
    #[diagnostic(
        code("mech::request::key_column"),
        help("add the column, or write `given {name} = …` in the file")
    )]
    KeyColumn {
        name: String,
        #[label("no `{name}` here")]
        span: Span,
    },
    /// A value of `--set` for a name that is not a `given`.
    #[error("`--set {name}=…`: {why}")]
    #[diagnostic(code("mech::request::set_unknown"))]
    SetUnknown {
        name: String,
        why: String,
        /// Its declaration, if there is one.
        #[label("declared here")]
        declared: Option<Span>,
        #[help]
        help: Option<String>,
    },
    /// A value of `--set` that cannot be used.
    #[error("`--set {name}={text}`: {why}")]
    #[diagnostic(code("mech::request::set_value"))]
    SetValue {
        name: String,
        /// The value as written.
        text: String,
        why: String,
        #[label("the value it would replace")]
        declared: Span,
        #[help]
        help: Option<String>,
    },
}

impl Problem for RequestError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::NotDriven { help: Some(help), span, .. } | Self::NoValue { help: Some(help), span, .. } => {
                Fix::quoted(help, *span)
            }
            // the third has no sign
            Self::WhichLink { help, span, .. } => Fix::quoted(help, *span).into_iter().take(2).collect(),
            Self::WhichTwo { help, span, .. } => {
                Fix::quoted(help.replace(" with links:", "").as_str(), *span)
            }
            _ => Vec::new(),
        }
    }
}
