//! What the server can do.

use crate::editor::TOKEN_COLOURS;
use assur_text::source::Encoding;
use serde_json::{Value, json};

/// The command that shows a text in the browser.
pub const PREVIEW: &str = "assur.preview";
/// The commands behind code lenses.
pub const SOLVE: &str = "assur.solve";
pub const TEST: &str = "assur.test";

/// The result of `initialize`.
pub fn result(encoding: Encoding) -> Value {
    let encoding = match encoding {
        Encoding::Utf8 => "utf-8",
        Encoding::Utf16 => "utf-16",
    };
    const INCREMENTAL: u32 = 2;
    json!({
        "capabilities": {
            "positionEncoding": encoding,
            "textDocumentSync": { "openClose": true, "change": INCREMENTAL },
            "codeActionProvider": { "codeActionKinds": ["quickfix", "refactor.extract", "refactor.rewrite", "source.fixAll"] },
            "codeLensProvider": {},
            "completionProvider": { "triggerCharacters": [".", ":", "(", " "] },
            "definitionProvider": true,
            "documentFormattingProvider": true,
            "documentHighlightProvider": true,
            "documentRangeFormattingProvider": true,
            "documentSymbolProvider": true,
            "executeCommandProvider": { "commands": [SOLVE, TEST, PREVIEW] },
            "foldingRangeProvider": true,
            "hoverProvider": true,
            "inlayHintProvider": true,
            "referencesProvider": true,
            "renameProvider": { "prepareProvider": true },
            "selectionRangeProvider": true,
            "semanticTokensProvider": {
                "legend": { "tokenTypes": TOKEN_COLOURS, "tokenModifiers": ["declaration"] },
                "full": { "delta": true },
            },
            "signatureHelpProvider": { "triggerCharacters": ["(", ","] },
            "workspaceSymbolProvider": true,
        },
        "serverInfo": { "name": "assur", "version": env!("CARGO_PKG_VERSION") },
    })
}

/// What the client asks for again when a text is solved.
#[derive(Clone, Copy, Debug, Default)]
pub struct Refreshes {
    hints: bool,
    lenses: bool,
}

impl Refreshes {
    /// Those that a client offers in its `initialize`.
    pub fn of(params: &Value) -> Self {
        let offers = |what: &str| {
            let path = format!("/capabilities/workspace/{what}/refreshSupport");
            params.pointer(&path).and_then(Value::as_bool).unwrap_or_default()
        };
        Self { hints: offers("inlayHint"), lenses: offers("codeLens") }
    }

    /// The request for hints alone.
    pub fn hints_again(self) -> Vec<Value> {
        Self { lenses: false, ..self }.requests()
    }

    /// The requests to the client.
    pub fn requests(self) -> Vec<Value> {
        let all = [(self.hints, "workspace/inlayHint/refresh"), (self.lenses, "workspace/codeLens/refresh")];
        let asked = all.into_iter().filter(|(offered, _)| *offered);
        asked.map(|(_, method)| json!({ "jsonrpc": "2.0", "id": method, "method": method })).collect()
    }
}
