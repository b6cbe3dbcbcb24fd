//! What can be wrong with a structure, said with the count and the pairs it concerns.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

use crate::source::Span;

/// A defect of the structure.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum StructureError {
    /// A link is joined to nothing.
    #[error("link `{name}` is joined to nothing")]
    #[diagnostic(code(mech::determinacy::floating_link))]
    FloatingLink {
        /// Its name.
        name: String,
        /// What to write.
        #[help]
        help: String,
        /// Its place.
        #[label("no pair names this link")]
        span: miette::SourceSpan,
    },
    /// Links joined to each other, but not to the ground.
    #[error("{names} are joined to each other, but not to the ground")]
    #[diagnostic(code(mech::determinacy::not_grounded))]
    NotGrounded {
        /// Their names.
        names: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A link driven at a point is joined elsewhere too.
    #[error(
        "`{drive}` moves only one point of its link, but pair `{pair}` joins the link elsewhere: its rotation is not known"
    )]
    #[diagnostic(
        code(mech::determinacy::outer_link),
        help(
            "a link driven at a point stands for the rest of a machine: join it at that point only, or join it to the ground and drive its angle"
        )
    )]
    OuterLink {
        /// The drive.
        drive: String,
        /// The pair.
        pair: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Something would turn a roller that nothing holds.
    #[error("`{name}` turns freely in `{pair}`: nothing balances {what}")]
    #[diagnostic(
        code(mech::determinacy::free_roller),
        help(
            "its rotation is a passive freedom and is not solved; leave that out, or give the circle to the link that carries `{name}`, and it slides instead of rolling"
        )
    )]
    FreeRoller {
        /// The roller.
        name: String,
        /// The pair on which it turns.
        pair: String,
        /// What would turn it.
        what: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// More mobility than drives.
    #[error("the mechanism is underconstrained: mobility F = {formula}, {drives}")]
    #[diagnostic(code(mech::determinacy::underconstrained))]
    Underconstrained {
        /// The count in figures.
        formula: String,
        /// `but no drive is declared`, `but 1 drive is declared`.
        drives: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Fewer freedoms than conditions.
    #[error("the mechanism is overconstrained: mobility F = {formula}, {drives}")]
    #[diagnostic(code(mech::determinacy::overconstrained))]
    Overconstrained {
        /// The count in figures.
        formula: String,
        /// `but 2 drives are declared`.
        drives: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Links that no drive moves.
    #[error("{names} {moves} not move, whatever the drives do")]
    #[diagnostic(
        code(mech::determinacy::immobile),
        severity(warning),
        help(
            "{pairs} hold them to the ground: check which links these pairs join; if the links are meant to stand still, make them part of the ground"
        )
    )]
    Immobile {
        /// Their names.
        names: String,
        /// `does` or `do`.
        moves: &'static str,
        /// The pairs that hold them.
        pairs: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A link or guide that only repeats what others of its kind do.
    #[error("{what} repeats what {others} already: {how}")]
    #[diagnostic(code(mech::determinacy::repeated))]
    Repeated {
        /// The link or pair.
        what: String,
        /// The others with their verb.
        others: String,
        /// What makes it so.
        how: &'static str,
        /// The count and what to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// One part has too many conditions and another too few.
    #[error("one part is overconstrained while another can still move: mobility F = {formula}, {drives}")]
    #[diagnostic(code(mech::determinacy::unbalanced))]
    Unbalanced {
        /// The count in figures.
        formula: String,
        /// `and 2 drives are declared`.
        drives: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Laws of wheels within closed chains of links.
    #[error(
        "wheels that move a closed chain of links together with the links ({links}) cannot be solved yet"
    )]
    #[diagnostic(code(mech::request::not_supported_yet), help("{help}"))]
    MixedTrain {
        /// The links of the group.
        links: String,
        /// What to do.
        help: &'static str,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The number or the place of unknown efforts does not fit.
    #[error("the forces are not determined: {why}")]
    #[diagnostic(code(mech::determinacy::efforts))]
    Efforts {
        /// What does not fit, with the count in figures.
        why: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The asserted group does not count.
    #[error("`{name}` is no structural group: {formula}, not 0")]
    #[diagnostic(code(mech::determinacy::not_a_group))]
    NotAGroup {
        /// Its name.
        name: String,
        /// The count in figures.
        formula: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The asserted links are not one of the groups found, nor made of several.
    #[error("`{name}` counts as a group, but its links are not solved by themselves")]
    #[diagnostic(code(mech::determinacy::part_of_larger))]
    PartOfLarger {
        /// Its name.
        name: String,
        /// The groups found that hold its links.
        #[help]
        help: String,
        /// Place.
        #[label("asserted here")]
        span: miette::SourceSpan,
    },
    /// The asserted group is made of smaller ones.
    #[error("`{name}` counts as a group, but is made of smaller ones")]
    #[diagnostic(code(mech::determinacy::contains_smaller), severity(warning))]
    ContainsSmaller {
        /// Its name.
        name: String,
        /// The groups found.
        #[help]
        help: String,
        /// Place.
        #[label("asserted here")]
        span: miette::SourceSpan,
    },
}

pub(super) fn label(text: impl Into<String>, span: Span) -> LabeledSpan {
    LabeledSpan::new_with_span(Some(text.into()), span)
}

/// `1 freedom`, `2 freedoms`.
pub(super) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// `a`, `a and b`, `a, b and c`.
pub(super) fn listed(items: &[String], and: &str) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} {and} {last}", first.join(", ")),
    }
}

/// Lines to paste below a sentence.
pub(super) fn with_lines(sentence: &str, lines: &[String]) -> String {
    let lines: String = lines.iter().map(|l| format!("\n  {l}")).collect();
    format!("{sentence}{lines}")
}

/// A whole number with the minus sign of text.
pub(super) fn whole(x: i64) -> String {
    if x < 0 { format!("−{}", x.unsigned_abs()) } else { x.to_string() }
}
