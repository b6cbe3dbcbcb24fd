//! What the server can do.

use super::client::Client;
use crate::editor::TOKEN_COLOURS;
use assur_text::source::Encoding;
use serde_json::{Value, json};

/// The command that shows a text in the browser.
pub const PREVIEW: &str = "assur.preview";
/// The commands behind code lenses.
pub const SOLVE: &str = "assur.solve";
pub const TEST: &str = "assur.test";
/// The command that shows the page of a code.
pub const EXPLAIN: &str = "assur.explain";

/// The result of `initialize`.
pub fn result(client: Client) -> Value {
    let encoding = match client.encoding {
        Encoding::Utf8 => "utf-8",
        Encoding::Utf16 => "utf-16",
    };
    const INCREMENTAL: u32 = 2;
    let mut result = json!({
        "capabilities": {
            "positionEncoding": encoding,
            "textDocumentSync": { "openClose": true, "change": INCREMENTAL },
            "codeActionProvider": { "codeActionKinds": ["quickfix", "refactor.extract", "refactor.rewrite", "source.fixAll"] },
            "codeLensProvider": {},
            "completionProvider": { "triggerCharacters": [".", ":", "(", " "] },
            "definitionProvider": true,
            "documentFormattingProvider": true,
            "documentHighlightProvider": true,
            "documentOnTypeFormattingProvider": { "firstTriggerCharacter": "}", "moreTriggerCharacter": ["\n"] },
            "documentRangeFormattingProvider": true,
            "documentSymbolProvider": true,
            "executeCommandProvider": { "commands": [SOLVE, TEST, PREVIEW, EXPLAIN] },
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
    });
    if client.pulls {
        let alone =
            json!({ "identifier": "assur", "interFileDependencies": false, "workspaceDiagnostics": false });
        result["capabilities"]["diagnosticProvider"] = alone;
    }
    result
}
