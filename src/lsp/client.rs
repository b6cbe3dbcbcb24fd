//! What a client says of itself: what it understands, and what it wants.

use crate::editor::{HintKind, TOKEN_COLOURS};
use assur_text::source::Encoding;
use serde_json::{Value, json};

#[derive(Clone, Copy, Debug, Default)]
pub struct Client {
    /// How it counts columns.
    pub encoding: Encoding,
    /// It asks for diagnostics, and takes a notice when there are new ones.
    pub pulls: bool,
    /// It shows faded what is not needed.
    pub fades: bool,
    pub shows_documents: bool,
    /// It takes a notice when a text is solved.
    pub hears_solved: bool,
    /// Hints that it does not want.
    without: Without,
    asks_again: AsksAgain,
}

/// Kinds of hints that are switched off.
#[derive(Clone, Copy, Debug, Default)]
struct Without {
    structure: bool,
    values: bool,
    outcomes: bool,
}

/// What it asks for again after a notice.
#[derive(Clone, Copy, Debug, Default)]
struct AsksAgain {
    hints: bool,
    lenses: bool,
}

/// Requests to ask again.
const DIAGNOSTICS: &str = "workspace/diagnostic/refresh";
const HINTS: &str = "workspace/inlayHint/refresh";
const LENSES: &str = "workspace/codeLens/refresh";

impl Client {
    /// That of an `initialize`.
    pub fn of(params: &Value) -> Self {
        let offers = |path: &str| params.pointer(path).and_then(Value::as_bool).unwrap_or_default();
        let encodings = params.pointer("/capabilities/general/positionEncodings").and_then(Value::as_array);
        let reads_bytes = encodings.is_some_and(|all| all.iter().any(|one| one == "utf-8"));
        let pulls = params.pointer("/capabilities/textDocument/diagnostic").is_some_and(Value::is_object);
        let options = params.get("initializationOptions").unwrap_or(&Value::Null);
        Self {
            encoding: if reads_bytes { Encoding::Utf8 } else { Encoding::Utf16 },
            // one without notices would show what was there before the text was solved
            pulls: pulls && offers("/capabilities/workspace/diagnostics/refreshSupport"),
            fades: ["publishDiagnostics", "diagnostic"].iter().any(|kind| fades(params, kind)),
            shows_documents: offers("/capabilities/window/showDocument/support"),
            hears_solved: options["solved"] == true,
            without: Without::of(options),
            asks_again: AsksAgain {
                hints: offers("/capabilities/workspace/inlayHint/refreshSupport"),
                lenses: offers("/capabilities/workspace/codeLens/refreshSupport"),
            },
        }
    }

    /// Takes the settings of a `workspace/didChangeConfiguration`; gives the requests that follow.
    pub fn configure(&mut self, params: &Value) -> Vec<Value> {
        self.without = Without::of(&params["settings"]["assur"]);
        self.hints_again()
    }

    /// Whether it wants hints of a kind.
    pub const fn wants(&self, kind: HintKind) -> bool {
        !match kind {
            HintKind::Structure => self.without.structure,
            HintKind::Value => self.without.values,
            HintKind::Outcome => self.without.outcomes,
        }
    }

    /// The request for hints alone.
    pub fn hints_again(&self) -> Vec<Value> {
        requests(&[(self.asks_again.hints, HINTS)])
    }

    /// The request for lenses alone.
    pub fn lenses_again(&self) -> Vec<Value> {
        requests(&[(self.asks_again.lenses, LENSES)])
    }

    /// The requests when a text is solved.
    pub fn all_again(&self) -> Vec<Value> {
        let AsksAgain { hints, lenses } = self.asks_again;
        requests(&[(self.pulls, DIAGNOSTICS), (hints, HINTS), (lenses, LENSES)])
    }
}

/// Whether diagnostics of a kind may be tagged as unnecessary.
fn fades(params: &Value, kind: &str) -> bool {
    const UNNECESSARY: u32 = 1;
    let tags = params.pointer(&format!("/capabilities/textDocument/{kind}/tagSupport/valueSet"));
    tags.and_then(Value::as_array).is_some_and(|all| all.iter().any(|one| *one == UNNECESSARY))
}

/// Those of the requests that are offered.
fn requests(all: &[(bool, &str)]) -> Vec<Value> {
    let asked = all.iter().filter(|(offered, _)| *offered);
    asked.map(|(_, method)| json!({ "jsonrpc": "2.0", "id": method, "method": method })).collect()
}

impl Without {
    /// `{ "hints": { "values": false } }`
    fn of(options: &Value) -> Self {
        let is_off = |kind: &str| options["hints"][kind] == false;
        Self { structure: is_off("structure"), values: is_off("values"), outcomes: is_off("outcomes") }
    }
}

// What the server can do.

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
