//! Messages of an editor, in any order and with anything in them: the language server answers, and never with an error of its own.
//!
//! `fuzz/run.sh 1000000 3600 messages`

#![no_main]

use assur::internals::lsp::{Server, Stop};
use libfuzzer_sys::fuzz_target;
use serde_json::{Value, json};
use std::sync::atomic::{AtomicUsize, Ordering};

const URI: &str = "untitled:fuzz";
/// Asked of a place.
const METHODS: [&str; 20] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/references",
    "textDocument/rename",
    "textDocument/prepareRename",
    "textDocument/documentHighlight",
    "textDocument/signatureHelp",
    "textDocument/codeAction",
    "textDocument/inlayHint",
    "textDocument/formatting",
    "textDocument/semanticTokens/full",
    "textDocument/selectionRange",
    "textDocument/onTypeFormatting",
    "textDocument/rangeFormatting",
    "textDocument/diagnostic",
    "textDocument/codeLens",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "assur/picture",
    "assur/motion",
    "assur/report",
    "assur/kinds",
    "assur/draw",
    "assur/write",
    "assur/tutorial",
];
/// Positions after which a text takes too long.
const POSITIONS: usize = 40;

fn session(text: &str) -> Server {
    let mut server = Server::default();
    server.handle(&json!({ "jsonrpc": "2.0", "id": 0, "method": "initialize", "params": { "capabilities": {} } }));
    let opened = json!({ "uri": URI, "languageId": "mech", "version": 1, "text": text });
    server.handle(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": opened } }));
    server
}

/// A line of the input as a message: JSON as it is, else a change or a question by its first letters.
fn message(line: &str, version: usize) -> Value {
    if let Ok(message) = serde_json::from_str(line) {
        return message;
    }
    let mut letters = line.chars().map(u32::from);
    let mut next = || letters.next().unwrap_or_default() % 64;
    let (which, line_at, column, lines, columns) = (next(), next(), next(), next() % 4, next());
    let start = json!({ "line": line_at, "character": column });
    let range = json!({ "start": start, "end": { "line": line_at + lines, "character": columns } });
    let document = json!({ "uri": URI, "version": version });
    match METHODS.get(which as usize / 2) {
        Some(method) => json!({ "id": version, "method": method, "params": {
            "textDocument": document, "uri": URI, "ch": "}", "position": start, "positions": [start], "range": range, "newName": "x",
            "context": { "diagnostics": [], "includeDeclaration": true }, "options": { "tabSize": 2, "insertSpaces": true },
        } }),
        None => {
            let text = line.chars().skip(5).collect::<String>();
            let change = json!({ "range": range, "text": text });
            json!({ "method": "textDocument/didChange", "params": { "textDocument": document, "contentChanges": [change] } })
        }
    }
}

fuzz_target!(|input: &str| {
    let (text, lines) = input.split_once("\n\n").unwrap_or((input, ""));
    let mut server = session(text);
    server.publish();
    for (version, line) in lines.lines().take(32).enumerate() {
        let message = message(line, version + 2);
        let answers = server.handle(&message);
        for answer in &answers {
            assert_ne!(answer["error"]["code"], -32603, "{message}");
        }
        for diagnostics in server.publish() {
            assert!(diagnostics["params"]["diagnostics"].is_array());
        }
        if version % 4 == 1 {
            let asked = AtomicUsize::new(0);
            let patience = || (asked.fetch_add(1, Ordering::Relaxed) > POSITIONS).then_some(Stop::Never);
            let said = server.solve(&patience);
            assert!(said.iter().all(|one| one["method"] != "window/logMessage"), "{said:?}");
        }
    }
});
