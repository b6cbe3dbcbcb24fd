//! What a sheet gives: every expression of a file is a datum or has its place elsewhere, every kind has words, and no number that moves
//! an answer is missing.

use crate::examples::{Example, examples};
use assur::internals::check::{expressions, parts_of};
use assur::internals::language::PROPERTIES;
use assur::internals::source::{Source, Span};
use assur::internals::syntax::document::{Document, ExprKind, Number, Statement};
use assur::internals::syntax::given::{Datum, Given, GivenKind, GivenLine, GivenValue, KINDS, Shown, lines};
use assur::internals::syntax::parse;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::process::{Command, Stdio};

fn read(text: &str) -> Document {
    parse(&Source::new("", text)).0
}

/// The places of a statement's expressions, words of properties such as `even` aside.
fn written(statement: &Statement) -> BTreeSet<(usize, usize)> {
    let mut all = BTreeSet::new();
    let is_word = |kind: &ExprKind| matches!(kind, ExprKind::Name(word) if WORDS.contains(&&**word));
    expressions(statement, &mut |expr| {
        if !is_word(&expr.kind) {
            all.insert((expr.span.start, expr.span.end));
        }
    });
    all
}

/// Words in place of values: they are flags.
const WORDS: [&str; 7] = ["line", "even", "worn", "round", "far", "cw", "ccw"];

#[test]
fn every_expression_is_a_datum() {
    let (mut count, mut wrong) = (0, Vec::new());
    for Example { name, text, .. } in examples() {
        let document = read(text);
        for (line, statement) in lines(&document).iter().zip(&document.statements) {
            let given: BTreeSet<_> =
                line.data.iter().flat_map(Datum::spans).map(|span| (span.start, span.end)).collect();
            let written = written(&statement.node);
            count += written.len();
            wrong.extend(written.difference(&given).map(|(a, b)| format!("{name}: {}", &text[*a..*b])));
        }
    }
    println!("{count} expressions");
    assert!(count > 5000, "{count}");
    assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(40)]);
}

/// The keys of a section of the words of a language.
fn keys(language: &str, section: &str) -> BTreeSet<String> {
    let path = format!("{}/crates/assur-worked/messages/{language}.txt", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("words");
    let own = text.split(&format!("[{section}]\n")).nth(1).expect("a section").split("\n[").next();
    let keys = own.unwrap_or_default().lines().filter(|line| !line.starts_with('#'));
    keys.filter_map(|line| Some(line.split_once(" | ")?.0.to_owned())).collect()
}

#[test]
fn every_kind_and_every_property_has_words() {
    let hidden = ["find", "method", "expect", "assemble"];
    let wanted: BTreeSet<String> =
        KINDS.iter().map(|kind| kind.key.to_owned()).filter(|key| !hidden.contains(&&**key)).collect();
    for language in ["en", "ru", "zh"] {
        assert_eq!(keys(language, "given"), wanted, "{language}");
    }
    for (block, properties) in PROPERTIES {
        for property in properties.iter().filter(|property| property.name != "rim") {
            assert!(GivenKind::of_property(block, property.name).is_some(), "{block}: {}", property.name);
        }
    }
}

/// A number of a file, and whether it is told.
struct Literal<'d> {
    number: &'d Number,
    at: usize,
    datum: Option<&'d Datum<'d>>,
    key: &'static str,
    is_told: bool,
}

/// All numbers of a document but those of expectations, exponents and the method.
fn literals<'d>(document: &'d Document, all: &'d [GivenLine<'d>], given: &Given<'d>) -> Vec<Literal<'d>> {
    let columns: BTreeSet<&str> = document
        .statements
        .iter()
        .filter_map(|s| match &s.node {
            Statement::Variants(table) => Some(table.columns.iter().map(|column| column.name.node.as_str())),
            _ => None,
        })
        .flatten()
        .collect();
    let mut found = Vec::new();
    for line in all {
        let kept = given.lines.iter().find(|kept| kept.statement == line.statement);
        for datum in &line.data {
            if matches!(datum.shown, Shown::Key | Shown::Method) {
                continue;
            }
            let is_kept = kept.is_some_and(|kept| kept.data.contains(datum));
            let is_used = datum.own.is_some_and(|own| given.used.contains(own) && !columns.contains(own));
            let is_definition = matches!(datum.kind.key, "given" | "let");
            let in_table = datum.own.is_some_and(|own| columns.contains(own)) && is_definition;
            for value in datum.expressions() {
                let mut exponents = BTreeSet::new();
                parts_of(value, &mut |part| {
                    if let ExprKind::Power(_, power) = &part.kind {
                        exponents.insert(power.span.start);
                    }
                });
                parts_of(value, &mut |part| {
                    let ExprKind::Number(number) = &part.kind else { return };
                    if exponents.contains(&part.span.start) || in_table {
                        return;
                    }
                    let is_told = if is_definition { is_used } else { is_kept };
                    let (key, at) = (datum.kind.key, part.span.start);
                    found.push(Literal { number, at, datum: Some(datum), key, is_told });
                });
            }
        }
    }
    found
}

/// The answers of a text by position and name; none where it has no solution.
fn answers(text: &str) -> Option<BTreeMap<String, Vec<f64>>> {
    let solution = assur::solve(text).ok()?;
    let mut all = BTreeMap::new();
    let mut put = |key: String, answer: &assur::Answer| {
        let numbers = answer.number().map(|x| vec![x]);
        let numbers = numbers.or_else(|| answer.vector().map(|(x, y)| vec![x, y]));
        all.insert(key, numbers.unwrap_or_default());
    };
    for name in solution.names() {
        solution.get(name).into_iter().for_each(|answer| put(name.clone(), answer));
    }
    for (i, pose) in solution.poses().iter().enumerate() {
        pose.iter().for_each(|(name, answer)| put(format!("{i} {name}"), answer));
    }
    Some(all)
}

/// Whether an answer is another one: by more than a part in a million of the largest of its name.
fn differ(one: &BTreeMap<String, Vec<f64>>, two: &BTreeMap<String, Vec<f64>>) -> bool {
    let name = |key: &str| key.split_once(' ').map_or(key, |(_, name)| name).to_owned();
    let mut largest: BTreeMap<String, f64> = BTreeMap::new();
    for (key, values) in one {
        let size = values.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
        let own = largest.entry(name(key)).or_default();
        *own = own.max(size);
    }
    let is_near = |key: &str, a: &[f64], b: &[f64]| {
        let scale = largest.get(&name(key)).copied().unwrap_or_default();
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-6 * scale.max(1e-12))
    };
    one.len() != two.len() || one.iter().any(|(key, a)| two.get(key).is_none_or(|b| !is_near(key, a, b)))
}

/// A number as a sheet may have it, and its digits there.
fn changed(literal: &Literal<'_>) -> Vec<String> {
    let value = literal.number.value;
    let is_count = literal.number.unit.is_none() && value.fract() == 0.0 && value >= 2.0;
    let counts = [value + 1.0, value - 1.0].map(|x| format!("{x}"));
    let parts = [1.1, 0.9, 1.02, 0.98, 1.001].map(|factor| format!("{}", value * factor));
    if is_count { counts.into_iter().chain(parts).collect() } else { parts.to_vec() }
}

/// What is said of a number without its digits: a direction in words, or a number of mathematics.
fn is_in_words(literal: &Literal<'_>) -> bool {
    let is_direction = literal.number.unit.as_ref().is_some_and(|unit| unit.node == "deg")
        && literal.number.value % 90.0 == 0.0;
    is_direction || literal.datum.is_some_and(|datum| matches!(datum.value, GivenValue::Positions(_)))
}

/// What changed numbers showed.
#[derive(Default)]
struct Tally {
    files: usize,
    numbers: usize,
    moved: usize,
    wrong: Vec<String>,
}

impl Tally {
    /// Changes numbers of a file, about so many or all: what moves an answer is told. Nothing where the file has no answer.
    fn judge(&mut self, name: &str, text: &str, most: Option<usize>) -> Option<()> {
        let document = read(text);
        let without: String = without(text, &document);
        let base = answers(&without).filter(|base| !base.is_empty())?;
        let (all, given) = (lines(&document), Given::of(&document));
        // a motion that breaks off has answers up to there, and no sheet
        let sheet = Some(sheet(text)).filter(|sheet| !sheet.is_empty())?;
        self.files += 1;
        let literals = literals(&document, &all, &given);
        let step = most.map_or(1, |most| literals.len().div_ceil(most).max(1));
        // not the same ones in every file
        for literal in literals.into_iter().skip(self.files % step).step_by(step) {
            self.numbers += 1;
            let end = literal.at + literal.number.text.len();
            let other =
                |new: &String| answers(&format!("{}{new}{}", &without[..literal.at], &without[end..]));
            let Some(other) = changed(&literal).iter().find_map(other) else { continue };
            if !differ(&base, &other) {
                continue;
            }
            self.moved += 1;
            let line = text[..literal.at].rfind('\n').map_or(0, |at| at + 1);
            let words = text[line..].lines().next().unwrap_or_default();
            let digits = literal.number.text.split(['e', 'E']).next().unwrap_or_default();
            let is_text = literal.datum.is_some_and(|datum| datum.shown == Shown::Text);
            if !literal.is_told {
                self.wrong.push(format!("{name}: {digits} of `{}` is not told: {words}", literal.key));
            } else if is_text && !is_in_words(&literal) && !sheet.contains(digits) {
                self.wrong.push(format!("{name}: {digits} of `{}` is not printed: {words}", literal.key));
            }
        }
        Some(())
    }

    fn finish(self, least: usize) {
        let Self { files, numbers, moved, wrong } = self;
        println!("{numbers} numbers of {files} files, {moved} move an answer");
        assert!(moved > least, "{moved}");
        assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(60)]);
    }
}

/// The sheet of a text.
fn sheet(text: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_assur"))
        .args(["report", "-", "--sheet", "--format", "text"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs");
    child.stdin.take().expect("a stream").write_all(text.as_bytes()).expect("it reads");
    String::from_utf8_lossy(&child.wait_with_output().expect("it ends").stdout).into_owned()
}

/// Examples that ask for something and have an answer.
fn with_questions() -> Vec<&'static Example> {
    examples().iter().filter(|e| e.text.contains("\nfind ") && e.solved.is_some()).collect()
}

#[test]
fn no_number_that_moves_an_answer_is_missing() {
    let mut tally = Tally::default();
    for Example { name, text, .. } in crate::share::spread(with_questions()) {
        tally.judge(name, text, None);
    }
    tally.finish(200);
}

/// Examples with other numbers: none is special any more, and none is that of another.
#[test]
fn the_same_holds_with_random_numbers() {
    let (all, mut tally) = (with_questions(), Tally::default());
    for seed in crate::share::first(0..300) {
        let mut state = seed;
        let mut random = || {
            // Knuth's multiplier
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        random();
        let Example { name, text, .. } = all[(random() * all.len() as f64) as usize];
        let document = read(text);
        let (data, given) = (lines(&document), Given::of(&document));
        let mut other = without(text, &document);
        let mut literals = literals(&document, &data, &given);
        literals.sort_by_key(|literal| std::cmp::Reverse(literal.at));
        for literal in literals.iter().filter(|literal| literal.number.unit.is_some()) {
            let end = literal.at + literal.number.text.len();
            let value = literal.number.value * (0.97 + 0.06 * random());
            let decimals = (3.0 - libm::log10(value.abs()).floor()).clamp(0.0, 12.0) as usize;
            other.replace_range(literal.at..end, &format!("{value:.decimals$}"));
        }
        tally.judge(&format!("{name}, {seed}"), &other, Some(5));
    }
    tally.finish(100);
}

/// A text without its expectations and variants, each character where it was.
fn without(text: &str, document: &Document) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let aside = document
        .statements
        .iter()
        .filter(|s| matches!(s.node, Statement::Expect(_) | Statement::Variants(_)));
    for Span { start, end } in aside.map(|s| s.span) {
        for byte in &mut bytes[start..end] {
            if *byte != b'\n' {
                *byte = b' ';
            }
        }
    }
    String::from_utf8(bytes).expect("a text")
}
