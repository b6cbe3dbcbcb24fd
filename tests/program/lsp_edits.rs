//! The language server after very many edits: what it says is what a fresh start says, and an error of its own ends nothing.

use crate::lsp::{URI, document, notify, range, request, session};
use crate::lsp_answers::drop_kept;
use assur::internals::lsp::{Pages, Server, View};
use serde_json::{Value, json};

const SLIDER: &str = include_str!("../../examples/crank-slider.mech");
/// What is typed.
const PUT: [&str; 16] = [
    "",
    "\n",
    " ",
    "link",
    "φ",
    "{",
    "}",
    "mm",
    "-",
    " rod",
    "find Mb\n",
    "given x = 5 mm\n",
    "crank",
    "//",
    "曲柄😀",
    "1",
];
/// Edits between two comparisons.
const EVERY: usize = 25;

/// How many edits there are: a thousand or a fifth, or as many as `ASSUR_EDITS` says.
fn edits() -> usize {
    std::env::var("ASSUR_EDITS").ok().and_then(|n| n.parse().ok()).unwrap_or_else(|| crate::share::part(1000))
}

/// A number that is not the last one.
fn next(state: &mut u64) -> usize {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    usize::try_from(*state >> 40).expect("24 bits")
}

/// All that is said of a text without a place.
fn state(server: &mut Server, version: i32) -> Value {
    let mut said = server.solve(&|| None);
    for message in &mut said {
        assert_eq!(message["params"]["version"], version);
        message["params"]["version"] = Value::Null;
    }
    let mut ask = |method: &str, more: Value| {
        let mut params = json!({ "textDocument": document(), "range": range((0, 0), (0, 0)) });
        params.as_object_mut().expect("an object").extend(more.as_object().expect("an object").clone());
        request(server, method, &params)["result"].clone()
    };
    let all = json!({ "range": range((0, 0), (5, 0)) });
    json!([
        said,
        ask("textDocument/inlayHint", all.clone()),
        ask("textDocument/codeLens", json!({})),
        ask("textDocument/semanticTokens/full", json!({}))["data"].clone(),
        ask("textDocument/documentSymbol", json!({})),
        ask("textDocument/foldingRange", json!({})),
        ask("textDocument/hover", json!({ "position": { "line": 3, "character": 3 } })),
        ask("textDocument/completion", json!({ "position": { "line": 2, "character": 1 } })),
    ])
}

#[test]
fn a_fresh_start_says_the_same() {
    let (mut server, _) = session(SLIDER, "utf-8");
    let (mut text, mut seed) = (SLIDER.to_owned(), 7);
    let mut undo: Vec<(usize, usize, String)> = Vec::new();
    for version in 2..i32::try_from(edits()).expect("a number of edits") + 2 {
        let (line, column, length, put) =
            (next(&mut seed), next(&mut seed), next(&mut seed) % 12, next(&mut seed));
        // the author takes most of it back
        let is_undone = !undo.is_empty() && (undo.len() > 8 || next(&mut seed) % 5 < 2);
        let (start, end, with) = match undo.pop_if(|_| is_undone) {
            Some(last) => last,
            None => {
                let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1));
                let starts = starts.collect::<Vec<_>>();
                let from = starts[line % starts.len()];
                let width = text[from..].find('\n').unwrap_or(text.len() - from);
                let start = text.floor_char_boundary(from + column % (width + 1));
                let end = text.ceil_char_boundary((start + length).min(text.len()));
                (start, end, PUT[put % PUT.len()].to_owned())
            }
        };
        let place = |byte: usize| {
            let line = text[..byte].matches('\n').count();
            json!({ "line": line, "character": byte - text[..byte].rfind('\n').map_or(0, |at| at + 1) })
        };
        let change = json!({ "range": { "start": place(start), "end": place(end) }, "text": with });
        let of = json!({ "uri": URI, "version": version });
        notify(
            &mut server,
            "textDocument/didChange",
            &json!({ "textDocument": of, "contentChanges": [change] }),
        );
        if !is_undone {
            undo.push((start, start + with.len(), text[start..end].to_owned()));
        }
        text.replace_range(start..end, &with);
        let published = server.publish();
        if usize::try_from(version).expect("not negative") % EVERY == 0 {
            let (mut fresh, first) = session(&text, "utf-8");
            assert_eq!(published[0]["params"]["diagnostics"], first[0]["params"]["diagnostics"], "{text}");
            let (mut seen, wanted) = (state(&mut server, version), state(&mut fresh, 1));
            if wanted[0] == json!([]) {
                drop_kept(&mut seen[1], &wanted[1]);
            }
            assert_eq!(seen.to_string(), wanted.to_string(), "{text}");
        }
    }
}

/// Pages that break whatever they do.
#[derive(Debug)]
struct Broken;

impl Pages for Broken {
    fn address(&mut self, _: &str) -> Result<Option<String>, String> {
        panic!("as this test wants it")
    }

    fn has(&self, _: &str) -> bool {
        true
    }

    fn mark(&mut self, _: &str, _: Option<(&'static str, String)>) {
        panic!("as this test wants it")
    }

    fn show(&mut self, _: &str, _: View) {}
}

#[test]
fn an_error_of_the_server_is_one_answer() {
    let mut server = Server::with_pages(Box::new(Broken));
    request(&mut server, "initialize", &json!({ "capabilities": {} }));
    let opened = json!({ "uri": URI, "languageId": "mech", "version": 1, "text": SLIDER });
    notify(&mut server, "textDocument/didOpen", &json!({ "textDocument": opened }));
    let place = json!({ "textDocument": document(), "position": { "line": 1, "character": 1 } });
    let preview = json!({ "command": "assur.preview", "arguments": [URI] });
    for (method, params) in
        [("workspace/executeCommand", &preview), ("textDocument/documentHighlight", &place)]
    {
        let message = json!({ "jsonrpc": "2.0", "id": 3, "method": method, "params": params });
        let said = server.handle(&message);
        assert_eq!(said[0]["error"]["code"], -32603, "{said:?}");
        assert_eq!(said[1]["method"], "window/logMessage");
        let logged = said[1]["params"]["message"].as_str().expect("a text");
        assert!(logged.starts_with(method) && logged.contains(env!("CARGO_PKG_VERSION")), "{logged}");
        assert!(logged.ends_with(SLIDER), "with the text: {logged}");
        assert!(
            request(&mut server, "textDocument/hover", &place)["error"].is_null(),
            "the next one is answered"
        );
    }
}
