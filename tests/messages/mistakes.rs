//! A hundred single mistakes of students in examples: what is reported first, what it offers, and that what it offers removes
//! the error. `mistakes/cases.txt` has them with their scores, `mistakes/said.txt` what is said.

use crate::paste::{pasted, words};
use assur::internals::check::Overrides;
use assur::internals::diagnostic::{DiagnosticView, Fix, Problems};
use assur::internals::source::Source;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// A mistake in an example.
struct Mistake {
    kind: String,
    text: String,
    score: u32,
    name: String,
}

fn folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn mistakes() -> Vec<Mistake> {
    let cases = include_str!("mistakes/cases.txt").lines();
    cases.filter(|line| !line.is_empty() && !line.starts_with('#')).map(mistake).collect()
}

fn mistake(line: &str) -> Mistake {
    let parts = line.split(" | ").collect::<Vec<_>>();
    let [kind, example, edit, score] = parts[..] else { panic!("{line}") };
    let (old, new) = edit.split_once(" =>").unwrap_or_else(|| panic!("{line}"));
    let [old, new] = [old, new.strip_prefix(' ').unwrap_or(new)].map(|part| part.replace("\\n", "\n"));
    let path = folder().join(format!("examples/{example}.mech"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{line}: {e}"));
    let text = without_key(&text);
    assert_eq!(text.matches(&old).count(), 1, "{line}: not once in {}", path.display());
    Mistake {
        kind: kind.to_owned(),
        text: text.replacen(&old, &new, 1),
        score: score.parse().unwrap_or_else(|_| panic!("{line}")),
        name: format!("{example} | {edit}"),
    }
}

/// Without the answer key, which belongs to other numbers.
fn without_key(text: &str) -> String {
    let mut is_key = false;
    let kept = text.split_inclusive('\n').filter(|line| {
        is_key = line.starts_with("expect") || is_key && line.starts_with("    ");
        !is_key
    });
    kept.collect()
}

fn solved(text: &str) -> (Source, Problems) {
    let source = Source::new("text.mech", text);
    let problems = assur::internals::solve_source(&source, &Overrides::none()).1;
    (source, problems)
}

/// What is said, notes after errors.
fn said(text: &str) -> Vec<DiagnosticView> {
    let (source, problems) = solved(text);
    let mut found = problems.views(&source);
    found.sort_by_key(|d| d.severity != "error");
    found
}

/// The texts that the fixes of the first diagnostic give, by its edits and by its words.
fn fixed(text: &str, first: &DiagnosticView) -> Vec<String> {
    let (source, problems) = solved(text);
    let is_first = |d: &DiagnosticView| d.code == first.code && d.message == first.message;
    let at = problems.views(&source).iter().position(is_first);
    let fixes: Vec<Fix> = at.and_then(|i| problems.sorted().get(i).map(|p| p.fixes())).unwrap_or_default();
    let mut all = fixes.iter().map(|fix| fix.apply(text)).collect::<Vec<_>>();
    if all.is_empty() {
        let help = first.help.as_deref().unwrap_or_default();
        let is_lines = help.starts_with("write: ") || help.starts_with("write one of");
        all = if is_lines { pasted(text, first) } else { written(text, first) };
    }
    all
}

/// The texts with the words that a help says to write, in place of what is marked and of the words before it that they repeat.
fn written(text: &str, first: &DiagnosticView) -> Vec<String> {
    let (Some(help), Some(at)) = (&first.help, first.spans.first()) else { return Vec::new() };
    let new = words(help).unwrap_or_default().into_iter();
    let start = |new: &str| {
        let line = text[..at.start.byte].rfind('\n').map_or(0, |i| i + 1);
        let word = new.split(' ').next().unwrap_or_default();
        let before = text[line..at.start.byte].rfind(word).map(|i| line + i);
        // a name in the mark begins there
        before.filter(|_| word.len() > 1 && !text[at.start.byte..].starts_with(word)).unwrap_or(at.start.byte)
    };
    let line = text[..at.start.byte].rfind('\n').map_or(0, |i| i + 1);
    let line_end = text[at.end.byte..].find('\n').map_or(text.len(), |i| at.end.byte + i);
    let replaced = |new: &str| {
        let behind = &text[at.end.byte..];
        match behind.find(')') {
            _ if new.contains(": ") => (line, line_end),
            Some(close) if new.ends_with(')') && behind.starts_with('(') => {
                (start(new), at.end.byte + close + 1)
            }
            _ => (start(new), at.end.byte),
        }
    };
    new.map(|new| {
        let (from, to) = replaced(new);
        format!("{}{new}{}", &text[..from], &text[to..])
    })
    .collect()
}

#[test]
fn a_hundred_mistakes() {
    let mut out = String::new();
    let mut wrong = Vec::new();
    for Mistake { text, name, .. } in mistakes() {
        let found = said(&text);
        let Some(first) = found.first() else {
            let _ = writeln!(out, "{name}\n  nothing");
            continue;
        };
        let code = first.code.as_deref().unwrap_or_default();
        let _ = writeln!(out, "{name}\n  {code} ({}): {}", found.len(), first.message);
        for line in first.help.iter().flat_map(|help| help.lines()) {
            let _ = writeln!(out, "    {line}");
        }
        for new in fixed(&text, first) {
            let left = said(&new);
            let same = left.iter().any(|d| d.code == first.code && d.message == first.message);
            if same {
                wrong.push(format!("{name}: {:?}\n{new}\n{left:#?}", first.help));
            }
            let follows = left.first().and_then(|d| d.code.as_deref()).unwrap_or("nothing");
            let _ = writeln!(out, "  fixed: {follows}");
        }
    }
    assert!(wrong.is_empty(), "{} fixes do not fix\n{}", wrong.len(), wrong.join("\n----\n"));
    let kept = folder().join("tests/messages/mistakes/said.txt");
    if std::env::var_os("INSTA_UPDATE").is_some() {
        std::fs::write(&kept, &out).unwrap_or_else(|e| panic!("{e}"));
    }
    let before = std::fs::read_to_string(&kept).unwrap_or_default();
    for (now, before) in out.lines().zip(before.lines()) {
        assert_eq!(now, before);
    }
    assert_eq!(out.lines().count(), before.lines().count());
}

/// What follows from a slip is not reported.
#[test]
fn one_cause_is_one_message() {
    let found = mistakes().into_iter().filter(|m| m.kind == "once").map(|m| {
        let errors = said(&m.text).iter().filter(|d| d.severity == "error").count();
        (m.name, errors)
    });
    let several = found.filter(|(_, errors)| *errors != 1).collect::<Vec<_>>();
    assert!(several.is_empty() && mistakes().iter().any(|m| m.kind == "once"), "{several:#?}");
}

#[test]
fn their_scores() {
    let all = mistakes();
    let mut kinds: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
    all.iter().for_each(|m| kinds.entry(&m.kind).or_default().push(m.score));
    for (kind, scores) in &kinds {
        println!("{kind}: {} mistakes, mean {:.2}", scores.len(), mean(scores));
    }
    let scores = all.iter().map(|m| m.score).collect::<Vec<_>>();
    println!("all: {} mistakes, mean {:.2}", scores.len(), mean(&scores));
    assert!(scores.len() >= 100 && mean(&scores) >= 2.8 && scores.iter().all(|s| (1..=3).contains(s)));
}

fn mean(scores: &[u32]) -> f64 {
    f64::from(scores.iter().sum::<u32>()) / scores.len().max(1) as f64
}
