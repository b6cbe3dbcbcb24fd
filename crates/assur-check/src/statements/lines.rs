//! Ends, braces and joints as they would be written, for lines that a message proposes.

use crate::statements::written::written;
use assur_syntax::document::{End, Joint, Path, Property};

/// `write …` with each of some lines.
pub fn write_one(lines: &[String]) -> Option<String> {
    let quoted = lines.iter().map(|l| format!("`{l}`")).collect::<Vec<_>>();
    (!lines.is_empty()).then(|| format!("write {}", quoted.join(" or ")))
}

/// Properties in braces as they would be written, after some more; nothing where there are none.
pub fn braces(properties: &[Property], more: &[&str]) -> String {
    let one = |p: &Property| {
        let values = p.values.iter().map(written).collect::<Option<Vec<_>>>()?.join(", ");
        let blank = if values.is_empty() { "" } else { " " };
        p.properties.is_empty().then(|| format!("{}{blank}{values}", p.name.node))
    };
    let own = properties.iter().map(|p| one(p).unwrap_or_else(|| "…".into()));
    let all = more.iter().map(|m| (*m).to_owned()).chain(own).collect::<Vec<_>>();
    if all.is_empty() { String::new() } else { format!(" {{ {} }}", all.join("; ")) }
}

/// An end as written.
pub fn end_text(end: &End) -> String {
    match end {
        End::At(path) => text(path),
        End::Over(name) => format!("over({})", name.node),
        End::Under(name) => format!("under({})", name.node),
    }
}

/// The line of a joint, each end as `end` writes it.
pub fn line_of(joint: &Joint, end: impl Fn(&End) -> String) -> String {
    let ends = joint.ends.iter().map(end).collect::<Vec<_>>().join(" - ");
    format!("{} {}: {ends}{}", joint.kind.node.word(), joint.name.node, braces(&joint.properties, &[]))
}

/// A path as the author writes it.
pub fn text(path: &Path) -> String {
    match &path.tail {
        Some(tail) => format!("{}.{}", path.head.node, tail.node),
        None => path.head.node.clone(),
    }
}
