//! The language server protocol: which question a message asks, and its answer as a message. No mechanics here, and no streams:
//! messages come in and go out as JSON.

mod answers;
mod asked;
mod capabilities;
mod colours;
mod convert;
mod error;
mod names;
mod preview;
mod shown;
mod texts;
mod typing;

use asked::diagnostics;
use assur_text::source::Encoding;
use capabilities::Refreshes;
use colours::Sent;
use error::Failure;
use gen_lsp_types::{LspNotificationMethod, LspRequestMethod, TextDocumentPositionParams};
pub use preview::{Pages, View};
use serde_json::{Value, json};
use std::panic::{AssertUnwindSafe, catch_unwind};
use texts::Texts;
pub use texts::{Patience, Stop};

/// How far a session is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Stage {
    /// Nothing but `initialize` is answered.
    #[default]
    New,
    /// Everything is answered.
    Ready,
    /// `shutdown` came; `exit` follows.
    Closed,
}

/// A session with one client.
#[derive(Debug, Default)]
pub struct Server {
    stage: Stage,
    encoding: Encoding,
    texts: Texts,
    sent: Sent,
    refreshes: Refreshes,
    /// Whether the client opens addresses.
    shows_documents: bool,
    pages: Option<Box<dyn Pages>>,
    /// Where the cursor was last, for a page that opens.
    cursor: Option<TextDocumentPositionParams>,
    is_over: bool,
}

impl Server {
    /// The answers to a message: a response to a request, nothing to a notification.
    pub fn handle(&mut self, message: &Value) -> Vec<Value> {
        let method = message.get("method").and_then(Value::as_str);
        let params = message.get("params").unwrap_or(&Value::Null);
        match (method, message.get("id")) {
            (Some(method), Some(id)) => {
                let response = guarded(|| self.respond(method, id, params));
                let internal = || Failure::internal();
                let broken = response.is_none().then(|| log(method, &internal()));
                let response = response.unwrap_or_else(|| internal().response(Some(id)));
                let is_command = method == "workspace/executeCommand";
                // clients do nothing with what a command returns; who names `false` behind the text does
                let is_quiet =
                    params["arguments"].as_array().is_some_and(|all| all.contains(&Value::Bool(false)));
                let result = (is_command && !is_quiet).then(|| &response["result"]);
                let text = result.and_then(Value::as_str).map(|text| shown(INFO, text));
                let page = result.and_then(|result| self.opened(result));
                [Some(response), text, page, broken].into_iter().flatten().collect()
            }
            (Some(method), None) => guarded(|| self.notice(method, params))
                .unwrap_or_else(|| vec![log(method, &Failure::internal())]),
            // the response to a request of ours, of which there are none
            (None, Some(_)) if message.get("result").is_some() || message.get("error").is_some() => {
                Vec::new()
            }
            (None, id) => vec![Failure::invalid_request("this is not a message").response(id)],
        }
    }

    /// The response to what is not JSON.
    #[must_use]
    pub fn unreadable(why: &str) -> Value {
        Failure::parse(why).response(None)
    }

    /// Diagnostics of the texts that changed. Ask when no other message waits, so that only the last of many changes is looked at.
    pub fn publish(&mut self) -> Vec<Value> {
        let changed = self.texts.changed();
        changed.into_iter().map(|(uri, version)| self.published(&uri, version)).collect()
    }

    /// Solves the texts that changed, until `patience` says to stop: diagnostics of their answers, and requests to ask for hints and
    /// lenses again.
    pub fn solve(&mut self, patience: &Patience<'_>) -> Vec<Value> {
        let solved = self.texts.solve(patience);
        self.show_pages();
        if solved.is_empty() {
            return Vec::new();
        }
        let published = solved.into_iter().map(|(uri, version)| self.published(&uri, version));
        published.chain(self.refreshes.requests()).collect()
    }

    fn published(&self, uri: &str, version: i32) -> Value {
        let found = guarded(|| {
            let analysis = self.texts.look(uri)?;
            Ok::<_, Failure>(diagnostics(uri, analysis, self.texts.results(uri), self.encoding))
        });
        // an error of the program says nothing of the text; what was said before is no longer true
        let diagnostics = found.and_then(Result::ok).unwrap_or_default();
        let params = json!({ "uri": uri, "version": version, "diagnostics": diagnostics });
        notification("textDocument/publishDiagnostics", &params)
    }

    /// Whether the client said `exit`.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        self.is_over
    }

    /// Whether it said `shutdown` before.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.stage == Stage::Closed
    }

    fn respond(&mut self, method: &str, id: &Value, params: &Value) -> Value {
        let answer = match (LspRequestMethod::from(method), self.stage) {
            (LspRequestMethod::Initialize, Stage::New) => Ok(self.initialize(params)),
            (_, Stage::New) => Err(Failure::not_initialized()),
            (_, Stage::Closed) => Err(Failure::invalid_request("the session is shut down")),
            (LspRequestMethod::Initialize, Stage::Ready) => {
                Err(Failure::invalid_request("the session is initialized already"))
            }
            (LspRequestMethod::Shutdown, Stage::Ready) => {
                self.stage = Stage::Closed;
                Ok(Value::Null)
            }
            (LspRequestMethod::WorkspaceExecuteCommand, Stage::Ready) => match self.preview(params) {
                Some(answer) => answer,
                None => self.answered(&LspRequestMethod::WorkspaceExecuteCommand, params),
            },
            (method, Stage::Ready) => {
                if method == LspRequestMethod::TextDocumentDocumentHighlight {
                    self.mark(params);
                }
                self.answered(&method, params)
            }
        };
        match answer {
            Ok(result) => json!({ "jsonrpc": "2.0", "id": id, "result": result }),
            Err(failure) => failure.response(Some(id)),
        }
    }

    fn answered(&self, method: &LspRequestMethod<'_>, params: &Value) -> Result<Value, Failure> {
        answers::answer(method, params, &self.texts, &self.sent, self.encoding)
    }

    fn initialize(&mut self, params: &Value) -> Value {
        self.stage = Stage::Ready;
        let offered = params.pointer("/capabilities/general/positionEncodings").and_then(Value::as_array);
        let reads_bytes = offered.is_some_and(|all| all.iter().any(|one| one == "utf-8"));
        self.refreshes = Refreshes::of(params);
        let shows = params.pointer("/capabilities/window/showDocument/support");
        self.shows_documents = shows.and_then(Value::as_bool).unwrap_or_default();
        self.encoding = if reads_bytes { Encoding::Utf8 } else { Encoding::Utf16 };
        capabilities::result(self.encoding)
    }

    fn notice(&mut self, method: &str, params: &Value) -> Vec<Value> {
        let done = match (LspNotificationMethod::from(method), self.stage) {
            (LspNotificationMethod::Exit, _) => {
                self.is_over = true;
                Ok(())
            }
            (LspNotificationMethod::TextDocumentDidOpen, Stage::Ready) => self.texts.open(params),
            (LspNotificationMethod::TextDocumentDidChange, Stage::Ready) => {
                self.texts.change(params, self.encoding)
            }
            (LspNotificationMethod::TextDocumentDidClose, Stage::Ready) => {
                let closed = self.texts.close(params);
                return match closed {
                    // what was said of it goes with it
                    Ok(uri) => {
                        self.sent.forget(&uri);
                        let params = json!({ "uri": uri, "diagnostics": [] });
                        vec![notification("textDocument/publishDiagnostics", &params)]
                    }
                    Err(failure) => vec![log(method, &failure)],
                };
            }
            (LspNotificationMethod::Custom(name), Stage::Ready) if name == POSE => {
                return match self.texts.look_at(params) {
                    Ok(()) => self.refreshes.hints_again(),
                    Err(failure) => vec![log(method, &failure)],
                };
            }
            _ => Ok(()),
        };
        done.err().map(|failure| log(method, &failure)).into_iter().collect()
    }
}

/// Nothing where an error of the program ends it; the session goes on.
fn guarded<T>(work: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(work)).ok()
}

fn notification(method: &str, params: &Value) -> Value {
    json!({ "jsonrpc": "2.0", "method": method, "params": params })
}

/// Our own notification: the part of the way, from 0 to 1, at which the author looks at a text; without one, all of it.
const POSE: &str = "assur/pose";

/// Kinds of messages to the author.
const ERROR: u32 = 1;
const INFO: u32 = 3;

/// A text for the author.
fn shown(kind: u32, text: &str) -> Value {
    notification("window/showMessage", &json!({ "type": kind, "message": text }))
}

/// A notification that could not be used, for the log of the client: it has no response.
fn log(method: &str, failure: &Failure) -> Value {
    let message = format!("{method}: {failure}");
    notification("window/logMessage", &json!({ "type": ERROR, "message": message }))
}
