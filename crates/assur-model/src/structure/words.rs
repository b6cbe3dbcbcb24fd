//! Words and labels of what is wrong with a structure.

use crate::model::{LinkId, Mechanism};
use crate::source::Span;
use assur_text::diagnostic::Fix;
use assur_text::source::Edit;
use miette::LabeledSpan;

/// The groups that a help lists, in place of one that is wrong.
pub(super) fn groups(help: &str, at: Span) -> Vec<Fix> {
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
