//! Answers that are errors.

use assur_text::source::{Edit, Encoding, LineColumn, Lines, Span};
use gen_lsp_types::{Position, Range, TextEdit};
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

// Places and edits in the units of the protocol.

/// The place of a range. A column past its line is the line's end; a line past the text, or a column within a character, is an
/// error.
pub fn span(lines: &Lines<'_>, range: Range, encoding: Encoding) -> Result<Span, Failure> {
    let byte = |at: Position| {
        let place = LineColumn { line: index(at.line), column: index(at.character) };
        let found = lines.byte(place, encoding);
        found.ok_or_else(|| Failure::params(format!("there is no place {}:{}", at.line, at.character)))
    };
    let (start, end) = (byte(range.start)?, byte(range.end)?);
    if start <= end {
        Ok(Span::new(start, end))
    } else {
        Err(Failure::params("a range ends before it begins"))
    }
}

fn index(n: u32) -> usize {
    usize::try_from(n).unwrap_or(usize::MAX)
}

/// The range of a place.
pub fn range(lines: &Lines<'_>, span: Span, encoding: Encoding) -> Range {
    let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    let position = |byte: usize| {
        let place = lines.place(byte, encoding);
        Position { line: number(place.line), character: number(place.column) }
    };
    Range { start: position(span.start), end: position(span.end) }
}

/// Edits as the protocol has them.
pub fn edits(lines: &Lines<'_>, edits: &[Edit], encoding: Encoding) -> Vec<TextEdit> {
    let edit =
        |edit: &Edit| TextEdit { range: range(lines, edit.span, encoding), new_text: edit.with.clone() };
    edits.iter().map(edit).collect()
}
