//! Which question a request asks.

use super::asked::TextRequest;
use super::client::{Client, EXPLAIN, SOLVE, TEST};
use super::documents;
use super::error::Failure;
use super::shown::Sent;
use super::texts::{Texts, params};
use crate::editor::{folds, symbols};
use assur_text::diagnostic::explain;
use gen_lsp_types::{
    CodeActionParams, DocumentOnTypeFormattingParams, DocumentRangeFormattingParams, ExecuteCommandParams,
    InlayHintParams, LspRequestMethod as Method, ReferenceParams, RenameParams, SelectionRangeParams,
    SemanticTokensDeltaParams, TextDocumentIdentifier, TextDocumentPositionParams, WorkspaceSymbolParams,
};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// What a request about a whole text carries.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Whole {
    text_document: TextDocumentIdentifier,
}

/// The answer to a request.
pub fn answer(
    method: &Method<'_>,
    message: &Value,
    texts: &Texts,
    sent: &Sent,
    client: Client,
) -> Result<Value, Failure> {
    let session = Session { texts, client };
    match method {
        Method::TextDocumentCodeAction => {
            let asked = params::<CodeActionParams>(message)?;
            session.of(&asked.text_document, |text| Ok(text.actions(text.span(asked.range)?)))
        }
        Method::TextDocumentRangeFormatting => {
            let asked = params::<DocumentRangeFormattingParams>(message)?;
            session.of(&asked.text_document, |text| text.formatting(asked.range))
        }
        Method::TextDocumentOnTypeFormatting => {
            let asked = params::<DocumentOnTypeFormattingParams>(message)?;
            session.of(&asked.text_document, |text| {
                Ok(text.edits(&text.analysis.formatting_after(text.byte(asked.position)?)))
            })
        }
        Method::TextDocumentDiagnostic => {
            session.whole(message, |text| json!({ "kind": "full", "items": text.diagnostics() }))
        }
        Method::TextDocumentReferences => {
            let with_declarations = params::<ReferenceParams>(message)?.context.include_declaration;
            session.at(message, |text, byte| text.references(byte, with_declarations))
        }
        Method::TextDocumentRename => {
            let name = params::<RenameParams>(message)?.new_name;
            session.at(message, |text, byte| text.rename(byte, &name))
        }
        Method::TextDocumentInlayHint => {
            let asked = params::<InlayHintParams>(message)?;
            session.of(&asked.text_document, |text| text.hints(asked.range))
        }
        Method::TextDocumentSelectionRange => {
            let asked = params::<SelectionRangeParams>(message)?;
            session.of(&asked.text_document, |text| text.selections(&asked.positions))
        }
        Method::WorkspaceSymbol => {
            let query = params::<WorkspaceSymbolParams>(message)?.query.to_lowercase();
            session.symbols(&query)
        }
        Method::WorkspaceExecuteCommand => session.execute(&params(message)?),
        Method::TextDocumentCodeLens => session.whole(message, |text| text.lenses()),
        Method::TextDocumentSemanticTokensFull => {
            session.whole(message, |text| sent.whole(text.uri, &text.semantic_tokens()))
        }
        Method::TextDocumentSemanticTokensFullDelta => {
            let asked = params::<SemanticTokensDeltaParams>(message)?;
            session.whole(message, |text| sent.changed(&asked, &text.semantic_tokens()))
        }
        Method::TextDocumentCompletion => session.at(message, |text, byte| Ok(text.completions(byte))),
        Method::TextDocumentSignatureHelp => session.at(message, |text, byte| Ok(text.signatures(byte))),
        Method::TextDocumentFormatting => {
            session.whole(message, |text| text.edits(&text.analysis.formatting(None)))
        }
        Method::TextDocumentDocumentSymbol => session.whole(message, |text| {
            symbols(&text.analysis.document).iter().map(|s| text.symbol(s)).collect::<Vec<_>>()
        }),
        Method::TextDocumentFoldingRange => session.whole(message, |text| {
            let found = folds(&text.analysis.source.text, &text.analysis.tokens);
            found.into_iter().map(|span| text.fold(span)).collect::<Vec<_>>()
        }),
        Method::TextDocumentHover => session.at(message, |text, byte| {
            Ok(text.analysis.hover(byte, text.results).map(|hover| text.hover(hover)))
        }),
        Method::TextDocumentDefinition => session.at(message, |text, byte| Ok(text.definition(byte))),
        Method::TextDocumentDocumentHighlight => session.at(message, |text, byte| Ok(text.highlights(byte))),
        Method::TextDocumentPrepareRename => session.at(message, |text, byte| text.prepare_rename(byte)),
        other => documents::answer(other.as_str(), message, &session)
            .unwrap_or_else(|| Err(Failure::unknown_method(other.as_str()))),
    }
}

/// The open texts, and who asks.
pub(super) struct Session<'t> {
    pub(super) texts: &'t Texts,
    client: Client,
}

impl Session<'_> {
    /// What is asked of an open text.
    pub(super) fn of<T: Serialize>(
        &self,
        document: &TextDocumentIdentifier,
        ask: impl FnOnce(&TextRequest<'_>) -> Result<T, Failure>,
    ) -> Result<Value, Failure> {
        let uri = document.uri.to_string();
        let analysis = self.texts.analysis(&uri)?;
        let asked = TextRequest::of(&uri, analysis, self.texts.results(&uri), self.client);
        let answer = ask(&TextRequest {
            earlier: self.texts.earlier(&uri),
            tested: self.texts.tested(&uri),
            ..asked
        })?;
        serde_json::to_value(answer).map_err(|_| Failure::internal())
    }

    fn whole<T: Serialize>(
        &self,
        message: &Value,
        ask: impl FnOnce(&TextRequest<'_>) -> T,
    ) -> Result<Value, Failure> {
        self.of(&params::<Whole>(message)?.text_document, |text| Ok(ask(text)))
    }

    /// The symbols of all open texts in whose names a text is.
    fn symbols(&self, query: &str) -> Result<Value, Failure> {
        let mut found = Vec::new();
        for uri in self.texts.uris() {
            let own =
                self.of(&TextDocumentIdentifier { uri: uri.into() }, |text| Ok(text.symbols_called(query)))?;
            found.extend(own.as_array().cloned().unwrap_or_default());
        }
        Ok(Value::Array(found))
    }

    /// What a command prints.
    fn execute(&self, asked: &ExecuteCommandParams) -> Result<Value, Failure> {
        let mut words = asked.arguments.iter().flatten().filter_map(Value::as_str);
        if asked.command == EXPLAIN {
            let page = words.find_map(explain);
            let page =
                page.ok_or_else(|| Failure::params(format!("`{EXPLAIN}` needs the code of a diagnostic")))?;
            return Ok(Value::String(page.to_owned()));
        }
        let uri = words.next();
        let uri =
            uri.ok_or_else(|| Failure::params(format!("`{}` needs the address of a text", asked.command)))?;
        let analysis = self.texts.analysis(uri)?;
        match asked.command.as_str() {
            SOLVE => Ok(Value::String(analysis.solved_page(self.texts.results(uri)))),
            TEST => {
                let page = analysis.tested_page();
                self.texts.keep_tested(uri, &page);
                Ok(Value::String(page))
            }
            other => Err(Failure::params(format!("there is no command `{other}`"))),
        }
    }

    /// What is asked of a place.
    fn at<T: Serialize>(
        &self,
        message: &Value,
        ask: impl FnOnce(&TextRequest<'_>, usize) -> Result<T, Failure>,
    ) -> Result<Value, Failure> {
        let asked = params::<TextDocumentPositionParams>(message)?;
        self.of(&asked.text_document, |text| ask(text, text.byte(asked.position)?))
    }
}
