//! What is asked for.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// What can be wrong with a question, or with an expression that hangs on results.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum RequestError {
    /// A value that must be known beforehand hangs on results.
    #[error("{what} must be a constant, but it depends on {result}")]
    #[diagnostic(
        code("mech::request::not_constant"),
        help("use numbers, `given` and those `let` that hang on nothing but them")
    )]
    NotConstant {
        /// What it is for.
        what: String,
        /// The result it hangs on.
        result: String,
        /// Where that stands.
        #[label(primary, "known only once the mechanism is solved")]
        span: Span,
    },
    /// A value that must not differ from pose to pose does.
    #[error("{what} cannot depend on computed results")]
    #[diagnostic(
        code("mech::request::needs_pose"),
        help("it says which poses there are: use numbers, `given`, `let`, `dead(…)` and `stroke(…)`")
    )]
    NeedsPose {
        /// What it is for.
        what: String,
        /// Where it stands.
        #[label(primary, "differs from pose to pose")]
        span: Span,
    },
    /// A function with too few or too many arguments.
    #[error("`{function}` takes {takes}, found {found}")]
    #[diagnostic(code("mech::request::arguments"), help("write `{usage}`"))]
    Arguments {
        /// The function.
        function: String,
        /// `one argument`, `one or two arguments`
        takes: &'static str,
        /// How many there are.
        found: usize,
        /// The call.
        #[label(primary, "{found} here")]
        span: Span,
        /// How it is written.
        usage: String,
    },
    /// Links in place of the group that they form.
    #[error("`{function}` takes a group, not the links {links}")]
    #[diagnostic(code("mech::request::arguments"), help("{help}"))]
    LinksForGroup {
        /// The function.
        function: String,
        /// The links, as written.
        links: String,
        /// The call.
        #[label(primary, "a group is expected")]
        span: Span,
        /// The lines to write.
        help: String,
    },
    /// An argument of the wrong kind.
    #[error("`{function}` takes {wanted} here")]
    #[diagnostic(code("mech::request::argument"), help("write `{usage}`"))]
    Argument {
        /// The function.
        function: String,
        /// `a point`, `a link`
        wanted: String,
        /// The argument.
        #[label(primary, "{wanted} is expected")]
        span: Span,
        /// How it is written.
        usage: String,
    },
    /// A force between two links of which nobody said on which it acts.
    #[error("`{function}({pair})` acts on {count} links with opposite signs: on which of them?")]
    #[diagnostic(code("mech::request::which_link"))]
    WhichLink {
        /// The function.
        function: String,
        /// The pair.
        pair: String,
        /// How many links the pair joins.
        count: usize,
        /// The call.
        #[label(primary, "on which link?")]
        span: Span,
        /// The choices.
        #[help]
        help: String,
    },
    /// A link that the pair does not join.
    #[error("`{pair}` does not join `{link}`")]
    #[diagnostic(code("mech::request::link_not_in_pair"), help("{help}"))]
    LinkNotInPair {
        /// The pair.
        pair: String,
        /// The link.
        link: String,
        /// Where it stands.
        #[label(primary, "not a link of `{pair}`")]
        span: Span,
        /// Where the pair is declared.
        #[label("`{pair}` is declared here")]
        declared: Span,
        /// The links it joins.
        help: String,
    },
    /// A result that this kind of pair has not.
    #[error("`{function}` is not defined for `{pair}`, {kind}")]
    #[diagnostic(code("mech::request::not_of_this_pair"))]
    NotOfThisPair {
        /// The function.
        function: String,
        /// The pair.
        pair: String,
        /// What kind it is, with its article.
        kind: String,
        /// The call.
        #[label(primary, "asked here")]
        span: Span,
        /// Where the pair is declared.
        #[label("declared here")]
        declared: Span,
        /// What to ask instead.
        #[help]
        help: Option<String>,
    },
    /// The relative motion in a pin that joins more than two links.
    #[error("`{pair}` joins {count} links: the motion of which two is meant?")]
    #[diagnostic(code("mech::request::which_two"))]
    WhichTwo {
        /// The pair.
        pair: String,
        /// How many links it joins.
        count: usize,
        /// The call.
        #[label(primary, "asked here")]
        span: Span,
        /// An example.
        #[help]
        help: String,
    },
    /// Forces at contact points that are not declared.
    #[error("`{pair}` has no contact points")]
    #[diagnostic(
        code("mech::request::no_contacts"),
        help("give it some, in its braces: `contacts -20 mm, 25 mm`")
    )]
    NoContacts {
        /// The pair.
        pair: String,
        /// The call.
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
        help("give it one, in its braces: `mass 2 kg at S; inertia 0.1 kg*m^2`")
    )]
    NoMass {
        /// The link.
        link: String,
        /// The call.
        #[label(primary, "asked here")]
        span: Span,
        /// Where the link is declared.
        #[label("declared here")]
        declared: Span,
    },
    /// The effort of what nothing drives.
    #[error("nothing drives `{name}`")]
    #[diagnostic(code("mech::request::not_driven"))]
    NotDriven {
        /// What was named.
        name: String,
        /// Where.
        #[label(primary, "no drive of that name")]
        span: Span,
        /// The drives there are.
        #[help]
        help: Option<String>,
    },
    /// The effort of a drive, where other unknown efforts are declared.
    #[error("`{name}` has no effort of its own, since the file declares what is unknown: `{balance}`")]
    #[diagnostic(
        code("mech::request::no_own_effort"),
        help("ask for `{balance}`, or leave out that `balance`")
    )]
    NoOwnEffort {
        /// What is driven.
        name: String,
        /// The first unknown effort.
        balance: String,
        /// The call.
        #[label(primary, "asked here")]
        span: Span,
        /// Where the unknown effort is declared.
        #[label("the unknown effort")]
        declared: Span,
    },
    /// An expression that is too long.
    #[error("this expression has {count} parts in a row; at most {most} can be read")]
    #[diagnostic(code("mech::request::too_long"), help("divide it among several `let`"))]
    TooLong {
        /// How many.
        count: usize,
        /// How many may be.
        most: usize,
        /// The expression.
        #[label(primary, "too long")]
        span: Span,
    },
    /// Values of the drive, where there is not one drive.
    #[error("`{function}` gives values of the drive, and there are {count} drives")]
    #[diagnostic(code("mech::request::which_drive"), help("it is defined for mechanisms with one drive"))]
    WhichDrive {
        /// The function.
        function: String,
        /// How many there are.
        count: usize,
        /// The call.
        #[label(primary, "asked here")]
        span: Span,
    },
    /// A point is named where a value is due.
    #[error("`{path}` is not a quantity")]
    #[diagnostic(code("mech::request::no_value"))]
    NoValue {
        /// As written.
        path: String,
        /// Where.
        #[label(primary, "a value is expected here")]
        span: Span,
        /// What may be asked of it.
        #[help]
        help: Option<String>,
    },
    /// A part that this result has not.
    #[error("this has no part `.{part}`")]
    #[diagnostic(code("mech::request::part"))]
    Part {
        /// The part.
        part: String,
        /// Where it stands.
        #[label(primary, "no such part")]
        span: Span,
        /// The parts there are.
        #[help]
        help: Option<String>,
    },
    /// The same is asked twice.
    #[error("`{name}` is asked for twice")]
    #[diagnostic(
        code("mech::request::asked_twice"),
        severity(Warning),
        help("leave one out, or give it a name of its own: `NAME = {name}`")
    )]
    AskedTwice {
        /// What it is called.
        name: String,
        /// The second place.
        #[label(primary, "again here")]
        again: Span,
        /// The first.
        #[label("first asked here")]
        first: Span,
    },
    /// A row of variants that is longer or shorter than the header.
    #[error("this row has {found}, and the table has {columns}")]
    #[diagnostic(code("mech::request::variant_row"), help("one number per column, separated by commas"))]
    VariantRow {
        /// `1 number`
        found: String,
        /// `2 columns`
        columns: String,
        /// The row.
        #[label(primary, "{found}")]
        span: Span,
        /// The header.
        #[label("{columns}")]
        header: Option<Span>,
    },
    /// A table beside the file without a column that the file's answer key needs.
    #[error("the table has no column `{name}`, and an `expect` of the file takes its value from there")]
    #[diagnostic(
        code("mech::request::key_column"),
        help("add the column, or write `given {name} = …` in the file")
    )]
    KeyColumn {
        /// Its name.
        name: String,
        /// The header.
        #[label("no `{name}` here")]
        span: Span,
    },
    /// A value from outside for what is no `given`.
    #[error("`--set {name}=…`: {why}")]
    #[diagnostic(code("mech::request::set_unknown"))]
    SetUnknown {
        /// The name.
        name: String,
        /// What is wrong with it.
        why: String,
        /// Its declaration, where there is one.
        #[label("declared here")]
        declared: Option<Span>,
        /// What may have been meant.
        #[help]
        help: Option<String>,
    },
    /// A value from outside that cannot be used.
    #[error("`--set {name}={text}`: {why}")]
    #[diagnostic(code("mech::request::set_value"))]
    SetValue {
        /// The name.
        name: String,
        /// The value as written.
        text: String,
        /// What is wrong with it.
        why: String,
        /// Its declaration.
        #[label("the value it would replace")]
        declared: Span,
        /// What to write instead.
        #[help]
        help: Option<String>,
    },
}
