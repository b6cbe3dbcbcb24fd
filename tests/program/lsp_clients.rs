//! The language server: what a client wants, and what it is told.

use crate::lsp::{URI, document, notify, range, request};
use crate::lsp_answers::{ENGINE, ask};
use assur::internals::lsp::Server;
use serde_json::{Value, json};

/// A session with a client that says this of itself, and what was published of a text.
fn session(text: &str, initialize: &Value) -> (Server, Value, Vec<Value>) {
    let mut server = Server::default();
    let result = request(&mut server, "initialize", initialize)["result"].clone();
    let opened = json!({ "uri": URI, "languageId": "mech", "version": 1, "text": text });
    notify(&mut server, "textDocument/didOpen", &json!({ "textDocument": opened }));
    let published = server.publish();
    (server, result, published)
}

fn methods(messages: &[Value]) -> Vec<&str> {
    messages.iter().filter_map(|message| message["method"].as_str()).collect()
}

#[test]
fn a_client_that_asks_for_diagnostics_is_not_told_them() {
    let pulls = json!({ "textDocument": { "diagnostic": {} }, "workspace": { "diagnostics": { "refreshSupport": true } } });
    let (mut server, result, published) = session(ENGINE, &json!({ "capabilities": pulls }));
    assert_eq!(result["capabilities"]["diagnosticProvider"]["interFileDependencies"], false);
    assert!(published.is_empty(), "{published:?}");
    let first = ask(&mut server, "diagnostic", &json!({}));
    assert_eq!((&first["kind"], &first["items"]), (&json!("full"), &json!([])));
    assert_eq!(methods(&server.solve(&|| None)), ["workspace/diagnostic/refresh"]);
    let solved = ask(&mut server, "diagnostic", &json!({}));
    assert_eq!(solved["items"][0]["code"], "mech::expect::mismatch");
    notify(&mut server, "textDocument/didClose", &json!({ "textDocument": document() }));
    // one that could not be told of new ones is told all of them
    let (mut server, result, published) =
        session(ENGINE, &json!({ "capabilities": { "textDocument": { "diagnostic": {} } } }));
    assert_eq!(result["capabilities"]["diagnosticProvider"], Value::Null);
    assert_eq!(methods(&published), ["textDocument/publishDiagnostics"]);
    assert_eq!(methods(&server.solve(&|| None)), ["textDocument/publishDiagnostics"]);
}

#[test]
fn a_client_that_asks_for_it_is_told_what_is_solved() {
    let sweep = ENGINE.replace("45 deg at", "0 deg .. 90 deg in 3 steps at").replace("expect", "// expect");
    let (mut server, ..) =
        session(&sweep, &json!({ "capabilities": {}, "initializationOptions": { "solved": true } }));
    let said = server.solve(&|| None);
    assert_eq!(methods(&said), ["textDocument/publishDiagnostics", "assur/solved"]);
    assert_eq!(said[1]["params"], json!({ "uri": URI, "version": 1, "poses": 4 }));
    assert!(server.solve(&|| None).is_empty(), "once");
    let picture = request(&mut server, "assur/picture", &json!({ "uri": URI }));
    assert_eq!(picture["result"]["poses"].as_array().map(Vec::len), Some(4));
    let (mut server, ..) = session(&sweep, &json!({ "capabilities": {} }));
    assert_eq!(methods(&server.solve(&|| None)), ["textDocument/publishDiagnostics"]);
}

#[test]
fn kinds_of_hints_are_switched_off() {
    let everything = json!({ "range": range((0, 0), (19, 0)) });
    let labels = |server: &mut Server| {
        let hints = ask(server, "inlayHint", &everything);
        let all =
            hints.as_array().expect("hints").iter().map(|h| h["label"].as_str().expect("a text").to_owned());
        all.collect::<Vec<_>>()
    };
    let refresh = json!({ "workspace": { "inlayHint": { "refreshSupport": true } } });
    let without = json!({ "hints": { "structure": false, "values": false } });
    let (mut server, ..) =
        session(ENGINE, &json!({ "capabilities": refresh, "initializationOptions": without }));
    server.solve(&|| None);
    assert_eq!(labels(&mut server), ["✓", "✗ 472.519 N*m"]);
    let settings = json!({ "settings": { "assur": { "hints": { "outcomes": false } } } });
    let said = server.handle(
        &json!({ "jsonrpc": "2.0", "method": "workspace/didChangeConfiguration", "params": settings }),
    );
    assert_eq!(methods(&said), ["workspace/inlayHint/refresh"]);
    let left = labels(&mut server);
    assert!(left.len() == 5 && left[0].starts_with("F = 1"), "{left:?}");
}

#[test]
fn what_nothing_depends_on_is_faded() {
    let text = ENGINE.replace("at n\n", "at 1500 rpm\n");
    let (_, _, published) = session(&text, &json!({ "capabilities": {} }));
    assert_eq!(published[0]["params"]["diagnostics"], json!([]), "this client would show it as others");
    let fades = json!({ "textDocument": { "publishDiagnostics": { "tagSupport": { "valueSet": [1, 2] } } } });
    let (_, _, published) = session(&text, &json!({ "capabilities": fades }));
    let all = published[0]["params"]["diagnostics"].as_array().expect("diagnostics").clone();
    assert_eq!(all.len(), 1, "{all:?}");
    assert_eq!(all[0]["message"], "nothing depends on `n`");
    assert_eq!((&all[0]["severity"], &all[0]["tags"]), (&json!(4), &json!([1])));
    assert_eq!(all[0]["range"], range((3, 6), (3, 7)));
}

#[test]
fn a_table_is_tested_once() {
    let text = format!(
        "{}expect Mb = key\nvariants {{\n  r [mm], key [N*m]\n  100, 472.5\n  100, 400\n}}\n",
        ENGINE.split("expect").next().expect("a text")
    );
    let refresh = json!({ "workspace": { "codeLens": { "refreshSupport": true } } });
    let (mut server, ..) = session(&text, &json!({ "capabilities": refresh }));
    let title = |server: &mut Server| {
        let lenses = ask(server, "codeLens", &json!({}));
        lenses.as_array().and_then(|all| all.last()).expect("a lens")["command"]["title"].clone()
    };
    assert_eq!(title(&mut server), "test 2 rows");
    let run = json!({ "command": "assur.test", "arguments": [URI] });
    let said = server
        .handle(&json!({ "jsonrpc": "2.0", "id": 1, "method": "workspace/executeCommand", "params": run }));
    assert_eq!(said[0]["result"], "2 rows, 1 fail");
    assert_eq!(methods(&said[1..]), ["window/showMessage", "workspace/codeLens/refresh"]);
    assert_eq!(title(&mut server), "2 rows, 1 fail");
}
