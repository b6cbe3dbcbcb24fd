//! The language on one page, for those who write files without having learnt it: language models above all. Made from the tables that the
//! checker reads; frame, rules, files and messages are written by hand beside it.

use super::manual::SUBJECTS;
use assur_text::language::{
    CAM_MEMBERS, COLLECTIONS, FUNCTIONS, FunctionRow, LAWS, MEMBERS, PAIRS, PROPERTIES, SHAPES, STATEMENTS,
    UNITS, Word,
};
use serde_json::{Value, json};
use std::fmt::Write;

/// Whole files, with what each shows.
pub const FILES: [(&str, &str); 6] = [
    ("forces of a crank-slider", include_str!("card/crank-slider.mech")),
    ("a four-bar over a turn", include_str!("card/four-bar.mech")),
    ("a shaper: six links with a block in a slot", include_str!("card/six-bar.mech")),
    ("a pin in a slot with friction", include_str!("card/slot.mech")),
    ("a planetary train", include_str!("card/train.mech")),
    ("motion under loads", include_str!("card/motion.mech")),
];

/// The page, in Markdown.
#[must_use]
pub fn page() -> String {
    let mut out = "# assur on one page\n\nA `.mech` file states a planar mechanism problem; `assur solve FILE` answers it.\n\n".to_owned();
    out += include_str!("card/frame.md");
    let mut section = |heading: &str, body: &str| {
        let _ = write!(out, "\n## {heading}\n\n{}\n", body.trim_end());
    };
    section("Rules", include_str!("card/rules.md"));
    let files = FILES.map(|(what, text)| format!("{what}:\n\n```mech\n{}\n```\n", text.trim_end()));
    section("Files that solve", &files.join("\n"));
    section("What is asked", include_str!("card/answers.md"));
    section("Statements", &lines(STATEMENTS));
    section("Pairs and transmissions", &lines(PAIRS));
    section("In the braces of a link", &lines(MEMBERS));
    section("Shapes of masses", &lines(SHAPES));
    section("In the braces of a cam", &lines(CAM_MEMBERS));
    section("Laws of cams", &inline(LAWS));
    section("Properties", &properties());
    section("Functions", &functions());
    section("Units", &units());
    section("Messages met most", include_str!("card/diagnostics.md"));
    section("The loop", include_str!("card/loop.md"));
    out
}

/// A line for each word: what can be pasted, and what it is.
fn lines(words: &[Word]) -> String {
    words.iter().map(|word| format!("- `{}` {}\n", word.example, word.means)).collect()
}

fn inline(words: &[Word]) -> String {
    words.iter().map(|word| format!("`{}`", word.word)).collect::<Vec<_>>().join(", ")
}

fn properties() -> String {
    let of = |(of, properties): &(&str, &[assur_text::language::Property])| {
        let all: Vec<String> = properties.iter().map(|one| format!("`{}`", one.example)).collect();
        format!("- {of}: {}\n", all.join(", "))
    };
    PROPERTIES.iter().map(of).collect()
}

/// The calls of all functions, by subject.
fn functions() -> String {
    let calls = |row: &FunctionRow| -> Vec<String> {
        let call = |takes: &[assur_text::language::Argument]| {
            let takes: Vec<String> = takes.iter().map(ToString::to_string).collect();
            format!("`{}({})`", row.name, takes.join(", "))
        };
        let mut calls: Vec<String> = row.forms.iter().map(|form| call(form.takes)).collect();
        calls.dedup();
        calls
    };
    let mut out = String::new();
    for (group, subject) in SUBJECTS {
        let rows = FUNCTIONS.iter().filter(|row| row.group == group);
        let _ = writeln!(out, "- {subject}: {}", rows.flat_map(calls).collect::<Vec<_>>().join(", "));
    }
    let all: Vec<String> = COLLECTIONS.iter().map(|one| format!("`{}`", one.word)).collect();
    let _ = writeln!(out, "- Many answers at once: `find` {}", all.join(", "));
    out + "\nP is a point (`C`, `rod.C`), L a link, J a pair, phi an angle of the cam; `reaction(J, L)` is the force on L.\n"
}

fn units() -> String {
    let all: Vec<&str> = UNITS.iter().map(|unit| unit.text).collect();
    format!("`{}`. Products, quotients and powers: `kg*m^2`, `m/s^2`, `N*m/rad`.\n", all.join(" "))
}

/// Statements and functions as data.
#[must_use]
pub fn data() -> Value {
    let words = |words: &[Word]| -> Vec<Value> {
        words.iter().map(|w| json!({ "word": w.word, "means": w.means, "example": w.example })).collect()
    };
    let functions = FUNCTIONS.iter().flat_map(|row| {
        row.forms.iter().map(|form| {
            let takes: Vec<String> = form.takes.iter().map(ToString::to_string).collect();
            let gives = form.gives.to_string();
            json!({ "name": row.name, "takes": takes, "gives": gives, "means": form.means })
        })
    });
    let functions: Vec<Value> = functions.collect();
    let units: Vec<&str> = UNITS.iter().map(|unit| unit.text).collect();
    json!({
        "schema": "assur.card/1",
        "statements": words(STATEMENTS),
        "pairs": words(PAIRS),
        "members": words(MEMBERS),
        "functions": functions,
        "units": units,
        "files": FILES.map(|(what, text)| json!({ "shows": what, "text": text })),
    })
}

/// `llms.txt`: what a language model that comes by reads first.
#[must_use]
pub fn llms() -> String {
    "# assur

> A small declarative language for planar mechanism problems, and the compiler that solves them: positions, velocities, accelerations, reactions
> with and without friction, balancing, flywheels, cams, gears, trains, motion under loads, pictures, worked solutions.

## Write files

- [The language on one page](docs/card.md): what `assur card` prints
- [Reference](docs/language.md): every statement, function and unit
- [Examples](examples/): files that solve, each with its answers
- [Diagnostics](docs/explain/): a page for every code

## Use the program

- [Agents](docs/agents.md): `assur mcp`, five tools on standard input and output
- [Commands](docs/commands.md)
- [Answers as JSON](docs/json-schema/solution-1.json)
- [Rust](docs/library.md), [Python](docs/python.md)
"
    .to_owned()
}
