//! What to do about a problem, in words and as changes of the text.

use crate::source::{Edit, Span, edited};
use std::fmt;

/// The most fixes of one help, where choices multiply.
const CHOICES: usize = 16;
/// The letters of a name in which one may be a slip.
const LETTERS: usize = 4;

/// A change of a text after which a problem of it is gone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What it does, as a sentence without its end.
    pub title: String,
    /// The changes, in order.
    pub edits: Vec<Edit>,
    /// Whether nothing else can be meant.
    pub certain: bool,
}

impl Fix {
    /// A text with the fix applied.
    #[must_use]
    pub fn apply(&self, text: &str) -> String {
        edited(text, &self.edits)
    }

    /// What a sentence says to write in a place: each of the words that it quotes and leaves nothing open in.
    #[must_use]
    pub fn quoted(sentence: &str, at: Span) -> Vec<Self> {
        let says =
            ["write ", "ask for ", "name ", "did you mean "].iter().any(|verb| sentence.starts_with(verb));
        let words = sentence.split('`').skip(1).step_by(2).filter(|word| says && !word.contains('…'));
        replacements(at, &words.map(str::to_owned).collect::<Vec<_>>())
    }

    /// What a help says to add: the lines that it sets apart, `one of` which is meant or all together. Of several such parts, joined by
    /// `and`, one line of each.
    #[must_use]
    pub fn added(help: &str) -> Vec<Self> {
        let mut fixes = Vec::new();
        let mut is_choice = false;
        // what was chosen before
        let mut chosen = vec![String::new()];
        for line in help.lines() {
            match line.strip_prefix("  ") {
                None if is_choice && line.starts_with("and one of") => {
                    chosen = std::mem::take(&mut fixes);
                    chosen.retain(|lines| !lines.is_empty());
                }
                None => {
                    is_choice = line.ends_with("one of");
                    chosen = vec![String::new()];
                    fixes.push(String::new());
                }
                Some(added) if is_choice => {
                    fixes.extend(chosen.iter().map(|before| format!("{before}{added}\n")))
                }
                Some(added) => fixes.last_mut().into_iter().for_each(|all| *all += &format!("{added}\n")),
            }
        }
        fixes.retain(|lines| !lines.is_empty());
        fixes.truncate(CHOICES);
        fixes.into_iter().map(|lines| Self::line(lines.trim_end())).collect()
    }

    /// A line behind the text.
    #[must_use]
    pub fn line(line: &str) -> Self {
        let title = format!("add `{}`", line.replace('\n', "` and `"));
        Self { title, edits: vec![Edit::new(Span::END, format!("\n{line}\n"))], certain: false }
    }

    /// Without what is in a place.
    #[must_use]
    pub fn left_out(what: &str, at: Span) -> Self {
        Self { title: format!("leave out {what}"), edits: vec![Edit::new(at, "")], certain: false }
    }
}

/// The help of a diagnostic. Where it has the exact words, it is printed from the fixes that write them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Help {
    text: String,
    fixes: Vec<Fix>,
}

impl Help {
    /// `write: …`: the lines of a place as they are with the edits.
    #[must_use]
    pub fn lines(text: &str, at: Span, edits: Vec<Edit>) -> Self {
        let title = format!("write: {}", lines_with(text, at, &edits));
        Self { text: title.clone(), fixes: vec![Fix { title, edits, certain: false }] }
    }

    /// ``write `…` or `…` ``: what may be in a place.
    #[must_use]
    pub fn write(at: Span, words: &[String]) -> Self {
        let text = format!("write {}", alternatives(words));
        Self { text, fixes: replacements(at, words) }
    }

    /// ``did you mean `…` or `…`?``: names that may be meant by another in a place. One that is alone and differs by a slip is certain.
    #[must_use]
    pub fn did_you_mean(name: &str, at: Span, names: &[String]) -> Self {
        let help =
            Self { text: format!("did you mean {}?", alternatives(names)), fixes: replacements(at, names) };
        if names.iter().all(|meant| is_slip(name, meant)) { help.certain() } else { help }
    }

    /// The same, with nothing else that can be meant if it has one fix alone.
    #[must_use]
    pub fn certain(mut self) -> Self {
        if let [only] = self.fixes.as_mut_slice() {
            only.certain = true;
        }
        self
    }

    /// `write one of …`: several of which one is meant.
    #[must_use]
    pub fn one_of(helps: Vec<Self>) -> Self {
        let line = |help: &Self| format!("\n  {}", help.text.strip_prefix("write: ").unwrap_or(&help.text));
        let lines = helps.iter().map(line).collect::<String>();
        let fixes = helps.into_iter().flat_map(|help| help.fixes).collect();
        Self { text: format!("write one of{lines}"), fixes }
    }

    /// The same fixes in other words.
    #[must_use]
    pub fn in_words(self, text: impl Into<String>) -> Self {
        Self { text: text.into(), ..self }
    }

    /// What can be changed.
    #[must_use]
    pub fn fixes(&self) -> &[Fix] {
        &self.fixes
    }
}

impl fmt::Display for Help {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl From<String> for Help {
    fn from(text: String) -> Self {
        Self { text, fixes: Vec::new() }
    }
}

impl From<&str> for Help {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

/// Whether a name is another one with a slip of the pen: not `B2` for `B1`, and not `rod` for `bar`.
fn is_slip(name: &str, meant: &str) -> bool {
    let digits = |name: &str| name.chars().filter(|c| c.is_numeric()).collect::<String>();
    let letters = |name: &str| name.chars().filter(|c| c.is_alphabetic()).count();
    name.to_lowercase() == meant.to_lowercase()
        || (digits(name) == digits(meant) && letters(meant) >= LETTERS && letters(name) >= LETTERS - 1)
}

fn alternatives(words: &[String]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" or ")
}

fn replacements(at: Span, words: &[String]) -> Vec<Fix> {
    let fix = |word: &String| Fix {
        title: format!("write `{word}`"),
        edits: vec![Edit::new(at, word)],
        certain: false,
    };
    words.iter().map(fix).collect()
}

/// The lines of a place as they are with edits in them, without the blanks around them.
fn lines_with(text: &str, at: Span, edits: &[Edit]) -> String {
    let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
    let bytes = text.as_bytes();
    let from = at.start.min(bytes.len());
    let to = at.end.min(bytes.len());
    let start = bytes[..from].iter().rposition(is_end).map_or(0, |i| i + 1);
    let end = bytes[to..].iter().position(is_end).map_or(bytes.len(), |i| to + i);
    let moved = |edit: &Edit| {
        let by = |at: usize| at.saturating_sub(start);
        Edit::new(Span::new(by(edit.span.start), by(edit.span.end)), &*edit.with)
    };
    let edits = edits.iter().map(moved).collect::<Vec<_>>();
    edited(text.get(start..end).unwrap_or_default(), &edits).trim().to_owned()
}
