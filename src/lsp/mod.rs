//! The language server protocol: which question a message asks, and its answer as a message. No mechanics here, and no streams:
//! messages come in and go out as JSON.

mod answers;
mod asked;
mod client;
mod documents;
mod error;
mod preview;
mod shown;
mod texts;

use crate::editor::Results;
use asked::TextRequest;
use client::Client;
use error::Failure;
use gen_lsp_types::{LspNotificationMethod, LspRequestMethod, TextDocumentPositionParams};
pub use preview::{Pages, View};
use serde_json::{Value, json};
use shown::Sent;
use std::panic::{AssertUnwindSafe, catch_unwind};
use texts::Texts;
pub use texts::{Patience, Stop};

/// How far a session is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Stage {
    /// Nothing but `initialize` is answered.
    #[default]
    New,
    Ready,
    /// `shutdown` came; `exit` follows.
    Closed,
}

/// A session with one client.
#[derive(Debug, Default)]
pub struct Server {
    stage: Stage,
    client: Client,
    texts: Texts,
    sent: Sent,
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
                let broken = response.is_none().then(|| self.broken(method, params));
                let response = response.unwrap_or_else(|| Failure::internal().response(Some(id)));
                let more = if method == COMMAND {
                    self.after_command(params, &response["result"])
                } else {
                    Vec::new()
                };
                [response].into_iter().chain(more).chain(broken).collect()
            }
            (Some(method), None) => {
                guarded(|| self.notice(method, params)).unwrap_or_else(|| vec![self.broken(method, params)])
            }
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

    /// What follows on a command, for the author: what it prints, the page that it shows.
    fn after_command(&self, params: &Value, result: &Value) -> Vec<Value> {
        // clients do nothing with what a command returns; who names `false` behind the text does
        let is_quiet = params["arguments"].as_array().is_some_and(|all| all.contains(&Value::Bool(false)));
        let lenses = if params["command"] == client::TEST { self.client.lenses_again() } else { Vec::new() };
        if is_quiet {
            return lenses;
        }
        let text = result.as_str().map(|text| shown(INFO, text));
        text.into_iter().chain(self.opened(result)).chain(lenses).collect()
    }

    /// An error of the program, for the log of the client: with its version, and the text in which it arose.
    fn broken(&self, method: &str, params: &Value) -> Value {
        let named =
            params.pointer("/textDocument/uri").or(params.get("uri")).or(params.pointer("/arguments/0"));
        let text = named.and_then(Value::as_str).and_then(|uri| self.texts.written(uri));
        let failure = Failure::internal();
        let line =
            text.map_or_else(|| failure.to_string(), |text| format!("{failure}, in this text:\n{text}"));
        logged(method, &line)
    }

    /// Diagnostics of the texts that changed. Ask when no other message waits, so that only the last of many changes is looked at.
    pub fn publish(&mut self) -> Vec<Value> {
        let changed = self.texts.changed();
        // one that asks for them asks after every change
        let pushed = changed.iter().filter(|_| !self.client.pulls);
        pushed.flat_map(|(uri, version)| self.published(uri, *version)).collect()
    }

    /// Solves the texts that changed, until `patience` says to stop: diagnostics of their answers, and requests to ask for hints and
    /// lenses again.
    pub fn solve(&mut self, patience: &Patience<'_>) -> Vec<Value> {
        let solved = self.texts.solve(patience);
        self.show_pages();
        let mut said = Vec::new();
        for uri in self.texts.broken() {
            said.push(self.broken("solve", &json!({ "uri": uri })));
        }
        if solved.is_empty() {
            return said;
        }
        for (uri, version) in solved {
            if !self.client.pulls {
                said.extend(self.published(&uri, version));
            }
            if self.client.hears_solved {
                let poses = self.texts.results(&uri).map_or(0, Results::positions);
                said.push(notification(SOLVED, &json!({ "uri": uri, "version": version, "poses": poses })));
            }
        }
        said.extend(self.client.all_again());
        said
    }

    fn published(&self, uri: &str, version: i32) -> Vec<Value> {
        let found = guarded(|| {
            let analysis = self.texts.analysis(uri)?;
            Ok::<_, Failure>(
                TextRequest::of(uri, analysis, self.texts.results(uri), self.client).diagnostics(),
            )
        });
        let broken = found.is_none().then(|| self.broken(PUBLISH, &json!({ "uri": uri })));
        // an error of the program says nothing of the text; what was said before is no longer true
        let diagnostics = found.and_then(Result::ok).unwrap_or_default();
        let params = json!({ "uri": uri, "version": version, "diagnostics": diagnostics });
        [notification(PUBLISH, &params)].into_iter().chain(broken).collect()
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
        answers::answer(method, params, &self.texts, &self.sent, self.client)
    }

    fn initialize(&mut self, params: &Value) -> Value {
        self.stage = Stage::Ready;
        self.client = Client::of(params);
        client::result(self.client)
    }

    fn notice(&mut self, method: &str, params: &Value) -> Vec<Value> {
        let done = match (LspNotificationMethod::from(method), self.stage) {
            (LspNotificationMethod::Exit, _) => {
                self.is_over = true;
                Ok(())
            }
            (LspNotificationMethod::TextDocumentDidOpen, Stage::Ready) => self.texts.open(params),
            (LspNotificationMethod::TextDocumentDidChange, Stage::Ready) => {
                self.texts.change(params, self.client.encoding)
            }
            (LspNotificationMethod::TextDocumentDidClose, Stage::Ready) => {
                let closed = self.texts.close(params);
                return match closed {
                    // what was said of it goes with it
                    Ok(uri) => {
                        self.sent.forget(&uri);
                        let params = json!({ "uri": uri, "diagnostics": [] });
                        if self.client.pulls { Vec::new() } else { vec![notification(PUBLISH, &params)] }
                    }
                    Err(failure) => vec![log(method, &failure)],
                };
            }
            (LspNotificationMethod::WorkspaceDidChangeConfiguration, Stage::Ready) => {
                return self.client.configure(params);
            }
            (LspNotificationMethod::Custom(name), Stage::Ready) if name == POSE => {
                return match self.texts.look_at(params) {
                    Ok(()) => self.client.hints_again(),
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

/// Our own notification to a client that asks for it: a text is solved.
const SOLVED: &str = "assur/solved";

const PUBLISH: &str = "textDocument/publishDiagnostics";
const COMMAND: &str = "workspace/executeCommand";

/// Kinds of messages to the author.
const ERROR: u32 = 1;
const INFO: u32 = 3;

/// A text for the author.
fn shown(kind: u32, text: &str) -> Value {
    notification("window/showMessage", &json!({ "type": kind, "message": text }))
}

/// A notification that could not be used, for the log of the client: it has no response.
fn log(method: &str, failure: &Failure) -> Value {
    logged(method, &failure.to_string())
}

fn logged(method: &str, what: &str) -> Value {
    let message = format!("{method}: {what}");
    notification("window/logMessage", &json!({ "type": ERROR, "message": message }))
}
