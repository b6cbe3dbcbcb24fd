//! The words in the grammars of editors are those of the tables of the language. `UPDATE=1` writes them.
//!
//! A list is on the line after one that names it: `words: units`.

use assur::internals::language::{
    COLLECTIONS, FUNCTIONS, PROPERTIES, Place, Property, PropertyValue, UNITS, WORDS, words_of,
};
use assur::internals::source::Source;
use assur::internals::{syntax, units};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// How a kind of file writes a list.
struct Form {
    /// What is before the first word, and after the last.
    around: (&'static str, &'static str),
    /// What is between two words.
    between: &'static str,
    /// Words are in quotes.
    quoted: bool,
}

const PATTERN: Form = Form { around: ("(?:", ")"), between: "|", quoted: false };
// after the name of the capture
const QUERY: Form = Form { around: ("builtin ", "))"), between: " ", quoted: true };
const BRACES: Form = Form { around: ("{", "}"), between: ", ", quoted: true };
const BLANKS: Form = Form { around: ("\"", "\""), between: " ", quoted: false };

const FILES: [(&str, Form); 4] = [
    ("editors/vscode/syntaxes/mech.tmLanguage.json", PATTERN),
    ("editors/tree-sitter-mech/queries/highlights.scm", QUERY),
    ("editors/tree-sitter-mech/src/scanner.c", BRACES),
    ("editors/pygments/pygments_mech/words.py", BLANKS),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Names and words of a table of properties and of those in their braces.
fn properties(table: &[Property], names: &mut BTreeSet<&'static str>, values: &mut BTreeSet<&'static str>) {
    for property in table {
        names.insert(property.name);
        match property.takes {
            PropertyValue::Block(inner) => properties(inner, names, values),
            PropertyValue::Word(words, _) | PropertyValue::FlagOr(words) => values.extend(words),
            _ => {}
        }
    }
}

/// What the grammar reads as the second part of a unit: `N m`.
fn units_after_a_blank() -> Vec<&'static str> {
    let grammar = include_str!("../../grammar/mech.pest");
    let rule = grammar.lines().find(|line| line.starts_with("unit_last ")).expect("the rule");
    rule.split('"').skip(1).step_by(2).collect()
}

/// The words of a list.
fn words(list: &str) -> Vec<&'static str> {
    let (mut names, mut values) = (BTreeSet::new(), BTreeSet::new());
    PROPERTIES.iter().for_each(|(_, table)| properties(table, &mut names, &mut values));
    match list {
        "statements" => words_of(Place::Statement).collect(),
        "pairs" => words_of(Place::Pair).collect(),
        "members" => words_of(Place::Member).collect(),
        "members of cams" => words_of(Place::CamMember).collect(),
        "laws" => words_of(Place::Law).collect(),
        "connecting" => words_of(Place::Connecting).collect(),
        "contextual" => words_of(Place::Contextual).collect(),
        "functions" => FUNCTIONS.iter().map(|row| row.name).collect(),
        "collections" => COLLECTIONS.iter().map(|row| row.word).collect(),
        "properties" => names.into_iter().collect(),
        "values of properties" => values.into_iter().collect(),
        "units" => UNITS.iter().map(|unit| unit.text).collect(),
        "units after a blank" => units_after_a_blank(),
        _ => panic!("no list is called `{list}`"),
    }
}

/// The line of a list.
fn line(old: &str, list: &str, form: &Form) -> String {
    let (open, close) = form.around;
    let start = old.find(open).unwrap_or_else(|| panic!("`{open}` in {old}")) + open.len();
    let end = start + old[start..].find(close).unwrap_or_else(|| panic!("`{close}` in {old}"));
    let quote = if form.quoted { "\"" } else { "" };
    let words: Vec<String> = words(list).into_iter().map(|word| format!("{quote}{word}{quote}")).collect();
    format!("{}{}{}", &old[..start], words.join(form.between), &old[end..])
}

/// A file with the words of the tables.
fn with_words(text: &str, form: &Form) -> String {
    let mut made = String::new();
    let mut list: Option<&str> = None;
    for old in text.lines() {
        match list.take() {
            Some(name) => made.push_str(&line(old, name, form)),
            None => made.push_str(old),
        }
        made.push('\n');
        list = old.split_once("words: ").map(|(_, name)| name.trim_end_matches(['"', ',']));
    }
    made
}

#[test]
fn grammars_of_editors_have_the_words_of_the_tables() {
    for (path, form) in &FILES {
        let text = read(path);
        let wanted = with_words(&text, form);
        assert!(text.contains("words: "), "{path} names no list");
        if text != wanted && std::env::var_os("UPDATE").is_some() {
            std::fs::write(root().join(path), wanted).expect("a file of the repository");
        } else {
            assert!(text == wanted, "{path}: UPDATE=1 cargo test --test repository editors");
        }
    }
}

#[test]
fn textmate_has_the_units_after_a_blank() {
    // within the line of all units
    let wanted = format!("[ .]({})", units_after_a_blank().join("|"));
    assert!(read("editors/vscode/syntaxes/mech.tmLanguage.json").contains(&wanted), "{wanted}");
}

/// The words of a generated grammar.
fn words_of_grammar(json: &str) -> BTreeSet<&str> {
    let values =
        json.lines().zip(json.lines().skip(1)).filter(|(line, _)| line.contains("\"type\": \"STRING\""));
    let words = values.filter_map(|(_, line)| line.split('"').nth(3));
    words.filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic())).collect()
}

#[test]
fn the_tree_sitter_grammar_has_every_word() {
    let grammar = read("editors/tree-sitter-mech/src/grammar.json");
    let mut wanted: BTreeSet<&str> = WORDS.iter().flat_map(|(place, _)| words_of(*place)).collect();
    // reserved, and in no statement
    wanted.remove("between");
    assert_eq!(words_of_grammar(&grammar), wanted);
}

/// All `.mech` files below a folder, in order.
fn problems_in(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("a folder").flatten().map(|e| e.path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            problems_in(&path, found);
        } else if path.extension().is_some_and(|e| e == "mech") {
            found.push(path);
        }
    }
}

/// A token as places and kinds. The last factors of a unit that are none are names: `6 mm*r`.
fn pieces(token: syntax::Token, text: &str) -> Vec<(usize, usize, &'static str)> {
    let (start, unit) = (token.span.start, token.text(text));
    let kind = match token.kind {
        syntax::TokenKind::Unit => "Unit",
        syntax::TokenKind::Word | syntax::TokenKind::Joining => "Word",
        syntax::TokenKind::Number => "Number",
        syntax::TokenKind::Text => "Text",
        syntax::TokenKind::Comment => "Comment",
        _ => return Vec::new(),
    };
    if kind != "Unit" || units::lookup(unit).is_ok() {
        return vec![(start, token.span.end, kind)];
    }
    let joints = unit.char_indices().filter(|(_, c)| matches!(c, '*' | '/' | '·' | '⋅' | '.' | ' '));
    let joints: Vec<(usize, usize)> = joints.map(|(at, c)| (at, at + c.len_utf8())).collect();
    let known = joints.iter().rposition(|(end, _)| units::lookup(&unit[..*end]).is_ok());
    let known = known.unwrap_or_else(|| panic!("`{unit}` is no unit"));
    let ends = joints[known + 1..].iter().map(|(end, _)| *end).chain([unit.len()]);
    let names = joints[known..].iter().zip(ends).map(|((_, from), end)| (start + from, start + end, "Word"));
    std::iter::once((start, start + joints[known].0, kind)).chain(names).collect()
}

/// Writes the tokens of all examples for `editors/agreement.py`, which compares other grammars with them.
#[test]
fn tokens_of_examples_cover_their_texts() {
    let mut files = Vec::new();
    problems_in(&root().join("examples"), &mut files);
    let mut lines = String::new();
    for path in files {
        let name = path.strip_prefix(root()).expect("below the root").display().to_string();
        let text = std::fs::read_to_string(&path).expect("an example");
        let (_, tokens, _) = syntax::parse_with_tokens(&Source::new(&name, text.clone()));
        let mut at = 0;
        let _ = writeln!(lines, "{name}");
        for token in tokens {
            assert!(text[at..token.span.start].trim().is_empty(), "{name}: a gap at byte {at}");
            at = token.span.end;
            for (start, end, kind) in pieces(token, &text) {
                let _ = writeln!(lines, "\t{start} {end} {kind}");
            }
        }
        assert!(text[at..].trim().is_empty(), "{name}: a gap at byte {at}");
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("tokens.txt"), lines).expect("target/tmp");
}

/// The lines to paste, in their languages.
fn blocks(text: &str) -> Vec<&str> {
    let parts = text.split("\n```").skip(1).step_by(2);
    parts.filter(|part| ["lua", "toml", "elisp"].iter().any(|l| part.starts_with(l))).collect()
}

#[test]
fn lines_to_paste_are_those_of_the_editors_own_pages() {
    let pages = ["neovim", "helix", "emacs"].map(|editor| read(&format!("editors/{editor}/README.md")));
    let known: Vec<&str> = pages.iter().flat_map(|page| blocks(page)).collect();
    let page = read("docs/editors.md");
    let pasted = blocks(&page);
    assert_eq!(pasted.len(), 3);
    for block in pasted {
        assert!(known.contains(&block), "docs/editors.md: {block}");
    }
}

#[test]
fn the_extension_has_the_version_of_the_program() {
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    let package = read("editors/vscode/package.json");
    assert!(package.contains(&version), "the built-in server is taken where the versions agree");
}
