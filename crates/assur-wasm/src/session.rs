//! A session with one host.

use crate::panels::Panels;
use assur::internals::lsp::Server;
pub use assur::internals::lsp::Stop;
use serde_json::Value;

/// No message waits: the host asks for what is to be said of the texts that changed.
const PUBLISH: &str = "assur/publish";
/// The author pauses: the host asks for the answers of the texts that changed.
const SOLVE: &str = "assur/solve";

/// The panel of a text was closed.
const HIDE: &str = "assur/hide";

/// A server, and what it shows.
#[derive(Debug)]
pub struct Session {
    server: Server,
    panels: Panels,
}

impl Default for Session {
    fn default() -> Self {
        let panels = Panels::default();
        Self { server: Server::with_pages(Box::new(panels.clone())), panels }
    }
}

impl Session {
    /// The answers to a message, as an array of JSON. While a text is solved, `stop` is asked again and again.
    pub fn handle(&mut self, message: &[u8], stop: &(dyn Fn() -> Option<Stop> + Sync)) -> Vec<u8> {
        let mut answers = match serde_json::from_slice::<Value>(message) {
            Ok(message) => self.answers(&message, stop),
            Err(error) => vec![Server::unreadable(&error.to_string())],
        };
        self.panels.draw(&|| stop() != Some(Stop::Never));
        answers.extend(self.panels.take());
        Value::Array(answers).to_string().into_bytes()
    }

    fn answers(&mut self, message: &Value, stop: &(dyn Fn() -> Option<Stop> + Sync)) -> Vec<Value> {
        match message.get("method").and_then(Value::as_str) {
            Some(PUBLISH) => self.server.publish(),
            Some(SOLVE) => self.server.solve(stop),
            Some(HIDE) => {
                self.panels.close(message["params"]["uri"].as_str().unwrap_or_default());
                Vec::new()
            }
            _ => self.server.handle(message),
        }
    }
}
