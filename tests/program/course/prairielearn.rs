//! `assur course prairielearn`: the files of a question, and its `server.py` by plain Python against `grade`.

use super::{
    CREDIT, KeyRow, MIXED, Random, SET, Said, Tally, Unknown, answer, is_told, key_rows, marked, moodle,
    numbers_of, others, without_variant, written_in,
};
use crate::run::{Folder, assur};
use crate::share;
use assur::internals::exercise::grade::Sheet;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::{Command, Stdio};

const HARNESS: &str = include_str!("harness.py");
/// Units in the words of pint, by their kinds, with their sizes.
const UNITS: [&[(&str, f64)]; 9] = [
    &[("newton", 1.0), ("kilonewton", 1e3), ("decanewton", 10.0), ("gram * meter / second ** 2", 1e-3)],
    &[("newton * meter", 1.0), ("kilonewton * millimeter", 1.0), ("joule", 1.0), ("meter * newton", 1.0)],
    &[("meter / second", 1.0), ("kilometer / hour", 1.0 / 3.6), ("millimeter / second", 1e-3)],
    &[("meter / second ** 2", 1.0), ("centimeter / second ** 2", 1e-2), ("newton / kilogram", 1.0)],
    &[("radian / second", 1.0), ("revolutions_per_minute", std::f64::consts::PI / 30.0), ("/ second", 1.0)],
    &[("radian / second ** 2", 1.0), ("degree / second ** 2", std::f64::consts::PI / 180.0)],
    &[("kilogram", 1.0), ("gram", 1e-3), ("metric_ton", 1e3)],
    &[("kilogram * meter ** 2", 1.0), ("centimeter ** 2 * gram", 1e-7)],
    &[("meter", 1.0), ("millimeter", 1e-3), ("watt", 1.0), ("kilowatt", 1e3)],
];

/// What a question answers to a request; nothing without Python.
fn asked(folder: &str, request: &Value) -> Option<Value> {
    let mut python = Command::new("python3");
    let python = python.args(["-B", "-c", HARNESS]).current_dir(folder);
    let child = python.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = match child {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            eprintln!("python3 is not installed: left out");
            return None;
        }
        child => child.unwrap(),
    };
    child.stdin.take().unwrap().write_all(request.to_string().as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{folder}: {}", String::from_utf8_lossy(&output.stderr));
    Some(serde_json::from_slice(&output.stdout).unwrap())
}

fn made(folder: &Folder, args: &[&str]) {
    let said = assur(folder, &[&["course", "prairielearn", "-o", "q"], args].concat());
    assert_eq!((said.status, said.stderr.as_str()), (0, ""), "{args:?}");
}

/// The names of a folder, sorted.
fn names(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap().flatten();
    let mut names: Vec<String> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// All files below a folder.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(rest, bytes)| (format!("{name}/{rest}"), bytes)));
        } else {
            found.insert(name, std::fs::read(path).unwrap());
        }
    }
    found
}

/// As an answer is named on a page.
fn plain(name: &str) -> String {
    name.replace(|c: char| !c.is_ascii_alphanumeric(), "_").trim_matches('_').to_owned()
}

#[test]
fn a_question_has_its_files() {
    let folder = Folder::new("pl-files").with("set/mixed.mech", MIXED);
    made(&folder, &["set", "--pose", "1"]);
    let info: Value = serde_json::from_str(&folder.read("q/mixed/info.json")).unwrap();
    let keys: Vec<&str> = info.as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(keys, ["singleVariant", "tags", "title", "topic", "type", "uuid"]);
    assert_eq!(
        (&info["type"], &info["topic"], &info["singleVariant"]),
        (&json!("v3"), &json!("set"), &json!(false))
    );
    let uuid = info["uuid"].as_str().unwrap();
    // `uuid.uuid5(uuid.NAMESPACE_URL, "assur:course/set/mixed")` of Python
    assert_eq!(uuid, "81028f50-4b52-51a2-a477-fc35ed582d68");
    assert_eq!(
        names(&folder.path("q/mixed")),
        ["clientFilesQuestion", "info.json", "question.html", "server.py", "solutions"]
    );
    assert_eq!(names(&folder.path("q/mixed/clientFilesQuestion")), ["1-1.svg", "2-1.svg"]);
    let page = folder.read("q/mixed/question.html");
    assert!(
        page.contains("<pl-figure file-name=\"{{params.picture_1}}\"")
            && page.contains("{{{params.solution}}}")
    );
    assert!(!page.contains("allow-blank"));
    let outside = page.split("</pl-question-panel>").nth(1).unwrap();
    let inputs: BTreeSet<&str> =
        outside.split("answers-name=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let Some(all) = asked(&folder.path("q/mixed"), &json!("rows")) else { return };
    let answers: BTreeSet<&str> = all[1].as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(inputs, answers);
    assert!(answers.contains("th") && answers.contains("v_x") && answers.len() > 10, "{answers:?}");
    for (name, kind) in all[1].as_object().unwrap() {
        let element = if kind[0] == "" { "pl-number-input" } else { "pl-units-input" };
        assert!(page.contains(&format!("<{element} answers-name=\"{name}\"")), "{name}: {kind}");
    }
}

#[test]
fn a_thousand_seeds_give_every_row() {
    let folder = Folder::new("pl-seeds").with("a.mech", MIXED);
    made(&folder, &["a.mech", "--pose", "1"]);
    let Some(all) = asked(&folder.path("q/a"), &json!(1000)) else { return };
    let variants = all.as_array().unwrap();
    assert_eq!(variants.len(), 1000);
    let kinds: BTreeSet<String> = variants.iter().map(Value::to_string).collect();
    assert_eq!(kinds.len(), 2);
    assert!(variants.iter().zip(&variants[2..]).all(|(one, next)| one == next), "a seed has the same row");
    let page = folder.read("q/a/question.html");
    for [params, answers] in variants[..2].iter().map(|one| [&one[0], &one[1]]) {
        let solution = params["solution"].as_str().unwrap();
        assert!(solution.contains("<h4>") && solution.contains("src=\"data:image/svg+xml;base64,"));
        assert!(!solution.contains("{{") && !solution.contains("\"@"), "braces would be read once more");
        let picture = params["picture_1"].as_str().unwrap();
        assert!(folder.read(&format!("q/a/clientFilesQuestion/{picture}")).starts_with("<svg"));
        let used = page.split("{{{params.").skip(1).filter_map(|rest| rest.split('}').next());
        used.for_each(|name| assert!(params[name].is_string(), "{name}"));
        let torque = answers["M"].as_str().unwrap();
        assert!(torque.ends_with(" newton * meter"), "{torque}");
        assert!(answers["th"].is_number(), "an angle is a plain number");
    }
}

/// The same bytes by one thread and by two, and over what is there; nothing of others is replaced.
#[test]
fn an_export_comes_again_as_it_was() {
    let folder = Folder::new("pl-again").with("set/a.mech", MIXED);
    made(&folder, &["set", "--pose", "1", "--threads", "1"]);
    let once = files(Path::new(&folder.path("q")));
    folder.write_bytes("q/a/clientFilesQuestion/old.svg", b"old");
    made(&folder, &["set", "--pose", "1", "--threads", "2"]);
    assert_eq!(once, files(Path::new(&folder.path("q"))));
    let refused = || {
        let said = assur(&folder, &["course", "prairielearn", "set", "--pose", "1", "-o", "q"]);
        assert!(said.status == 2 && said.stderr.contains("is not replaced"), "{}", said.stderr);
    };
    folder.write_bytes("q/a/a.mech", MIXED.as_bytes());
    refused();
    assert_eq!(folder.read("q/a/a.mech"), MIXED);
    std::fs::remove_file(folder.path("q/a/a.mech")).unwrap();
    folder.write_bytes("q/a/info.json", b"{}");
    refused();
    assert_eq!(folder.read("q/a/info.json"), "{}");
    assert_eq!(names(&folder.path("q")), ["a"]);
}

#[test]
fn what_cannot_be_a_variant_is_left_out_and_named() {
    let bad = MIXED.replace("B_2, 90, 500", "B_2, 900, 500");
    let folder = Folder::new("pl-left-out").with("a.mech", &bad).with("b.mech", "given r = 1 m\n");
    let run = |args: &[&str]| assur(&folder, &[&["course", "prairielearn"], args].concat());
    let said = run(&["a.mech", "-o", "q", "--pose", "1"]);
    assert!(said.status == 1 && said.stderr.contains("row 2, variant B_2"), "{}", said.stderr);
    assert!(folder.read("q/a/info.json").contains("\"singleVariant\": true"));
    for (args, status, words) in [
        (&["b.mech", "-o", "none"][..], 1, "mech::course::nothing_asked"),
        (&["a.mech"], 2, "no folder is named"),
        (&["a.mech", "-o", "none", "--one-per-answer"], 2, "is an option of Moodle"),
        (&["a.mech", "-o", "a.mech"], 2, "is both an input and the output"),
        (&["a.mech", "-o", "none", "--points", "Mb=2"], 2, "the key has no `Mb`"),
    ] {
        let said = run(args);
        assert_eq!(said.status, status, "{args:?}: {}", said.stderr);
        assert!(said.stderr.contains(words), "{args:?}: {}", said.stderr);
    }
    assert!(!folder.names().contains(&"none".to_owned()));
}

/// A table that is too long is refused before any row is solved.
#[test]
fn a_table_has_at_most_500_rows() {
    let row = |i: usize| format!("  R{i}, 80, {}\n", 500 + i);
    let long = MIXED.replace("  A1, 80, 600\n", &(0..500).map(row).collect::<String>());
    let folder = Folder::new("pl-long").with("a.mech", &long);
    let run =
        |args: &[&str]| assur(&folder, &[&["course", "prairielearn", "a.mech", "-o", "q"], args].concat());
    let said = run(&["--pose", "1"]);
    assert_eq!((said.status, folder.names().contains(&"q".to_owned())), (2, false));
    assert!(
        said.stderr.contains("the question of `a` has 501 rows, and 500 are the most"),
        "{}",
        said.stderr
    );
    let said = run(&["--pose", "1", "--row", "R3", "--row", "B_2"]);
    assert_eq!((said.status, said.stderr.as_str()), (0, ""));
}

/// The answers of a variant are in no text and no picture that a student sees first, nor in a file that a student can fetch.
#[test]
fn no_answer_is_shown() {
    let folder = Folder::new("pl-hidden");
    made(&folder, &[SET]);
    let (mut count, mut wrong) = (0, Vec::new());
    for name in names(&folder.path("q")) {
        let Some(all) = asked(&folder.path(&format!("q/{name}")), &json!("rows")) else { return };
        let page = folder.read(&format!("q/{name}/question.html"));
        let panel = page.split("<pl-answer-panel>").next().unwrap();
        for row in all[0].as_array().unwrap() {
            let mut seen = panel.to_owned();
            for (param, value) in row["params"].as_object().unwrap() {
                let Some(text) = value.as_str() else { continue };
                seen += "\n";
                seen += &if param.starts_with("picture_") {
                    written_in(&folder.read(&format!("q/{name}/clientFilesQuestion/{text}")))
                } else {
                    text.to_owned()
                };
            }
            let numbers = numbers_of(&seen);
            for (answer, of) in row["answers"].as_object().unwrap() {
                count += 1;
                let right = of[0].as_str().map_or_else(|| of[0].to_string(), str::to_owned);
                if is_told(right.split(' ').next().unwrap(), &numbers) {
                    wrong.push(format!("{name}, {answer}: {right}"));
                }
            }
        }
    }
    assert!(count > 200, "{count}");
    assert_eq!(wrong, Vec::<String>::new());
}

/// PrairieLearn has every part of a mark, and weights.
#[test]
fn parts_and_points_are_those_of_the_options() {
    let folder = Folder::new("pl-parts").with("a.mech", MIXED);
    made(&folder, &["a.mech", "--pose", "1", "--credit", "sign=0.37", "--points", "M=1.5", "--lang", "ru"]);
    let Some(all) = asked(&folder.path("q/a"), &json!("rows")) else { return };
    assert_eq!((&all[1]["M"][1], &all[1]["th"][1]), (&json!(3), &json!(2)));
    let right = all[0][0]["answers"]["M"][1][0][0].as_f64().unwrap();
    let own = "newton * meter";
    let request = json!([[0, "M", -right, own, 1.0, own], [0, "M", right, own, 1.0, own]]);
    let said = asked(&folder.path("q/a"), &request).unwrap();
    assert_eq!((&said[0][0], &said[1][0]), (&json!(0.37), &json!(1.0)));
}

/// A question for each position, with a heading; every name on the page is another.
#[test]
fn positions_have_answers_of_their_own() {
    let text = MIXED.replace("find reactions\n", "").replace("crank_angle = angle(crank) as rad, ", "");
    let folder = Folder::new("pl-positions").with("a.mech", &text);
    made(&folder, &["a.mech"]);
    let page = folder.read("q/a/question.html");
    assert!(page.contains("answers-name=\"M_at_1\"") && page.contains("answers-name=\"M_at_2\""), "{page}");
    assert!(page.contains("<h5>Position 2 (φ_1 = 130°)</h5>"), "{page}");
}

/// An interval as the reader of Moodle's files has it.
fn options(intervals: &Value) -> Vec<moodle::Option> {
    let of = |it: &Value| moodle::Option {
        fraction: 0.0,
        answer: it[0].as_f64().unwrap(),
        text: String::new(),
        tolerance: it[1].as_f64().unwrap(),
        words: String::new(),
    };
    intervals.as_array().unwrap().iter().map(of).collect()
}

/// A number for an answer, and a request for it with another unit.
fn request(random: &mut Random, (seed, name, own): (usize, &str, &str), x: f64) -> Value {
    let group = UNITS.iter().find(|group| group.iter().any(|(unit, _)| *unit == own));
    let Some(group) = group else { return json!([seed, name, x, own, 1.0, own]) };
    let size = group.iter().find(|(unit, _)| *unit == own).unwrap().1;
    // lengths and powers are in one list
    let kind = |unit: &str| unit.contains("watt");
    let fitting: Vec<(&str, f64)> =
        group.iter().copied().filter(|(unit, _)| group.len() < 4 || kind(unit) == kind(own)).collect();
    let (other, its) = random.of(&fitting);
    json!([seed, name, x, own, its / size, other])
}

/// Random answers get from `server.py` the words and the part of the mark that they get from `grade`.
#[test]
fn verdicts_are_those_of_grade() {
    let count = share::part(60);
    let mut random = Random(11);
    let mut tally = Tally::default();
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    let all = std::fs::read_dir(SET).unwrap().flatten().map(|entry| entry.path());
    let mut problems: Vec<(String, String)> = all
        .filter(|path| path.extension().is_some_and(|e| e == "mech"))
        .map(|path| {
            (path.file_stem().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(path).unwrap())
        })
        .collect();
    problems.sort();
    problems.push(("mixed".to_owned(), MIXED.to_owned()));
    for (name, text) in &problems {
        let file = format!("{name}.mech");
        let folder = Folder::new("pl-verdicts").with(&file, text);
        let batch = assur(&folder, &["batch", &file, "--key", "key.csv", "--out", "all.csv"]);
        assert_eq!(batch.status, 0, "{}", batch.stderr);
        let key = folder.read("key.csv");
        let key = if name == "mixed" { without_variant(&key) } else { key.replace(",variant", ",name") };
        let sheet = Sheet::read("key.csv", key.as_bytes(), None).unwrap().unwrap();
        let keys = key_rows(&key);
        let several = keys[0].names[1].is_empty() && keys.iter().any(|row| !row.names[1].is_empty());
        let pose = keys.iter().map(|row| row.names[1].as_str()).max().unwrap();
        let keys: Vec<&KeyRow> = keys.iter().filter(|row| row.names[1] == pose).collect();
        let at: &[&str] = if pose.is_empty() { &[] } else { &["--pose", pose] };
        let args = [file.as_str(), "--steps", "none", "--picture", "none", "--credit", CREDIT];
        made(&folder, &[&args, at].concat());
        let home = folder.path(&format!("q/{name}"));
        let Some(baked) = asked(&home, &json!("rows")) else { return };
        let rows = baked[0].as_array().unwrap();
        assert_eq!(rows.len(), keys.len(), "{name}");
        let (mut requests, mut marks) = (Vec::new(), Vec::new());
        for ((i, row), key) in rows.iter().enumerate().zip(&keys) {
            for (asked, it) in row["answers"].as_object().unwrap() {
                let own = baked[1][asked][0].as_str().unwrap();
                let Some((quantity, unit, value)) =
                    key.numbers.iter().find(|(name, ..)| plain(name) == *asked)
                else {
                    // it needs no position
                    assert!(several, "{asked} is in the key");
                    continue;
                };
                *kinds.entry(unit.clone()).or_default() += 1;
                let header = if unit.is_empty() { quantity.clone() } else { format!("{quantity} [{unit}]") };
                let others = others(key, quantity, unit);
                for _ in 0..count {
                    let x = answer(&mut random, *value, &others, unit == "deg", &options(&it[1]));
                    if x.abs() > 1e15 || x != 0.0 && x.abs() < 1e-15 {
                        continue;
                    }
                    let line = format!("{},{pose},{x:e}", key.names[0]);
                    let mark = marked(&sheet, &format!("row,pose,\"{header}\""), &line)[quantity].clone();
                    let seed = i + rows.len() * (random.next() * 9.0) as usize;
                    requests.push(request(&mut random, (seed, asked, own), x));
                    marks.push((
                        mark,
                        Unknown::of(x, *value, unit, &options(&it[1])),
                        format!("{name}, {asked}, key {value}: {x}"),
                    ));
                }
            }
        }
        let said = asked(&home, &Value::Array(requests)).unwrap();
        for (said, (mark, unknown, at)) in said.as_array().unwrap().iter().zip(&marks) {
            if said.is_null() {
                continue;
            }
            let part = said[0].as_f64().unwrap();
            let words = if part == 1.0 { "" } else { said[1].as_str().unwrap() };
            let said: Said = (100.0 * part, words.to_owned());
            tally.add(&said, mark, *unknown, at);
        }
    }
    println!("units {kinds:?}");
    tally.check(share::part(10_000));
}
