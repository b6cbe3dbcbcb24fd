//! Every name of every example gets another one, one after the other: the answers stay, and their names change.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::folder::files;
use crate::share::spread;
use assur::internals::check::Overrides;
use assur::internals::editor::Analysis;
use assur::internals::report::{PrintedDigits, json};
use assur::internals::source::{Source, edited};
use std::path::Path;

fn look(text: &str) -> Analysis {
    Analysis::of(Source::new("a.mech", text))
}

/// All numbers of the answers, in order, and how many problems there are.
fn numbers(text: &str) -> (Vec<String>, usize) {
    let source = Source::new("a.mech", text);
    let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
    let printed = solved.map_or_else(String::new, |solved| {
        let answers = solved.answers(PrintedDigits::READABLE);
        json::render("a.mech", Some(&answers.model), Some(&answers), &[])
    });
    // every second part is in quotes; no answer has a quote within its quotes
    let outside = printed.split('"').step_by(2);
    let is_digit = |c: char| c.is_ascii_digit() || "+-.e".contains(c);
    let found = outside.flat_map(|part| part.split(|c| !is_digit(c))).filter(|n| !n.is_empty());
    (found.map(str::to_owned).collect(), problems.views(&source).len())
}

/// The text with all names new, and how many there were.
fn renamed(text: &str, path: &Path) -> (String, usize) {
    let mut analysis = look(text);
    let mut count = 0;
    let is_old = |name: &str| !name.starts_with("new_") && !["ground", "variant"].contains(&name);
    loop {
        let old = analysis.names.declared().find(|d| is_old(&d.name)).cloned();
        let Some(old) = old else { return (analysis.source.text, count) };
        let name = format!("new_{count}");
        let edits = analysis.rename(old.at.start, &name).unwrap_or_else(|why| {
            panic!("{}: {} → {name}: {why}\n{}", path.display(), old.name, analysis.source.text)
        });
        analysis = look(&edited(&analysis.source.text, &edits));
        count += 1;
    }
}

#[test]
fn answers_do_not_depend_on_names() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut count = 0;
    for (index, path) in spread(files(&root, "mech")).into_iter().enumerate() {
        let text = std::fs::read_to_string(&path).unwrap();
        let (other, names) = renamed(&text, &path);
        count += names;
        if index % 4 == 0 {
            assert!(numbers(&other) == numbers(&text), "{}:\n{other}", path.display());
        }
    }
    assert!(count > crate::share::least(2000), "{count} names");
}

#[test]
fn a_name_that_cannot_be_is_refused_in_the_words_of_check() {
    let text = "given r = 100 mm\ngiven l = 2*r\ngiven a = 1\nground { A (0, 0) }\nlink crank A-B r\nrevolute A: ground - crank\n\
        drive crank = 30 deg\nfind position(B)\n";
    let analysis = look(text);
    for (word, name, why) in [
        ("given r", "l", "`l` is declared twice"),
        ("A-B", "A", "`A` is declared twice"),
        ("link crank", "ground", "`ground` is declared twice"),
        ("given r", "а", "two different names look like `а`"),
        ("given r", "cw", "`cw` is a keyword and cannot be a name"),
        ("given r", "5 mm", "cannot read this `given`: expected a name"),
        ("given r", "", "cannot read this `given`: expected a name"),
        ("given r", "A.B", "cannot read this `given`: expected `=`"),
        ("given r", "x // ", "cannot read this `given`: expected `=`"),
        ("link", "x", "there is no name here"),
        ("ground", "x", "`ground` is a keyword"),
    ] {
        let byte = text.find(word).unwrap() + word.len() - 1;
        assert_eq!(analysis.rename(byte, name), Err(why.to_owned()), "{word} → {name}");
    }
    let hinge = analysis.rename(text.find("revolute A").unwrap() + 9, "O").unwrap();
    let edited = edited(text, &hinge);
    assert!(edited.contains("ground { O (0, 0) }") && edited.contains("crank O-B r"), "{edited}");
}
