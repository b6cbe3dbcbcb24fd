//! Texts that are formatted, and what must be the same before and after.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur_format::edits;
use assur_syntax::{Token, TokenKind, parse_with_tokens};
use assur_text::source::{Source, edited};
use std::path::{Path, PathBuf};

/// A text in the one style.
pub fn formatted(text: &str) -> String {
    let edits =
        edits(&Source::new("text.mech", text)).unwrap_or_else(|problems| panic!("{problems:?}\n{text}"));
    edited(text, &edits)
}

/// Whether a text has no error of reading.
pub fn reads(text: &str) -> bool {
    !parse_with_tokens(&Source::new("text.mech", text)).2.has_errors()
}

/// Examples, files to start from, blocks of the pages, and wrong files that read, with their names.
pub fn all() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = Vec::new();
    for folder in ["examples", "src/cli/start", "tests/errors"] {
        for path in files(&root.join(folder), "mech") {
            if let Ok(text) = std::fs::read_to_string(&path) {
                found.push((path.display().to_string(), text));
            }
        }
    }
    for path in files(&root.join("docs"), "md") {
        let page = std::fs::read_to_string(&path).unwrap();
        let blocks = page.split("```mech").skip(1).filter_map(|b| b.split_once('\n')?.1.split("```").next());
        found.extend(blocks.map(|block| (path.display().to_string(), block.to_owned())));
    }
    found.retain(|(_, text)| reads(text));
    found
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(folder) = open.pop() {
        for path in std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == ending) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// Checks that formatting a text that reads changes nothing but blanks, and nothing when it is done again.
pub fn check(name: &str, text: &str) {
    let after = formatted(text);
    assert_eq!(words(text), words(&after), "{name}: the same tokens\n{text}\n---\n{after}");
    assert_eq!(tree(text), tree(&after), "{name}: the same tree\n{text}\n---\n{after}");
    assert_eq!(formatted(&after), after, "{name}: again\n{text}");
    assert!(after.ends_with('\n') && !after.ends_with("\n\n"), "{name}: one newline at the end");
    let blanks = after.lines().find(|line| line.ends_with([' ', '\t', '\r']));
    assert!(blanks.is_none() || after.contains("\r\n"), "{name}: blanks at the end of `{blanks:?}`");
}

/// The tokens as written, in order, without line ends and semicolons; comments without the blanks at their slashes.
fn words(text: &str) -> Vec<String> {
    let (_, tokens, _) = parse_with_tokens(&Source::new("text.mech", text));
    let counts = |t: &&Token| !matches!(t.kind, TokenKind::Newline | TokenKind::Semicolon);
    let word = |t: &Token| match t.text(text).strip_prefix("//") {
        Some(words) => format!("// {}", words.trim_start()),
        None => format!("{:?} {}", t.kind, t.text(text)),
    };
    tokens.iter().filter(counts).map(word).collect()
}

/// The statements and the problem's text, without places.
fn tree(text: &str) -> String {
    let (document, _, _) = parse_with_tokens(&Source::new("text.mech", text));
    let written = format!("{:?} {:?}", document.statements, document.notes);
    let mut parts = written.split("Span { start: ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |out, part| out + part.split_once('}').map_or(part, |(_, rest)| rest))
}
