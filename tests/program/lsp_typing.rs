//! The language server while a text is typed: what stays, what is offered, what is put in order.

use crate::lsp::{URI, applied, notify, range};
use crate::lsp_answers::{ENGINE, ask, at, solved};
use assur::internals::lsp::Server;
use serde_json::{Value, json};

/// Types a text at a place.
fn typed(server: &mut Server, line: u32, character: u32, text: &str) {
    let change = json!({ "range": range((line, character), (line, character)), "text": text });
    let of = json!({ "uri": URI, "version": 2 });
    notify(server, "textDocument/didChange", &json!({ "textDocument": of, "contentChanges": [change] }));
    server.publish();
    server.solve(&|| None);
}

fn hints(server: &mut Server) -> Vec<(u64, String)> {
    let all = ask(server, "inlayHint", &json!({ "range": range((0, 0), (19, 0)) }));
    let hint = |hint: &Value| {
        let line = hint["position"]["line"].as_u64().expect("a line");
        (line, hint["label"].as_str().expect("a text").to_owned())
    };
    all.as_array().expect("hints").iter().map(hint).collect()
}

#[test]
fn hints_stay_while_a_line_does_not_read() {
    let (mut server, _) = solved(ENGINE);
    let before = hints(&mut server);
    assert_eq!(before.len(), 7);
    // a line before the answers
    typed(&mut server, 9, 0, "revolute \n");
    let moved = before.iter().map(|(line, label)| (if *line < 9 { *line } else { line + 1 }, label.clone()));
    assert_eq!(hints(&mut server), moved.collect::<Vec<_>>());
    // the line that is typed has none
    typed(&mut server, 17, 5, "+");
    let lines = hints(&mut server).into_iter().map(|(line, _)| line).collect::<Vec<_>>();
    assert_eq!(lines, [1, 4, 18, 19]);
}

#[test]
fn the_answer_is_offered_while_its_line_is_typed() {
    let (mut server, _) = solved(ENGINE);
    typed(&mut server, 17, 0, "expect Mb \n");
    let offered = ask(&mut server, "completion", &at(17, 10));
    let mut labels = offered.as_array().expect("completions").iter().map(|one| one["label"].clone());
    assert!(labels.any(|label| label == "= 472.519 N*m"), "{offered}");
}

#[test]
fn a_key_puts_what_it_ends_in_order() {
    let ended = |text: &str, line: u32, character: u32, key: &str| {
        let (mut server, _) = solved(text);
        let mut more = at(line, character);
        more["ch"] = key.into();
        more["options"] = json!({ "tabSize": 2, "insertSpaces": true });
        let edits = ask(&mut server, "onTypeFormatting", &more);
        applied(text, &edits)
    };
    assert_eq!(ended("given  r=1 m\ngiven  n=2\n\n", 2, 0, "\n"), "given  r=1 m\ngiven n = 2\n\n");
    assert_eq!(ended("given  r=1 m\n", 0, 5, "\n"), "given  r=1 m\n", "there is no line before");
    let braces = "given  r=1 m\nlink rod {\n A (0,0)\nB (1 m,0)\n}\ngiven  n=2\n";
    let closed = "given  r=1 m\nlink rod {\n  A (0, 0)\n  B (1 m, 0)\n}\ngiven  n=2\n";
    assert_eq!(ended(braces, 4, 1, "}"), closed);
    assert_eq!(ended("given  r=1 m\nlink {\n", 2, 0, "\n"), "given  r=1 m\nlink {\n", "it does not read");
}
