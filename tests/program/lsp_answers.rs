//! The language server: what it says of a text that is solved, and while one is typed.

use crate::lsp::{URI, document, notify, range, request, session};
use assur::internals::lsp::{Server, Stop};
use proptest::prelude::*;
use serde_json::{Value, json};

pub const ENGINE: &str = "\
mech 1
mechanism \"Engine\"
given r = 100 mm
given n = 1500 rpm
let l = 3.5*r
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod B-C l { S (117 mm, 0); mass 2.5 kg at S; inertia 0.0425 kg*m^2 }
link piston { C (0, 0); mass 2.14 kg at C }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 45 deg at n
assemble C ahead of B
balance torque Mb on crank
find Mb, v = velocity(C), reaction(B, rod)
expect Mb = 472.5 N*m
expect Mb = 400 N*m
";

/// A text that is solved, and what was said then.
pub fn solved(text: &str) -> (Server, Vec<Value>) {
    let (mut server, _) = session(text, "utf-16");
    let said = server.solve(&|| None);
    (server, said)
}

pub fn ask(server: &mut Server, method: &str, more: &Value) -> Value {
    let mut params = json!({ "textDocument": document() });
    if let (Some(params), Some(more)) = (params.as_object_mut(), more.as_object()) {
        params.extend(more.clone());
    }
    let answer = request(server, &format!("textDocument/{method}"), &params);
    assert!(answer["error"].is_null(), "{answer}");
    answer["result"].clone()
}

pub fn at(line: u32, character: u32) -> Value {
    json!({ "position": { "line": line, "character": character } })
}

pub fn hover(server: &mut Server, line: u32, character: u32) -> String {
    ask(server, "hover", &at(line, character))["contents"]["value"].as_str().unwrap_or_default().to_owned()
}

#[test]
fn names_are_explained_with_their_values() {
    let (mut server, _) = solved(ENGINE);
    let rod = hover(&mut server, 10, 21);
    for part in
        ["link rod B-C l {", "points `B`, `C`, `S`", "mass 2.5 kg", "structural group rod, piston (II, RRP)"]
    {
        assert!(rod.contains(part), "{part} in {rod}");
    }
    let hinge = hover(&mut server, 10, 9);
    for part in [
        "revolute B: crank - rod",
        "a pin: two links turn on each other; joins `crank` and `rod`",
        "`reaction(B, rod)` = (",
        "`position(rod.B)`",
    ] {
        assert!(hinge.contains(part), "{part} in {hinge}");
    }
    assert!(hover(&mut server, 4, 12).ends_with("`r` = 100 mm"));
    assert!(hover(&mut server, 7, 13).ends_with("`l` = 350 mm"));
    assert!(hover(&mut server, 16, 5).ends_with("`Mb` = 472.519 N*m"), "{}", hover(&mut server, 16, 5));
    // a sweep has a range
    let sweep = ENGINE.replace("45 deg at", "0 deg .. 90 deg in 3 steps at").replace("expect", "// expect");
    let (mut server, _) = solved(&sweep);
    let range = hover(&mut server, 16, 5);
    assert!(range.contains(" … ") && range.ends_with("N*m"), "{range}");
}

#[test]
fn hints_show_structure_values_and_outcomes() {
    let (mut server, said) = solved(ENGINE);
    let failed = said[0]["params"]["diagnostics"].to_string();
    assert!(failed.contains("mech::expect::mismatch"), "{failed}");
    let everything = json!({ "range": range((0, 0), (19, 0)) });
    let hints = ask(&mut server, "inlayHint", &everything);
    let labels = hints.as_array().expect("hints").iter().map(|h| h["label"].as_str().expect("a text"));
    let labels = labels.collect::<Vec<_>>();
    assert_eq!(labels[0], "F = 1 · crank (I, driven) · rod, piston (II, RRP)");
    assert_eq!(labels[1], "= 350 mm");
    assert_eq!(labels[2], "= 472.519 N*m");
    assert!(labels[3].starts_with("= (") && labels[3].ends_with("m/s"), "{labels:?}");
    assert_eq!(labels[5..], ["✓", "✗ 472.519 N*m"]);
    let lenses = ask(&mut server, "codeLens", &json!({}));
    let titles = lenses.as_array().expect("lenses").iter().map(|l| l["command"]["title"].clone());
    assert_eq!(titles.collect::<Vec<_>>(), ["solve", "1 of 2 expectations fail", "picture"]);
    let mut execute = |command: &str| {
        let params = json!({ "command": command, "arguments": [URI] });
        let message =
            json!({ "jsonrpc": "2.0", "id": 1, "method": "workspace/executeCommand", "params": params });
        let said = server.handle(&message);
        assert_eq!(said[0]["result"], said[1]["params"]["message"], "returned and shown");
        said[0]["result"].as_str().map(str::to_owned)
    };
    assert!(execute("assur.solve").is_some_and(|page| page.contains("Mb") && page.contains("472.519")));
    assert_eq!(execute("assur.test").as_deref(), Some("1 of 2 expectations fail"));
}

#[test]
fn positions_that_cannot_be_are_reported() {
    let (_, said) =
        solved(&ENGINE.replace("let l = 3.5*r", "let l = 0.5*r").replace("45 deg at", "90 deg at"));
    let found = said[0]["params"]["diagnostics"].to_string();
    assert!(found.contains("mech::assembly::") && found.contains("help:"), "{found}");
}

#[test]
fn solving_waits_for_messages() {
    let (mut server, _) = session(ENGINE, "utf-16");
    let everything = json!({ "range": range((0, 0), (19, 0)) });
    let count = |server: &mut Server| ask(server, "inlayHint", &everything).as_array().map(Vec::len);
    assert!(server.solve(&|| Some(Stop::Later)).is_empty());
    assert_eq!(count(&mut server), Some(2), "structure and a constant need no solution");
    assert_eq!(server.solve(&|| None).len(), 1, "it is solved later");
    assert_eq!(count(&mut server), Some(7));
    assert!(server.solve(&|| None).is_empty(), "once");
    // a newer text has no answers yet; one that takes too long gets none
    let change =
        json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "text": ENGINE }] });
    notify(&mut server, "textDocument/didChange", &change);
    assert_eq!(count(&mut server), Some(7), "those of the text before");
    assert!(server.solve(&|| Some(Stop::Never)).is_empty());
    assert_eq!((server.solve(&|| None).len(), count(&mut server)), (0, Some(7)));
}

/// What a client sees of a text: diagnostics, and everything that is shown without a cursor.
fn shown(server: &mut Server, diagnostics: &Value, lines: u32) -> Value {
    let everything = json!({ "range": range((0, 0), (lines - 1, 0)) });
    let whole = json!({});
    json!({
        "diagnostics": diagnostics,
        "hints": ask(server, "inlayHint", &everything),
        "lenses": ask(server, "codeLens", &whole),
        "tokens": ask(server, "semanticTokens/full", &whole),
        "symbols": ask(server, "documentSymbol", &whole),
    })
}

/// Drops hints that a text without answers has from an earlier one.
pub fn drop_kept(seen: &mut Value, own: &Value) {
    let is_own = |hint: &Value| own.as_array().is_some_and(|own| own.contains(hint));
    seen.as_array_mut().expect("hints").retain(is_own);
}

/// Solves what is left, and gives the last diagnostics, and whether there are answers.
fn settled(server: &mut Server, published: &[Value]) -> (Value, bool) {
    let solved = server.solve(&|| None);
    let last = published
        .iter()
        .chain(&solved)
        .rev()
        .find(|said| said["method"] == "textDocument/publishDiagnostics");
    (last.map_or(Value::Null, |said| said["params"]["diagnostics"].clone()), !solved.is_empty())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(crate::share::part(60)) })]

    /// After any edits, with or without time to solve between them, a client sees what a fresh start shows of the text; hints that an
    /// unchanged line keeps while there are no answers are more.
    #[test]
    fn no_history_is_seen_in_answers(edits in prop::collection::vec((2..19_u32, 0..30_u32, 0..4_u32, 0..8_usize, 0..3_u8), 1..12)) {
        const PUT: [&str; 8] = ["", "1", " ", "B", "crank", "\n", "deg", "φ"];
        let (mut server, _) = session(ENGINE, "utf-16");
        let mut text = ENGINE.to_owned();
        let mut published = Vec::new();
        for (version, (line, column, length, put, time)) in edits.into_iter().enumerate() {
            let lines = text.lines().collect::<Vec<_>>();
            let Some(written) = lines.get(line as usize) else { continue };
            let count = u32::try_from(written.chars().count()).expect("short");
            let (from, to) = (column.min(count), (column + length).min(count));
            let change = json!({ "range": range((line, from), (line, to)), "text": PUT[put] });
            let version = json!({ "uri": URI, "version": version + 2 });
            notify(&mut server, "textDocument/didChange", &json!({ "textDocument": version, "contentChanges": [change] }));
            let cut = |n: u32| written.chars().take(n as usize).map(char::len_utf8).sum::<usize>();
            let start = lines[..line as usize].iter().map(|l| l.len() + 1).sum::<usize>();
            text.replace_range(start + cut(from)..start + cut(to), PUT[put]);
            match time {
                0 => {}
                1 => published = server.publish(),
                _ => {
                    published = server.publish();
                    server.solve(&|| if put % 2 == 0 { Some(Stop::Later) } else { None });
                }
            }
        }
        published.extend(server.publish());
        // solved already, or not: a change without effect makes it new
        let version = json!({ "uri": URI, "version": 99 });
        notify(&mut server, "textDocument/didChange", &json!({ "textDocument": version, "contentChanges": [] }));
        published.extend(server.publish());
        let (seen, _) = settled(&mut server, &published);
        let (mut fresh, published) = session(&text, "utf-16");
        let (wanted, is_solved) = settled(&mut fresh, &published);
        let lines = u32::try_from(text.lines().count()).expect("few");
        let (mut seen, wanted) = (shown(&mut server, &seen, lines), shown(&mut fresh, &wanted, lines));
        if !is_solved {
            drop_kept(&mut seen["hints"], &wanted["hints"]);
        }
        prop_assert_eq!(seen, wanted, "{}", text);
    }
}

/// The labels that are offered at `|`.
pub fn offered(text: &str) -> Vec<String> {
    let before = text.split('|').next().expect("a text");
    let line = u32::try_from(before.lines().count() - 1).expect("few lines");
    let column = before.lines().last().map_or(0, |line| line.encode_utf16().count());
    let (mut server, _) = solved(&text.replace('|', ""));
    let items = ask(&mut server, "completion", &at(line, u32::try_from(column).expect("short")));
    let items = items.as_array().expect("completions").iter();
    items.map(|item| item["label"].as_str().expect("a label").to_owned()).collect()
}

#[test]
fn completions_fit_their_places() {
    let machine = ENGINE.split("find").next().expect("a text");
    let at_end = |line: &str| offered(&format!("{machine}{line}"));
    let has = |all: &[String], one: &str| all.iter().any(|label| label == one);
    let begin = at_end("l|");
    assert!(has(&begin, "link") && has(&begin, "revolute") && !has(&begin, "velocity"), "{begin:?}");
    assert_eq!(at_end("find velocity(rod.|"), ["B", "C", "S"]);
    let links = at_end("revolute E: |");
    assert!(has(&links, "crank") && has(&links, "ground") && !has(&links, "Mb"), "{links:?}");
    assert!(has(&at_end("revolute E: crank - |"), "rod"));
    assert!(has(&at_end("torque M on |"), "crank"));
    assert_eq!(at_end("force P on rod at |")[..3], ["B", "C", "S"]);
    let members = at_end("link bar { m|");
    assert!(has(&members, "mass") && !has(&members, "drive"), "{members:?}");
    let properties = at_end("spring k: rod.B - ground.A { s|");
    assert!(has(&properties, "stiffness") && !has(&properties, "mass"), "{properties:?}");
    let units = at_end("spring k: rod.B - ground.A { stiffness 4 |");
    assert!(has(&units, "N/m") && !has(&units, "kg"), "{units:?}");
    let values = at_end("let x = |");
    assert!(has(&values, "r") && has(&values, "velocity") && has(&values, "sqrt"), "{values:?}");
    let pairs = at_end("find reaction(|");
    assert!(has(&pairs, "B") && !has(&pairs, "Mb"), "{pairs:?}");
    let answer = offered(
        &ENGINE.replace("expect Mb = 400 N*m\n", "").replace("expect Mb = 472.5", "expect Mb | = 472.5"),
    );
    assert!(has(&answer, "= 472.519 N*m"), "{answer:?}");
    assert!(at_end("// l|").is_empty());
    let (mut server, _) = session("rev", "utf-16");
    let items = ask(&mut server, "completion", &at(0, 3));
    let hinge = items.as_array().expect("completions").iter().find(|item| item["label"] == "revolute");
    let hinge = hinge.expect("a hinge");
    assert_eq!(
        hinge["textEdit"],
        json!({ "range": range((0, 0), (0, 3)), "newText": "revolute ${1:B}: ${2:crank} - ${3:rod}" })
    );
}

#[test]
fn arguments_are_explained() {
    let (mut server, _) = session("find reaction(B, rod)\n", "utf-16");
    let help = ask(&mut server, "signatureHelp", &at(0, 17));
    assert_eq!(help["activeParameter"], 1);
    let label = help["signatures"][0]["label"].as_str().expect("a label");
    assert!(label.starts_with("reaction("), "{help}");
    assert_eq!(ask(&mut server, "signatureHelp", &at(0, 3)), Value::Null);
}

#[test]
fn parts_of_a_text_are_coloured_and_chosen() {
    let (mut server, _) = session("given φ = 5 mm\nlink a A-B φ { mass 2 kg at A }\n", "utf-16");
    let data = ask(&mut server, "semanticTokens/full", &json!({}))["data"].clone();
    let data = data.as_array().expect("numbers").iter().map(|n| n.as_u64().expect("one")).collect::<Vec<_>>();
    // given, φ where it is declared, 5, mm
    assert_eq!(data[..20], [0, 0, 5, 0, 0, 0, 6, 1, 7, 1, 0, 4, 1, 1, 0, 0, 2, 2, 4, 0]);
    let positions = json!({ "positions": [{ "line": 1, "character": 15 }] });
    let chain = ask(&mut server, "selectionRange", &positions)[0].clone();
    let mut ranges = Vec::new();
    let mut one = &chain;
    while !one.is_null() {
        ranges.push(one["range"].clone());
        one = &one["parent"];
    }
    let wanted = [
        range((1, 15), (1, 19)),
        range((1, 14), (1, 30)),
        range((1, 13), (1, 31)),
        range((1, 0), (1, 31)),
        range((0, 0), (2, 0)),
    ];
    assert_eq!(ranges, wanted);
    let found = request(&mut server, "workspace/symbol", &json!({ "query": "A" }))["result"].clone();
    let names =
        found.as_array().expect("symbols").iter().map(|s| (s["name"].clone(), s["containerName"].clone()));
    assert_eq!(names.collect::<Vec<_>>(), [(json!("a"), Value::Null), (json!("A"), json!("a"))]);
}

/// The text with one of the changes that are offered at a place.
pub fn changed(text: &str, line: u32, character: u32, title: &str) -> String {
    let (mut server, _) = solved(text);
    let here = range((line, character), (line, character));
    let actions = ask(&mut server, "codeAction", &json!({ "range": here, "context": { "diagnostics": [] } }));
    let all = actions.as_array().expect("actions");
    let one =
        all.iter().find(|action| action["title"].as_str().is_some_and(|found| found.starts_with(title)));
    let one = one.unwrap_or_else(|| panic!("{title} in {actions}"));
    crate::lsp::applied(text, &one["edit"]["changes"][URI])
}

#[test]
fn a_name_is_declared_a_number_named_an_answer_kept() {
    let without = ENGINE.replace("given n = 1500 rpm\n", "");
    assert!(
        changed(&without, 12, 24, "declare `given n")
            .contains("given n = 1500 rpm\ndrive crank = 45 deg at n\n")
    );
    let without = ENGINE.replace("link crank A-B r\n", "");
    let declared = changed(&without, 8, 22, "declare `link crank");
    assert!(
        declared.contains("link crank { A (0, 0); B (100 mm, 0) }\nrevolute A: ground - crank\n"),
        "{declared}"
    );
    let named = changed(ENGINE, 13, 15, "declare `given value");
    assert!(named.contains("given value = 45 deg\ndrive crank = value at n\n"), "{named}");
    let kept = changed(ENGINE, 16, 5, "add `expect Mb");
    assert!(kept.contains("reaction(B, rod)\nexpect Mb = 472.519 N*m\n"), "{kept}");
    let (_, said) = solved(&kept.replace("expect Mb = 400 N*m\n", ""));
    assert_eq!(said[0]["params"]["diagnostics"], json!([]), "the answer meets what is expected");
}

#[test]
fn assemblies_are_offered() {
    let begun = ENGINE.replace("assemble C ahead of B", "assemble ");
    let (mut server, _) = session(&begun, "utf-16");
    let offered = ask(&mut server, "completion", &at(14, 9));
    let labels =
        offered.as_array().expect("completions").iter().map(|one| one["label"].as_str().expect("a text"));
    let labels = labels.collect::<Vec<_>>();
    assert_eq!(labels[..2], ["C ahead of B", "C behind B"], "{labels:?}");
}

#[test]
fn values_are_those_of_the_pose() {
    let sweep = ENGINE.replace("45 deg at", "0 deg .. 90 deg in 2 steps at").replace("expect", "// expect");
    let (mut server, _) = solved(&sweep);
    assert!(hover(&mut server, 16, 5).contains(" … "));
    notify(&mut server, "assur/pose", &json!({ "uri": URI, "part": 0.45 }));
    let middle = hover(&mut server, 16, 5);
    assert!(middle.contains("472.519 N*m") && middle.contains("(pose 2)"), "{middle}");
    notify(&mut server, "assur/pose", &json!({ "uri": URI, "part": null }));
    assert!(hover(&mut server, 16, 5).contains(" … "), "all of them again");
    let unknown =
        json!({ "jsonrpc": "2.0", "method": "assur/pose", "params": { "uri": "untitled:b", "part": 0 } });
    assert_eq!(server.handle(&unknown)[0]["method"], "window/logMessage");
}

#[test]
fn colours_are_sent_as_changes() {
    let (mut server, _) = session(ENGINE, "utf-16");
    let first = ask(&mut server, "semanticTokens/full", &json!({}));
    let mut data = first["data"].as_array().expect("numbers").clone();
    let longer = json!({ "range": range((2, 10), (2, 13)), "text": "1000" });
    let of = json!({ "uri": URI, "version": 2 });
    notify(&mut server, "textDocument/didChange", &json!({ "textDocument": of, "contentChanges": [longer] }));
    let delta =
        ask(&mut server, "semanticTokens/full/delta", &json!({ "previousResultId": first["resultId"] }));
    let number = |edit: &Value, key: &str| {
        usize::try_from(edit[key].as_u64().expect("a number")).expect("a small one")
    };
    let edits = delta["edits"].as_array().expect("edits");
    assert!(
        edits.len() == 1 && edits[0]["data"].as_array().is_some_and(|new| new.len() < data.len() / 2),
        "{delta}"
    );
    for edit in edits {
        let start = number(edit, "start");
        let new = edit["data"].as_array().expect("numbers").clone();
        data.splice(start..start + number(edit, "deleteCount"), new);
    }
    assert_eq!(Value::Array(data), ask(&mut server, "semanticTokens/full", &json!({}))["data"]);
    let unknown = ask(&mut server, "semanticTokens/full/delta", &json!({ "previousResultId": "0" }));
    assert!(unknown["data"].is_array(), "all of them");
}
