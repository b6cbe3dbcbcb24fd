//! Errors of the structure, with the count and the pairs concerned.

use crate::model::{LinkId, Mechanism};
use crate::source::Span;
use assur_text::diagnostic::{Fix, Problem};
use assur_text::source::Edit;
use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

/// A defect of the structure.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum StructureError {
    /// A link is not joined to any other.
    #[error("link `{name}` is not joined to any other link")]
    #[diagnostic(code(mech::determinacy::floating_link))]
    FloatingLink {
        name: String,
        #[help]
        help: String,
        #[label("no pair names this link")]
        span: miette::SourceSpan,
    },
    /// Links joined to each other, but not to the ground.
    #[error("{names} are joined to each other, but not to the ground")]
    #[diagnostic(code(mech::determinacy::not_grounded))]
    NotGrounded {
        names: String,
        #[help]
        help: String,
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
            "join it at this point only, or join it to the ground and drive its angle: a link driven at a point must not be joined elsewhere"
        )
    )]
    OuterLink {
        drive: String,
        pair: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Something would turn a free roller.
    #[error("`{name}` turns freely in `{pair}`: nothing balances {what}")]
    #[diagnostic(
        code(mech::determinacy::free_roller),
        help(
            "leave that out, or give the circle to the link that carries `{name}`, so that it slides instead of rolling: the rotation of a free roller is not solved"
        )
    )]
    FreeRoller {
        name: String,
        /// The pair on which it turns.
        pair: String,
        /// The loads that would turn it.
        what: String,
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
        #[help]
        help: String,
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
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Links that no drive moves.
    #[error("{names} {moves} not move, whatever the drives do")]
    #[diagnostic(
        code(mech::determinacy::immobile),
        severity(warning),
        help(
            "check which links {pairs} join, because they hold them to the ground; if the links should not move, make them part of the ground"
        )
    )]
    Immobile {
        names: String,
        /// `does` or `do`.
        moves: &'static str,
        /// The pairs that hold them.
        pairs: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// A link or guide that only repeats others of its kind.
    #[error("{what} {} what {others} already: {how}", if what.contains("` and `") { "repeat" } else { "repeats" })]
    #[diagnostic(code(mech::determinacy::repeated))]
    Repeated {
        /// The link or pair.
        what: String,
        /// The others with their verb.
        others: String,
        how: &'static str,
        /// The count and what to write.
        #[help]
        help: String,
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
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The number or the place of unknown efforts does not fit.
    #[error("the forces are not determined: {why}")]
    #[diagnostic(code(mech::determinacy::efforts))]
    Efforts {
        /// The reason, with the count in figures.
        why: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The asserted group does not satisfy the count.
    #[error("`{name}` is not a structural group: {formula}, not 0")]
    #[diagnostic(code(mech::determinacy::not_a_group))]
    NotAGroup {
        name: String,
        /// The count in figures.
        formula: String,
        #[help]
        help: String,
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The asserted links are not one of the groups found, nor made of several.
    #[error("`{name}` satisfies the count of a group, but its links cannot be solved by themselves")]
    #[diagnostic(code(mech::determinacy::part_of_larger))]
    PartOfLarger {
        name: String,
        /// The groups found that hold its links.
        #[help]
        help: String,
        #[label("asserted here")]
        span: miette::SourceSpan,
    },
    /// The asserted group is made of smaller ones.
    #[error("`{name}` satisfies the count of a group, but consists of smaller groups")]
    #[diagnostic(code(mech::determinacy::contains_smaller), severity(warning))]
    ContainsSmaller {
        name: String,
        #[help]
        help: String,
        #[label("asserted here")]
        span: miette::SourceSpan,
    },
}

impl Problem for StructureError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            // where something is to be left out too, a line alone does not help
            Self::Efforts { help, .. } if help.contains("leave out") => Vec::new(),
            Self::Underconstrained { help, .. }
            | Self::Efforts { help, .. }
            | Self::FloatingLink { help, .. } => Fix::added(help),
            Self::PartOfLarger { help, span, .. } | Self::ContainsSmaller { help, span, .. } => {
                groups(help, Span::new(span.offset(), span.offset() + span.len()))
            }
            Self::NotAGroup { help, labels, .. } => {
                let all = labels.first().map(|l| groups(help, Span::new(l.offset(), l.offset() + l.len())));
                all.unwrap_or_default()
            }
            _ => Vec::new(),
        }
    }
}

/// The groups that a help lists, in place of one that is wrong.
fn groups(help: &str, at: Span) -> Vec<Fix> {
    let lines = help.lines().filter_map(|line| line.strip_prefix("  ")).collect::<Vec<_>>();
    let (title, all) = (format!("write `{}`", lines.join("` and `")), lines.join("\n"));
    let fix = || Fix { title, edits: vec![Edit::new(at, all)], certain: false };
    (!lines.is_empty()).then(fix).into_iter().collect()
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

// Names of links in a message.

/// More labels than this tell nothing.
pub(super) const MOST_LABELS: usize = 12;
/// More names than this are counted.
const MOST_NAMES: usize = 6;

/// `` `a`, `b` and `c` ``, the last ones counted where there are many.
pub(super) fn names(mechanism: &Mechanism, links: impl Iterator<Item = LinkId>) -> String {
    let mut names: Vec<String> = links.map(|l| format!("`{}`", mechanism.link(l).name)).collect();
    let more = names.len().saturating_sub(MOST_NAMES);
    if more > 1 {
        names.truncate(MOST_NAMES);
        names.push(format!("{more} more"));
    }
    listed(&names, "and")
}
