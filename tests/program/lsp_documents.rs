//! Our own requests about a solved text: the motion, pictures, answers as tables, files.

use crate::lsp::{URI, request, session};
use crate::lsp_answers::ENGINE;
use crate::run::{Folder, assur};
use assur::internals::lsp::Server;
use serde_json::{Value, json};

fn solved(text: &str) -> Server {
    let (mut server, ..) = session(text, "utf-16");
    server.solve(&|| None);
    server
}

fn ask(server: &mut Server, method: &str, more: &Value) -> Value {
    let mut params = json!({ "uri": URI });
    params.as_object_mut().expect("params").extend(more.as_object().expect("params").clone());
    request(server, method, &params)
}

fn sweep() -> String {
    ENGINE.replace("45 deg at", "0 deg .. 90 deg in 3 steps at").replace("expect", "// expect")
}

#[test]
fn a_motion_has_markup_data_and_declarations() {
    let mut server = solved(&sweep());
    let answer = ask(&mut server, "assur/motion", &json!({ "language": "ru" }))["result"].clone();
    assert_eq!((&answer["version"], &answer["motion"]["decimal"]), (&1.into(), &",".into()));
    let markup = answer["markup"].as_str().expect("markup");
    for part in ["<svg ", "class=\"motion-slider\"", "пуск или пауза", "class=\"motion-values\""]
    {
        assert!(markup.contains(part), "{part}");
    }
    assert!(answer["declared"].as_array().is_some_and(|all| all.iter().any(|one| one["name"] == "crank")));
    let kinds = |answer: &Value| {
        let all = answer["motion"]["arrows"].as_array().expect("arrows");
        all.iter().map(|one| one["kind"].as_str().expect("a kind").to_owned()).collect::<Vec<_>>()
    };
    let shown = ask(&mut server, "assur/motion", &json!({ "show": "velocities" }))["result"].clone();
    assert_eq!(shown["motion"]["shown"], "velocities");
    assert!(kinds(&shown).contains(&"velocities".to_owned()));
    // what cannot be shown has its reason
    let text = "mech 1\nground { A (0, 0) }\nlink crank A-B 100 mm\nrevolute A: ground - crank\n\
                drive crank = 0 deg .. 90 deg in 3 steps\nfind position(B)\n";
    let mut still = solved(text);
    let missing = ask(&mut still, "assur/motion", &json!({ "show": "velocities" }));
    assert!(
        missing["error"]["message"].as_str().is_some_and(|said| said.contains("speed")),
        "{:?}",
        missing["error"]
    );
    let unknown = ask(&mut server, "assur/motion", &json!({ "show": "jerks" }));
    assert!(unknown["error"]["message"].as_str().is_some_and(|said| said.contains("`velocities`")));
}

#[test]
fn a_part_of_the_way_is_a_position() {
    let mut server = solved(&sweep());
    let at = |server: &mut Server, part: f64| {
        let answer = ask(server, "assur/picture", &json!({ "part": part }));
        answer["result"]["svg"].as_str().expect("a picture").to_owned()
    };
    let (first, last) = (at(&mut server, 0.0), at(&mut server, 1.0));
    let named = ask(&mut server, "assur/picture", &json!({ "pose": "4" }));
    assert!(first != last && named["result"]["svg"] == last.as_str());
    assert_eq!(at(&mut server, 1e300), last, "beyond the end");
}

#[test]
fn answers_are_tables_and_pictures_are_of_the_kinds_there_are() {
    let mut server = solved(&sweep());
    let report = ask(&mut server, "assur/report", &json!({}))["result"].clone();
    assert_eq!(report["version"], 1);
    let blocks = report["sections"].as_array().expect("sections").iter();
    let tables: Vec<&Value> = blocks.flat_map(|s| s["blocks"].as_array().expect("blocks")).collect();
    let table = tables.iter().find_map(|block| block.get("table")).expect("a table");
    assert_eq!(table["columns"][0]["align"], "left");
    let kinds = ask(&mut server, "assur/kinds", &json!({}))["result"]["kinds"].clone();
    let kinds: Vec<String> = serde_json::from_value(kinds).expect("kinds");
    assert!(kinds.contains(&"scheme".to_owned()) && kinds.contains(&"velocities".to_owned()), "{kinds:?}");
    assert!(!kinds.contains(&"train".to_owned()) && !kinds.contains(&"animation".to_owned()), "{kinds:?}");
    for kind in &kinds {
        let drawn = ask(&mut server, "assur/draw", &json!({ "kind": kind, "theme": "light", "part": 0.5 }));
        let all = drawn["result"]["svg"].as_array().expect("pictures");
        assert!(
            !all.is_empty() && all.iter().all(|svg| svg.as_str().is_some_and(|s| s.starts_with("<svg ")))
        );
    }
    let wrong = ask(&mut server, "assur/draw", &json!({ "kind": "schem" }));
    assert!(wrong["error"]["message"].as_str().is_some_and(|said| said.contains("did you mean `scheme`?")));
    let wrong = ask(&mut server, "assur/draw", &json!({ "kind": "train" }));
    assert!(wrong["error"]["message"].as_str().is_some_and(|said| !said.is_empty()));
}

#[test]
fn files_are_those_of_the_program() {
    let table = include_str!("../../examples/variants/crank-slider.mech");
    for text in [sweep().as_str(), table, "mech 1\nlink"] {
        let mut server = solved(text);
        let name = URI.rsplit('/').next().expect("a name");
        let folder = Folder::new("lsp-documents").with(name, text);
        let line = |said: &str| said.replace(&format!("\"file\":\"{URI}\""), &format!("\"file\":\"{name}\""));
        let json = ask(&mut server, "assur/write", &json!({ "what": "solution.json" }))["result"].clone();
        assert_eq!(json["type"], "application/json");
        let out = assur(&folder, &["solve", name, "--format", "json"]);
        assert_eq!(line(json["text"].as_str().expect("text")), out.stdout);
        let csv = ask(&mut server, "assur/write", &json!({ "what": "poses.csv" }))["result"].clone();
        let out = assur(&folder, &["solve", name, "--format", "csv"]);
        assert_eq!(csv["text"], out.stdout);
        if text.ends_with("link") {
            let missing = ask(&mut server, "assur/write", &json!({ "what": "worked.html" }));
            assert!(missing["error"]["message"].as_str().is_some_and(|said| !said.is_empty()), "{missing}");
            continue;
        }
        for (what, args) in [("worked.html", vec!["report"]), ("sheet.html", vec!["report", "--sheet"])] {
            let file = ask(&mut server, "assur/write", &json!({ "what": what }))["result"].clone();
            let out = assur(&folder, &[args.as_slice(), &[name, "--format", "html"]].concat());
            assert_eq!(file["text"], out.stdout, "{what}");
        }
        let page = ask(&mut server, "assur/write", &json!({ "what": "motion.html" }))["result"].clone();
        assert!(page["text"].as_str().is_some_and(|page| page.starts_with("<!doctype html>")));
        assert!(page["name"].as_str().is_some_and(|name| name.ends_with("-motion.html")));
    }
    let mut server = solved(&sweep());
    let wrong = ask(&mut server, "assur/write", &json!({ "what": "a.pdf" }));
    assert!(wrong["error"]["message"].as_str().is_some_and(|said| said.contains("`worked.html`")));
}

#[test]
fn a_text_that_is_not_solved_has_a_sentence() {
    let (mut server, ..) = session(&sweep(), "utf-16");
    for method in ["assur/motion", "assur/report", "assur/kinds", "assur/picture"] {
        let answer = ask(&mut server, method, &json!({}));
        assert_eq!(answer["error"]["message"], "the text is not solved", "{method}");
    }
}

/// The lines of each step lead to the next one, in every language and in any order of writing; the last is solved.
#[test]
fn the_lines_of_the_tutorial_lead_through_it() {
    let titles = |language: &str, text: &str| {
        let answer = ask(&mut solved(text), "assur/tutorial", &json!({ "language": language }));
        let steps = answer["result"]["steps"].as_array().expect("steps").clone();
        (steps, answer["result"]["at"].clone())
    };
    for language in ["en", "ru", "zh"] {
        let mut text = String::new();
        for at in 0..6 {
            let (steps, now) = titles(language, &text);
            assert_eq!((steps.len(), &now), (6, &at.into()), "{language}: {text}");
            let done = steps.iter().filter(|step| step["done"] == true).count();
            assert_eq!(done, at, "{text}");
            text += steps[at]["example"].as_str().expect("lines");
            text.push('\n');
        }
        assert_eq!(titles(language, &text).1, 6, "{text}");
        let mut server = solved(&text);
        let report = ask(&mut server, "assur/report", &json!({}))["result"].to_string();
        assert!(report.contains("\"M [N*m]\"") || report.contains("M ["), "{report}");
    }
    let (steps, at) = titles("en", "drive crank = 1 deg at 1 rpm\n");
    assert_eq!((&at, &steps[3]["done"]), (&0.into(), &true.into()), "written before its turn");
    let wrong = ask(&mut solved(""), "assur/tutorial", &json!({ "language": "la" }));
    assert!(wrong["error"]["message"].as_str().is_some_and(|said| said.contains("`la`")));
}
