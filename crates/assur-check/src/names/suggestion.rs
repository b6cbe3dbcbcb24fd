//! What may be meant by a name that nothing has.

use crate::names::lookalikes::difference;
use assur_syntax::skeleton;
use assur_text::diagnostic::did_you_mean;

/// Among more names than these none is looked for: every error would go through all.
const MOST_NAMES: usize = 2000;

/// `did you mean …?`, or else what there is.
pub fn suggestion(name: &str, all: &[&str], kind: &str) -> Option<String> {
    let quoted = |names: &[&str]| names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>();
    if all.len() > MOST_NAMES {
        return Some(format!("the {kind} are {}, …", quoted(&all[..8]).join(", ")));
    }
    // names of ASCII look like themselves alone
    let lookalike =
        |n: &&&str| **n != name && !(n.is_ascii() && name.is_ascii()) && skeleton(n) == skeleton(name);
    if let Some(lookalike) = all.iter().find(lookalike) {
        let how = difference(lookalike, name, "there", "here");
        return Some(format!("`{lookalike}` is declared; it only looks the same: {how}"));
    }
    let near = did_you_mean(name, all.iter().copied());
    if !near.is_empty() {
        return Some(format!("did you mean {}?", quoted(&near).join(" or ")));
    }
    match all.len() {
        0 => None,
        1..=8 => Some(format!("the {kind} are {}", quoted(all).join(", "))),
        _ => Some(format!("the {kind} are {}, …", quoted(&all[..8]).join(", "))),
    }
}
