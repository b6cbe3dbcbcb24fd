//! `assur course`: the file of Moodle by the rules of Moodle, and its verdicts against those of `grade`.

#![allow(clippy::unwrap_used)] // a test that cannot write its files has failed

mod moodle;
mod prairielearn;

use crate::run::{Folder, assur};
use crate::share;
use assur::internals::exercise::grade::{Credit, Rules, Sheet, Verdict, grade};
use moodle::{Asked, Element, decoded, gaps, numerical, read};
use std::collections::{BTreeMap, BTreeSet};

const SET: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/exercise-set");
/// Angles, vectors, reactions, zeros, several positions, awkward names.
const MIXED: &str = "\
mechanism \"Slider & crank: {r} / {n}\"
// A crank turns. Find angles, velocities and forces.
given r = 80 mm
given n = 600 rpm
ground { A (0, 0); line guide through A along 0 deg }
link 1 crank  A-B r
link 2 rod    B-C 280 mm
link 3 piston { C (0, 0) }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 50 deg, 130 deg at n
assemble C ahead of B
force on piston at C = 1 kN left
balance torque M on crank
find th = angle(rod) as deg, crank_angle = angle(crank) as rad, v = velocity(piston.C) as m/s, M as N*m
find w = omega(rod) as rpm, ratio = r / 280 mm, top = max(velocity(piston.C).x) as m/s
find reactions
variants {
  variant, r [mm], n [rpm]
  A1, 80, 600
  B_2, 90, 500
}
";

fn made(folder: &Folder, args: &[&str]) -> String {
    let said = assur(folder, &[&["course", "moodle"], args].concat());
    assert_eq!((said.status, said.stderr.as_str()), (0, ""), "{args:?}");
    said.stdout
}

/// The questions of a file, without categories.
fn questions(text: &str) -> Vec<Element> {
    let quiz = read(text).unwrap();
    assert_eq!(quiz.name, "quiz");
    quiz.inside.into_iter().filter(|one| one.attribute("type") != "category").collect()
}

/// The numbers that a question asks for.
fn asked(question: &Element) -> Vec<Asked> {
    match question.attribute("type") {
        "cloze" => gaps(question.said("questiontext")).0,
        _ => vec![numerical(question)],
    }
}

#[test]
fn the_file_keeps_the_rules_of_moodle() {
    const PARTS: [f64; 5] = [100.0, 0.0, 50.0, 25.0, 33.33333];
    let folder = Folder::new("course").with("set/mixed.mech", MIXED);
    let credit = ["--credit", "sign=0.5,half=0.5"];
    let points = ["--points", "M=1.5,v.x=0.5"];
    for more in [
        &credit[..],
        &points,
        &["--one-per-answer"],
        &["--lang", "ru"],
        &["--steps", "none", "--picture", "none"],
    ] {
        let text = made(&folder, &[&["set/mixed.mech", "--pose", "1"], more].concat());
        let quiz = read(&text).unwrap();
        let category = quiz.inside.first().unwrap();
        assert_eq!(category.said("category"), "$course$/top/set/01 Slider & crank: r // n");
        let mut ids = BTreeSet::new();
        for question in questions(&text) {
            let id = question.said("idnumber");
            assert!(ids.insert(id.to_owned()), "{id} is there twice");
            assert!(id.chars().count() <= 100 && id.chars().all(|c| c.is_alphanumeric() || "-@".contains(c)));
            assert!(question.said("name").chars().count() <= 255);
            files_are_there(&question);
            for asked in asked(&question) {
                assert!(asked.weight > 0.0);
                for one in &asked.options {
                    assert!(PARTS.contains(&one.fraction), "{}", one.fraction);
                    let digits = one.text.split('e').next().unwrap().trim_start_matches(['-', '0', '.']);
                    let digits = digits.chars().filter(char::is_ascii_digit).collect::<String>();
                    assert!(digits.trim_end_matches('0').len() <= 6, "{}", one.text);
                    assert!(!one.words.is_empty() && !one.words.contains(['~', '{', '}']), "{}", one.words);
                }
                let names: BTreeSet<&str> = asked.units.iter().map(|(name, _)| name.as_str()).collect();
                assert_eq!(names.len(), asked.units.len(), "units have different names");
                let wrong =
                    |name: &&&str| name.contains(char::is_whitespace) || name.starts_with(char::is_numeric);
                assert_eq!(names.iter().find(wrong), None);
                assert!(asked.units.first().is_none_or(|(_, many)| *many == 1.0));
            }
        }
    }
}

/// Files that are used are there, and those that are there are used.
fn files_are_there(question: &Element) {
    for part in ["questiontext", "generalfeedback"] {
        let used = question.said(part).split("@@PLUGINFILE@@/").skip(1);
        let used: BTreeSet<&str> = used.filter_map(|rest| rest.split('"').next()).collect();
        let part = question.one(part);
        let there: BTreeSet<&str> = part.all("file").map(|file| file.attribute("name")).collect();
        assert_eq!(used, there);
        for file in part.all("file") {
            let svg = String::from_utf8(bytes(&file.text)).unwrap();
            assert!(svg.starts_with("<svg xmlns=") && svg.trim_end().ends_with("</svg>"));
            assert!(!svg.contains("prefers-color-scheme"), "Moodle has no dark pages");
        }
    }
}

fn bytes(base64: &str) -> Vec<u8> {
    let value = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let mut out = Vec::new();
    for four in base64.as_bytes().chunks(4) {
        let all =
            four.iter().fold(0_u32, |all, c| all << 6 | u32::from(if *c == b'=' { 0 } else { value(*c) }));
        let padding = four.iter().filter(|c| **c == b'=').count();
        out.extend_from_slice(&all.to_be_bytes()[1..4 - padding]);
    }
    out
}

#[test]
fn one_thread_or_two_write_the_same() {
    let folder = Folder::new("course-threads");
    let args = |threads| [SET, "--steps", "3,6", "--threads", threads];
    let once = made(&folder, &args("1"));
    assert_eq!(once, made(&folder, &args("2")));
    assert_eq!(once.matches("<question type=\"cloze\">").count(), 75);
    assert_eq!(once.matches("<question type=\"category\">").count(), 25);
}

/// Numbers from 0 to 1, the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.next() * all.len() as f64) as usize % all.len()]
    }
}

/// An answer to a quantity with this key among others, in its unit.
fn answer(random: &mut Random, key: f64, others: &[f64], degrees: bool, options: &[moodle::Option]) -> f64 {
    const FACTORS: [f64; 10] =
        [1000.0, 57.295_78, 9.549_297, std::f64::consts::TAU, 9.81, 60.0, 10.0, 100.0, 1e6, 2.0];
    let near = 1.0 + 0.07 * (random.next() - 0.5);
    let sign = random.of(&[1.0, 1.0, -1.0]);
    let turn = if degrees { 180.0 } else { std::f64::consts::PI };
    match (random.next() * 10.0) as u32 {
        0 => key * near,
        1 => -key * near,
        2 => sign * key * random.of(&FACTORS) * near,
        3 => sign * key / random.of(&FACTORS) * near,
        4 if !others.is_empty() => sign * random.of(others) * near,
        5 => sign * key.hypot(others.first().copied().unwrap_or(0.0)) * near,
        6 => random.of(&[key + turn, turn - key, key - 2.0 * turn, key + 2.0 * turn]) * near,
        7 => sign * (1.0 + 9.0 * random.next()) * 10_f64.powi((random.next() * 10.0) as i32 - 4),
        _ => {
            // beside a border
            let at = (random.next() * options.len() as f64) as usize % options.len();
            let edge = options[at].answer + random.of(&[1.0, -1.0]) * options[at].tolerance;
            edge * (1.0 + random.of(&[2e-5, -2e-5]))
        }
    }
}

/// The same as a student types it, with the number that it is.
fn typed(x: f64) -> (String, f64) {
    let text = format!("{x:.9e}");
    let x = text.parse().unwrap();
    (text, x)
}

/// Parts of the mark for all slips but the value of another row, such that Moodle has their products.
const CREDIT: &str = "sign=0.5,other-link=0.5,unit=0.5,weight=0.5,decimal-point=0.2,half=0.5,opposite-direction=0.25,\
                      supplement=0.25,other-component=0.2,magnitude=0.2,other-quantity=0.1,close=0.75";

/// A verdict: the part of the mark in percent, and what is said; nothing where there is no name.
type Said = (f64, String);

/// What a file knows nothing of: the right answer, or a slip, turns away; what is at a border, beside its vector.
#[derive(Clone, Copy)]
struct Unknown {
    right: bool,
    slip: bool,
}

impl Unknown {
    fn of(x: f64, key: f64, unit: &str, options: &[moodle::Option]) -> Self {
        let turn = match unit {
            "deg" => 360.0,
            "rad" => std::f64::consts::TAU,
            _ => f64::INFINITY,
        };
        let right = (x - key).abs() > 1.4 * turn;
        // ends of intervals have six digits
        let least = 5e-5 * options[0].tolerance;
        let is_border = |one: &moodle::Option| ((x - one.answer).abs() - one.tolerance).abs() <= least;
        Self { right, slip: right || x.abs() > 1.4 * turn || options.iter().any(is_border) }
    }
}

#[derive(Default)]
struct Tally {
    kinds: BTreeMap<&'static str, usize>,
    differ: Vec<String>,
}

impl Tally {
    /// Compares two verdicts.
    fn add(&mut self, pack: &Said, marker: &Said, unknown: Unknown, of: &str) {
        let is_same = (pack.0 - marker.0).abs() < 1e-3 && pack.1 == marker.1;
        let is_unknown = if marker.0 == 100.0 { unknown.right } else { unknown.slip };
        let kind = match (pack, marker) {
            (pack, _) if is_same && pack.0 == 100.0 => "right",
            (pack, _) if is_same && pack.1.is_empty() => "wrong, no name",
            _ if is_same => "wrong, same name",
            ((0.0, name), _) if name.is_empty() && is_unknown => "in grade alone",
            _ => {
                self.differ.push(format!("{of}: the file says {pack:?}, grade says {marker:?}"));
                return;
            }
        };
        *self.kinds.entry(kind).or_default() += 1;
    }

    fn check(&self, least: usize) {
        println!("{:?}", self.kinds);
        let differ = &self.differ;
        assert!(differ.is_empty(), "{} differ:\n{}", differ.len(), differ[..differ.len().min(20)].join("\n"));
        assert!(self.kinds.values().sum::<usize>() >= least, "{:?}", self.kinds);
        assert!(self.kinds.len() >= 3, "every kind is seen: {:?}", self.kinds);
    }
}

/// What `grade` says of a line of answers, by quantity; other rows aside.
fn marked(key: &Sheet, header: &str, line: &str) -> BTreeMap<String, Said> {
    let text = format!("{header}\n{line}\n");
    let answers = Sheet::read("a", text.as_bytes(), Some(key)).unwrap().unwrap();
    let rules = Rules { credit: Credit::read(CREDIT).unwrap(), ..Rules::default() };
    let graded = grade(key, answers, &rules).unwrap();
    let row = graded.rows.iter().find(|row| row.line.is_some()).unwrap();
    let marks = row.marks.iter().map(|mark| {
        let words = match &mark.verdict {
            Verdict::Wrong(Some(slip)) if slip.name() != "other-row" => slip.words(),
            _ => String::new(),
        };
        let mut letters = words.chars();
        let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
        let end = if words.is_empty() || words.ends_with('?') { "" } else { "." };
        let said = format!("{first}{}{end}", letters.as_str());
        let part = if mark.possible > 0.0 { 100.0 * mark.points / mark.possible } else { 0.0 };
        (graded.quantity(mark).name.clone(), (part, said))
    });
    marks.collect()
}

/// A row of a key as text: the names of the row, and its numbers with their headers.
struct KeyRow {
    names: [String; 2],
    numbers: Vec<(String, String, f64)>,
}

/// The key of a file, read by itself: `name [unit]`.
fn key_rows(text: &str) -> Vec<KeyRow> {
    let rows = crate::run::rows(text);
    let unit = |header: &str| match header.rsplit_once(" [") {
        Some((name, unit)) => (name.to_owned(), unit.trim_end_matches(']').to_owned()),
        None => (header.to_owned(), String::new()),
    };
    let place = |name: &str| rows[0].iter().position(|header| header == name);
    let row = |cells: &Vec<String>| KeyRow {
        names: ["row", "pose"].map(|name| place(name).map_or_else(String::new, |i| cells[i].clone())),
        numbers: (rows[0].iter().zip(cells).filter(|(header, _)| *header != "row" && *header != "pose"))
            .filter_map(|(header, cell)| Some((unit(header), cell.parse().ok()?)))
            .map(|((name, unit), x)| (name, unit, x))
            .collect(),
    };
    rows[1..].iter().filter(|cells| cells[0] != "turns").map(row).collect()
}

/// The values of others of the same unit: a partner of a vector first.
fn others(row: &KeyRow, name: &str, unit: &str) -> Vec<f64> {
    let stem = name.trim_end_matches(".x").trim_end_matches(".y");
    let mut all: Vec<(bool, f64)> = Vec::new();
    for (other, its, x) in row.numbers.iter().filter(|(other, its, _)| other != name && its == unit) {
        all.push((
            !(other.starts_with(stem) && other.ends_with([".x", ".y"].map(|e| e.chars().last().unwrap()))),
            *x,
        ));
        let _ = its;
    }
    all.sort_by_key(|(far, _)| *far);
    all.into_iter().map(|(_, x)| x).collect()
}

/// Ten thousand answers get from the file the words and the part of the mark that they get from `grade`.
#[test]
fn verdicts_are_those_of_grade() {
    let count = share::part(40);
    let mut random = Random(7);
    let mut tally = Tally::default();
    let mut files: Vec<(String, String)> = std::fs::read_dir(SET)
        .unwrap()
        .flatten()
        .filter(|file| file.path().extension().is_some_and(|e| e == "mech"))
        .map(|file| {
            (file.file_name().to_string_lossy().into_owned(), std::fs::read_to_string(file.path()).unwrap())
        })
        .collect();
    files.sort();
    files.push(("mixed.mech".to_owned(), MIXED.to_owned()));
    for (name, text) in &files {
        let folder = Folder::new("course-verdicts").with(name, text);
        let batch = assur(&folder, &["batch", name, "--key", "key.csv", "--out", "all.csv"]);
        assert_eq!(batch.status, 0, "{}", batch.stderr);
        let key_text = folder.read("key.csv").replace(",variant", ",name");
        let key_text = if name == "mixed.mech" { without_variant(&folder.read("key.csv")) } else { key_text };
        let key = Sheet::read("key.csv", key_text.as_bytes(), None).unwrap().unwrap();
        let rows = key_rows(&key_text);
        let poses: BTreeSet<&String> = rows.iter().map(|row| &row.names[1]).collect();
        // what needs no position is in a line of its own
        let several = poses.len() > 1;
        for pose in poses {
            let at: &[&str] = if pose.is_empty() { &[] } else { &["--pose", pose] };
            let plain =
                [&[name.as_str(), "--steps", "none", "--picture", "none", "--credit", CREDIT], at].concat();
            let numbers = questions(&made(&folder, &[&plain[..], &["--one-per-answer"]].concat()));
            let clozes = questions(&made(&folder, &plain));
            let gaps: Vec<Asked> = clozes.iter().flat_map(asked).collect();
            assert_eq!(gaps.len(), numbers.len(), "a question for every gap");
            let rows: Vec<&KeyRow> = rows.iter().filter(|row| row.names[1] == *pose).collect();
            let per_row = numbers.len() / rows.len();
            for ((i, question), gap) in numbers.iter().enumerate().zip(&gaps) {
                let row = rows[i / per_row];
                let called = question.said("name");
                let of = called.rsplit_once(": ").unwrap().1;
                let quantity = (row.numbers.iter())
                    .filter(|(name, ..)| called.contains(&format!(": {name} (")) || of == name)
                    .max_by_key(|(name, ..)| name.len());
                let Some((quantity, unit, value)) = quantity else {
                    assert!(several, "{called} is in the key");
                    continue;
                };
                let number = numerical(question);
                let header = if unit.is_empty() { quantity.clone() } else { format!("{quantity} [{unit}]") };
                let header = format!("row,pose,\"{header}\"");
                let others = others(row, quantity, unit);
                for _ in 0..count {
                    let x = answer(&mut random, *value, &others, unit == "deg", &gap.options);
                    if x.abs() > 1e15 || x != 0.0 && x.abs() < 1e-15 {
                        continue;
                    }
                    let (text, x) = typed(x);
                    let around = [1.0 - 1e-5, 1.0 + 1e-5].map(|part| gap.hit(x * part));
                    if around.iter().any(|hit| *hit != gap.hit(x)) {
                        continue;
                    }
                    let marks = marked(&key, &header, &format!("{},{pose},{text}", row.names[0]));
                    let marker = &marks[quantity];
                    let said = |(fraction, words): (f64, &str)| {
                        (fraction, if fraction == 100.0 { String::new() } else { decoded(words).unwrap() })
                    };
                    let at = format!("{called}, key {value}: {text}");
                    tally.add(&said(gap.hit(x)), marker, Unknown::of(x, *value, unit, &gap.options), &at);
                    // the same with a unit, in any spelling
                    let response = match number.units.as_slice() {
                        [] => text.clone(),
                        units => {
                            let (unit, many) =
                                &units[(random.next() * units.len() as f64) as usize % units.len()];
                            format!("{:.12e} {unit}", x * many)
                        }
                    };
                    let read = number.number(&response).unwrap_or_else(|| panic!("{response} is read"));
                    assert!((read - x).abs() <= 1e-9 * x.abs(), "{response} is {x}");
                    assert_eq!(number.hit(read), gap.hit(x), "{at} as {response}");
                }
            }
        }
    }
    tally.check(share::part(10_000));
}

/// A key without the names of its rows.
fn without_variant(key: &str) -> String {
    let line = |line: &str| {
        let mut cells = line.splitn(3, ',');
        let (row, _, rest) = (cells.next().unwrap(), cells.next(), cells.next().unwrap());
        format!("{row},{rest}")
    };
    key.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// What is written in a picture, not where it is drawn.
fn written_in(svg: &str) -> String {
    let written = svg.split("<text").skip(1).filter_map(|part| part.split("</text>").next());
    written.flat_map(|part| part.split('<').filter_map(|p| Some(p.split_once('>')?.1))).collect()
}

/// The numbers of a text, to four figures.
fn numbers_of(seen: &str) -> BTreeSet<String> {
    let number = |word: &str| word.trim_matches(['.', '-']).parse::<f64>().ok();
    let words = seen.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    words.filter_map(number).map(|x| format!("{x:.3e}")).collect()
}

/// Whether an answer is among these numbers. A number of one or two figures is everywhere.
fn is_told(answer: &str, numbers: &BTreeSet<String>) -> bool {
    let is_telling = answer.chars().filter(char::is_ascii_digit).count() > 2;
    is_telling && numbers.contains(&format!("{:.3e}", answer.parse::<f64>().unwrap().abs()))
}

/// The answers are in no text and no picture that a student sees first.
#[test]
fn no_answer_is_shown() {
    let folder = Folder::new("course-hidden");
    let (mut count, mut wrong) = (0, Vec::new());
    for question in questions(&made(&folder, &[SET])) {
        let (gaps, mut seen) = gaps(question.said("questiontext"));
        for file in question.one("questiontext").all("file") {
            seen += &written_in(&String::from_utf8(bytes(&file.text)).unwrap());
        }
        let numbers = numbers_of(&seen);
        for gap in gaps {
            count += 1;
            if is_told(&gap.options[0].text, &numbers) {
                wrong.push(format!("{}: {}", question.said("name"), gap.options[0].text));
            }
        }
    }
    assert!(count > 200, "{count}");
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn what_cannot_be_asked_is_left_out_and_named() {
    let bad = MIXED.replace("B_2, 90, 500", "B_2, 900, 500");
    let folder = Folder::new("course-left-out").with("a.mech", &bad).with("b.mech", "given r = 1 m\n");
    let said = assur(&folder, &["course", "moodle", "a.mech", "-o", "q.xml", "--pose", "1"]);
    assert_eq!(said.status, 1);
    assert!(said.stderr.contains("row 2, variant B_2"), "{}", said.stderr);
    assert_eq!(questions(&folder.read("q.xml")).len(), 1);
    let said = assur(&folder, &["course", "moodle", "b.mech", "-o", "none.xml"]);
    assert_eq!(said.status, 1, "{}", said.stderr);
    assert!(said.stderr.contains("mech::course::nothing_asked"), "{}", said.stderr);
    assert!(!folder.names().contains(&"none.xml".to_owned()));
    for (args, words) in [
        (&["--credit", "sign=0.37"][..], "not 0.37"),
        (&["--credit", "sign=0.9,unit=0.7"], "not 0.63"),
        (&["--points", "Mb=2"], "the key has no `Mb`"),
        (&["--steps", "9"], "write numbers from 0 to 8"),
    ] {
        let said =
            assur(&folder, &[&["course", "moodle", "a.mech", "--row", "1", "--pose", "1"], args].concat());
        assert_eq!((said.status, said.stdout.as_str()), (2, ""), "{args:?}");
        assert!(said.stderr.contains(words), "{args:?}: {}", said.stderr);
    }
    folder.write_bytes("many.mech", MIXED.replace("50 deg, 130", "10 deg, 50 deg, 130").as_bytes());
    let said = assur(&folder, &["course", "moodle", "many.mech", "--row", "1"]);
    assert!(said.status == 1 && said.stderr.contains("mech::course::too_many_gaps"), "{}", said.stderr);
}

/// The size follows from the first questions, so that a file too large is refused within seconds and leaves nothing.
#[test]
fn the_size_of_a_file_is_known_before_it_is_written() {
    let rows = |count: usize| {
        let rows: String = (0..count).map(|i| format!("  A{i}, {}, 600\n", 80.0 + i as f64 / 1e3)).collect();
        MIXED.replace("  A1, 80, 600\n  B_2, 90, 500\n", &rows)
    };
    let folder = Folder::new("course-size")
        .with("long.mech", &rows(9000))
        .with("large.mech", &rows(200))
        .with("q.xml", "q");
    let run = |args: &[&str]| assur(&folder, &[&["course", "moodle", "--pose", "1"], args].concat());
    for out in ["q.xml", "-"] {
        let said = run(&["long.mech", "-o", out]);
        assert_eq!((said.status, said.stdout.as_str()), (2, ""));
        let words = said.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains("the file of 9000 rows would have"), "{words}");
        assert!(words.contains("write `--steps none`, or `--picture none`, or at most"), "{words}");
        assert_eq!(folder.read("q.xml"), "q");
    }
    let said = run(&["long.mech", "--steps", "none", "--picture", "none", "-o", "q.xml"]);
    assert!(said.status == 2 && said.stderr.contains("write at most"), "{}", said.stderr);
    let said = run(&["large.mech", "-o", "q.xml"]);
    let size = folder.read("q.xml").len();
    assert!((20_000_000..50_000_000).contains(&size), "{size}");
    assert!(
        said.status == 0 && said.stderr.matches("the file of questions has").count() == 1,
        "{}",
        said.stderr
    );
    let near =
        [size - 1_000_000, size, size + 1_000_000].map(|s| format!("has {} MB", s.div_ceil(1_000_000)));
    assert!(near.iter().any(|near| said.stderr.contains(near)), "{size}: {}", said.stderr);
    assert_eq!(questions(&folder.read("q.xml")).len(), 200);
    assert_eq!(run(&["large.mech", "--row", "A3"]).stderr, "");
}

#[test]
fn a_problem_with_positions_has_a_heading_for_each() {
    let text = MIXED.replace("find reactions\n", "").replace("crank_angle = angle(crank) as rad, ", "");
    let folder = Folder::new("course-positions").with("a.mech", &text);
    let all =
        questions(&made(&folder, &["a.mech", "--row", "A1", "--credit", "sign=0.5", "--points", "M=1.5"]));
    let [question] = all.as_slice() else { panic!("one question") };
    let page = question.said("questiontext");
    assert!(
        page.contains("<h5>Position 1 (φ_1 = 50°)</h5>") && page.contains("<h5>Position 2 (φ_1 = 130°)</h5>"),
        "{page}"
    );
    let (gaps, _) = gaps(page);
    // five numbers at each of two positions, two of none; 1.5 points are 3 of 2
    assert_eq!(
        gaps.iter().map(|gap| gap.weight as u32).collect::<Vec<_>>(),
        [2, 2, 2, 3, 2, 2, 2, 2, 3, 2, 2, 2]
    );
    assert_eq!(gaps[3].hit(-gaps[3].options[0].answer).0, 50.0);
}

#[test]
fn a_text_of_the_author_is_no_gap_and_no_markup() {
    let text =
        MIXED.replace("// A crank turns.", "// A crank turns <b>fast</b> & {7:NM:=987654:13#ha} ]]> $$x$$.");
    let folder = Folder::new("course-markup").with("a.mech", &text);
    let page = made(&folder, &["a.mech", "--row", "A1", "--pose", "2"]);
    let all = questions(&page);
    let text = all[0].said("questiontext");
    assert!(text.contains("&lt;b&gt;fast&lt;/b&gt; &amp; &#123;7:NM:=987654:13#ha&#125; ]]&gt;"), "{text}");
    assert!(gaps(text).0.len() > 6);
}

#[test]
fn pixels_are_900_wide_or_refused() {
    let folder = Folder::new("course-pixels").with("a.mech", MIXED);
    let args =
        ["course", "moodle", "a.mech", "--row", "A1", "--pose", "1", "--steps", "none", "--picture", "png"];
    let said = assur(&folder, &args);
    if said.stderr.contains("no font for its letters") {
        // a machine without fonts
        return;
    }
    if cfg!(feature = "png") {
        assert_eq!((said.status, said.stderr.as_str()), (0, ""));
        let all = questions(&said.stdout);
        let file = all[0].one("questiontext").one("file");
        assert_eq!(file.attribute("name"), "a-A1.png");
        let png = bytes(&file.text);
        assert_eq!(&png[1..4], b"PNG");
        assert_eq!(u32::from_be_bytes(png[16..20].try_into().unwrap()), 900);
    } else {
        assert_eq!((said.status, said.stdout.as_str()), (2, ""));
        assert!(said.stderr.contains("mech::course::no_pixels"), "{}", said.stderr);
    }
}

#[test]
fn questions_are_kept() {
    let folder = Folder::new("course-kept")
        .with("week 3/slider.mech", include_str!("../../examples/exercise-set/18-v-groove.mech"));
    let args = ["week 3", "--row", "1", "--picture", "none", "--steps", "6"];
    insta::with_settings!({ snapshot_path => "course", prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("cloze", made(&folder, &args));
        insta::assert_snapshot!("numerical", made(&folder, &[&args[..], &["--one-per-answer", "--lang", "ru"]].concat()));
    });
}
