//! The tables of the language against its reference and its grammar, in both directions.

use assur::internals::language::{
    CAM_MEMBERS, FUNCTIONS, LAWS, MEMBERS, PAIRS, PROPERTIES, Place, Property, UNITS, WORDS, Word, words_of,
};
use assur::internals::source::Source;
use assur::internals::{syntax, units};
use std::collections::BTreeSet;

fn read(path: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(path).expect("a file of the repository")
}

/// The rows of the first table below a heading of the reference, without its head.
fn table(heading: &str) -> Vec<String> {
    let text = read("docs/language.md");
    let below = text.lines().skip_while(|line| *line != heading).skip(1).skip_while(|l| !l.starts_with("| "));
    below.take_while(|l| l.starts_with("| ")).skip(2).map(str::to_owned).collect()
}

/// Holds a table of the reference to the rows that the tables of the language make.
fn hold(heading: &str, wanted: &[String]) {
    let found = table(heading);
    let missing: Vec<&String> = wanted.iter().filter(|row| !found.contains(row)).collect();
    let needless: Vec<&String> = found.iter().filter(|row| !wanted.contains(row)).collect();
    assert!(missing.is_empty() && needless.is_empty(), "{heading}: add {missing:#?}, remove {needless:#?}");
    assert_eq!(found, wanted, "{heading}: the order");
}

fn code(text: &str) -> String {
    format!("`{text}`")
}

#[test]
fn the_reference_lists_every_function_with_its_arguments() {
    let rows = FUNCTIONS.iter().flat_map(|row| {
        row.forms.iter().map(move |form| {
            let takes = form.takes.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
            format!("| `{}({takes})` | {} | {} |", row.name, form.means, form.gives)
        })
    });
    hold("## Functions", &rows.collect::<Vec<_>>());
}

#[test]
fn the_reference_lists_every_property() {
    // a property that several have is one row
    let mut rows: Vec<(String, String)> = Vec::new();
    for (of, list) in PROPERTIES {
        for Property { name, takes, means, .. } in *list {
            let row = format!("`{name}` | {takes} | {means} |");
            match rows.iter_mut().find(|(_, known)| *known == row) {
                Some((all, _)) => *all = format!("{all} `{of}`"),
                None => rows.push((code(of), row)),
            }
        }
    }
    let rows = rows.into_iter().map(|(of, row)| format!("| {of} | {row}"));
    hold("## Properties", &rows.collect::<Vec<_>>());
}

#[test]
fn the_reference_lists_every_word() {
    let rows = WORDS.iter().map(|(place, list)| {
        let of = match place {
            Place::Statement => "begin a statement",
            Place::Pair => "begin a pair or transmission",
            Place::Member => "begin a member of a link",
            Place::CamMember => "begin a member of a cam",
            Place::Law => "name the laws of cams",
            Place::Connecting => "connect others, and cannot be names",
            Place::Shape => "follow the value of a mass, and can be names elsewhere",
            Place::Contextual => "connect others, and can be names elsewhere",
        };
        let words = list.iter().map(|row| code(row.word)).collect::<Vec<_>>();
        format!("| {of} | {} |", words.join(" "))
    });
    hold("## Words", &rows.collect::<Vec<_>>());
}

#[test]
fn the_reference_lists_every_unit_beside_those_of_its_dimension() {
    let mut listed = BTreeSet::new();
    for row in table("## Values and units") {
        let cells: Vec<&str> = row.split(" | ").collect();
        let units = cells[1].split(';').next().unwrap_or_default();
        let words: Vec<&str> = units.split('`').skip(1).step_by(2).collect();
        let of = |word: &str| units::lookup(word).unwrap_or_else(|_| panic!("`{word}` in {row}")).dimension;
        for word in &words {
            assert!(of(word).fits(of(words[0])), "`{word}` in {row}");
            if units::is_unit(word) {
                assert!(listed.insert((*word).to_owned()), "`{word}` is listed twice");
            }
        }
    }
    let known: BTreeSet<String> = UNITS.iter().map(|u| u.text.to_owned()).collect();
    assert_eq!(listed, known);
}

/// The text of a rule of the grammar.
fn rule<'g>(grammar: &'g str, name: &str) -> &'g str {
    let head = format!("\n{name} ");
    let start = grammar.find(&head).unwrap_or_else(|| panic!("the rule `{name}`")) + head.len();
    let rest = &grammar[start..];
    let next = rest
        .match_indices('\n')
        .map(|(i, _)| i)
        .find(|i| rest[i + 1..].starts_with(|c: char| c.is_ascii_alphabetic() || c == '/' || c == '\n'));
    &rest[..next.unwrap_or(rest.len())]
}

/// The words in quotes in a rule.
fn quoted(rule: &str) -> BTreeSet<&str> {
    let strings = rule.split('"').skip(1).step_by(2);
    strings.filter(|s| s.len() > 1 && s.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')).collect()
}

/// The rules with a prefix that a rule names, without it.
fn named<'r>(rule: &'r str, prefix: &str) -> BTreeSet<&'r str> {
    rule.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .filter_map(|w| w.strip_prefix(prefix))
        .collect()
}

fn set(places: &[Place]) -> BTreeSet<&'static str> {
    places.iter().flat_map(|place| words_of(*place)).collect()
}

fn of(table: &'static [Word]) -> BTreeSet<&'static str> {
    table.iter().map(|row| row.word).collect()
}

#[test]
fn the_grammar_has_the_words_of_the_tables() {
    let grammar = read("grammar/mech.pest");
    assert_eq!(quoted(rule(&grammar, "kind")), of(PAIRS));
    assert_eq!(quoted(rule(&grammar, "statement_word =")), set(&[Place::Statement, Place::Pair]));
    let reserved = quoted(rule(&grammar, "reserved"));
    assert_eq!(reserved, set(&[Place::Connecting, Place::Law]));
    assert_eq!(named(rule(&grammar, "law"), "w_"), of(LAWS));
    let mut members = named(rule(&grammar, "member "), "m_");
    assert!(members.remove("point"));
    assert_eq!(members, of(MEMBERS));
    let mut of_cams = named(rule(&grammar, "phase_kind"), "w_");
    of_cams.extend(["turning", "follower", "lift"]);
    assert_eq!(of_cams, of(CAM_MEMBERS));
    // every word has a rule that is named after it; some are only kept free
    let rules = grammar.lines().filter_map(|line| line.strip_prefix("w_")?.split_once(" = "));
    let mut words = BTreeSet::new();
    for (name, text) in rules {
        assert_eq!(quoted(text), BTreeSet::from([name]));
        words.insert(name);
    }
    words.extend(&reserved);
    words.extend(of(PAIRS));
    assert_eq!(words, WORDS.iter().flat_map(|(place, _)| words_of(*place)).collect());
    for unit in
        ["unit_last", "unit_common"].map(|name| rule(&grammar, name)).join(" ").split('"').skip(1).step_by(2)
    {
        assert!(units::is_unit(unit), "{unit}");
    }
}

/// Whether a text reads, whatever it means.
fn reads(text: &str) {
    let (_, problems) = syntax::parse(&Source::new("example.mech", text));
    assert!(!problems.has_errors(), "{text}");
}

#[test]
fn every_example_reads() {
    for (place, list) in WORDS {
        for row in list.iter().filter(|row| !["variants", "curve"].contains(&row.word)) {
            match place {
                Place::Statement | Place::Pair => reads(row.example),
                Place::Member | Place::Shape => reads(&format!("link a A-B 1 m {{ {} }}", row.example)),
                Place::CamMember | Place::Law => reads(&format!("cam a {{ {} }}", row.example)),
                Place::Connecting | Place::Contextual => assert_eq!(row.example, ""),
            }
        }
    }
    for row in FUNCTIONS {
        reads(&format!("find {}", row.usage));
    }
    for (_, list) in PROPERTIES {
        for property in *list {
            reads(&format!("spring k: a.A - b.B {{ {} }}", property.example));
        }
    }
}

#[test]
fn every_name_stands_once_in_its_table() {
    let once = |names: Vec<&str>| {
        let set: BTreeSet<&&str> = names.iter().collect();
        assert_eq!(set.len(), names.len(), "{names:?}");
    };
    once(FUNCTIONS.iter().map(|row| row.name).collect());
    once(UNITS.iter().map(|row| row.text).collect());
    PROPERTIES.iter().for_each(|(_, list)| once(list.iter().map(|p| p.name).collect()));
    WORDS.iter().for_each(|(place, _)| once(words_of(*place).collect()));
    let means = WORDS.iter().flat_map(|(_, list)| list.iter().map(|row| row.means));
    assert!(means.into_iter().all(|m| !m.is_empty() && !m.ends_with('.')));
}
