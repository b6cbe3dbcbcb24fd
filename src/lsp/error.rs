//! Answers that are errors.

use serde_json::{Value, json};
use std::fmt;

/// Why a request has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    code: i32,
    message: String,
}

impl Failure {
    pub(super) fn parse(why: &str) -> Self {
        Self { code: -32700, message: format!("this is not JSON: {why}") }
    }

    pub(super) fn invalid_request(message: &str) -> Self {
        Self { code: -32600, message: message.to_owned() }
    }

    pub(super) fn unknown_method(method: &str) -> Self {
        Self { code: -32601, message: format!("`{method}` is not supported") }
    }

    pub(super) fn params(message: impl Into<String>) -> Self {
        Self { code: -32602, message: message.into() }
    }

    /// What is asked cannot be done.
    pub(super) fn request(why: String) -> Self {
        Self { code: -32803, message: why }
    }

    pub(super) fn internal() -> Self {
        let version = env!("CARGO_PKG_VERSION");
        Self { code: -32603, message: format!("internal error of assur {version}") }
    }

    pub(super) fn not_initialized() -> Self {
        Self { code: -32002, message: "the session is not initialized".to_owned() }
    }

    /// As the response to a request.
    pub(super) fn response(&self, id: Option<&Value>) -> Value {
        json!({ "jsonrpc": "2.0", "id": id, "error": { "code": self.code, "message": self.message } })
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}
