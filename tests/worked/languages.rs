//! Solutions in other languages: no sentence of another one, the letters of their courses, labels that stay apart.

use crate::drawn::faults;
use crate::examples::{Example, examples};
use assur::internals::handout::document;
use assur::internals::picture::{Kind, Options, Scene, draw};
use assur::internals::syntax::parse;
use assur::internals::worked::{Language, drawing_in, html};
use std::collections::BTreeSet;
use std::process::Command;

/// The page of an example as the program writes it.
fn page(name: &str, language: &str) -> String {
    let path = format!("{}/examples/{name}", env!("CARGO_MANIFEST_DIR"));
    let words = ["report", &path, "--lang", language, "--format", "html"];
    let out = Command::new(env!("CARGO_BIN_EXE_assur")).args(words).output().expect("the program runs");
    String::from_utf8_lossy(&out.stdout).into_owned()
}

/// The texts of a page, formulas and rules of style aside.
fn texts(page: &str) -> Vec<String> {
    let mut page = page.to_owned();
    for (open, close) in [("<style", "</style>"), ("<math", "</math>")] {
        while let Some(at) = page.find(open) {
            let end = page[at..].find(close).map_or(page.len(), |end| at + end + close.len());
            page.replace_range(at..end, " ");
        }
    }
    page.split('<')
        .filter_map(|part| Some(part.split_once('>')?.1.trim().to_owned()))
        .filter(|t| !t.is_empty())
        .collect()
}

fn words(text: &str) -> Vec<&str> {
    text.split(|c: char| !c.is_ascii_alphabetic()).filter(|w| w.len() >= 3).collect()
}

/// Words that all languages have: units, functions of the language of files and names that it makes.
const COMMON: [&str; 24] = [
    "rad",
    "deg",
    "rpm",
    "min",
    "max",
    "red",
    "effort",
    "barrel",
    "rod",
    "RRR",
    "RRP",
    "RPR",
    "RPP",
    "PRP",
    "PPR",
    "assur",
    "solve",
    "grade",
    "find",
    "reactions",
    "III",
    "VII",
    "ground",
    "alpha",
];

#[test]
fn no_sentence_is_of_another_language() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for Example { name, text: file, solved } in examples() {
        let Some((source, solved)) = solved else { continue };
        let (read, _) = parse(source);
        let own: BTreeSet<&str> = words(file).into_iter().chain(COMMON).collect();
        // an index of two links has both their names
        let is_own = |w: &&str| {
            own.contains(*w) || (1..w.len()).any(|i| own.contains(&w[..i]) && own.contains(&w[i..]))
        };
        for language in [Language::Chinese, Language::Russian] {
            let Ok(page) = document(source, &read, solved, language, (None, &[])) else { continue };
            let (page, language) = (html(&page), language.code());
            count += 1;
            for text in texts(&page) {
                let foreign: Vec<&str> = words(&text).into_iter().filter(|w| !is_own(w)).collect();
                let sentence = foreign.iter().filter(|w| w.chars().all(|c| c.is_ascii_lowercase())).count();
                if sentence > 1 || sentence == 1 && text.trim() == foreign[0] {
                    wrong.push(format!("{name}, {language}: {text}"));
                }
                let strange = |c: char| match language {
                    "zh" => ('а'..='я').contains(&c),
                    _ => ('一'..='龥').contains(&c),
                };
                if text.chars().any(|c| strange(c) && !file.contains(c)) {
                    wrong.push(format!("{name}, {language}: {text}"));
                }
            }
        }
    }
    println!("{count} pages");
    assert!(count > 380, "{count}");
    assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(40)]);
}

#[test]
fn pictures_have_the_letters_of_the_course() {
    let chinese = page("kinetostatics/six-bar.mech", "zh");
    assert!(chinese.contains("aria-label=\"F_R12\"") && !chinese.contains("aria-label=\"R_12\""));
    let russian = page("kinetostatics/six-bar.mech", "ru");
    assert!(russian.contains("aria-label=\"F_и2\"") && !russian.contains("aria-label=\"F_I2\""));
    let places = russian.split("<text").skip(1).filter_map(|t| t.split("</text>").next());
    let decimals = |t: &&str| {
        let shown: String = t.split('<').filter_map(|part| Some(part.split_once('>')?.1)).collect();
        shown.as_bytes().windows(3).any(|w| w[0].is_ascii_digit() && w[1] == b'.' && w[2].is_ascii_digit())
    };
    assert_eq!(places.filter(decimals).collect::<Vec<_>>(), Vec::<&str>::new());
}

#[test]
fn labels_are_apart_and_words_are_of_the_language() {
    const PICTURES: [Kind; 9] = [
        Kind::Scheme,
        Kind::Velocities,
        Kind::Accelerations,
        Kind::Forces,
        Kind::Lever,
        Kind::Plot,
        Kind::Work,
        Kind::Cam,
        Kind::Train,
    ];
    let (mut wrong, mut count) = (Vec::new(), 0);
    for Example { name, text, solved } in examples() {
        let Some((source, solved)) = solved else { continue };
        let own: BTreeSet<&str> = words(text).into_iter().chain(words(name)).chain(COMMON).collect();
        let file = (source.name.as_str(), source.text.as_str());
        let Ok(scene) = Scene::of(solved.compiled.model(), &solved.solution, file, None) else { continue };
        for kind in PICTURES {
            for drawing in draw(kind, &scene, &Options::default()).unwrap_or_default() {
                for language in [Language::Chinese, Language::Russian] {
                    count += 1;
                    let sheet = drawing_in(language, scene.mechanism(), drawing.clone()).placed();
                    let said = format!("{} {}", sheet.drawing.title, sheet.drawing.description);
                    // an index of inertia, or of a pair, stands before the name of a link, and M before it where a pair
                    // of forces stands for the couple
                    let is_own = |w: &&str| {
                        let bare = w.strip_prefix('M').unwrap_or(w);
                        let is_name = |w: &str| own.contains(w) || w.len() < 3;
                        own.contains(w)
                            || w.get(1..).is_some_and(is_name)
                            || bare.get(1..).is_some_and(is_name)
                    };
                    let foreign: Vec<&str> = words(&said).into_iter().filter(|w| !is_own(w)).collect();
                    if !foreign.is_empty() {
                        wrong.push(format!("{name}, {}: {foreign:?} in {said}", kind.name()));
                    }
                    wrong.extend(
                        faults(&sheet).iter().map(|fault| format!("{name}, {}: {fault}", kind.name())),
                    );
                }
            }
        }
    }
    println!("{count} pictures");
    assert!(count > 2000, "{count}");
    assert!(wrong.is_empty(), "{} {:#?}", wrong.len(), &wrong[..wrong.len().min(20)]);
}

/// The rows of a file of sentences: section, key, text.
fn rows(name: &str) -> Vec<(String, String, String)> {
    let path = format!("{}/crates/assur-worked/messages/{name}.txt", env!("CARGO_MANIFEST_DIR"));
    let mut section = String::new();
    let mut rows = Vec::new();
    for line in std::fs::read_to_string(path).expect("a file of sentences").lines() {
        if let Some(name) = line.strip_prefix('[') {
            section = name.trim_end_matches(']').to_owned();
        } else if !line.starts_with('#') && !line.is_empty() {
            let (key, text) =
                line.split_once(" | ").unwrap_or_else(|| panic!("{name}: `{line}` has no text"));
            rows.push((section.clone(), key.to_owned(), text.to_owned()));
        }
    }
    rows
}

/// The places of a text, in order.
fn places(text: &str) -> Vec<&str> {
    let mut all: Vec<&str> =
        text.split('{').skip(1).filter_map(|part| Some(part.split_once('}')?.0)).collect();
    all.sort_unstable();
    all.dedup();
    if all == [""] { text.matches("{}").collect() } else { all }
}

#[test]
fn every_language_has_every_sentence_with_its_parts() {
    let by_english = ["phrases", "pictures", "titles", "items"];
    // their keys are those of tables
    let by_data = ["functions", "labels", "given", "given subjects", "given words"];
    let [english, chinese, russian] = ["en", "zh", "ru"].map(rows);
    let keys = |rows: &[(String, String, String)]| -> Vec<(String, String)> {
        rows.iter().map(|(section, key, _)| (section.clone(), key.clone())).collect()
    };
    assert_eq!(keys(&chinese), keys(&russian));
    let of_keys = |rows: &[(String, String)]| -> Vec<(String, String)> {
        rows.iter().filter(|row| !by_english.contains(&row.0.as_str())).cloned().collect()
    };
    assert_eq!(keys(&english), of_keys(&keys(&chinese)));
    assert_eq!(keys(&chinese).iter().collect::<BTreeSet<_>>().len(), chinese.len(), "a key stands twice");
    for ((section, key, chinese), (_, _, russian)) in chinese.iter().zip(&russian) {
        let english = english.iter().find(|row| (&row.0, &row.1) == (section, key)).map_or(key, |row| &row.2);
        assert_eq!(places(english), places(chinese), "{key}: {chinese}");
        assert_eq!(places(english), places(russian), "{key}: {russian}");
    }
    // what the program names is there, and nothing else
    let path = format!("{}/crates/assur-worked/src/words/message.rs", env!("CARGO_MANIFEST_DIR"));
    let code = std::fs::read_to_string(path).expect("the keys");
    let mut named = BTreeSet::new();
    for part in code.split(" of \"").skip(1) {
        let (section, rest) = part.split_once("\" {").expect("keys");
        let (keys, _) = rest.split_once('}').expect("keys");
        named.extend(keys.split_whitespace().map(|key| (section.to_owned(), key.to_owned())));
    }
    let written: BTreeSet<_> =
        keys(&english).into_iter().filter(|k| !by_data.contains(&k.0.as_str())).collect();
    assert_eq!(named, written);
}
