//! The points that a link has, as far as they can be seen in a text that does not read.

use crate::words::is_name_char;

/// The points in the head and in the braces of a statement that declares a link: those of its bar, and those with coordinates.
pub(super) fn points_in(statement: &str) -> Vec<&str> {
    let (head, body) = statement.split_once('{').unwrap_or(("", statement));
    let named = |text: &&str| !text.is_empty() && text.chars().all(is_name_char);
    let head = if head.is_empty() { statement } else { head };
    let bar = head.split_whitespace().find_map(|word| word.split_once('-'));
    let ends = bar.into_iter().flat_map(|(from, to)| [from, to]);
    let members = body.split([';', '}', '\n']).filter_map(|member| member.trim().split_once('('));
    ends.chain(members.map(|(name, _)| name.trim())).filter(named).collect()
}

/// The points of the link of that name.
pub(super) fn points_of<'a>(text: &'a str, link: &str) -> Vec<&'a str> {
    let declares = |line: &str| {
        let mut words = line.split(|c: char| c == '{' || c.is_whitespace()).filter(|word| !word.is_empty());
        match words.next() {
            Some("ground") => link == "ground",
            Some("link" | "slider" | "shaft") => words.next() == Some(link),
            _ => false,
        }
    };
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if declares(line) {
            let rest = &text[start..];
            let end = if line.contains('{') { rest.find('}') } else { None };
            return points_in(&rest[..end.unwrap_or(line.len())]);
        }
        start += line.len();
    }
    Vec::new()
}
