//! What a help offers to paste, and the text with it.

use crate::case::errors;
use assur::internals::check::Overrides;
use assur::internals::diagnostic::DiagnosticView;
use assur::internals::source::Source;

/// The errors of a text.
pub fn checked(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    errors(&assur::internals::check_source(&source, &Overrides::none()).1, &source)
}

/// The errors of reading a text.
pub fn read(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    errors(&assur::internals::syntax::parse(&source).1, &source)
}

/// The texts that a help offers to paste: lines behind `write:` or `write one of`, which replace the line of the mistake,
/// and words in backticks behind `write`, which replace what is marked.
pub fn pasted(text: &str, problem: &DiagnosticView) -> Vec<String> {
    let (Some(help), Some(at)) = (&problem.help, problem.spans.first()) else { return Vec::new() };
    let line_start = text[..at.start.byte].rfind('\n').map_or(0, |i| i + 1);
    let with_lines = |new: &str| {
        let count = new.lines().count().max(1);
        let end =
            text[line_start..].match_indices('\n').nth(count - 1).map_or(text.len(), |(i, _)| line_start + i);
        format!("{}{new}{}", &text[..line_start], &text[end..])
    };
    if let Some(lines) = help.strip_prefix("write: ") {
        return vec![with_lines(lines.split("\nand so for ").next().unwrap_or(lines))];
    }
    if let Some(lines) = help.strip_prefix("write one of\n") {
        return lines.lines().map(|line| with_lines(line.trim())).collect();
    }
    let words = words(help).unwrap_or_default();
    let replaced = |new: &&str| {
        let name = new.split(" = ").next().unwrap_or_default();
        let defined = new.contains(" = ").then(|| text[line_start..].find(name)).flatten();
        let start = defined.map_or(at.start.byte, |i| line_start + i);
        format!("{}{new}{}", &text[..start], &text[at.end.byte..])
    };
    words.iter().map(replaced).collect()
}

/// `` write `a` or `b` ``, up to the end or a colon
pub fn words(help: &str) -> Option<Vec<&str>> {
    let mut rest = help.strip_prefix("write ")?;
    let mut words = Vec::new();
    loop {
        let (word, behind) = rest.strip_prefix('`')?.split_once('`')?;
        words.push(word);
        match behind.strip_prefix(" or ") {
            Some(more) => rest = more,
            None if behind.is_empty() || behind.starts_with(": ") => return Some(words),
            None => return None,
        }
    }
}

/// How many errors remain where a fix lays open what it hid: a name used again, a point that is missing.
fn revealed(name: &str) -> usize {
    usize::from(["let_at", "f3"].contains(&name))
}

/// Pastes every fix alone. Says how many there were.
pub fn paste(
    text: &str,
    found: &[DiagnosticView],
    look: impl Fn(&str) -> Vec<DiagnosticView>,
    name: &str,
) -> usize {
    let mut count = 0;
    for problem in found {
        for new in pasted(text, problem) {
            let left = look(&new);
            let most = found.len() - 1 + revealed(name);
            assert!(left.len() <= most, "{name}: {:?}\n{new}\n{left:#?}", problem.help);
            count += 1;
        }
    }
    count
}
