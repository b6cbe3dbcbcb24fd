//! Pairs without a name: `revolute ground - crank`.

use super::case::Case;
use super::phrase::What;
use crate::recover::lacking;
use crate::words::is_name_char;
use assur_text::diagnostic::Diagnosis;
use assur_text::language::JointKind;

/// What people write between two links.
const BETWEEN: &[&str] = &[" - ", "-", " and ", " to ", ", ", " with ", " / "];

/// A pair as it is written without a name.
struct Pair<'a> {
    kind: &'a str,
    first: &'a str,
    second: &'a str,
    /// The point behind `at`.
    place: Option<&'a str>,
}

impl<'a> Pair<'a> {
    fn of(statement: &'a str) -> Option<Self> {
        let (kind, rest) = statement.trim().split_once(' ')?;
        if statement.contains(':') || JointKind::named(kind).is_none() {
            return None;
        }
        let (links, place) = match rest.split_once(" at ") {
            Some((links, place)) => (links, Some(place.trim())),
            None => (rest, None),
        };
        let (first, second) = BETWEEN.iter().find_map(|sign| links.split_once(sign))?;
        Some(Self { kind, first: first.trim(), second: second.trim(), place })
    }

    /// The point that it is at: the one that is named, or the only one that both links have.
    fn point(&self, text: &'a str) -> Option<&'a str> {
        if self.place.is_some() {
            return self.place;
        }
        let name = |link: &'a str| link.split(|c| !is_name_char(c)).next().unwrap_or_default();
        let second = points_of(text, name(self.second));
        let mut common = points_of(text, name(self.first)).into_iter().filter(|point| second.contains(point));
        let only = common.next()?;
        common.next().is_none().then_some(only)
    }
}

pub(super) fn explain(case: &Case<'_>) -> Option<Diagnosis> {
    let pair = Pair::of(case.slice).filter(|_| case.what == What::Statement)?;
    let name = pair.point(case.text).map_or_else(|| unused(case), str::to_owned);
    let line = format!("{} {name}: {} - {}", pair.kind, pair.first, pair.second);
    let at = case.slice.len() - case.slice.get(pair.kind.len()..)?.trim_start().len();
    case.reads(&line).then(|| {
        lacking(
            &format!("{name}:"),
            case.span(at, case.token(at).len()),
            case.help(0, case.slice.len(), &line),
        )
    })
}

/// A letter that the text has no name of, and that no pair above needs.
fn unused(case: &Case<'_>) -> String {
    let is_word = |name: &String| case.text.split(|c| !is_name_char(c)).any(|word| word == name);
    let mut letters = ('A'..='Z').map(String::from).filter(|name| !is_word(name));
    let above = case.text.get(..case.offset).unwrap_or_default().lines().filter_map(Pair::of);
    let needed = above.filter(|pair| pair.point(case.text).is_none()).count();
    letters.nth(needed).unwrap_or_else(|| "J".to_owned())
}

// The points that a link has, as far as they can be seen in a text that does not read.

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
