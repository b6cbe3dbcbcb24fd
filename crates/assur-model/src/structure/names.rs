//! Names of links in a message.

use super::error::listed;
use crate::model::{LinkId, Mechanism};

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
